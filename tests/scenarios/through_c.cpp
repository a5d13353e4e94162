#include "through_c.h"

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <memory>
#include <sstream>
#include <vector>

#include "capi/outputs.h"
#include "io/input_stream.h"
#include "openevc/evc.h"
#include "openevc/openevc.h"

namespace evc::scenario {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

openevc_rbc of(const std::optional<port::RbcIdentity>& with, bool infill_unit) {
  openevc_rbc rbc{};
  rbc.infill_unit = infill_unit;
  if (!with) return rbc;
  rbc.given = 1;
  rbc.NID_C = with->NID_C;
  rbc.NID_RBC = with->NID_RBC;
  return rbc;
}

/// The inputs of a cycle in C, with the arrays they refer to.
struct InC {
  openevc_inputs in{};
  std::vector<openevc_telegram> telegrams;
  std::vector<double> passed;
  std::vector<openevc_message> loops, radio;
  std::vector<openevc_rbc> radio_from;
};

void set_trackside(InC& c, const port::Inputs& from) {
  for (const port::BaliseTelegram& t : from.balise_telegrams) {
    c.telegrams.push_back({t.bytes.data(), static_cast<std::uint32_t>(t.bits), 0, t.at.from_origin.si});
    c.passed.push_back(t.passed ? t.passed->si : kNone);
  }
  for (const port::LoopMessage& m : from.loop_messages) c.loops.push_back({m.bytes.data(), m.bytes.size()});
  for (const port::RadioMessage& m : from.radio_messages) {
    c.radio.push_back({m.bytes.data(), m.bytes.size()});
    c.radio_from.push_back(of(m.from, m.infill_unit));
  }
  c.in.telegrams = c.telegrams.data();
  c.in.telegrams_passed = c.passed.data();
  c.in.telegrams_count = c.telegrams.size();
  c.in.loops = c.loops.data();
  c.in.loops_count = c.loops.size();
  c.in.radio = c.radio.data();
  c.in.radio_from = c.radio_from.data();
  c.in.radio_count = c.radio.size();
  c.in.link = static_cast<std::int32_t>(from.radio_link);
  c.in.link_with = of(from.radio_link_with, from.radio_link_of_infill_unit);
}

void set_driver(openevc_inputs& in, const port::DriverActions& d) {
  in.selected = d.selected;
  in.acknowledged = d.acknowledged;
  in.acknowledged_text = d.acknowledged_text;
  const auto entered = [&in](bool given, openevc_entry entry) {
    if (given) in.entered |= 1u << entry;
  };
  entered(d.driver_id.has_value(), OPENEVC_ENTRY_DRIVER_ID);
  entered(d.level.has_value(), OPENEVC_ENTRY_LEVEL);
  entered(d.rbc_contact.has_value(), OPENEVC_ENTRY_RBC_CONTACT);
  entered(d.train_running_number.has_value(), OPENEVC_ENTRY_TRAIN_RUNNING_NUMBER);
  entered(d.V_sr.has_value(), OPENEVC_ENTRY_SR_SPEED);
  entered(d.D_sr.has_value(), OPENEVC_ENTRY_SR_DISTANCE);
  entered(d.cover.has_value(), OPENEVC_ENTRY_VBC);
  entered(d.network.has_value(), OPENEVC_ENTRY_NETWORK);
  entered(d.set_speed.has_value(), OPENEVC_ENTRY_SET_SPEED);
  in.set_speed = d.set_speed.value_or(Speed{}).si;
  entered(d.train_data != nullptr, OPENEVC_ENTRY_TRAIN_DATA);
  entered(d.language.has_value(), OPENEVC_ENTRY_LANGUAGE);
  if (d.language) std::memcpy(in.language, d.language->letters.data(), d.language->letters.size());
  if (d.driver_id) std::memcpy(in.driver_id_text, d.driver_id->characters.data(), DriverId::kMost);
  in.train_running_number = d.train_running_number.value_or(0);
  in.level = d.level ? static_cast<std::int32_t>(*d.level) : 0;
  in.NID_NTC = d.nid_ntc;
  if (d.rbc_contact) {
    in.NID_C = d.rbc_contact->NID_C;
    in.NID_RBC = d.rbc_contact->NID_RBC;
    in.NID_RADIO = d.rbc_contact->NID_RADIO;
  }
  if (d.cover) {
    in.VBC_NID_C = d.cover->NID_C;
    in.VBC_NID_VBCMK = d.cover->NID_VBCMK;
    in.VBC_T_VBC = d.cover->T_VBC;
  }
  in.network = d.network.value_or(0);
  if (d.V_sr) in.V_sr = d.V_sr->si;
  if (d.D_sr) in.D_sr = d.D_sr->si;
}

void set_train(openevc_inputs& in, const port::TrainSignals& t) {
  in.powered = t.powered;
  in.isolated = t.isolated;
  in.desk_open = t.desk_open;
  in.cab = t.cab == kernel::Cab::B ? 1 : 0;
  in.sleeping = t.sleeping;
  in.non_leading = t.non_leading;
  in.passive_shunting = t.passive_shunting;
  in.direction = t.direction_controller == port::DirectionController::forward    ? std::int8_t{1}
                 : t.direction_controller == port::DirectionController::backward ? std::int8_t{-1}
                                                                                 : std::int8_t{0};
  in.service_brake_feedback = t.service_brake_feedback;
  in.regenerative_brake_active = t.regenerative_brake_active;
  in.eddy_current_brake_active = t.eddy_current_brake_active;
  in.magnetic_shoe_brake_active = t.magnetic_shoe_brake_active;
  in.ep_brake_active = t.ep_brake_active;
  in.additional_brake_active = t.additional_brake_active;
  in.antenna_alarm = t.antenna_alarm;
  in.radio_registered = t.radio_registered;
  in.integrity = static_cast<std::int32_t>(t.integrity);
  in.brake_pressure_kpa = t.brake_pressure_kpa.value_or(kNone);
  in.length_confirmed = t.length_confirmed ? t.length_confirmed->si : kNone;
}

void set_states(openevc_inputs& in, const port::Inputs& from) {
  in.now = from.now.si;
  in.nominal = from.odometry.nominal.from_origin.si;
  in.min = from.odometry.min.from_origin.si;
  in.max = from.odometry.max.from_origin.si;
  in.V_est = from.odometry.V_est.si;
  in.V_min = from.odometry.V_min.si;
  in.V_max = from.odometry.V_max.si;
  in.A_est = from.odometry.A_est.si;
  in.measured = from.odometry.measured ? from.odometry.measured->si : kNone;
  in.open_windows = static_cast<std::uint32_t>(from.windows.bits());
  in.national_systems = from.national_system.available;
  in.national_trip = from.national_system.trip_active;
  in.national_service_brake = from.national_system.service_brake;
  in.national_emergency_brake = from.national_system.emergency_brake;
  in.safety_fault = from.safety_fault;
  in.utc_given = from.utc.has_value();
  in.utc = from.utc.value_or(0);
  in.moved = !from.moved ? OPENEVC_MOVEMENT_UNKNOWN : *from.moved ? OPENEVC_MOVED : OPENEVC_NOT_MOVED;
}

/// The train data that are entered, or given by another source, in the order of the lines.
std::vector<std::string> train_documents(const std::string& inputs, const char* where) {
  std::vector<std::string> found;
  std::istringstream lines(inputs);
  for (std::string line; std::getline(lines, line);) {
    const io::Json object = io::Json::parse(line);
    const io::Json::json_pointer place(where);
    if (object.contains(place)) found.push_back(object[place].dump());
  }
  return found;
}

struct Free {
  void operator()(void* memory) const { std::free(memory); }
};

class Both {
 public:
  explicit Both(const io::Configuration& configuration)
      : ours_(std::make_unique<kernel::Unit>()),
        outputs_(std::make_unique<kernel::Outputs>()),
        expected_(std::make_unique<openevc_outputs>()),
        given_(std::make_unique<openevc_outputs>()) {
    kernel::Config config = configuration.for_kernel();
    config.terminals = configuration.terminals.value_or(1);
    kernel::power_up(*ours_, config);
    const std::size_t size =
        (openevc_unit_size() + openevc_alignment() - 1) / openevc_alignment() * openevc_alignment();
    memory_.reset(std::aligned_alloc(openevc_alignment(), size));
    const std::string& text = configuration.document;
    if (openevc_power_up(memory_.get(), size, text.data(), text.size(), &unit_, why_, sizeof why_) != OPENEVC_OK)
      unit_ = nullptr;
  }
  /// Empty if both give the same.
  std::string step(const port::Inputs& inputs, const openevc_inputs& in) {
    kernel::step(*ours_, inputs, *outputs_);
    capi::give_outputs(*expected_, *outputs_);
    expected_->size = given_->size = sizeof *given_;
    if (openevc_step(unit_, &in, given_.get(), why_, sizeof why_) != OPENEVC_OK) return why_;
    if (std::memcmp(expected_.get(), given_.get(), sizeof *given_) != 0) return "the outputs differ";
    return same_planning() ? "" : "the advance displays differ";
  }

 private:
  bool same_planning() {
    capi::give_planning(*planned_, kernel::plan(*ours_, *planning_) ? planning_.get() : nullptr);
    planned_->size = planned_by_c_->size = sizeof *planned_;
    return openevc_plan(unit_, planned_by_c_.get()) == OPENEVC_OK &&
           std::memcmp(planned_.get(), planned_by_c_.get(), sizeof *planned_) == 0;
  }

  std::unique_ptr<kernel::Unit> ours_;
  std::unique_ptr<kernel::Outputs> outputs_;
  std::unique_ptr<openevc_outputs> expected_, given_;
  std::unique_ptr<kernel::Planning> planning_ = std::make_unique<kernel::Planning>();
  std::unique_ptr<openevc_planning> planned_ = std::make_unique<openevc_planning>();
  std::unique_ptr<openevc_planning> planned_by_c_ = std::make_unique<openevc_planning>();
  std::unique_ptr<void, Free> memory_;
  openevc_unit* unit_ = nullptr;
  char why_[256] = "";
};

}  // namespace

std::string compare_through_c(const std::string& inputs) {
  auto stream = io::InputStream::open("inputs", io::lines_of(inputs));
  if (!stream) return stream.error().text();
  const auto entered = train_documents(inputs, "/driver/enter/train_data");
  const auto external = train_documents(inputs, "/train/data");
  std::size_t n_entered = 0, n_external = 0;
  Both both(stream->configuration());
  sim::CycleInputs cycle;
  for (;;) {
    const auto more = stream->next(cycle);
    if (!more) return more.error().text();
    if (!*more) break;
    const port::Inputs& view = cycle.view();
    InC c;
    if (openevc_inputs_init(&c.in, sizeof c.in) != OPENEVC_OK) return "openevc_inputs_init";
    set_states(c.in, view);
    set_trackside(c, view);
    set_driver(c.in, view.driver);
    set_train(c.in, view.train);
    if (view.driver.train_data != nullptr) {
      const std::string& text = entered.at(n_entered++);
      c.in.train_data = text.data();
      c.in.train_data_length = text.size();
    }
    if (view.external_train_data.data != nullptr) {
      const std::string& text = external.at(n_external++);
      c.in.external_train_data = text.data();
      c.in.external_train_data_length = text.size();
      c.in.external_data_trusted = !view.external_train_data.driver_validates;
    }
    const std::string difference = both.step(view, c.in);
    if (!difference.empty()) return "at " + std::to_string(cycle.t_ms) + " ms: " + difference;
  }
  return "";
}

}  // namespace evc::scenario
