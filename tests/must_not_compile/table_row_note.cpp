// A footnote of a row is a number in brackets.
// expected: row_cannot_be_read
#include "modes/page.h"

using namespace evc;

#ifdef MISTAKE
constexpr auto row = modes::page::notes("A[3");
#else
constexpr auto row = modes::page::notes("A[3]");
#endif
