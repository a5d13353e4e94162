#include "language/encode.h"

#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "io/file.h"
#include "io/telegram_json.h"
#include "language/airgap.h"

namespace evc::language {
namespace {

using Json = nlohmann::json;

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

int encode_text(const EncodeOptions& o, const std::string& name, std::string_view text, io::WholeFile& out) {
  io::EncodeOptions how;
  if (o.to_train) how.direction = lang::Direction::to_train;
  if (o.to_track) how.direction = lang::Direction::to_track;
  if (!o.sv.empty()) {
    how.sv = io::parse_version(o.sv);
    if (!how.sv || lang::known_version(*how.sv) == 0) {
      fmt::print(stderr, "--sv: found {}, expected a system version 1.Y or 2.Y\n", o.sv);
      return 2;
    }
  }
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    fmt::print(stderr, "{}: found nothing, expected a JSON object\n", name);
    return 2;
  }
  bool all_taken = true;
  std::string answers;
  const auto answer = [&](const Json& json) {
    const Encoded encoded = encode_one(o, how, json);
    answers += encoded ? *encoded : io::error_json(encoded.error());
    answers += '\n';
    all_taken = all_taken && encoded.has_value();
  };
  for (std::size_t at = 0;;) {
    at = text.find_first_not_of(" \t\r\n", at);
    if (at == std::string_view::npos) break;
    const std::size_t end = end_of_value(text, at);
    const Json json = Json::parse(text.substr(at, end - at), nullptr, false);
    if (json.is_discarded()) {
      const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
      fmt::print(stderr, "{}: line {}: found no JSON object, expected one\n", name, line);
      return 2;
    }
    if (json.is_array())
      for (const Json& one : json) answer(one);
    else
      answer(json);
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
  if (!out) {
    fmt::print(stderr, "{}\n", out.error().text());
    return 2;
  }
  std::string text;
  std::string name = "JSON";
  if (!o.input.empty() && (o.input.front() == '{' || o.input.front() == '[')) {
    text = o.input;
  } else {
    auto read = io::read_text(o.input);
    if (!read) {
      fmt::print(stderr, "{}\n", read.error().text());
      return 2;
    }
    text = std::move(*read);
    name = o.input;
  }
  const int code = encode_text(o, name, text, *out);
  if (code == 2) return code;
  if (const auto done = out->commit(); !done) {
    fmt::print(stderr, "{}\n", done.error().text());
    return 2;
  }
  return code;
}

}  // namespace evc::language
