// A speed is not compared with a length.
#include "base/units.h"

using namespace evc;

#ifdef MISTAKE
constexpr bool faster = Speed{1.0} < Distance{2.0};
#else
constexpr bool faster = Speed{1.0} < Speed{2.0};
#endif
