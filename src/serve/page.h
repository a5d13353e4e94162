#pragma once
#include <string>

namespace evc::serve {

/// The page at `/`: that of the cab as `make cab` has compiled it, with no line and no train, so that it is the display
/// and the desk of the unit at `/unit?dmi`. Where it was not compiled, a page that sends lines and says how to get it.
std::string page();

}  // namespace evc::serve
