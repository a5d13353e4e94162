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
  const kernel::Display* const dmi = printed_.dmi && looked_at ? &on_board_.show() : nullptr;
  std::string at_rest;
  if (printed_.changes && dmi != nullptr) at_rest = io::motionless(*dmi);
  const bool wanted = printed_.changes ? n == 0 || differs(outputs, planning, at_rest) : in_turn;
  if (wanted) io::append_output(text, cycle.t_ms, outputs, planning, names_, dmi);
  if (!printed_.changes) return;
  last_ = outputs;
  last_planning_.reset();
  if (planning != nullptr) last_planning_ = *planning;
  last_dmi_ = std::move(at_rest);
}

}  // namespace evc::run
