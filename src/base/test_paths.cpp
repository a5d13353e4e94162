#include "base/test_paths.h"

#include <cstdlib>

#ifndef EVC_COMMAND
#define EVC_COMMAND ""
#endif

namespace evc::test {

std::string source_folder() { return EVC_SOURCE_DIR; }
std::string shared_folder() {
  const char* given = std::getenv("OPENEVC_SHARED");
  return given != nullptr ? given : source_folder() + "/../shared";
}
std::string evc_command() { return EVC_COMMAND; }

}  // namespace evc::test
