#include "run/stream.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>
#include <system_error>

#include "io/file.h"
#include "io/json.h"
#include "io/retained_file.h"

namespace evc::run {
namespace {

/// A stream that evc run or replay printed: each line has what the unit answered.
bool is_of_outputs(std::string_view text) {
  return text.substr(0, text.find('\n')).find("\"brake_reasons\":") != std::string_view::npos;
}

}  // namespace

io::Result<io::InputStream> open_stream(const std::string& input, const std::string& config) {
  std::optional<io::Configuration> given;
  if (!config.empty()) {
    const auto text = io::read_text(config);
    if (!text) return tl::unexpected(text.error());
    auto configuration = io::read_configuration(*text, config);
    if (!configuration) return tl::unexpected(configuration.error());
    given = *std::move(configuration);
  }
  const auto lines = std::make_shared<io::Lines>(input);
  auto stream = io::InputStream::open(
      input, [lines](std::string& line) { return lines->next(line); }, std::move(given));
  if (!stream) return tl::unexpected(of_stream(stream.error(), input));
  if (stream->empty()) return tl::unexpected(no_input(input));
  return stream;
}

io::Diagnostic no_input(const std::string& input) {
  return {input, "", "no input", "a line with t_ms, as {\"t_ms\":0}"};
}

io::Result<kernel::Retained> load_retained(const std::string& file) {
  const auto text = io::read_text(file);
  if (!text) return tl::unexpected(text.error());
  return io::read_retained(*text, file);
}

io::Diagnostic of_stream(const io::Diagnostic& error, const std::string& input) {
  std::error_code none;
  if (!std::filesystem::is_regular_file(input, none)) return error;  // what came through a pipe cannot be read again
  constexpr const char* kExpected = "a stream of inputs, as inputs.jsonl of evc run";
  const auto text = io::read_text(input);
  if (text && is_of_outputs(*text)) return {input, "line 1", "a line of outputs", kExpected};
  const std::string schema = text ? io::schema_of(*text) : "";
  if (io::use_of(schema).empty()) return error;
  return {input, "/schema", io::quoted_kind(schema), kExpected};
}

}  // namespace evc::run
