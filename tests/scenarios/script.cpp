#include "script.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "io/telegram_json.h"
#include "lang/message_table.h"
#include "terms/srs_version.h"
#include "words.h"

namespace evc::scenario {
namespace {

/// Names of the outputs (`evc replay`, docs/replay.md) that a condition may name. Lists are tested with `has` and
/// `lacks`.
constexpr auto kOutputs = std::to_array<const char*>({
    "t_ms",
    "mode",
    "level",
    "lrbg",
    "lrbg.NID_C",
    "lrbg.NID_BG",
    "est_front_m",
    "min_safe_front_m",
    "max_safe_front_m",
    "v_kmh",
    "monitoring",
    "status",
    "V_P",
    "V_W",
    "V_SBI",
    "V_EBI",
    "V_MRSP",
    "V_target",
    "d_target_m",
    "V_release",
    "EOA_m",
    "SvL_m",
    "tco",
    "sb",
    "eb",
    "brake_reasons",
    "driver.requests",
    "driver.texts",
    "driver.symbols",
    "V_I",
    "tti_s",
    "lssma_kmh",
    "mrdt_changed",
    "d_indication_m",
    "memo_status",
    "level_valid",
    "levels_allowed",
    "trip_reason",
    "geo_m",
    "rv_left_m",
    "version",
    "radio_register",
    "enabled",
    "messages",
    "track_conditions",
    "train_orders",
    "sessions",
    "planning",
    "dmi",
    "data",
    "clock",
    "shown",
    "set_speed_kmh",
    "language",
    "dialogue",
    "dialogue.procedure",
    "dialogue.step",
    "dialogue.waits_for",
    "forwarded",
});

/// Outputs with elements and members of their own: "train_orders.pantograph.0.to_end_m".
constexpr std::array<const char*, 8> kStructured{
    "track_conditions", "train_orders", "sessions", "planning", "dmi", "data", "clock", "forwarded"};
constexpr std::array<const char*, 19> kModes{"NP", "SB", "PS", "SH", "FS", "LS", "SR", "OS", "SL", "NL",
                                             "UN", "TR", "PT", "SF", "IS", "SN", "RV", "SM", "AD"};
constexpr std::array<const char*, 5> kLevels{"0", "NTC", "1", "2", "3"};
/// The kinds of `covers`; their names are checked elsewhere.
constexpr std::array<const char*, 6> kCovers{"message", "procedure", "stored", "brake", "step", "cell"};

template <std::size_t N>
bool is_one(const std::array<const char*, N>& names, std::string_view word) {
  return std::any_of(names.begin(), names.end(), [&](const char* n) { return word == n; });
}
template <std::size_t N>
std::string all(const std::array<const char*, N>& names) {
  std::string text;
  for (const char* n : names) text += (text.empty() ? "" : ", ") + std::string(n);
  return text;
}

std::string joined(const Line& line) {
  std::string text;
  bool glued = true;
  for (const Token& t : line) {
    const bool closes = t.kind == Token::Kind::mark && (t.text == "]" || t.text == ",");
    if (!glued && !closes) text += ' ';
    glued = t.kind == Token::Kind::mark && t.text == "[";
    text += t.kind == Token::Kind::text ? '"' + t.text + '"' : t.text;
  }
  return text;
}

/// "3.10.2.2", "A.3.4", "4.6.3(31)", "SUBSET-034 2.2": digits and letters that look like a clause.
bool is_clause(std::string_view word) {
  if (word.empty()) return false;
  const bool srs = word[0] >= '1' && word[0] <= '9';
  const bool annex = word.size() > 2 && word[0] == 'A' && word[1] == '.';
  if (!srs && !annex) return false;
  return word.find('.') != std::string_view::npos &&
         word.find_first_not_of("0123456789.ABCDabcdefghijklmnopqrst()_-") == std::string_view::npos;
}

class Reader {
 public:
  Reader(std::string file, const std::vector<Block>& library) : file_(std::move(file)), library_(library) {}

  File read(std::string_view text) {
    const std::vector<Line> lines = joined_lines(cut(text));
    std::vector<std::string> also;
    for (std::size_t i = 0; i < lines.size();) {
      const std::string& head = lines[i][0].text;
      if (head == "also") {
        also.push_back(issue_of(lines[i++]));
        continue;
      }
      std::size_t end = i + 1;
      while (end < lines.size() && lines[end][0].text != "scenario" && lines[end][0].text != "block") ++end;
      const std::vector<Line> body(lines.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                                   lines.begin() + static_cast<std::ptrdiff_t>(end));
      if (head == "block")
        read_block(lines[i], body);
      else if (head == "scenario")
        read_scenario(lines[i], body);
      else
        throw ReadError{lines[i][0].line, "\"" + head + "\"", "scenario, block or also"};
      i = end;
    }
    for (const std::string& issue : also) repeat(issue);
    return std::move(out_);
  }

 private:
  static std::string issue_of(const Line& line) {
    for (const auto srs : {SrsVersion::v3_4_0, SrsVersion::v3_6_0, SrsVersion::v4_0_0})
      if (line.size() == 2 && line[1].text == evc::name(srs)) return line[1].text;
    throw ReadError{line[0].line, name_of(line, 0, line.size()), "also and an issue: 3.4.0, 3.6.0 or 4.0.0"};
  }

  /// Each scenario again, in another issue.
  void repeat(const std::string& srs) {
    const std::size_t n = out_.scenarios.size();
    for (std::size_t i = 0; i < n; ++i)
      if (out_.scenarios[i].srs.empty()) out_.scenarios.push_back(again_in(out_.scenarios[i], srs));
  }
  /// What it covers is of the issue of its `config`.
  static Scenario again_in(const Scenario& scenario, const std::string& srs) {
    Scenario again = scenario;
    again.name += " in " + srs;
    again.srs = srs;
    again.covers.clear();
    return again;
  }

  /// Packets and balises on separate lines belong to the line before.
  static std::vector<Line> joined_lines(const std::vector<Line>& lines) {
    std::vector<Line> out;
    for (const Line& line : lines) {
      const std::string& head = line[0].text;
      const bool goes_on = head == "packet" || head == "balise" || head == "bits";
      if (!out.empty() && line[0].kind == Token::Kind::word && goes_on)
        out.back().insert(out.back().end(), line.begin(), line.end());
      else
        out.push_back(line);
    }
    return out;
  }

  static std::string name_of(const Line& line, std::size_t from, std::size_t to) {
    std::string name;
    for (std::size_t i = from; i < to; ++i)
      name += (name.empty() || line[i].kind == Token::Kind::mark ? "" : " ") + line[i].text;
    return name;
  }

  const Block* find_block(const std::string& name) const {
    for (const auto* blocks : {&out_.blocks, &library_})
      for (const Block& b : *blocks)
        if (b.name == name) return &b;
    return nullptr;
  }

  static std::size_t with(const Line& line, std::size_t from) {
    for (std::size_t i = from; i < line.size(); ++i)
      if (line[i].kind == Token::Kind::word && line[i].text == "with") return i;
    return line.size();
  }

  /// `NAME = VALUE, NAME = VALUE`; a value is one word with its unit, a text, or a part in brackets.
  static std::vector<Parameter> parameters(const Line& line, std::size_t from) {
    std::vector<Parameter> found;
    std::size_t i = from;
    while (i < line.size()) {
      Parameter p;
      p.name = line[i].text;
      if (line[i].kind != Token::Kind::word || i + 1 >= line.size() || line[i + 1].text != "=")
        throw ReadError{line[i].line, "\"" + line[i].text + "\"", "NAME = VALUE, separated by commas"};
      i += 2;
      int depth = 0;
      for (; i < line.size(); ++i) {
        const Token& t = line[i];
        const bool mark = t.kind == Token::Kind::mark;
        if (mark && (t.text == "{" || t.text == "[")) ++depth;
        if (mark && (t.text == "}" || t.text == "]")) --depth;
        if (mark && t.text == "," && depth == 0) break;
        p.value.push_back(t);
      }
      if (p.value.empty()) throw ReadError{line[from].line, "no value for " + p.name, "NAME = VALUE"};
      if (i < line.size()) ++i;
      found.push_back(std::move(p));
    }
    return found;
  }

  void read_block(const Line& head, const std::vector<Line>& body) {
    const std::size_t end = with(head, 1);
    Block block;
    block.at = {file_, head[0].line, ""};
    block.name = name_of(head, 1, end);
    if (block.name.empty())
      throw ReadError{head[0].line, "block without a name", "block NAME [with NAME = VALUE, ...]"};
    if (find_block(block.name) != nullptr)
      throw ReadError{head[0].line, "block " + block.name + " again", "each name once"};
    if (end < head.size()) block.parameters = parameters(head, end + 1);
    block.body = body;
    // Checked at its place, with its own values.
    (void)expand(block, {}, "");
    out_.blocks.push_back(std::move(block));
  }

  std::vector<Statement> expand(const Block& block, const std::vector<Parameter>& given, const std::string& from) {
    if (++depth_ > 8) throw ReadError{block.at.line, "blocks that use each other", "at most 8 in each other"};
    std::vector<Line> body;
    for (const Line& line : block.body) {
      Line out;
      for (const Token& t : line) {
        if (t.kind != Token::Kind::word || t.text[0] != '$') {
          out.push_back(t);
          continue;
        }
        const Parameter* value = nullptr;
        for (const auto* list : {&block.parameters, &given})
          for (const Parameter& p : *list)
            if (p.name == t.text.substr(1)) value = &p;
        if (value == nullptr) throw ReadError{t.line, t.text, "a parameter of the block"};
        for (Token part : value->value) {
          part.line = t.line;
          out.push_back(std::move(part));
        }
      }
      body.push_back(std::move(out));
    }
    const std::string own = file_;
    file_ = block.at.file;
    const std::string before = called_from_;
    called_from_ = from;
    std::vector<Statement> statements;
    try {
      statements = read_statements(body);
    } catch (const ReadError& e) {
      // An error in a block of another file is also reported with the place of its use.
      file_ = own;
      if (from.empty() || block.at.file == own) throw;
      throw ReadError{line_of(from), "in " + block.at.file + " line " + std::to_string(e.line) + ": " + e.found,
                      e.expected};
    }
    file_ = own;
    called_from_ = before;
    for (Statement& s : statements) s.in_block = true;
    --depth_;
    return statements;
  }

  static int line_of(const std::string& place) {
    return std::atoi(place.c_str() + place.rfind(' ') + 1);  // NOLINT(cert-err34-c): written by ourselves
  }

  void read_scenario(const Line& head, const std::vector<Line>& body) {
    Scenario s;
    s.at = {file_, head[0].line, ""};
    s.name = name_of(head, 1, head.size());
    if (s.name.empty()) throw ReadError{head[0].line, "scenario without a name", "scenario NAME"};
    for (const Scenario& other : out_.scenarios)
      if (other.name == s.name) throw ReadError{head[0].line, "scenario " + s.name + " again", "each name once"};
    std::vector<Line> steps;
    std::vector<std::string> issues;
    for (const Line& line : body) {
      Words words(line);
      if (line[0].text == "also")
        issues.push_back(issue_of(line));
      else if (words.take("covers"))
        read_covers(words, s);
      else if (words.take("open"))
        s.open = words.text("\"finding\"");
      else
        steps.push_back(line);
    }
    s.statements = read_statements(steps);
    if (std::none_of(s.statements.begin(), s.statements.end(),
                     [](const Statement& x) { return x.kind == Statement::Kind::then && !x.in_block; }))
      throw ReadError{head[0].line, "a scenario that expects nothing", "at least one then"};
    out_.scenarios.push_back(s);
    for (const std::string& issue : issues) out_.scenarios.push_back(again_in(s, issue));
  }

  static void read_covers(Words& words, Scenario& s) {
    do {
      Cover c;
      c.kind = words.word("message, procedure, stored, brake or step");
      if (!is_one(kCovers, c.kind)) throw ReadError{words.place(), "\"" + c.kind + "\"", "one of " + all(kCovers)};
      c.name = words.next_is_text() ? words.text("a name") : words.word("what is covered");
      s.covers.push_back(std::move(c));
    } while (words.take(","));
    if (!words.end()) words.fail("a comma or the end of the line");
  }

  std::vector<Statement> read_statements(const std::vector<Line>& lines) {
    std::vector<Statement> out;
    Statement::Kind kind = Statement::Kind::given;
    bool begun = false;
    for (const Line& line : lines) {
      Words words(line);
      if (words.take("given"))
        kind = Statement::Kind::given;
      else if (words.take("when"))
        kind = Statement::Kind::when;
      else if (words.take("then"))
        kind = Statement::Kind::then;
      else if (!begun || !words.take("and"))
        words.fail("given, when, then or and");
      begun = true;
      Statement s;
      s.kind = kind;
      s.at = {file_, line[0].line, called_from_};
      s.text = joined(line);
      if (kind == Statement::Kind::then) {
        read_then(words, s);
      } else {
        if (const auto block = use_of_block(line)) {
          out.insert(out.end(), block->begin(), block->end());
          if (out.size() > 2000) throw ReadError{line[0].line, "more than 2000 steps", "fewer"};
          continue;
        }
        read_step(words, out, s);
      }
      if (!words.end()) words.fail("the end of the statement");
      out.push_back(std::move(s));
    }
    return out;
  }

  std::optional<std::vector<Statement>> use_of_block(const Line& line) {
    const std::size_t end = with(line, 1);
    const Block* block = find_block(name_of(line, 1, end));
    if (block == nullptr) return {};
    std::vector<Parameter> given;
    if (end < line.size()) given = parameters(line, end + 1);
    for (const Parameter& p : given)
      if (std::none_of(block->parameters.begin(), block->parameters.end(),
                       [&](const Parameter& own) { return own.name == p.name; }))
        throw ReadError{line[0].line, "\"" + p.name + "\"", "a parameter of " + block->name};
    const Block copy = *block;
    return expand(copy, given, file_ + " line " + std::to_string(line[0].line));
  }

  // --- given and when ---------------------------------------------------------------------------------------------

  /// Whether the step only gives inputs to one cycle, so that another step can share the cycle.
  static bool gives_inputs(const Action& a) {
    using What = Action::What;
    return a.what == What::message || a.what == What::loop || a.what == What::input;
  }

  void read_step(Words& words, const std::vector<Statement>& before, Statement& s) {
    const bool same_cycle = words.take("in");
    if (same_cycle)
      for (const char* word : {"the", "same", "cycle"}) words.require(word);
    read_action(words, s.action);
    s.action.same_cycle = same_cycle;
    if (!same_cycle) return;
    const bool shared = !before.empty() && before.back().kind != Statement::Kind::then &&
                        gives_inputs(before.back().action) &&
                        (gives_inputs(s.action) || s.action.what == Action::What::drive);
    if (!shared) words.fail("a message, a loop message, an input or drives after one of the first three");
  }

  void read_action(Words& words, Action& a) {
    using What = Action::What;
    if (words.take("config")) {
      a.what = What::configure;
      a.json = plain_json(words.object());
    } else if (words.take("train")) {
      a.what = What::configure;
      a.json = Json{{"train", plain_json(words.object())}};
    } else if (words.take("message")) {
      read_message(words, a);
    } else if (words.take("loop")) {
      a.what = What::loop;
      const Value header = words.peek() == "{" ? words.object() : Value{};
      a.json = telegram(header, true);
      read_packets(words, a.json, 2, 1);
      check_telegram(a.json, true, words.place());
    } else if (words.take("passes")) {
      a.what = What::pass;
      read_group(words, a);
    } else if (words.take("group")) {
      a.what = What::lay;
      a.NID_BG = words.integer(0, 16383, "NID_BG");
      words.require("lies");
      a.ahead_m = words.metres();
      if (words.one_of({"ahead", "from"}) == 1) {
        words.require("group");
        a.from_group = words.integer(0, 16383, "NID_BG");
      }
      read_balises(words, a);
    } else if (words.take("drives")) {
      read_drive(words, a);
    } else if (words.take("stops")) {
      a.what = What::stop;
      if (words.take("with")) a.a_mps2 = acceleration(words);
    } else if (words.take("waits")) {
      a.what = What::wait;
      if (words.take("until"))
        read_until(words, a);
      else
        a.for_s = words.seconds();
    } else if (words.take("driver")) {
      read_driver(words, a);
    } else if (words.take("session")) {
      static constexpr std::array<const char*, 3> names{"connected", "lost", "refused"};
      Json report{{"session", names[words.one_of({"connected", "lost", "refused"})]}};
      bool infill_unit = false;
      if (words.take("with")) {
        const Partner with = partner(words);
        report["to"] = Json{{"NID_C", 1}, {with.key(), with.number}};
        infill_unit = with.infill_unit;
      }
      a = input(infill_unit ? "radio_in_fill" : "radio", report);
    } else if (words.take("desk")) {
      a = input("train", {{"desk_open", words.one_of({"closed", "opened"}) == 1}});
    } else if (words.take("power")) {
      a = input("train", {{"powered", words.one_of({"off", "on"}) == 1}});
    } else if (words.take("unit")) {
      words.require("replaced");
      a.what = What::restart;
    } else if (words.take("signal")) {
      a = input("train", plain_json(words.object()));
    } else if (words.take("national_system")) {
      a = input("national_system", plain_json(words.object()));
    } else if (words.take("fault")) {
      a = input("fault", plain_json(words.object()));
    } else if (words.take("input")) {
      a.what = What::input;
      a.json = plain_json(words.object());
    } else if (words.take("odometer")) {
      a.what = What::odometer;
      const bool error = words.one_of({"reads", "error"}) == 1;
      const double n = words.number("3 %") / 100.0;
      words.require("%");
      if (error)
        a.error = n;
      else if (words.one_of({"too_much", "too_little"}) == 0)
        a.reads = 1.0 + n;
      else
        a.reads = 1.0 - n;
    } else {
      words.fail(
          "a block, or one of config, train, message, loop, passes, group, drives, stops, waits, driver, session, "
          "desk, power, unit, signal, national_system, fault, input, odometer");
    }
  }

  static Partner partner(Words& words) {
    Partner p;
    p.infill_unit = words.take("RIU");
    if (!p.infill_unit) words.require("RBC");
    p.number = words.integer(0, 16383, p.key());
    return p;
  }

  static Action input(const char* key, Json value) {
    Action a;
    a.what = Action::What::input;
    a.json = Json{{key, std::move(value)}};
    return a;
  }

  static double acceleration(Words& words) {
    const double n = words.number("0.5 m/s2");
    words.require("m/s2");
    if (!(n > 0.0 && n < 100.0)) words.fail("a rate above 0");
    return n;
  }

  void read_until(Words& words, Action& a) {
    a.until = read_condition(words);
    if (words.take("within")) a.within_s = words.seconds();
  }

  void read_drive(Words& words, Action& a) {
    a.what = Action::What::drive;
    if (words.take("at")) {
      a.v_mps = words.speed();
      if (*a.v_mps > 160.0 || *a.v_mps < -160.0) words.fail("a speed within 576 km/h");
    }
    if (words.take("with")) a.a_mps2 = acceleration(words);
    if (words.take("for")) {
      char kind = 0;
      (void)unit_factor(words.peek(1), kind);
      if (kind == 'm')
        a.for_m = words.metres();
      else
        a.for_s = words.seconds();
    } else if (words.take("until")) {
      read_until(words, a);
    }
  }

  static void read_driver(Words& words, Action& a) {
    switch (words.one_of({"selects", "acknowledges", "opens", "closes", "enters"})) {
      case 0:
        a = input("driver", {{"select", words.word("what is selected")}});
        break;
      case 1:
        a = input("driver", {{"ack", words.word("what is acknowledged")}});
        break;
      case 2:
        a = input("driver", {{"window", {{"opened", words.word("an entry window")}}}});
        break;
      case 3:
        a = input("driver", {{"window", {{"closed", words.word("an entry window")}}}});
        break;
      default: {
        Json entered = plain_json(words.object());
        // A level is a name, even if it is a number.
        if (const auto level = entered.find("level"); level != entered.end() && level->is_number())
          *level = std::to_string(level->get<int>());
        a = input("driver", {{"enter", entered}});
      }
    }
  }

  /// X and Y of `version 1.1`; default 2.1.
  static void read_version(Words& words, int& X, int& Y) {
    if (!words.take("version")) return;
    constexpr std::array<const char*, lang::kVersions> kNames{"1.0", "1.1", "2.0", "2.1", "2.2", "2.3", "3.0"};
    const std::string version = words.word("1.0, 1.1, 2.0 to 2.3 or 3.0");
    if (std::none_of(kNames.begin(), kNames.end(), [&](const char* name) { return version == name; }))
      throw ReadError{words.place(), "\"" + version + "\"", "version 1.0, 1.1, 2.0 to 2.3 or 3.0"};
    X = version[0] - '0';
    Y = version[2] - '0';
  }

  /// The message that one with T_TRAIN_REF answers: 8 train data, 27 and 28 a request for shunting, 4 and 5 one for a
  /// supervised manoeuvre, 7 the safe consist length.
  static std::uint8_t answered_by(std::uint8_t nid) {
    switch (nid) {
      case 8:
        return 129;
      case 4:
      case 5:
        return 131;
      case 7:
        return 133;
      default:
        return 130;
    }
  }

  void read_message(Words& words, Action& a) {
    a.what = Action::What::message;
    const int line = words.place();
    const auto nid = static_cast<std::uint8_t>(words.integer(0, 127, "the number of a message to the train"));
    int X = 2, Y = 1;
    read_version(words, X, Y);
    if (words.take("from")) a.from = partner(words);
    if (words.take("sent")) {
      a.ago_s = words.seconds();
      words.require("ago");
    }
    const Value members = words.peek() == "{" ? words.object() : Value{};
    const auto named = [&](const char* name) {
      return std::any_of(members.members.begin(), members.members.end(),
                         [&](const Value& m) { return m.name == name; });
    };
    a.json = message_json(nid, &members, line, X, Y);
    a.T_TRAIN = a.json.contains("T_TRAIN") && !named("T_TRAIN");
    a.NID_LRBG = a.json.contains("NID_LRBG") && !named("NID_LRBG");
    if (a.json.contains("T_TRAIN_REF") && !named("T_TRAIN_REF")) a.answers = answered_by(nid);
    a.json["system_version"] = std::to_string(X) + "." + std::to_string(Y);
    read_packets(words, a.json, X, Y);
    read_damage(words, a.damage);
    if (words.take("cut"))
      a.damage.bytes = -bytes_of(words);
    else if (words.take("longer"))
      a.damage.bytes = bytes_of(words);
    const auto bits = io::encode_radio_json(a.json, {lang::Direction::to_train, {}});
    if (!bits)
      throw ReadError{line, "message " + std::to_string(nid) + " " + bits.error().variable,
                      "one that can be encoded (" + bits.error().why + ")"};
  }

  static void read_packets(Words& words, Json& to, int X, int Y) {
    Json packets = Json::array();
    while (words.peek() == "packet") {
      words.require("packet");
      const int line = words.place();
      const auto nid = static_cast<std::uint8_t>(words.integer(0, 254, "the number of a packet"));
      if (words.peek() == "{") {
        const Value members = words.object();
        packets.push_back(packet_json(nid, &members, line, X, Y));
      } else {
        packets.push_back(packet_json(nid, nullptr, line, X, Y));
      }
    }
    if (!packets.empty()) to["packets"] = packets;
  }

  /// `bits 50 to 57 are 99 ...`
  static void read_damage(Words& words, Damage& damage) {
    while (words.take("bits")) {
      Damage::Bits b;
      b.first = static_cast<std::size_t>(words.integer(0, 8191, "the first bit"));
      words.require("to");
      const auto least = static_cast<std::int64_t>(b.first);
      b.last = static_cast<std::size_t>(words.integer(least, least + 31, "the last of at most 32 bits"));
      words.require("are");
      b.value =
          static_cast<std::uint64_t>(words.integer(0, (std::int64_t{2} << (b.last - b.first)) - 1, "their value"));
      damage.bits.push_back(b);
    }
  }
  /// Other bits of a telegram that nobody decodes would say nothing.
  static void check_damage(const Balise& b, int line) {
    if ((b.spoiled || b.missing) && !b.damage.bits.empty())
      throw ReadError{line, std::string("bits of a balise that is ") + (b.missing ? "missing" : "spoiled"),
                      "bits of one that is read"};
  }
  static std::int64_t bytes_of(Words& words) {
    words.require("by");
    const std::int64_t n = words.integer(1, 100, "1 to 100 bytes");
    (void)words.one_of({"bytes", "byte"});
    return n;
  }

  /// The header of a telegram or loop message with the defaults.
  static Json telegram(const Value& members, bool loop) {
    Json header = loop ? Json{{"Q_UPDOWN", 1}, {"M_VERSION", 33}, {"Q_MEDIA", 1}, {"NID_C", 1}, {"NID_LOOP", 0}}
                       : Json{{"Q_UPDOWN", 1}, {"M_VERSION", 33}, {"Q_MEDIA", 0}, {"N_PIG", 0},  {"N_TOTAL", 1},
                              {"M_DUP", 0},    {"M_MCOUNT", 255}, {"NID_C", 1},   {"NID_BG", 0}, {"Q_LINK", 1}};
    for (const Value& value : members.members) {
      if (!header.contains(value.name))
        throw ReadError{value.line, "\"" + value.name + "\"", "a variable of the header"};
      header[value.name] = plain_json(value);
    }
    return Json{{"header", header}};
  }

  static void check_telegram(const Json& telegram, bool loop, int line) {
    const auto bits = loop ? io::encode_loop_json(telegram) : io::encode_balise_json(telegram);
    if (!bits)
      throw ReadError{line, "a telegram with " + bits.error().variable,
                      "one that can be encoded (" + bits.error().why + ")"};
  }

  void read_group(Words& words, Action& a) {
    words.require("group");
    a.NID_BG = words.integer(0, 16383, "NID_BG");
    read_balises(words, a);
  }

  /// `[reversed] [{ header }] packets [damage] [balise N [missing|spoiled] [{ header }] packets [damage]]...`
  static void read_balises(Words& words, Action& a) {
    const int line = words.place();
    a.reversed = words.take("reversed");
    std::int64_t balises = 2;
    if (words.take("of")) {
      balises = words.integer(1, 8, "1 to 8 balises");
      (void)words.one_of({"balises", "balise"});
    }
    const Value common = words.peek() == "{" ? words.object() : Value{};
    for (std::int64_t i = 0; i < balises; ++i) {
      Balise b;
      b.telegram = telegram(common, false);
      b.telegram["header"]["N_PIG"] = i;
      b.telegram["header"]["N_TOTAL"] = balises - 1;
      b.telegram["header"]["NID_BG"] = a.NID_BG;
      a.balises.push_back(std::move(b));
    }
    std::size_t of = 0;
    for (;;) {
      Balise& b = a.balises[of];
      const lang::SystemVersion sv = version_of(b.telegram);
      read_packets(words, b.telegram, sv.x, sv.y);
      read_damage(words, b.damage);
      check_damage(b, words.place());
      if (!words.take("balise")) break;
      of = static_cast<std::size_t>(words.integer(1, balises, "the number of the balise in the group")) - 1;
      if (words.take("missing")) a.balises[of].missing = true;
      if (words.take("spoiled")) a.balises[of].spoiled = true;
      if (a.balises[of].missing && a.balises[of].spoiled)
        throw ReadError{words.place(), "balise " + std::to_string(of + 1) + " both spoiled and missing", "one of them"};
      if (words.peek() == "{") {
        const Value own = words.object();
        const Json header = telegram(own, false);
        for (const Value& v : own.members) a.balises[of].telegram["header"][v.name] = header["header"][v.name];
      }
    }
    for (Balise& b : a.balises) {
      const lang::SystemVersion sv = version_of(b.telegram);
      b.telegram["system_version"] = std::to_string(sv.x) + "." + std::to_string(sv.y);
      b.telegram["bits"] = 830;
      check_telegram(b.telegram, false, line);
    }
  }

  static lang::SystemVersion version_of(const Json& telegram) {
    const Json& code = telegram["header"]["M_VERSION"];
    const lang::SystemVersion sv = lang::system_version(code.is_number_integer() ? code.get<std::uint64_t>() : 33u);
    return lang::known_version(sv) == 0 ? lang::SystemVersion{2, 1} : sv;
  }

  // --- then -------------------------------------------------------------------------------------------------------

  void read_then(Words& words, Statement& s) {
    if (words.take("within"))
      s.within_s = words.seconds();
    else if (words.take("for"))
      s.for_s = words.seconds();
    s.condition = read_condition(words);
    if (words.end()) words.fail("the clause in brackets, as in [3.10.2.2]");
    words.require("[");
    do {
      const std::string clause = words.word("a clause");
      if (!is_clause(clause)) throw ReadError{words.place(), "\"" + clause + "\"", "a clause, as 3.10.2.2 or A.3.4"};
      s.clauses.push_back(clause);
    } while (words.take(","));
    words.require("]");
  }

  Condition read_condition(Words& words) {
    using What = Condition::What;
    Condition c;
    if (words.take("no")) {
      c.negated = true;
      switch (words.one_of({"event", "symbol", "request", "text", "cause"})) {
        case 0:
          return event(words, c);
        case 1:
          return list("driver.symbols", words, true);
        case 2:
          return list("driver.requests", words, true);
        case 3:
          return list("driver.texts", words, true);
        default:
          return list("brake_reasons", words, true);
      }
    }
    if (words.take("event")) return event(words, c);
    if (words.take("symbol")) return list("driver.symbols", words, false);
    if (words.take("request")) return list("driver.requests", words, false);
    if (words.take("text")) return list("driver.texts", words, false);
    if (words.take("cause")) return list("brake_reasons", words, false);
    if (words.take("brakes")) return brakes(words);
    if (words.take("sends")) {
      c.what = What::message;
      c.negated = words.take("no");
      words.require("message");
      c.message.NID_MESSAGE = static_cast<int>(words.integer(128, 255, "the number of a message to the trackside"));
      if (words.take("to")) c.message.to = partner(words);
      c.message.members = words.peek() == "{" ? sent_members(words.object()) : Json::object();
      while (words.take("packet")) {
        const std::int64_t nid = words.integer(0, 255, "the number of a packet");
        Json packet = words.peek() == "{" ? sent_members(words.object()) : Json::object();
        packet["NID_PACKET"] = nid;
        c.message.packets.push_back(std::move(packet));
      }
      return c;
    }
    if (words.take("calls")) return address(words, What::call);
    if (words.take("hangs_up")) return address(words, What::hang_up);
    return output(words);
  }

  static Condition address(Words& words, Condition::What what) {
    Condition c;
    c.what = what;
    c.negated = words.take("nobody");
    c.address = !c.negated && words.peek() == "{" ? plain_json(words.object()) : Json::object();
    return c;
  }

  static Condition event(Words& words, Condition c) {
    c.what = Condition::What::event;
    c.pattern = words.text("\"the event as it is printed\", with * for any characters");
    return c;
  }

  static Condition list(const char* key, Words& words, bool lacks) {
    Condition c;
    c.key = key;
    c.wanted.how = lacks ? Wanted::How::lacks : Wanted::How::has;
    c.wanted.value = words.next_is_text() ? words.text("a text") : words.word("a name");
    return c;
  }

  static Condition brakes(Words& words) {
    Condition c;
    c.what = Condition::What::brakes;
    switch (words.one_of({"none", "traction", "service", "emergency"})) {
      case 0:
        break;
      case 1:
        c.tco = true;
        break;
      case 2:
        c.sb = true;
        break;
      default:
        c.eb = true;
    }
    if (words.take("because")) do {
        c.reasons.push_back(words.next_is_text() ? words.text("a cause") : words.word("a cause"));
      } while (words.take("and"));
    return c;
  }

  Condition output(Words& words) {
    Condition c;
    const int line = words.place();
    c.key = words.word("what is expected");
    if (!is_one(kOutputs, c.key) && !is_one(kStructured, c.key.substr(0, c.key.find('.'))))
      throw ReadError{
          line, "\"" + c.key + "\"",
          "event, brakes, symbol, request, text, cause, sends, calls, hangs_up, no, or an output: " + all(kOutputs)};
    if (c.key == "mode" || c.key == "level") {
      const bool is_not = words.take("not");
      if (is_not) c.wanted.how = Wanted::How::lacks;
      const std::string word = words.word(c.key.c_str());
      const bool known = c.key == "mode" ? is_one(kModes, word) : is_one(kLevels, word);
      if (!known) throw ReadError{line, "\"" + word + "\"", "one of " + (c.key == "mode" ? all(kModes) : all(kLevels))};
      c.wanted.value = word;
      return c;
    }
    static constexpr std::array<Wanted::How, 6> hows{Wanted::How::equal,   Wanted::How::above, Wanted::How::below,
                                                     Wanted::How::between, Wanted::How::has,   Wanted::How::lacks};
    c.wanted.how = hows[words.one_of({"is", "above", "below", "between", "has", "lacks"})];
    read_wanted(words, c);
    return c;
  }

  static void read_wanted(Words& words, Condition& c) {
    Wanted& w = c.wanted;
    const auto n = words.next_is_text() ? std::nullopt : number_of(words.peek());
    if (!n) {
      if (words.take("null"))
        w.how = Wanted::How::absent;
      else
        w.value = plain_json(words.value());
      return;
    }
    const auto number = [&] {
      const Value v = words.value();
      char kind = 0;
      const double factor = v.unit.empty() ? 1.0 : unit_factor(v.unit, kind);
      // Outputs are in km/h and metres.
      return v.number * (kind == 'v' ? factor * 3.6 : factor);
    };
    w.value = number();
    w.tolerance = 0.001;
    if (w.how == Wanted::How::between) {
      words.require("and");
      w.upper = number();
    }
    if (words.take("from")) {
      if (words.one_of({"group", "front"}) == 0)
        w.from_group = words.integer(0, 16383, "NID_BG");
      else
        w.from_front = true;
    }
    if (words.take("+-")) w.tolerance = number();
  }

  std::string file_;
  const std::vector<Block>& library_;
  std::string called_from_;
  int depth_ = 0;
  File out_;
};

}  // namespace

std::string Place::text() const {
  std::string t = file + ":" + std::to_string(line);
  if (!called_from.empty()) t += " (used in " + called_from + ")";
  return t;
}

io::Result<File> read(std::string_view text, const std::string& file, const std::vector<Block>& library) {
  try {
    return Reader(file, library).read(text);
  } catch (const ReadError& e) {
    return tl::unexpected(io::Diagnostic{file, "line " + std::to_string(e.line), e.found, e.expected});
  }
}

}  // namespace evc::scenario
