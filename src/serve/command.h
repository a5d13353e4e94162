#pragma once
#include <cstdint>
#include <optional>

namespace evc::serve {

/// The port without `--port`.
inline constexpr std::uint16_t kPort = 8026;

struct Options {
  std::uint16_t port = kPort;            ///< 0: any that is free
  bool real_time = false;                ///< cycles by the clock
  std::optional<std::int64_t> cycle_ms;  ///< with real_time: instead of `cycle_ms` of each configuration
  bool planning = false;                 ///< lines have the advance display (3.15.10)
  bool dmi = false;                      ///< lines have the record of the display (015560)
};

/// `evc serve`: prints its address in one line and answers until SIGINT or SIGTERM. Returns the exit status: 0, or 2
/// with one line on standard error.
int serve(const Options& options);

}  // namespace evc::serve
