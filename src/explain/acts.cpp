#include <fmt/format.h>

#include "explain/journal.h"
#include "explain/words.h"
#include "texts/texts.h"

// The inputs of driver, train interface and bearer in words.
namespace evc::explain {
namespace {

bool told(const kernel::Outputs& outputs, What what, std::int32_t id = port::Event::kNone) {
  for (const port::Event& e : outputs.events)
    if (e.what == what && e.id == id) return true;
  return false;
}

bool refused(const kernel::Outputs& outputs, port::Select select) {
  return told(outputs, What::selection_not_enabled, static_cast<std::int32_t>(select));
}
bool refused(const kernel::Outputs& outputs, Ack ack) {
  return told(outputs, What::acknowledgement_not_enabled, static_cast<std::int32_t>(ack));
}
bool SR_data_refused(const kernel::Outputs& outputs) {
  return told(outputs, What::entry_not_enabled, static_cast<std::int32_t>(port::Entered::SR_speed_distance)) ||
         told(outputs, What::SR_data_out_of_range);
}

const char* controller(port::DirectionController position) {
  return position == port::DirectionController::forward    ? "direction controller forward"
         : position == port::DirectionController::backward ? "direction controller backward"
                                                           : "direction controller neutral";
}

}  // namespace

void Journal::take_driver(const sim::CycleInputs& cycle, const kernel::Outputs& outputs) {
  using Kind = Act::Kind;
  const port::DriverActions& driver = cycle.levels.driver;
  const auto note = [&](Kind kind, std::string text, std::uint8_t about = 0) {
    acts_.push_back({cycle.t_ms, kind, std::move(text), about});
  };
  for (std::uint8_t n = 0; n < static_cast<std::uint8_t>(port::Select::count); ++n)
    if (const auto select = static_cast<port::Select>(n); driver.has(select) && !refused(outputs, select))
      note(Kind::select, fmt::format("driver selects {}", texts::words_of(select)), n);
  for (std::uint8_t n = 0; n < static_cast<std::uint8_t>(Ack::count); ++n)
    if (const auto ack = static_cast<Ack>(n); driver.has(ack) && !refused(outputs, ack))
      note(Kind::acknowledge, fmt::format("driver acknowledges {}", kAckRows[n].name), n);
  if (SR_data_refused(outputs)) return;
  if (driver.V_sr) note(Kind::SR_speed, fmt::format("driver enters the SR speed {}", kmh_words(*driver.V_sr)));
  if (driver.D_sr) note(Kind::SR_distance, fmt::format("driver enters the SR distance {}", metres_words(*driver.D_sr)));
}

void Journal::take_acts(const sim::CycleInputs& cycle) {
  using Kind = Act::Kind;
  const port::Inputs& in = cycle.levels;
  const auto note = [&](Kind kind, std::string text, std::uint8_t about = 0) {
    acts_.push_back({cycle.t_ms, kind, std::move(text), about});
  };
  const auto changed = [&](Kind kind, bool was, bool is, const char* yes, const char* no) {
    if (was != is) note(kind, is ? yes : no);
  };
  const auto window = [&](port::Window which, const char* words) {
    const bool opens = in.windows.has(which);
    if (windows_.has(which) != opens)
      note(Kind::window, fmt::format("driver {} the window of {}", opens ? "opens" : "closes", words),
           static_cast<std::uint8_t>(which));
  };
  window(port::Window::train_data, "train data");
  window(port::Window::SR_data, "SR speed and distance");
  const port::TrainSignals& t = in.train;
  changed(Kind::desk, train_.desk_open, t.desk_open, "a desk is opened", "the desk is closed");
  changed(Kind::power, train_.powered, t.powered, "power on", "power off");
  changed(Kind::isolation, train_.isolated, t.isolated, "isolation on", "isolation off");
  changed(Kind::sleeping, train_.sleeping, t.sleeping, "sleeping signal", "sleeping signal off");
  changed(Kind::non_leading, train_.non_leading, t.non_leading, "non leading signal", "non leading signal off");
  changed(Kind::passive_shunting, train_.passive_shunting, t.passive_shunting, "passive shunting signal",
          "passive shunting signal off");
  changed(Kind::antenna, train_.antenna_alarm, t.antenna_alarm, "alarm of the balise antenna",
          "the alarm of the balise antenna ends");
  if (first_ || train_.direction_controller != t.direction_controller)
    note(Kind::controller, controller(t.direction_controller));
  if (cycle.external_train_data) note(Kind::external_data, "an external source changes the train data");
  const port::NationalSystem &was = national_system_, &is = in.national_system;
  const auto order = [&](bool before, bool now, std::uint8_t about, const char* what) {
    if (before != now)
      note(Kind::national_system, fmt::format("the national system {} {}", now ? "orders" : "withdraws", what), about);
  };
  order(was.service_brake, is.service_brake, kNationalService, "the service brake");
  order(was.emergency_brake, is.emergency_brake, kNationalEmergency, "the emergency brake");
  order(was.trip_active, is.trip_active, kNationalTrip, "the trip");
  changed(Kind::fault, fault_, in.safety_fault, "a fault that affects safety is reported", "the fault is over");
  if (in.radio_link != RadioLink::unchanged)
    note(Kind::session,
         in.radio_link == RadioLink::connected ? "the radio is connected"
         : in.radio_link == RadioLink::lost    ? "the radio connection is lost"
                                               : "the radio connection is refused",
         in.radio_link == RadioLink::connected ? std::uint8_t{0} : kNotConnected);
  train_ = t;
  windows_ = in.windows;
  national_system_ = in.national_system;
  fault_ = in.safety_fault;
  first_ = false;
}

}  // namespace evc::explain
