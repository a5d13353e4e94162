#include "kernel/intake/groups.h"

#include "kernel/here.h"
#include "kernel/intake/buffer.h"
#include "kernel/intake/filter.h"
#include "kernel/intake/loops.h"
#include "kernel/intake/national_values.h"
#include "kernel/intake/system_version.h"
#include "kernel/radio_infill.h"
#include "modes/active_functions.h"
#include "protection/authority.h"
#include "track/relocate.h"
#include "track/services.h"

namespace evc::kernel {
namespace {

bool judged_by_crossing(Mode mode) { return mode == Mode::SL || mode == Mode::PS || mode == Mode::SH; }

/// Modes in which an inconsistent message does not brake (4.4.6.1.12, 4.4.14.1.9, 4.4.15.1.10, 4.4.18.1.10,
/// 4.4.20.1.15).
bool brakes_on_message_error(Mode mode) {
  return modes::active(modes::Function::bg_msg_consistency_unlinked, mode) && mode != Mode::SL && mode != Mode::PT &&
         mode != Mode::NL && mode != Mode::RV && mode != Mode::PS;
}

/// 3.14.3.6: telegrams read during a movement that reverse movement protection forbids are ignored. In PT and RV the
/// permitted direction is backward.
bool moves_against_permission(const State& s) {
  if (!modes::active(modes::Function::reverse_movement, s.mode)) return false;
  const bool backward_permitted = s.mode == Mode::PT || s.mode == Mode::RV;
  return position::motion(s.position) == (backward_permitted ? position::Motion::forward : position::Motion::backward);
}

balise::Situation situation_of(const Reception& r) {
  const State& s = r.state;
  balise::Situation now;
  now.now = s.now;
  now.linking_checked = modes::active(modes::Function::link_consistency, s.mode);
  now.braking_on_message_error = brakes_on_message_error(s.mode);
  now.against_permitted_movement = moves_against_permission(s);
  now.counter_rises = position::counter_rises(s.position);
  now.level_1_2_3 = level_1_2_3(s.level.level);
  now.srs = s.srs;
  now.highest_X = highest_X(s.srs);
  return now;
}

void react(Reception& r, const balise::Outcome& outcome) {
  State& s = r.state;
  bool linking = false;
  bool two_missed = false;
  for (const balise::Event& e : outcome.events) {
    // The contents of the group are logged where they are evaluated.
    if (e.what == What::group_accepted) continue;
    r.log.note({.what = e.what, .id = e.id.NID_BG, .clause = e.clause});
    if (e.report != ErrorReport::none && level_2_or_3(s.level.level)) radio::report_error(s.radio, e.report);
    if (e.what == What::linking_error_missed || e.what == What::linking_error_later)
      note_signal_of_radio_infill(s, e.id);
    linking = linking || e.what == What::linking_error_early || e.what == What::linking_error_missed ||
              e.what == What::linking_error_later;
    two_missed = two_missed || e.what == What::double_linking_error;
  }
  if (outcome.reaction == Reaction::trip) r.out.linking_reaction_trip = true;
  if (outcome.reaction == Reaction::service_brake) {
    r.out.asked.add(two_missed ? brakes::Cause::two_groups_missed
                    : linking  ? brakes::Cause::linking
                               : brakes::Cause::balise_group_consistency);
    s.shorten_at_standstill = s.shorten_at_standstill || outcome.shorten_at_standstill;
  }
  if (outcome.wrong_direction) r.out.linked_group_wrong_direction = true;
  if (outcome.version_too_high) r.out.telegram_version_too_high = true;
}

/// Stored data that hang on `of` move and hang on `then` from now on.
void relocate_stored(State& s, Anchor of, Anchor then, const Relocation& by) {
  if (!s.anchors.has(of)) return;
  track::relocate(s.track, of, then, by);
  if (auto& pending = s.level_transition.pending; pending && pending->anchor == of) {
    pending->border = pending->border + by.shift;
    pending->anchor = then;
  }
  if (auto& table = s.level_transition.announced_table; table && table->anchor == of) {
    table->border = table->border + by.shift;
    table->anchor = then;
  }
  if (auto& pending = s.pending_national_values; pending && pending->anchor == of) {
    pending->from = pending->from + by.shift;
    pending->anchor = then;
  }
  if (auto& loop = s.loop; loop && loop->anchor == of) {
    if (loop->from) loop->from = *loop->from + by.shift;
    if (loop->to) loop->to = *loop->to + by.shift;
    loop->anchor = then;
  }
  for (BufferedSet& set : s.buffer) {
    if (set.anchor != of) continue;
    set.reference = set.reference + by.shift;
    set.widening.nearer = set.widening.nearer + by.nearer;
    set.widening.farther = set.widening.farther + by.farther;
    set.anchor = then;
  }
  s.anchors.remove(of);
  s.anchors.add(then, then != Anchor::lrbg);
}

/// The group becomes the LRBG, or only the reference of its own information.
const position::Reference& locate(Reception& r, const balise::Group& group) {
  State& s = r.state;
  // 3.6.1.4 of 4.0.0: the invalid position is deleted, with the groups of before: the way from them is not known.
  if (s.srs == SrsVersion::v4_0_0 && s.position.status == DataStatus::invalid) position::forget(s.position);
  position::Passage passage;
  passage.id = group.id;
  passage.counter = group.counter;
  passage.L_antenna = L_antenna(s);
  passage.link_place = group.link_place;
  passage.Q_LOCACC = group.Q_LOCACC ? *group.Q_LOCACC : s.national_values.Q_NVLOCACC;
  passage.counter_against_group = group.counter_against_group;
  passage.single = group.single;
  if (group.lrbg_compliant) {
    const position::Relocated by = position::relocate(s.position, passage);
    if (by.out_of_tolerance) r.log.note({.what = What::odometer_out_of_tolerance, .id = group.id.NID_BG});
    relocate_stored(s, Anchor::travelled, by.by_linking ? Anchor::lrbg : Anchor::travelled, by.travelled);
    relocate_stored(s, Anchor::unlinked, Anchor::travelled, by.unlinked);
    // The release speed calculated on board depends on the accuracy of the LRBG (3.13.9.4.8.2).
    if (s.basis.authority.release.kind == ReleaseSpeedChoice::on_board) ++s.revision;
    r.out.new_lrbg = true;
    return s.position.references.back();
  }
  // Data of the unlinked group before it move only where it is the reference of the position.
  const position::Relocated by = position::refer_to_unlinked(s.position, passage);
  relocate_stored(s, Anchor::unlinked, Anchor::unlinked, by.unlinked);
  // 4.0.0 knows a valid position that refers to an unlinked group (3.6.2.2.2.1, 5.4.3.2 D34).
  if (s.srs == SrsVersion::v4_0_0 && position::lrbg(s.position) == nullptr) s.position.status = DataStatus::valid;
  return *s.position.unlinked;
}

/// A group whose message is refused is passed all the same (4.6.3 [36], [52]). In 4.0.0 no clause counts it (A.3.3.2,
/// Table 17); nor the part of a group that a virtual balise cover leaves, if it is refused (A.3.3.5).
void check_lists(Reception& r, const balise::Group& group) {
  State& s = r.state;
  if (s.srs == SrsVersion::v4_0_0 && !group.accepted) return;
  const auto named = [id = group.id](const track::GroupList& list) {
    for (const GroupId& g : list)
      if (g == id) return true;
    return false;
  };
  if (s.mode == Mode::SR && s.track.sr_list) {
    const bool expected = named(*s.track.sr_list);
    if (expected && group.accepted) r.out.group_passed_in_SR_list = true;
    if (!expected) r.out.group_passed_not_in_SR_list = true;
  }
  if (s.mode == Mode::SH && s.track.sh_list && !named(*s.track.sh_list)) r.out.group_passed_not_in_SH_list = true;
}

/// A group whose telegrams contain more packets than the unit can hold is treated as a group with an inconsistent
/// message (3.16.2.4.4): none of it is used.
void refuse_group(Reception& r, GroupId id) {
  State& s = r.state;
  r.log.note({.what = What::group_too_many_packets, .id = id.NID_BG, .clause = "3.16.2.4.4"_srs});
  if (!brakes_on_message_error(s.mode)) return;
  r.out.asked.add(brakes::Cause::balise_group_consistency);
  s.shorten_at_standstill = true;
}

/// The trip by a balise group in release speed monitoring (3.13.10.2.6 b of 4.0.0).
void check_group_at_EOA(Reception& r, const balise::Group& group) {
  const State& s = r.state;
  const bool in_RSM = s.supervision.active && s.supervision.monitoring == Monitoring::RSM;
  if (s.srs != SrsVersion::v4_0_0 || !in_RSM || !level_2_or_3(s.level.level)) return;
  if (!group.announced || !group.link_place || !group.Q_LOCACC) return;
  if (protection::group_trips(s.basis.authority, *group.link_place - *group.Q_LOCACC, L_antenna(s)))
    r.out.group_at_EOA_in_RSM = true;
}

void receive_group(Reception& r, const balise::Group& group) {
  State& s = r.state;
  check_group_at_EOA(r, group);
  if (group.identified) {
    note_signal_of_loop(s, group.id);
    note_signal_of_radio_infill(s, group.id);
    check_lists(r, group);
  }
  if (!group.accepted) return;
  const bool other_country = in_another_country(s, group.id.NID_C);
  // Before the group is located: its default accuracy is that of its own country (3.18.2.5).
  leave_area(r, group.id.NID_C);
  const position::Reference& reference = locate(r, group);
  r.out.here = here(s);
  balise::keep_covers_of(s.balise, group.id.NID_C);
  const Anchor anchor = group.lrbg_compliant ? Anchor::lrbg : Anchor::unlinked;
  s.anchors.add(anchor, anchor != Anchor::lrbg);
  track::note_group(s.track, group.id, reference.place, reference.orientation, anchor);
  if (group.default_information) r.out.default_information = true;
  r.log.note({.what = What::group_accepted, .id = group.id.NID_BG});

  Information information;
  information.medium = Medium::balise;
  information.group = group.id;
  information.reference = reference.place;
  information.anchor = anchor;
  if (anchor != Anchor::lrbg) information.widening = position::from_unlinked(s.position);
  information.orientation = judged_by_crossing(s.mode) ? group.crossing : reference.orientation;
  information.min_safe_front = r.out.here.min_safe_front;
  information.time = group.first_passed;
  information.marked_unlinked = !group.linked;
  information.repositioning = group.repositioning;
  information.version = SenderVersion{group.X, other_country};
  for (const balise::Telegram& t : group.telegrams) {
    if (!t.used) continue;
    const lang::TelegramView view =
        lang::scan_telegram(t.span(), t.bits, lang::Check::structure, lang::newest_version(s.srs));
    if (!gather(information, view.packets, &r.log)) return refuse_group(r, group.id);
  }
  drop_superseded(information, &r.log);
  const Waiting waiting = evaluate(r, information);
  if (!waiting.any()) return;
  BufferedSet& set = keep(r, information, waiting);
  for (const balise::Telegram& t : group.telegrams)
    if (t.used) add_telegram(set, t.span(), t.bits);
}

void take(Reception& r, const balise::Outcome& outcome) {
  react(r, outcome);
  for (const balise::Group& group : outcome.groups) receive_group(r, group);
}

}  // namespace

void receive_balises(Reception& r) {
  State& s = r.state;
  balise::Outcome& outcome = r.scratch.balises;  // each call begins it anew
  for (const BaliseTelegram& t : r.in.balise_telegrams) {
    balise::Reading reading;
    reading.bytes = t.bytes;
    reading.bits = t.bits;
    reading.counter = position::reading_at(s.position, t.passed ? position::counter_at(s.position, *t.passed) : t.at);
    reading.antenna = position::antenna_at(s.position, reading.counter, L_antenna(s));
    balise::read(s.balise, reading, situation_of(r), outcome);
    take(r, outcome);
  }
  balise::Situation now = situation_of(r);
  balise::close_overdue(s.balise, s.position.now.counter, now, outcome);
  if (!outcome.groups.empty() || !outcome.events.empty()) {
    take(r, outcome);
    now = situation_of(r);
  }
  balise::expect(s.balise, position::antenna(s.position, L_antenna(s)), now, outcome);
  take(r, outcome);
}

}  // namespace evc::kernel
