// Any scenario is read, or rejected with a diagnostic that names the place.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "script.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto file = evc::scenario::read(text, "fuzz.scenario");
  if (!file && file.error().text().find("fuzz.scenario: line ") == std::string::npos) std::abort();
  if (!file) return 0;
  for (const auto& scenario : file->scenarios)
    if (scenario.name.empty() || scenario.statements.empty()) std::abort();
  return 0;
}
