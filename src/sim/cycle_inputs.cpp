#include "sim/cycle_inputs.h"

namespace evc::sim {

void CycleInputs::clear() {
  balises.clear();
  loops.clear();
  radio.clear();
  train_data.reset();
  external_train_data.reset();
  levels.external_train_data = {};
  levels.radio_link = RadioLink::unchanged;
  levels.radio_link_with.reset();
  levels.radio_link_of_infill_unit = false;
  levels.driver = {};
  levels.utc.reset();
}

const port::Inputs& CycleInputs::view() {
  balise_views_.clear();
  loop_views_.clear();
  radio_views_.clear();
  for (const Telegram& t : balises) balise_views_.push_back({t.bits.bytes, t.bits.size, t.at, t.passed});
  for (const Bits& l : loops) loop_views_.push_back({l.bytes});
  for (const RadioMessage& r : radio) radio_views_.push_back({r.bytes, r.from, r.infill_unit});
  levels.now = {static_cast<double>(t_ms) / 1000.0};
  levels.balise_telegrams = balise_views_;
  levels.loop_messages = loop_views_;
  levels.radio_messages = radio_views_;
  levels.driver.train_data = train_data ? &*train_data : nullptr;
  levels.external_train_data.data = external_train_data ? &*external_train_data : nullptr;
  return levels;
}

}  // namespace evc::sim
