#include "openevc/language.h"

#include <utility>

#include "io/json.h"
#include "io/telegram_json.h"

namespace evc::language {
namespace {

lang::Direction of(Direction direction) {
  return direction == Direction::to_track ? lang::Direction::to_track : lang::Direction::to_train;
}
lang::SystemVersion of(Version version) { return {version.X, version.Y}; }

Error of(io::TelegramError error) {
  return {error.bit, error.packet, std::move(error.variable), error.value, std::move(error.why)};
}
Error because(std::string why) { return {0, -1, {}, {}, std::move(why)}; }

Bits of(tl::expected<io::Bits, io::TelegramError> bits) {
  if (!bits) return {{}, 0, of(std::move(bits.error()))};
  return {std::move(bits->bytes), bits->bits, {}};
}

bool known(Version version) { return lang::known_version(of(version)) != 0; }
constexpr const char* kVersions = "a system version 1.Y, 2.Y or 3.Y is expected";

}  // namespace

Text decode(std::span<const std::uint8_t> bytes, std::size_t bits, const Reading& reading) {
  if (bits > bytes.size() * 8) return {{}, because("more bits than the bytes hold")};
  const bool alone = reading.form == Form::radio || reading.form == Form::packet;
  if (alone && !known(reading.version)) return {{}, because(kVersions)};
  const io::Spare spare = reading.tolerant ? io::Spare::accept : io::Spare::refuse;
  Text text;
  tl::expected<void, io::TelegramError> done;
  switch (reading.form) {
    case Form::balise:
      done = io::append_balise_json(text.json, bytes, bits, spare);
      break;
    case Form::loop:
      done = io::append_loop_json(text.json, bytes, bits, spare);
      break;
    case Form::radio:
      done = io::append_radio_json(text.json, bytes.first((bits + 7) / 8), of(reading.direction), of(reading.version),
                                   spare);
      break;
    case Form::packet:
      done = io::append_packet_json(text.json, bytes, bits, of(reading.direction), of(reading.version));
      break;
  }
  if (!done) return {{}, of(std::move(done.error()))};
  return text;
}

Bits encode(std::string_view json, const Writing& writing) {
  const auto read = io::guarded([&] { return io::parse_json(json, "JSON"); });
  if (!read) return {{}, 0, because(read.error().text())};
  const io::Json& object = *read;
  if (writing.version && !known(*writing.version)) return {{}, 0, because(kVersions)};
  io::EncodeOptions options;
  if (writing.direction) options.direction = of(*writing.direction);
  if (writing.version) options.sv = of(*writing.version);
  switch (writing.form) {
    case Form::balise:
      return of(io::encode_balise_json(object));
    case Form::loop:
      return of(io::encode_loop_json(object));
    case Form::radio:
      return of(io::encode_radio_json(object, options));
    case Form::packet:
      return of(io::encode_packet_json(object, options));
  }
  return {{}, 0, because("no such form")};
}

Bits bits_of_hex(std::string_view hex) { return of(io::bits_of_hex(hex)); }

std::string hex_of_bits(std::span<const std::uint8_t> bytes, std::size_t bits) {
  return io::hex_of_bits(bytes, bits < bytes.size() * 8 ? bits : bytes.size() * 8);
}

}  // namespace evc::language
