#include "kernel/intake/levels.h"

#include "kernel/driver_inputs.h"
#include "kernel/here.h"
#include "kernel/intake/buffer.h"
#include "kernel/intake/driver.h"
#include "kernel/intake/system_version.h"
#include "kernel/stored.h"
#include "lang/decode.h"
#include "lang/packets/packet_41.h"
#include "lang/packets/packet_46.h"
#include "lang/si.h"
#include "terms/packet_numbers.h"

namespace evc::kernel {
namespace {

using modes::OrderEffect;

/// Packet 46 has no place, hence no length in rear of it.
Distance L_ack(const lang::Packet41& p, const lang::Packet41_levels& e) {
  return lang::metres(p.Q_SCALE, e.L_ACKLEVELTR);
}
Distance L_ack(const lang::Packet46&, const lang::Packet46_levels&) { return {}; }

template <class P>
modes::LevelTable table_of(const P& p, SrsVersion srs) {
  modes::LevelTable table;
  const auto entry = [&p, srs](const auto& e) {
    modes::OrderedLevel level;
    const Level ordered = level_of(e.M_LEVELTR.raw).value_or(Level::L0);  // a spare code was rejected before
    level.level = modes::level_in(srs, ordered);
    level.ordered_as_level_3 = level.level != ordered;
    level.nid_ntc = level.level == Level::NTC ? static_cast<std::uint8_t>(e.NID_NTC.raw) : std::uint8_t{0};
    level.L_ack = L_ack(p, e);
    return level;
  };
  bool room = table.push_back(entry(p.first_levels()));
  for (const auto& further : p.levels) room = room && table.push_back(entry(further));
  return table;
}

/// 4.8.5.4 a: information that waits for a transition is deleted with the order for it, before anything that comes
/// with the new order is stored there (4.8.1.3.1).
void delete_waiting_of_replaced(Reception& r, const modes::OrderDecision& decision) {
  if (!decision.cancels_pending) return;
  const std::optional<modes::OrderedLevel> replaced = ordered_level(r);
  if (replaced && !replaced->same_level(decision.to)) clear_level_buffer(r.state);
}

/// 4.9; the release of the transition buffer is the caller's next step.
void enter_level(Reception& r, const modes::OrderedLevel& to, bool by_driver) {
  State& s = r.state;
  r.log.note(Event::level_changed(s.level.level, to.level, by_driver));
  const Level before = s.level.level;
  s.level = to;
  s.data.level_status = DataStatus::valid;
  ++s.revision;
  keep_for_level(s, to.level);
  r.out.level_changed_by_driver = by_driver;
  operate_version_of_rbc(r, before);  // before the buffer is released: 6.6.3.2.2
}

/// The transition itself, and what waited for it.
void switch_level(Reception& r, const procedures::level_transition::Result& result) {
  State& s = r.state;
  const Level from = s.level.level;
  enter_level(r, *result.switch_to, result.by_driver);
  r.out.level_switched_to = s.level.level;
  r.out.national_system_only = from == Level::NTC && s.level.level == Level::NTC;
  if (level_2_or_3(from) && !level_2_or_3(s.level.level)) {
    s.reports.rear_border = result.by_driver ? std::optional<Place>{} : result.border.value_or(r.out.here.est_front);
    (result.by_driver ? r.out.level_2_or_3_left_by_driver : r.out.level_2_or_3_left) = true;
  }
  release_buffer(r);
}

}  // namespace

std::optional<procedures::level_transition::Order> order_of(const lang::PacketView& view, SrsVersion srs) {
  procedures::level_transition::Order order;
  if (view.NID_PACKET == packet::conditional_level_transition_order) {
    lang::Packet46 p;
    if (lang::decode(view, p) != lang::Fault::none) return {};
    order.kind = modes::OrderKind::conditional;
    order.table = table_of(p, srs);
    return order;
  }
  lang::Packet41 p;
  if (lang::decode(view, p) != lang::Fault::none) return {};
  order.kind = lang::metres(p.Q_SCALE, p.D_LEVELTR) ? modes::OrderKind::announcement : modes::OrderKind::immediate;
  order.table = table_of(p, srs);
  return order;
}

namespace {

/// An order behind one of the same cycle that is executed is judged from the level to which that one leads (5.10.1.6).
modes::OrderDecision give_further_order(Reception& r, const procedures::level_transition::Order& order) {
  State& s = r.state;
  const modes::AvailableLevels available = available_levels(s, r.in.national_system);
  procedures::level_transition::JudgedOrder& first = *r.order;
  const modes::OrderDecision decision = modes::judge(order.kind, order.table, first.decision.to, s.mode, available);
  if (order.kind == modes::OrderKind::announcement) {
    r.announcement = order;  // judged again when the level is entered
    return decision;
  }
  if (decision.effect != OrderEffect::execute) {
    first.order.table = order.table;  // 5.10.2.9 b
    return decision;
  }
  delete_waiting_of_replaced(r, decision);
  first = {order, decision};
  if (decision.to.same_level(s.level)) first.decision.effect = OrderEffect::none;  // back to the level of now
  r.announcement.reset();
  return first.decision;
}

}  // namespace

modes::OrderDecision give_order(Reception& r, const procedures::level_transition::Order& order) {
  State& s = r.state;
  // The procedure evaluates one order per cycle, the last one; an earlier one of the same cycle is replaced (5.10.1.6).
  if (executes_order(r)) return give_further_order(r, order);
  const modes::OrderDecision decision =
      modes::judge(order.kind, order.table, s.level, s.mode, available_levels(s, r.in.national_system));
  delete_waiting_of_replaced(r, decision);
  r.order = {order, decision};
  r.announcement.reset();
  return decision;
}

void place_border(Reception& r, const lang::PacketView& packet, const track::Reference& reference, Anchor anchor) {
  procedures::level_transition::Order* const order = r.announcement ? &*r.announcement
                                                     : r.order      ? &r.order->order
                                                                    : nullptr;
  if (order == nullptr) return;
  if (order->kind != modes::OrderKind::announcement) {
    // Of a group: the border is there. An order of the RBC has no place.
    order->border = reference.place;
    order->placed = reference.medium == Medium::balise;
    return;
  }
  lang::Packet41 p;
  if (lang::decode(packet, p) != lang::Fault::none) return;
  const std::optional<Distance> D_LEVELTR = lang::metres(p.Q_SCALE, p.D_LEVELTR);
  if (!D_LEVELTR) return;
  order->border = reference.place + *D_LEVELTR;
  order->anchor = anchor;
}

bool executes_order(const Reception& r) { return r.order && r.order->decision.effect == OrderEffect::execute; }

std::optional<modes::OrderedLevel> ordered_level(const Reception& r) {
  std::optional<modes::OrderedLevel> to;
  if (r.state.level_transition.pending) to = r.state.level_transition.pending->to;
  if (r.order) {
    const modes::OrderDecision& decision = r.order->decision;
    if (decision.effect == OrderEffect::announce || decision.effect == OrderEffect::execute)
      to = decision.to;
    else if (decision.cancels_pending)
      to.reset();
  }
  if (to && to->same_level(r.state.level)) to.reset();
  return to;
}

void run_level_transition(Reception& r) {
  State& s = r.state;
  procedures::level_transition::Inputs in;
  in.now = s.now;
  in.mode = s.mode;
  in.current = s.level;
  in.est_front = r.out.here.est_front;
  in.max_safe_front = r.out.here.max_safe_front;
  in.order = r.order ? &*r.order : nullptr;
  in.driver_level = driver_level(r);
  in.available = available_levels(s, r.in.national_system);
  in.acknowledged = r.out.acknowledged.has(Ack::level);
  in.srs = s.srs;
  if (in.driver_level) s.data.level_status = DataStatus::valid;
  const DataStatus status = s.data.level_status;
  const auto result = procedures::level_transition::step(s.level_transition, in);
  r.out.level = result.effects;
  if (result.table) s.level_table = *result.table;
  if (result.overdue)
    r.out.asked.add(*result.overdue == Level::NTC ? brakes::Cause::level_NTC_unacknowledged
                                                  : brakes::Cause::level_0_unacknowledged);
  // An order of this cycle did this when it was received (give_order).
  if (result.cancelled && (result.by_driver || !r.order)) clear_level_buffer(s);
  if (result.switch_to) switch_level(r, result);
  if (result.after_no_power) {  // 4.11.1.4 e: as valid as the level before, by cold movement detection
    s.data.level_status = status;
    if (!valid(status)) s.level_table.reset();
  }
  if (r.announcement)
    procedures::level_transition::announce(
        s.level_transition,
        {*r.announcement, modes::judge(r.announcement->kind, r.announcement->table, s.level, s.mode, in.available)});
}

}  // namespace evc::kernel
