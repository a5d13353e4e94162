#pragma once
#include <cstdint>
#include <optional>

#include "base/inplace_vector.h"
#include "port/outputs.h"

namespace evc::sim {

/// The radio networks of a line (SUBSET-026-3 3.5.6), each by its NID_MN.
struct Networks {
  InplaceVector<std::uint32_t, 16> offered;  ///< that the driver may choose; the first one is that of the terminals
  std::optional<std::uint32_t> along_line;   ///< the one that is there; absent: a terminal registers with any at once
};

/// The mobile terminals of the train: they are registered some seconds after the order of the on-board where the
/// network is there, and with no other one.
class Terminals {
 public:
  explicit Terminals(const Networks& networks) : along_line_(networks.along_line) {}

  /// Takes the order to register of the cycle at `t_ms`.
  void hear(const port::Outputs& outputs, std::int64_t t_ms);
  /// Whether a terminal is registered in the cycle at `t_ms`.
  bool registered(std::int64_t t_ms) const { return !along_line_ || (since_ms_ && *since_ms_ <= t_ms); }

 private:
  std::optional<std::uint32_t> along_line_;
  std::optional<std::int64_t> since_ms_;  // from when on; absent: it will not be
};

}  // namespace evc::sim
