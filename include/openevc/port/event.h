#pragma once
#include <cstdint>
#include <type_traits>

#include "openevc/terms/clause.h"
#include "openevc/terms/level.h"
#include "openevc/terms/mode.h"
#include "openevc/terms/what.h"

namespace evc::port {

/// What the driver entered, in events.
enum class Entered : std::uint8_t {
  driver_id,
  train_running_number,
  train_data,
  rbc_contact,
  level,
  SR_speed_distance,
  cover,
  network,
  set_speed,
  language,
  count
};

/// One event of a cycle, with the object it concerns and the clause that requires it.
struct Event {
  static constexpr std::int32_t kNone = -1;

  What what{};
  std::uint8_t from = 0, to = 0;  ///< of a change: Mode or Level
  std::int32_t id =
      kNone;        ///< its meaning depends on `what`: NID_MESSAGE, NID_BG, number of a condition, ... not negative
  Clause clause{};  ///< none where the event needs no clause

  /// A mode transition and its condition of 4.6.3.
  static constexpr Event mode_changed(Mode from, Mode to, int condition) {
    return {What::mode_changed, static_cast<std::uint8_t>(from), static_cast<std::uint8_t>(to), condition, {}};
  }
  static constexpr Event level_changed(Level from, Level to, bool by_driver) {
    return {by_driver ? What::level_changed_by_driver : What::level_changed, static_cast<std::uint8_t>(from),
            static_cast<std::uint8_t>(to), kNone, "5.10"_srs};
  }

  friend constexpr bool operator==(const Event&, const Event&) = default;
};
static_assert(std::is_trivially_copyable_v<Event> && sizeof(Event) == 12);

}  // namespace evc::port
