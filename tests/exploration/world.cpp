#include "world.h"

#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include "io/input_stream.h"
#include "terms/mode.h"
#include "texts/texts.h"

namespace evc::exploration {
namespace {

constexpr std::int64_t kCycle_ms = 100;
constexpr double kPassing = 5.0;  // m/s
constexpr double kBetween = 3.0;  // metres between two balises of a group

kernel::Config configuration(SrsVersion srs) {
  const auto read =
      io::read_configuration(std::string(R"({"srs":")") + name(srs) + R"(","NID_ENGINE":7})", "exploration");
  if (!read) throw std::runtime_error(read.error().text());
  return read->for_kernel();
}

std::vector<std::uint8_t> telegram(unsigned NID_BG, unsigned N_PIG, const BitList& packets) {
  BitList bits;
  const std::pair<std::uint64_t, unsigned> header[] = {{1, 1}, {33, 7},  {0, 1},  {N_PIG, 3},   {1, 3},
                                                       {0, 2}, {255, 8}, {1, 10}, {NID_BG, 14}, {1, 1}};
  for (const auto& [code, n] : header) bits.put(code, n);
  through_step::append(bits, packets);
  bits.put(255, 8);
  while (bits.size() < 830) bits.put(1, 1);
  return bits.bytes();
}

std::uint32_t T_TRAIN_of(std::span<const std::uint8_t> m) {
  std::uint64_t v = 0;
  for (std::size_t bit = 18; bit < 50; ++bit) v = v << 1 | ((m[bit / 8] >> (7 - bit % 8)) & 1u);
  return static_cast<std::uint32_t>(v);
}

}  // namespace

void put(BitList& to, unsigned NID_PACKET, const Codes& codes) {
  through_step::put_packet(to, *through_step::find_packet("to_train", NID_PACKET, "2.1"), codes);
}

Watch::Watch(SrsVersion srs) {
  const auto& table = through_step::reference(srs == SrsVersion::v4_0_0 ? "mode_transitions_v400" : "mode_transitions");
  for (const auto& cell : table.at("transitions")) {
    cells[{cell.at("from"), cell.at("to")}] = 0;
    const std::string to = cell.at("to");
    if (std::find(modes_.begin(), modes_.end(), to) == modes_.end()) modes_.push_back(to);
  }
}

void Watch::look(Mode before, const port::Outputs& now, const port::TrainSignals& train) {
  const std::string mode = name(now.mode);
  ++cycles[mode];
  if (before != now.mode) {
    const auto cell = cells.find({name(before), mode});
    if (cell == cells.end())
      faults.push_back(std::string("from ") + name(before) + " to " + mode + ": no cell of 4.6.2");
    else
      ++cell->second;
  }
  const bool braked = now.mode == Mode::TR || now.mode == Mode::SF || now.mode == Mode::NP;
  if (braked && !now.eb) faults.push_back(mode + " without emergency brake");
  if (now.mode == Mode::IS && (now.eb || now.sb || now.tco)) faults.push_back("IS with a brake");
  if (train.desk_open) return;
  if (!now.requests.empty()) faults.push_back(mode + ": an acknowledgement is asked with the desk closed");
  if (!now.entries.empty()) faults.push_back(mode + ": an entry is asked with the desk closed");
  if (now.start_offered) faults.push_back(mode + ": start is offered with the desk closed");
}

Runner::Runner(SrsVersion srs, Watch& watch)
    : config_(configuration(srs)), watch_(watch), derived_(std::make_unique<kernel::Derived>()) {}

std::unique_ptr<World> Runner::power_up() {
  auto world = std::make_unique<World>();
  kernel::power_up(world->state, *derived_, config_);
  world_ = world.get();
  run(2);
  return world;
}

void Runner::go_on_with(World& world) {
  world_ = &world;
  derived_->built = 0;
}

void Runner::advance() {
  world_->in.t_ms += kCycle_ms;
  auto& o = inputs().odometry;
  const Distance run = o.V_est * Duration{static_cast<double>(kCycle_ms) / 1000.0};
  o.nominal = o.nominal + run;
  o.min = o.min + run;
  o.max = o.max + run;
}

void Runner::cycle() {
  World& w = *world_;
  const Mode before = w.out.mode;
  const port::Inputs& in = w.in.view();
  kernel::step(w.state, *derived_, in, w.out);
  w.brakes.srs = w.state.srs;
  for (std::string& fault : brake_rules::look(w.brakes, in, w.out, true)) watch_.faults.push_back(std::move(fault));
  for (std::string& fault : look(w.known, in, w.out, watch_.applied)) watch_.faults.push_back(std::move(fault));
  // 4.4.6.1.6, 4.4.15.1.5, 4.4.20.1.10: the alarm is memorised as a fault.
  const bool memorises = w.out.mode == Mode::SL || w.out.mode == Mode::NL || w.out.mode == Mode::PS;
  w.failed = w.failed || (memorises && in.train.antenna_alarm);
  w.in.clear();
  watch_.look(before, w.out, w.in.levels.train);
  if (prints_events)
    for (const auto& e : w.out.events) std::printf("  %s\n", std::string(texts::line_of(e).view()).c_str());
  for (const auto& m : w.out.radio_out)
    if (m.bytes.size() >= 7) w.sent[m.bytes[0]] = T_TRAIN_of({m.bytes.begin(), m.bytes.size()});
  // Both in one cycle: the connection of the session that has ended, and the call for the one that follows it.
  if (w.out.radio_disconnect) w.calling = false;
  if (w.out.radio_connect) w.calling = true;
  advance();
}

void Runner::run(int cycles) {
  for (int i = 0; i < cycles; ++i) cycle();
}

void Runner::tell(const Ahead& ahead, double group_at) {
  const double front = group_at - config_.train.L_antenna_front.si;  // the counter with the front end there
  Told told{ahead.area, {{front + ahead.D_MAMODE}}, std::nullopt};
  if (ahead.D_EMERGENCYSTOP) told.stop = OdometerPlace{{front + *ahead.D_EMERGENCYSTOP}};
  world_->known.telling = told;
}

void Runner::pass(const BitList& packets, bool spoiled, const Ahead& ahead) {
  auto& o = inputs().odometry;
  const Speed before = o.V_est;
  if (o.V_est.si < kPassing) o.V_est = o.V_min = o.V_max = Speed{kPassing};
  cycle();
  const unsigned NID_BG = 100 + world_->groups++ % 16000;
  const double at = o.nominal.from_origin.si;
  world_->groups_at[NID_BG] = at;
  tell(ahead, at);
  world_->in.balises.push_back(
      {{spoiled ? std::vector<std::uint8_t>{} : telegram(NID_BG, 0, packets), spoiled ? 0u : 830u}, {{at}}, {}});
  do cycle();
  while (o.nominal.from_origin.si < at + kBetween);
  world_->in.balises.push_back({{telegram(NID_BG, 1, {}), 830}, {{at + kBetween}}, {}});
  run(2);
  o.V_est = o.V_min = o.V_max = before;
  run(2);
  world_->known.telling.reset();
}

void Runner::receive(unsigned NID_MESSAGE, Codes codes, const BitList& packets, const Ahead& ahead) {
  const auto& lrbg = world_->out.lrbg;
  codes.try_emplace("T_TRAIN", static_cast<std::uint64_t>(world_->in.t_ms / 10));
  codes.try_emplace("NID_LRBG", lrbg ? std::uint64_t{lrbg->NID_C} << 14 | lrbg->NID_BG : 0xFFFFFFu);
  sim::CycleInputs::RadioMessage m;
  const through_step::Json* layout = through_step::find_message("to_train", NID_MESSAGE, "2.1");
  if (layout == nullptr) layout = through_step::find_message("to_train", NID_MESSAGE, "2.3");
  m.bytes = through_step::message_bits(*layout, codes, packets).bytes();
  world_->in.radio.push_back(m);
  const auto at = world_->groups_at.find(lrbg ? lrbg->NID_BG : 0u);
  if (at != world_->groups_at.end()) tell(ahead, at->second);
  run(3);
  world_->known.telling.reset();
}

std::uint64_t Runner::asked(unsigned NID_MESSAGE) const {
  const auto found = world_->sent.find(NID_MESSAGE);
  return found == world_->sent.end() ? 0 : found->second;
}

void Runner::enter_train_data() { world_->in.train_data = config_.train; }

}  // namespace evc::exploration
