#include "balise/linking.h"

namespace evc::balise {
namespace {

std::optional<std::size_t> index_of(const LinkingState& linking, GroupId id) {
  if (id.NID_BG == kIdentityUnknown) return std::nullopt;  // says nothing of a group
  for (std::size_t i = 0; i < linking.links.size(); ++i)
    if (linking.links[i].id == id) return i;
  return std::nullopt;
}

/// The expectation moves on to the next entry (3.4.4.4.6).
Link move_on(LinkingState& linking) {
  const Link link = linking.links.front();
  linking.links.erase(0);
  linking.previous = link.place;
  linking.detected = false;
  return link;
}

void react(Outcome& outcome, What what, const Link& link, Clause clause) {
  note(outcome, {what, link.id, Finding::none, link.reaction, ErrorReport::linking, clause});
}

Judgement found(LinkingState& linking) {
  Judgement judgement;
  judgement.verdict = Judgement::Verdict::found;
  judgement.link = move_on(linking);
  linking.found = LinkingState::Found{judgement.link->id, judgement.link->place};
  linking.missed_in_row = 0;
  linking.repositioned.reset();  // 3.16.2.7.2.1 b
  return judgement;
}

/// The expected group itself: before, in or behind its window.
Judgement judge_expected(LinkingState& linking, const PlaceInterval& antenna, Outcome& outcome) {
  const Link link = linking.links.front();
  const bool early = antenna.max < first_possible(linking, link);
  const bool late = antenna.min > last_possible(link);
  if (!early && !late) return found(linking);
  move_on(linking);
  linking.missed_in_row = 0;  // elsewhere, but detected
  if (early)
    react(outcome, What::linking_error_early, link, "3.16.2.3.1 a"_srs);
  else
    react(outcome, What::linking_error_missed, link, "3.16.2.3.1 b"_srs);
  return {Judgement::Verdict::outside_window, link};
}

/// A group announced for later, `ahead` entries after the expected one.
Judgement judge_later(LinkingState& linking, std::size_t ahead, const PlaceInterval& antenna, Outcome& outcome) {
  for (; ahead > 0; --ahead) {
    const Link& next = linking.links.front();
    // Neither a) nor c) holds while the window of the expected group is not open: no reaction.
    if (antenna.max < first_possible(linking, next)) return {Judgement::Verdict::outside_window, linking.links[ahead]};
    react(outcome, What::linking_error_later, move_on(linking), "3.16.2.3.1 c"_srs);
    linking.missed_in_row = 0;
  }
  return judge_expected(linking, antenna, outcome);  // 3.4.4.4.6.1
}

/// Linking is stored but not supervised (or no longer used): groups passed are deleted from the list, the other places
/// stay valid.
Judgement judge_unsupervised(LinkingState& linking, GroupId id) {
  Judgement judgement;
  judgement.verdict = Judgement::Verdict::not_used;
  const std::optional<std::size_t> i = index_of(linking, id);
  if (!i) return judgement;
  judgement.link = linking.links[*i];
  linking.links.erase(0, *i + 1);
  linking.previous = judgement.link->place;
  linking.found = LinkingState::Found{id, judgement.link->place};
  return judgement;
}

void miss(LinkingState& linking, Outcome& outcome) {
  const bool seen = linking.detected;
  const Link link = move_on(linking);
  react(outcome, What::linking_error_missed, link, "3.16.2.3.1 b"_srs);
  linking.missed_in_row = seen ? std::uint8_t{0} : static_cast<std::uint8_t>(linking.missed_in_row + 1);
  if (linking.missed_in_row < 2) return;
  linking.missed_in_row = 1;  // this one and a third one would be two in a row again
  note(outcome, {What::double_linking_error, link.id, Finding::none, Reaction::service_brake,
                 ErrorReport::double_linking, "3.16.2.7.1.1"_srs});
}

Place end_of(const LinkingState& linking) {
  Place end = last_possible(linking.links.front());
  for (const Link& link : linking.links)
    if (last_possible(link) > end) end = last_possible(link);
  return end;
}

}  // namespace

bool announced(const LinkingState& linking, GroupId id) { return index_of(linking, id).has_value(); }

Judgement judge(LinkingState& linking, GroupId id, bool marked_linked, const PlaceInterval& antenna,
                bool linking_checked, Outcome& outcome) {
  if (!marked_linked) return {Judgement::Verdict::unlinked, std::nullopt};
  if (!used(linking, antenna, linking_checked)) return judge_unsupervised(linking, id);
  const std::optional<std::size_t> i = index_of(linking, id);
  if (i) return *i == 0 ? judge_expected(linking, antenna, outcome) : judge_later(linking, *i, antenna, outcome);
  const Link* next = expected(linking);
  if (next == nullptr || !next->identity_unknown()) return {Judgement::Verdict::not_announced, std::nullopt};
  if (!in_window(linking, *next, antenna)) return {Judgement::Verdict::not_announced, std::nullopt};
  return {Judgement::Verdict::repositioning, *next};
}

Judgement judge_without_reference(LinkingState& linking, GroupId id, const PlaceInterval& antenna,
                                  bool linking_checked) {
  if (!used(linking, antenna, linking_checked)) return judge_unsupervised(linking, id);
  const std::optional<std::size_t> i = index_of(linking, id);
  if (i && *i > 0) return {Judgement::Verdict::outside_window, linking.links[*i]};
  if (i) {
    linking.missed_in_row = 0;  // not its reference balise, but the group was detected
    return {Judgement::Verdict::found, move_on(linking)};
  }
  const Link* next = expected(linking);
  if (next != nullptr && next->identity_unknown()) return {Judgement::Verdict::repositioning, *next};
  return {Judgement::Verdict::not_announced, std::nullopt};
}

void leave_repositioning(LinkingState& linking, const Link& link) {
  const Link* next = expected(linking);
  if (next != nullptr && *next == link) move_on(linking);
  linking.missed_in_row = 0;
}

void note_detection(LinkingState& linking, const PlaceInterval& antenna) {
  linking.missed_in_row = 0;
  const Link* next = expected(linking);
  if (next != nullptr && antenna.max >= first_possible(linking, *next)) linking.detected = true;
}

void take_repositioning(LinkingState& linking, GroupId id, const Link& link) {
  leave_repositioning(linking, link);
  linking.found = LinkingState::Found{id, link.place};
  linking.repositioned = LinkingState::Repositioned{id, last_possible(link), link.crossing};
}

bool second_repositioning(const LinkingState& linking, GroupId id, Direction crossing) {
  return linking.repositioned && !(linking.repositioned->id == id) && linking.repositioned->crossing == crossing;
}

void end_windows(LinkingState& linking, const PlaceInterval& antenna, bool linking_checked,
                 const std::optional<GroupId>& reading, Outcome& outcome) {
  if (linking.repositioned && antenna.min > linking.repositioned->end) linking.repositioned.reset();
  if (!linking_checked) {
    while (!linking.links.empty() && antenna.min > last_possible(linking.links.front())) move_on(linking);
    linking.missed_in_row = 0;
  }
  while (!linking.links.empty()) {
    const Link& next = linking.links.front();
    if (!(antenna.min > last_possible(next) + kDetectionZone)) break;
    if (reading && (next.id == *reading || next.identity_unknown())) break;
    miss(linking, outcome);
  }
  if (linking.links.empty() && linking.used_until && antenna.min > *linking.used_until) linking.used_until.reset();
}

namespace {

/// Whether the entry is the group passed at `place`, and not the same group again after a loop of track: the places may
/// differ by the error of a measured distance.
bool passed_at(const Link& link, const LinkingReference& reference, GroupId id, Place place) {
  constexpr Distance kSure{100};
  if (!(link.id == id) || link.id == reference.id) return false;
  const Distance run = place - reference.place;
  return link.place - place <= kSure + 0.1 * run;
}

/// The list in the track frame, and the part of it that is behind the train.
struct Placed {
  InplaceVector<Link, 32> links;
  std::size_t passed = 0;  // entries up to the last one that was passed
  Distance correction{};   // added to all places, so that the current LRBG keeps its place
};

/// The train has run back behind the group, whose place is exact, as that of the LRBG or by its distance from it: it
/// will pass it again.
bool lies_ahead(Place group, const PlaceInterval& antenna) { return group - antenna.est > kDetectionZone; }

/// Of the entries up to the LRBG, the last one, those that are behind the train.
std::size_t behind(const Placed& placed, const PlaceInterval& antenna) {
  std::size_t n = placed.links.size();
  while (n > 0 && lies_ahead(placed.links[n - 1].place + placed.correction, antenna)) --n;
  return n;
}

Placed place_links(const LinkingState& linking, const LinkingList& list, const LinkingReference& reference,
                   const PlaceInterval& antenna, const std::optional<CurrentLrbg>& current) {
  Placed placed;
  Place place = reference.place;
  std::uint16_t country = reference.NID_C;
  for (const LinkingList::Entry& entry : list.entries) {
    place = place + entry.D_LINK;
    if (entry.NID_C) country = *entry.NID_C;  // 7.5.1.121: else that of the entry before
    const Link link{place,
                    entry.Q_LOCACC,
                    {country, entry.NID_BG},
                    entry.reaction,
                    entry.nominal ? Direction::nominal : Direction::reverse,
                    reference.orientation_known};
    EVC_REQUIRE(placed.links.push_back(link));
    if (link.identity_unknown()) continue;
    const bool is_current = current && passed_at(link, reference, current->id, current->place);
    const bool is_found = linking.found && passed_at(link, reference, linking.found->id, linking.found->place);
    // 3.6.4.3: the list holds the reference and the LRBG, so their distance by linking is used.
    if (is_found) placed.passed = placed.links.size();
    if (!is_current) continue;
    placed.correction = current->place - link.place;
    placed.passed = behind(placed, antenna);
  }
  for (Link& link : placed.links) link.place = link.place + placed.correction;
  return placed;
}

}  // namespace

Stored store(LinkingState& linking, const LinkingList& list, const LinkingReference& reference,
             const PlaceInterval& antenna, const std::optional<CurrentLrbg>& current) {
  const Placed placed = place_links(linking, list, reference, antenna, current);
  Stored stored{reference.place + placed.correction, true};
  if (reference.infill) {  // 3.7.3.1 n: groups announced up to the infill reference are kept
    linking.links.erase_if([&](const Link& link) { return link.place > stored.reference; });
  } else {  // 3.7.3.1 m
    linking.links.clear();
    linking.used_until.reset();
    linking.previous = placed.passed > 0 ? placed.links[placed.passed - 1].place : stored.reference;
    linking.detected = false;
  }
  for (std::size_t i = placed.passed; i < placed.links.size(); ++i) {
    // Windows that have ended already are no errors (3.4.4.4.5).
    if (linking.links.empty() && antenna.min > last_possible(placed.links[i])) continue;
    if (!linking.links.push_back(placed.links[i])) stored.complete = false;
  }
  if (!linking.links.empty()) linking.used_until = end_of(linking);
  return stored;
}

void clear(LinkingState& linking) { linking = LinkingState{}; }

void clear_beyond(LinkingState& linking, Place place) {
  const std::size_t before = linking.links.size();
  linking.links.erase_if([&](const Link& link) { return link.place > place; });
  if (linking.links.size() == before) return;
  linking.used_until.reset();
  if (!linking.links.empty()) linking.used_until = end_of(linking);
}

void end_with_last_window(LinkingState& linking) {
  if (linking.links.empty()) linking.used_until.reset();
}

bool used(const LinkingState& linking, const PlaceInterval& antenna, bool linking_checked) {
  // A window counts as passed only after it was judged: the group may still be under the antenna.
  return linking_checked && (!linking.links.empty() || (linking.used_until && antenna.min <= *linking.used_until));
}

const Link* expected(const LinkingState& linking) { return linking.links.empty() ? nullptr : &linking.links.front(); }

Place first_possible(const LinkingState& linking, const Link& link) {
  // 3.4.4.4.4: a group of unknown identity may follow directly behind the last linked group.
  if (link.identity_unknown() && linking.previous) return *linking.previous;
  return link.place - link.Q_LOCACC;
}

Place last_possible(const Link& link) { return link.place + link.Q_LOCACC; }

bool in_window(const LinkingState& linking, const Link& link, const PlaceInterval& antenna) {
  return antenna.max >= first_possible(linking, link) && antenna.min <= last_possible(link);
}

std::optional<PlaceInterval> window(const LinkingState& linking, const PlaceInterval& antenna) {
  const Link* next = expected(linking);
  if (next == nullptr) return std::nullopt;
  return PlaceInterval{first_possible(linking, *next) - (antenna.max - antenna.est), next->place,
                       last_possible(*next) + (antenna.est - antenna.min)};
}

}  // namespace evc::balise
