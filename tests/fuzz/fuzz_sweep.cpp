// Any description of a sweep is rejected with its place, or gives values for every case.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "io/json_pointer.h"
#include "sweep/cases.h"
#include "sweep/spec.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto spec = evc::sweep::read_spec(text, "fuzz.json");
  if (!spec && spec.error().text().find("fuzz.json") == std::string::npos) std::abort();
  if (!spec) return 0;
  const evc::sweep::Cases cases(*spec);
  for (const std::uint64_t number : {std::uint64_t{0}, spec->cases / 2, spec->cases - 1})
    if (number >= spec->cases || cases.values(number).size() != spec->vary.size() ||
        cases.values(number) != cases.values(number))
      std::abort();
  for (const auto& entry : spec->vary)
    if (evc::io::tokens_of(entry.at).empty()) std::abort();
  return 0;
}
