#include "sweep/report.h"

#include <string_view>

#include "io/number.h"
#include "io/xml.h"

namespace evc::sweep {

extern const char report_template[];

namespace {

/// A page with more rows would be slow. Of a larger sweep it has every second, third, ... case.
constexpr std::uint64_t kMostRows = 20000;

void append_value(std::string& out, const Value& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value))
    io::append_number(out, *whole);
  else if (const auto* number = std::get_if<double>(&value))
    io::append_number(out, *number);
  else if (const auto* text = std::get_if<std::string>(&value))
    io::append_string(out, *text);
  else
    out += "null";
}

/// The name of a file as one word of a shell.
std::string shell_word(const std::string& name) {
  const bool plain = name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._-/+") ==
                     std::string::npos;
  if (plain && !name.empty()) return name;
  std::string out = "'";
  for (const char c : name) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

}  // namespace

io::Result<std::string> report_page(const Store& store, const std::string& results) {
  const Header& header = store.header();
  const auto counts = store.counts();
  if (!counts) return tl::unexpected(counts.error());
  const std::uint64_t stride = (header.cases + kMostRows - 1) / kMostRows;
  std::string data = "{\"spec\":" + header.spec + ",\"kind\":";
  io::append_string(data, header.kind);
  data += ",\"file\":";
  io::append_string(data, header.spec_file);
  data += ",\"results\":";
  io::append_string(data, shell_word(results));
  data += ",\"version\":";
  io::append_string(data, header.version);
  data += ",\"started\":";
  io::append_string(data, header.started);
  data += ",\"finished\":";
  io::append_string(data, header.finished);
  data += ",\"cases\":" + std::to_string(header.cases) + ",\"done\":" + std::to_string(counts->done) +
          ",\"failed\":" + std::to_string(counts->failed) + ",\"stride\":" + std::to_string(stride) +
          ",\"varied\":" + std::to_string(store.varied()) + ",\"columns\":[";
  for (const std::string& name : store.columns()) {
    if (data.back() != '[') data += ',';
    io::append_string(data, name);
  }
  data += "],\"rows\":[";
  const auto read = store.each(
      [&](const std::vector<Value>& values) {
        data += data.back() == '[' ? "\n[" : ",\n[";
        for (std::size_t i = 0; i < values.size(); ++i) {
          if (i > 0) data += ',';
          append_value(data, values[i]);
        }
        data += ']';
      },
      stride);
  if (!read) return tl::unexpected(read.error());
  data += "]}";
  std::string page = report_template;
  constexpr std::string_view place = "/*DATA*/null";
  page.replace(page.find(place), place.size(), io::json_in_script(std::move(data)));
  return page;
}

}  // namespace evc::sweep
