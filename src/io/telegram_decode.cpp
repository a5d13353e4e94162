#include <cstring>

#include "io/telegram_headers.h"
#include "io/telegram_json.h"
#include "lang/telegram.h"
#include "lang/variable_table.h"
#include "lang/walk.h"

namespace evc::io {
namespace {

using lang::Direction;
using lang::Fault;
using lang::FaultAt;
using lang::PacketLayout;
using lang::Step;
using lang::SystemVersion;
using lang::Versions;

constexpr char kDigits[] = "0123456789ABCDEF";

/// Appends text to a buffer that was made large enough before: a telegram has some hundred bytes.
void put(std::string& out, std::string_view text) { out.append(text); }
void put_number(std::string& out, std::uint64_t n) {
  char text[20];
  char* at = text + sizeof text;
  do {
    *--at = static_cast<char>('0' + n % 10);
    n /= 10;
  } while (n != 0);
  out.append(at, static_cast<std::size_t>(text + sizeof text - at));
}
void put_hex64(std::string& out, std::uint64_t n) {
  char text[16];
  for (int i = 15; i >= 0; --i, n >>= 4) text[i] = kDigits[n & 15u];
  out.append(text, 16);
}
void put_key(std::string& out, const char* name) {
  out += '"';
  out.append(name);
  out.append("\":", 2);
}
void put_member(std::string& out, const char* name, std::uint64_t n) {
  put_key(out, name);
  put_number(out, n);
}
void put_version(std::string& out, SystemVersion sv) {
  put_number(out, sv.x);
  out += '.';
  put_number(out, sv.y);
}
/// Bits [from, to) as hexadecimal digits, left aligned.
void put_hex(std::string& out, std::span<const std::uint8_t> bytes, std::size_t from, std::size_t to) {
  BitReader in(bytes, to, from);
  while (in.left() > 0) {
    const auto bits = static_cast<unsigned>(in.left() < 4 ? in.left() : 4);
    out += kDigits[in.read(bits) << (4 - bits)];
  }
}
bool all_are(std::span<const std::uint8_t> bytes, std::size_t from, std::size_t to, bool one) {
  BitReader in(bytes, to, from);
  while (in.left() > 0) {
    const auto bits = static_cast<unsigned>(in.left() < 32 ? in.left() : 32);
    if (in.read(bits) != (one ? lang::all_ones(bits) : 0)) return false;
  }
  return true;
}

/// The counter N_ITER is not written, others (L_TEXT) are.
bool is_written(const char* counter) { return std::strncmp(counter, "N_ITER", 6) != 0; }

/// Writes the members of one packet or message.
struct JsonWriter {
  std::string& out;
  std::span<const std::uint8_t> bytes;

  void separate() {
    if (out.back() != '{') out += ',';
  }
  void field(const Step& step, std::uint64_t code, std::size_t) {
    separate();
    put_key(out, step.name);
    if (step.bits > 53) {
      out += '"';
      put_hex64(out, code);
      out += '"';
    } else if (step.bits == 16 && std::strcmp(step.variable, "D_REF") == 0) {
      const auto value = static_cast<std::int16_t>(code);
      if (value < 0) out += '-';
      put_number(out, static_cast<std::uint64_t>(value < 0 ? -static_cast<int>(value) : static_cast<int>(value)));
    } else {
      put_number(out, code);
    }
  }
  void begin_group(const Step& step, std::uint64_t count, std::size_t) {
    separate();
    if (is_written(step.counter)) {
      put_member(out, step.counter, count);
      out += ',';
    }
    put_key(out, step.name);
    out += '[';
  }
  void begin_element(std::uint64_t index) { put(out, index == 0 ? "{" : ",{"); }
  void end_element() { out += '}'; }
  void end_group() { out += ']'; }
  void rest(const Step& step, std::size_t bit, std::size_t bits) {
    separate();
    put_key(out, step.name);
    out += '"';
    BitReader in(bytes, bit + bits, bit);
    while (in.left() > 0) out += in.read(1) != 0 ? '1' : '0';
    out += '"';
  }
};

TelegramError error_of(const FaultAt& at) {
  TelegramError error;
  error.bit = at.bit;
  error.packet = at.packet;
  if (at.variable != nullptr) {
    const lang::VariableInfo* info = lang::find_variable(at.variable);
    error.variable = info != nullptr ? info->name : at.variable;
  }
  if (at.fault == Fault::spare_value || (at.variable != nullptr && at.value != 0)) error.value = at.value;
  error.why = lang::text_of(at.fault);
  return error;
}

/// One packet at `bit`; `end` is where the telegram or message ends. Returns the bit after the packet. A packet
/// accepted by scan_...() cannot fail here, but this reader does not rely on it.
tl::expected<std::size_t, FaultAt> put_packet(std::string& out, std::span<const std::uint8_t> bytes, std::size_t bit,
                                              std::size_t end, Direction direction, Versions version) {
  BitReader in(bytes, end, bit);
  const auto nid = static_cast<std::uint8_t>(in.read(8, "NID_PACKET"));
  if (in.faulty()) return tl::unexpected(FaultAt{Fault::truncated, bit, -1, "NID_PACKET", 0});
  const PacketLayout* layout = lang::find_packet_layout(direction, version, nid);
  put(out, "{");
  put_member(out, "NID_PACKET", nid);
  std::size_t packet_end = end;
  const bool has_length = layout == nullptr || layout->has_length;
  if (has_length) {
    if (direction == Direction::to_train) {
      out += ',';
      put_member(out, "Q_DIR", in.read(2, "Q_DIR"));
    }
    const std::size_t at = in.position();
    const std::uint64_t length = in.read(13, "L_PACKET");
    if (in.faulty()) return tl::unexpected(FaultAt{Fault::truncated, in.position(), nid, in.failed_on(), 0});
    if (bit + length < in.position())
      return tl::unexpected(FaultAt{Fault::length_too_small, at, nid, "L_PACKET", length});
    if (bit + length > end) return tl::unexpected(FaultAt{Fault::length_beyond_end, at, nid, "L_PACKET", length});
    out += ',';
    put_member(out, "L_PACKET", length);
    packet_end = bit + length;
  }
  if (layout == nullptr) {
    out.append(",\"raw\":\"");
    put_hex(out, bytes, in.position(), packet_end);
    out.append("\"}");
    return packet_end;
  }
  BitReader inside(bytes, packet_end, in.position());
  JsonWriter writer{out, bytes};
  lang::walk<lang::read_fast>(inside, layout->steps, writer, nullptr, layout->has_direction ? 1 : 0);
  if (inside.faulty())
    return tl::unexpected(FaultAt{has_length ? Fault::length_mismatch : Fault::truncated, inside.position(), nid,
                                  inside.failed_on(), has_length ? packet_end - bit : 0});
  if (has_length && inside.position() != packet_end)
    return tl::unexpected(FaultAt{Fault::length_mismatch, inside.position(), nid, "L_PACKET", packet_end - bit});
  out += '}';
  return inside.position();
}

/// The whole of a balise telegram or loop message that is consistent; `sv`: that of its M_VERSION, also a later Y that
/// is read as the newest known one.
tl::expected<void, FaultAt> put_telegram(std::string& out, std::span<const std::uint8_t> bytes, std::size_t bits,
                                         std::span<const HeaderField> header, SystemVersion sv) {
  put(out, "{\"schema\":\"evc-telegram/1\",\"system_version\":\"");
  put_version(out, sv);
  put(out, "\",\"header\":{");
  BitReader in(bytes, bits);
  for (const HeaderField& f : header) {
    if (f.name != header[0].name) out += ',';
    put_member(out, f.name, in.read(f.bits, f.name));
  }
  put(out, "},\"packets\":[");
  std::size_t at = in.position();
  const Versions version = lang::known_version(sv);
  for (bool first = true;; first = false) {
    BitReader next(bytes, bits, at);
    if (next.left() < 8) return tl::unexpected(FaultAt{Fault::no_end_packet, bits, -1, "NID_PACKET", 0});
    if (next.read(8) == 255) break;
    if (!first) out += ',';
    const auto end = put_packet(out, bytes, at, bits, Direction::to_train, version);
    if (!end) return tl::unexpected(end.error());
    at = *end;
  }
  at += 8;
  put(out, "]");
  // Bits after packet 255 have no meaning (8.4.2.1). Less than a byte of zeros counts as padding of the digits;
  // anything else is kept, so that encoding gives the same bits.
  std::size_t end = bits;
  if (bits > 210 && bits <= 216 && at <= 210 && all_are(bytes, 210, bits, false)) end = 210;
  if (end - at >= 8 || !all_are(bytes, at, end, false)) {
    out += ',';
    put_member(out, "bits", end);
    if (!all_are(bytes, at, end, true)) {
      put(out, ",\"padding\":\"");
      put_hex(out, bytes, at, end);
      out += '"';
    }
  }
  out += '}';
  return {};
}

/// Runs `write`; on error `out` is reset to its old length.
template <class Write>
tl::expected<void, TelegramError> guarded(std::string& out, Write write) {
  const std::size_t before = out.size();
  const tl::expected<void, FaultAt> done = write();
  if (done) return {};
  out.resize(before);
  return tl::unexpected(error_of(done.error()));
}

}  // namespace

tl::expected<void, TelegramError> append_balise_json(std::string& out, std::span<const std::uint8_t> bytes,
                                                     std::size_t bits, Spare spare) {
  // Of the last digit's four bits, 830 bits leave two unused.
  if (bits > 830 && bits <= 832) bits = 830;
  if (bits > 830) return tl::unexpected(TelegramError{830, -1, "", {}, "more than the 830 user bits of a telegram"});
  const lang::TelegramView view =
      lang::scan_telegram(bytes, bits, spare == Spare::refuse ? lang::Check::reading : lang::Check::structure);
  if (view.fault != Fault::none) return tl::unexpected(error_of(view.at));
  return guarded(
      out, [&] { return put_telegram(out, bytes, bits, balise_header, lang::system_version(view.M_VERSION.raw)); });
}

tl::expected<void, TelegramError> append_loop_json(std::string& out, std::span<const std::uint8_t> bytes,
                                                   std::size_t bits, Spare spare) {
  const lang::LoopMessageView view =
      lang::scan_loop_message(bytes, bits, spare == Spare::refuse ? lang::Check::reading : lang::Check::structure);
  if (view.fault != Fault::none) return tl::unexpected(error_of(view.at));
  return guarded(out,
                 [&] { return put_telegram(out, bytes, bits, loop_header, lang::system_version(view.M_VERSION.raw)); });
}

tl::expected<void, TelegramError> append_radio_json(std::string& out, std::span<const std::uint8_t> bytes,
                                                    Direction direction, SystemVersion sv, Spare spare) {
  const lang::Check check = spare == Spare::refuse ? lang::Check::reading : lang::Check::structure;
  std::size_t used = 0;
  FaultAt fault;
  if (direction == Direction::to_train) {
    const lang::MessageToTrainView view = lang::scan_message_to_train(bytes, sv, check);
    fault = view.at;
    used = view.bits_used;
  } else {
    const lang::MessageToTrackView view = lang::scan_message_to_track(bytes, sv, check);
    fault = view.at;
    used = view.bits_used;
  }
  if (fault) return tl::unexpected(error_of(fault));
  return guarded(out, [&]() -> tl::expected<void, FaultAt> {
    BitReader in(bytes);
    const auto nid = static_cast<std::uint8_t>(in.read(8));
    const lang::MessageLayout* layout = lang::find_message_layout(direction, sv, nid);
    if (layout == nullptr) return tl::unexpected(FaultAt{Fault::unknown_message, 0, -1, "NID_MESSAGE", nid});
    put(out, "{");
    put_member(out, "NID_MESSAGE", nid);
    out += ',';
    put_member(out, "L_MESSAGE", in.read(10));
    JsonWriter writer{out, bytes};
    lang::walk<lang::read_fast>(in, layout->steps, writer);
    if (in.faulty()) return tl::unexpected(FaultAt{Fault::truncated, in.position(), -1, in.failed_on(), 0});
    put(out, ",\"packets\":[");
    const Versions version = lang::known_version(sv);
    for (std::size_t at = in.position(); at < used;) {
      if (at != in.position()) out += ',';
      const auto end = put_packet(out, bytes, at, bytes.size() * 8, direction, version);
      if (!end) return tl::unexpected(end.error());
      at = *end;
    }
    put(out, "]");
    if (!all_are(bytes, used, bytes.size() * 8, false)) {
      put(out, ",\"padding\":\"");
      put_hex(out, bytes, used, bytes.size() * 8);
      out += '"';
    }
    out += '}';
    return {};
  });
}

tl::expected<void, TelegramError> append_packet_json(std::string& out, std::span<const std::uint8_t> bytes,
                                                     std::size_t bits, Direction direction, SystemVersion sv,
                                                     Spare spare) {
  const Versions version = lang::known_version(sv);
  if (version == 0) return tl::unexpected(TelegramError{0, -1, "M_VERSION", {}, lang::text_of(Fault::unknown_version)});
  return guarded(out, [&]() -> tl::expected<void, FaultAt> {
    const auto end = put_packet(out, bytes, 0, bits, direction, version);
    if (!end) return tl::unexpected(end.error());
    if (bits - *end >= 8 || !all_are(bytes, *end, bits, false))
      return tl::unexpected(FaultAt{Fault::length_mismatch, *end, bytes[0], "L_PACKET", *end});
    if (spare == Spare::refuse)
      if (const FaultAt at = lang::check_packet(bytes, *end, direction, sv)) return tl::unexpected(at);
    return {};
  });
}

}  // namespace evc::io
