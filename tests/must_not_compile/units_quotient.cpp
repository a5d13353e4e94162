// A length by a time is a speed, not an acceleration.
#include "base/units.h"

using namespace evc;

#ifdef MISTAKE
constexpr Acceleration v = Distance{10.0} / Duration{2.0};
#else
constexpr Speed v = Distance{10.0} / Duration{2.0};
#endif
