#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <nlohmann/json.hpp>

#include "base/bit_cursor.h"
#include "io/telegram_headers.h"
#include "io/telegram_json.h"
#include "lang/layouts.h"
#include "lang/walk.h"

namespace evc::io {
namespace {

using Json = nlohmann::json;
using lang::Direction;
using lang::PacketLayout;
using lang::Step;
using lang::SystemVersion;
using lang::Versions;

TelegramError complaint(std::string variable, std::string why, int packet = -1) {
  return {0, packet, std::move(variable), {}, std::move(why)};
}

/// Thrown and caught inside this file only.
struct Refused {
  TelegramError error;
};
[[noreturn]] void refuse(std::string variable, std::string why, std::optional<std::uint64_t> value = {}) {
  Refused refused{complaint(std::move(variable), std::move(why))};
  refused.error.value = value;
  throw refused;
}
std::string found_not(std::uint64_t found, std::uint64_t expected) {
  return "found " + std::to_string(found) + ", expected " + std::to_string(expected);
}

std::optional<std::uint64_t> hex_number(const std::string& text) {
  std::string_view digits = text;
  if (digits.starts_with("0x") || digits.starts_with("0X")) digits.remove_prefix(2);
  std::uint64_t n = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), n, 16);
  if (digits.empty() || error != std::errc{} || end != digits.data() + digits.size()) return {};
  return n;
}

/// The raw code of a member: a number (negative for D_REF), or, where a JSON number may not be exact, a string of
/// hexadecimal digits.
std::uint64_t code_of(const Json& value, const char* name, unsigned bits) {
  std::uint64_t code = 0;
  if (value.is_number_unsigned()) {
    code = value.get<std::uint64_t>();
  } else if (value.is_number_integer()) {
    const auto n = value.get<std::int64_t>();
    if (n < 0 && (std::strcmp(name, "D_REF") != 0 || n < -32768)) refuse(name, "less than 0");
    code = n < 0 ? static_cast<std::uint64_t>(n) & 0xFFFFu : static_cast<std::uint64_t>(n);
  } else if (value.is_string() && bits > 53) {
    const auto n = hex_number(value.get_ref<const std::string&>());
    if (!n) refuse(name, "not a number in hexadecimal digits");
    code = *n;
  } else {
    refuse(name, "expected a number");
  }
  if (code > lang::all_ones(bits)) refuse(name, "needs more than its " + std::to_string(bits) + " bits", code);
  return code;
}

/// Thrown when the members fit but a length does not: more useful than the fault of another version.
struct WrongLength : Refused {};

/// L_PACKET and L_MESSAGE may be absent, but not wrong.
void check_length(const Json& object, const char* name, unsigned bits, std::uint64_t computed) {
  const auto given = object.find(name);
  if (given == object.end()) return;
  const std::uint64_t found = code_of(*given, name, bits);
  if (found == computed) return;
  WrongLength wrong;
  wrong.error = complaint(name, found_not(found, computed));
  wrong.error.value = found;
  throw wrong;
}

/// The names of members in addition to those of a layout.
using Names = std::initializer_list<const char*>;
bool holds(Names names, const std::string& name) {
  return std::any_of(names.begin(), names.end(), [&name](const char* n) { return name == n; });
}
std::size_t count_present(const Json& object, Names names) {
  return static_cast<std::size_t>(
      std::count_if(names.begin(), names.end(), [&object](const char* n) { return object.contains(n); }));
}

/// Writes the members of one object by a layout. Every member must be used.
class ObjectWriter {
 public:
  explicit ObjectWriter(BitWriter& out) : out_(out) {}

  /// The steps before `first` and the members `beside` are written elsewhere.
  void write(const Json& object, std::span<const Step> steps, const lang::WalkScope* up, std::size_t first,
             Names beside) {
    std::array<std::uint64_t, lang::kStepsMax> codes{};
    const lang::WalkScope scope{steps, codes.data(), up};
    std::array<bool, lang::kStepsMax> present{};
    std::size_t used = first + count_present(object, beside);
    const auto member = [&](const char* name) -> const Json& {
      const auto it = object.find(name);
      if (it != object.end()) return *it;
      // First: a misspelt name explains why the right one is missing.
      refuse_unknown(object, steps, beside);
      refuse(name, "missing");
    };
    for (std::size_t i = first; i < steps.size(); ++i) {
      const Step& step = steps[i];
      present[i] = true;
      switch (step.kind) {
        case Step::Kind::field:
          codes[i] = code_of(member(step.name), step.name, step.bits);
          ++used;
          out_.write(codes[i], step.bits);
          break;
        case Step::Kind::when:
          if (!step.test(codes[step.condition])) i += step.count;
          break;
        case Step::Kind::when_around:
          if (!step.test(scope.around(step.variable))) i += step.count;
          break;
        case Step::Kind::repeat: {
          const Json& group = member(step.name);
          ++used;
          std::optional<std::uint64_t> given;
          if (const auto counter = object.find(step.counter); counter != object.end()) {
            ++used;
            given = code_of(*counter, step.counter, step.bits);
          }
          if (!group.is_array()) refuse(step.name, "expected an array");
          if (group.size() > step.capacity) refuse(step.name, "more than " + std::to_string(step.capacity));
          if (given && *given != group.size()) refuse(step.counter, found_not(*given, group.size()), *given);
          out_.write(group.size(), step.bits);
          for (const Json& element : group) {
            if (!element.is_object()) refuse(step.name, "expected objects");
            write(element, step.element(), &scope, 0, {});
          }
          break;
        }
        case Step::Kind::rest: {
          const Json& value = member(step.name);
          ++used;
          if (!value.is_string()) refuse(step.name, "expected a string of 0 and 1");
          for (const char c : value.get_ref<const std::string&>()) {
            if (c != '0' && c != '1') refuse(step.name, "expected a string of 0 and 1");
            out_.write(c == '1' ? 1 : 0, 1);
          }
          break;
        }
      }
    }
    if (used != object.size()) refuse_spare(object, steps, first, present, beside);
  }

 private:
  /// Names a member that the layout does not have.
  static void refuse_unknown(const Json& object, std::span<const Step> steps, Names beside) {
    for (const auto& [key, value] : object.items()) {
      bool in_layout = holds(beside, key);
      for (const Step& step : steps) in_layout = in_layout || key == step.name || key == step.counter;
      if (!in_layout) refuse(key, "unknown member");
    }
  }
  /// Names one member that is not used: misspelt, or its condition does not hold.
  [[noreturn]] static void refuse_spare(const Json& object, std::span<const Step> steps, std::size_t first,
                                        const std::array<bool, lang::kStepsMax>& present, Names beside) {
    refuse_unknown(object, steps, beside);
    for (const auto& [key, value] : object.items())
      for (std::size_t i = first; i < steps.size(); ++i)
        if ((key == steps[i].name || key == steps[i].counter) && !present[i])
          refuse(key, "a member whose condition does not hold");
    refuse("", "members of different layouts");
  }

  BitWriter& out_;
};

void write_packet_as(BitWriter& out, const Json& packet, const PacketLayout& layout) {
  const std::size_t start = out.position();
  std::size_t length = 0;
  out.write(layout.info->NID_PACKET, 8);
  if (layout.has_direction) {
    const auto it = packet.find("Q_DIR");
    if (it == packet.end()) refuse("Q_DIR", "missing");
    out.write(code_of(*it, "Q_DIR", 2), 2);
  }
  if (layout.has_length) {
    length = out.position();
    out.write(0, 13);
  }
  const std::size_t first = layout.has_direction ? 1 : 0;
  ObjectWriter(out).write(packet, layout.steps, nullptr, first, {"NID_PACKET", "L_PACKET"});
  check_length(packet, "L_PACKET", 13, out.position() - start);
  if (layout.has_length) {
    if (out.position() - start > 8191) refuse("L_PACKET", "packet longer than 8191 bits");
    out.patch(length, out.position() - start, 13);
  }
}

/// `{NID_PACKET, Q_DIR, L_PACKET, raw}`: written unchanged.
void write_raw_packet(BitWriter& out, const Json& packet, std::uint64_t nid) {
  const bool with_direction = packet.contains("Q_DIR");
  if (!packet.contains("L_PACKET")) refuse("L_PACKET", "missing");
  const std::uint64_t length = code_of(packet.at("L_PACKET"), "L_PACKET", 13);
  const std::size_t header = with_direction ? 23 : 21;
  if (length < header) refuse("L_PACKET", "less than the packet's header");
  out.write(nid, 8);
  if (with_direction) out.write(code_of(packet.at("Q_DIR"), "Q_DIR", 2), 2);
  out.write(length, 13);
  if (!packet.at("raw").is_string()) refuse("raw", "expected hexadecimal digits");
  const std::string& digits = packet.at("raw").get_ref<const std::string&>();
  // A packet may consist of its header only.
  const auto raw = digits.empty() ? tl::expected<Bits, TelegramError>(Bits{}) : bits_of_hex(digits);
  if (!raw) refuse("raw", raw.error().why);
  if ((length - header + 3) / 4 != raw->bits / 4) refuse("raw", "the number of digits does not match L_PACKET");
  BitReader in(raw->bytes, length - header);
  while (in.left() > 0) {
    const auto bits = static_cast<unsigned>(in.left() < 32 ? in.left() : 32);
    out.write(in.read(bits), bits);
  }
}

struct Wish {
  std::optional<Direction> direction;
  std::optional<SystemVersion> sv;
};

/// The layouts to try, the newest first.
std::vector<const PacketLayout*> candidates(const Json& packet, std::uint8_t nid, const Wish& wish) {
  std::vector<const PacketLayout*> found;
  Direction direction = Direction::to_train;
  if (wish.direction)
    direction = *wish.direction;
  else if (!packet.contains("Q_DIR") && nid != 255 && !(nid == 0 && packet.contains("NID_VBCMK")))
    direction = Direction::to_track;
  for (const PacketLayout& layout : lang::packet_layouts()) {
    if (layout.info->NID_PACKET != nid || layout.info->direction != direction) continue;
    if (wish.sv && (layout.info->versions & lang::known_version(*wish.sv)) == 0) continue;
    found.push_back(&layout);
  }
  return found;
}

void append(BitWriter& out, std::span<const std::uint8_t> bytes, std::size_t bits) {
  BitReader in(bytes, bits);
  while (in.left() > 0) {
    const auto n = static_cast<unsigned>(in.left() < 32 ? in.left() : 32);
    out.write(in.read(n), n);
  }
}

void write_packet(BitWriter& out, const Json& packet, const Wish& wish) {
  if (!packet.is_object()) refuse("packets", "expected objects");
  const auto it = packet.find("NID_PACKET");
  if (it == packet.end()) refuse("NID_PACKET", "missing");
  const auto nid = static_cast<std::uint8_t>(code_of(*it, "NID_PACKET", 8));
  try {
    if (packet.contains("raw")) return write_raw_packet(out, packet, nid);
    const std::vector<const PacketLayout*> layouts = candidates(packet, nid, wish);
    if (layouts.empty()) refuse("NID_PACKET", "no such packet in this version and direction");
    std::array<std::uint8_t, 1100> room{};
    std::optional<Refused> first, wrong_length;
    for (const PacketLayout* layout : layouts) {
      BitWriter trial(room);
      try {
        write_packet_as(trial, packet, *layout);
        return append(out, trial.bytes(), trial.position());
      } catch (const WrongLength& refused) {
        if (!wrong_length) wrong_length = refused;
      } catch (const Refused& refused) {
        if (!first) first = refused;
      }
    }
    if (wrong_length) throw *wrong_length;
    throw *first;
  } catch (Refused& refused) {
    if (refused.error.packet < 0) refused.error.packet = nid;
    throw;
  }
}

void know_only(const Json& object, Names names) {
  for (const auto& [key, value] : object.items())
    if (!holds(names, key)) refuse(key, "unknown member");
}

const Json& packets_of(const Json& object) {
  static const Json none = Json::array();
  const auto it = object.find("packets");
  if (it == object.end()) return none;
  if (!it->is_array()) refuse("packets", "expected an array");
  return *it;
}

void put_padding(BitWriter& out, const Json& padding, std::size_t bits) {
  if (!padding.is_string()) refuse("padding", "expected hexadecimal digits");
  const auto raw = bits_of_hex(padding.get_ref<const std::string&>());
  if (!raw) refuse("padding", raw.error().why);
  if (raw->bits < bits) refuse("padding", "fewer bits than \"bits\"");
  append(out, raw->bytes, bits);
}

Bits finish(std::vector<std::uint8_t>& room, const BitWriter& out) {
  if (out.faulty()) refuse("", "longer than a telegram or message can be");
  room.resize((out.position() + 7) / 8);
  return {std::move(room), out.position()};
}

void check_schema(const Json& object) {
  if (const auto it = object.find("schema"); it != object.end() && *it != "evc-telegram/1")
    refuse("schema", "expected evc-telegram/1");
}

/// The member "system_version", if there is one.
std::optional<SystemVersion> given_version(const Json& object) {
  const auto it = object.find("system_version");
  if (it == object.end()) return {};
  const auto sv = it->is_string() ? parse_version(it->get_ref<const std::string&>()) : std::nullopt;
  if (!sv) refuse("system_version", "expected X.Y");
  return sv;
}

Bits write_telegram(const Json& telegram, std::span<const HeaderField> header, std::size_t most_bits) {
  if (!telegram.is_object()) refuse("", "expected an object");
  know_only(telegram, {"schema", "system_version", "header", "packets", "bits", "padding", "airgap"});
  check_schema(telegram);
  const auto it = telegram.find("header");
  if (it == telegram.end() || !it->is_object()) refuse("header", "missing");
  for (const auto& [key, value] : it->items())
    if (std::none_of(header.begin(), header.end(), [&key = key](const HeaderField& f) { return key == f.name; }))
      refuse(key, "unknown member");
  std::vector<std::uint8_t> room((most_bits + 7) / 8 + 8);
  BitWriter out(room);
  std::uint64_t M_VERSION = 0;
  for (const HeaderField& f : header) {
    const auto value = it->find(f.name);
    if (value == it->end()) refuse(f.name, "missing");
    const std::uint64_t code = code_of(*value, f.name, f.bits);
    if (std::strcmp(f.name, "M_VERSION") == 0) M_VERSION = code;
    out.write(code, f.bits);
  }
  const SystemVersion sv = lang::system_version(M_VERSION);
  if (lang::known_version(sv) == 0) refuse("M_VERSION", "unknown system version");
  if (const auto given = given_version(telegram); given && *given != sv)
    refuse("system_version", "not that of M_VERSION");
  for (const Json& packet : packets_of(telegram)) write_packet(out, packet, {Direction::to_train, sv});
  out.write(255, 8);
  if (out.position() > most_bits)
    refuse("packets", std::to_string(out.position()) + " bits: more than " + std::to_string(most_bits));
  if (const auto bits = telegram.find("bits"); bits != telegram.end()) {
    const std::uint64_t n = code_of(*bits, "bits", 16);
    if (n < out.position() || n > most_bits) refuse("bits", "less than the packets need, or too many");
    if (const auto padding = telegram.find("padding"); padding != telegram.end())
      put_padding(out, *padding, n - out.position());
    while (out.position() < n) out.write(1, 1);
  } else if (telegram.contains("padding")) {
    refuse("padding", "without \"bits\"");
  }
  return finish(room, out);
}

template <class Write>
tl::expected<Bits, TelegramError> encoded(Write write) {
  try {
    return write();
  } catch (Refused& refused) {
    return tl::unexpected(std::move(refused.error));
  }
}

}  // namespace

tl::expected<Bits, TelegramError> encode_balise_json(const Json& telegram) {
  return encoded([&] { return write_telegram(telegram, balise_header, 830); });
}

tl::expected<Bits, TelegramError> encode_loop_json(const Json& message) {
  return encoded([&] { return write_telegram(message, loop_header, 8192); });
}

tl::expected<Bits, TelegramError> encode_radio_json(const Json& message, const EncodeOptions& options) {
  return encoded([&]() -> Bits {
    if (!message.is_object()) refuse("", "expected an object");
    const auto it = message.find("NID_MESSAGE");
    if (it == message.end()) refuse("NID_MESSAGE", "missing");
    const auto nid = static_cast<std::uint8_t>(code_of(*it, "NID_MESSAGE", 8));
    Wish wish{options.direction, options.sv};
    if (!wish.direction) wish.direction = nid >= 128 ? Direction::to_track : Direction::to_train;
    check_schema(message);
    if (const auto given = given_version(message); !wish.sv) wish.sv = given;
    std::optional<Refused> first, wrong_length;
    for (const lang::MessageLayout& layout : lang::message_layouts()) {
      if (layout.info->NID_MESSAGE != nid || layout.info->direction != *wish.direction) continue;
      if (wish.sv && (layout.info->versions & lang::known_version(*wish.sv)) == 0) continue;
      std::vector<std::uint8_t> room(1300);
      BitWriter out(room);
      try {
        out.write(nid, 8);
        out.write(0, 10);
        ObjectWriter(out).write(message, layout.steps, nullptr, 0,
                                {"NID_MESSAGE", "L_MESSAGE", "packets", "padding", "schema", "system_version"});
        for (const Json& packet : packets_of(message)) write_packet(out, packet, wish);
        const std::size_t filling = (8 - out.position() % 8) % 8;
        if (const auto padding = message.find("padding"); padding != message.end())
          put_padding(out, *padding, filling);
        else if (filling > 0)
          out.write(0, static_cast<unsigned>(filling));
        if (out.position() / 8 > 1023) refuse("L_MESSAGE", "longer than 1023 bytes");
        check_length(message, "L_MESSAGE", 10, out.position() / 8);
        out.patch(8, out.position() / 8, 10);
        return finish(room, out);
      } catch (const WrongLength& refused) {
        if (!wrong_length) wrong_length = refused;
      } catch (const Refused& refused) {
        if (!first) first = refused;
      }
    }
    if (wrong_length) throw *wrong_length;
    if (first) throw *first;
    refuse("NID_MESSAGE", "no such message in this version and direction");
  });
}

tl::expected<Bits, TelegramError> encode_packet_json(const Json& packet, const EncodeOptions& options) {
  return encoded([&] {
    std::vector<std::uint8_t> room(1100);
    BitWriter out(room);
    write_packet(out, packet, {options.direction, options.sv});
    return finish(room, out);
  });
}

}  // namespace evc::io
