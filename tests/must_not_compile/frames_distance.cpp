// Places of two frames have no distance.
#include "base/units.h"

using namespace evc;

#ifdef MISTAKE
constexpr Distance d = Place{} - OdometerPlace{};
#else
constexpr Distance d = OdometerPlace{} - OdometerPlace{};
#endif
