#include <fmt/format.h>

#include "explain/journal.h"
#include "texts/texts.h"

// The inputs of driver, train interface and bearer in words.
namespace evc::explain {
namespace {

std::string driver_enters(const port::DriverActions& d) {
  std::string text;
  const auto add = [&text](bool given, const std::string& what) {
    if (given) text += (text.empty() ? "driver enters " : ", ") + what;
  };
  add(d.driver_id.has_value(), "the driver identity");
  add(d.level.has_value(), d.level ? fmt::format("level {}", name(*d.level)) : "");
  add(d.rbc_contact.has_value(), "the RBC contact");
  add(d.train_data != nullptr, "train data");
  add(d.train_running_number.has_value(), "the train running number");
  add(d.V_sr.has_value() || d.D_sr.has_value(), "SR speed or distance");
  add(d.cover.has_value(), "a virtual balise cover");
  add(d.network.has_value(), "a radio network");
  return text;
}

const char* controller(port::DirectionController position) {
  return position == port::DirectionController::forward    ? "direction controller forward"
         : position == port::DirectionController::backward ? "direction controller backward"
                                                           : "direction controller neutral";
}

}  // namespace

void Journal::take_acts(const sim::CycleInputs& cycle) {
  using Kind = Act::Kind;
  const port::Inputs& in = cycle.levels;
  const auto note = [&](Kind kind, std::string text) { acts_.push_back({cycle.t_ms, kind, std::move(text)}); };
  const auto changed = [&](Kind kind, bool was, bool is, const char* yes, const char* no) {
    if (was != is) note(kind, is ? yes : no);
  };
  for (unsigned n = 0; n < static_cast<unsigned>(port::Select::count); ++n)
    if (in.driver.has(static_cast<port::Select>(n)))
      note(Kind::select, fmt::format("driver selects {}", texts::words_of(static_cast<port::Select>(n))));
  for (unsigned n = 0; n < static_cast<unsigned>(Ack::count); ++n)
    if (in.driver.has(static_cast<Ack>(n)))
      note(Kind::acknowledge, fmt::format("driver acknowledges {}", kAckRows[n].name));
  port::DriverActions driver = in.driver;
  driver.train_data = cycle.train_data ? &*cycle.train_data : nullptr;
  if (std::string text = driver_enters(driver); !text.empty()) note(Kind::enter, std::move(text));
  using port::Window;
  changed(Kind::window, windows_.has(Window::train_data), in.windows.has(Window::train_data),
          "driver opens the window of train data", "driver closes the window of train data");
  changed(Kind::window, windows_.has(Window::SR_data), in.windows.has(Window::SR_data),
          "driver opens the window of SR speed and distance", "driver closes the window of SR speed and distance");
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
  if (!(national_system_ == in.national_system)) note(Kind::national_system, "the national system reports a change");
  changed(Kind::fault, fault_, in.safety_fault, "a fault that affects safety is reported", "the fault is over");
  if (in.radio_link != RadioLink::unchanged)
    note(Kind::session, in.radio_link == RadioLink::connected ? "the radio is connected"
                        : in.radio_link == RadioLink::lost    ? "the radio connection is lost"
                                                              : "the radio connection is refused");
  train_ = t;
  windows_ = in.windows;
  national_system_ = in.national_system;
  fault_ = in.safety_fault;
  first_ = false;
}

}  // namespace evc::explain
