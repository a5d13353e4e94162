// Two places are not added.
#include "base/units.h"

using namespace evc;

#ifdef MISTAKE
constexpr Place p = Place{} + Place{};
#else
constexpr Place p = Place{} + Distance{1.0};
#endif
