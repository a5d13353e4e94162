#include "run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <initializer_list>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "brakes_page.h"
#include "display.h"
#include "io/input_stream.h"
#include "io/number.h"
#include "io/output_lines.h"
#include "io/retained_file.h"
#include "io/telegram_json.h"
#include "kernel/evc.h"
#include "kernel/examine.h"
#include "kernel/state.h"
#include "mode_coverage.h"
#include "modes/mode_properties.h"
#include "openevc/terms/dialogue.h"
#include "sim/cycle_inputs.h"

namespace evc::scenario {
namespace {

/// Maximum time of a scenario: 30 minutes of the unit's time.
constexpr std::int64_t kLongestMs = 30 * 60 * 1000;

struct Failure {
  const Statement* at;
  std::string expected, found;
  bool of_the_unit = true;  ///< false: the scenario itself cannot continue
};

/// The end of the text that begins at `at` in a JSON document.
std::size_t end_of_text(std::string_view document, std::size_t at) {
  for (std::size_t i = at + 1;;) {
    i = document.find_first_of("\"\\", i);
    if (i == std::string_view::npos || document[i] == '"') return i;
    i += 2;
  }
}

/// The end of the value that begins at `at` in an object: the comma or bracket behind it.
std::size_t end_of_value(std::string_view document, std::size_t at) {
  int depth = 0;
  for (std::size_t i = at; i < document.size(); ++i) {
    const char c = document[i];
    if (c == '"')
      i = end_of_text(document, i);
    else if (c == '{' || c == '[')
      ++depth;
    else if (depth == 0 && (c == ',' || c == '}'))
      return i;
    else if (c == '}' || c == ']')
      --depth;
  }
  return document.size();
}

/// The member `key` of an object as io::append_output writes it: keys without escapes, no blanks between what is
/// written. Empty: there is none.
std::string_view text_of_member(std::string_view object, std::string_view key) {
  for (std::size_t at = 1; at < object.size() && object[at] == '"';) {
    const std::size_t name_ends = end_of_text(object, at);
    const std::size_t from = name_ends + 2;  // behind the colon
    const std::size_t end = end_of_value(object, from);
    if (object.substr(at + 1, name_ends - at - 1) == key) return object.substr(from, end - from);
    at = end + 1;
  }
  return {};
}

/// A cycle that was run. The outputs of the last ones are kept; of others there is the line if it may be looked at
/// later.
struct Cycle {
  static constexpr std::size_t kKept = 3;  ///< cycles: as many as a report shows
  std::int64_t t_ms = 0;
  bool momentary = false;                         ///< it has events, messages or orders of the radio
  std::string line;                               ///< empty: not written yet
  std::map<std::string, Json, std::less<>> read;  ///< members of the line that were looked at
  std::vector<Json> messages;                     ///< those of `radio_out`, in the form of `evc decode radio`
};

/// `*` stands for any characters.
bool matches(std::string_view pattern, std::string_view text) {
  std::size_t p = 0, t = 0, star = std::string_view::npos, back = 0;
  while (t < text.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      back = t;
    } else if (p < pattern.size() && pattern[p] == text[t]) {
      ++p;
      ++t;
    } else if (star != std::string_view::npos) {
      p = star + 1;
      t = ++back;
    } else {
      return false;
    }
  }
  while (p < pattern.size() && pattern[p] == '*') ++p;
  return p == pattern.size();
}

/// The given members are equal; every element of a given list is in the list, an empty list is empty.
bool holds(const Json& wanted, const Json& found) {
  if (wanted.is_array())
    return found.is_array() && (!wanted.empty() || found.empty()) &&
           std::all_of(wanted.begin(), wanted.end(), [&](const Json& item) {
             return std::any_of(found.begin(), found.end(), [&](const Json& other) { return holds(item, other); });
           });
  if (!wanted.is_object()) return wanted == found;
  if (!found.is_object()) return false;
  for (const auto& [key, value] : wanted.items()) {
    const auto it = found.find(key);
    if (it == found.end() || !holds(value, *it)) return false;
  }
  return true;
}

constexpr std::array kVersions{lang::SystemVersion{2, 1}, lang::SystemVersion{2, 0}, lang::SystemVersion{1, 1},
                               lang::SystemVersion{1, 0}, lang::SystemVersion{3, 0}, lang::SystemVersion{2, 3},
                               lang::SystemVersion{2, 2}};

/// A message of the unit as JSON of `evc decode radio`, in the version of its receiver, or, if that is not known, in
/// the first one in which it can be read; a text with the reason if it cannot be read.
Json decoded(const std::string& hex, const std::optional<lang::SystemVersion>& of_receiver) {
  const auto bits = io::bits_of_hex(hex);
  if (!bits) return "no hexadecimal digits";
  std::string why;
  for (const lang::SystemVersion sv : kVersions) {
    if (of_receiver && sv != *of_receiver) continue;
    std::string text;
    const auto read = io::append_radio_json(text, bits->bytes, lang::Direction::to_track, sv);
    if (read) return Json::parse(text, nullptr, false);
    if (why.empty()) why = read.error().why + " " + read.error().variable;
  }
  return why;
}

bool is_sent(const WantedMessage& wanted, const Json& message) {
  if (!message.is_object() || message.value("NID_MESSAGE", 0) != wanted.NID_MESSAGE) return false;
  if (!holds(wanted.members, message)) return false;
  const Json packets = message.value("packets", Json::array());
  return std::all_of(wanted.packets.begin(), wanted.packets.end(), [&](const Json& packet) {
    return std::any_of(packets.begin(), packets.end(), [&](const Json& p) { return holds(packet, p); });
  });
}

/// Writes over bits that were encoded. False: they are beyond the end.
bool spoil(io::Bits& to, const Damage& damage) {
  for (const Damage::Bits& b : damage.bits) {
    if (b.last >= to.bits) return false;
    for (std::size_t i = b.first; i <= b.last; ++i) {
      const auto mask = static_cast<std::uint8_t>(0x80u >> (i % 8));
      const bool one = ((b.value >> (b.last - i)) & 1u) != 0;
      std::uint8_t& byte = to.bytes[i / 8];
      byte = static_cast<std::uint8_t>(one ? byte | mask : byte & ~mask);
    }
  }
  const auto bytes = static_cast<std::int64_t>(to.bytes.size()) + damage.bytes;
  if (bytes <= 0) return false;
  if (damage.bytes == 0) return true;
  to.bytes.resize(static_cast<std::size_t>(bytes));
  to.bits = 8 * to.bytes.size();
  return true;
}

class Run {
 public:
  explicit Run(const Scenario& scenario) : scenario_(scenario) {
    if (!scenario.srs.empty()) config_["srs"] = scenario.srs;
    const auto asks = [](const Statement& s, const char* output) {
      return s.condition.key.rfind(output, 0) == 0 || (s.action.until && s.action.until->key.rfind(output, 0) == 0);
    };
    for (const Statement& s : scenario.statements) {
      plans_ = plans_ || asks(s, "planning");
      shows_ = shows_ || asks(s, "dmi");
    }
  }

  /// As whole(); what was seen of the mode table counts with that of all scenarios.
  std::string watched() {
    std::string failure = whole();
    const std::size_t from = scenario_.at.file.rfind('/') + 1;
    const std::string file = scenario_.at.file.substr(from, scenario_.at.file.rfind('.') - from);
    if (stream_) modes_.add_to_all(file + ": " + scenario_.name);
    return failure;
  }
  std::string whole() {
    try {
      const std::vector<Statement>& all = scenario_.statements;
      for (std::size_t i = 0; i < all.size(); ++i) {
        shares_cycle_ = i + 1 < all.size() && all[i + 1].action.same_cycle;
        step(all[i]);
      }
    } catch (const Failure& f) {
      const bool expected =
          !scenario_.open.empty() && f.of_the_unit && !f.at->in_block && f.at->kind == Statement::Kind::then;
      return expected ? "" : report(f);
    }
    if (scenario_.open.empty()) return steps_not_seen() + cells_not_seen();
    return scenario_.at.text() + ": scenario " + scenario_.name + "\n  is open (" + scenario_.open +
           ") and holds now: move it to the others and delete its line `open`\n";
  }
  const std::string& inputs() const { return inputs_; }

 private:
  /// `covers step PROCEDURE.FROM>TO`: what the output `dialogue` can show of it has been seen, FROM before TO.
  std::string steps_not_seen() const {
    std::string text;
    for (const Cover& c : scenario_.covers) {
      const std::size_t dot = c.name.find('.'), arrow = c.name.find('>');
      if (c.kind != "step" || dot == std::string::npos) continue;
      const std::string procedure = c.name.substr(0, dot);
      const std::string from = c.name.substr(dot + 1, arrow - dot - 1);
      const std::string to = arrow == std::string::npos ? "" : c.name.substr(arrow + 1);
      auto at = steps_.begin();
      for (const std::string& step : {from, to}) {
        if (!is_shown(procedure, step)) continue;
        at = std::find(at, steps_.end(), procedure + "." + step);
        if (at != steps_.end()) continue;
        text += scenario_.at.text() + ": scenario " + scenario_.name + "\n  covers step " + c.name + ", and " + step +
                " was not seen" + (step == to ? " after " + from : "") + "\n";
        break;
      }
    }
    return text;
  }

  /// `covers cell FROM>TO`: the transition has been seen.
  std::string cells_not_seen() const {
    std::string text;
    for (const Cover& c : scenario_.covers) {
      const std::size_t arrow = c.name.find('>');
      if (c.kind != "cell" || arrow == std::string::npos) continue;
      if (modes_.has(c.name.substr(0, arrow), c.name.substr(arrow + 1))) continue;
      text += scenario_.at.text() + ": scenario " + scenario_.name + "\n  covers cell " + c.name +
              ", and the transition was not seen\n";
    }
    return text;
  }

  static bool is_shown(std::string_view procedure, std::string_view step) {
    return std::any_of(kDialogueRows.begin(), kDialogueRows.end(),
                       [&](const DialogueRow& row) { return procedure == row.procedure && step == row.step; });
  }

  void note_step() {
    const auto& shown = unit_->outputs.dialogue;
    if (!shown) return;
    const DialogueRow& row = kDialogueRows[terms::index(shown->step)];
    std::string now = std::string(row.procedure) + "." + row.step;
    if (steps_.empty() || steps_.back() != now) steps_.push_back(std::move(now));
  }

  void step(const Statement& s) {
    now_ = &s;
    if (s.kind == Statement::Kind::then) {
      expect(s);
      after_then_ = true;
      return;
    }
    if (s.kind == Statement::Kind::when && (after_then_ || !when_before_)) window_ = cycles_.size();
    when_before_ = s.kind == Statement::Kind::when;
    after_then_ = false;
    act(s.action);
  }

  // --- given and when ---------------------------------------------------------------------------------------------

  void act(const Action& a) {
    using What = Action::What;
    switch (a.what) {
      case What::configure:
        if (stream_) fail("config and train before anything else", "cycles have run", false);
        for (const auto& [key, value] : a.json.items()) {
          if (config_.contains(key) && config_[key].is_object() && value.is_object())
            config_[key].update(value);
          else
            config_[key] = value;
        }
        if (!scenario_.srs.empty()) config_["srs"] = scenario_.srs;
        break;
      case What::message:
        give_message(a);
        if (!shares_cycle_) cycle();
        break;
      case What::loop:
        give_bits("loop", io::encode_loop_json(a.json));
        if (!shares_cycle_) cycle();
        break;
      case What::pass:
        pass(a);
        break;
      case What::lay:
        lay(a);
        break;
      case What::drive:
        drive(a);
        break;
      case What::stop:
        while (v_ != 0.0) move(0.0, a.a_mps2);
        cycle();
        break;
      case What::wait:
        if (a.until)
          until(a);
        else
          run_for(a.for_s.value_or(0.0), v_, 1.0);
        break;
      case What::input:
        give_input(a.json);
        if (!shares_cycle_) cycle();
        break;
      case What::restart:
        replace_unit();
        break;
      case What::odometer:
        if (a.error) error_ = *a.error;
        if (!a.reads) break;
        offset_ += (reads_ - *a.reads) * front_;  // the counter continues from its value
        reads_ = *a.reads;
        break;
    }
  }

  void start() {
    if (stream_) return;
    give(Json{{"config", config_}}.dump());
    auto opened = io::InputStream::open(scenario_.at.file, [this](std::string& line) { return next_line(line); });
    if (!opened) fail("inputs that can be read", opened.error().text(), false);
    stream_ = std::make_unique<io::InputStream>(std::move(*opened));
    const io::Configuration& c = stream_->configuration();
    cycle_ms_ = c.cycle_ms;
    antenna_m_ = c.train.data.L_antenna_front.si;
    kernel::power_up(unit_->state, unit_->derived, c.for_kernel());
  }

  /// By another one, which has only what is in the file of `evc replay --persistent`.
  void replace_unit() {
    start();
    brakes_ = {};
    display_ = {};
    const auto kept = io::read_retained(io::retained_text(kernel::retained(unit_->state)), "the file kept");
    if (!kept) fail("a file that can be read", kept.error().text());
    *unit_ = {};
    if (!kernel::power_up(unit_->state, unit_->derived, stream_->configuration().for_kernel(), *kept))
      fail("data that a unit takes", "they are refused");
  }

  /// The stream reads one line ahead, where a cycle does not say that it is complete: at the beginning.
  bool next_line(std::string& line) {
    if (waiting_.empty()) {
      line = R"({"t_ms":0})";
      return true;
    }
    line = std::move(waiting_.front());
    waiting_.pop_front();
    return true;
  }

  std::int64_t next_ms() const { return static_cast<std::int64_t>(cycles_.size()) * cycle_ms_; }

  void queue(Json object) {
    start();
    object["t_ms"] = next_ms();
    queued_.push_back(object.dump());
  }

  /// The driver who enters `train_data {}` enters the train of the configuration.
  void give_input(Json input) {
    const Json::json_pointer entered("/driver/enter/train_data");
    if (input.contains(entered) && input[entered].empty() && config_.contains("train"))
      input[entered] = config_["train"];
    queue(std::move(input));
  }

  template <class Bits>
  void give_bits(const char* key, const Bits& bits, Json members = Json::object()) {
    if (!bits) fail("bits", bits.error().variable + " " + bits.error().why, false);
    // Whole bytes, filled up with ones (a loop message ends with packet 255).
    std::string hex = io::hex_of_bits(bits->bytes, bits->bits);
    if (hex.size() % 2 != 0) hex += 'F';
    members["message"] = hex;
    queue(Json{{key, members}});
  }

  void give_message(const Action& a) {
    start();
    Json message = a.json;
    // Messages of one cycle have increasing time stamps (3.16.3.3.2).
    if (a.T_TRAIN)
      message["T_TRAIN"] = next_ms() / 10 + static_cast<std::int64_t>(queued_.size()) - std::llround(a.ago_s * 100.0);
    if (a.NID_LRBG) message["NID_LRBG"] = last_lrbg();
    if (a.answers != 0) message["T_TRAIN_REF"] = last_T_TRAIN(a.answers, a.from);
    if (message["NID_MESSAGE"] == 32 && (a.from || called_))
      note_version(a.from ? *a.from : *called_, message["M_VERSION"].get<std::uint64_t>());
    Json more = Json::object();
    if (a.from) more["to"] = Json{{"NID_C", 1}, {a.from->key(), a.from->number}};
    auto bits = io::encode_radio_json(message, {lang::Direction::to_train, {}});
    if (bits && !spoil(*bits, a.damage)) fail("bits of the message", "beyond its end", false);
    give_bits(a.from && a.from->infill_unit ? "radio_in_fill" : "radio", bits, more);
  }
  /// What an RBC or a radio infill unit says in message 32: both speak in that version from then on, or, if the unit
  /// knows an earlier Y only, in that one (3.5.3.7).
  void note_version(const Partner& partner, std::uint64_t M_VERSION) {
    const lang::SystemVersion said = lang::system_version(M_VERSION);
    const lang::SystemVersion newest = lang::newest_version(stream_->configuration().srs);
    versions_.erase(key_of(partner));
    for (const lang::SystemVersion sv : kVersions)
      if (sv == (said.x == newest.x ? std::min(said, newest) : said)) versions_[key_of(partner)] = sv;
  }
  static std::pair<bool, std::int64_t> key_of(const Partner& partner) { return {partner.infill_unit, partner.number}; }
  /// Who gets a message of the last cycle: one that does not name its RBC is sent to the one that supervises.
  std::optional<Partner> receiver_of(const Json& sent) const {
    if (sent.is_object()) {
      const Json& to = sent["to"];
      const bool infill_unit = to.contains("NID_RIU");
      return Partner{to[infill_unit ? "NID_RIU" : "NID_RBC"].get<std::int64_t>(), infill_unit};
    }
    for (const Json& session : last("sessions"))
      if (session["role"] == "supervising") return Partner{session["NID_RBC"].get<std::int64_t>(), false};
    return std::nullopt;
  }
  /// Every message of every scenario can be read by its receiver.
  void read_messages() {
    for (const Json& sent : last("radio_out")) {
      const std::optional<Partner> receiver = receiver_of(sent);
      const auto version = receiver ? versions_.find(key_of(*receiver)) : versions_.end();
      const bool known = version != versions_.end();
      Json message = decoded(text_of(sent), known ? std::optional(version->second) : std::nullopt);
      if (!message.is_object())
        fail("messages of the version of their receiver" +
                 (known ? ", " + std::to_string(version->second.x) + "." + std::to_string(version->second.y)
                        : std::string()),
             text_of(sent) + ": " + message.dump());
      cycles_.back().messages.push_back(std::move(message));
    }
  }
  std::int64_t last_lrbg() const {
    if (cycles_.empty()) return 0xFFFFFF;
    const Json& lrbg = last("lrbg");
    if (!lrbg.is_object()) return 0xFFFFFF;
    return lrbg["NID_C"].get<std::int64_t>() << 14 | lrbg["NID_BG"].get<std::int64_t>();
  }

  /// `to`: the recipient, if it matters.
  std::int64_t last_T_TRAIN(int NID_MESSAGE, const std::optional<Partner>& to) const {
    for (std::size_t i = cycles_.size(); i-- > 0;) {
      if (!cycles_[i].momentary) continue;
      const Json& all = output(i, "radio_out");
      for (std::size_t k = 0; k < all.size(); ++k) {
        const Json& message = cycles_[i].messages[k];
        if (is_sent_to(to, all[k], i) && message.value("NID_MESSAGE", 0) == NID_MESSAGE)
          return message.value("T_TRAIN", 0);
      }
    }
    fail("message " + std::to_string(NID_MESSAGE) + " sent before", "none was sent", false);
  }
  /// A message that does not name its RBC is sent to the one that supervises.
  bool is_sent_to(const std::optional<Partner>& to, const Json& sent, std::size_t cycle) const {
    if (!to) return true;
    if (sent.is_object()) return sent["to"].value(to->key(), std::int64_t{-1}) == to->number;
    for (const Json& session : output(cycle, "sessions"))
      if (session["role"] == "supervising") return !to->infill_unit && session["NID_RBC"] == to->number;
    return false;
  }
  /// Since the second edition of the outputs a message to another RBC is an object.
  static std::string text_of(const Json& sent) {
    return sent.is_object() ? sent.value("message", "") : sent.get<std::string>();
  }

  void lay(const Action& a) {
    start();
    const double way = v_ < 0.0 ? -1.0 : 1.0;
    const std::size_t n = a.balises.size();
    double from = front_;
    if (a.from_group) {
      const auto group = places_.find(*a.from_group);
      if (group == places_.end()) fail("a group that was passed or laid before", "none of that number", false);
      from = group->second;
    }
    for (std::size_t i = 0; i < n; ++i) {
      // In running direction: the one with the greatest N_PIG first if the group is reversed.
      const std::size_t k = a.reversed ? n - 1 - i : i;
      const double at = from + way * (a.ahead_m + 3.0 * static_cast<double>(i));
      if (i == 0) {
        groups_[a.NID_BG] = counter(at);
        places_[a.NID_BG] = at;
      }
      if (a.balises[k].missing) continue;
      auto bits = io::encode_balise_json(a.balises[k].telegram);
      if (!bits) fail("a telegram", bits.error().why, false);
      // Without a header there is no telegram.
      if (a.balises[k].spoiled)
        *bits = {};
      else if (!spoil(*bits, a.balises[k].damage))
        fail("bits of the telegram", "beyond its end", false);
      balises_.push_back({at, io::hex_of_bits(bits->bytes, bits->bits), bits->bits});
    }
  }
  void pass(const Action& a) {
    if (v_ == 0.0) fail("a train that moves", "it stands: no group is passed", false);
    lay(a);
    const double length = a.ahead_m + 3.0 * static_cast<double>(a.balises.size() - 1);
    const double end = front_ + (v_ < 0.0 ? -length : length);
    while (v_ > 0.0 ? front_ < end : front_ > end) move(v_, 1.0);
    move(v_, 1.0);
  }

  void drive(const Action& a) {
    start();
    const double v = a.v_mps.value_or(v_);
    if (a.for_m) {
      const double from = front_;
      while (std::abs(front_ - from) < *a.for_m) {
        if (v_ == 0.0 && v == 0.0) fail("a train that moves", "it stands", false);
        move(v, a.a_mps2);
      }
    } else if (a.for_s) {
      run_for(*a.for_s, v, a.a_mps2);
    } else if (a.until) {
      until(a);
    } else {
      do move(v, a.a_mps2);
      while (v_ != v);
    }
  }
  void run_for(double seconds, double v, double a) {
    start();
    const auto end = next_ms() + static_cast<std::int64_t>(std::llround(seconds * 1000.0));
    while (next_ms() < end) move(v, a);
  }
  void until(const Action& a) {
    start();
    const auto end = next_ms() + static_cast<std::int64_t>(std::llround(a.within_s * 1000.0));
    const std::size_t from = cycles_.size();
    const double v = a.v_mps.value_or(v_);
    std::string found;
    do {
      move(v, a.a_mps2);
      found = difference(*a.until, from);
    } while (!found.empty() && next_ms() < end);
    if (!found.empty()) fail("", "not so within " + std::to_string(a.within_s) + " s: " + found);
  }

  // --- one cycle --------------------------------------------------------------------------------------------------

  double counter(double place) const { return reads_ * place + offset_; }

  void move(double v, double a) {
    start();
    const double most = a * static_cast<double>(cycle_ms_) / 1000.0;
    target_v_ = std::clamp(v, v_ - most, v_ + most);
    cycle();
  }

  void cycle() {
    start();
    if (next_ms() > kLongestMs) fail("an end within 30 min", "none", false);
    const double dt = static_cast<double>(cycle_ms_) / 1000.0;
    const double v = std::isnan(target_v_) ? v_ : target_v_;
    target_v_ = std::nan("");
    const double from = front_;
    const double a = (v - v_) / dt;
    if (!cycles_.empty()) front_ += (v + v_) / 2.0 * dt;
    v_ = v;
    doubt_ += std::abs(front_ - from) * error_;
    const double nominal = counter(front_);
    give_odometer({{"nominal_m", nominal},
                   {"min_m", nominal - doubt_},
                   {"max_m", nominal + doubt_},
                   {"speed_mps", v_ * reads_},
                   {"accel_mps2", a * reads_}});
    give_balises(from);
    for (std::string& line : queued_) give(std::move(line));
    queued_.clear();
    waiting_.back().insert(waiting_.back().size() - 1, R"(,"end":true)");  // complete: the stream reads no line ahead
    const auto more = stream_->next(inputs_of_cycle_);
    if (!more) fail("inputs that can be read", more.error().text(), false);
    const port::Inputs& in = inputs_of_cycle_.view();
    const Mode mode_before = unit_->state.mode;
    const bool SH_was_asked_for = unit_->state.shunting.waits_for_answer;
    kernel::examine(unit_->state, unit_->derived, in, unit_->outputs, unit_->examined);
    modes_.watch(stream_->configuration().srs, mode_before, {in, unit_->examined.facts, unit_->state, SH_was_asked_for},
                 unit_->outputs);
    expect_coherent(unit_->outputs);
    expect_brake_rules(in);
    note_step();
    watch_display(display_, unit_->state, unit_->outputs, scenario_.at.text());
    keep();
  }
  /// The line of a cycle whose events, messages and orders may be looked for later is written at once.
  void keep() {
    const kernel::Outputs& now = unit_->outputs;
    Kept& kept = *kept_[cycles_.size() % Cycle::kKept];
    kept.outputs = now;
    kept.plans = plans_ && kernel::plan(unit_->state, unit_->derived, kept.planning);
    if (shows_) kernel::show(unit_->state, unit_->derived, now, kept.display.emplace());
    Cycle& c = cycles_.emplace_back();
    c.t_ms = inputs_of_cycle_.t_ms;
    c.momentary = !now.events.empty() || !now.radio_out.empty() || now.radio_connect || now.radio_disconnect;
    if (c.momentary) (void)line(cycles_.size() - 1);
    if (!now.radio_out.empty()) read_messages();
    if (now.radio_connect && !now.radio_connect->infill_unit) called_ = Partner{now.radio_connect->NID_RBC, false};
  }
  /// 4.4: in every cycle of every scenario.
  void expect_coherent(const kernel::Outputs& out) const {
    if (!modes::possible_in(out.mode, out.level))
      fail("a mode of the level", std::string(name(out.mode)) + " in level " + std::string(name(out.level)));
  }
  /// 3.14.1, 4.12: the same.
  void expect_brake_rules(const port::Inputs& in) {
    const train::NationalValues& values = unit_->state.national_values;
    const bool service_brake = values.Q_NVSBTSMPERM && stream_->configuration().train.data.service_brake_interface;
    const bool until_standstill = !values.Q_NVEMRRLS && service_brake;
    brakes_.srs = stream_->configuration().srs;
    const auto faults = watch_brakes(brakes_, in, unit_->outputs, until_standstill, scenario_.at.text());
    if (!faults.empty()) fail("brakes by tests/reference/brake_causes.json", faults.front());
  }
  void give_odometer(std::initializer_list<std::pair<const char*, double>> members) {
    std::string text = R"({"t_ms":)" + std::to_string(next_ms()) + R"(,"odometer":{)";
    for (const auto& [key, value] : members) {
      text += text.back() == '{' ? "\"" : ",\"";
      text += key;
      text += "\":";
      io::append_number(text, value);
    }
    give(text + "}}");
  }
  void give(std::string line) {
    inputs_ += line + "\n";
    waiting_.push_back(std::move(line));
  }
  void give_balises(double from) {
    const bool forwards = front_ >= from;
    std::vector<TrackBalise> read;
    for (auto it = balises_.begin(); it != balises_.end();) {
      const bool passed = forwards ? it->at > from && it->at <= front_ : it->at < from && it->at >= front_;
      if (passed) read.push_back(*it);
      it = passed ? balises_.erase(it) : it + 1;
    }
    std::sort(read.begin(), read.end(),
              [&](const TrackBalise& x, const TrackBalise& y) { return forwards ? x.at < y.at : x.at > y.at; });
    for (const TrackBalise& b : read)
      give((b.bits == 0 ? Json{{"t_ms", next_ms()}, {"balise_failed", {{"at_m", counter(b.at)}}}}
                        : Json{{"t_ms", next_ms()},
                               {"balise", {{"telegram", b.hex}, {"bits", b.bits}, {"at_m", counter(b.at)}}}})
               .dump());
  }

  // --- then -------------------------------------------------------------------------------------------------------

  void expect(const Statement& s) {
    if (cycles_.empty()) cycle();
    std::string found = difference(s.condition, window_);
    if (s.within_s) {
      const auto end = next_ms() + static_cast<std::int64_t>(std::llround(*s.within_s * 1000.0));
      while (!found.empty() && next_ms() < end) {
        cycle();
        found = difference(s.condition, window_);
      }
      if (!found.empty()) found += ", and not within " + std::to_string(*s.within_s) + " s";
    }
    if (s.for_s) {
      const auto end = next_ms() + static_cast<std::int64_t>(std::llround(*s.for_s * 1000.0));
      while (found.empty() && next_ms() < end) {
        cycle();
        found = difference(s.condition, window_);
      }
    }
    if (!found.empty()) fail("", found);
  }

  /// Why a condition does not hold in the last cycle; for events and messages, since `from`.
  std::string difference(const Condition& c, std::size_t from) const {
    using What = Condition::What;
    switch (c.what) {
      case What::event:
        return momentary(c, from, "events", [&](const Json& e) { return matches(c.pattern, e.get<std::string>()); });
      case What::message:
        return sent(c, from);
      case What::call:
        return called(c, from, "radio_connect");
      case What::hang_up:
        return called(c, from, "radio_disconnect");
      case What::brakes:
        return braked(c);
      case What::output:
        return compared(c);
    }
    return "";
  }

  /// What the unit put out in a cycle, through the line of `evc replay`.
  const std::string& line(std::size_t i) const {
    Cycle& c = cycles_[i];
    if (!c.line.empty()) return c.line;
    if (i + Cycle::kKept < cycles_.size()) throw std::logic_error("the outputs of a cycle that are not kept");
    const Kept& kept = *kept_[i % Cycle::kKept];
    io::append_output(c.line, c.t_ms, kept.outputs, kept.plans ? &kept.planning : nullptr,
                      stream_->configuration().ntc_names, kept.display ? &*kept.display : nullptr);
    return c.line;
  }
  /// One output of a cycle. Nothing: there is none of that name.
  const Json* find_output(std::size_t i, std::string_view key) const {
    Cycle& c = cycles_[i];
    if (const auto known = c.read.find(key); known != c.read.end()) return &known->second;
    const std::string_view text = text_of_member(line(i), key);
    return text.empty() ? nullptr : &c.read.emplace(key, Json::parse(text)).first->second;
  }
  const Json& output(std::size_t i, std::string_view key) const {
    const Json* found = find_output(i, key);
    if (found == nullptr) throw std::logic_error("no output " + std::string(key));
    return *found;
  }
  const Json& last(std::string_view key) const { return output(cycles_.size() - 1, key); }

  template <class Is>
  std::string momentary(const Condition& c, std::size_t from, const char* key, Is is) const {
    std::string seen;
    for (std::size_t i = from; i < cycles_.size(); ++i) {
      if (!cycles_[i].momentary) continue;
      for (const Json& e : output(i, key)) {
        if (is(e)) return c.negated ? "\"" + e.get<std::string>() + "\" at " + time(i) : "";
        seen += "\n      " + time(i) + "  " + e.get<std::string>();
      }
    }
    if (c.negated) return "";
    return seen.empty() ? "no event" : "only" + seen;
  }

  std::string sent(const Condition& c, std::size_t from) const {
    std::string seen;
    for (std::size_t i = from; i < cycles_.size(); ++i) {
      if (!cycles_[i].momentary) continue;
      const Json& all = output(i, "radio_out");
      for (std::size_t k = 0; k < all.size(); ++k) {
        const Json& message = cycles_[i].messages[k];
        if (is_sent_to(c.message.to, all[k], i) && is_sent(c.message, message))
          return c.negated ? "sent at " + time(i) + ": " + message.dump() : "";
        seen += "\n      " + time(i) + "  " + message.dump();
      }
    }
    if (c.negated) return "";
    return seen.empty() ? "nothing sent" : "only" + seen;
  }

  std::string called(const Condition& c, std::size_t from, const char* key) const {
    std::string seen;
    for (std::size_t i = from; i < cycles_.size(); ++i) {
      if (!cycles_[i].momentary) continue;
      const Json& address = output(i, key);
      if (!address.is_object()) continue;
      if (c.negated) return address.dump() + " at " + time(i);
      if (holds(c.address, address)) return "";
      seen += " " + address.dump() + " at " + time(i);
    }
    return c.negated ? "" : seen.empty() ? "none" : "only" + seen;
  }

  std::string braked(const Condition& c) const {
    const bool tco = last("tco"), sb = last("sb"), eb = last("eb");
    const Json& reasons = last("brake_reasons");
    const std::string found = std::string(eb    ? "emergency brake"
                                          : sb  ? "service brake"
                                          : tco ? "traction cut-off"
                                                : "none") +
                              " " + reasons.dump();
    const bool any = c.tco || c.sb || c.eb;
    if (!any) return tco || sb || eb ? found : "";
    if (c.eb ? !eb : c.sb ? !sb || eb : !tco || sb || eb) return found;
    for (const std::string& reason : c.reasons)
      if (std::find(reasons.begin(), reasons.end(), reason) == reasons.end()) return found;
    return "";
  }

  /// A member or, by its number, an element; null where the list is shorter or has no member below.
  const Json* value_of(const std::string& key) const {
    static const Json nothing;
    std::size_t dot = key.find('.');
    const Json* at = find_output(cycles_.size() - 1, key.substr(0, dot));
    while (at != nullptr && dot != std::string::npos) {
      const std::size_t from = dot + 1;
      dot = key.find('.', from);
      const std::string name = key.substr(from, dot - from);
      if (at->is_null()) return &nothing;
      if (at->is_array() && name.find_first_not_of("0123456789") == std::string::npos) {
        const std::size_t i = std::stoul(name);
        at = i < at->size() ? &(*at)[i] : &nothing;
      } else {
        if (!at->is_object() || !at->contains(name)) return nullptr;
        at = &(*at)[name];
      }
    }
    return at;
  }

  /// An element that is the text, or an object one of whose members is.
  static bool contains(const Json& list, const Json& wanted) {
    for (const Json& item : list) {
      if (item == wanted) return true;
      if (!item.is_object()) continue;
      for (const auto& [key, value] : item.items())
        if (value == wanted) return true;
    }
    return false;
  }

  std::string compared(const Condition& c) const {
    const Wanted& w = c.wanted;
    const Json* found = value_of(c.key);
    if (found == nullptr) return "no output " + c.key;
    const std::string says = c.key + " " + found->dump();
    using How = Wanted::How;
    if (w.how == How::absent) return found->is_null() ? "" : says;
    if (found->is_array()) {
      if (w.how == How::has) return contains(*found, w.value) ? "" : says;
      if (w.how == How::lacks) return contains(*found, w.value) ? says : "";
      return *found == w.value ? "" : says;
    }
    if (w.how == How::lacks) return *found == w.value ? says : "";
    if (!w.value.is_number()) return *found == w.value ? "" : says;
    if (!found->is_number()) return says;
    double base = 0.0;
    if (w.from_group) {
      const auto group = groups_.find(*w.from_group);
      if (group == groups_.end()) return "no group " + std::to_string(*w.from_group) + " was passed";
      base = group->second - antenna_m_;
    } else if (w.from_front) {
      base = last("est_front_m").get<double>();
    }
    const double x = found->get<double>() - base;
    const double y = w.value.get<double>();
    const std::string says_from =
        w.from_group || w.from_front ? says + " (" + std::to_string(x) + " m from there)" : says;
    switch (w.how) {
      case How::above:
        return x > y ? "" : says_from;
      case How::below:
        return x < y ? "" : says_from;
      case How::between:
        return x >= y && x <= w.upper ? "" : says_from;
      default:
        return std::abs(x - y) <= w.tolerance ? "" : says_from;
    }
  }

  // --- what failed ------------------------------------------------------------------------------------------------

  std::string time(std::size_t i) const { return std::to_string(cycles_[i].t_ms) + " ms"; }

  [[noreturn]] void fail(std::string expected, std::string found, bool of_the_unit = true) const {
    throw Failure{now_, std::move(expected), std::move(found), of_the_unit};
  }

  std::string report(const Failure& f) const {
    std::string text = f.at->at.text() + ": scenario " + scenario_.name + "\n";
    text += (f.expected.empty() ? "  expected: " : "  step:     ") + f.at->text + "\n";
    if (!f.expected.empty()) text += "  expected: " + f.expected + "\n";
    text += "  found:    " + f.found + "\n";
    if (cycles_.empty()) return text;
    text += "  events since the last when:\n";
    for (std::size_t i = std::min(window_, cycles_.size()); i < cycles_.size(); ++i) {
      if (!cycles_[i].momentary) continue;
      for (const Json& e : output(i, "events")) text += "    " + time(i) + "  " + e.get<std::string>() + "\n";
    }
    text += "  last outputs:\n";
    for (std::size_t i = cycles_.size() > Cycle::kKept ? cycles_.size() - Cycle::kKept : 0; i < cycles_.size(); ++i)
      text += "    " + line(i);
    return text;
  }

  struct TrackBalise {
    double at;
    std::string hex;
    std::size_t bits;
  };
  struct Unit {
    kernel::State state;
    kernel::Derived derived;
    kernel::Outputs outputs;
    kernel::Examined examined;
  };
  /// The outputs of one of the last cycles.
  struct Kept {
    kernel::Outputs outputs;
    kernel::Planning planning;
    bool plans = false;
    std::optional<kernel::Display> display;
  };

  const Scenario& scenario_;
  bool plans_ = false;  // an expectation asks for the advance display
  bool shows_ = false;  // or for the record of the display
  const Statement* now_ = nullptr;
  Json config_ = Json::object();
  std::unique_ptr<Unit> unit_ = std::make_unique<Unit>();
  std::array<std::unique_ptr<Kept>, Cycle::kKept> kept_{std::make_unique<Kept>(), std::make_unique<Kept>(),
                                                        std::make_unique<Kept>()};
  std::unique_ptr<io::InputStream> stream_;
  sim::CycleInputs inputs_of_cycle_;
  brake_rules::Memory brakes_;
  DisplayMemory display_;
  ModeWatch modes_;
  std::deque<std::string> waiting_;
  std::vector<std::string> queued_;
  std::string inputs_;
  std::int64_t cycle_ms_ = 100;
  mutable std::vector<Cycle> cycles_;  // lines and members are written and read when they are looked at
  std::vector<std::string> steps_;     ///< of the output `dialogue`, one after the other: PROCEDURE.STEP
  std::size_t window_ = 0;
  bool after_then_ = false, when_before_ = false;
  bool shares_cycle_ = false;  // the next step is in the same cycle as this one
  double antenna_m_ = 0.0;
  double front_ = 0.0, v_ = 0.0, doubt_ = 0.0, target_v_ = std::nan("");
  double error_ = 0.0, reads_ = 1.0, offset_ = 0.0;
  std::vector<TrackBalise> balises_;
  std::optional<Partner> called_;                                          // the RBC called last
  std::map<std::pair<bool, std::int64_t>, lang::SystemVersion> versions_;  // of RBCs and (true) radio infill units
  std::map<std::int64_t, double> groups_;  // the counter at the first balise of each group
  std::map<std::int64_t, double> places_;  // its true place
};

}  // namespace

std::string run(const Scenario& scenario) { return Run(scenario).watched(); }

std::string run(const Scenario& scenario, std::string& inputs) {
  Run one(scenario);
  std::string failure = one.watched();
  inputs = one.inputs();
  return failure;
}

std::string inputs_of(const Scenario& scenario) {
  std::string inputs;
  (void)run(scenario, inputs);
  return inputs;
}

}  // namespace evc::scenario
