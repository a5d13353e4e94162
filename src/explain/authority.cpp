#include <fmt/format.h>

#include <algorithm>

#include "explain/brake.h"
#include "explain/words.h"
#include "kernel/here.h"
#include "kernel/train_category.h"
#include "terms/packet_numbers.h"

// The authority of a moment, and what changed it.
namespace evc::explain {
namespace {

std::string release_speed(const track::Release& release) {
  switch (release.kind) {
    case ReleaseSpeedChoice::value:
      return ", release speed " + kmh_words(release.V);
    case ReleaseSpeedChoice::on_board:
      return ", release speed calculated on board";
    case ReleaseSpeedChoice::national:
      return ", release speed V_NVREL";
    default:
      return "";
  }
}

/// The end of the stored authority itself, without what replaces it (3.12).
track::Authority own_end(const kernel::State& s) {
  return s.track.ma ? track::authority(*s.track.ma, {}, s.mode, s.srs) : track::Authority{};
}

/// What makes an end or a supervised location in rear of that of the authority, and the packet that brought it (3.12).
struct Temporary {
  std::string what;
  const char* clause = "";
  const Note* packet = nullptr;
};

/// The one that begins at a place. `SvL`: as a supervised location.
std::optional<Temporary> temporary_at(const Journal& journal, const kernel::State& s, Place at, bool SvL) {
  for (const track::LevelCrossing& lx : s.track.lx)
    if (lx.from == at && lx.unprotected && !lx.substituted)
      return Temporary{fmt::format("level crossing {} is not protected", lx.NID_LX), "3.12.5.8",
                       journal.note(journal.brought().lx.of(lx))};
  for (const track::RouteSuitability& item : s.track.suitability)
    if (item.at == at && track::unsuitable(item, kernel::interfaces_of(s.train))) {
      const char* const what = item.kind == Suitability::gauge       ? "its loading gauge"
                               : item.kind == Suitability::axle_load ? "its axle load"
                                                                     : "its traction system";
      return Temporary{fmt::format("the route does not suit the train by {}", what), "3.12.2.4",
                       journal.note(journal.brought().suitability.of(item))};
    }
  for (const track::ModeArea& area : s.track.mode_profile)
    if (area.from == at && !area.accepted && area.mode != s.mode && (area.also_SvL || !SvL))
      // The profile is replaced with the authority that it belongs to (3.12.4.3): the last one.
      return Temporary{fmt::format("an area of {} begins", name(area.mode)), "3.12.4.7",
                       journal.last_packet(packet::mode_profile)};
  return std::nullopt;
}

bool is_repositioning(const port::Event& e) {
  return e.what == What::packet_accepted && e.id == packet::repositioning_information;
}

bool changes_authority(const port::Event& e) {
  switch (e.what) {
    case What::authority_timer_elapsed:
    case What::shortening_granted:
    case What::emergency_stop_accepted:
    case What::emergency_stop_revoked:
    case What::track_description_shortened:
    case What::track_description_ended:
    case What::level_crossing_speed:
      return true;
    default:
      return is_repositioning(e);
  }
}

/// An authority that was not taken: of messages only those that bring one.
bool refuses_authority(const port::Event& e) {
  const bool message = e.what == What::message_refused || e.what == What::message_rejected;
  return e.what == What::authority_refused || e.what == What::shortening_rejected ||
         (message && (e.id == 3 || e.id == 9 || e.id == 33));
}

/// The brake that stopped the train before the track description was shortened (3.16.2.6.2, 3.16.3.4.5, 3.18.3.7).
Steps shortening_steps(const Journal& journal, std::int64_t t_ms) {
  Command stopped;
  for (const Cause cause : {Cause::linking, Cause::balise_group_consistency, Cause::two_groups_missed,
                            Cause::T_NVCONTACT, Cause::train_data_changed}) {
    const auto found = journal.brakings().find(cause);
    if (found == journal.brakings().end() || found->second.onset->t_ms > t_ms) continue;
    if (stopped.braking == nullptr || found->second.onset->t_ms >= stopped.braking->onset->t_ms)
      stopped = {cause, &found->second};
  }
  return stopped.braking == nullptr ? Steps{} : chain_of(stopped, journal);
}

/// `words` of an authority, with how far its EOA is ahead.
std::string with_distance(std::string words, const kernel::State& s, const track::Authority& a) {
  if (!a.EOA) return words;
  const Distance ahead = *a.EOA - kernel::here(s).est_front;
  const std::string place = place_words(s, *a.EOA);
  const std::size_t at = words.find(place);  // the EOA is the first place in them
  if (ahead > Distance{} && at != std::string::npos)
    words.insert(at + place.size(), fmt::format(" ({} ahead)", metres_words(ahead)));
  return words;
}

/// A change of the authority: what it was, where a new one does not only go on, and what it is: `end`, without one what
/// it became then.
Step change_step(const Note& note, const std::string& end) {
  Step step = step_of(note);
  if (is_repositioning(note.event)) step.clause = "3.8.5.2";
  const bool tells = note.event.what != What::authority_accepted || note.nearer;
  const std::string& is = end.empty() ? note.became : end;
  if (tells && !note.ended.empty())
    step.text += fmt::format(": was {}; is {}", note.ended, is.empty() ? "none" : is);
  else if (!is.empty())
    step.text += ", " + is;
  return step;
}

/// The end in force where it is not the authority's own.
std::optional<Step> temporary_step(const Journal& journal, const kernel::State& s) {
  const track::Authority &a = s.basis.authority, own = own_end(s);
  const auto EOA = a.EOA ? temporary_at(journal, s, *a.EOA, false) : std::nullopt;
  const auto SvL = a.SvL ? temporary_at(journal, s, *a.SvL, true) : std::nullopt;
  const auto& temporary = EOA ? EOA : SvL;
  if (!temporary) return std::nullopt;
  Step step = temporary->packet != nullptr ? step_of(*temporary->packet) : Step{};
  const std::string end = EOA ? end_words(a, s.position) : "SvL at " + place_words(s, *a.SvL);
  step.text += fmt::format("{}{}: {}", step.text.empty() ? "" : ": ", temporary->what, with_distance(end, s, a));
  if (EOA && own.EOA_or_LOA() && *own.EOA_or_LOA() > *a.EOA) step.text += ", not that of the MA";
  step.clause = temporary->clause;
  return step;
}

}  // namespace

std::string end_words(const track::Authority& a, const position::State& position) {
  if (a.ends_with_LOA()) return fmt::format("LOA at {}, {}", place_words(position, *a.LOA), kmh_words(a.V_LOA));
  if (!a.EOA) return "";
  const bool together = a.SvL == a.EOA;
  std::string text = (together ? "EOA and SvL at " : "EOA at ") + place_words(position, *a.EOA);
  if (a.SvL && !together) text += ", SvL at " + place_words(position, *a.SvL);
  return text + release_speed(a.release);
}

Steps authority_steps(const Journal& journal, const Moment& m) {
  const Note* accepted = journal.last(What::authority_accepted, m.t_ms);
  if (accepted == nullptr) return {};
  std::vector<const Note*> changes{accepted};
  Steps steps, shortening;
  const Note* refused = nullptr;
  for (const Note& note : journal.notes()) {
    if (note.t_ms < accepted->t_ms || note.t_ms > m.t_ms) continue;
    if (refuses_authority(note.event)) refused = &note;
    if (note.event.what == What::track_description_shortened) shortening = shortening_steps(journal, note.t_ms);
    // What comes with the authority itself is part of it.
    if (changes_authority(note.event) && (note.t_ms > accepted->t_ms || !is_repositioning(note.event)))
      changes.push_back(&note);
  }
  // A trip deletes the authority that led to it.
  const kernel::State& s = m.after.basis.authority.EOA_or_LOA() ? m.after : m.deciding;
  const track::Authority& a = s.basis.authority;
  const auto temporary = a.EOA_or_LOA() ? temporary_step(journal, s) : std::nullopt;
  for (const Note* note : changes) {
    std::string end;
    // Where something else ends it, a change other than the authority itself has what it changed then, or nothing.
    const bool told = temporary && note->event.what != What::authority_accepted;
    if (note == changes.back() && a.EOA_or_LOA() && !told)
      end = temporary ? end_words(own_end(s), s.position) : with_distance(end_words(a, s.position), s, a);
    steps.push_back(change_step(*note, end));
  }
  for (Step& step : shortening) steps.push_back(std::move(step));
  if (temporary) steps.push_back(*temporary);
  if (refused != nullptr) {
    steps.push_back(step_of(*refused));
    if (m.after.emergency_stops.any()) steps.back().text += ": an emergency stop is not revoked (3.10.2.4)";
  }
  std::stable_sort(steps.begin(), steps.end(), [](const Step& x, const Step& y) { return x.t_ms < y.t_ms; });
  return steps;
}

}  // namespace evc::explain
