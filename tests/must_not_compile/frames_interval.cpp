// A place interval is made of places on the track.
#include "base/location.h"

using namespace evc;

#ifdef MISTAKE
constexpr PlaceInterval front = PlaceInterval{} - OdometerPlace{};
#else
constexpr PlaceInterval front = PlaceInterval{} - Distance{1.0};
#endif
