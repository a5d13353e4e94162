#include "app/signals.h"

#include <csignal>

#include "io/file.h"

namespace evc::app {
namespace {

/// The default action is in force again (SA_RESETHAND): the caller sees that the signal ended the program.
extern "C" void delete_and_end(int signal) {
  io::delete_unfinished_files();
  (void)::raise(signal);
}

}  // namespace

void leave_no_parts_of_files() {
  // A file beyond the limit of the caller (`ulimit -f`) is one that cannot be written, as on a full disk.
  (void)::signal(SIGXFSZ, SIG_IGN);
  for (const int signal : io::kEndingSignals) {
    struct sigaction action {};
    if (::sigaction(signal, nullptr, &action) != 0 || action.sa_handler != SIG_DFL) continue;
    action.sa_handler = delete_and_end;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigemptyset(&action.sa_mask);
    (void)::sigaction(signal, &action, nullptr);
  }
}

}  // namespace evc::app
