#include "procedures/observe.h"

#include "procedures/conditions_of.h"

namespace evc::procedures {
modes::Conditions observe(const Facts& f) {
  modes::Conditions c;
  conditions_of(f, [&c](int n, bool holds) { c.set(n, holds); });
  return c;
}

}  // namespace evc::procedures
