#include <algorithm>
#include <cstdio>
#include <cstring>
#include <vector>

#include "io/telegram_explain.h"
#include "lang/layouts.h"
#include "lang/message_table.h"

namespace evc::io {
namespace {

using lang::Direction;
using lang::PacketLayout;
using lang::Step;
using lang::VariableInfo;
using lang::Versions;

std::string versions_text(Versions versions) {
  std::string text;
  constexpr const char* kNames[lang::kVersions]{"1.0", "1.1", "2.0", "2.1", "2.2", "2.3", "3.0"};
  for (unsigned i = 0; i < lang::kVersions; ++i)
    if ((versions & (1u << i)) != 0) text += std::string(text.empty() ? "" : ", ") + kNames[i];
  return text;
}
std::string media_text(lang::Media m) {
  std::string text;
  const auto add = [&](lang::Media one, const char* name) {
    if ((m & one) != 0) text += std::string(text.empty() ? "" : ", ") + name;
  };
  add(lang::media::balise, "balise");
  add(lang::media::loop, "loop");
  add(lang::media::RBC, "RBC");
  add(lang::media::RIU, "RIU");
  return text;
}
const char* direction_text(Direction d) { return d == Direction::to_train ? "track to train" : "train to track"; }

/// The codes of a variable with their meanings, in one line.
std::string codes_text(const VariableInfo& v) {
  std::vector<std::string> parts;
  if (v.by_scale)
    parts.emplace_back("0.1 m, 1 m or 10 m by Q_SCALE");
  else if (v.kind == lang::Kind::table)
    parts.emplace_back(std::string("table, ") + v.unit);
  else if (v.resolution != 0 && (*v.unit != '\0' || v.resolution != 1)) {
    char text[40];
    std::snprintf(text, sizeof text, "steps of %g %s", v.resolution, v.unit);
    std::string s = text;
    if (s.back() == ' ') s.pop_back();
    parts.push_back(s);
  }
  if (v.kind == lang::Kind::bcd) parts.emplace_back("decimal digits, filled up with F");
  if (v.is_signed) parts.emplace_back("two's complement");
  for (const lang::Meaning& m : v.codes) parts.push_back(std::to_string(m.code) + ": " + m.text);
  for (const lang::Meaning& m : v.bit_meanings) parts.push_back("bit " + std::to_string(m.code) + ": " + m.text);
  for (const lang::Meaning& m : v.special) parts.push_back(std::to_string(m.code) + ": " + m.text);
  std::string spare;
  for (const lang::Range& r : v.spare) {
    if (r.first > r.last) {
      spare += std::string(spare.empty() ? "" : ", ") + "digits A to E";
      continue;
    }
    spare += (spare.empty() ? "" : ", ") + std::to_string(r.first);
    if (r.last != r.first) spare += "-" + std::to_string(r.last);
  }
  if (!spare.empty()) parts.push_back("spare: " + spare);
  std::string text;
  for (const std::string& p : parts) text += (text.empty() ? "" : "; ") + p;
  return text;
}

struct Row {
  std::string bit, name, bits, when, about;
};

std::string test_text(const std::string& variable, const lang::Test& test) {
  std::string text = variable + (test.negated ? " not " : " = ");
  for (std::uint8_t i = 0; i < test.count; ++i) text += (i > 0 ? " or " : "") + std::to_string(test.codes[i]);
  return text;
}

/// The rows of a table: the lowest bit of every field, counted from the start of its structure.
class Rows {
 public:
  void add(std::span<const Step> steps, std::size_t from, std::size_t to, int depth, const std::string& when) {
    for (std::size_t i = from; i < to; ++i) {
      const Step& s = steps[i];
      switch (s.kind) {
        case Step::Kind::field:
          field(s.name, s.variable, s.bits, depth, when);
          break;
        case Step::Kind::when:
        case Step::Kind::when_around: {
          const std::string test = test_text(s.kind == Step::Kind::when ? steps[s.condition].name : s.variable, s.test);
          const std::size_t before = at_;
          const bool was_fixed = fixed_;
          add(steps, i + 1, i + 1u + s.count, depth, when.empty() ? test : when + ", " + test);
          at_ = before;  // the lowest bit: without them
          fixed_ = false;
          (void)was_fixed;
          i += s.count;
          break;
        }
        case Step::Kind::repeat: {
          field(s.counter, s.variable, s.bits, depth, when);
          rows.push_back({"", indent(depth) + s.name + " (each)", "", std::string(s.counter) + " times", ""});
          const std::size_t before = at_;
          const bool relative = relative_;
          at_ = 0;
          fixed_ = true;
          relative_ = true;
          add(s.element(), 0, s.element().size(), depth + 1, "");
          at_ = before;
          fixed_ = false;
          relative_ = relative;
          break;
        }
        case Step::Kind::rest:
          rows.push_back({offset(), indent(depth) + s.name, "", when, "to the end given by L_PACKET"});
          break;
      }
    }
  }
  void field(const char* name, const char* variable, unsigned bits, int depth, const std::string& when) {
    const VariableInfo* v = lang::find_variable(variable);
    std::string shown = name;
    if (std::strcmp(name, v->name) != 0) shown += std::string(" (") + v->name + ")";
    rows.push_back({offset(), indent(depth) + shown, std::to_string(bits), when, codes_text(*v)});
    at_ += bits;
  }
  std::vector<Row> rows;

 private:
  std::string offset() const {
    return std::string(relative_ ? "+" : "") + std::to_string(at_) + (fixed_ ? "" : " or more");
  }
  static std::string indent(int depth) { return std::string(static_cast<std::size_t>(depth) * 2, ' '); }
  std::size_t at_ = 0;
  bool fixed_ = true;
  bool relative_ = false;
};

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '|' || c == '*' || c == '_') out += '\\';
    out += c;
  }
  return out;
}

std::string table(const std::vector<Row>& rows, bool markdown) {
  std::string out;
  if (markdown) {
    out = "| bit | variable | bits | present if | codes |\n|---:|---|---:|---|---|\n";
    for (const Row& r : rows) {
      std::string name = r.name;
      std::size_t blanks = name.find_first_not_of(' ');
      std::string lead;
      for (std::size_t i = 0; i < blanks; ++i) lead += "&nbsp;";
      out += "| " + r.bit + " | " + lead + escaped(name.substr(blanks)) + " | " + r.bits + " | " + escaped(r.when) +
             " | " + escaped(r.about) + " |\n";
    }
    return out;
  }
  std::size_t widths[4] = {3, 8, 4, 10};
  for (const Row& r : rows) {
    widths[0] = std::max(widths[0], r.bit.size());
    widths[1] = std::max(widths[1], r.name.size());
    widths[3] = std::max(widths[3], std::min<std::size_t>(r.when.size(), 34));
  }
  const auto cell = [](std::string text, std::size_t width, bool right) {
    if (text.size() < width) text.insert(right ? 0 : text.size(), width - text.size(), ' ');
    return text;
  };
  const auto line = [&](const Row& r) {
    std::string text = cell(r.bit, widths[0], true) + "  " + cell(r.name, widths[1], false) + "  " +
                       cell(r.bits, widths[2], true) + "  " + cell(r.when, widths[3], false) + "  " + r.about;
    text.resize(text.find_last_not_of(' ') + 1);
    return text + "\n";
  };
  out = line({"bit", "variable", "bits", "present if", "codes"});
  for (const Row& r : rows) out += line(r);
  return out;
}

std::string number_list(std::span<const std::uint8_t> list, const char* between) {
  std::string text;
  for (const std::uint8_t n : list) text += (text.empty() ? "" : between) + std::to_string(n);
  return text.empty() ? "none" : text;
}

}  // namespace

std::string describe_packet(std::uint8_t nid, Direction direction, bool markdown) {
  std::string out;
  for (const PacketLayout& l : lang::packet_layouts()) {
    if (l.info->NID_PACKET != nid || l.info->direction != direction) continue;
    const std::string title = std::string("Packet ") + std::to_string(nid) + ": " + l.info->name;
    if (out.empty()) out += markdown ? "# " + title + "\n\n" : title + "\n";
    const std::string versions = versions_text(l.info->versions);
    std::string facts =
        std::string(direction_text(direction)) + "; by " + media_text(l.info->media) + "; SUBSET-026 " + l.info->ref;
    if (*l.info->note != '\0') facts += std::string("; ") + l.info->note;
    out += (markdown ? "## System version " : "\nsystem version ") + versions + (markdown ? "\n\n" : "\n");
    out += (markdown ? escaped(facts) + ".\n\n" : facts + "\n");
    Rows rows;
    rows.field("NID_PACKET", "NID_PACKET", 8, 0, "");
    rows.rows.back().about = std::to_string(nid);
    if (l.has_direction) rows.field("Q_DIR", "Q_DIR", 2, 0, "");
    if (l.has_length) rows.field("L_PACKET", "L_PACKET", 13, 0, "");
    rows.add(l.steps, l.has_direction ? 1 : 0, l.steps.size(), 0, "");
    out += table(rows.rows, markdown) + (markdown ? "\n" : "");
  }
  if (markdown && !out.empty()) {
    out +=
        "A bit number is counted from the start of the packet; `+` from the start of the element. \"or more\": a "
        "field\n"
        "before it may be present. Made by `evc describe packets " +
        std::to_string(nid) + (direction == Direction::to_train ? " --to-train" : " --to-track") + " --markdown`.\n";
  }
  return out;
}

std::string describe_message(std::uint8_t nid, bool markdown) {
  std::string out;
  std::string_view first;
  for (const lang::MessageRules& m : lang::message_rules()) {
    if (m.NID_MESSAGE != nid) continue;
    const std::string title = std::string("Message ") + std::to_string(nid) + ": " + m.name;
    if (out.empty()) out += markdown ? "# " + title + "\n\n" : title + "\n";
    if (first.empty()) first = m.name;
    out += (markdown ? "## System version " : "\nsystem version ") + versions_text(m.versions);
    if (m.name != first) out += std::string(": ") + m.name;  // message 38 has another meaning from 2.3 on
    out += markdown ? "\n\n" : "\n";
    std::string facts = std::string(direction_text(m.direction)) + "; " + media_text(m.media) + "; priority " +
                        m.priority + "; SUBSET-026 " + m.ref;
    if (*m.note != '\0') facts += std::string("; ") + m.note;
    out += (markdown ? escaped(facts) + ".\n\n" : facts + "\n");
    lang::SystemVersion sv{2, 1};
    for (const lang::SystemVersion v : {lang::SystemVersion{1, 0}, {1, 1}, {2, 0}, {2, 1}, {2, 2}, {2, 3}, {3, 0}})
      if ((m.versions & lang::known_version(v)) != 0) sv = v;
    const lang::MessageLayout* layout = lang::find_message_layout(m.direction, sv, nid);
    Rows rows;
    rows.field("NID_MESSAGE", "NID_MESSAGE", 8, 0, "");
    rows.rows.back().about = std::to_string(nid);
    rows.field("L_MESSAGE", "L_MESSAGE", 10, 0, "");
    rows.add(layout->steps, 0, layout->steps.size(), 0, "");
    out += table(rows.rows, markdown) + "\n";
    std::string required;
    for (const auto& one_of : m.required)
      if (!one_of.empty()) required += (required.empty() ? "" : ", then ") + number_list(one_of, " or ");
    out += "mandatory packets: " + (required.empty() ? "none" : required) + "\n";
    out += (markdown ? "\n" : std::string()) + "optional packets: " + number_list(m.optional, ", ") + "\n";
    if (m.media == (lang::media::RBC | lang::media::RIU) && !m.optional_from_riu.empty() &&
        m.optional_from_riu.size() != m.optional.size())
      out += (markdown ? "\n" : std::string()) + "from an RIU only: " + number_list(m.optional_from_riu, ", ") + "\n";
    if (markdown) out += "\n";
  }
  return out;
}

std::string describe_variable(std::string_view name, bool markdown) {
  std::string out;
  for (const VariableInfo& v : lang::variables()) {
    if (name != v.name && name != v.key) continue;
    out += (markdown ? "# " : "") + std::string(v.name) + (std::strcmp(v.key, v.name) != 0 ? " (versions 1.Y)" : "") +
           "\n";
    if (markdown) out += "\n";
    out += std::string(v.about) + "; " + std::to_string(v.bits) + " bits; system version " + versions_text(v.versions) +
           "; SUBSET-026 " + v.ref + "\n";
    if (*v.note != '\0') out += std::string(v.note) + "\n";
    if (markdown) out += "\n| code | meaning |\n|---:|---|\n";
    const auto row = [&](const std::string& code, const std::string& text) {
      out += markdown ? "| " + code + " | " + escaped(text) + " |\n"
                      : std::string(code.size() < 12 ? 12 - code.size() : 0, ' ') + code + "  " + text + "\n";
    };
    if (v.kind != lang::Kind::enumeration && v.kind != lang::Kind::bitset && v.kind != lang::Kind::table)
      row("0-" + std::to_string(v.max), codes_text({v.key,
                                                    v.name,
                                                    v.bits,
                                                    v.is_signed,
                                                    v.kind,
                                                    v.unit,
                                                    v.resolution,
                                                    v.by_scale,
                                                    v.max,
                                                    {},
                                                    {},
                                                    {},
                                                    {},
                                                    {},
                                                    v.versions,
                                                    "",
                                                    "",
                                                    ""}));
    for (const lang::Meaning& m : v.codes) row(std::to_string(m.code), m.text);
    for (const lang::Meaning& m : v.bit_meanings) row("bit " + std::to_string(m.code), m.text);
    if (v.codes.empty())
      for (const lang::CodeNumber& n : v.numbers) row(std::to_string(n.code), std::to_string(n.number) + " " + v.unit);
    for (const lang::Meaning& m : v.special) row(std::to_string(m.code), m.text);
    for (const lang::Range& r : v.spare)
      row(r.first > r.last    ? "digits A-E"
          : r.first == r.last ? std::to_string(r.first)
                              : std::to_string(r.first) + "-" + std::to_string(r.last),
          "spare");
    out += "\n";
  }
  return out;
}

std::string list_packets() {
  std::string out;
  for (const PacketLayout& l : lang::packet_layouts()) {
    char text[160];
    std::snprintf(text, sizeof text, "%-15s %4d  %-40s %-20s %s\n", direction_text(l.info->direction),
                  l.info->NID_PACKET, l.info->name, versions_text(l.info->versions).c_str(), l.info->ref);
    out += text;
  }
  return out;
}
std::string list_messages() {
  std::string out;
  for (const lang::MessageRules& m : lang::message_rules()) {
    char text[160];
    std::snprintf(text, sizeof text, "%-15s %4d  %-40s %-20s %s\n", direction_text(m.direction), m.NID_MESSAGE, m.name,
                  versions_text(m.versions).c_str(), m.ref);
    out += text;
  }
  return out;
}
std::string list_variables() {
  std::string out;
  for (const VariableInfo& v : lang::variables()) {
    char text[240];
    std::snprintf(text, sizeof text, "%-24s %2u bits  %-20s %s\n", v.key, v.bits, versions_text(v.versions).c_str(),
                  v.about);
    out += text;
  }
  return out;
}

namespace {

/// JSON schema of the members of a list of steps.
class Schema {
 public:
  void object(std::string& out, std::span<const Step> steps, const std::string& head,
              const std::string& required_head) {
    std::string required = required_head;
    out += "{\"type\": \"object\", \"properties\": {" + head;
    members(out, steps, required);
    out += "}, \"required\": [" + required + "], \"additionalProperties\": false}";
  }
  static std::string number(unsigned bits, bool is_signed = false) {
    if (bits > 53) return "{\"type\": \"string\", \"pattern\": \"^[0-9A-F]{" + std::to_string(bits / 4) + "}$\"}";
    const std::string least = is_signed ? "-" + std::to_string(1ull << (bits - 1)) : "0";
    const std::uint64_t most = is_signed ? lang::all_ones(bits - 1) : lang::all_ones(bits);
    return "{\"type\": \"integer\", \"minimum\": " + least + ", \"maximum\": " + std::to_string(most) + "}";
  }

 private:
  static void comma(std::string& out, const std::string& after = "{") {
    if (out.substr(out.size() - after.size()) != after) out += ", ";
  }
  void members(std::string& out, std::span<const Step> steps, std::string& required) {
    std::size_t conditional_to = 0;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const Step& s = steps[i];
      if (s.kind == Step::Kind::when || s.kind == Step::Kind::when_around) {
        conditional_to = std::max(conditional_to, i + 1 + s.count);
        continue;
      }
      comma(out);
      out += "\"" + std::string(s.name) + "\": ";
      if (i >= conditional_to) required += (required.empty() ? "\"" : ", \"") + std::string(s.name) + "\"";
      if (s.kind == Step::Kind::field) {
        out += number(s.bits, lang::find_variable(s.variable)->is_signed);
      } else if (s.kind == Step::Kind::rest) {
        out += "{\"type\": \"string\", \"pattern\": \"^[01]*$\"}";
      } else {
        out += "{\"type\": \"array\", \"maxItems\": " + std::to_string(s.capacity) + ", \"items\": ";
        object(out, s.element(), "", "");
        out += "}";
        out += ", \"" + std::string(s.counter) + "\": " + number(s.bits);
      }
    }
  }
};

}  // namespace

std::string telegram_schema() {
  std::string out =
      "{\n\"$schema\": \"https://json-schema.org/draft/2020-12/schema\",\n\"title\": \"evc-telegram/1\",\n"
      "\"description\": \"A balise telegram, Euroloop message, radio message or packet of the ETCS language as raw "
      "codes. "
      "Made by evc describe schema.\",\n"
      "\"anyOf\": [{\"$ref\": \"#/$defs/telegram\"}, {\"$ref\": \"#/$defs/message\"}, {\"$ref\": \"#/$defs/packet\"}, "
      "{\"$ref\": \"#/$defs/refusal\"}],\n\"$defs\": {\n";
  out +=
      "\"telegram\": {\"type\": \"object\", \"properties\": {\"schema\": {\"const\": \"evc-telegram/1\"}, "
      "\"system_version\": {\"type\": \"string\", \"pattern\": \"^[0-7][.][0-9]+$\"}, \"header\": {\"type\": "
      "\"object\", "
      "\"properties\": {";
  for (const char* name : {"Q_UPDOWN", "M_VERSION", "Q_MEDIA", "N_PIG", "N_TOTAL", "M_DUP", "M_MCOUNT", "NID_C",
                           "NID_BG", "NID_LOOP", "Q_LINK"})
    out += std::string(out.back() == '{' ? "" : ", ") + "\"" + name +
           "\": " + Schema::number(lang::find_variable(name)->bits);
  out +=
      "}, \"required\": [\"Q_UPDOWN\", \"M_VERSION\", \"Q_MEDIA\", \"NID_C\"], \"additionalProperties\": false}, "
      "\"packets\": {\"type\": \"array\", \"items\": {\"$ref\": \"#/$defs/packet\"}}, \"bits\": " +
      Schema::number(13) +
      ", \"padding\": {\"type\": \"string\", \"pattern\": \"^[0-9A-F]*$\"}, \"airgap\": {\"type\": \"object\"}}, "
      "\"required\": [\"header\"], \"additionalProperties\": false},\n";
  out +=
      "\"refusal\": {\"type\": \"object\", \"properties\": {\"error\": {\"type\": \"object\", \"properties\": "
      "{\"line\": {\"type\": \"integer\", \"minimum\": 1}, \"bit\": "
      "{\"type\": \"integer\", \"minimum\": 0}, \"packet\": " +
      Schema::number(8) +
      ", \"variable\": {\"type\": \"string\"}, \"value\": {\"type\": \"integer\"}, \"why\": {\"type\": \"string\"}}, "
      "\"required\": [\"bit\", \"why\"]}, \"airgap\": {\"type\": \"object\"}}, "
      "\"required\": [\"error\"], \"additionalProperties\": false},\n";
  out += "\"message\": {\"anyOf\": [";
  bool first = true;
  for (const lang::MessageLayout& m : lang::message_layouts()) {
    out += first ? "\n" : ",\n";
    first = false;
    Schema().object(
        out, m.steps,
        "\"NID_MESSAGE\": {\"const\": " + std::to_string(m.info->NID_MESSAGE) +
            "}, \"L_MESSAGE\": " + Schema::number(10) +
            ", \"system_version\": {\"type\": \"string\"}, \"packets\": {\"type\": \"array\", \"items\": {\"$ref\": "
            "\"#/$defs/packet\"}}, \"padding\": {\"type\": \"string\"}",
        "\"NID_MESSAGE\"");
  }
  out += "]},\n\"packet\": {\"anyOf\": [";
  out += "\n{\"type\": \"object\", \"properties\": {\"NID_PACKET\": " + Schema::number(8) +
         ", \"Q_DIR\": " + Schema::number(2) + ", \"L_PACKET\": " + Schema::number(13) +
         ", \"raw\": {\"type\": \"string\", \"pattern\": \"^[0-9A-F]*$\"}}, \"required\": "
         "[\"NID_PACKET\", \"L_PACKET\", \"raw\"], \"additionalProperties\": false}";
  for (const PacketLayout& l : lang::packet_layouts()) {
    out += ",\n";
    std::string head = "\"NID_PACKET\": {\"const\": " + std::to_string(l.info->NID_PACKET) + "}";
    if (l.has_length) head += ", \"L_PACKET\": " + Schema::number(13);
    Schema().object(out, l.steps, head, "\"NID_PACKET\"");
  }
  out += "]}\n}\n}\n";
  return out;
}

std::string packet_page_name(std::uint8_t nid, Direction direction) {
  return (direction == Direction::to_train ? "packet_" : "train_packet_") + std::to_string(nid) + ".md";
}

std::string packet_index_page() {
  std::string out =
      "# The packets of the ETCS language\nOne page per packet, to be compared with SUBSET-026-7. Made by "
      "`tools/make_packet_pages`; a test keeps them up to date.\n";
  for (const Direction d : {Direction::to_train, Direction::to_track}) {
    out += d == Direction::to_train ? "\n## Track to train\n" : "\n## Train to track\n";
    out += "| packet | name | system versions |\n|---:|---|---|\n";
    int last = -1;
    for (const PacketLayout& l : lang::packet_layouts()) {
      if (l.info->direction != d) continue;
      if (l.info->NID_PACKET == last) {
        out.resize(out.size() - 3);
        out += "; " + versions_text(l.info->versions) + " |\n";
        continue;
      }
      last = l.info->NID_PACKET;
      out += "| " + std::to_string(last) + " | [" + l.info->name + "](" + packet_page_name(l.info->NID_PACKET, d) +
             ") | " + versions_text(l.info->versions) + " |\n";
    }
  }
  return out;
}

}  // namespace evc::io
