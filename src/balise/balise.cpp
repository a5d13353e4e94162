#include "balise/balise.h"

#include "balise/message.h"
#include "balise/telegram.h"

namespace evc::balise {
namespace {

void begin(Outcome& outcome) {
  outcome.groups.clear();
  outcome.events.clear();
  outcome.reaction = Reaction::none;
  outcome.wrong_direction = false;
  outcome.version_too_high = false;
  outcome.shorten_at_standstill = false;
}

void tell(Outcome& outcome, What what, GroupId id, Clause clause) {
  note(outcome, {what, id, Finding::none, Reaction::none, ErrorReport::none, clause});
}

Distance between(const OdometerReading& a, const OdometerReading& b) {
  const Distance d = a.nominal - b.nominal;
  return d.si < 0 ? -d : d;
}

bool too_far(const OpenGroup& open, const OdometerReading& counter) {
  return between(counter, open.last) > kBaliseSpacing + kSpacingMargin;
}

bool seen(const OpenGroup& open, std::uint8_t N_PIG) { return ((open.seen >> N_PIG) & 1u) != 0; }

/// The same balise is still under the antenna (3.16.2.1.1: one telegram).
bool same_passage(const OpenGroup& open, const Header& header, const Reading& reading) {
  return open.identified && open.id == header.id && !open.telegrams.empty() &&
         open.telegrams.back().N_PIG == header.N_PIG &&
         between(reading.counter, open.telegrams.back().counter) < kSameBalise;
}

/// Does this telegram continue the open group? Another group, a balise read before, or one against the order so far
/// (the train has turned) begins a new passage.
bool continues(const OpenGroup& open, const Header& header) {
  if (!open.identified) return true;
  if (!(open.id == header.id) || seen(open, header.N_PIG)) return false;
  if (open.telegrams.size() < 2) return true;
  const bool rising = open.telegrams.back().N_PIG > open.telegrams.front().N_PIG;
  return (header.N_PIG > open.telegrams.back().N_PIG) == rising;
}

OpenGroup& opened(State& state, const Situation& situation) {
  if (!state.open) state.open.emplace().first_passed = situation.now;
  return *state.open;
}

/// All were read, or the last one in the direction of passage: those before it are missed (3.16.2.2.2 b).
bool complete(const OpenGroup& open) {
  const unsigned all = (1u << (open.N_TOTAL + 1u)) - 1u;
  if ((open.seen & all) == all) return true;
  if (open.telegrams.size() < 2) return false;
  const bool rising = open.telegrams.back().N_PIG > open.telegrams.front().N_PIG;
  return open.telegrams.back().N_PIG == (rising ? open.N_TOTAL : 0);
}

/// The train turned over the last balise of a group and turned again: with the balise read again it goes on from
/// there as after the first time, and no other balise of the group is missed (3.16.2.2.2). A telegram that is
/// inconsistent or fits another message than the first time is judged. `counter`: where the train is now.
bool read_again(const State& state, const OdometerReading& counter) {
  const OpenGroup& open = *state.open;
  if (!state.last || !open.identified || open.undecoded || open.telegrams.size() != 1) return false;
  const LastBalise& last = *state.last;
  const Telegram& telegram = open.telegrams.front();
  const bool same = last.id == open.id && last.N_PIG == telegram.N_PIG && open.seen == (1u << telegram.N_PIG) &&
                    last.M_MCOUNT == telegram.M_MCOUNT && !telegram.faulty && !open.header_mismatch &&
                    between(last.counter, telegram.counter) < kSameBalise;
  return same && (counter.nominal > last.counter.nominal) == last.counter_rose;
}

/// Linking that came while the balise read again was ahead of the train may announce its group, which is found then.
void find_again(State& state, const Situation& situation, Outcome& outcome) {
  const OpenGroup& open = *state.open;
  const Link* next = expected(state.linking);
  if (next == nullptr || !(next->id == open.id) || !announced_since(state.linking, open)) return;
  const PlaceInterval& antenna = open.telegrams.front().antenna;
  if (in_window(state.linking, *next, antenna))
    judge(state.linking, open.id, open.Q_LINK, antenna, situation.linking_checked, outcome);
}

/// Finishes the open group when the counter is at `counter`. A group of which only telegrams of too new a version were
/// read is not evaluated.
void close(State& state, const OdometerReading& counter, const Situation& situation, Outcome& outcome) {
  const OpenGroup& open = *state.open;
  const bool empty = open.identified && open.telegrams.empty() && !open.undecoded;
  if (!empty && read_again(state, counter))
    find_again(state, situation, outcome);
  else if (!empty)
    judge_message(state.linking, *state.open, situation, outcome);
  if (open.identified && open.telegrams.size() > 1 && complete(open)) {
    const Telegram& last = open.telegrams.back();
    state.last = LastBalise{open.id, last.N_PIG, last.M_MCOUNT, last.counter,
                            last.counter.nominal > open.telegrams.front().counter.nominal};
  }
  state.open.reset();
}

/// The group to which the telegram belongs; closes a different open group first.
OpenGroup& group_of(State& state, const Header& header, const Reading& reading, const Situation& situation,
                    Outcome& outcome) {
  if (state.open && (!continues(*state.open, header) || too_far(*state.open, reading.counter)))
    close(state, reading.counter, situation, outcome);
  OpenGroup& open = opened(state, situation);
  if (!open.identified) {
    open.identified = true;
    open.id = header.id;
    open.N_TOTAL = header.N_TOTAL;
    open.Q_LINK = header.Q_LINK;
  }
  // The identity is equal; the other common values of the group must be equal too (3.16.1.1).
  if (open.N_TOTAL != header.N_TOTAL || open.Q_LINK != header.Q_LINK) open.header_mismatch = true;
  open.seen = static_cast<std::uint8_t>(open.seen | (1u << header.N_PIG));
  open.last = reading.counter;
  open.last_antenna = reading.antenna;
  return open;
}

bool covered(const State& state, const Header& header, Duration now) {
  for (const Cover& cover : state.covers)
    if (header.NID_VBCMK && cover.NID_VBCMK == *header.NID_VBCMK && cover.NID_C == header.id.NID_C &&
        now <= cover.until)
      return true;
  return false;
}

/// The checks of a single telegram, in the order of A.3.3; true: no part of the telegram is used.
bool dropped(State& state, const Header& header, const Reading& reading, const Situation& situation, Outcome& outcome) {
  if (header.X() == 0) {
    tell(outcome, What::telegram_version_old, header.id, "3.17.3.5 a"_srs);
    return true;
  }
  if (covered(state, header, situation.now)) {
    tell(outcome, What::telegram_covered, header.id, "3.15.9.3"_srs);
    return true;
  }
  if (situation.against_permitted_movement) {
    tell(outcome, What::telegram_against_movement, header.id, "3.14.3.6"_srs);
    return true;
  }
  if (header.X() <= situation.highest_X) return false;
  // Ignored, but not missed: its balise was detected.
  OpenGroup& open = group_of(state, header, reading, situation, outcome);
  if (header.N_PIG == 0) open.ignored_reference = OpenGroup::Encounter{reading.counter, reading.antenna};
  tell(outcome, What::telegram_version_new, header.id, situation.level_1_2_3 ? "3.17.3.5 d"_srs : "3.17.3.5 e"_srs);
  if (situation.level_1_2_3) outcome.version_too_high = true;
  if (complete(*state.open)) close(state, reading.counter, situation, outcome);
  return true;
}

void note_undecodable(State& state, const Reading& reading, const Situation& situation, Outcome& outcome) {
  if (situation.against_permitted_movement) return;  // 3.14.3.6
  if (state.open && too_far(*state.open, reading.counter)) close(state, reading.counter, situation, outcome);
  OpenGroup& open = opened(state, situation);
  tell(outcome, What::telegram_not_decoded, open.id, "3.16.1.1"_srs);
  open.undecoded = true;
  open.last = reading.counter;
  open.last_antenna = reading.antenna;
}

}  // namespace

void read(State& state, const Reading& reading, const Situation& situation, Outcome& outcome) {
  begin(outcome);
  const Header header = read_header(reading.bytes, reading.bits);
  // A covered balise counts as not received (3.15.9.3).
  if (situation.srs == SrsVersion::v4_0_0 && !(header.readable && covered(state, header, situation.now)))
    note_detection(state.linking, reading.antenna);
  if (!header.readable) return note_undecodable(state, reading, situation, outcome);
  if (dropped(state, header, reading, situation, outcome)) return;
  if (state.open && same_passage(*state.open, header, reading)) return;

  OpenGroup& open = group_of(state, header, reading, situation, outcome);
  if (situation.srs == SrsVersion::v4_0_0) end_with_last_window(state.linking);
  Telegram* telegram = open.telegrams.grow();
  EVC_REQUIRE(telegram != nullptr);  // at most one for each N_PIG
  look_into(*telegram, reading.bytes, reading.bits, header, situation.srs);
  telegram->counter = reading.counter;
  telegram->antenna = reading.antenna;
  if (telegram->faulty) tell(outcome, What::telegram_not_decoded, header.id, "3.16.1.1"_srs);

  const Link* next = expected(state.linking);
  if (next != nullptr && next->id == header.id) state.linking.detected = true;
  if (header.N_PIG == 0)
    open.judgement =
        judge(state.linking, header.id, header.Q_LINK, reading.antenna, situation.linking_checked, outcome);
  if (complete(open)) close(state, reading.counter, situation, outcome);
}

void close_overdue(State& state, const OdometerReading& counter, const Situation& situation, Outcome& outcome) {
  begin(outcome);
  if (state.open && too_far(*state.open, counter)) close(state, counter, situation, outcome);
}

void expect(State& state, const PlaceInterval& antenna, const Situation& situation, Outcome& outcome) {
  begin(outcome);
  state.covers.erase_if([&](const Cover& c) { return c.until < situation.now; });  // 3.15.9.5 a
  std::optional<GroupId> reading;
  if (state.open && state.open->identified) {
    const Judgement::Verdict verdict = state.open->judgement.verdict;
    if (verdict == Judgement::Verdict::unjudged || verdict == Judgement::Verdict::repositioning ||
        announced_since(state.linking, *state.open))
      reading = state.open->id;
  }
  end_windows(state.linking, antenna, situation.linking_checked, reading, outcome);
  if (situation.srs == SrsVersion::v4_0_0) end_with_last_window(state.linking);
}

void abandon(State& state) {
  state.open.reset();
  state.last.reset();
}

bool set_cover(State& state, const Cover& cover) {
  remove_cover(state, cover.NID_VBCMK, cover.NID_C);
  return state.covers.push_back(cover);
}

void remove_cover(State& state, std::uint8_t NID_VBCMK, std::uint16_t NID_C) {
  state.covers.erase_if([&](const Cover& c) { return c.NID_VBCMK == NID_VBCMK && c.NID_C == NID_C; });
}

void keep_covers_of(State& state, std::uint16_t NID_C) {
  state.covers.erase_if([&](const Cover& c) { return c.NID_C != NID_C; });
}

}  // namespace evc::balise
