// A speed times a time is a length, nothing else.
#include "base/units.h"

using namespace evc;

#ifdef MISTAKE
constexpr Speed way = Speed{10.0} * Duration{2.0};
#else
constexpr Distance way = Speed{10.0} * Duration{2.0};
#endif
