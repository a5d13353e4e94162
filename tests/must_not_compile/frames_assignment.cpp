// A place on the track is not kept as a place of the odometer.
#include "base/location.h"

using namespace evc;

#ifdef MISTAKE
constexpr OdometerReading reading{Place{}, {}, {}};
#else
constexpr OdometerReading reading{OdometerPlace{}, {}, {}};
#endif
