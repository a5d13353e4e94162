#pragma once
#include <nlohmann/json_fwd.hpp>

#include "check/finding.h"
#include "check/trackside.h"
#include "io/diagnostic.h"
#include "io/train_file.h"

// The rules of a review, by what they look at.
namespace evc::check {

/// Telegrams and groups: bits, header variables, order and spacing of the balises, identities (3.4.1, 3.4.2, 3.16.2).
void check_groups(const Trackside& trackside, Findings& out);
/// Radio messages: bits, numbers, and the group that each one counts from (3.6.2.2, 8.4.4).
void check_messages(const Trackside& trackside, Findings& out);
/// What a train meets on its way: levels with the filters of 4.8.3, linking, authorities with their profiles and
/// timers, restrictions that are revoked (3.4.4, 3.7.2.3, 3.8, 3.11.5).
void check_journey(const Trackside& trackside, Findings& out);
/// `physical_track`: gradients and speeds without holes and overlaps.
void check_track(const Trackside& trackside, Findings& out);
/// Bits and what the file says about them in its other keys (`nid_bg`, `header`, `packets`, `fields`, `contains`, ...).
/// `document` is the file that the line was read from.
void check_document(const Trackside& trackside, const nlohmann::json& document, Findings& out);
/// Restrictions that reach this train too late: it runs along the line, at the permitted speed, with the on-board.
void check_braking(const Trackside& trackside, const io::Train& train, Findings& out);

}  // namespace evc::check
