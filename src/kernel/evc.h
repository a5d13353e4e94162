#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "base/inplace_vector.h"
#include "base/units.h"
#include "modes/mode.h"
#include "terms/monitoring.h"
#include "terms/radio_link.h"
#include "terms/srs_version.h"
#include "train/national_values.h"
#include "train/train_data.h"

// The whole outside of the kernel. Nothing else goes in or out: no clock, no file, no thread, no
// random number.
namespace evc::kernel {

/// What the unit is told once, at power-up.
struct Config {
  Duration cycle{0.1};
  SrsVersion srs = SrsVersion::v3_6_0;
  train::TrainData train;
  train::NationalValues national_values;                                  // valid until packet 3 brings others (3.18.2)
  std::array<bool, modes::kLevels> levels{true, true, true, true, true};  // what this unit is fitted for
};

/// The odometer: absolute counters since power-up (metres) and speeds. min <= nominal <= max.
struct Odometry {
  OdometerPlace nominal, min, max;
  Speed V_est, V_min, V_max;
  Acceleration A_est;
};

/// The user bits of one balise telegram and the nominal counter when its centre was passed by the antenna.
struct BaliseTelegram {
  std::span<const std::uint8_t> bytes;  // left aligned
  std::size_t bits = 0;
  OdometerPlace at;
};
struct LoopMessage {
  std::span<const std::uint8_t> bytes;
};
struct RadioMessage {
  std::span<const std::uint8_t> bytes;
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
  count
};
/// Acknowledgements of the driver in this cycle, one bit each.
using modes::Ack;

struct DriverActions {
  std::uint32_t selected = 0;      // bit n: Select(n)
  std::uint32_t acknowledged = 0;  // bit n: Ack(n)
  constexpr bool has(Select s) const { return ((selected >> static_cast<unsigned>(s)) & 1u) != 0; }
  constexpr bool has(Ack a) const { return ((acknowledged >> static_cast<unsigned>(a)) & 1u) != 0; }
  /// Entered data (5.4 start of mission); absent when nothing was entered in this cycle.
  std::optional<std::uint32_t> driver_id;  // as entered, 8 BCD digits packed (DRIVER_ID)
  std::optional<modes::Level> level;
  std::uint8_t nid_ntc = 0;                           // with level NTC
  std::optional<std::uint32_t> train_running_number;  // 8 BCD digits packed (NID_OPERATIONAL)
  const train::TrainData* train_data = nullptr;       // entered and validated by the driver
  struct RbcContact {
    std::uint16_t NID_C;
    std::uint16_t NID_RBC;
    std::uint64_t NID_RADIO;
  };
  std::optional<RbcContact> rbc_contact;
  std::optional<Speed> V_sr;  // SR speed and distance (4.4.11)
  std::optional<Distance> D_sr;
};

enum class DirectionController : std::uint8_t { neutral, forward, backward };

/// The train interface (SUBSET-034), levels, not edges: io keeps the last value of each.
struct TrainSignals {
  bool powered = true;
  bool isolated = false;
  bool desk_open = false;
  bool sleeping = false;
  bool non_leading = false;
  bool passive_shunting = false;
  DirectionController direction_controller = DirectionController::forward;
  std::optional<double> brake_pressure_kpa;
  bool service_brake_feedback = false;
  bool regenerative_brake_active = true, eddy_current_brake_active = true, magnetic_shoe_brake_active = true,
       ep_brake_active = true;
  bool additional_brake_active = false;
};

/// The STM interface, levels: bit n of `available` is NID_NTC n (NID_NTC > 63 is not kept here).
struct NationalSystem {
  std::uint64_t available = 0;
  bool trip_active = false;
};

struct Inputs {
  Duration now{};  // since power-up
  Odometry odometry;
  std::span<const BaliseTelegram> balise_telegrams;
  std::span<const LoopMessage> loop_messages;
  std::span<const RadioMessage> radio_messages;
  RadioLink radio_link = RadioLink::unchanged;
  DriverActions driver;
  TrainSignals train;
  NationalSystem national_system;
  bool safety_fault = false;
};

/// "SUBJECT what [clause or condition]": `mode SR->FS [31]`, `linking BG 353 ok`. All texts are
/// literals. Printed: subject, then `id` unless negative, then `from->to` if both are set, then
/// `what` unless null, then `[clause]` or `[number]`.
struct Event {
  const char* subject = "";
  std::int64_t id = -1;
  const char* from = nullptr;
  const char* to = nullptr;
  const char* what = nullptr;
  const char* clause = nullptr;
  int number = -1;
};

struct NidLrbg {
  std::uint16_t NID_C = 0;
  std::uint16_t NID_BG = 0;
  friend constexpr bool operator==(const NidLrbg&, const NidLrbg&) = default;
};

/// A text on the driver interface (3.12.3).
struct ShownText {
  std::uint8_t id = 0;                 // given on board
  std::optional<std::uint8_t> Q_TEXT;  // a fixed text; absent: plain text
  std::uint8_t length = 0;
  std::array<char, 255> characters{};  // ISO 8859-1, not terminated
};

struct OutgoingMessage {
  InplaceVector<std::uint8_t, 192> bytes;
};
struct RbcAddress {
  std::uint16_t NID_C = 0;
  std::uint16_t NID_RBC = 0;
  std::uint64_t NID_RADIO = 0;  // BCD, as on the wire
};

struct Outputs {
  Duration now{};
  modes::Mode mode = modes::Mode::NP;
  modes::Level level = modes::Level::L0;
  std::uint8_t nid_ntc = 0;
  std::optional<NidLrbg> lrbg;
  OdometerPlace est_front, min_safe_front, max_safe_front;
  Speed v;
  Monitoring monitoring = Monitoring::none;
  Status status = Status::none;
  // Absent where not supervised.
  std::optional<Speed> V_P, V_W, V_SBI, V_EBI, V_MRSP, V_target, V_release;
  std::optional<Distance> d_target;
  // End of authority and supervised location (3.8.4.3, 3.8.4.5) as nominal counter of the front end
  // that stands there; absent without an authority.
  std::optional<OdometerPlace> EOA, SvL;
  bool tco = false, sb = false, eb = false;
  InplaceVector<const char*, 24> brake_reasons;    // literals, one per cause that asks for a brake
  InplaceVector<const char*, 16> driver_requests;  // acknowledgements and entries asked of the driver
  InplaceVector<ShownText, 6> texts;               // texts shown now (packets 72, 76)
  InplaceVector<const char*, 32> symbols;          // DMI symbol names (MO07, LE04, ...)
  InplaceVector<OutgoingMessage, 24> radio_out;
  std::optional<RbcAddress> radio_connect, radio_disconnect;
  InplaceVector<Event, 96> events;
};

struct State;
struct Derived;

/// Puts the unit into its state after power-up: mode SB is entered from NP in the first cycle (4.6.3 [4]). With train
/// data or national values that `train::check` refuses it goes to SF then ([13]).
void power_up(State& state, Derived& derived, const Config& config) noexcept;

/// One cycle. Total, deterministic, allocation-free; equal (state, inputs) give equal results. Times, places and speeds
/// that are not numbers, out of all range (10^9 s or m, 1000 m/s), not between their bounds or before the last cycle's
/// lead to SF (4.4.5).
void step(State& state, Derived& derived, const Inputs& inputs, Outputs& outputs) noexcept;

}  // namespace evc::kernel
