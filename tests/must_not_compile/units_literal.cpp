// A literal has its unit.
#include "base/units.h"

using namespace evc;

#ifdef MISTAKE
constexpr Speed v = 50_m;
#else
constexpr Speed v = 50_km_h;
#endif
