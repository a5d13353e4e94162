#include "language/encode.h"

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/file.h"
#include "io/json.h"
#include "io/telegram_json.h"
#include "language/airgap.h"

namespace evc::language {
namespace {

using io::complain;
using io::Json;

using Encoded = tl::expected<std::string, io::TelegramError>;

Encoded hex(const tl::expected<io::Bits, io::TelegramError>& bits) {
  if (!bits) return tl::unexpected(bits.error());
  return io::hex_of_bits(bits->bytes, bits->bits);
}

Encoded encode_one(const EncodeOptions& o, const io::EncodeOptions& how, const Json& json) {
  switch (o.what) {
    case What::balise:
      return hex(o.loop ? io::encode_loop_json(json) : io::encode_balise_json(json));
    case What::airgap:
      return hex(encode_airgap_json(json));
    case What::radio:
      return hex(io::encode_radio_json(json, how));
    case What::packet:
      return hex(io::encode_packet_json(json, how));
  }
  return "";
}

/// The end of the JSON value that begins at `from`: the brace or bracket that closes it.
std::size_t end_of_value(std::string_view text, std::size_t from) {
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = from; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\') ++i;
      if (c == '"') in_string = false;
      continue;
    }
    if (c == '"') in_string = true;
    if (c == '{' || c == '[') ++depth;
    if (c == '}' || c == ']') --depth;
    if (depth <= 0) return i + 1;
  }
  return text.size();
}

/// The value `text` of a file, which begins in line `line`. Throws io::ReadError.
Json parse_value(const std::string& name, std::string_view text, std::size_t line) {
  if (text.find('\n') == std::string_view::npos) return io::parse_json(text, name, "line " + std::to_string(line));
  auto json = io::guarded([&] { return io::parse_json(text, name); });
  // Of several lines: read again with the lines before it, for the right line of the error.
  if (!json) return io::parse_json(std::string(line - 1, '\n') + std::string(text), name);
  return *std::move(json);
}

/// The objects of one value: itself, or those of an array. Throws io::ReadError.
std::vector<Json> objects_of(const std::string& name, std::string_view text, std::size_t line) {
  const std::string where = "line " + std::to_string(line);
  if (text.front() != '{' && text.front() != '[')
    throw io::ReadError{{name, where, "no JSON object", "one, or an array of them"}};
  Json value = parse_value(name, text, line);
  if (value.is_object()) return {std::move(value)};
  const io::JsonPlace array(value, name, where);
  if (array.size() == 0) array.fail("an empty array", "at least one JSON object");
  for (std::size_t i = 0; i < array.size(); ++i)
    if (!array[i].is_object()) array[i].fail("a JSON object");
  return std::move(value.get_ref<Json::array_t&>());
}

int encode_text(const EncodeOptions& o, const std::string& name, std::string_view text, io::WholeFile& out) {
  io::EncodeOptions how;
  if (o.to_train) how.direction = lang::Direction::to_train;
  if (o.to_track) how.direction = lang::Direction::to_track;
  if (!o.sv.empty()) {
    how.sv = io::parse_version(o.sv);
    if (!how.sv || lang::known_version(*how.sv) == 0) {
      return complain({"--sv", "", o.sv, "a system version 1.Y, 2.Y or 3.Y"});
    }
  }
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos)
    return complain({name, "", "nothing", "a JSON object"});
  bool all_taken = true;
  std::string answers;
  const auto answer = [&](const Json& json) {
    const Encoded encoded = encode_one(o, how, json);
    answers += encoded ? *encoded : io::error_json(encoded.error());
    answers += '\n';
    all_taken = all_taken && encoded.has_value();
  };
  std::size_t line = 1, counted = 0;  // lines up to `counted`
  for (std::size_t at = 0;;) {
    at = text.find_first_not_of(" \t\r\n", at);
    if (at == std::string_view::npos) break;
    const std::string_view before = text.substr(counted, at - counted);
    line += static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
    counted = at;
    const std::size_t end = end_of_value(text, at);
    const auto objects = io::guarded([&] { return objects_of(name, text.substr(at, end - at), line); });
    if (!objects) return complain(objects.error());
    for (const Json& one : *objects) answer(one);
    if (answers.size() > (1u << 16)) {
      out.write(answers);
      answers.clear();
    }
    at = end;
  }
  out.write(answers);
  return all_taken ? 0 : 1;
}

}  // namespace

int encode(const EncodeOptions& o) {
  auto out = io::WholeFile::create(o.output);
  if (!out) return complain(out.error());
  std::string text;
  std::string name = "JSON";
  if (!o.input.empty() && (o.input.front() == '{' || o.input.front() == '[')) {
    text = o.input;
  } else {
    auto read = io::read_text(o.input, io::kLargestStream);
    if (!read) return complain(read.error());
    text = std::move(*read);
    name = o.input;
  }
  const int code = encode_text(o, name, text, *out);
  if (code == 2) return code;
  const auto done = out->commit();
  return done ? code : complain(done.error());
}

}  // namespace evc::language
