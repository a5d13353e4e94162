#include "explain/journal.h"

#include <fmt/format.h>

#include "brakes/brakes.h"
#include "explain/origins.h"
#include "explain/words.h"
#include "lang/message_table.h"
#include "lang/telegram.h"
#include "terms/packet_numbers.h"

namespace evc::explain {
namespace {

Moment moment_of(const sim::CycleInputs& cycle, const kernel::State& before, const kernel::State& after,
                 const kernel::Derived& derived, const kernel::Examined& seen, const kernel::Outputs& outputs) {
  return {cycle.t_ms,
          before,
          seen.deciding,
          after,
          derived.in_force,
          seen.facts,
          outputs,
          cycle.levels.odometry,
          cycle.levels.train,
          cycle.levels.safety_fault};
}

/// The events of a message come before the event of the message itself, those of a group behind it.
bool names_group(What what) { return what == What::group_accepted || what == What::loop_accepted; }
bool names_message(What what) {
  return what == What::message_accepted || what == What::message_buffered || what == What::message_refused ||
         what == What::message_refused_no_room;
}

/// Whether the event is of what a telegram or message says. The others of the same cycle are of the train, the driver
/// or the time, or name their group or message themselves.
bool of_track(What what) {
  switch (what) {
    case What::packet_accepted:
    case What::packet_buffered:
    case What::packet_refused:
    case What::packet_refused_no_room:
    case What::packet_kept:
    case What::packet_contact_stored:
    case What::packet_not_used:
    case What::packet_other_direction:
    case What::packet_superseded:
    case What::packet_no_room:
    case What::packet_shortened:
    case What::infill_refused:
    case What::buffer_full:
    case What::linking_capacity:
    case What::authority_accepted:
    case What::authority_refused:
    case What::shortening_granted:
    case What::shortening_rejected:
    case What::trip_ordered:
    case What::track_description_ended:
    case What::emergency_stop_accepted:
    case What::emergency_stop_place_passed:
    case What::emergency_stop_other_direction:
    case What::emergency_stop_unconditional:
    case What::emergency_stop_revoked:
    case What::session_ordered:
    case What::session_termination_ordered:
      return true;
    default:
      return false;
  }
}

std::string group_of(const sim::CycleInputs& cycle, const kernel::Outputs& outputs, std::int32_t NID_BG) {
  for (const auto& t : cycle.balises) {
    const lang::TelegramView view = lang::scan_telegram(t.bits.bytes, t.bits.size);
    if (view.fault == lang::Fault::none && static_cast<std::int32_t>(view.NID_BG.raw) == NID_BG)
      return fmt::format("group {}/{}", view.NID_C.raw, NID_BG);
  }
  if (outputs.lrbg && outputs.lrbg->NID_BG == NID_BG) return fmt::format("group {}/{}", outputs.lrbg->NID_C, NID_BG);
  return fmt::format("group {}", NID_BG);
}

std::string source_of(const sim::CycleInputs& cycle, const kernel::Outputs& outputs, const port::Event& e) {
  if (e.what == What::group_accepted) return group_of(cycle, outputs, e.id);
  if (e.what == What::loop_accepted) return fmt::format("loop {}", e.id);
  return message_words(static_cast<std::uint8_t>(e.id));
}

/// Which balise of a group was not decoded in this cycle, why, and where in its telegram; nothing without its header.
std::string undecoded_words(const sim::CycleInputs& cycle, std::int32_t NID_BG) {
  for (const auto& t : cycle.balises) {
    const lang::TelegramView view = lang::scan_telegram(t.bits.bytes, t.bits.size);
    if (view.at.packet < 0 || static_cast<std::int32_t>(view.NID_BG.raw) != NID_BG) continue;
    return fmt::format("balise {} of {} was not decoded: {} (packet {}, bit {})", view.N_PIG.raw + 1,
                       view.N_TOTAL.raw + 1, lang::text_of(view.at.fault), view.at.packet, view.at.bit);
  }
  return "";
}

/// The number of a packet in X = 2: X = 1 has some of them under another one (6.5.1.5).
std::int32_t number_in_X_2(std::int32_t NID_PACKET) {
  switch (NID_PACKET) {
    case packet::national_values_v1:
      return packet::national_values;
    case packet::track_condition_v1:
      return packet::track_condition;
    case packet::route_suitability_v1:
      return packet::route_suitability;
    default:
      return NID_PACKET;
  }
}

/// The service brake of this command fails, and did not before.
bool fails(Cause cause, const Braking& braking, const kernel::State& after) {
  return brakes::row(cause).kind == brakes::Kind::service_brake && !braking.until && !braking.failed &&
         after.brakes.service_brake.failed;
}
/// The EBI limit is exceeded too, after an emergency brake in place of the service brake.
bool passes_EBI(Cause cause, const Braking& braking, const kernel::State& after) {
  return cause == Cause::overspeed_emergency && !braking.until && !braking.beyond_EBI && after.supervision.eb &&
         !braking.onset->after.supervision.eb;
}

}  // namespace

void Journal::take_notes(const sim::CycleInputs& cycle, const kernel::Outputs& outputs) {
  std::size_t open = notes_.size();  // the first one that a message may claim
  std::string group;
  for (const port::Event& e : outputs.events) {
    if (names_group(e.what)) group = source_of(cycle, outputs, e);
    notes_.push_back(
        {cycle.t_ms, e, of_track(e.what) || e.what == What::group_accepted ? group : "", "", "", "", false});
    if (e.what == What::packet_accepted) packets_[number_in_X_2(e.id)] = notes_.size() - 1;
    if (e.what == What::telegram_not_decoded) notes_.back().detail = undecoded_words(cycle, e.id);
    if (e.what == What::group_inconsistent) notes_.back().detail = error_words(e.id);
    if (names_group(e.what)) open = notes_.size();
    if (!names_message(e.what)) continue;
    const std::string message = source_of(cycle, outputs, e);
    for (std::size_t i = open; i < notes_.size(); ++i)
      if (notes_[i].source.empty() && of_track(notes_[i].event.what)) notes_[i].source = message;
    open = notes_.size();
    group.clear();
  }
}

/// Which balise of a group was not read or not decoded (3.16.2.4.1); nothing if its telegrams were used and differ.
std::string Journal::error_words(std::int32_t NID_BG) const {
  const auto found = groups_read_.find(NID_BG);
  if (found == groups_read_.end()) return "";
  constexpr std::int64_t kBefore = 10000;  // one that was not decoded may be the first: its group is not known then
  const GroupRead& group = found->second;
  bool undecoded = false;
  for (std::size_t i = notes_.size(); i-- > 0 && notes_[i].t_ms >= group.began_ms - kBefore;) {
    const port::Event& e = notes_[i].event;
    if (e.what != What::telegram_not_decoded || (e.id != NID_BG && e.id > 0)) continue;
    if (!notes_[i].detail.empty()) return notes_[i].detail;
    undecoded = true;
  }
  const char* const error = undecoded ? "was not decoded" : "was not read";
  for (unsigned n = 0; n < group.total; ++n)
    if ((group.read >> n & 1u) == 0) return fmt::format("balise {} of {} {}", n + 1, group.total, error);
  return undecoded ? "a telegram of it is not as specified (3.16.1.1)" : "";
}

void Journal::take_groups(const sim::CycleInputs& cycle) {
  constexpr std::int64_t kApart = 60000;  // one passage of a group is shorter
  for (const auto& t : cycle.balises) {
    const lang::TelegramView view = lang::scan_telegram(t.bits.bytes, t.bits.size);
    if (view.fault != lang::Fault::none) continue;
    GroupRead& group = groups_read_[static_cast<std::int32_t>(view.NID_BG.raw)];
    if (group.total == 0 || cycle.t_ms - group.t_ms > kApart) group = {cycle.t_ms, 0, 0, cycle.t_ms};
    group.t_ms = cycle.t_ms;
    group.total = static_cast<unsigned>(view.N_TOTAL.raw) + 1;
    group.read |= 1u << view.N_PIG.raw;
  }
}

void Journal::take_links(const kernel::State& s) {
  const Note* note = notes_.empty() ? nullptr : last(What::packet_accepted, notes_.back().t_ms, packet::linking);
  if (note == nullptr || note->t_ms != notes_.back().t_ms) return;
  for (const balise::Link& link : s.balise.linking.links)
    announced_[link.id.NID_BG] = {*note, link, place_words(s, link.place)};
}

void Journal::take_end(const kernel::State& before, const kernel::State& after) {
  if (notes_.empty() || before.basis.number == after.basis.number) return;
  const track::Authority &was = before.basis.authority, &is = after.basis.authority;
  if (was == is) return;
  const std::int64_t t_ms = notes_.back().t_ms;
  const auto behind = [](const track::Authority& a) { return a.SvL ? a.SvL : a.EOA_or_LOA(); };
  for (std::size_t i = notes_.size(); i-- > 0 && notes_[i].t_ms == t_ms;) {
    notes_[i].ended = end_words(was, after.position);
    notes_[i].became = end_words(is, after.position);
    notes_[i].nearer =
        was.EOA_or_LOA() && is.EOA_or_LOA() && (*is.EOA_or_LOA() < *was.EOA_or_LOA() || *behind(is) < *behind(was));
  }
}

void Journal::take_contact(const sim::CycleInputs& cycle, const radio::Session& before, const radio::Session& after) {
  if (!after.last_T_TRAIN || after.last_T_TRAIN == before.last_T_TRAIN) return;
  for (const sim::CycleInputs::RadioMessage& message : cycle.radio) {
    const auto head = lang::head_of_message_to_train(message.bytes);
    if (message.infill_unit || !head || head->T_TRAIN != *after.last_T_TRAIN) continue;
    if (message.from && message.from->NID_RBC != after.rbc.NID_RBC) continue;
    contacts_[{after.rbc.NID_C, after.rbc.NID_RBC}] = {cycle.t_ms, message.bytes[0]};
  }
}

void Journal::take_track(const track::Description& now) {
  const auto last = [&](std::int32_t number) {
    const auto found = packets_.find(number);
    return found == packets_.end() ? std::nullopt : std::optional(found->second);
  };
  brought_.ssp.take(now.ssp.steps, last(packet::static_speed_profile));
  brought_.asp.take(now.asp, last(packet::axle_load_speed_profile));
  brought_.tsr.take(now.tsr, last(packet::temporary_speed_restriction));
  brought_.pbd.take(now.pbd, last(packet::permitted_braking_distance));
  brought_.lx.take(now.lx, last(packet::level_crossing));
  brought_.areas.take(now.mode_profile, last(packet::mode_profile));
  brought_.suitability.take(now.suitability, last(packet::route_suitability));
  brought_.adhesion.take(now.adhesion, last(packet::adhesion_factor));
  brought_.conditions.take(now.conditions, last(packet::track_condition));
}

void Journal::take_radio_hole(std::int64_t t_ms, const kernel::State& before, const kernel::State& after) {
  if (!before.radio.was_in_hole && after.radio.was_in_hole) in_radio_hole_since_ = t_ms;
  if (!before.radio.was_in_hole || after.radio.was_in_hole) return;
  radio_hole_ = RadioHole{in_radio_hole_since_, t_ms, {}, "", {}};
  // Of several the farthest one that the train has entered.
  for (const track::TrackCondition& c : before.track.conditions)
    if (c.kind == TrackConditionKind::radio_hole && c.progress.phase == ConditionPhase::active) {
      radio_hole_->packet = brought_.conditions.of(c);
      radio_hole_->place = fmt::format("from {} to {}", place_words(before, c.from), place_words(before, c.to));
    }
  if (const Contact* last = last_of(after.radio.supervising.session.rbc)) radio_hole_->last = *last;
}

void Journal::take_values(std::int64_t t_ms, const kernel::State& before, const kernel::State& after) {
  if (before.national_values == after.national_values || notes_.empty() || notes_.back().t_ms != t_ms) return;
  replaced_values_ = ReplacedValues{t_ms, before.national_values};
}

void Journal::take_texts(const kernel::State& before, const kernel::State& after) {
  for (const track::Text& text : after.track.texts) {
    bool known = false;
    for (const track::Text& old : before.track.texts) known = known || old.id == text.id;
    if (known) continue;
    if (const Note* note = last(What::packet_accepted, notes_.empty() ? 0 : notes_.back().t_ms,
                                text.Q_TEXT ? std::int32_t{packet::fixed_text} : std::int32_t{packet::plain_text}))
      texts_[text.id] = *note;
  }
}

bool Journal::brakes_change(const kernel::State& after, const kernel::Outputs& outputs) const {
  if (outputs.brake_reasons != braked_) return true;
  for (const auto& [cause, braking] : brakings_)
    if (fails(cause, braking, after) || passes_EBI(cause, braking, after)) return true;
  return false;
}

void Journal::take_brakes(const Moment& moment) {
  const Set<Cause> now = moment.outputs.brake_reasons;
  for (std::size_t i = 0; i < terms::index(Cause::count); ++i) {
    const Cause cause = static_cast<Cause>(i);
    if (now.has(cause) && !braked_.has(cause)) brakings_[cause] = {std::make_unique<Moment>(moment), {}, {}, {}};
    if (!now.has(cause) && braked_.has(cause)) brakings_[cause].until = moment.t_ms;
  }
  for (auto& [cause, braking] : brakings_) {
    if (fails(cause, braking, moment.after)) braking.failed = moment.t_ms;
    if (passes_EBI(cause, braking, moment.after)) braking.beyond_EBI = std::make_unique<Moment>(moment);
  }
  braked_ = now;
}

void Journal::take(const sim::CycleInputs& cycle, const kernel::State& before, const kernel::State& after,
                   const kernel::Derived& derived, const kernel::Examined& seen, const kernel::Outputs& outputs) {
  if (first_) starts_with_defaults_ = before.national_values == train::NationalValues{};
  take_driver(cycle, outputs);
  take_acts(cycle);
  take_groups(cycle);
  take_notes(cycle, outputs);
  if (!outputs.events.empty()) {
    take_links(seen.deciding);
    // What the supervision changes counts too (5.16.2), the mode that was entered not.
    take_end(before, before.mode == after.mode ? after : seen.deciding);
  }
  take_contact(cycle, before.radio.supervising.session, after.radio.supervising.session);
  take_contact(cycle, before.radio.other.session, after.radio.other.session);
  take_radio_hole(cycle.t_ms, before, after);
  if (!outputs.events.empty() || before.track.revision != after.track.revision) take_track(after.track);
  if (!outputs.events.empty()) take_values(cycle.t_ms, before, after);
  take_texts(before, after);
  const bool entered = before.mode != after.mode;
  if (!entered && !brakes_change(after, outputs)) return;
  const Moment moment = moment_of(cycle, before, after, derived, seen, outputs);
  if (entered) entry_ = std::make_unique<Moment>(moment);
  take_brakes(moment);
}

void Journal::stop_here(const sim::CycleInputs& cycle, const kernel::State& before, const kernel::State& after,
                        const kernel::Derived& derived, const kernel::Examined& seen, const kernel::Outputs& outputs) {
  now_ = std::make_unique<Moment>(moment_of(cycle, before, after, derived, seen, outputs));
}

const Note* Journal::last(What what, std::int64_t t_ms, std::optional<std::int32_t> id) const {
  for (std::size_t i = notes_.size(); i-- > 0;)
    if (notes_[i].t_ms <= t_ms && notes_[i].event.what == what && (!id || notes_[i].event.id == *id)) return &notes_[i];
  return nullptr;
}

const Act* Journal::last(Act::Kind kind, std::int64_t t_ms, std::optional<std::uint8_t> about) const {
  for (std::size_t i = acts_.size(); i-- > 0;)
    if (acts_[i].t_ms <= t_ms && acts_[i].kind == kind && (!about || acts_[i].about == *about)) return &acts_[i];
  return nullptr;
}

const Note* Journal::last_packet(std::int32_t NID_PACKET) const {
  const auto found = packets_.find(NID_PACKET);
  return found == packets_.end() ? nullptr : &notes_[found->second];
}

const Note* Journal::of_text(std::uint8_t id) const {
  const auto found = texts_.find(id);
  return found == texts_.end() ? nullptr : &found->second;
}

const Announced* Journal::announced(std::int32_t NID_BG) const {
  const auto found = announced_.find(NID_BG);
  return found == announced_.end() ? nullptr : &found->second;
}

const Contact* Journal::last_of(const radio::Rbc& rbc) const {
  const auto found = contacts_.find({rbc.NID_C, rbc.NID_RBC});
  return found == contacts_.end() ? nullptr : &found->second;
}

}  // namespace evc::explain
