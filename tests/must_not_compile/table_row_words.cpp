// A row of a table has as many cells as the page has columns.
// expected: row_cannot_be_read
#include "modes/page.h"

using namespace evc;

#ifdef MISTAKE
constexpr auto row = modes::page::words<3>("U D U U");
#else
constexpr auto row = modes::page::words<3>("U D  U");
#endif
