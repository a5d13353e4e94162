#pragma once
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "balise/linking.h"
#include "check/finding.h"
#include "check/trackside.h"
#include "lang/telegram.h"
#include "modes/acceptance.h"
#include "modes/levels.h"
#include "terms/medium.h"
#include "track/from_packets.h"
#include "track/store.h"

namespace evc::check {

/// What a train meets on its way, in the order of the places: groups as it passes them, messages as it gets them. The
/// levels follow the orders of the line, on a train with every level; the mode is one that uses everything (FS). Track
/// data are stored by the rules of the unit.
class Journey {
 public:
  Journey(const Trackside& trackside, Findings& out);
  void run();

 private:
  /// A group or message as received.
  struct Source {
    Where where;
    Medium medium = Medium::balise;
    Place front{};  ///< of the train at reception
    const lang::MessageToTrainView* message = nullptr;
    std::set<int> rejected;  ///< packets that have a finding already: balises of a group repeat them
  };
  /// Packets with one reference: those of a source, or behind a packet 136.
  struct Part {
    track::Reference reference;
    bool infill = false;
    std::vector<const lang::PacketView*> packets;
  };
  struct Announced {
    GroupId id;
    double at_m = 0.0;    ///< by linking
    double last_m = 0.0;  ///< end of its window
  };

  void pass(const Group& group);
  void receive(const Message& message);
  void advance(Place front);
  void check_announced(const Group& group) const;
  Direction orientation_of(const Group& group) const;

  void begin_infill(std::vector<Part>& parts, const Source& source, const lang::PacketView& view);
  void evaluate_parts(Source& source, const std::vector<Part>& parts);
  void evaluate_part(Source& source, const Part& part);
  void take_level_orders(Source& source, const Part& part);
  void take_linking(Source& source, const Part& part);
  void take_rest(Source& source, const Part& part);
  void take_authority(Source& source, const Part& part);
  void take_message(Source& source, const Part& part);

  /// The first filter, 4.8.3. False, with a finding, where the level rejects the packet.
  bool passes(Source& source, const lang::PacketView& view);
  void reject(Source& source, int packet, const std::string& what, Clause clause);
  void check_list(const Source& source, const Part& part, const balise::LinkingList& list);
  void check_linked_group(const Source& source, const balise::LinkingList::Entry& entry, GroupId id, double expected_m,
                          double linked_m) const;
  void check_revocation(const Source& source, const lang::PacketView& view) const;
  void check_cover(const Source& source, const track::MovementAuthority& ma) const;
  void check_timers(const Source& source, const track::MovementAuthority& ma) const;
  double highest_speed() const;

  const Trackside& trackside_;
  Findings& out_;
  modes::OrderedLevel level_;
  std::optional<modes::PendingTransition> pending_;
  std::optional<modes::OrderedLevel> executed_;  ///< by an order of this source
  modes::AcceptanceContext context_;
  std::vector<Announced> announced_;
  std::vector<std::optional<Direction>> by_linking_;  ///< of single groups, by their index in trackside
  std::unique_ptr<track::Description> stored_;
  std::unique_ptr<track::Contents> contents_;
};

/// Metres of a place.
constexpr double metres(Place at) { return at.from_origin.si; }

}  // namespace evc::check
