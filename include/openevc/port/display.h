#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <type_traits>

#include "openevc/base/inplace_vector.h"
#include "openevc/base/set.h"
#include "openevc/base/units.h"
#include "openevc/port/outputs.h"
#include "openevc/port/planning.h"
#include "openevc/terms/button.h"
#include "openevc/terms/picture.h"
#include "openevc/terms/srs_version.h"
#include "openevc/terms/train_category.h"

// What the on-board gives its display in a cycle (ERA_ERTMS_015560): one record, complete, which the driver-machine
// interface draws. The on-board has masked it by the mode (4.7.2). Distances are from the estimated front end; an
// absent value is not shown.
namespace evc::port {

/// The highest speed of the dial (015560 8.2.1.1).
enum class Dial : std::uint8_t { to_140, to_180, to_250, to_400 };

/// A national system that the display can name.
struct NtcName {
  std::uint8_t nid_ntc = 0;
  std::array<char, 8> characters{};  ///< ISO 8859-1, the rest zero
};

/// The limits of an entry (015560 10.3.4), in the unit of its label: outside the technical ones a value is rejected,
/// outside the operational ones the driver has to insist on it.
struct EntryRange {
  double least = 0.0, most = 0.0, step = 1.0;
  std::optional<double> operational_least = {}, operational_most = {};
};

/// A check across fields of the train data: a train of one of these categories is at most this fast (015560 10.3.4.4,
/// 10.3.4.6).
struct CrossCheck {
  Set<TrainCategory> categories;
  Speed V_most;
  bool operational = false;  ///< the driver may insist; else the values are rejected
};

/// How train data are entered (015560 11.3.9.6).
enum class TrainDataEntry : std::uint8_t { flexible, fixed, switchable };

/// A train type of the fixed entry, with the data for which it stands.
struct TrainType {
  std::array<char, 16> name{};  ///< ISO 8859-1, the rest zero
  ShownTrainData data;
};

/// What is fixed for a display.
struct DisplayConfig {
  SrsVersion srs = SrsVersion::v4_0_0;
  Dial dial = Dial::to_400;
  InplaceVector<NtcName, 16> ntc_names;
  InplaceVector<Language, 12> languages;
  TrainDataEntry train_data_entry = TrainDataEntry::flexible;
  InplaceVector<TrainType, 12> train_types;
  Set<TrainCategory> categories = Set<TrainCategory>::of_bits(~std::uint64_t{0});  ///< offered to the driver
  std::uint16_t axle_loads = 0x1FFF;                                               ///< bit n: train::AxleLoad(n)
  std::uint8_t loading_gauges = 0x1F;                                              ///< bit n: train::LoadingGauge(n)
  EntryRange L_TRAIN{.least = 0, .most = 4095};                                    ///< m
  EntryRange brake_percentage{.least = 10, .most = 250};                           ///< %
  /// The driver enters one: with brake model gamma the train has none (SUBSET-026-3 3.13.2.2.1, 3.18.3.2).
  bool asks_brake_percentage = true;
  EntryRange V_MAXTRAIN{.least = 0, .most = 600, .step = 5};  ///< km/h
  EntryRange V_sr{.least = 0, .most = 600, .step = 5};        ///< km/h
  EntryRange D_sr{.least = 0, .most = 100000};                ///< m
  InplaceVector<CrossCheck, 8> cross_checks;
  bool gsmr_fitted = true, frmcs_fitted = false;  ///< radio systems
  Duration T_dispTTI{14.0};                       ///< the time to Indication is shown below it (SUBSET-026 A.3.1)
};

/// What the driver has to acknowledge, in order of arrival. `since` separates requests of one moment, which the display
/// orders by their kind (015560 5.4.1.9.1), from those that came one after another.
struct AskedAck {
  Ack what{};
  std::uint16_t id = 0;  ///< with Ack::text: id of the text
  Duration since{};
  friend constexpr bool operator==(const AskedAck&, const AskedAck&) = default;
};

enum class TextKind : std::uint8_t { fixed, plain, status, national };

/// A text in areas E5 to E9 (015560 8.2.3.4).
struct DisplayedText {
  std::uint16_t id = 0;  ///< as in ShownText, or that of a status text
  TextKind kind = TextKind::plain;
  bool important = false;    ///< group 1: system status, and Q_TEXTCLASS 1
  bool acknowledge = false;  ///< an acknowledgement is asked for and was not given yet
  Duration since{};
  std::optional<std::uint16_t> minute_of_day = {};  ///< local time of its begin; absent: not known
  std::uint8_t Q_TEXT = 0;                          ///< with kind fixed
  StatusText status{};                              ///< with kind status
  std::uint8_t nid_ntc = 0;                         ///< with kind status, where the text names a national system
  std::uint8_t length = 0;                          ///< with kind plain or national
  std::array<char, 255> characters{};               ///< ISO 8859-1
};

/// A symbol of areas B3 to B5: track conditions and level crossings, in order of appearance.
struct DisplayedCondition {
  std::uint16_t id = 0;  ///< the same as long as it is the same track condition, whichever its phase
  Picture picture{};
  ConditionPhase phase = ConditionPhase::announced;
};

struct TunnelStoppingArea {
  bool inside = false;
  Distance distance;  ///< to its begin, where not inside
};

/// An order or announcement ahead in the planning area: the distance at which its symbol in B3 to B5 will appear
/// (015560 8.3.4).
struct PlannedOrder {
  Picture picture{};
  Distance at;
};

/// The announced level (015560 8.2.3.2). Its acknowledgement is in the queue.
struct AnnouncedLevel {
  Level level{};
  std::uint8_t nid_ntc = 0;
};

/// For what the procedure waits, so that the display shows the hour glass (015560 11.7).
enum class Waiting : std::uint8_t {
  nothing,
  end_of_session,
  radio_registration,
  network_list,
  session,
  train_accepted,
  train_data_acknowledged,
  answer_to_ma_request,
  answer_to_sh_request,
  answer_to_sm_request
};

enum class RadioNetworkType : std::uint8_t { frmcs, frmcs_and_gsmr, gsmr };

enum class AtoStatus : std::uint8_t { none, selected, ready, engaged, disengaging, failure };
enum class AtoStop : std::uint8_t { none, overshoot, undershoot, accurate };
enum class AtoDoors : std::uint8_t { none, open_both, open_left, open_right, are_open, close, closing, closed };
enum class AtoSkip : std::uint8_t { none, inactive, by_trackside, by_driver };

/// Automatic train operation, 4.0.0 (015560 8.5).
struct DisplayedAto {
  bool on = false;  ///< the selector is not in stand-by
  AtoStatus status = AtoStatus::none;
  AtoStop stop = AtoStop::none;
  std::optional<std::uint16_t> dwell_s;
  bool hold = false;
  AtoDoors doors = AtoDoors::none;
  AtoSkip skip = AtoSkip::none;
  bool coasting_advice = false;
  bool warning_sound = false;
  std::optional<Speed> advice_speed;
  std::uint8_t name_length = 0;  ///< of the next stopping point
  std::array<char, 20> name{};
  std::optional<std::uint32_t> arrival_second_of_day;
  InplaceVector<Distance, 4> stopping_points;
  std::optional<Distance> advice_change;
};

/// Stored data with status, and what the driver may choose (015560 11.3).
struct DisplayedData {
  ShownData stored;
  std::optional<std::uint8_t> train_type;     ///< of the fixed entry: place in DisplayConfig::train_types
  std::uint8_t levels = 0;                    ///< bit n: Level(n) is offered
  InplaceVector<std::uint8_t, 16> ntcs;       ///< NID_NTC of the national systems that are offered
  InplaceVector<std::uint32_t, 16> networks;  ///< NID_MN of the GSM-R networks that are offered
  InplaceVector<ShownCover, 16> covers;
  std::uint8_t M_VERSION = 0;  ///< operated system version
  RadioNetworkType radio = RadioNetworkType::gsmr;
  bool gsmr_registered = false, frmcs_registered = false;
  bool asks_one_radio_system = false;  ///< the start of mission asks for it (015560 11.7.2 S5)
  std::optional<Distance> D_sr_most;   ///< proposed for SR where the stored distance is infinite or longer
};

enum class SmDirection : std::uint8_t { forward, backward };

struct Display {  // NOLINT(clang-analyzer-optin.performance.Padding): the fields are in the order of the areas
  DisplayConfig config;
  Duration now{};
  std::optional<std::uint32_t> second_of_day;  // local time
  Mode mode = Mode::SB;
  Level level = Level::L0;
  bool level_valid = false;
  std::uint8_t nid_ntc = 0;  // with level NTC
  bool standstill = true;
  Language language;

  // Speed and distance monitoring (areas A and B).
  Speed v;
  Monitoring monitoring = Monitoring::none;
  Status status = Status::none;
  std::optional<Speed> V_P, V_SBI, V_target, V_release;
  bool target_information = false;   // in ceiling speed monitoring: asked for by the national value
  std::uint8_t MRDT = 0;             // changes when another target is the most relevant displayed one
  std::optional<Distance> d_target;  // to it; in RV what is left of the distance to run
  std::optional<Duration> TTI;       // while the national value asks for it and it is known
  std::optional<Speed> LSSMA;
  std::optional<Speed> set_speed;

  // Symbols.
  bool slippery_rail = false;                        // A4
  std::optional<SmDirection> sm;                     // B8, 4.0.0
  bool override_active = false;                      // C7
  bool reversing_permitted = false;                  // C6
  bool bmm_inhibited = false;                        // C6, 4.0.0
  bool brake = false;                                // C9: ETCS commands a brake
  bool brake_for_missing_ack = false;                // of a level, mode or text: released by that acknowledgement
  std::optional<AnnouncedLevel> announced_level;     // C1
  RadioIndication radio = RadioIndication::none;     // E1
  std::optional<Distance> geo;                       // G12
  InplaceVector<DisplayedCondition, 50> conditions;  // B3 to B5: 49 track conditions and a level crossing
  std::optional<TunnelStoppingArea> tunnel;          // C2 to C4; absent: not known on-board
  bool track_ahead_free = false;                     // D: the question

  // Planning (area D). Of `planning` the display draws `speeds`, `gradients`, EOA and LOA; its conditions are `orders`.
  Planning planning;
  InplaceVector<PlannedOrder, 97> orders;     // in the order of distance
  std::optional<Distance> indication_marker;  // the first Indication location (3.13.10.3.8)
  std::optional<Distance> indication_target;  // the place of the target it belongs to

  InplaceVector<DisplayedText, 32> texts;
  InplaceVector<AskedAck, 32> acks;

  // The driver's side.
  DisplayedData data;
  Set<Button> buttons;            // enabled, but for an acknowledgement that is pending
  Set<DriverInput> enabled;       // as in the outputs
  std::optional<Dialogue> step;   // of the procedure that waits for somebody
  bool start_of_mission = false;  // its dialogue runs (015560 11.7.2), up to the Main window
  Waiting waiting = Waiting::nothing;
  DisplayedAto ato;  // 4.0.0
};
static_assert(std::is_trivially_copyable_v<Display>);

}  // namespace evc::port
