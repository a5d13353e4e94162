#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "base/location.h"
#include "check/finding.h"
#include "lang/telegram.h"
#include "sim/line.h"

namespace evc::check {

/// A balise with its telegram as a train reads it. `view.fault` set: it is rejected.
struct Telegram {
  const sim::Balise* balise = nullptr;
  lang::TelegramView view;
  /// The header can be read: also of a telegram that is rejected for its packets.
  bool has_header() const;
  GroupId id() const;
};

/// The balises that the file lists as one group.
struct Group {
  std::size_t index = 0;            // in the file
  std::vector<Telegram> telegrams;  // by place
  GroupId id;                       // of the first readable header
  double at_m = 0.0;                // of balise N_PIG 0 (3.4.2.2.1), else of the first one
  /// The direction in which the train passes it; unknown for one balise (3.4.2.3.1) or a wrong order.
  Direction crossing = Direction::unknown;

  double first_m() const { return telegrams.front().balise->position_m; }
  double last_m() const { return telegrams.back().balise->position_m; }
  bool linked() const;
  Where where() const { return {at_m, id, {}}; }
  Where where(const Telegram& telegram) const { return {telegram.balise->position_m, id, {}}; }
};

struct Message {
  const sim::TracksideMessage* sent = nullptr;
  lang::MessageToTrainView view;
  std::optional<GroupId> lrbg;  // none: unknown

  Where where() const { return {sent->position_m, {}, sent->seq}; }
};

/// A line, decoded. It refers to the line, which must outlive it.
struct Trackside {
  const sim::Line* line = nullptr;
  std::vector<Group> groups;      // by place
  std::vector<Message> messages;  // by place

  /// The group with this identity, the one nearest to the place; null if there is none.
  const Group* find(GroupId id, double near_m) const;
};

/// Radio messages are read in the version of the first telegram: it is that of the simulated RBC.
Trackside read(const sim::Line& line);

}  // namespace evc::check
