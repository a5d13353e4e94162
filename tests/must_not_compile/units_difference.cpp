// A speed is not subtracted from an acceleration.
#include "base/units.h"

using namespace evc;

#ifdef MISTAKE
constexpr auto left = Acceleration{1.0} - Speed{0.5};
#else
constexpr auto left = Acceleration{1.0} - Acceleration{0.5};
#endif
