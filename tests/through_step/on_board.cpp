#include "on_board.h"

#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

#include "base/test_paths.h"
#include "io/input_stream.h"
#include "io/output_lines.h"
#include "io/retained_file.h"
#include "run.h"
#include "texts/texts.h"

namespace evc::through_step {
namespace {

constexpr std::int64_t kCycle_ms = 100;
constexpr int kLongestWait = 600;  // cycles; 3 m take 11 at 10 km/h

const std::vector<scenario::Block>& library() {
  static const std::vector<scenario::Block> blocks = [] {
    std::ifstream file(evc::test::source_folder() + "/tests/scenarios/library.scenario");
    std::ostringstream text;
    text << file.rdbuf();
    auto read = scenario::read(text.str(), "library.scenario");
    if (!read) throw std::runtime_error(read.error().text());
    return read->blocks;
  }();
  return blocks;
}

std::string inputs_after(const std::string& statements) {
  const auto file =
      scenario::read("scenario start\n" + statements + "  then mode not NP [4.6.3(4)]\n", "start", library());
  if (!file) throw std::runtime_error(file.error().text());
  std::string inputs;
  const std::string failure = scenario::run(file->scenarios.at(0), inputs);
  if (!failure.empty()) throw std::runtime_error(failure);
  return inputs;
}

/// The header of a telegram (8.4.2.1).
constexpr const char* kHeader[] = {"Q_UPDOWN", "M_VERSION", "Q_MEDIA", "N_PIG",  "N_TOTAL",
                                   "M_DUP",    "M_MCOUNT",  "NID_C",   "NID_BG", "Q_LINK"};

std::vector<std::uint8_t> telegram(const Codes& header, const std::string& balise, const BitList& packets) {
  BitList bits;
  for (const char* name : kHeader) {
    const auto of_one = header.find(balise + "/" + name);
    bits.put(of_one != header.end() ? of_one->second : header.at(name), variable(name).at("bits"));
  }
  append(bits, packets);
  bits.put(255, 8);  // packet 255
  while (bits.size() < 830) bits.put(1, 1);
  return bits.bytes();
}

}  // namespace

std::string Answer::event(std::initializer_list<std::string> parts) const {
  for (const std::string& e : events) {
    bool all = true;
    for (const std::string& part : parts) all = all && e.find(part) != std::string::npos;
    if (all) return e;
  }
  return "";
}

std::string Answer::text() const {
  std::string out;
  for (const std::string& e : events) out += "\n    " + e;
  return out;
}

OnBoard::OnBoard() : unit_(std::make_unique<Unit>()) {}
OnBoard::OnBoard(const OnBoard& other)
    : unit_(std::make_unique<Unit>(*other.unit_)),
      in_(other.in_),
      group_(other.group_),
      sent_before_(other.sent_before_) {}

const OnBoard& OnBoard::after(const std::string& statements) {
  static std::map<std::string, OnBoard> known;
  const auto found = known.find(statements);
  if (found != known.end()) return found->second;
  OnBoard b;
  auto stream = io::InputStream::open("start", io::lines_of(inputs_after(statements)));
  if (!stream) throw std::runtime_error(stream.error().text());
  kernel::power_up(b.unit_->state, b.unit_->derived, stream->configuration().for_kernel());
  for (;;) {
    const auto more = stream->next(b.in_);
    if (!more) throw std::runtime_error(more.error().text());
    if (!*more) break;
    kernel::step(b.unit_->state, b.unit_->derived, b.in_.view(), b.unit_->outputs);
    for (const auto& m : b.unit_->outputs.radio_out) b.sent_before_.emplace_back(m.bytes.begin(), m.bytes.end());
  }
  b.in_.clear();
  b.advance();
  return known.emplace(statements, std::move(b)).first->second;
}

/// To the next cycle, at the present speed.
void OnBoard::advance() {
  in_.t_ms += kCycle_ms;
  auto& o = in_.levels.odometry;
  const Distance run = o.V_est * Duration{static_cast<double>(kCycle_ms) / 1000.0};
  o.nominal = o.nominal + run;
  o.min = o.min + run;
  o.max = o.max + run;
  o.A_est = {};
  o.measured.reset();
}

void OnBoard::cycle(Answer& answer) {
  kernel::step(unit_->state, unit_->derived, in_.view(), unit_->outputs);
  in_.clear();
  for (const auto& e : unit_->outputs.events) answer.events.emplace_back(texts::line_of(e).view());
  for (const auto& m : unit_->outputs.radio_out) answer.sent.emplace_back(m.bytes.begin(), m.bytes.end());
  for (const auto& f : unit_->outputs.forwarded)
    answer.forwarded.emplace_back(f.NID_XUSER, f.NID_NTC ? int{*f.NID_NTC} : -1);
  advance();
}

std::string OnBoard::line(bool planning) {
  std::string line;
  const bool plans = planning && kernel::plan(unit_->state, unit_->derived, unit_->planning);
  io::append_output(line, in_.t_ms, unit_->outputs, plans ? &unit_->planning : nullptr);
  return line;
}

Json OnBoard::output(bool planning) { return Json::parse(line(planning)); }

Json OnBoard::retained() const { return Json::parse(io::retained_text(kernel::retained(unit_->state))); }

Answer OnBoard::run(int cycles) {
  Answer answer;
  for (int i = 0; i < cycles; ++i) cycle(answer);
  return answer;
}

Answer OnBoard::pass(unsigned NID_BG, const BitList& packets, const std::string& sv, const Codes& header) {
  Codes codes{{"Q_UPDOWN", 1},
              {"M_VERSION", static_cast<std::uint64_t>(sv[0] - '0') * 16u + static_cast<std::uint64_t>(sv[2] - '0')},
              {"Q_MEDIA", 0},
              {"0/N_PIG", 0},
              {"1/N_PIG", 1},
              {"N_TOTAL", 1},
              {"M_DUP", 0},
              {"M_MCOUNT", 255},
              {"NID_C", 1},
              {"NID_BG", NID_BG},
              {"Q_LINK", 0}};
  for (const auto& [name, code] : header) codes[name] = code;
  Answer answer;
  cycle(answer);  // without the group, so that the counter of the next cycle is known
  group_ = front();
  in_.balises.push_back({{telegram(codes, "0", packets), 830}, {{group_}}, {}});
  cycle(answer);
  for (int cycles = 0; front() < group_ + 3.0; ++cycles) {
    if (cycles == kLongestWait) throw std::runtime_error("the train does not reach the second balise");
    cycle(answer);
  }
  in_.balises.push_back({{telegram(codes, "1", {}), 830}, {{group_ + 3.0}}, {}});
  cycle(answer);
  cycle(answer);
  return answer;
}

Answer OnBoard::receive(unsigned NID_MESSAGE, Codes codes, const BitList& packets, const std::string& sv,
                        bool infill_unit) {
  codes.try_emplace("T_TRAIN", static_cast<std::uint64_t>(in_.t_ms / 10));
  return receive(message_bits(*find_message("to_train", NID_MESSAGE, sv), codes, packets).bytes(), infill_unit);
}

Decoded OnBoard::last_sent(unsigned NID_MESSAGE, const std::string& sv) const {
  for (auto m = sent_before_.rbegin(); m != sent_before_.rend(); ++m)
    if (!m->empty() && (*m)[0] == NID_MESSAGE) return decode_to_track(*m, sv);
  throw std::runtime_error("message " + std::to_string(NID_MESSAGE) + " was not sent");
}

Answer OnBoard::receive(const std::vector<std::uint8_t>& message, bool infill_unit) {
  Answer answer;
  sim::CycleInputs::RadioMessage m;
  m.infill_unit = infill_unit;
  m.bytes = message;
  in_.radio.push_back(m);
  cycle(answer);
  cycle(answer);
  return answer;
}

Answer OnBoard::receive_loop(const std::vector<std::uint8_t>& message) {
  Answer answer;
  sim::Bits m;
  m.bytes = message;
  in_.loops.push_back(m);
  cycle(answer);
  cycle(answer);
  return answer;
}

}  // namespace evc::through_step
