#include <fmt/format.h>

#include "explain/brake.h"
#include "explain/words.h"
#include "kernel/here.h"
#include "position/position.h"
#include "terms/packet_numbers.h"

// Commands because of balise groups: linking, consistency, lists of groups.
namespace evc::explain {
namespace {

bool is_linking_error(What what) {
  return what == What::linking_error_missed || what == What::linking_error_early || what == What::linking_error_later ||
         what == What::group_inconsistent || what == What::group_wrong_direction;
}

/// The link of the group that the event names, as it was before the cycle.
const balise::Link* link_of(const Moment& m, const port::Event& e) {
  for (const balise::Link& link : m.before.balise.linking.links)
    if (std::int32_t{link.id.NID_BG} == e.id) return &link;
  return nullptr;
}

/// The error of this cycle that has a reaction, otherwise the first one.
const Note* linking_error(const Journal& journal, const Moment& m) {
  const Note* error = nullptr;
  for (const Note& note : journal.notes()) {
    if (note.t_ms != m.t_ms || !is_linking_error(note.event.what)) continue;
    if (error == nullptr) error = &note;
    const balise::Link* link = link_of(m, note.event);
    if (link != nullptr && link->reaction != Reaction::none) return &note;
  }
  return error;
}

std::string link_words(const balise::Link& link, const std::string& place) {
  return fmt::format(": group {} announced at {} +- {}, reaction {}", link.id.NID_BG, place,
                     metres_words(link.Q_LOCACC), reaction_words(link.reaction));
}

/// What announced the group of the error; nothing: it was not announced.
std::optional<Step> announced_step(const Journal& journal, const Moment& m, const port::Event& error) {
  const balise::Link* link = link_of(m, error);
  const Announced* announced = journal.announced(error.id);
  if (announced == nullptr) return std::nullopt;
  Step step = step_of(announced->note);
  step.clause = "3.4.4";
  step.text +=
      link == nullptr
          ? link_words(announced->link, announced->place)
          : link_words(*link, metres_words(position::counter_of(m.before.position, link->place) - OdometerPlace{}));
  return step;
}

}  // namespace

const char* reaction_words(Reaction reaction) {
  return reaction == Reaction::trip ? "trip" : reaction == Reaction::service_brake ? "service brake" : "none";
}

Steps linking_steps(const Journal& journal, const Moment& m) {
  const Note* error = linking_error(journal, m);
  if (error == nullptr) return {};
  Steps steps;
  if (auto announced = announced_step(journal, m, error->event)) steps.push_back(*std::move(announced));
  steps.push_back(step_of(*error));
  if (error->event.what != What::linking_error_missed) return steps;
  const PlaceInterval antenna = position::antenna(m.after.position, kernel::L_antenna(m.after));
  steps.back().text += fmt::format(" (antenna between {} and {})",
                                   metres_words(position::counter_of(m.after.position, antenna.min) - OdometerPlace{}),
                                   metres_words(position::counter_of(m.after.position, antenna.max) - OdometerPlace{}));
  return steps;
}

Steps two_groups_steps(const Journal& journal, const Moment& m) {
  Steps announced, steps;
  const Note* packet = journal.last(What::packet_accepted, m.t_ms, std::int32_t{packet::linking});
  for (const Note& note : journal.notes()) {
    if (packet == nullptr || note.t_ms < packet->t_ms || note.t_ms > m.t_ms) continue;
    const What what = note.event.what;
    if (what == What::linking_error_missed)
      if (auto step = announced_step(journal, m, note.event)) announced.push_back(*std::move(step));
    if (what == What::linking_error_missed || what == What::double_linking_error || what == What::double_repositioning)
      steps.push_back(step_of(note));
  }
  if (announced.empty() && packet != nullptr) announced.push_back(step_of(*packet));
  announced.insert(announced.end(), steps.begin(), steps.end());
  return announced;
}

Steps list_steps(const Journal& journal, const Moment& m, const std::optional<track::GroupList>& list) {
  Steps steps;
  const bool SH = m.before.mode == Mode::SH;
  const std::int32_t packet = SH ? packet::balise_groups_for_sh_area : packet::balise_groups_in_sr_authority;
  const char* clause = SH ? "4.4.8.1.1 b" : "4.4.11.1.3 c";
  if (const Note* note = journal.last(What::packet_accepted, m.t_ms, packet)) {
    steps.push_back(step_of(*note));
    steps.back().text += fmt::format(": list of the groups that may be passed in {}", SH ? "SH" : "SR");
    steps.back().clause = clause;
  }
  std::string groups;
  if (list)
    for (const GroupId& id : *list) groups += fmt::format("{}{}/{}", groups.empty() ? "" : ", ", id.NID_C, id.NID_BG);
  const Note* read = journal.last(What::group_accepted, m.t_ms);
  if (read != nullptr && read->t_ms == m.t_ms)
    steps.push_back({m.t_ms,
                     fmt::format("{} is read; the list of the groups that may be passed has {}", read->source,
                                 groups.empty() ? "none" : groups),
                     clause});
  return steps;
}

}  // namespace evc::explain
