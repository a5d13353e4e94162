#include "run/stop_signals.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

namespace evc::run {
namespace {

/// How a child ends that does this; 0: it was as expected.
template <class Do>
int status_of(Do&& does) {
  const pid_t child = ::fork();
  if (child == 0) {
    // A test in the background ignores SIGINT.
    for (const int signal : {SIGINT, SIGTERM}) (void)::signal(signal, SIG_DFL);
    does();
    ::_exit(0);
  }
  int status = -1;
  EXPECT_EQ(::waitpid(child, &status, 0), child);
  return status;
}

void expect(bool holds) {
  if (!holds) ::_exit(1);
}

bool ended_by(int status, int signal) { return WIFSIGNALED(status) && WTERMSIG(status) == signal; }

TEST(StopSignals, TheFirstAsksTheSecondEnds) {
  for (const int first : {SIGINT, SIGTERM})
    for (const int second : {SIGINT, SIGTERM})
      EXPECT_TRUE(ended_by(status_of([&] {
                             const StopSignals signals;
                             expect(!signals.seen());
                             (void)::raise(first);
                             expect(signals.seen());
                             (void)::raise(second);
                           }),
                           second))
          << first << ' ' << second;
}

/// What the caller does with the signal is done at the second one, and afterwards.
TEST(StopSignals, TheEarlierHandlerComesBack) {
  EXPECT_EQ(status_of([] {
              (void)::signal(SIGTERM, [](int) { ::_exit(0); });
              const StopSignals signals;
              (void)::raise(SIGTERM);
              (void)::raise(SIGTERM);
              ::_exit(1);
            }),
            0);
  EXPECT_TRUE(ended_by(status_of([] {
                         { const StopSignals signals; }
                         (void)::raise(SIGINT);
                       }),
                       SIGINT));
}

TEST(StopSignals, OneThatIsIgnoredStaysIgnored) {
  EXPECT_EQ(status_of([] {
              (void)::signal(SIGINT, SIG_IGN);
              const StopSignals signals;
              for (int n = 0; n < 3; ++n) (void)::raise(SIGINT);
              expect(!signals.seen());
            }),
            0);
}

/// A write that waits goes on: the progress bar does not fail by the signal.
TEST(StopSignals, CallsOfTheSystemGoOn) {
  EXPECT_EQ(status_of([] {
              const StopSignals signals;
              for (const int signal : {SIGINT, SIGTERM}) {
                struct sigaction action {};
                expect(::sigaction(signal, nullptr, &action) == 0 && (action.sa_flags & SA_RESTART) != 0);
              }
            }),
            0);
}

}  // namespace
}  // namespace evc::run
