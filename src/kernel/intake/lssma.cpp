#include "kernel/intake/lssma.h"

#include <span>

#include "terms/packet_numbers.h"
#include "track/from_packets.h"

namespace evc::kernel {
namespace {

/// 4.8.4 [9], [10] of 4.0.0: of the areas that the confidence interval overlaps the furthest one is for LS.
bool overlaps_LS_area(const track::Here& now, std::span<const track::ModeArea> areas) {
  const track::ModeArea* furthest = nullptr;
  for (const track::ModeArea& area : areas) {
    const bool overlaps = now.max_safe_front >= area.from && !(area.to && now.min_safe_front > *area.to);
    if (overlaps && (furthest == nullptr || area.from >= furthest->from)) furthest = &area;
  }
  return furthest != nullptr && furthest->mode == Mode::LS;
}

/// The estimated front end is where on sight may be acknowledged (4.8.4 [10] of 4.0.0).
bool front_in_OS_ack_area(std::span<const track::ModeArea> areas, Place est_front) {
  for (const track::ModeArea& area : areas)
    if (area.mode == Mode::OS && est_front >= area.ack_from && est_front < area.from) return true;
  return false;
}

}  // namespace

bool front_in_LS_area(Evaluation& e) {
  track::AuthorityContents& along = e.r.scratch.proposal;
  along = {};
  for (const lang::PacketView& view : e.information.packets)
    if (view.NID_PACKET == packet::mode_profile) (void)track::add(along, e.information.time, view, e.reference);
  if (!along.mode_profile) return false;
  const track::Here& now = e.r.out.here;
  if (e.context.srs == SrsVersion::v4_0_0) {
    const std::span<const track::ModeArea> areas{along.mode_profile->begin(), along.mode_profile->size()};
    e.context.front_in_OS_ack_area = front_in_OS_ack_area(areas, now.est_front);
    return overlaps_LS_area(now, areas);
  }
  for (const track::ModeArea& area : *along.mode_profile)
    if (area.mode == Mode::LS && now.max_safe_front >= area.from && !(area.to && now.max_safe_front > *area.to))
      return true;
  return false;
}

}  // namespace evc::kernel
