#include "words.h"

#include <array>
#include <charconv>
#include <cmath>

#include "io/telegram_json.h"
#include "lang/layouts.h"
#include "lang/variable_table.h"

namespace evc::scenario {
namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r'; }
bool is_mark(char c) { return c == '{' || c == '}' || c == '[' || c == ']' || c == ',' || c == '='; }

struct Unit {
  const char* name;
  double factor;
  char kind;
};
constexpr std::array<Unit, 10> kUnits{{{"m", 1.0, 'm'},
                                       {"km", 1000.0, 'm'},
                                       {"s", 1.0, 's'},
                                       {"ms", 0.001, 's'},
                                       {"min", 60.0, 's'},
                                       {"km/h", 1.0 / 3.6, 'v'},
                                       {"m/s", 1.0, 'v'},
                                       {"permille", 1.0, 'g'},
                                       {"m/s2", 1.0, 'a'},
                                       {"%", 0.01, '%'}}};

/// A variable that is not given is 0, except these.
struct Default {
  const char* name;
  std::uint64_t code;
};
constexpr std::array<Default, 14> kDefaults{{{"Q_DIR", 1},
                                             {"M_VERSION", 33},
                                             {"Q_SCALE", 1},
                                             {"Q_GDIR", 1},
                                             {"T_EMA", 1023},
                                             {"V_MAIN", 32},
                                             {"Q_LINKORIENTATION", 1},
                                             {"Q_LINKREACTION", 2},
                                             {"NID_C", 1},
                                             {"NID_RBC", 1},
                                             {"M_MODETEXTDISPLAY", 15},
                                             {"M_LEVELTEXTDISPLAY", 5},
                                             {"T_TEXTDISPLAY", 1023},
                                             {"L_TEXTDISPLAY", 32767}}};

std::uint64_t default_code(const char* name) {
  for (const Default& d : kDefaults)
    if (std::string_view(d.name) == name) return d.code;
  return 0;
}

double scale_of(std::uint64_t Q_SCALE) { return Q_SCALE == 0 ? 0.1 : Q_SCALE == 2 ? 10.0 : 1.0; }

/// The code of a value of this variable.
Json code_of(const Value& v, const std::string& name, const lang::VariableInfo* info, std::uint64_t Q_SCALE) {
  if (v.kind == Value::Kind::text || v.kind == Value::Kind::list) return plain_json(v);
  if (v.kind == Value::Kind::word) {
    if (v.text == "unknown" && info != nullptr) return lang::all_ones(info->bits);
    throw ReadError{v.line, "\"" + v.text + "\"", "a number for " + name};
  }
  if (v.kind != Value::Kind::number) throw ReadError{v.line, "an object", "a number for " + name};
  double code = v.number;
  if (!v.unit.empty()) {
    char kind = 0;
    const double si = v.number * unit_factor(v.unit, kind);
    if (info == nullptr) throw ReadError{v.line, name + " with a unit", "a code"};
    if (info->by_scale && kind == 'm') {
      code = si / scale_of(Q_SCALE);
    } else if (info->resolution > 0.0) {
      const std::string unit = info->unit;
      char wanted = 0;

      const double factor = unit_factor(unit, wanted);
      if (wanted != kind) throw ReadError{v.line, v.text + " " + v.unit, "a value of " + name + " in " + unit};
      code = si / factor / info->resolution;
    } else {
      throw ReadError{v.line, v.text + " " + v.unit,
                      info->by_scale ? "a value of " + name + " in m" : "a code of " + name};
    }
    if (std::abs(code - std::round(code)) > 1e-6)
      throw ReadError{v.line, v.text + " " + v.unit, "a value that " + name + " can carry"};
    code = std::round(code);
  }
  if (code != std::floor(code) || std::abs(code) > 9e15) throw ReadError{v.line, v.text, "a whole number for " + name};
  if (code < 0) return static_cast<std::int64_t>(code);
  return static_cast<std::uint64_t>(code);
}

const Value* member(const Value* object, std::string_view name) {
  if (object == nullptr) return nullptr;
  for (const Value& value : object->members)
    if (value.name == name) return &value;
  return nullptr;
}

std::uint64_t as_code(const Json& j) {
  if (j.is_number_unsigned()) return j.get<std::uint64_t>();
  if (j.is_number_integer()) return static_cast<std::uint64_t>(j.get<std::int64_t>());
  return 0;
}

struct Scope {
  std::span<const lang::Step> steps;
  const std::uint64_t* codes;
  const Scope* up;
};

std::uint64_t around(const Scope* scope, std::string_view variable) {
  for (const Scope* s = scope; s != nullptr; s = s->up)
    for (std::size_t i = 0; i < s->steps.size(); ++i)
      if (s->steps[i].kind == lang::Step::Kind::field && s->steps[i].variable == variable) return s->codes[i];
  return 0;
}

/// Writes every member of the layout; an unknown member is an error that lists the known ones.
void fill(Json& out, std::span<const lang::Step> steps, const Value* given, std::uint64_t& Q_SCALE, const Scope* up,
          const std::string& where, int line) {
  std::vector<std::uint64_t> codes(steps.size());
  const Scope scope{steps, codes.data(), up};
  std::vector<bool> there(steps.size());
  using Kind = lang::Step::Kind;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const lang::Step& step = steps[i];
    there[i] = true;
    switch (step.kind) {
      case Kind::field: {
        const Value* v = member(given, step.name);
        const Json code = v != nullptr ? code_of(*v, step.name, lang::find_variable(step.variable), Q_SCALE)
                                       : Json(default_code(step.variable));
        codes[i] = as_code(code);
        if (std::string_view(step.name) == "Q_SCALE") Q_SCALE = codes[i];
        out[step.name] = code;
        break;
      }
      case Kind::when:
        if (!step.test(codes[step.condition])) i += step.count;
        break;
      case Kind::when_around:
        if (!step.test(around(scope.up, step.variable))) i += step.count;
        break;
      case Kind::repeat: {
        Json elements = Json::array();
        const Value* v = member(given, step.name);
        if (v != nullptr && v->kind == Value::Kind::text) {
          // Characters of a text (packet 72), digits of a telephone number.
          for (const char c : v->text) {
            Json element = Json::object();
            for (const lang::Step& s : step.element()) element[s.name] = static_cast<unsigned char>(c);
            elements.push_back(element);
          }
        } else if (v != nullptr) {
          if (v->kind != Value::Kind::list) throw ReadError{v->line, v->text, std::string("a list for ") + step.name};
          for (const Value& item : v->items) {
            if (item.kind != Value::Kind::object) throw ReadError{item.line, item.text, "an object { ... }"};
            Json element = Json::object();
            fill(element, step.element(), &item, Q_SCALE, &scope, where + " " + step.name, item.line);
            elements.push_back(element);
          }
        }
        out[step.name] = elements;
        break;
      }
      case Kind::rest: {
        const Value* v = member(given, step.name);
        out[step.name] = v != nullptr ? v->text : "";
        break;
      }
    }
  }
  if (given == nullptr) return;
  for (const Value& value : given->members) {
    const std::string& key = value.name;
    std::string known;
    bool found = false, stands = false;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      if (steps[i].kind == Kind::when || steps[i].kind == Kind::when_around) continue;
      if (key == steps[i].name) {
        found = true;
        stands = stands || there[i];
      }
      known += known.empty() ? "" : " ";
      known += steps[i].name;
    }
    if (!found) throw ReadError{value.line, "\"" + key + "\"", "a variable of " + where + ": " + known};
    if (!stands) throw ReadError{value.line, "\"" + key + "\"", "it only where its condition in " + where + " holds"};
  }
  (void)line;
}

}  // namespace

std::optional<double> number_of(const std::string& word) {
  double n = 0.0;
  const char* from = word.data();
  const char* end = from + word.size();
  if (word.size() > 2 && word[0] == '0' && word[1] == 'x') {
    std::uint64_t code = 0;
    const auto [stop, error] = std::from_chars(from + 2, end, code, 16);
    if (error != std::errc{} || stop != end) return {};
    return static_cast<double>(code);
  }
  if (word.empty() || (word[0] != '-' && (word[0] < '0' || word[0] > '9'))) return {};
  const auto [stop, error] = std::from_chars(from, end, n);
  if (error != std::errc{} || stop != end || !std::isfinite(n)) return {};
  return n;
}

double unit_factor(const std::string& unit, char& kind) {
  for (const Unit& u : kUnits)
    if (unit == u.name) {
      kind = u.kind;
      return u.factor;
    }
  kind = 0;
  return 0.0;
}

std::vector<Line> cut(std::string_view text) {
  std::vector<Line> lines;
  Line line;
  int number = 1, depth = 0, opened = 0;
  const auto finish = [&] {
    if (!line.empty()) lines.push_back(std::move(line));
    line.clear();
  };
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == '\n') {
      if (depth == 0) finish();
      ++number;
      ++i;
    } else if (is_space(c)) {
      ++i;
    } else if (c == '#') {
      while (i < text.size() && text[i] != '\n') ++i;
    } else if (c == '"') {
      const std::size_t end = text.find_first_of("\"\n", i + 1);
      if (end == std::string_view::npos || text[end] != '"')
        throw ReadError{number, "the end of the line", "\" that closes the text"};
      line.push_back({Token::Kind::text, std::string(text.substr(i + 1, end - i - 1)), number});
      i = end + 1;
    } else if (is_mark(c)) {
      if (c == '{' || c == '[') {
        if (depth == 0) opened = number;
        if (++depth > 16) throw ReadError{number, "more than 16 open brackets", "fewer"};
      }
      if ((c == '}' || c == ']') && --depth < 0) throw ReadError{number, std::string(1, c), "what it closes"};
      line.push_back({Token::Kind::mark, std::string(1, c), number});
      ++i;
    } else {
      std::size_t end = i;
      while (end < text.size() && !is_space(text[end]) && text[end] != '\n' && !is_mark(text[end]) &&
             text[end] != '"' && text[end] != '#')
        ++end;
      line.push_back({Token::Kind::word, std::string(text.substr(i, end - i)), number});
      i = end;
    }
  }
  if (depth > 0) throw ReadError{opened, "the end of the file", "the bracket that closes this one"};
  finish();
  return lines;
}

int Words::place() const {
  if (line_.empty()) return 0;
  return at_ < line_.size() ? line_[at_].line : line_.back().line;
}
const std::string& Words::peek(std::size_t ahead) const {
  static const std::string nothing;
  return at_ + ahead < line_.size() ? line_[at_ + ahead].text : nothing;
}
bool Words::take(std::string_view word) {
  if (end() || line_[at_].kind == Token::Kind::text || line_[at_].text != word) return false;
  ++at_;
  return true;
}
void Words::require(std::string_view word) {
  if (!take(word)) fail(std::string(word));
}
void Words::fail(const std::string& expected) const {
  throw ReadError{place(), end() ? "the end of the statement" : "\"" + line_[at_].text + "\"", expected};
}
std::string Words::word(const char* expected) {
  if (end() || line_[at_].kind != Token::Kind::word) fail(expected);
  return line_[at_++].text;
}
std::string Words::text(const char* expected) {
  if (end() || line_[at_].kind != Token::Kind::text) fail(expected);
  return line_[at_++].text;
}
std::size_t Words::one_of(std::initializer_list<const char*> words) {
  std::string all;
  std::size_t i = 0;
  for (const char* w : words) {
    if (take(w)) return i;
    ++i;
    all += all.empty() ? "" : ", ";
    all += w;
  }
  fail("one of " + all);
}
double Words::number(const char* expected) {
  const auto n = end() || line_[at_].kind != Token::Kind::word ? std::nullopt : number_of(line_[at_].text);
  if (!n) fail(expected);
  ++at_;
  return *n;
}
std::int64_t Words::integer(std::int64_t least, std::int64_t most, const char* expected) {
  const auto n = end() || line_[at_].kind != Token::Kind::word ? std::nullopt : number_of(line_[at_].text);
  if (!n || *n != std::floor(*n) || *n < static_cast<double>(least) || *n > static_cast<double>(most)) fail(expected);
  ++at_;
  return static_cast<std::int64_t>(*n);
}

namespace {
double measured(Words& words, char wanted, const char* expected) {
  const double n = words.number(expected);
  char kind = 0;
  const double factor = unit_factor(words.peek(), kind);
  if (kind != wanted) words.fail(std::string("a unit, as in \"") + expected + "\"");
  (void)words.word("a unit");
  return n * factor;
}
}  // namespace
double Words::metres() { return measured(*this, 'm', "100 m"); }
double Words::seconds() { return measured(*this, 's', "10 s"); }
double Words::speed() { return measured(*this, 'v', "60 km/h"); }

Value Words::value() {
  Value v;
  v.line = place();
  if (end()) fail("a value");
  const Token& token = line_[at_];
  if (token.kind == Token::Kind::text) {
    v.kind = Value::Kind::text;
    v.text = token.text;
    ++at_;
    return v;
  }
  if (token.text == "{") return object();
  if (take("[")) {
    v.kind = Value::Kind::list;
    while (!take("]")) {
      if (take(",")) continue;
      v.items.push_back(value());
    }
    return v;
  }
  if (token.kind == Token::Kind::mark) fail("a value");
  v.text = token.text;
  ++at_;
  if (const auto n = number_of(v.text)) {
    v.kind = Value::Kind::number;
    v.number = *n;
    char kind = 0;
    if (!end() && line_[at_].kind == Token::Kind::word && unit_factor(line_[at_].text, kind) != 0.0)
      v.unit = line_[at_++].text;
  }
  return v;
}

Value Words::object() {
  Value v;
  v.kind = Value::Kind::object;
  v.line = place();
  require("{");
  while (!take("}")) {
    if (take(",")) continue;
    const int line = place();
    const std::string name = next_is_text() ? text("a name or }") : word("a name or }");
    for (const Value& other : v.members)
      if (other.name == name) throw ReadError{line, "\"" + name + "\" again", "each name once"};
    v.members.push_back(value());
    v.members.back().name = name;
  }
  return v;
}

Json plain_json(const Value& v) {
  switch (v.kind) {
    case Value::Kind::number:
      if (v.number == std::floor(v.number) && std::abs(v.number) < 9e15) return static_cast<std::int64_t>(v.number);
      return v.number;
    case Value::Kind::word:
      if (v.text == "true") return true;
      if (v.text == "false") return false;
      if (v.text == "null") return nullptr;
      return v.text;
    case Value::Kind::text:
      return v.text;
    case Value::Kind::object: {
      Json object = Json::object();
      for (const Value& value : v.members) object[value.name] = plain_json(value);
      return object;
    }
    case Value::Kind::list: {
      Json list = Json::array();
      for (const Value& item : v.items) list.push_back(plain_json(item));
      return list;
    }
  }
  return nullptr;
}

Json packet_json(std::uint8_t NID_PACKET, const Value* members, int line, int X, int Y) {
  const lang::SystemVersion sv{static_cast<std::uint8_t>(X), static_cast<std::uint8_t>(Y)};
  const lang::PacketLayout* layout =
      lang::find_packet_layout(lang::Direction::to_train, lang::known_version(sv), NID_PACKET);
  if (layout == nullptr)
    throw ReadError{line, "packet " + std::to_string(NID_PACKET), "a packet to the train of this system version"};
  Json packet = Json::object();
  packet["NID_PACKET"] = NID_PACKET;
  std::uint64_t Q_SCALE = 1;
  fill(packet, layout->steps, members, Q_SCALE, nullptr, "packet " + std::to_string(NID_PACKET), line);
  const auto bits = io::encode_packet_json(packet, {lang::Direction::to_train, sv});
  if (!bits)
    throw ReadError{line, "packet " + std::to_string(NID_PACKET) + " " + bits.error().variable,
                    "one that can be encoded (" + bits.error().why + ")"};
  return packet;
}

Json message_json(std::uint8_t NID_MESSAGE, const Value* members, int line, int X, int Y) {
  const lang::SystemVersion sv{static_cast<std::uint8_t>(X), static_cast<std::uint8_t>(Y)};
  const lang::MessageLayout* layout = lang::find_message_layout(lang::Direction::to_train, sv, NID_MESSAGE);
  if (layout == nullptr)
    throw ReadError{line, "message " + std::to_string(NID_MESSAGE), "a message to the train of this system version"};
  Json message = Json::object();
  message["NID_MESSAGE"] = NID_MESSAGE;
  std::uint64_t Q_SCALE = 1;
  fill(message, layout->steps, members, Q_SCALE, nullptr, "message " + std::to_string(NID_MESSAGE), line);
  return message;
}

namespace {
/// The variable of a member of a message of the on-board; null if no message or packet has one of this name.
const lang::VariableInfo* find_sent(std::span<const lang::Step> steps, std::string_view name) {
  for (const lang::Step& step : steps) {
    if (step.kind == lang::Step::Kind::field && name == step.name) return lang::find_variable(step.variable);
    if (step.kind != lang::Step::Kind::repeat) continue;
    if (const lang::VariableInfo* found = find_sent(step.element(), name)) return found;
  }
  return nullptr;
}
/// Whether a message of the on-board has a list of this name.
bool is_sent_list(std::string_view name) {
  for (const lang::PacketLayout& layout : lang::packet_layouts())
    for (const lang::Step& step : layout.steps)
      if (layout.info->direction == lang::Direction::to_track && step.kind == lang::Step::Kind::repeat &&
          name == step.name)
        return true;
  return false;
}
const lang::VariableInfo* find_sent(std::string_view name) {
  for (const lang::PacketLayout& layout : lang::packet_layouts())
    if (layout.info->direction == lang::Direction::to_track)
      if (const lang::VariableInfo* found = find_sent(layout.steps, name)) return found;
  for (const lang::MessageLayout& layout : lang::message_layouts())
    if (layout.info->direction == lang::Direction::to_track)
      if (const lang::VariableInfo* found = find_sent(layout.steps, name)) return found;
  return nullptr;
}
}  // namespace

Json sent_members(const Value& members) {
  Json out = Json::object();
  std::uint64_t Q_SCALE = 1;
  if (const Value* scale = member(&members, "Q_SCALE")) Q_SCALE = static_cast<std::uint64_t>(scale->number);
  for (const Value& value : members.members) {
    const std::string& key = value.name;
    if (value.kind == Value::Kind::list && is_sent_list(key)) {
      out[key] = Json::array();
      for (const Value& item : value.items) out[key].push_back(sent_members(item));
      continue;
    }
    const lang::VariableInfo* info = find_sent(key);
    if (info == nullptr) throw ReadError{value.line, "\"" + key + "\"", "a variable that the on-board sends"};
    out[key] = code_of(value, key, info, Q_SCALE);
  }
  return out;
}

}  // namespace evc::scenario
