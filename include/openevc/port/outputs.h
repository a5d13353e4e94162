#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "openevc/base/inplace_vector.h"
#include "openevc/base/set.h"
#include "openevc/base/units.h"
#include "openevc/port/event.h"
#include "openevc/port/inputs.h"
#include "openevc/terms/cause.h"
#include "openevc/terms/data_status.h"
#include "openevc/terms/dialogue.h"
#include "openevc/terms/driver_id.h"
#include "openevc/terms/driver_input.h"
#include "openevc/terms/driver_output.h"
#include "openevc/terms/engine_orientation.h"
#include "openevc/terms/level.h"
#include "openevc/terms/mode.h"
#include "openevc/terms/monitoring.h"
#include "openevc/terms/radio_link.h"
#include "openevc/terms/requests.h"
#include "openevc/terms/status_text.h"
#include "openevc/terms/symbol.h"
#include "openevc/terms/track_condition.h"
#include "openevc/train/train_data.h"

// The outputs of one cycle of the kernel: enumerations and numbers. Their names and texts for people and JSON are in
// the tables of `terms` and in `texts`.
namespace evc::port {

struct NidLrbg {
  std::uint16_t NID_C = 0;
  std::uint16_t NID_BG = 0;
  friend constexpr bool operator==(const NidLrbg&, const NidLrbg&) = default;
};

/// A text of the trackside on the driver interface (3.12.3).
struct ShownText {
  std::uint8_t id = 0;                 // given on board
  bool important = false;              // Q_TEXTCLASS
  bool acknowledge = false;            // the driver is asked to acknowledge it
  Duration since{};                    // when its display began
  std::optional<std::uint8_t> Q_TEXT;  // a fixed text; absent: plain text
  std::uint8_t length = 0;
  std::array<char, 255> characters{};  // ISO 8859-1, not terminated
};

/// Ids of the system status messages, in the order of StatusText: those of trackside texts are below (an octet).
inline constexpr std::uint16_t kFirstStatusId = 256;
inline constexpr std::uint16_t kLastStatusId = kFirstStatusId + terms::index(StatusText::count) - 1;

/// A system status message on the driver interface.
struct ShownStatus {
  StatusText text{};
  Duration since{};  // when its display began
};

/// A communication session with an RBC, or with a radio infill unit (then NID_RBC is NID_RIU, and `role` means
/// nothing).
struct RbcSession {
  std::uint16_t NID_C = 0;
  std::uint16_t NID_RBC = 0;
  SessionPhase phase = SessionPhase::idle;
  SessionRole role = SessionRole::supervising;
  friend constexpr bool operator==(const RbcSession&, const RbcSession&) = default;
};

/// A track condition on the driver interface (5.18). Places are nominal counters of a front end there.
struct ShownCondition {
  Symbol symbol{};
  std::optional<TrackConditionKind> kind;  // absent: change of traction system
  OdometerPlace from, to;                  // alike for a change at a place
  ConditionPhase phase{};                  // announced, active or ending
};

// Track conditions for the train (5.20, SUBSET-034): the distances that remain.
/// An area in which something is switched off, lowered or closed.
struct OrderedArea {
  TrackConditionKind kind{};
  std::optional<Distance> to_start;  // absent: not needed any more; below 0: in rear of the front end
  Distance to_end;
};
struct OrderedPlatform {
  std::optional<Distance> to_start;
  Distance to_end;
  std::uint8_t M_PLATFORM = 0, Q_PLATFORM = 0;
};
struct OrderedTraction {
  Distance to_start;
  std::uint8_t M_VOLTAGE = 0;
  std::uint16_t NID_CTRACTION = 0;
};
struct OrderedCurrent {
  Distance to_start;
  std::optional<std::uint16_t> amperes;  // absent: no restriction
};

struct OutgoingMessage {
  InplaceVector<std::uint8_t, 192> bytes;
  std::optional<RbcIdentity> to;  // absent: the RBC that supervises
  bool infill_unit = false;       // `to` is a radio infill unit: NID_RBC is NID_RIU
};
struct RbcAddress {
  std::uint16_t NID_C = 0;
  std::uint16_t NID_RBC = 0;
  std::uint64_t NID_RADIO = 0;  // BCD, as on the wire
  bool infill_unit = false;     // NID_RBC is NID_RIU
  friend constexpr bool operator==(const RbcAddress&, const RbcAddress&) = default;
};

/// Of the train data those that may be changed (3.18.6.1).
struct ShownTrainData {
  Distance L_TRAIN;
  Speed V_MAXTRAIN;
  std::optional<double> brake_percentage;  // absent with brake model gamma
  std::uint16_t cant_deficiency_mm = 0;
  std::uint16_t other_categories = 0;  // bits kFreightP, kFreightG, kPassenger of train_data.h
  train::AxleLoad axle_load{};
  train::LoadingGauge loading_gauge{};
  bool airtight = false;
};
/// Staff responsible: the supervised speed, and what is left of the distance; absent: infinite. Valid in SR.
struct ShownSR {
  DataStatus status = DataStatus::unknown;
  Speed V;
  std::optional<Distance> D;
};
/// A virtual balise cover (3.15.9), and the time that is left of its validity period, which was set as T_VBC days.
struct ShownCover {
  std::uint16_t NID_C = 0;
  std::uint8_t NID_VBCMK = 0;
  Duration left;
  std::uint8_t T_VBC = 0;
};
/// Stored data with their status (3.18.6). A value counts where its status is valid; the driver may be asked to
/// revalidate an invalid one.
struct ShownData {
  DataStatus driver_id_status = DataStatus::unknown;
  DataStatus train_running_number_status = DataStatus::unknown;
  DataStatus level_status = DataStatus::unknown;  // of Outputs::level
  DataStatus rbc_status = DataStatus::unknown;
  DataStatus train_status = DataStatus::unknown;
  bool slippery_rail = false;              // selected by the driver
  DriverId driver_id;                      // as entered
  std::uint32_t train_running_number = 0;  // 8 BCD digits, as entered
  RbcAddress rbc;
  ShownTrainData train;
  ShownSR SR;
  std::optional<std::uint32_t> network;  // NID_MN of the radio network, of trackside or driver, or the default; absent:
                                         // that of the terminals, which is not known
};

/// Date and time (3.18.5): seconds since 1970, the local time by its offset.
struct DateTime {
  std::int64_t utc = 0;
  std::int16_t local_offset_min = 0;
};
/// No NID_MN, which is decimal digits.
inline constexpr std::uint32_t kDefaultNetwork = 0xFFFFFF;

/// Data of packet 44 for an application outside ETCS, or for a national system (3.15.6.5).
struct ForwardedData {
  std::uint16_t NID_XUSER = 0;
  std::optional<std::uint8_t> NID_NTC;  // with NID_XUSER 102
  std::uint16_t bits = 0;
  InplaceVector<std::uint8_t, 128> bytes;  // left aligned
};
using Forwarded = InplaceVector<ForwardedData, 8>;

/// What a procedure of chapter 5 waits for; `acknowledges` where it is an acknowledgement of the driver.
struct ShownDialogue {
  Dialogue step{};
  std::optional<Ack> acknowledges;
  friend constexpr bool operator==(const ShownDialogue&, const ShownDialogue&) = default;
};

struct Outputs {  // NOLINT(clang-analyzer-optin.performance.Padding): the fields are in the order of an output line
  Duration now{};
  Mode mode = Mode::NP;
  Level level = Level::L0;
  std::uint8_t nid_ntc = 0;
  std::optional<NidLrbg> lrbg;
  OdometerPlace est_front, min_safe_front, max_safe_front;
  Speed v;
  Monitoring monitoring = Monitoring::none;
  Status status = Status::none;
  // Absent where not supervised.
  std::optional<Speed> V_P, V_W, V_SBI, V_EBI, V_MRSP, V_target, V_release;
  std::optional<Distance> d_target;
  // End of authority and supervised location (3.8.4.3, 3.8.4.5), as the nominal counter of a front
  // end at that place; absent without an authority.
  std::optional<OdometerPlace> EOA, SvL;
  bool tco = false, sb = false, eb = false;
  Set<Cause> brake_reasons;           // every cause that asks for a brake
  Set<Ack> requests;                  // acknowledgements asked of the driver
  Set<Entry> entries;                 // data that the driver is asked to enter
  bool start_offered = false;         // the driver may choose Start (5.4, 4.4.13)
  InplaceVector<ShownText, 6> texts;  // texts shown now (packets 72, 76)
  InplaceVector<Symbol, 32> symbols;  // in the order of the areas of the screen
  InplaceVector<OutgoingMessage, 24> radio_out;
  std::optional<RbcAddress> radio_connect, radio_disconnect;
  InplaceVector<Event, 96> events;

  // Absent where not supervised. `V_I`: the speed above which an Indication limit is passed, at most V_MRSP; none in
  // release speed monitoring (3.13.9.3.6).
  std::optional<Speed> V_I;
  std::optional<Duration> TTI;            // time to Indication, while it is to be shown (3.13.10.3.10)
  std::optional<Speed> LSSMA;             // lowest supervised speed within the MA, while it is to be shown (4.4.19.1.4)
  bool MRDT_changed = false;              // the most relevant displayed target is another one (3.13.10.4.5)
  std::optional<Distance> d_indication;   // from the front end to the first Indication location (3.13.10.3.8)
  std::optional<MemoStatus> memo_status;  // where speed is supervised
  bool level_valid = false;               // the stored level has the status valid (5.4.3.3)
  Set<Level> levels_allowed;              // that the driver may choose (5.10.2.8)
  std::optional<StatusText> trip_reason;  // in TR and PT (4.4.13.1.3)
  std::optional<Distance> geo;            // geographical position of the estimated front end (3.6.6)
  std::optional<Distance> rv_left;        // in RV: what is left of the distance to run (3.15.4); absent: infinite
  std::uint8_t M_VERSION = 0;             // operated system version (3.17.2): X in bits 4 to 6, Y in bits 0 to 3
  /// The mobile terminals that are free have to register with this radio network, NID_MN (3.5.6); kDefaultNetwork:
  /// their own default.
  std::optional<std::uint32_t> radio_register;
  Set<DriverInput> enabled;                     // what the driver may do in the next cycle (4.7.2)
  InplaceVector<ShownStatus, 20> status_texts;  // shown now; trackside texts are `texts`
  InplaceVector<RbcSession, 2> sessions;        // not those that are idle

  // Track conditions, from their announcement on: for the driver, and for the train in the modes of 4.5.2.
  InplaceVector<ShownCondition, 49> track_conditions;
  InplaceVector<OrderedArea, 48> ordered_areas;
  InplaceVector<OrderedPlatform, 40> ordered_platforms;
  std::optional<OrderedTraction> ordered_traction;
  std::optional<OrderedCurrent> ordered_current;
  InplaceVector<RbcSession, 2> infill_sessions;         // with radio infill units; not those that are idle
  bool sound_horn = false;                              // the driver is asked for it
  bool remote_shunting = false;                         // the mode permits it (4.4.8.1.4)
  std::optional<EngineOrientation> engine_orientation;  // in SM (4.4.21.1.13): how the train reads the orders above

  ShownData data;
  InplaceVector<ShownCover, 16> covers;         // stored
  std::optional<DateTime> clock;                // where it is known (3.18.5)
  Forwarded forwarded;                          // accepted in this cycle
  std::optional<ShownDialogue> dialogue;        // none: no procedure waits for somebody
  Set<DriverOutput> shown;                      // what the driver interface shows of the table in this mode (4.7.2)
  std::optional<Speed> set_speed;               // where the mode shows it
  Language language;                            // of the display, as the driver chose it
  std::optional<std::uint8_t> national_system;  // NID_NTC of the last level NTC, which status texts speak of
};

}  // namespace evc::port
