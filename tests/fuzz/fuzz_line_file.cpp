// Any line file is read, or rejected with a diagnostic that names the place.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "io/line_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto line = evc::io::read_line(text, "fuzz.json");
  if (!line && line.error().text().find("fuzz.json") == std::string::npos) std::abort();
  if (!line) return 0;
  for (std::size_t i = 1; i < line->balises.size(); ++i)
    if (line->balises[i].position_m < line->balises[i - 1].position_m) std::abort();
  for (const auto& balise : line->balises)
    if (balise.telegram.size > 8 * balise.telegram.bytes.size() || balise.group >= line->groups) std::abort();
  return 0;
}
