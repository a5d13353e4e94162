#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <type_traits>

#include "balise/balise.h"
#include "base/inplace_vector.h"
#include "base/units.h"
#include "brakes/brakes.h"
#include "driver/status_texts.h"
#include "kernel/buffered_set.h"
#include "kernel/displayed.h"
#include "kernel/evc.h"
#include "kernel/manoeuvre_state.h"
#include "kernel/radio_network.h"
#include "lang/telegram.h"
#include "modes/acceptance.h"
#include "modes/levels.h"
#include "position/odometer_accuracy.h"
#include "position/position.h"
#include "position/report.h"
#include "procedures/end_of_mission.h"
#include "procedures/leaving_rbc.h"
#include "procedures/level_transition.h"
#include "procedures/mode_profile.h"
#include "procedures/override.h"
#include "procedures/rbc_handover.h"
#include "procedures/shunting.h"
#include "procedures/start_of_mission.h"
#include "procedures/train_data_change.h"
#include "procedures/train_trip.h"
#include "protection/antenna.h"
#include "protection/authority.h"
#include "protection/emergency_stops.h"
#include "protection/movement.h"
#include "radio/radio.h"
#include "sdm/supervision.h"
#include "track/description.h"
#include "track/services.h"

// The memory of the unit (State) and the data computed from it (Derived).
namespace evc::kernel {

/// The highest number X of a system version that is supported (6.4.2), as all from 1 on; operated first (3.17.2.9.1).
constexpr std::uint8_t highest_X(SrsVersion srs) { return lang::newest_version(srs).x; }
/// The operated system version as M_VERSION: of its number X the highest Y that the unit supports (3.17.2.1.1).
constexpr std::uint8_t operated_M_VERSION(std::uint8_t X, SrsVersion srs) {
  const unsigned Y = srs != SrsVersion::v4_0_0 ? 1u : X == 1 ? 1u : X == 2 ? 3u : 0u;
  return static_cast<std::uint8_t>((unsigned{X} << 4) | Y);
}

/// The countries or regions (NID_C) in which national values are applicable.
using NationalAreas = InplaceVector<std::uint16_t, 32>;
/// A set of national values as received (3.18.2.3). What it does not contain stays as it is (6.6.3.2.3 [1b], [2]).
struct NationalSet {
  train::NationalValues values;
  NationalAreas areas;
  bool of_X_2 = true;   ///< contains Q_NVLOCACC and V_NVLIMSUPERV
  bool braking = true;  ///< contains the values for braking curves
};

/// National values that wait for their place (3.18.2.9).
struct PendingNationalValues {
  Place from{};
  Anchor anchor{};
  NationalSet set;
};

/// The loop that a balise group announced (packet 134, 3.4.5.1).
struct AnnouncedLoop {
  std::uint16_t NID_C = 0;  ///< of the group: its messages have the same
  std::uint16_t NID_LOOP = 0;
  DataStatus status = DataStatus::valid;
  Direction orientation = Direction::unknown;  ///< of the train against the loop
  Anchor anchor{};                             ///< what its area hangs on
  bool entered = false;                        ///< by the min safe antenna (3.4.5.1.6)
  bool signal_passed = false;
  std::optional<GroupId> signal;  ///< of its SR distance (4.4.11.1.6.7)
  std::optional<Place> from, to;  ///< its area, from the group on; absent: not known
};

/// The RBC transition order that is executed, or was last (3.15.1). It is deleted from the track description when it is
/// complete.
struct Handover {
  std::optional<track::RbcTransition> order;
  procedures::rbc_handover::State procedure;
};

/// Radio infill (3.9.3): the area whose order was executed last, and the units that are to be called.
struct RadioInfill {
  struct Area {
    radio::Rbc unit;
    GroupId signal;              ///< at its end
    bool entry_due = false;      ///< the unit has to be informed that it was entered
    bool signal_passed = false;  ///< read or missed
    bool over = false;           ///< its end is passed
  };
  std::optional<Area> area;
  InplaceVector<radio::Rbc, 2> to_call;  ///< as soon as a session can be handled (3.9.3.5 b)
};

/// Data that the driver enters (3.18.4) and their status.
struct DriverData {
  DataStatus driver_id_status = DataStatus::unknown;
  DataStatus train_running_number_status = DataStatus::unknown;
  DataStatus train_data_status = DataStatus::unknown;
  DataStatus level_status = DataStatus::unknown;
  DriverId driver_id;
  std::uint32_t train_running_number = 0xFFFFFFFF;       // NID_OPERATIONAL, unknown
  std::optional<RbcIdentity> train_running_number_from;  // the RBC that gave it; absent: entered
};

/// The last reading of the clock, seconds since 1970 (3.18.5.1).
struct ClockReading {
  std::int64_t utc = 0;
  Duration at{};
};

/// A change of train data by another source than the driver (5.17).
struct TrainDataChange {
  std::optional<train::TrainData> pending;  ///< the changed data; absent: no change is pending
  bool driver_validates = false;
  procedures::train_data_change::State procedure;
};

/// The display of the LSSMA as trackside ordered it, with a generic LS marker (4.4.19.1.4.2-6).
struct LssmaDisplay {
  struct Order {
    Duration since{}, delay{};
  };
  std::optional<Order> waiting;  ///< an order to toggle it on whose time is not over
  bool on = false;
};

/// The distance that may be run in SR, and the entries of the driver (4.4.11).
struct StaffResponsible {
  std::optional<Place> end;            // absent: infinite
  std::optional<Place> national_from;  // the start of D_NVSTFF; absent: the distance is the RBC's or the driver's
  /// 4.0.0: the front end at the start of the distance, which no group moves (3.6.7.3); of a loop the end is a place.
  std::optional<OdometerReading> counter;
  Distance D{};                        // from there
  std::optional<Place> end_of_curves;  // where the max safe front end of the position is when that one has run it
  bool by_rbc = false;                 // given by an SR authorisation, even if infinite
  std::optional<Speed> V;
};

/// The inputs of the curves in force other than stored data: curves built again from them are the same (3.13.2,
/// 3.13.9.4.8).
struct SupervisionBasis {
  /// The curves are built again when one of these changes.
  struct Key {
    Mode mode{};                  ///< the MRSP and the supervision depend on it (4.5.2)
    std::uint32_t track = 0;      ///< track::Description::revision
    std::uint32_t revision = 0;   ///< State::revision
    std::uint8_t brakes = 0;      ///< special brakes reported active (3.13.2.2.6), one bit each
    bool level_1_at_EOA = false;  ///< alpha of 3.13.9.4.8.2: also by a level order in rear of the EOA
    std::uint32_t inaccuracy =
        0;  ///< with a release speed calculated on board: confidence interval and V_ura, in steps
    std::optional<Speed> mode_limit;  ///< of the mode (3.11.7)
    friend constexpr bool operator==(const Key&, const Key&) = default;
  };
  Key key;
  std::uint32_t number = 0;  ///< increases with every change of the key; 0: never built
  // At that moment:
  Place min_safe_rear{};
  Distance confidence_interval{};
  Speed V_ura{};
  Distance L_train_doubt{};        ///< of the front end, in a supervised manoeuvre (3.13.9.4.8.2)
  std::optional<Place> reference;  ///< of the LRBG
  Distance Q_LOCACC{};
  track::Authority authority;  ///< supervised from then on
};

/// The whole memory of the unit. Trivially copyable.
struct State {  // NOLINT(clang-analyzer-optin.performance.Padding): fields that belong together are together
  Duration now{};
  SrsVersion srs = SrsVersion::v3_6_0;
  std::array<bool, kLevels> fitted_levels{true, true, true, true, true};
  port::Identity identity;
  std::uint8_t terminals = 2;
  ByTrain by_train;
  track::SpeedCode V_SH = track::kNoSpeed;  // of the area that led to SH, deleted by 4.10 (3.11.7.1.1)
  std::int16_t local_time_offset_min = 0;
  Mode mode = Mode::NP;
  Mode previous_mode = Mode::NP;
  std::uint8_t operated_X =
      highest_X(SrsVersion::v3_6_0);  // operated system version, number X: kept without power (3.17.2.9)
  modes::OrderedLevel level;
  std::optional<modes::LevelTable> level_table;  // of the last order (5.10.2.7)

  train::TrainData train;
  Distance L_engine{};
  train::NationalValues national_values;
  // Of the national values; empty: those of the configuration or defaults. Values that a set of X = 1 left as they were
  // have areas of their own.
  NationalAreas national_areas, national_areas_of_X_2, national_areas_of_braking;
  std::optional<PendingNationalValues> pending_national_values;
  DriverData data;
  std::optional<ClockReading> clock;

  position::State position;
  position::OdometerAccuracy odometer_accuracy;  // 4.0.0 (3.6.8)
  Set<Anchor> anchors;                           // of stored data; those of the LRBG do not count
  position::ReportState reports;
  position::IntegrityStatus integrity;
  balise::State balise;
  track::Description track;
  radio::State radio;
  RadioNetwork network;
  Handover handover;
  std::optional<AnnouncedLoop> loop;
  RadioInfill radio_infill;
  InplaceVector<BufferedSet, kBufferedSets> buffer;

  procedures::start_of_mission::State start_of_mission;
  procedures::level_transition::State level_transition;
  procedures::mode_profile::State mode_profile;
  procedures::train_trip::State train_trip;
  procedures::end_of_mission::State end_of_mission;
  procedures::leaving_rbc::State leaving_rbc;
  procedures::override_::State override_;
  procedures::shunting::State shunting;
  TrainDataChange train_data_change;
  Set<Ack> requested;  // acknowledgements shown in the cycle before
  Set<Offer> offers;   // choices offered by the procedures, and
  Set<Entry> entries;  // entries, in the cycle before
  StaffResponsible staff_responsible;
  Manoeuvre manoeuvre;
  Speed dial;                                   // the highest speed on the dial of the display
  std::optional<Speed> set_speed;               // as entered
  Language language;                            // of the display: never deleted (4.10)
  std::optional<std::uint8_t> national_system;  // NID_NTC of the last level NTC
  LssmaDisplay lssma;
  bool safety_fault_memorised = false;  // it occurred in SL or NL, and these have to be left (4.4.6.1.6, 4.4.15.1.5)
  bool safety_fault_reported = false;   // to the RBC
  bool start_in_SR = false;             // selected by the driver: an MA is requested (4.4.11.1.6)
  bool slippery_rail = false;           // selected by the driver
  bool removes_cover = false;           // selected by the driver: the next one entered is removed
  bool toggled_on = false;              // by the driver: speeds and distances are shown in OS, SR and SH
  bool ma_with_trip_order = false;
  bool NL_was_permitted = false;      // by the train interface, in the cycle before
  bool level_crossing_shown = false;  // its approach began to be shown in the cycle before (5.16.1.4)

  protection::EmergencyStops emergency_stops;
  protection::MovementGuards guards;
  protection::AntennaAlarm antenna_alarm;
  protection::TrackAheadFree track_ahead_free;
  brakes::State brakes;
  bool shorten_at_standstill = false;                   // after a linking or consistency reaction (A.3.4 g, h, l, m)
  bool track_description_deleted = false;               // reason of the MA request until a new MA (3.8.2.7.3)
  InplaceVector<std::uint8_t, 6> texts_to_acknowledge;  // ids, the first is acknowledged first
  driver::StatusTexts status_texts;
  Displayed displayed;

  sdm::Supervision supervision;
  SupervisionBasis basis;
  std::uint32_t revision = 0;  // increases when train data, national values, mode or level change the supervision
  DataStatus contact_status = DataStatus::unknown;  // of the stored RBC contact (5.4.3.3)
  Cab cab = Cab::A;                                 // the active one, without one the last (3.6.1.5)
  bool desk_was_open = false;                       // in the cycle before
  bool asks_for_contact = false;                    // the driver, for a session after his change of level (5.10.3.15.2)
  bool contact_trip = false;                        // [41], found at the end of the cycle before
  bool edition_told = false;                        // what it lacks
  bool configuration_refused = false;               // train data or national values out of their range at power-up
};
static_assert(std::is_trivially_copyable_v<State>);
static_assert(sizeof(State) <= 64 * 1024);

/// Data that can be computed again from State at any time: curves and merged profiles. Not part of a snapshot; a
/// restored State is used with a Derived{}.
struct Derived {
  /// Curves of one authority, with their inputs.
  struct Curves {
    sdm::Inputs inputs;
    sdm::Derived sdm;
    InplaceVector<track::SpeedCode, 40> pbd_speeds;  ///< of the permitted braking distances stored (3.11.11)
  };
  /// Scratch memory: it is read only in the call that wrote it, and the data in force do not change.
  struct Scratch {
    balise::Outcome balises;                             ///< of a telegram, of what is overdue or expected
    track::Contents contents;                            ///< of the evaluated message
    track::AuthorityContents proposal;                   ///< of the evaluated authority (4.8.3 [4], 3.8.6)
    Curves curves;                                       ///< of the proposed authority (3.8.6)
    InplaceVector<BufferedSet, kBufferedSets> released;  ///< from the transition buffer
  };
  std::uint32_t built = 0;  ///< SupervisionBasis::number `in_force` was built from; 0: from none
  Curves in_force;
  Scratch scratch;
};

}  // namespace evc::kernel
