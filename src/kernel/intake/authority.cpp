#include "kernel/intake/authority.h"

#include "kernel/intake/filter.h"
#include "kernel/intake/message_events.h"
#include "kernel/intake/routes.h"
#include "kernel/stored.h"
#include "terms/message_numbers.h"
#include "track/relocate.h"
#include "track/store.h"
#include "track/withdraw.h"

namespace evc::kernel {
namespace {

using modes::Verdict;

constexpr modes::Acceptance kUnreadable{Verdict::rejected, "3.16.1.1"_srs};

/// The signalling related speed restriction "0" has a row of its own: a trip order (3.11.6.4). Returns whether it
/// counts; then it is stored, even if the authority is refused (store_contents).
bool judge_trip_order(Evaluation& e) {
  if (modes::accept(evc::Information::signalling_speed, e.context).verdict != Verdict::accepted) return false;
  e.r.log.note({.what = What::trip_ordered, .clause = "3.11.6.4"_srs});
  return true;
}

/// Of the same part: packets after packet 136 belong to the infill authority.
void add_with_authority(Evaluation& e) {
  for (std::size_t k = 0; k < e.information.packets.size(); ++k) {
    const lang::PacketView& view = e.information.packets[k];
    if ((view.NID_PACKET == packet::mode_profile || view.NID_PACKET == packet::balise_groups_for_sh_area) &&
        judged(e, k))
      (void)track::add(e.contents, view, e.reference);
  }
}

/// Without an authority in the same part they say nothing (3.12.4.3): of a group or loop, as such packets of a message
/// belong to it (8.7).
void tell_without_authority(Evaluation& e) {
  if (e.information.message != nullptr) return;
  for (std::size_t k = 0; k < e.information.packets.size(); ++k) {
    const auto number = e.information.packets[k].NID_PACKET;
    if (route_of(e.information.packets[k]).turn == Turn::with_authority && judged(e, k))
      e.r.log.note({.what = What::packet_not_used, .id = number});
  }
}

void tell_stored(Evaluation& e, const track::Stored& stored) {
  for (const track::Note& n : stored.notes) {
    if (n.what == track::Note::What::stored) continue;
    e.r.log.note({.what = n.what == track::Note::What::full        ? What::packet_no_room
                          : n.what == track::Note::What::shortened ? What::packet_shortened
                          : !n.clause                              ? What::packet_refused_no_room
                                                                   : What::packet_refused,
                  .id = n.packet,
                  .clause = n.clause});
    if (n.what == track::Note::What::refused) refuse(e, n.clause);
  }
}

/// 3.6.6.4.1: of groups passed before, the one reported last counts.
void place_geo_references(const position::State& position, InplaceVector<track::GeoReference, 32>& geo) {
  for (std::size_t i = position.references.size(); i-- > 0;) {
    const position::Reference& group = position.references[i];
    bool named = false;
    for (track::GeoReference& reference : geo) {
      if (!group.reported || !(reference.group == group.id)) continue;
      track::place(reference, group.place, group.orientation);
      named = true;
    }
    if (named) return;
  }
}

/// Authority and track description have been ended at `from`.
void tell_end_of_description(Evaluation& e, Place from) {
  const Place front = e.r.out.here.max_safe_front;
  cut_beyond(e.r.state, from < front ? front : from);
  e.r.log.note({.what = What::track_description_ended, .clause = "3.7.2.3"_srs});
}

/// Returns whether the track description was deleted at the train.
bool end_where_undescribed(Evaluation& e) {
  const std::optional<Place> from = track::undescribed_from(e.r.state.track, e.r.out.here);
  if (!from) return false;
  const bool deleted = track::end_before(e.r.state.track, *from, e.r.out.here);
  tell_end_of_description(e, *from);
  return deleted;
}

}  // namespace

void evaluate_authority(Evaluation& e) {
  // The authority of a request to shorten is a proposal: take_message decides (3.8.6).
  if (e.information.message != nullptr && e.information.message->NID_MESSAGE == message::request_to_shorten_ma) return;
  track::Contents& c = e.contents;
  bool authority = false;
  for (std::size_t i = 0; i < e.information.packets.size(); ++i) {
    const lang::PacketView& view = e.information.packets[i];
    if (route_of(view).turn != Turn::authority || !judged(e, i)) continue;
    authority = true;
    track::AuthorityContents& offered = e.r.scratch.proposal;
    offered = {};
    if (track::add(offered, c.time, view, e.reference) != track::Added::added) {
      // Does not occur: the bits were checked on reception.
      tell_packet(e, view.NID_PACKET, kUnreadable, std::nullopt);
      tell_belonging(e, kUnreadable);
      continue;
    }
    e.context.described_over_whole_ma = track::complete(e.r.state.track, c, *offered.ma, e.r.out.here);
    const bool stop = offered.V_MAIN && *offered.V_MAIN == 0 && !c.infill;
    if (stop && judge_trip_order(e)) c.V_MAIN = offered.V_MAIN;
    const modes::Acceptance judged_as = judge_packet(e, i);
    tell_belonging(e, judged_as);
    if (judged_as.verdict != Verdict::accepted) continue;
    c.ma = offered.ma;
    if (offered.V_MAIN) c.V_MAIN = offered.V_MAIN;
    add_with_authority(e);
  }
  if (!authority) tell_without_authority(e);
}

namespace {
/// 4.4.19.1.4.8: balise groups alone have the marker; an area of limited supervision of another sender leaves it.
void keep_marker_of_groups(Evaluation& e) {
  if (e.information.medium != Medium::balise && e.r.state.track.generic_ls_marker) e.contents.generic_ls_marker = true;
}
}  // namespace

void store_contents(Evaluation& e) {
  Received& out = e.r.out;
  State& s = e.r.state;
  const Anchor anchor = anchor_of(e);
  if (e.information.medium == Medium::rbc && e.contents.geo) place_geo_references(s.position, *e.contents.geo);
  if (anchor != Anchor::lrbg) {
    track::hang_on_unlinked(e.contents);
    if (s.srs == SrsVersion::v4_0_0) track::overlap(s.track, e.contents, anchor, e.information.widening);
  }
  keep_marker_of_groups(e);
  const track::Stored stored = track::store(s.track, e.contents, out.here);
  if (anchor != Anchor::lrbg) track::relocate(s.track, Anchor::received, anchor, e.information.widening);
  // The acceptance of an area that is left is none for another one ahead.
  track::forget_acceptance_ahead(s.track, s.mode, out.here);
  tell_stored(e, stored);
  if (stored.trip_order) out.trip_order = true;
  if (stored.shortened && s.track.ma && !s.track.ma->sections.empty()) {
    cut_beyond(s, s.track.ma->far_end(), e.brought);  // what was stored before the message (3.8.5.1.3, 3.8.5.1.5)
  }
  if (stored.lost_from) tell_end_of_description(e, *stored.lost_from);
  bool deleted = stored.track_description_deleted;
  if (e.contents.ssp || e.contents.gradient || e.contents.repositioned_section)
    deleted = end_where_undescribed(e) || deleted;
  if (stored.ma_accepted) s.track_description_deleted = false;  // 3.8.2.7.3
  if (deleted) s.track_description_deleted = true;
  if (stored.ma_accepted) {
    s.ma_with_trip_order = out.trip_order;
    s.manoeuvre.authority = authorises_manoeuvre(e.information);
    out.SM_authorised |= s.manoeuvre.authority;
    if (e.information.medium == Medium::rbc)
      out.ma_from_rbc = true;
    else if (!out.trip_order)
      out.balise_proceed = true;
    e.r.log.note({.what = What::authority_accepted, .clause = "3.8.4"_srs});
  } else if (stored.ma_refused) {
    e.r.log.note({.what = What::authority_refused, .clause = stored.ma_refused_by});
  }
  if (e.contents.stop_if_in_sr && *e.contents.stop_if_in_sr) out.stop_if_in_SR = true;
  if (e.contents.danger_for_shunting && *e.contents.danger_for_shunting) out.stop_if_in_SH = true;
  if (e.contents.track_ahead_free_to) {
    out.NID_LTRBG =
        (std::uint32_t{e.contents.track_ahead_free_to->NID_C} << 14) | e.contents.track_ahead_free_to->NID_BG;
  }
}

}  // namespace evc::kernel
