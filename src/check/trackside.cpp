#include "check/trackside.h"

#include <algorithm>
#include <cmath>

#include "lang/schema.h"
#include "lang/si.h"

namespace evc::check {
namespace {

/// From the order of the numbers along the run (3.4.2.2.2).
Direction crossing_of(const std::vector<Telegram>& telegrams) {
  bool rising = telegrams.size() > 1, falling = rising;
  for (std::size_t i = 0; i < telegrams.size(); ++i) {
    if (!telegrams[i].has_header()) return Direction::unknown;
    if (i == 0) continue;
    rising = rising && telegrams[i].view.N_PIG.raw > telegrams[i - 1].view.N_PIG.raw;
    falling = falling && telegrams[i].view.N_PIG.raw < telegrams[i - 1].view.N_PIG.raw;
  }
  return rising ? Direction::nominal : falling ? Direction::reverse : Direction::unknown;
}

void complete(Group& group) {
  group.at_m = group.first_m();
  group.crossing = crossing_of(group.telegrams);
  const auto readable = [](const Telegram& t) { return t.has_header(); };
  const auto first = std::find_if(group.telegrams.begin(), group.telegrams.end(), readable);
  if (first != group.telegrams.end()) group.id = first->id();
  const auto reference = std::find_if(group.telegrams.begin(), group.telegrams.end(),
                                      [&](const Telegram& t) { return readable(t) && t.view.N_PIG.raw == 0; });
  if (reference != group.telegrams.end()) group.at_m = reference->balise->position_m;
}

}  // namespace

bool Telegram::has_header() const { return balise->telegram.size >= 50; }

GroupId Telegram::id() const {
  return {static_cast<std::uint16_t>(view.NID_C.raw), static_cast<std::uint16_t>(view.NID_BG.raw)};
}

bool Group::linked() const {
  return std::any_of(telegrams.begin(), telegrams.end(),
                     [](const Telegram& t) { return t.has_header() && t.view.Q_LINK.raw == 1; });
}

const Group* Trackside::find(GroupId id, double near_m) const {
  const Group* found = nullptr;
  for (const Group& group : groups)
    if (group.id == id && (found == nullptr || std::abs(group.at_m - near_m) < std::abs(found->at_m - near_m)))
      found = &group;
  return found;
}

Trackside read(const sim::Line& line) {
  Trackside trackside;
  trackside.line = &line;
  for (const sim::Balise& balise : line.balises) {
    const auto known = std::find_if(trackside.groups.begin(), trackside.groups.end(),
                                    [&](const Group& g) { return g.index == balise.group; });
    Group& group = known != trackside.groups.end() ? *known : trackside.groups.emplace_back();
    group.index = balise.group;
    group.telegrams.push_back({&balise, lang::scan_telegram(balise.telegram.bytes, balise.telegram.size)});
  }
  for (Group& group : trackside.groups) complete(group);
  const lang::SystemVersion sv = lang::system_version(line.balises.front().telegram.number(1, 7));
  for (const sim::TracksideMessage& sent : line.radio) {
    Message message{&sent, lang::scan_message_to_train(sent.message.bytes, sv), {}};
    const auto lrbg = lang::group(message.view.NID_LRBG);
    if (lrbg) message.lrbg = GroupId{lrbg->NID_C, lrbg->NID_BG};
    trackside.messages.push_back(message);
  }
  return trackside;
}

}  // namespace evc::check
