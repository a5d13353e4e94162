// Any stream of inputs: every line is consumed or rejected with its number, and the kernel answers every cycle up to
// there.
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>

#include "io/input_stream.h"
#include "io/output_lines.h"
#include "kernel/state.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string text(reinterpret_cast<const char*>(data), size);
  auto stream = evc::io::InputStream::open("fuzz.jsonl", evc::io::lines_of(std::move(text)));
  if (!stream) {
    if (stream.error().text().empty()) std::abort();
    return 0;
  }
  const auto state = std::make_unique<evc::kernel::State>();
  const auto derived = std::make_unique<evc::kernel::Derived>();
  const auto outputs = std::make_unique<evc::kernel::Outputs>();
  evc::kernel::power_up(*state, *derived, stream->configuration().for_kernel());
  evc::sim::CycleInputs cycle;
  std::string line;
  // A distant time would give many cycles: some are enough.
  for (int n = 0; n < 300; ++n) {
    const auto more = stream->next(cycle);
    if (!more && more.error().text().find("line ") == std::string::npos) std::abort();
    if (!more || !*more) break;
    evc::kernel::step(*state, *derived, cycle.view(), *outputs);
    line.clear();
    evc::io::append_output(line, cycle.t_ms, *outputs);
    if (line.empty() || line.back() != '\n') std::abort();
  }
  return 0;
}
