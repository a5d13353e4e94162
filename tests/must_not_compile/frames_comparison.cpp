// A place of the odometer is not compared with a place on the track.
#include "base/units.h"

using namespace evc;

#ifdef MISTAKE
constexpr bool beyond = Place{} < OdometerPlace{};
#else
constexpr bool beyond = Place{} < Place{};
#endif
