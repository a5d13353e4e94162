#include "ride/ride.h"

#include <limits>
#include <utility>

#include "io/input_writer.h"
#include "io/number.h"
#include "io/output_lines.h"
#include "kernel/evc.h"
#include "kernel/state.h"
#include "sim/world.h"

namespace evc::ride {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
/// A journey by hand begins at 08:00 (UTC) of 2026-01-01 unless its begin is given: the same touches give the same
/// bytes.
constexpr std::int64_t kBegin_utc = 1767254400;

double kmh(const std::optional<Speed>& v) { return v ? v->si * 3.6 : kNone; }

/// The networks of a journey that the simulated driver drives: those of `evc run`, where he does not choose one.
sim::Networks networks_of(const Given& given, const Ride::Settings& settings) {
  return settings.driver ? sim::Networks{} : given.networks;
}

io::Configuration configuration_of(const Given& given, const Ride::Settings& settings) {
  io::Configuration configuration;
  configuration.cycle_ms = settings.cycle_ms;
  configuration.srs = settings.srs;
  configuration.train.name = given.train_name;
  configuration.train.data = given.train;
  configuration.train.dynamics = given.dynamics;
  configuration.train.document = given.train_document;
  configuration.networks = networks_of(given, settings).offered;
  configuration.document = io::configuration_document(configuration);
  return configuration;
}

sim::World::Settings world_of(const Ride::Settings& settings) {
  sim::World::Settings world;
  world.by_hand = !settings.driver;
  world.driver = settings.driver.value_or(world.driver);
  world.seed = settings.seed;
  world.cycle_ms = settings.cycle_ms;
  // Without a clock the display has no local time (area G13). Journeys of a simulated driver are those of `evc run`,
  // which has one only where it is asked for.
  world.utc = settings.utc;
  if (!world.utc && world.by_hand) world.utc = kBegin_utc;
  return world;
}

/// A list of JSON objects: `append(out, item)` makes one.
template <class List, class Append>
void append_list(std::string& out, const char* key, const List& items, Append append) {
  out += key;
  out += '[';
  bool first = true;
  for (const auto& item : items) {
    if (!first) out += ',';
    first = false;
    append(out, item);
  }
  out += ']';
}

void append_triple(std::string& out, double a, double b, double c) {
  out += '[';
  io::append_number(out, a);
  out += ',';
  io::append_number(out, b);
  out += ',';
  io::append_number(out, c);
  out += ']';
}

}  // namespace

/// The on-board and what is around it.
struct Ride::World {
  World(const Given& given, const io::Configuration& configuration, const Settings& settings)
      : writer(configuration),
        outside(given.line, given.train, given.dynamics, world_of(settings)),
        terminals(networks_of(given, settings)) {
    kernel::power_up(state, derived, configuration.for_kernel());
  }

  io::InputWriter writer;
  sim::World outside;
  sim::Terminals terminals;
  kernel::State state;
  kernel::Derived derived;
  kernel::Outputs outputs;
};

Ride::Ride(Given given, const Settings& settings) : given_(std::move(given)), by_hand_(!settings.driver) {
  world_ = std::make_unique<World>(given_, configuration_of(given_, settings), settings);
}

Ride::~Ride() = default;

bool Ride::finished() const { return world_->outside.finished(); }
void Ride::set_desk(const sim::Desk& desk) { world_->outside.set_desk(desk); }

int Ride::advance(int cycles) {
  outputs_.clear();
  inputs_.clear();
  events_.clear();
  points_.clear();
  int done = 0;
  // The first cycle is that of time 0: a world that has not begun has not ended.
  for (; done < cycles && (cycles_ == 0 || !finished()); ++done) cycle();
  return done;
}

void Ride::cycle() {
  World& w = *world_;
  sim::CycleInputs& inputs = w.outside.advance();
  inputs.levels.train.radio_registered = w.terminals.registered(inputs.t_ms);
  const dmi::Commands commands = panel_->take();
  if (by_hand_) obey(commands, inputs);
  // The simulated driver has no fingers: of what he selects, Start alone closes a window (015560 11.3).
  if (!by_hand_ && inputs.levels.driver.has(port::Select::start)) panel_->touch_button(Button::start);
  w.writer.append(inputs_, inputs);
  kernel::step(w.state, w.derived, inputs.view(), w.outputs);
  w.outside.observe(w.outputs);
  w.terminals.hear(w.outputs, inputs.t_ms);
  kernel::show(w.state, w.derived, w.outputs, panel_->record_at(inputs.levels.now));
  panel_->shown();
  const std::size_t before = outputs_.size();
  io::append_output(outputs_, inputs.t_ms, w.outputs);
  hash_.add(std::string_view(outputs_).substr(before));
  ++cycles_;
  note();
}

/// What the driver did at the display.
void Ride::obey(const dmi::Commands& commands, sim::CycleInputs& inputs) {
  inputs.levels.driver = commands.actions;
  inputs.levels.windows = commands.windows;
  // A state: the selector stays where the driver put it (4.4.16.1.2 of 4.0.0).
  if (commands.ato_on) ato_active_ = *commands.ato_on;
  inputs.levels.automatic_operation.active = ato_active_;
  if (commands.train_data) inputs.train_data = dmi::with_entered(given_.train, *commands.train_data);
}

/// The point and the events of the cycle.
void Ride::note() {
  const kernel::Outputs& o = world_->outputs;
  const sim::World& outside = world_->outside;
  const auto reference = o.lrbg ? outside.reference(*o.lrbg) : std::nullopt;
  // Where a place of the odometer is along the line: through the reference group, before the first one by the true
  // front end.
  const double origin =
      reference ? reference->position_m - reference->nominal_m : outside.front_m() - o.est_front.from_origin.si;
  const auto on_line = [&](const std::optional<OdometerPlace>& p) { return p ? p->from_origin.si + origin : kNone; };
  Point p;
  p.t_s = static_cast<double>(outside.t_ms()) / 1000.0;
  p.x_m = outside.front_m();
  p.v = o.v.si * 3.6;
  p.V_P = kmh(o.V_P);
  p.V_W = kmh(o.V_W);
  p.V_SBI = kmh(o.V_SBI);
  p.V_EBI = kmh(o.V_EBI);
  p.V_MRSP = kmh(o.V_MRSP);
  p.V_target = kmh(o.V_target);
  p.V_release = kmh(o.V_release);
  p.target_m = o.d_target ? p.x_m + o.d_target->si : kNone;
  p.EOA_m = on_line(o.EOA);
  p.SvL_m = on_line(o.SvL);
  p.least_m = on_line(o.min_safe_front);
  p.most_m = on_line(o.max_safe_front);
  p.brakes = (o.tco ? 1 : 0) + (o.sb ? 2 : 0) + (o.eb ? 4 : 0);
  p.mode = static_cast<double>(terms::index(o.mode));
  p.level = static_cast<double>(terms::index(o.level));
  p.status = static_cast<double>(terms::index(o.status));
  points_.push_back(p);
  if (const int mode = static_cast<int>(o.mode); mode_ != mode) {
    if (o.mode != Mode::NP) modes_.push_back(name(o.mode));
    mode_ = mode;
  }
  for (const kernel::Event& event : o.events) {
    events_ += "{\"t_s\":";
    io::append_number(events_, p.t_s);
    events_ += ",\"x_m\":";
    io::append_number(events_, p.x_m);
    events_ += ",\"text\":";
    std::string text;
    io::append_event(text, event);
    io::append_string(events_, text);
    events_ += "}\n";
  }
}

std::string Ride::summary() const {
  std::string out = "{\"output_hash\":\"" + hash_.digest() + '"';
  append_list(out, ",\"modes\":", modes_, [](std::string& s, const char* mode) { io::append_string(s, mode); });
  out += ",\"cycles\":";
  io::append_number(out, cycles_);
  return out + '}';
}

std::string Ride::scene() const {
  const sim::Line& line = given_.line;
  std::string out = "{\"line\":";
  io::append_string(out, line.name);
  out += ",\"train\":";
  io::append_string(out, given_.train_name);
  out += ",\"train_length_m\":";
  io::append_number(out, given_.train.L_TRAIN.si);
  out += ",\"start_m\":";
  io::append_number(out, world_->outside.start_m());
  out += ",\"end_m\":";
  io::append_number(out, world_->outside.end_m());
  append_list(out, ",\"gradient\":", line.gradient,
              [](std::string& s, const sim::GradientSegment& g) { append_triple(s, g.start_m, g.end_m, g.permille); });
  append_list(out, ",\"speeds\":", line.ssp,
              [](std::string& s, const sim::SpeedSegment& g) { append_triple(s, g.start_m, g.end_m, g.kmh); });
  std::vector<double> groups;
  std::optional<std::size_t> last;
  for (const sim::Balise& balise : line.balises) {
    if (last != balise.group) groups.push_back(balise.position_m);
    last = balise.group;
  }
  append_list(out, ",\"groups\":", groups, [](std::string& s, double at) { io::append_number(s, at); });
  return out + '}';
}

}  // namespace evc::ride
