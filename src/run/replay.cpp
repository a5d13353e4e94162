#include "run/replay.h"

#include <fmt/core.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>

#include "io/file.h"
#include "io/input_stream.h"
#include "io/output_lines.h"
#include "io/outputs_diff.h"
#include "run/on_board.h"

namespace evc::run {
namespace {

int complain(const io::Diagnostic& diagnostic) {
  fmt::print(stderr, "{}\n", diagnostic.text());
  return 2;
}

/// Lines of a file in sequence: a live stream is answered cycle by cycle.
class Lines {
 public:
  static io::Result<std::shared_ptr<Lines>> open(const std::string& file) {
    std::FILE* stream = file == "-" ? stdin : std::fopen(file.c_str(), "rb");
    if (stream == nullptr)
      return tl::unexpected(io::Diagnostic{file, "", std::strerror(errno), "a file that can be read"});
    return std::shared_ptr<Lines>(new Lines(stream));
  }
  ~Lines() {
    if (stream_ != stdin) (void)std::fclose(stream_);
    std::free(buffer_);
  }
  Lines(const Lines&) = delete;
  Lines& operator=(const Lines&) = delete;
  bool next(std::string& line) {
    const auto length = ::getline(&buffer_, &capacity_, stream_);
    if (length < 0) {
      if (std::ferror(stream_) != 0) error_ = errno;
      return false;
    }
    line.assign(buffer_, static_cast<std::size_t>(length));
    if (!line.empty() && line.back() == '\n') line.pop_back();
    return true;
  }
  /// The errno that ended reading before the end of the file; 0: none.
  int error() const { return error_; }

 private:
  explicit Lines(std::FILE* stream) : stream_(stream) {}
  std::FILE* stream_;
  int error_ = 0;
  char* buffer_ = nullptr;
  std::size_t capacity_ = 0;
};

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
  const auto lines = Lines::open(options.input);
  if (!lines) return complain(lines.error());
  auto stream = io::InputStream::open(
      options.input, [source = *lines](std::string& line) { return source->next(line); }, std::move(given));
  const auto cut_off = [&] {
    return io::Diagnostic{options.input, "", std::strerror((*lines)->error()), "a file that can be read"};
  };
  if (!stream) return complain((*lines)->error() != 0 ? cut_off() : stream.error());
  auto out = io::WholeFile::create(options.output);
  if (!out) return complain(out.error());
  const auto replayed = replay_stream(*stream, *out, options);
  const auto written = out->commit();
  if (!replayed) return complain(replayed.error());
  if ((*lines)->error() != 0) return complain(cut_off());
  if (!written) return complain(written.error());
  return 0;
}

int diff(const std::string& a, const std::string& b) {
  const auto text_a = io::read_text(a);
  if (!text_a) return complain(text_a.error());
  const auto text_b = io::read_text(b);
  if (!text_b) return complain(text_b.error());
  const auto found = io::difference(*text_a, a, *text_b, b);
  if (!found) return complain(found.error());
  if (!*found) return 0;
  fmt::print("{}", io::text_of(**found, a, b));
  return 1;
}

}  // namespace evc::run
