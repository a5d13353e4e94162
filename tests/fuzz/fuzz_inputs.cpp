// Any stream of inputs: every line is consumed or rejected with its number, and the kernel answers every cycle up to
// there. Any file of what is kept without power: it is rejected with its name, or a unit takes it.
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>

#include "io/input_stream.h"
#include "io/output_lines.h"
#include "io/retained_file.h"
#include "kernel/state.h"

namespace {

void try_as_retained(const std::string& text, evc::kernel::State& state, evc::kernel::Derived& derived) {
  const auto retained = evc::io::read_retained(text, "fuzz.json");
  if (!retained) {
    if (retained.error().text().find("fuzz.json") == std::string::npos) std::abort();
    return;
  }
  if (!evc::kernel::power_up(state, derived, {}, *retained)) std::abort();
  if (!evc::io::read_retained(evc::io::retained_text(evc::kernel::retained(state)), "again")) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string text(reinterpret_cast<const char*>(data), size);
  const auto state = std::make_unique<evc::kernel::State>();
  const auto derived = std::make_unique<evc::kernel::Derived>();
  try_as_retained(text, *state, *derived);
  auto stream = evc::io::InputStream::open("fuzz.jsonl", evc::io::lines_of(std::move(text)));
  if (!stream) {
    if (stream.error().text().empty()) std::abort();
    return 0;
  }
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
