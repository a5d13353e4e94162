// Any description of a line is rejected with its place, or made into a line that its reader accepts.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "io/line_file.h"
#include "io/make_line.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto made = evc::io::make_line(text, "fuzz.json");
  if (!made && made.error().text().find("fuzz.json") == std::string::npos) std::abort();
  if (made && !evc::io::read_line(*made, "made.json")) std::abort();
  return 0;
}
