// A length and a time are not added.
#include "base/units.h"

using namespace evc;

#ifdef MISTAKE
constexpr auto sum = Distance{1.0} + Duration{2.0};
#else
constexpr auto sum = Distance{1.0} + Distance{2.0};
#endif
