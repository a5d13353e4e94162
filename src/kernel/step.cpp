#include "kernel/cab.h"
#include "kernel/decide/decide.h"
#include "kernel/evc.h"
#include "kernel/examine.h"
#include "kernel/intake/intake.h"
#include "kernel/report/report.h"
#include "kernel/supervise/supervise.h"

namespace evc::kernel {

void power_up(State& state, Derived& derived, const Config& config) noexcept {
  state = State{};
  derived.built = 0;
  state.srs = config.srs;
  state.fitted_levels = config.levels;
  if (config.srs == SrsVersion::v4_0_0)
    state.fitted_levels[static_cast<std::size_t>(Level::L3)] = false;  // 2.6 has none
  state.operated_X = highest_X(config.srs);
  state.radio.newest = lang::newest_version(config.srs);
  state.identity = config.identity;
  state.terminals = config.terminals;
  state.by_train = config.by_train;
  state.dial = config.dial;
  state.displayed.ntc_names = config.ntc_names;
  if (config.contact) {
    state.radio.contact = radio::Rbc{config.contact->NID_C, config.contact->NID_RBC, config.contact->NID_RADIO};
    state.contact_status = DataStatus::invalid;
  }
  state.local_time_offset_min = config.local_time_offset_min;
  state.network.offered = config.networks;
  state.train = config.train;
  state.manoeuvre.train = config.train;
  state.L_engine = config.L_engine;
  state.national_values = config.national_values;
  state.configuration_refused = train::check(config.train) != train::Fault::none ||
                                train::check(config.national_values) != train::Fault::none ||
                                !(config.L_engine.si > 0.0 && config.L_engine.si <= 1000.0);
}

namespace {

/// One cycle: the picture of docs/architecture.md, from top to bottom.
void run_cycle(State& state, Derived& derived, const Inputs& inputs, Outputs& outputs, Examined* seen) {
  reset(outputs);
  const Log log{outputs.events};
  radio::Outbox outbox;
  const Received received = intake(state, derived.scratch, inputs, outbox, log, &outputs.forwarded);
  const Decided decided = decide(state, inputs, received, log, seen);
  const Supervised supervised = supervise(state, derived, inputs.train, decided.here, decided.basis_renewed,
                                          received.acknowledged.has(Ack::brake), log);
  report(state, inputs, received, decided, supervised, outbox, log, outputs);
}

void run_step(State& state, Derived& derived, const Inputs& inputs, Outputs& outputs, Examined* seen) {
  if (!skips_closing(state, inputs.train)) return run_cycle(state, derived, inputs, outputs, seen);
  Inputs closed = inputs;
  closed.train.desk_open = false;
  run_cycle(state, derived, closed, outputs, seen);
}

}  // namespace

void step(State& state, Derived& derived, const Inputs& inputs, Outputs& outputs) noexcept {
  run_step(state, derived, inputs, outputs, nullptr);
}

void examine(State& state, Derived& derived, const Inputs& inputs, Outputs& outputs, Examined& seen) noexcept {
  run_step(state, derived, inputs, outputs, &seen);
}

}  // namespace evc::kernel
