#include "run/stop_signals.h"

#include <array>
#include <atomic>
#include <csignal>
#include <cstddef>

namespace evc::run {
namespace {

constexpr std::array kStopping{SIGINT, SIGTERM};
std::atomic<bool> asked = false;
static_assert(std::atomic<bool>::is_always_lock_free);  // a signal handler writes it
std::array<struct sigaction, kStopping.size()> before{};

void restore() {
  for (std::size_t n = 0; n < kStopping.size(); ++n) (void)::sigaction(kStopping[n], &before[n], nullptr);
}

/// A second signal does what it did before, whatever the drive does with the first: it ends the program.
extern "C" void ask_for_stop(int) {
  asked = true;
  restore();
}

}  // namespace

StopSignals::StopSignals() {
  asked = false;
  // All of them first: the handler restores all.
  for (std::size_t n = 0; n < kStopping.size(); ++n) (void)::sigaction(kStopping[n], nullptr, &before[n]);
  for (std::size_t n = 0; n < kStopping.size(); ++n) {
    if (before[n].sa_handler == SIG_IGN) continue;
    struct sigaction action {};
    action.sa_handler = ask_for_stop;
    action.sa_flags = static_cast<int>(SA_RESTART);  // a write that waits does not fail
    sigemptyset(&action.sa_mask);
    for (const int other : kStopping) sigaddset(&action.sa_mask, other);
    (void)::sigaction(kStopping[n], &action, nullptr);
  }
}

StopSignals::~StopSignals() { restore(); }

bool StopSignals::seen() const { return asked; }

}  // namespace evc::run
