#pragma once
#include <cstdint>
#include <optional>

#include "procedures/effects.h"
#include "terms/data_status.h"
#include "terms/level.h"
#include "terms/mode.h"
#include "terms/srs_version.h"

// Start of mission, SUBSET-026-5 5.4. The steps have the standard's names.
namespace evc::procedures::start_of_mission {

enum class Session : std::uint8_t { none, establishing, open, terminating };

/// The steps in which the procedure waits; decisions and actions between them take no time.
enum class Step : std::uint8_t {
  S0,   // no mission is being started
  S1,   // driver identity
  S2,   // level
  S3,   // RBC contact
  S4,   // 4.0.0: a mobile terminal registers with the radio network
  D31,  // the session is being opened
  D33,  // the RBC validates the position or decides (D33, D22)
  A40,  // the train is rejected: the session is being terminated
  S10,  // shunting, non leading or train data
  S12,  // train data
  S13,  // train running number
  S11,  // train data sent, the RBC's acknowledgement is due
  S20,  // start
  S21,  // waits for the RBC's answer to the MA request
  S22,  // SN is acknowledged
  S23,  // UN
  S24,  // SR
  S25,  // OS, LS or SH
};

struct State {
  Step step = Step::S0;
  Mode profile = Mode::OS;             // S25: the mode to acknowledge
  bool without_session = false;        // S24: Start was chosen in level 2/3 without a session
  bool had_session = false;            // since the desk was opened
  bool desk_was_open = false;          // in the cycle before
  bool entry_was_open = false;         // the entry of train data, in the cycle before
  std::uint8_t cycles_in_session = 0;  // S0: with an open session, up to 2; then it is being terminated
};

struct Inputs {
  Mode mode = Mode::SB;
  Level level = Level::L0;
  bool desk_open = false;
  Session session = Session::none;
  bool mobile_terminal_registered = false;
  bool network_offered = false;         // the driver may choose another network
  bool registration_failed = false;     // none is registered, and the time to wait for it is over (A.3.1 of 4.0.0)
  bool position_refers_to_LRBG = true;  // not to an unlinked group alone
  // Status of the stored data, entries of this cycle included.
  DataStatus driver_id = DataStatus::unknown;
  DataStatus train_running_number = DataStatus::unknown;
  DataStatus position = DataStatus::unknown;
  DataStatus level_status = DataStatus::unknown;
  DataStatus train_data = DataStatus::unknown;
  // The driver, this cycle.
  bool enters_level = false;          // entered or revalidated (S2, and again in S10 and S20)
  bool enters_rbc_contact = false;    // entered, revalidated or "last RBC" chosen
  bool selects_short_number = false;  // the identity of the RBC is not known yet (3.5.3.11)
  bool enters_train_data = false;
  bool entry_of_train_data_open = false;  // selected (E11), and not left since
  bool selects_start = false;
  // The RBC, this cycle.
  bool train_data_acknowledged = false;  // message 8, or acknowledged earlier and not changed since
  bool position_confirmed = false;       // 43
  bool train_accepted = false;           // 41
  bool train_rejected = false;           // 40
  bool SR_authorised = false;            // 2
  // MA, SSP and gradient are stored and the mode profile requires this mode at the train's position (OS, LS or SH).
  std::optional<Mode> profile_at_front;
  SrsVersion srs = SrsVersion::v3_6_0;
};

/// One cycle. Outside SB, or with the desk closed, the procedure has ended (step S0); its session, or the set-up of
/// one, ends with a desk that is closed meanwhile (3.5.3.8 a, 3.5.5.1). A session that is open when the desk is opened
/// is terminated first (5.4.1.4); so is one that the on-board opens later in S0, once it is open. The acknowledgements
/// asked for in S22 to S25 become [58], [60], [8], [15], [70], [50] in observe(); a plain MA in S21 is [10].
Effects step(State& state, const Inputs& inputs);

/// Whether the procedure goes on, or has just led to a mode, without having had a session (3.5.3.4 g).
bool without_session(const State& state);

}  // namespace evc::procedures::start_of_mission
