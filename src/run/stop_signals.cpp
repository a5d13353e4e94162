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

extern "C" void ask_for_stop(int) { asked = true; }

}  // namespace

StopSignals::StopSignals() {
  asked = false;
  for (std::size_t n = 0; n < kStopping.size(); ++n) {
    (void)::sigaction(kStopping[n], nullptr, &before[n]);
    if (before[n].sa_handler == SIG_IGN) continue;
    struct sigaction action {};
    action.sa_handler = ask_for_stop;
    sigemptyset(&action.sa_mask);
    (void)::sigaction(kStopping[n], &action, nullptr);
  }
}

StopSignals::~StopSignals() {
  for (std::size_t n = 0; n < kStopping.size(); ++n) (void)::sigaction(kStopping[n], &before[n], nullptr);
}

bool StopSignals::seen() const { return asked; }

}  // namespace evc::run
