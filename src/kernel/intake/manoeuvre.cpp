#include "kernel/intake/manoeuvre.h"

#include "kernel/here.h"
#include "kernel/intake/filter.h"
#include "kernel/manoeuvre.h"
#include "lang/decode.h"
#include "lang/messages.h"
#include "lang/packets/packet_15.h"
#include "terms/packet_numbers.h"

namespace evc::kernel {
namespace {

/// 3.18.3.8: the track under what was joined to the rear end of a train without valid train data.
void forget_track_behind(State& s, const ConsistLength& now) {
  const auto before = consist_of_train(s);
  const Distance behind = s.manoeuvre.opposite ? now.front.max : now.rear.max;
  if (!before || behind <= before->behind.max) return;
  const Place rear = here(s).min_safe_rear;
  s.track.ssp.begin_at(rear);
  s.track.gradient.begin_at(rear);
}

void store(Reception& r, const ConsistLength& consist) {
  State& s = r.state;
  Manoeuvre& m = s.manoeuvre;
  const bool was_in_front = m.consist && m.consist->front.max > Distance{};
  const bool changed = !m.available || m.consist != consist;
  m.available = m.captured = true;
  if (!changed) return;
  forget_track_behind(s, consist);
  m.consist = consist;
  ++s.revision;
  r.out.consist_changed = true;
  r.out.consist_in_front = consist.front.max > Distance{} && !was_in_front;  // 4.6.3 [83]
  r.log.note({.what = What::consist_changed, .clause = "3.18.3.2"_srs});
}

}  // namespace

void receive_consist_length(Reception& r) {
  State& s = r.state;
  if (s.srs != SrsVersion::v4_0_0) return;
  const std::optional<ConsistLength>& consist = r.in.train.consist;
  // Others are those of a source that does not work.
  if (consist && is_possible(consist->front) && is_possible(consist->rear)) {
    store(r, *consist);
  } else if (s.manoeuvre.available) {
    s.manoeuvre.available = false;
    r.out.consist_changed = r.out.consist_lost = true;
    if (!s.manoeuvre.active) s.manoeuvre.consist.reset();  // 3.18.3.2.5: in a mission it stays
    r.log.note({.what = What::consist_lost, .clause = "3.18.3.2.5"_srs});
  }
  place_front_end(s);
  r.out.here = here(s);
}

bool answers_manoeuvre_request(const State& s, std::uint32_t T_TRAIN_REF) {
  if (s.mode == Mode::SM) return true;
  return s.manoeuvre.request.waits_for_answer && s.radio.manoeuvre_request_stamp == T_TRAIN_REF;
}

ManoeuvreAuthorisation judge_manoeuvre(const Reception& r, const Information& information,
                                       const lang::MessageToTrainView& view) {
  const State& s = r.state;
  ManoeuvreAuthorisation out;
  const auto refuse = [&out](Clause clause) {
    out.refused = clause;
    return out;
  };
  lang::Message4 m;
  if (lang::decode(view, m) != lang::Fault::none) return refuse("3.16.3.1.1"_srs);
  if (!answers_manoeuvre_request(s, m.T_TRAIN_REF.raw)) return refuse("4.8.4"_srs.exception(14));
  if (!s.manoeuvre.consist) return refuse("4.4.21"_srs);
  modes::AcceptanceContext context = context_of(r, information);
  context.described_over_whole_ma = true;  // judged with the authority
  const modes::Acceptance a = modes::accept(evc::Information::movement_authority_sm, context);
  if (a.verdict != modes::Verdict::accepted) return refuse(a.clause);
  if (information.orientation == Direction::unknown) return refuse("3.6.3.1.4"_srs);
  out.V_SM = static_cast<track::SpeedCode>(m.V_SM.raw);
  for (const lang::PacketView& packet : view.packets) {
    lang::Packet15 p;
    if (packet.NID_PACKET == packet::level_2_3_movement_authority && lang::decode(packet, p) == lang::Fault::none)
      out.opposite = !track::valid_direction(p.Q_DIR.raw, information.orientation);
  }
  return out;
}

}  // namespace evc::kernel
