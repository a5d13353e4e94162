// A length is not converted to a number implicitly.
#include "base/units.h"

using namespace evc;

#ifdef MISTAKE
constexpr double metres = Distance{5.0};
#else
constexpr double metres = Distance{5.0}.si;
#endif
