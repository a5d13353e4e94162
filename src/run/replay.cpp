#include "run/replay.h"

#include <fmt/core.h>

#include <cstdio>
#include <memory>
#include <string>

#include "io/file.h"
#include "io/input_stream.h"
#include "io/output_lines.h"
#include "io/outputs_diff.h"
#include "run/on_board.h"

namespace evc::run {
namespace {

using io::complain;

/// Answers every cycle of the stream. After an error the outputs up to there are complete.
io::Result<bool> replay_stream(io::InputStream& stream, io::WholeFile& out, const ReplayOptions& options) {
  constexpr std::size_t block = 1 << 16;
  OnBoard on_board(stream.configuration().for_kernel());
  sim::CycleInputs cycle;
  kernel::Outputs last;
  std::string text;
  const bool live = options.input == "-";
  for (std::int64_t n = 0;; ++n) {
    const auto more = stream.next(cycle);
    if (!more || !*more) {
      out.write(text);
      return more;
    }
    const kernel::Outputs& outputs = on_board.step(cycle.view());
    const bool wanted = options.changes ? n == 0 || io::differ_beyond_motion(last, outputs) : n % options.every == 0;
    if (wanted) io::append_output(text, cycle.t_ms, outputs);
    if (options.changes) last = outputs;
    if (text.size() < block && !live) continue;
    out.write(text);
    text.clear();
    if (live && options.output == "-") std::fflush(stdout);
  }
}

}  // namespace

int replay(const ReplayOptions& options) {
  for (const std::string& input : {options.input, options.config})
    if (const auto apart = io::not_the_input(input, options.output); !apart) return complain(apart.error());
  std::optional<io::Configuration> given;
  if (!options.config.empty()) {
    const auto text = io::read_text(options.config);
    if (!text) return complain(text.error());
    auto configuration = io::read_configuration(*text, options.config);
    if (!configuration) return complain(configuration.error());
    given = *std::move(configuration);
  }
  const auto lines = std::make_shared<io::Lines>(options.input);
  auto stream = io::InputStream::open(
      options.input, [lines](std::string& line) { return lines->next(line); }, std::move(given));
  if (!stream) return complain(stream.error());
  auto out = io::WholeFile::create(options.output);
  if (!out) return complain(out.error());
  const auto replayed = replay_stream(*stream, *out, options);
  const auto written = out->commit();
  if (!replayed) return complain(replayed.error());
  if (!written) return complain(written.error());
  return 0;
}

int diff(const std::string& a, const std::string& b) {
  const auto text_a = io::read_text(a, io::kLargestStream);
  if (!text_a) return complain(text_a.error());
  const auto text_b = io::read_text(b, io::kLargestStream);
  if (!text_b) return complain(text_b.error());
  const auto found = io::difference(*text_a, a, *text_b, b);
  if (!found) return complain(found.error());
  if (!*found) return 0;
  fmt::print("{}", io::text_of(**found, a, b));
  return 1;
}

}  // namespace evc::run
