#include "io/telegram_explain.h"

#include <cstdio>
#include <cstring>
#include <vector>

#include "lang/fault.h"
#include "lang/walk.h"

namespace evc::io {
namespace {

using lang::Direction;
using lang::Kind;
using lang::PacketLayout;
using lang::Step;
using lang::SystemVersion;
using lang::VariableInfo;

/// A number with as few decimals as it needs, three at most.
std::string decimal(double number) {
  char text[40];
  std::snprintf(text, sizeof text, "%.3f", number);
  std::string s = text;
  while (s.back() == '0') s.pop_back();
  if (s.back() == '.') s.pop_back();
  return s;
}

const char* text_in(std::span<const lang::Meaning> list, std::uint64_t code) {
  for (const lang::Meaning& m : list)
    if (m.code == code) return m.text;
  return nullptr;
}

std::string digits_of(std::uint64_t code, unsigned bits) {
  std::string text;
  for (unsigned shift = bits; shift > 0; shift -= 4) {
    const auto digit = static_cast<unsigned>((code >> (shift - 4)) & 15u);
    if (digit == 15) continue;
    text += digit < 10 ? static_cast<char>('0' + digit) : static_cast<char>('A' + digit - 10);
  }
  return text.empty() ? "no digits" : text;
}

std::string bit_texts(const VariableInfo& v, std::uint64_t code) {
  std::string text;
  for (unsigned bit = 0; bit < v.bits; ++bit) {
    if (((code >> bit) & 1u) == 0) continue;
    const char* meaning = text_in(v.bit_meanings, bit);
    if (!text.empty()) text += " + ";
    text += meaning != nullptr ? meaning : "bit " + std::to_string(bit);
  }
  return text.empty() ? "none" : text;
}

bool is_spare(const VariableInfo& v, std::uint64_t code) {
  for (const lang::Range& r : v.spare)
    if (lang::is_in(r, code)) return true;
  return false;
}

std::string character(std::uint64_t code) {
  if (code >= 0x20 && code < 0x7F) return std::string("'") + static_cast<char>(code) + "'";
  if (code < 0xA0) return "control character";
  // ISO 8859-1 as UTF-8
  return std::string("'") + static_cast<char>(0xC0 | (code >> 6)) + static_cast<char>(0x80 | (code & 0x3F)) + "'";
}

/// Lines of the table, in columns.
class Table {
 public:
  void line(std::size_t bit, int depth, const std::string& name, const std::string& raw, const std::string& meaning) {
    char text[16];
    std::snprintf(text, sizeof text, "%5zu  ", bit);
    out_ += text;
    std::string left(static_cast<std::size_t>(depth) * 2, ' ');
    left += name;
    if (left.size() < 27) left.resize(27, ' ');
    out_ += left;
    if (raw.size() < 16) out_.append(16 - raw.size(), ' ');
    out_ += raw;
    if (!meaning.empty()) out_ += "  " + meaning;
    out_ += '\n';
  }
  void title(const std::string& text) { out_ += text + "\n"; }
  std::string take() { return std::move(out_); }

 private:
  std::string out_;
};

/// Enters the values of a walk in the table.
struct Explainer {
  Table& table;
  std::span<const std::uint8_t> bytes;
  int depth = 1;
  std::uint64_t scale = 1;
  std::string text{};                // letters of X_TEXT
  std::vector<std::string> names{};  // of the repeated groups around the field
  std::size_t here = 0;              // bit reached

  void field(const Step& step, std::uint64_t code, std::size_t bit) {
    here = bit + step.bits;
    const VariableInfo* v = lang::find_variable(step.variable);
    if (v->kind == Kind::character) {
      const std::string c = character(code);
      text += c.front() == '\'' ? c.substr(1, c.size() - 2) : "?";
      return;
    }
    if (std::strcmp(step.variable, "Q_SCALE") == 0) scale = code;
    std::string raw = step.bits > 53 ? digits_of_hex(code) : std::to_string(code);
    if (v->is_signed) raw = std::to_string(static_cast<std::int16_t>(code));
    table.line(bit, depth, step.name, raw, meaning_of(*v, code, scale));
  }
  void begin_group(const Step& step, std::uint64_t count, std::size_t bit) {
    here = bit + step.bits;
    table.line(bit, depth, step.counter, std::to_string(count),
               count == 0 ? std::string("no ") + step.name : std::string(step.name) + " follow");
    names.emplace_back(step.name);
    text.clear();
  }
  void begin_element(std::uint64_t index) {
    if (names.back() != "text")
      table.title("       " + std::string(static_cast<std::size_t>(depth) * 2, ' ') + names.back() + " " +
                  std::to_string(index + 1));
    ++depth;
  }
  void end_element() { --depth; }
  void end_group() {
    if (names.back() == "text" && !text.empty())
      table.title("       " + std::string(static_cast<std::size_t>(depth) * 2, ' ') + "\"" + text + "\"");
    names.pop_back();
  }
  void rest(const Step& step, std::size_t bit, std::size_t bits) {
    std::string hex;
    BitReader in(bytes, bit + bits, bit);
    while (in.left() > 0) {
      const auto n = static_cast<unsigned>(in.left() < 4 ? in.left() : 4);
      hex += "0123456789ABCDEF"[in.read(n) << (4 - n)];
    }
    table.line(bit, depth, step.name, std::to_string(bits) + " bits", hex);
  }
  static std::string digits_of_hex(std::uint64_t code) {
    char text[20];
    std::snprintf(text, sizeof text, "%016llX", static_cast<unsigned long long>(code));
    return text;
  }
};

void known(Table& table, BitReader& in, const char* variable, int depth) {
  const VariableInfo* v = lang::find_variable(variable);
  const std::size_t bit = in.position();
  const std::uint64_t code = in.read(v->bits, variable);
  if (!in.faulty()) table.line(bit, depth, variable, std::to_string(code), meaning_of(*v, code, 1));
}

/// One packet; the bit after it, 0 if it cannot be read.
std::size_t explain_one(Table& table, std::span<const std::uint8_t> bytes, std::size_t bit, std::size_t end,
                        Direction direction, SystemVersion sv) {
  BitReader in(bytes, end, bit);
  const auto nid = static_cast<std::uint8_t>(in.read(8, "NID_PACKET"));
  if (in.faulty()) return 0;
  const PacketLayout* layout = lang::find_packet_layout(direction, lang::known_version(sv), nid);
  table.title("");
  table.title("packet " + std::to_string(nid) + "  " +
              (layout != nullptr ? layout->info->name : "unknown in this version"));
  table.line(bit, 0, "NID_PACKET", std::to_string(nid),
             layout != nullptr ? std::string("SUBSET-026 ") + layout->info->ref : "");
  std::size_t packet_end = end;
  if (layout == nullptr || layout->has_length) {
    if (direction == Direction::to_train) known(table, in, "Q_DIR", 0);
    const std::size_t at = in.position();
    const std::uint64_t length = in.read(13, "L_PACKET");
    if (in.faulty() || bit + length > end || bit + length < in.position()) return 0;
    table.line(at, 0, "L_PACKET", std::to_string(length), "bits, up to bit " + std::to_string(bit + length - 1));
    packet_end = bit + length;
  }
  if (layout == nullptr) return packet_end;
  BitReader inside(bytes, packet_end, in.position());
  Explainer explainer{table, bytes, 0};
  lang::walk<lang::read_fast>(inside, layout->steps, explainer, nullptr, layout->has_direction ? 1 : 0);
  return inside.faulty() ? 0 : inside.position();
}

std::string version_text(SystemVersion sv) { return std::to_string(sv.x) + "." + std::to_string(sv.y); }

std::string heading(std::string text, Direction direction, SystemVersion sv) {
  text += direction == Direction::to_train ? " to the train" : " to the track";
  text += ", system version ";
  text += version_text(sv);
  return text;
}

}  // namespace

std::string meaning_of(const VariableInfo& v, std::uint64_t code, std::uint64_t Q_SCALE) {
  if (const char* text = text_in(v.special, code)) return text;
  if (const char* text = text_in(v.codes, code)) return text;
  if (is_spare(v, code)) return "SPARE";
  for (const lang::CodeNumber& n : v.numbers)
    if (n.code == code) return decimal(n.number) + (*v.unit != '\0' ? std::string(" ") + v.unit : "");
  double value = static_cast<double>(code);
  if (v.is_signed) value = static_cast<std::int16_t>(code);
  switch (v.kind) {
    case Kind::bitset:
      return bit_texts(v, code);
    case Kind::bcd:
      return digits_of(code, v.bits);
    case Kind::character:
      return character(code);
    case Kind::version:
      return version_text(lang::system_version(code));
    case Kind::identity:
      if (v.bits == 24 && std::strstr(v.name, "BG") != nullptr)
        return "NID_C " + std::to_string(code >> 14) + ", NID_BG " + std::to_string(code & 0x3FFFu);
      return "";
    case Kind::enumeration:
      return "no meaning given";
    default:
      break;
  }
  if (v.by_scale)
    return Q_SCALE > 2 ? "scale unknown"
                       : decimal(Q_SCALE == 0   ? value / 10
                                 : Q_SCALE == 1 ? value
                                                : value * 10) +
                             " m";
  if (*v.unit == '\0' && (v.resolution == 0 || v.resolution == 1)) return "";
  // Resolutions such as 0.05 are not exact; their inverse is.
  const double scaled = v.resolution != 0 && v.resolution < 1
                            ? value / static_cast<double>(static_cast<long>(1 / v.resolution + 0.5))
                            : value * (v.resolution == 0 ? 1 : v.resolution);
  const std::string unit = std::strcmp(v.unit, "permille") == 0 ? "\xE2\x80\xB0"
                           : std::strcmp(v.unit, "m/s2") == 0   ? "m/s\xC2\xB2"
                                                                : v.unit;
  return decimal(scaled) + (unit.empty() ? "" : " " + unit);
}

std::string explain_balise(std::span<const std::uint8_t> bytes, std::size_t bits) {
  if (bits > 830) bits = 830;
  Table table;
  BitReader in(bytes, bits);
  const SystemVersion sv = lang::system_version(BitReader(bytes, bits, 1).read(7));
  table.title("balise telegram, system version " + version_text(sv));
  table.title("  bit  variable                                raw  meaning");
  for (const char* name :
       {"Q_UPDOWN", "M_VERSION", "Q_MEDIA", "N_PIG", "N_TOTAL", "M_DUP", "M_MCOUNT", "NID_C", "NID_BG", "Q_LINK"})
    known(table, in, name, 0);
  std::size_t at = in.position();
  while (!in.faulty()) {
    BitReader next(bytes, bits, at);
    if (next.read(8) == 255) {
      table.title("");
      table.title("packet 255  End of information");
      table.line(at, 0, "NID_PACKET", "255",
                 bits - at > 15 ? std::to_string(bits - at - 8) + " bits follow, without meaning" : "");
      return table.take();
    }
    at = next.faulty() ? 0 : explain_one(table, bytes, at, bits, Direction::to_train, sv);
    if (at == 0) break;
  }
  table.title("! not consistent from here on");
  return table.take();
}

std::string explain_radio(std::span<const std::uint8_t> bytes, Direction direction, SystemVersion sv) {
  Table table;
  BitReader in(bytes);
  const auto nid = static_cast<std::uint8_t>(in.read(8));
  const lang::MessageLayout* layout = lang::find_message_layout(direction, sv, nid);
  table.title(heading("radio message", direction, sv));
  table.title("  bit  variable                                raw  meaning");
  if (layout == nullptr) {
    table.title("! unknown message " + std::to_string(nid));
    return table.take();
  }
  table.line(0, 0, "NID_MESSAGE", std::to_string(nid),
             std::string(layout->info->name) + ", SUBSET-026 " + layout->info->ref);
  known(table, in, "L_MESSAGE", 0);
  Explainer explainer{table, bytes, 0};
  lang::walk<lang::read_fast>(in, layout->steps, explainer);
  std::size_t at = in.position();
  const std::size_t bits = bytes.size() * 8;
  while (!in.faulty() && bits - at >= 8) {
    at = explain_one(table, bytes, at, bits, direction, sv);
    if (at == 0) {
      table.title("! not consistent from here on");
      break;
    }
  }
  return table.take();
}

std::string explain_packet(std::span<const std::uint8_t> bytes, std::size_t bits, Direction direction,
                           SystemVersion sv) {
  Table table;
  table.title(heading("packet", direction, sv));
  table.title("  bit  variable                                raw  meaning");
  if (explain_one(table, bytes, 0, bits, direction, sv) == 0) table.title("! not consistent from here on");
  return table.take();
}

}  // namespace evc::io
