// A place is not a length.
#include "base/units.h"

using namespace evc;

#ifdef MISTAKE
constexpr Distance d = Place{};
#else
constexpr Distance d = Place{} - Place{};
#endif
