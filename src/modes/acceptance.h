#pragma once
#include <cstdint>
#include <optional>

#include "terms/clause.h"
#include "terms/information.h"
#include "terms/level.h"
#include "terms/medium.h"
#include "terms/mode.h"
#include "terms/radio_link.h"
#include "terms/srs_version.h"

namespace evc::modes {

/// The kind of a level transition order: packet 41 with D_LEVELTR 32767 is immediate, any other an announcement; packet
/// 46 is conditional.
enum class OrderKind : std::uint8_t { immediate, announcement, conditional };

/// The facts for the exceptions of 4.8.3 and 4.8.4, at the time of the evaluation.
struct AcceptanceContext {
  Mode mode = Mode::NP;
  Level level = Level::L0;
  Medium medium = Medium::balise;
  SessionRole rbc = SessionRole::supervising;  // of the RBC that sends (4.8.2)
  bool infill = false;
  // 4.8.3
  std::optional<Level> announced;               // [1][2][6][7][9]: a transition to this level further on is ordered. An
                                                // order in the same message that changes the level counts as one: the
                                                // rest is then buffered and judged at the new level (4.8.1.3.1).
  bool train_data_unacknowledged = false;       // [3]: sent to the RBC and not acknowledged; in 4.0.0 the first ones
                                                // of the session, or others in what its routes depend on
  bool described_over_whole_ma = false;         // [4]: SSP and gradient, stored or in this message, cover the MA
  bool emergency_stop_pending = false;          // [5]
  bool revocable_and_inhibited = false;         // [8]: a revocable TSR while their inhibition is stored
  bool other_previous_lrbg = false;             // [10]: the LRBG was reported with a different previous one
  bool level_order_along_or_announced = false;  // [11]
  bool text_awaits_acknowledgement = false;     // [12]: same message identity, report asked for, not yet acknowledged
  bool immediate_order_to_1_2_3 = false;        // [13]: comes with the message
  bool names_rbc_of_transition = false;         // [14]: the RBC of a stored or same-message RBC transition order
  bool network_missing = false;                // [15] of 4.0.0: no radio of this unit is registered to the network that
                                               // a network order of the message names
  bool unlinked_with_level_1 = false;          // [16] of 4.0.0: by a group marked as unlinked, level 1 in its table
  bool consist_length_unacknowledged = false;  // [17] of 4.0.0: it was sent to the RBC
  // 4.8.4
  bool exit_from_trip_recognised = false;    // [1]: recognition received, and this information is later than it
  bool desk_open = false;                    // [2]
  bool orders_establishment = false;         // [3]: session management that orders to establish one
  bool train_data_valid = false;             // [4]
  OrderKind order = OrderKind::immediate;    // [5][7], of a level transition order
  bool override_active = false;              // [6]
  bool null_distance = false;                // [8]: RBC transition order to be executed at once
  bool front_in_ls_area_of_message = false;  // [9][10]: in the LS area of a profile in this message
  bool front_in_OS_ack_area = false;         // [10] of 4.0.0: the estimated front end
  bool train_running_number = false;         // [11] of 4.0.0: valid, or in this message
  SrsVersion srs = SrsVersion::v3_6_0;
};

enum class Verdict : std::uint8_t {
  accepted,
  buffered,             // stored in the transition buffer and judged again when the level or RBC changes (4.8.5)
  only_contact_stored,  // only the RBC's identity and number are stored (4.8.4 [3], [8])
  order_stored,         // the level order is stored until a mode other than SH or PS is entered (4.8.4 [7])
  rejected,
};

struct Acceptance {
  Verdict verdict = Verdict::rejected;
  Clause clause;  // the table and the exception that decided, "4.8.3 [4]"; the table alone for a plain cell
};

/// 4.8.1: the filter of level and medium (4.8.3), then that of the supervising RBC (4.8.2), then that of the mode
/// (4.8.4). Buffered information passes the other filters when it is released. A cell that cannot occur rejects.
Acceptance accept(Information information, const AcceptanceContext& context);

/// The first filter alone.
Acceptance accept_by_level(Information information, const AcceptanceContext& context);
/// The second filter alone: for information from the RBC that does not supervise yet, or no longer
/// supervises.
Acceptance accept_by_rbc(Information information, const AcceptanceContext& context);
/// The third filter alone.
Acceptance accept_by_mode(Information information, const AcceptanceContext& context);

/// 4.8.3, last part: information from the national system X. `own_level_ntc`: the level is NTC of the same X;
/// `announced_own`: a transition to NTC X further on is ordered.
Acceptance accept_from_stm(Information information, bool own_level_ntc, bool announced_own,
                           const AcceptanceContext& context);

}  // namespace evc::modes
