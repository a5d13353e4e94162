#include "run/answers.h"

#include "io/display_json.h"

namespace evc::run {

bool Answers::differs(const kernel::Outputs& outputs, const kernel::Planning* planning, const std::string& dmi) const {
  return io::differ_beyond_motion(last_, outputs) ||
         io::differ_beyond_motion(last_planning_ ? &*last_planning_ : nullptr, planning) || last_dmi_ != dmi;
}

void Answers::append(std::string& text, sim::CycleInputs& cycle) {
  const kernel::Outputs& outputs = on_board_.step(cycle.view());
  const std::int64_t n = cycles_++;
  const bool in_turn = n % printed_.every == 0;
  const bool looked_at = printed_.changes || in_turn;
  const kernel::Planning* const planning = printed_.planning && looked_at ? on_board_.plan() : nullptr;
  // Of every cycle: a sound comes from what changes.
  const kernel::Display* const dmi = printed_.dmi ? &on_board_.show() : nullptr;
  if (dmi != nullptr) display_->append(sounds_, *dmi);
  std::string at_rest;
  if (printed_.changes && dmi != nullptr) at_rest = io::motionless(*dmi);
  const bool wanted = printed_.changes ? n == 0 || !sounds_.empty() || differs(outputs, planning, at_rest) : in_turn;
  if (wanted) {
    io::append_output(text, cycle.t_ms, outputs, planning, names_, dmi, sounds_);
    sounds_.clear();
  }
  if (!printed_.changes) return;
  last_ = outputs;
  last_planning_.reset();
  if (planning != nullptr) last_planning_ = *planning;
  last_dmi_ = std::move(at_rest);
}

}  // namespace evc::run
