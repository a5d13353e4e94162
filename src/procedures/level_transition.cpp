#include "procedures/level_transition.h"

#include "modes/mode_properties.h"
#include "modes/stored_information.h"

namespace evc::procedures::level_transition {
namespace {

using modes::OrderedLevel;
using modes::OrderEffect;

/// PT and RV belong to levels 1 to 3 (4.4), and no change of level leads out of them (4.6.2): a transition to another
/// level waits until the mode is left. 4.0.0 leads out of PT: [77] to [79].
bool waits(Mode mode, const OrderedLevel& to, SrsVersion srs) {
  const bool stays = mode == Mode::RV || (mode == Mode::PT && srs != SrsVersion::v4_0_0);
  return stays && !modes::possible_in(mode, to.level);
}

/// The pending transition ends, and an acknowledgement given ahead of it, or in answer to what is shown for it: it
/// counts for no other (5.10.4.1.3).
void drop_pending(State& state) {
  state.pending.reset();
  state.acknowledged = state.asked_ahead = false;
  if (!state.unacknowledged) state.shown = false;
}

/// The level that was entered is acknowledged no more: what was shown for it is for no other.
void end_request(State& state) {
  if (state.unacknowledged) state.shown = false;
  state.unacknowledged = false;
}

/// The transition is executed in this cycle.
void execute(State& state, const Inputs& in, const OrderedLevel& to, Result& out) {
  out.switch_to = to;
  end_request(state);
  const bool needed = !out.after_no_power && modes::acknowledgement_needed(in.current, to, in.mode, in.srs);
  // 5.10.4.3: within T_ACK after the transition, unless the driver acknowledged before.
  state.unacknowledged = needed && !state.acknowledged;
  state.unacknowledged_level = to.level;
  state.deadline = in.now + T_ACK;
  drop_pending(state);
}

/// 5.10.2.9, 5.10.2.10 a: the table of an announcement applies from its place on, that of another order at once; one
/// that waited is deleted.
void take_table(State& state, const Order& order, const modes::OrderDecision& decision, Result& out) {
  if (decision.effect == OrderEffect::rejected) return;
  state.announced_table.reset();
  if (order.kind == modes::OrderKind::announcement)
    state.announced_table = AnnouncedTable{order.border, order.table, order.anchor};
  else
    out.table = order.table;
}

void take(State& state, const Inputs& in, const Order& order, const modes::OrderDecision& decision, Result& out) {
  if (decision.effect == OrderEffect::keep_until_mode_left ||
      (decision.effect == OrderEffect::execute && waits(in.mode, decision.to, in.srs))) {
    state.kept = true;  // only one, the newest (4.4.8.1.5)
    state.kept_order = order;
    return;
  }
  if (decision.effect != OrderEffect::rejected) state.kept = false;  // one that waited is older (5.10.1.6)
  take_table(state, order, decision, out);
  // An acknowledgement for the same level stays valid when the order is repeated (5.10.4.1.3, 5.10.4.1.4).
  const bool same = state.pending.has_value() && state.pending->to.same_level(decision.to);
  if (decision.cancels_pending && state.pending.has_value()) {
    out.cancelled = !same;
    if (same)
      state.pending.reset();
    else
      drop_pending(state);
  }
  if (decision.effect == OrderEffect::announce) {
    state.pending = modes::PendingTransition{decision.to, order.border, order.anchor};
    // 5.10.4.1.3: where the place of the acknowledgement lies ahead, the driver is asked there again.
    if (!modes::in_acknowledgement_length(*state.pending, in.max_safe_front))
      state.acknowledged = state.asked_ahead = false;
  } else if (decision.effect == OrderEffect::execute) {
    execute(state, in, decision.to, out);
    if (order.placed) out.border = order.border;
  }
}

/// 5.10.4: asks for the acknowledgement, before or after the transition.
void ask(State& state, const Inputs& in, const OrderedLevel& current, Result& out) {
  // 5.10.4.1.2 of 4.0.0: in SB only at the transition; 3.x does not say.
  const bool only_at_change = in.srs == SrsVersion::v4_0_0 && in.mode == Mode::SB;
  const bool needed = state.pending.has_value() && !only_at_change &&
                      modes::acknowledgement_needed(current, state.pending->to, in.mode, in.srs);
  // Once shown, the request stays, also where the place at which it began lies ahead again (A.3.5.1).
  if (needed && modes::in_acknowledgement_length(*state.pending, in.max_safe_front)) state.asked_ahead = true;
  const bool ahead = needed && state.asked_ahead && !state.acknowledged;
  // Only an acknowledgement that was asked for counts, and for the level that was shown: where an order of this cycle
  // has changed it, the driver is asked anew.
  if (in.acknowledged && state.shown) {
    if (state.unacknowledged)
      state.unacknowledged = false;
    else if (ahead)
      state.acknowledged = true;
  }
  state.shown = state.unacknowledged || (ahead && !state.acknowledged);
  out.effects.requests.add(Ack::level, state.shown);
  if (state.unacknowledged && in.now >= state.deadline) {
    out.overdue = state.unacknowledged_level;
  }
}

}  // namespace

Result step(State& state, const Inputs& in) {
  Result out;
  if (in.order != nullptr) {
    take(state, in, in.order->order, in.order->decision, out);
  } else if (state.kept && in.mode != Mode::NP) {
    out.after_no_power = state.kept_without_power;
    state.kept_without_power = false;
    state.kept = false;  // take() keeps it again as long as the mode is SH or PS
    const Order& order = state.kept_order;
    take(state, in, order, modes::judge(order.kind, order.table, in.current, in.mode, in.available), out);
  }
  if (state.announced_table.has_value() && in.est_front >= state.announced_table->border) {
    out.table = state.announced_table->table;
    state.announced_table.reset();
  }
  if (state.pending.has_value() && modes::border_reached(*state.pending, in.est_front) &&
      !waits(in.mode, state.pending->to, in.srs)) {
    const modes::PendingTransition due = *state.pending;
    if (due.to.same_level(in.current)) {
      drop_pending(state);
    } else {
      execute(state, in, due.to, out);
      out.border = due.border;
    }
  }
  if (!out.switch_to.has_value() && in.driver_level.has_value() && !in.driver_level->same_level(in.current)) {
    out.switch_to = in.driver_level;
    out.by_driver = true;
    end_request(state);
    if (in.srs == SrsVersion::v4_0_0) {
      out.cancelled = state.pending.has_value();
      drop_pending(state);
      state.announced_table.reset();  // 5.10.2.10 b
    }
  }
  const OrderedLevel current = out.switch_to.value_or(in.current);
  ask(state, in, current, out);
  out.announced = state.pending.has_value() && modes::announced_to_driver(*state.pending, current);
  return out;
}

void announce(State& state, const JudgedOrder& announcement) {
  Result none;
  take(state, {}, announcement.order, announcement.decision, none);
}

namespace {

void forget_announcement(State& state) {
  drop_pending(state);
  state.announced_table.reset();  // 5.10.2.10 b
}

}  // namespace

void forget_order(State& state) {
  forget_announcement(state);
  state.kept = false;
}

void turn(State& state) {
  forget_announcement(state);
  state.kept_order.placed = false;
}

void on_mode_change(State& state, Mode from, Mode to, SrsVersion srs) {
  using modes::Fate;
  if (modes::on_entry(to, from, Stored::level_transition_order, srs) == Fate::deleted) forget_announcement(state);
  if (modes::kept_level_order_on_entry(to, from, srs) == Fate::deleted) state.kept = false;
  state.kept_without_power = state.kept && (to == Mode::NP || state.kept_without_power);
  switch (to) {  // 4.12 of 4.0.0: the brake command that waits for the acknowledgement is revoked
    case Mode::NP:
    case Mode::SB:
    case Mode::PS:
    case Mode::SH:
    case Mode::SM:
    case Mode::SL:
    case Mode::NL:
    case Mode::TR:
    case Mode::PT:  // the driver cannot acknowledge it there (4.7.2): of a change from NTC, up to 3.6.0
    case Mode::RV:
    case Mode::SF:
    case Mode::IS:
      end_request(state);
      break;
    default:
      break;
  }
}

}  // namespace evc::procedures::level_transition
