#include "kernel/intake/driver.h"

namespace evc::kernel {
namespace {

/// The speed of the speed control is shown on the dial (015560 8.2.3.9); it is the driver's who entered it.
void enter_set_speed(Reception& r) {
  State& s = r.state;
  if (!r.in.train.desk_open) s.set_speed.reset();
  const auto& entered = r.in.driver.set_speed;
  if (!entered) return;
  if (!r.in.train.desk_open || !(*entered >= Speed{}) || *entered > s.dial)
    return r.log.note(
        {.what = What::entry_not_enabled, .id = static_cast<std::int32_t>(Entered::set_speed), .clause = "4.7.2"_srs});
  s.set_speed.reset();
  if (*entered > Speed{}) s.set_speed = entered;
}

/// The language of the display; what is no language is not entered.
void enter_language(Reception& r) {
  const auto& chosen = r.in.driver.language;
  if (chosen && chosen->valid() && may_enter(r, driver::Input::language, Entered::language)) r.state.language = *chosen;
}

}  // namespace

void set_display(Reception& r) {
  if (r.out.selected.has(Select::toggle)) r.state.toggled_on = !r.state.toggled_on;
  enter_set_speed(r);
  enter_language(r);
}

}  // namespace evc::kernel
