#include "language/describe.h"

#include <fmt/core.h>

#include <charconv>
#include <memory>
#include <string>

#include "io/file.h"
#include "io/telegram_explain.h"

namespace evc::language {
namespace {

io::Result<std::string> found(const std::string& text, const std::string& what, const std::string& id) {
  if (!text.empty()) return text;
  const std::string command = "evc describe " + what;
  return tl::unexpected(io::Diagnostic{command, "", id, "one that `" + command + "` lists"});
}

int print(const io::Result<std::string>& text) {
  if (!text) return io::complain(text.error());
  const auto written = io::write_whole("-", *text);
  return written ? 0 : io::complain(written.error());
}

int number_of(const std::string& id) {
  int n = -1;
  const auto [end, error] = std::from_chars(id.data(), id.data() + id.size(), n);
  return error == std::errc{} && end == id.data() + id.size() && n >= 0 && n <= 255 ? n : -1;
}

}  // namespace

io::Result<std::string> packets_text(const DescribeOptions& o) {
  if (o.index) return found(io::packet_index_page(), "packets", "");
  if (o.id.empty()) return found(io::list_packets(), "packets", "");
  const int n = number_of(o.id);
  if (n < 0) return found("", "packets", o.id);
  const auto nid = static_cast<std::uint8_t>(n);
  std::string text;
  if (!o.to_track) text += io::describe_packet(nid, lang::Direction::to_train, o.markdown);
  if (!o.to_train) text += (text.empty() ? "" : "\n") + io::describe_packet(nid, lang::Direction::to_track, o.markdown);
  if (text == "\n") text.clear();
  return found(text, "packets", o.id);
}

io::Result<std::string> messages_text(const DescribeOptions& o) {
  if (o.id.empty()) return found(io::list_messages(), "messages", "");
  const int n = number_of(o.id);
  return found(n < 0 ? "" : io::describe_message(static_cast<std::uint8_t>(n), o.markdown), "messages", o.id);
}

io::Result<std::string> variables_text(const DescribeOptions& o) {
  if (o.id.empty()) return found(io::list_variables(), "variables", "");
  return found(io::describe_variable(o.id, o.markdown), "variables", o.id);
}

int describe_packets(const DescribeOptions& options) { return print(packets_text(options)); }
int describe_messages(const DescribeOptions& options) { return print(messages_text(options)); }
int describe_variables(const DescribeOptions& options) { return print(variables_text(options)); }
int describe_schema() { return print(io::telegram_schema()); }

}  // namespace evc::language
