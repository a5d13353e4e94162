// A bare number is not a length.
#include "base/units.h"

using namespace evc;

#ifdef MISTAKE
constexpr Distance d = 5.0;
#else
constexpr Distance d{5.0};
#endif
