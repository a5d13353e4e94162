// The square of a speed is not a speed.
#include "base/units.h"

using namespace evc;

#ifdef MISTAKE
constexpr Speed v2 = Speed{10.0} * Speed{10.0};
#else
constexpr SpeedSquared v2 = Speed{10.0} * Speed{10.0};
#endif
