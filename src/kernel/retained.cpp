#include "kernel/cab.h"
#include "kernel/clock.h"
#include "kernel/evc.h"
#include "kernel/here.h"
#include "kernel/radio_address.h"
#include "kernel/state.h"
#include "modes/stored_information.h"

// What is kept without power (3.15.9.5, 3.17.2.9, 3.18.2.7, 4.10) as a value.
namespace evc::kernel {
namespace {

constexpr bool between(double v, double least, double most) { return v >= least && v <= most; }  // false for NaN
constexpr bool is_direction(std::uint8_t code) { return code <= static_cast<std::uint8_t>(Direction::unknown); }

bool plausible(const Retained::Position& p) {
  constexpr double kFarthest = Retained::kFarthest.si;
  return is_direction(p.orientation) && is_direction(p.pair_orientation) &&
         between(p.ahead.si, -kFarthest, kFarthest) && between(p.Q_LOCACC.si, 0.0, kFarthest) &&
         between(p.over.si, p.Q_LOCACC.si, kFarthest) && between(p.under.si, p.Q_LOCACC.si, kFarthest);
}
bool plausible(const Retained::StoredLevel& level) { return static_cast<std::size_t>(level.level) < kLevels; }

bool plausible(const Retained::LevelOrder& order) {
  for (const Retained::StoredLevel& level : order.table)
    if (!plausible(level)) return false;
  return !order.table.empty();
}

bool plausible(const Retained& r, SrsVersion srs) {
  for (const Retained::Cover& cover : r.covers)
    if (!between(cover.left.si, 0.0, Retained::kLongestCover.si) || (cover.utc && !is_date(*cover.utc))) return false;
  for (const Retained::StoredLevel& level : r.level_table)
    if (!plausible(level)) return false;
  if (r.level_order && !plausible(*r.level_order)) return false;
  return train::check(r.national_values) == train::Fault::none && between(r.operated_X, 1.0, highest_X(srs)) &&
         (!r.network || *r.network < port::kDefaultNetwork) && (!r.level || plausible(*r.level)) &&
         (!r.position || plausible(*r.position));
}

std::optional<NidLrbg> identity_of(const std::optional<GroupId>& id) {
  if (!id) return std::nullopt;
  return NidLrbg{id->NID_C, id->NID_BG};
}
std::optional<GroupId> group_of(const std::optional<NidLrbg>& id) {
  if (!id) return std::nullopt;
  return GroupId{id->NID_C, id->NID_BG};
}

Retained::Position position_of(const position::Kept& kept) {
  Retained::Position p;
  p.lrbg = {kept.lrbg.id.NID_C, kept.lrbg.id.NID_BG};
  p.orientation = static_cast<std::uint8_t>(kept.lrbg.orientation);
  p.single = kept.lrbg.single;
  p.previous = identity_of(kept.lrbg.previous);
  p.pair_orientation = static_cast<std::uint8_t>(kept.lrbg.pair_orientation);
  p.counter_rising = kept.lrbg.counter_rising;
  p.ahead = kept.ahead;
  p.over = kept.doubts.over;
  p.under = kept.doubts.under;
  p.Q_LOCACC = kept.lrbg.Q_LOCACC;
  return p;
}
position::Kept kept_of(const Retained::Position& p) {
  position::Kept kept;
  kept.lrbg.id = {p.lrbg.NID_C, p.lrbg.NID_BG};
  kept.lrbg.orientation = static_cast<Direction>(p.orientation);
  kept.lrbg.single = p.single;
  kept.lrbg.previous = group_of(p.previous);
  kept.lrbg.pair_orientation = static_cast<Direction>(p.pair_orientation);
  kept.lrbg.counter_rising = p.counter_rising;
  kept.lrbg.Q_LOCACC = p.Q_LOCACC;
  kept.ahead = p.ahead;
  kept.doubts = {p.over, p.under};
  return kept;
}

/// In 4.0.0 the level 3 of a table is what trackside ordered (6.6.3.4.5 [1b]), or was kept by a unit of an older
/// edition.
modes::OrderedLevel level_of(const State& s, const Retained::StoredLevel& kept) {
  modes::OrderedLevel to;
  to.level = modes::level_in(s.srs, kept.level);
  to.nid_ntc = kept.nid_ntc;
  to.ordered_as_level_3 = to.level != kept.level;
  return to;
}
Retained::StoredLevel kept_of(const modes::OrderedLevel& l) {
  return {l.ordered_as_level_3 ? Level::L3 : l.level, l.nid_ntc};
}

/// 4.10, column NP of 4.0.0: the order that waits is unchanged.
std::optional<Retained::LevelOrder> order_kept(const State& s) {
  const procedures::level_transition::State& transition = s.level_transition;
  if (!transition.kept || modes::kept_level_order_on_entry(Mode::NP, s.mode, s.srs) == modes::Fate::deleted)
    return std::nullopt;
  Retained::LevelOrder order;
  order.conditional = transition.kept_order.kind == modes::OrderKind::conditional;
  for (const modes::OrderedLevel& l : transition.kept_order.table) (void)order.table.push_back(kept_of(l));  // as many
  return order;
}
/// It is judged when No Power is left (4.11.1.4).
void restore(State& s, const Retained::LevelOrder& order) {
  if (modes::kept_level_order_on_entry(Mode::NP, Mode::SB, s.srs) == modes::Fate::deleted) return;
  procedures::level_transition::State& transition = s.level_transition;
  transition.kept = transition.kept_without_power = true;
  transition.kept_order = {};
  transition.kept_order.kind = order.conditional ? modes::OrderKind::conditional : modes::OrderKind::immediate;
  for (const Retained::StoredLevel& l : order.table)
    (void)transition.kept_order.table.push_back(level_of(s, l));  // as many
}

/// Position, level, its table and RBC contact: invalid until the mode NP is left (4.10, 4.11).
void restore_to_be_revalidated(State& s, const Retained& r) {
  if (r.level) {
    const Level level = modes::level_in(s.srs, r.level->level);
    if (s.fitted_levels[static_cast<std::size_t>(level)]) {
      s.level = {.level = level, .nid_ntc = r.level->nid_ntc};
      s.data.level_status = DataStatus::invalid;
    }
  }
  if (!r.level_table.empty()) {
    s.level_table.emplace();
    for (const Retained::StoredLevel& l : r.level_table) (void)s.level_table->push_back(level_of(s, l));  // as many
  }
  if (r.level_order) restore(s, *r.level_order);
  s.radio.contact.reset();
  s.contact_status = DataStatus::unknown;
  if (r.contact) {
    s.radio.contact = radio::Rbc{r.contact->NID_C, r.contact->NID_RBC, r.contact->NID_RADIO};
    s.contact_status = DataStatus::invalid;
  }
  if (!r.position) return;
  position::restore(s.position, kept_of(*r.position));
  if (r.position->cab_B) see_from_other_cab(s, Cab::B);
}

/// Where the engine is, seen from its cab: without power there are no vehicles in front of it, and no manoeuvre against
/// its orientation (3.6.1.3.4, 3.6.1.5.1 of 4.0.0).
position::State position_of_engine(const State& s) {
  position::State position = s.position;
  if (s.manoeuvre.opposite) position::turn(position);
  position.ahead = {};
  return position;
}

}  // namespace

Retained retained(const State& s) noexcept {
  Retained r;
  r.national_values = s.national_values;
  r.national_areas = s.national_areas;
  r.national_areas_of_X_2 = s.national_areas_of_X_2;
  r.national_areas_of_braking = s.national_areas_of_braking;
  r.operated_X = s.operated_X;
  r.generic_ls_marker = s.track.generic_ls_marker;
  for (const balise::Cover& cover : s.balise.covers)
    if (cover.until >= s.now)
      (void)r.covers.push_back({cover.NID_C, cover.NID_VBCMK, cover.until - s.now, cover.T_VBC, date_of(s, cover)});
  r.network = s.network.NID_MN;
  if (s.data.level_status != DataStatus::unknown) r.level = Retained::StoredLevel{s.level.level, s.level.nid_ntc};
  if (s.level_table)
    for (const modes::OrderedLevel& l : *s.level_table) (void)r.level_table.push_back(kept_of(l));
  r.level_order = order_kept(s);
  if (s.radio.contact) r.contact = address_of(*s.radio.contact);
  if (const auto position = position::kept(position_of_engine(s), s.L_engine)) {
    r.position = position_of(*position);
    r.position->cab_B = s.cab == Cab::B;
  }
  return r;
}

bool power_up(State& s, Derived& derived, const Config& config, const Retained& r) noexcept {
  power_up(s, derived, config);
  if (!plausible(r, s.srs)) return false;
  s.national_values = r.national_values;
  s.national_areas = r.national_areas;
  s.national_areas_of_X_2 = r.national_areas_of_X_2;
  s.national_areas_of_braking = r.national_areas_of_braking;
  s.operated_X = r.operated_X;
  s.track.generic_ls_marker = r.generic_ls_marker;
  for (const Retained::Cover& cover : r.covers)
    (void)s.balise.covers.push_back(
        {cover.NID_VBCMK, cover.NID_C, cover.left, cover.T_VBC, cover.utc});  // as many; from time 0 on
  s.network.NID_MN = r.network;
  restore_to_be_revalidated(s, r);
  return true;
}

}  // namespace evc::kernel
