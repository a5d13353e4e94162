#include "kernel/intake/shortening.h"

#include <span>

#include "kernel/basis.h"
#include "kernel/curves.h"
#include "kernel/stored.h"
#include "radio/messages.h"
#include "terms/packet_numbers.h"
#include "track/store.h"

namespace evc::kernel {
bool can_stop_before(const State& s, Derived::Curves& curves, const TrainSignals& train, const track::Here& here,
                     const track::AuthorityContents& proposal) {
  if (!supervises(s, modes::Supervision::full) || !proposal.ma) return false;
  // The start of an area of its mode profile that is not entered yet would also be an end (3.12.4).
  std::span<const track::ModeArea> areas;
  if (proposal.mode_profile) areas = {proposal.mode_profile->begin(), proposal.mode_profile->size()};
  const track::Authority a = track::authority(*proposal.ma, areas, s.mode, s.srs);
  build(curves, s, train, basis_of(s, here, s.basis.key, a));
  // The Indication limit of the proposed end alone counts, whatever else is a target now.
  sdm::Inputs& in = curves.inputs;
  in.mrsp.steps.clear();
  (void)in.mrsp.append(here.min_safe_rear, track::kNoLimit);
  in.mrsp_due_to_TSR = {};
  curves.sdm.valid = false;
  (void)sdm::rebuild(curves.sdm, in);
  // 3.8.6.1 b: in 3.4.0 too by the Indication limit; the pre-indication location depends on the MRSP, left out here.
  curves.sdm.rules.pre_indication = false;
  sdm::Supervision fresh;
  const bool in_rear = sdm::supervise(fresh, curves.sdm, motion_of(s, here, train)).monitoring == Monitoring::CSM;
  curves.sdm.valid = false;
  return in_rear;
}

bool proposal_is_described(Evaluation& e) {
  track::AuthorityContents& proposed = e.r.scratch.proposal;
  proposed = {};
  for (const lang::PacketView& p : e.information.packets)
    if (p.NID_PACKET != packet::level_1_movement_authority)
      (void)track::add(proposed, e.information.time, p, e.reference);
  return proposed.ma && track::complete(e.r.state.track, *proposed.ma, e.r.out.here);
}

namespace {
/// 3.8.6.1 a: no farther than the EOA or LOA in force. The request is no way to extend the authority.
bool is_closer(const track::MovementAuthority& proposed, const std::optional<track::MovementAuthority>& now) {
  if (proposed.sections.empty()) return false;
  return now && !now->sections.empty() && proposed.end() <= now->end();
}
}  // namespace

Clause take_shortening(Evaluation& e, const lang::MessageToTrainView& view) {
  State& s = e.r.state;
  track::AuthorityContents& proposed = e.r.scratch.proposal;
  if (proposed.mode_profile) {
    track::carry_acceptance(*proposed.mode_profile, s.track, e.r.out.here);
    (void)track::forget_acceptance_ahead(*proposed.mode_profile, s.mode, e.r.out.here);
  }
  const bool granted = e.context.described_over_whole_ma && is_closer(*proposed.ma, s.track.ma) &&
                       can_stop_before(s, e.r.scratch.curves, e.r.in.train, e.r.out.here, proposed);
  radio::answer_shortening(granted, view.T_TRAIN.raw, e.r.outbox);
  e.r.log.note({.what = granted ? What::shortening_granted : What::shortening_rejected, .clause = "3.8.6"_srs});
  if (!granted) return "3.8.6.2"_srs;
  proposed.ma_is_shortening_request = true;
  (void)track::store(s.track, proposed, e.r.out.here);
  track::forget_acceptance_ahead(s.track, s.mode, e.r.out.here);
  cut_beyond(s, proposed.ma->far_end());
  return {};
}

}  // namespace evc::kernel
