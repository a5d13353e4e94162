#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "check/journey.h"
#include "kernel/intake/routes.h"
#include "lang/decode.h"
#include "lang/packets/packet_5.h"

namespace evc::check {
namespace {

using enum Severity;

/// A difference that the steps of D_LINK and of surveys explain.
constexpr double kSurvey = 1.0;

}  // namespace

/// A group marked linked that linking does not announce is rejected (3.4.4.4.2).
void Journey::check_announced(const Group& group) const {
  if (level_.level == Level::L0 || level_.level == Level::NTC || !group.linked()) return;
  const bool used =
      std::any_of(announced_.begin(), announced_.end(), [&](const Announced& a) { return a.last_m > group.last_m(); });
  const bool known = std::any_of(announced_.begin(), announced_.end(), [&](const Announced& a) {
    return a.id == group.id || a.id.NID_BG == balise::kIdentityUnknown;
  });
  if (used && !known)
    out_.add(warning, group.where(), "3.4.4.4.2"_srs,
             fmt::format("group {} is marked linked and not announced, linking goes beyond it: a train rejects it",
                         group_text(group.id)));
}

void Journey::take_linking(Source& source, const Part& part) {
  for (const lang::PacketView* view : part.packets) {
    lang::Packet5 p;
    if (kernel::route_of(*view).turn != kernel::Turn::linking || !passes(source, *view) ||
        lang::decode(*view, p) != lang::Fault::none || !track::valid_direction(p.Q_DIR.raw, part.reference.orientation))
      continue;
    check_list(source, part, balise::linking_list(p));
  }
}

void Journey::check_list(const Source& source, const Part& part, const balise::LinkingList& list) {
  const double reference_m = part.reference.place.from_origin.si;
  // New linking replaces the stored one from its reference on (3.7.3.1); an infill counts from a group ahead.
  const GroupId reference = part.reference.origin();
  const auto replaced = [&](const Announced& a) { return a.at_m > reference_m && a.id != reference; };
  announced_.erase(std::remove_if(announced_.begin(), announced_.end(), replaced), announced_.end());
  double linked_m = reference_m;    // by linking: the sum of D_LINK
  double previous_m = reference_m;  // on the line: the group before
  double window_end_m = reference_m;
  std::uint16_t NID_C = part.reference.group.NID_C;
  for (const balise::LinkingList::Entry& entry : list.entries) {
    NID_C = entry.NID_C.value_or(NID_C);
    const GroupId id{NID_C, entry.NID_BG};
    linked_m += entry.D_LINK.si;
    if (linked_m - entry.Q_LOCACC.si <= window_end_m)
      out_.add(
          error, source.where, "3.4.4.4.3.1"_srs,
          fmt::format("the window of group {} ({:.0f} m, +/- {:.0f} m) begins at or before {:.1f} m, the end of the "
                      "one before it",
                      group_text(id), linked_m, entry.Q_LOCACC.si, window_end_m));
    window_end_m = linked_m + entry.Q_LOCACC.si;
    announced_.push_back({id, linked_m, window_end_m});
    const double expected_m = previous_m + entry.D_LINK.si;
    const Group* group = trackside_.find(id, expected_m);
    previous_m = group != nullptr ? group->at_m : expected_m;
    if (entry.NID_BG == balise::kIdentityUnknown) continue;
    check_linked_group(source, entry, id, expected_m, linked_m);
    if (group != nullptr && group->crossing == Direction::unknown)
      by_linking_[static_cast<std::size_t>(group - trackside_.groups.data())] =
          entry.nominal ? Direction::nominal : Direction::reverse;
  }
}

void Journey::check_linked_group(const Source& source, const balise::LinkingList::Entry& entry, GroupId id,
                                 double expected_m, double linked_m) const {
  const Group* group = trackside_.find(id, expected_m);
  if (group == nullptr) {
    const bool beyond = linked_m > trackside_.groups.back().last_m();
    out_.add(beyond                             ? note
             : entry.reaction == Reaction::none ? warning
                                                : error,
             source.where, "3.4.4.2.1"_srs,
             fmt::format("links group {} at {:.1f} m, which is not on the line", group_text(id), linked_m));
    return;
  }
  const double off_m = group->at_m - expected_m;
  if (std::abs(off_m) > entry.Q_LOCACC.si + 1e-6)
    out_.add(error, source.where, "3.4.4.4.3.2"_srs,
             fmt::format("links group {} at {:.1f} m +/- {:.0f} m, it is at {:.1f} m: a train rejects it",
                         group_text(id), expected_m, entry.Q_LOCACC.si, group->at_m));
  else if (std::abs(off_m) > kSurvey)
    out_.add(warning, source.where, "3.4.4.2.1"_srs,
             fmt::format("links group {} at {:.1f} m, it is at {:.1f} m", group_text(id), expected_m, group->at_m));
  if (group->crossing != Direction::unknown && (group->crossing == Direction::nominal) != entry.nominal)
    out_.add(error, source.where, "3.4.4.4.7"_srs,
             fmt::format("links group {} as crossed in {} direction, it is crossed in {} direction: trip",
                         group_text(id), entry.nominal ? "nominal" : "reverse", entry.nominal ? "reverse" : "nominal"));
  if (!group->linked())
    out_.add(error, source.where, "3.4.4.1.2"_srs,
             fmt::format("links group {}, which is marked unlinked", group_text(id)));
}

}  // namespace evc::check
