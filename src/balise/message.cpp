#include "balise/message.h"

#include "lang/instances.h"

namespace evc::balise {
namespace {

constexpr std::uint8_t kNextIsSame = 1, kPreviousIsSame = 2;  // M_DUP
constexpr std::uint8_t kFitsNone = 254, kFitsAll = 255;       // M_MCOUNT

Telegram* read_of(OpenGroup& open, int N_PIG) {
  for (Telegram& telegram : open.telegrams)
    if (telegram.N_PIG == N_PIG) return &telegram;
  return nullptr;
}

/// The telegram marked as the duplicate of balise `n`, or null.
Telegram* duplicate_of(OpenGroup& open, int n) {
  Telegram* before = read_of(open, n - 1);
  if (before != nullptr && before->M_DUP == kNextIsSame) return before;
  Telegram* after = read_of(open, n + 1);
  if (after != nullptr && after->M_DUP == kPreviousIsSame) return after;
  return nullptr;
}

/// The errors within the group; for a and b, whether a duplicate resolves them.
struct Examined {
  bool missed = false;       // a, and no duplicate was read
  bool not_decoded = false;  // b, and no duplicate was read
  bool all_read = false;
  bool direction_saved = true;  // the packets of these duplicates can be used without linking (3.16.2.4.4.1 a)
  bool single = false;
  Finding content = Finding::none;  // c or d
  Direction crossing = Direction::unknown;
};

/// One of each pair of duplicates is used (3.16.2.4.8.1, .2).
void choose_duplicates(OpenGroup& open) {
  for (Telegram& first : open.telegrams) {
    if (first.M_DUP != kNextIsSame) continue;
    Telegram* second = read_of(open, first.N_PIG + 1);
    if (second == nullptr || second->M_DUP != kPreviousIsSame) continue;
    if (first.default_information != second->default_information) {
      (first.default_information ? first : *second).used = false;
      continue;
    }
    const bool second_is_last = second > &first;  // they are in the order of reading
    (second_is_last ? first : *second).used = false;
  }
}

bool counters_fit(const OpenGroup& open) {
  int common = kFitsAll;
  for (const Telegram& telegram : open.telegrams) {
    if (!telegram.used || telegram.M_MCOUNT == kFitsAll) continue;
    if (telegram.M_MCOUNT == kFitsNone) return false;  // 3.16.2.4.7, .7.1
    if (common != kFitsAll && common != telegram.M_MCOUNT) return false;
    common = telegram.M_MCOUNT;
  }
  return true;
}

/// 8.4.1.4 for the whole message: the telegrams it is composed of (8.4.1.6), each of which is consistent.
bool packets_fit(const OpenGroup& open, SrsVersion srs) {
  lang::Instances message;
  for (const Telegram& telegram : open.telegrams) {
    if (!telegram.used) continue;
    message.begin_telegram();
    const lang::TelegramView view =
        lang::scan_telegram(telegram.span(), telegram.bits, lang::Check::structure, lang::newest_version(srs));
    for (const lang::PacketView& packet : view.packets)
      if (message.add(packet)) return false;
  }
  return true;
}

Direction order_of_reading(const OpenGroup& open) {
  if (open.telegrams.size() < 2) return Direction::unknown;
  return open.telegrams.back().N_PIG > open.telegrams.front().N_PIG ? Direction::nominal : Direction::reverse;
}

/// 3.4.2.3, 3.4.2.4.1: one balise, or a pair of duplicates of which one was read.
bool gives_no_orientation(const OpenGroup& open) {
  if (open.N_TOTAL == 0) return true;
  return open.N_TOTAL == 1 && open.telegrams.size() == 1 && open.telegrams.front().M_DUP != 0 &&
         open.telegrams.front().M_DUP != 3;
}

void examine_missing(OpenGroup& open, Examined& found) {
  bool any = false;
  for (int n = 0; n <= open.N_TOTAL; ++n) {
    if (((open.seen >> n) & 1u) != 0) continue;
    any = true;
    const Telegram* duplicate = duplicate_of(open, n);
    if (duplicate == nullptr || duplicate->faulty) {
      (open.undecoded ? found.not_decoded : found.missed) = true;
      continue;
    }
    if (duplicate->one_direction && found.crossing == Direction::unknown) found.direction_saved = false;
  }
  found.all_read = !any;
  // The undecoded telegram belongs to no known balise of this group: no duplicate replaces it.
  if (!any && open.undecoded) found.not_decoded = true;
}

Examined examine(OpenGroup& open, SrsVersion srs) {
  Examined found;
  found.single = gives_no_orientation(open);
  found.crossing = order_of_reading(open);
  examine_missing(open, found);
  choose_duplicates(open);
  bool faulty = open.header_mismatch;
  for (const Telegram& telegram : open.telegrams) faulty = faulty || (telegram.used && telegram.faulty);
  if (faulty || (open.telegrams.size() > 1 && !packets_fit(open, srs)))
    found.content = Finding::invalid_value;
  else if (!counters_fit(open))
    found.content = Finding::counters_differ;
  return found;
}

/// The error that counts; `linked_by_list`: linking gave the reference, so a duplicate resolves the error in any case.
Finding error_of(const Examined& found, bool linked_by_list) {
  if (found.not_decoded) return Finding::balise_not_decoded;
  if (found.missed || (!linked_by_list && !found.direction_saved)) return Finding::balise_missed;
  return found.content;
}

/// 3.16.2.4.4.1 b: packet 145 in a telegram that was read inhibits the brake reaction to errors a
/// and b.
bool inhibited(const OpenGroup& open, const Examined& found) {
  if (found.all_read || found.content != Finding::none) return false;
  for (const Telegram& telegram : open.telegrams)
    if (telegram.inhibits_reaction && !telegram.faulty) return true;
  return false;
}

bool repositioning_for(const OpenGroup& open, Direction crossing) {
  for (const Telegram& telegram : open.telegrams) {
    if (!telegram.used) continue;
    for (std::uint64_t Q_DIR = 0; Q_DIR < 3; ++Q_DIR)
      if (((telegram.repositioning >> Q_DIR) & 1u) != 0 && valid_for(Q_DIR, crossing)) return true;
  }
  return false;
}

void refuse(Group& group, Finding finding, What what, Reaction reaction, ErrorReport report, Clause clause,
            Outcome& outcome) {
  group.accepted = false;
  group.finding = finding;
  note(outcome, {what, group.id, finding, reaction, report, clause});
}

/// The group is not checked against linking: 3.16.2.4.4, 3.16.2.5.1.
void judge_by_itself(Group& group, const OpenGroup& open, const Examined& found, const Situation& situation,
                     Outcome& outcome) {
  const Finding error = error_of(found, false);
  group.accepted = error == Finding::none;
  if (group.accepted) return;
  const bool brakes = situation.braking_on_message_error && !inhibited(open, found);
  const Reaction reaction = brakes ? Reaction::service_brake : Reaction::none;
  if (group.linked)
    refuse(group, error, What::group_inconsistent, reaction, ErrorReport::linked_message, "3.16.2.4.4"_srs, outcome);
  else
    refuse(group, error, What::group_inconsistent, reaction, ErrorReport::unlinked_message, "3.16.2.5.1"_srs, outcome);
}

/// The announced group, its reference balise in its window (or missed): 3.16.2.3.2, 3.16.2.4.1.
void judge_announced(Group& group, const Link& link, const Examined& found, Outcome& outcome) {
  group.accepted = true;
  group.link_place = link.place;
  group.Q_LOCACC = link.Q_LOCACC;
  if (found.crossing != Direction::unknown && found.crossing != link.crossing)
    refuse(group, Finding::wrong_direction, What::group_wrong_direction, Reaction::trip, ErrorReport::linking,
           "3.16.2.3.2"_srs, outcome);
  const Finding error = error_of(found, true);
  if (error != Finding::none)
    refuse(group, error, What::group_inconsistent, link.reaction, ErrorReport::linked_message, "3.16.2.4.1"_srs,
           outcome);
  if (!group.accepted) return;
  note(outcome, {What::linking_ok, group.id, Finding::none, Reaction::none, ErrorReport::none, "3.4.4.4.3"_srs});
}

/// Not the group that is expected with unknown identity. 4.0.0: with an error in its reading it may have been that one,
/// unless it was crossed the other way (3.16.2.4.3.1).
void pass_over(Group& group, const Link& link, const Examined& found, const Situation& situation, Outcome& outcome) {
  const Finding error = error_of(found, true);
  const Finding finding = error != Finding::none ? error : Finding::not_repositioning;
  const bool unread = error == Finding::balise_missed || error == Finding::balise_not_decoded;
  const bool other_way = found.crossing != Direction::unknown && found.crossing != link.crossing;
  if (situation.srs == SrsVersion::v4_0_0 && unread && !other_way)
    return refuse(group, finding, What::group_inconsistent, link.reaction, ErrorReport::none, "3.16.2.4.3.1"_srs,
                  outcome);
  refuse(group, finding, What::group_ignored, Reaction::none, ErrorReport::none, "3.4.4.4.2.1"_srs, outcome);
}

/// Identity unknown was expected: 3.4.4.4.2.1 a to c.
void judge_repositioning(LinkingState& linking, Group& group, const OpenGroup& open, const Link& link,
                         const Examined& found, const Situation& situation, Outcome& outcome) {
  const bool fits = found.crossing != Direction::unknown && found.crossing == link.crossing &&
                    repositioning_for(open, found.crossing);
  if (!fits) return pass_over(group, link, found, situation, outcome);
  group.announced = true;
  const Finding error = error_of(found, true);
  if (error != Finding::none) {  // the announced group, its message inconsistent
    leave_repositioning(linking, link);
    return refuse(group, error, What::group_inconsistent, link.reaction, ErrorReport::linked_message, "3.16.2.4.1"_srs,
                  outcome);
  }
  take_repositioning(linking, group.id, link);
  group.accepted = true;
  group.repositioning = true;
  // The entry with unknown identity breaks the chain of link distances: the estimated place is used
  // (3.6.4.3).
  group.Q_LOCACC = link.Q_LOCACC;
  note(outcome, {What::linking_ok, group.id, Finding::none, Reaction::none, ErrorReport::none, "3.4.4.4.2.1"_srs});
}

/// Where linking is not supervised, a stored entry still gives place, accuracy and orientation.
void use_stored_link(Group& group, const std::optional<Link>& link) {
  if (!link || !group.accepted) return;
  group.link_place = link->place;
  group.Q_LOCACC = link->Q_LOCACC;
}

void look_for_second_repositioning(LinkingState& linking, const Group& group, const OpenGroup& open, Outcome& outcome) {
  if (!group.linked || group.announced || !second_repositioning(linking, group.id, group.crossing)) return;
  if (!repositioning_for(open, group.crossing)) return;
  linking.repositioned.reset();
  note(outcome, {What::double_repositioning, group.id, Finding::none, Reaction::service_brake,
                 ErrorReport::double_repositioning, "3.16.2.7.2.2"_srs});
}

/// The reference balise is N_PIG 0, or its duplicate where that one was not read (3.16.2.3.3).
const Telegram* location_reference(OpenGroup& open) {
  const Telegram* reference = read_of(open, 0);
  return reference != nullptr ? reference : duplicate_of(open, 0);
}

Direction against_counter(const OpenGroup& open, Direction crossing, const Situation& situation) {
  if (crossing == Direction::unknown) return crossing;
  if (open.telegrams.size() > 1) {
    const Telegram& first = open.telegrams.front();
    const Telegram& last = open.telegrams.back();
    if (last.counter.nominal > first.counter.nominal) return crossing;
    if (last.counter.nominal < first.counter.nominal) return opposite(crossing);
  }
  return situation.counter_rises ? crossing : opposite(crossing);
}

void describe(Group& group, const OpenGroup& open, const Telegram* reference) {
  group = {};
  group.id = open.id;
  group.identified = open.identified;
  group.linked = open.identified && open.Q_LINK;
  group.first_passed = open.first_passed;
  group.counter = open.last;
  if (reference != nullptr) {
    group.counter = reference->counter;
    group.antenna = reference->antenna;
  } else if (open.ignored_reference) {  // it is ignored, and the origin of the group all the same (3.4.2.2.1)
    group.counter = open.ignored_reference->counter;
    group.antenna = open.ignored_reference->antenna;
  }
}

void finish(Group& group, const OpenGroup& open) {
  for (const Telegram& telegram : open.telegrams) {
    if (telegram.used && telegram.default_information) group.default_information = true;
    const auto X = static_cast<std::uint8_t>(telegram.M_VERSION >> 4);
    if (X > group.X) group.X = X;
  }
  group.telegrams = open.telegrams;
  const bool place_fits = group.linking_used ? group.announced : true;
  group.lrbg_compliant = group.accepted && group.linked && place_fits;  // 3.6.2.2.2 a
}

/// Completes the judgement of the reference balise where it is still open, or where a list of linking that came after
/// it announces the group.
void complete_judgement(LinkingState& linking, OpenGroup& open, const Situation& situation, Outcome& outcome) {
  Judgement& judgement = open.judgement;
  if (!open.identified || !open.Q_LINK) {
    judgement = {Judgement::Verdict::unlinked, std::nullopt};
    return;
  }
  if (judgement.verdict != Judgement::Verdict::unjudged && !announced_since(linking, open)) return;
  if (const Telegram* reference = location_reference(open))
    judgement = judge(linking, open.id, true, reference->antenna, situation.linking_checked, outcome);
  else if (open.ignored_reference)
    judgement = judge(linking, open.id, true, open.ignored_reference->antenna, situation.linking_checked, outcome);
  else
    judgement = judge_without_reference(linking, open.id, open.last_antenna, situation.linking_checked);
}

void orient(Group& group, const OpenGroup& open, const Examined& found, const Situation& situation) {
  const std::optional<Link>& link = open.judgement.link;
  group.single = found.single;
  group.crossing = found.crossing;
  // 3.4.2.3.2.2: a group without orientation of its own is assigned the announced one.
  if (found.crossing == Direction::unknown && link && link->gives_orientation) group.crossing = link->crossing;
  group.counter_against_group = against_counter(open, group.crossing, situation);
}

/// Decides by linking whether the group is accepted.
void decide(LinkingState& linking, Group& group, const OpenGroup& open, const Examined& found,
            const Situation& situation, Outcome& outcome) {
  using Verdict = Judgement::Verdict;
  const auto ignore = [&](Finding finding, Clause clause) {
    refuse(group, finding, What::group_ignored, Reaction::none, ErrorReport::none, clause, outcome);
  };
  switch (open.judgement.verdict) {
    case Verdict::found:
      group.announced = true;
      return judge_announced(group, *open.judgement.link, found, outcome);
    case Verdict::repositioning:
      return judge_repositioning(linking, group, open, *open.judgement.link, found, situation, outcome);
    case Verdict::outside_window:
      group.announced = true;
      return ignore(Finding::outside_window, "3.16.2.3.1.1"_srs);
    case Verdict::not_announced:
      return ignore(Finding::not_announced, "3.16.2.4.3"_srs);
    case Verdict::unjudged:
    case Verdict::unlinked:
    case Verdict::not_used:
      judge_by_itself(group, open, found, situation, outcome);
      return use_stored_link(group, open.judgement.link);
  }
}

}  // namespace

bool announced_since(const LinkingState& linking, const OpenGroup& open) {
  const Judgement::Verdict verdict = open.judgement.verdict;
  const bool passed_by = verdict == Judgement::Verdict::not_used || verdict == Judgement::Verdict::not_announced;
  return passed_by && announced(linking, open.id);
}

void judge_message(LinkingState& linking, OpenGroup& open, const Situation& situation, Outcome& outcome) {
  using Verdict = Judgement::Verdict;
  const Examined found = examine(open, situation.srs);
  Group* out = outcome.groups.grow();
  EVC_REQUIRE(out != nullptr);
  Group& group = *out;
  describe(group, open, location_reference(open));
  complete_judgement(linking, open, situation, outcome);
  const Verdict verdict = open.judgement.verdict;
  group.linking_used = verdict != Verdict::not_used && verdict != Verdict::unlinked;
  orient(group, open, found, situation);
  decide(linking, group, open, found, situation, outcome);
  if (situation.linking_checked) look_for_second_repositioning(linking, group, open, outcome);
  finish(group, open);
  if (group.accepted && !group.announced)
    note(outcome, {What::group_accepted, group.id, Finding::none, Reaction::none, ErrorReport::none, "3.4.4.4.1"_srs});
}

}  // namespace evc::balise
