#include "procedures/observe.h"

#include "procedures/conditions_of.h"

namespace evc::procedures {
modes::Conditions observe(const Facts& f, SrsVersion srs) {
  modes::Conditions c;
  const auto give = [&c](int n, bool holds) { c.set(n, holds); };
  conditions_of(f, give);
  if (srs == SrsVersion::v4_0_0) conditions_of_4_0_0(f, give);
  return c;
}

}  // namespace evc::procedures
