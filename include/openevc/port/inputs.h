#pragma once
#include <cstdint>
#include <optional>
#include <span>

#include "openevc/base/set.h"
#include "openevc/base/units.h"
#include "openevc/terms/consist_length.h"
#include "openevc/terms/driver_id.h"
#include "openevc/terms/level.h"
#include "openevc/terms/radio_link.h"
#include "openevc/terms/requests.h"
#include "openevc/terms/train_integrity.h"
#include "openevc/train/train_data.h"

// The inputs of one cycle of the kernel.
namespace evc::port {

/// The odometer: absolute counters since power-up (metres) and speeds. min <= nominal <= max.
struct Odometry {
  OdometerPlace nominal, min, max;
  Speed V_est, V_min, V_max;
  Acceleration A_est;
  /// When they were measured; absent: at `Inputs::now`. The unit extrapolates them by the speeds; older than 1 s while
  /// they show movement they count as failed, a standstill holds until the next reading.
  std::optional<Duration> measured = {};
};

/// The user bits of one balise telegram and the nominal counter when its centre was passed by the antenna.
struct BaliseTelegram {
  std::span<const std::uint8_t> bytes;  // left aligned
  std::size_t bits = 0;                 // none: something was read that is no telegram (3.16.2.4)
  OdometerPlace at;
  std::optional<Duration> passed = {};  // the time instead: the unit finds the counter
};
struct LoopMessage {
  std::span<const std::uint8_t> bytes;
};
/// The RBC of a message or of a report of the bearer.
struct RbcIdentity {
  std::uint16_t NID_C = 0;
  std::uint16_t NID_RBC = 0;
  friend constexpr bool operator==(const RbcIdentity&, const RbcIdentity&) = default;
};
struct RadioMessage {
  std::span<const std::uint8_t> bytes;
  std::optional<RbcIdentity> from = std::nullopt;  // absent: the RBC that was called last
  bool infill_unit = false;  // from a radio infill unit: NID_RBC is NID_RIU; absent: the unit that was called last
};
/// Selections of the driver in this cycle, one bit each (4.7.2, "driver requests").
enum class Select : std::uint8_t {
  start,
  override_,
  shunting,
  exit_shunting,
  non_leading,
  maintain_shunting,
  train_data,
  slippery_rail,
  adhesion_normal,
  isolate,
  track_ahead_free,
  main,                 // a button of the main window: ends some status texts (015560 15)
  integrity_confirmed,  // the driver confirms that the train is complete (3.6.5.2)
  last_rbc,             // the stored contact is to be used (5.4.3.2 S3)
  short_number,         // the short number stored on board is to be called (3.5.3.11)
  vbc_set,              // a virtual balise cover is to be entered and set, or
  vbc_remove,           // removed (3.15.9.2)
  radio_network,        // the radio network is to be changed: sessions end (3.18.4.3.6)
  toggle,               // speeds and distances in OS, SR and SH are switched on or off (015560 8.2.2.4)
  ato_engage,           // automatic driving, 4.0.0: to be entered, and
  ato_disengage,        // left (4.4.16.1.2, .3)
  sm,                   // supervised manoeuvre, 4.0.0: asked for,
  continue_sm,          // asked for again at its end (4.4.21.1.10), and
  exit_sm,              // left
  bmm_inhibit,          // the reaction to the antenna alarm, 4.0.0: it is inhibited (5.22), or
  bmm_revoke,           // acts again
  count
};
/// `selected` (bit n: Select(n)) with one more selection of the same cycle, a bit: the same twice is once, but for the
/// toggle, which is then where it was (015560 8.2.2.4).
constexpr std::uint32_t with_selection(std::uint32_t selected, std::uint32_t bit) {
  return bit == 1u << static_cast<unsigned>(Select::toggle) ? selected ^ bit : selected | bit;
}
struct DriverActions {
  std::uint32_t selected = 0;      // bit n: Select(n)
  std::uint32_t acknowledged = 0;  // bit n: Ack(n)
  constexpr bool has(Select s) const { return ((selected >> static_cast<unsigned>(s)) & 1u) != 0; }
  constexpr bool has(Ack a) const { return ((acknowledged >> static_cast<unsigned>(a)) & 1u) != 0; }
  /// Entered data (5.4 start of mission); absent when nothing was entered in this cycle.
  std::optional<DriverId> driver_id;
  std::optional<Level> level;
  std::uint8_t nid_ntc = 0;                           // with level NTC
  std::uint16_t acknowledged_text = 0;                // with Ack::text: id of the message, 0: the oldest that waits
  std::optional<std::uint32_t> train_running_number;  // 8 BCD digits packed (NID_OPERATIONAL)
  const train::TrainData* train_data = nullptr;       // entered and validated by the driver
  struct RbcContact {
    std::uint16_t NID_C;
    std::uint16_t NID_RBC;
    std::uint64_t NID_RADIO;
  };
  std::optional<RbcContact> rbc_contact;
  /// A virtual balise cover to be set, after Select::vbc_remove to be removed (3.15.9).
  struct Cover {
    std::uint16_t NID_C;
    std::uint8_t NID_VBCMK;  ///< 0 to 63
    std::uint8_t T_VBC;      ///< validity period in days; a removal does not need it
  };
  std::optional<Cover> cover;
  std::optional<std::uint32_t> network;  // NID_MN, 6 BCD digits packed (3.18.4.3.6)
  std::optional<Speed> V_sr;             // SR speed and distance (4.4.11)
  std::optional<Distance> D_sr;
  std::optional<Speed> set_speed;    // of the speed control, to be shown; 0: none any more (015560 8.2.3.9)
  std::optional<Language> language;  // of the display
};

/// The windows in which the driver enters data and the train may not move.
enum class Window : std::uint8_t {
  train_data,  ///< entry, change or revalidation of train data (3.18.3.3.1)
  SR_data,     ///< entry of SR speed and distance (4.4.11.1.5.1)
  count
};

/// Train data changed by another source than the driver, in this cycle (3.18.3.6, 5.17).
struct ExternalTrainData {
  const train::TrainData* data = nullptr;  ///< the whole block; none: nothing changed
  bool driver_validates = true;            ///< 5.17.2.2 D0: the driver has to validate them
};

enum class DirectionController : std::uint8_t { neutral, forward, backward };

/// The two driver's cabs of the engine. The odometer counts up towards the front end of cab A (3.6.1.5).
enum class Cab : std::uint8_t { A, B };

/// The train interface (SUBSET-034). The signals are states, not edges: io keeps the last value of
/// each.
struct TrainSignals {
  bool powered = true;
  bool isolated = false;
  bool desk_open = false;
  Cab cab = Cab::A;  ///< whose desk is open
  bool sleeping = false;
  bool non_leading = false;
  bool passive_shunting = false;
  DirectionController direction_controller = DirectionController::forward;
  std::optional<double> brake_pressure_kpa;
  bool service_brake_feedback = false;
  bool regenerative_brake_active = true, eddy_current_brake_active = true, magnetic_shoe_brake_active = true,
       ep_brake_active = true;
  bool additional_brake_active = false;
  bool radio_registered = true;  ///< a mobile terminal is registered with the radio network (3.5.6)
  bool antenna_alarm = false;    ///< the on-board reports a failure of the balise transmission (3.15.7)
  TrainIntegrity integrity = TrainIntegrity::unknown;  ///< says an external source (3.6.5.2)
  std::optional<Distance> length_confirmed;            ///< of the train, with TrainIntegrity::confirmed
  std::optional<ConsistLength> consist;                ///< 4.0.0: of an external source; absent: not available
};

/// The STM interface, as states: bit n of `available` is NID_NTC n (NID_NTC > 63 is not stored
/// here).
struct NationalSystem {
  std::uint64_t available = 0;
  bool trip_active = false;
  bool service_brake = false, emergency_brake = false;  ///< ordered by the national system (3.14.1.7.7)
  friend constexpr bool operator==(const NationalSystem&, const NationalSystem&) = default;
};

/// The interface of automatic train operation as states, 4.0.0: what the conditions of 4.6.3 ask of it.
struct AutomaticOperation {
  bool requests_AD = false;  ///< it asks for automatic driving
  bool active = false;       ///< its selector is not in stand-by
  friend constexpr bool operator==(const AutomaticOperation&, const AutomaticOperation&) = default;
};

struct Inputs {
  Duration now{};  // since power-up
  Odometry odometry;
  std::span<const BaliseTelegram> balise_telegrams;
  std::span<const LoopMessage> loop_messages;
  std::span<const RadioMessage> radio_messages;
  RadioLink radio_link = RadioLink::unchanged;
  std::optional<RbcIdentity> radio_link_with;  // absent: the RBC that was called last
  bool radio_link_of_infill_unit = false;      // as `infill_unit` of RadioMessage
  DriverActions driver;
  Set<Window> windows;  ///< open now
  TrainSignals train;
  ExternalTrainData external_train_data;
  NationalSystem national_system;
  AutomaticOperation automatic_operation;
  bool safety_fault = false;
  /// Whether the engine was moved while the power was off, says cold movement detection; absent: not known (3.15.8).
  /// It counts in the cycle in which No Power is left.
  std::optional<bool> moved = {};
  /// A reading of the clock in this cycle, seconds since 1970 (UTC): for display and records (3.18.5), covers (3.15.9).
  std::optional<std::int64_t> utc = {};
};

}  // namespace evc::port
