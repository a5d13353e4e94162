#include <fmt/format.h>

#include <algorithm>

#include "explain/brake.h"
#include "explain/words.h"
#include "kernel/here.h"
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
    default:
      return "";
  }
}

/// Why the end in force lies in rear of the end of the stored authority, and the packet that says so.
struct TemporaryEnd {
  std::string why;
  std::int32_t packet = 0;
};
std::optional<TemporaryEnd> temporary_end(const kernel::State& s) {
  const track::Authority& a = s.basis.authority;
  if (!a.EOA || !s.track.ma || *a.EOA >= s.track.ma->end()) return std::nullopt;
  for (const track::ModeArea& area : s.track.mode_profile)
    if (area.from == *a.EOA)
      return TemporaryEnd{fmt::format("start of an area of {}", name(area.mode)), packet::mode_profile};
  for (const track::LevelCrossing& lx : s.track.lx)
    if (lx.from == *a.EOA)
      return TemporaryEnd{fmt::format("level crossing {} is not protected", lx.NID_LX), packet::level_crossing};
  return TemporaryEnd{"route not suitable", packet::route_suitability};
}

bool changes_authority(What what) {
  switch (what) {
    case What::authority_timer_elapsed:
    case What::shortening_granted:
    case What::emergency_stop_accepted:
    case What::emergency_stop_revoked:
    case What::track_description_shortened:
    case What::track_description_ended:
    case What::level_crossing_speed:
      return true;
    default:
      return false;
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

void add_end(std::string& text, const kernel::State& s) {
  const track::Authority& a = s.basis.authority;
  text += (text.find(": was ") == std::string::npos ? ", " : "; is ") + end_words(s);
  if (!a.EOA) return;
  const Distance ahead = *a.EOA - kernel::here(s).est_front;
  const std::string place = place_words(s, *a.EOA);
  if (ahead > Distance{})
    text.insert(text.rfind(place) + place.size(), fmt::format(" ({} ahead)", metres_words(ahead)));
}

}  // namespace

std::string end_words(const kernel::State& s) {
  const track::Authority& a = s.basis.authority;
  if (a.LOA) return fmt::format("LOA at {}, {}", place_words(s, *a.LOA), kmh_words(a.V_LOA));
  if (!a.EOA) return "";
  std::string text = "EOA at " + place_words(s, *a.EOA);
  if (a.SvL && *a.SvL != *a.EOA) text += ", SvL at " + place_words(s, *a.SvL);
  return text + release_speed(a.release);
}

Steps authority_steps(const Journal& journal, const Moment& m) {
  const Note* accepted = journal.last(What::authority_accepted, m.t_ms);
  if (accepted == nullptr) return {};
  Steps steps{step_of(*accepted)};
  const Note* refused = nullptr;
  for (const Note& note : journal.notes()) {
    if (note.t_ms < accepted->t_ms || note.t_ms > m.t_ms) continue;
    if (refuses_authority(note.event)) refused = &note;
    if (note.event.what == What::track_description_shortened)
      for (Step& step : shortening_steps(journal, note.t_ms)) steps.push_back(std::move(step));
    if (changes_authority(note.event.what)) steps.push_back(step_of(note));
    if (changes_authority(note.event.what) && !note.ended.empty()) steps.back().text += ": was " + note.ended;
  }
  // A trip deletes the authority that led to it.
  const kernel::State& s = m.after.basis.authority.EOA_or_LOA() ? m.after : m.deciding;
  if (s.basis.authority.EOA_or_LOA()) {
    const auto temporary = temporary_end(s);
    const Note* packet = temporary ? journal.last(What::packet_accepted, m.t_ms, temporary->packet) : nullptr;
    if (packet != nullptr && packet->t_ms != steps.back().t_ms) steps.push_back(step_of(*packet));
    add_end(steps.back().text, s);
    if (temporary) steps.back().text += " (" + temporary->why + ")";
  }
  if (refused != nullptr) steps.push_back(step_of(*refused));
  std::stable_sort(steps.begin(), steps.end(), [](const Step& a, const Step& b) { return a.t_ms < b.t_ms; });
  return steps;
}

}  // namespace evc::explain
