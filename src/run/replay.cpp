#include "run/replay.h"

#include <fmt/core.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>

#include "io/file.h"
#include "io/input_stream.h"
#include "io/outputs_diff.h"
#include "io/retained_file.h"
#include "run/answers.h"
#include "run/on_board.h"
#include "run/stream.h"

namespace evc::run {
namespace {

using io::complain;

/// A file, and not found only at the end that it cannot be written.
io::Result<bool> can_be_kept(const std::string& persistent) {
  if (persistent.empty()) return true;
  if (persistent == "-") return tl::unexpected(io::Diagnostic{persistent, "", "standard input", "a file"});
  const std::filesystem::path folder = std::filesystem::path(persistent).parent_path();
  return io::can_be_written_in(folder.empty() ? "." : folder.string());
}

/// The unit of the stream, with what another one kept in the file of --persistent.
io::Result<std::unique_ptr<OnBoard>> unit_of(const io::InputStream& stream, const std::string& persistent) {
  const kernel::Config config = stream.configuration().for_kernel();
  std::error_code error;
  if (persistent.empty() || std::filesystem::status(persistent, error).type() == std::filesystem::file_type::not_found)
    return std::make_unique<OnBoard>(config);
  const auto retained = load_retained(persistent);
  if (!retained) return tl::unexpected(retained.error());
  return std::make_unique<OnBoard>(config, *retained);
}

/// Nothing without --persistent.
io::Result<bool> keep(const OnBoard& on_board, const std::string& persistent) {
  if (persistent.empty()) return true;
  return io::write_whole(persistent, io::retained_text(on_board.retained()));
}

/// Answers every cycle of the stream. After an error the outputs up to there are complete.
io::Result<bool> replay_stream(io::InputStream& stream, OnBoard& on_board, io::WholeFile& out,
                               const ReplayOptions& options) {
  constexpr std::size_t block = 1 << 16;
  sim::CycleInputs cycle;
  bool powered = true;
  Answers answers(on_board, stream.configuration().ntc_names, options);
  std::string text;
  const bool live = options.input == "-";
  for (;;) {
    const auto more = stream.next(cycle);
    if (!more || !*more) {
      out.write(text);
      return more;
    }
    answers.append(text, cycle);
    const bool goes_off = powered && !cycle.levels.train.powered;
    powered = cycle.levels.train.powered;
    if (goes_off)
      if (const auto kept = keep(on_board, options.persistent); !kept) {
        out.write(text);
        return kept;
      }
    if (text.size() < block && !live) continue;
    out.write(text);
    text.clear();
    if (live && options.output == "-") std::fflush(stdout);
  }
}

}  // namespace

int replay(const ReplayOptions& options) {
  for (const std::string& input : {options.input, options.config, options.persistent})
    if (const auto apart = io::not_the_input(input, options.output); !apart) return complain(apart.error());
  for (const std::string& input : {options.input, options.config})
    if (const auto apart = io::not_the_input(input, options.persistent); !apart) return complain(apart.error());
  if (const auto possible = can_be_kept(options.persistent); !possible) return complain(possible.error());
  auto stream = open_stream(options.input, options.config);
  if (!stream) return complain(stream.error());
  auto on_board = unit_of(*stream, options.persistent);
  if (!on_board) return complain(on_board.error());
  auto out = io::WholeFile::create(options.output);
  if (!out) return complain(out.error());
  const auto replayed = replay_stream(*stream, **on_board, *out, options);
  const auto written = out->commit();
  if (!replayed) return complain(of_stream(replayed.error(), options.input));
  if (!written) return complain(written.error());
  if (const auto kept = keep(**on_board, options.persistent); !kept) return complain(kept.error());
  return 0;
}

int diff(const std::string& a, const std::string& b) {
  if (a == "-" && b == "-") return complain({"-", "", "standard input twice", "it once"});
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
