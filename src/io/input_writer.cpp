#include "io/input_writer.h"

#include <cmath>

#include "io/date_time.h"
#include "io/number.h"
#include "io/rbc_contact.h"
#include "texts/texts.h"

namespace evc::io {
namespace {

using sim::CycleInputs;

std::string opened(std::int64_t t_ms) {
  std::string line = "{\"t_ms\":";
  append_number(line, t_ms);
  return line;
}

/// Milliseconds, where they are not those of the line.
void append_time(std::string& out, const std::optional<Duration>& at, std::int64_t t_ms, const char* key) {
  if (!at || at->si == static_cast<double>(t_ms) / 1000.0) return;
  out += key;
  append_number(out, at->si * 1000.0);
}

void append_odometer(std::string& out, const kernel::Odometry& o, std::int64_t t_ms) {
  const auto field = [&](const char* key, double value) {
    out += key;
    append_number(out, value);
  };
  field(",\"odometer\":{\"nominal_m\":", o.nominal.from_origin.si);
  field(",\"min_m\":", o.min.from_origin.si);
  field(",\"max_m\":", o.max.from_origin.si);
  field(",\"speed_mps\":", o.V_est.si);
  field(",\"speed_min_mps\":", o.V_min.si);
  field(",\"speed_max_mps\":", o.V_max.si);
  field(",\"accel_mps2\":", o.A_est.si);
  append_time(out, o.measured, t_ms, ",\"at_ms\":");
  out += '}';
}

void append_integrity(std::string& fields, const kernel::TrainSignals& before, const kernel::TrainSignals& now) {
  if (before.integrity == now.integrity && before.length_confirmed == now.length_confirmed) return;
  fields += fields.empty() ? "" : ",";
  fields += std::string("\"integrity\":\"") + terms::kNames<kTrainIntegrityRows>[terms::index(now.integrity)] + '"';
  if (!now.length_confirmed) return;
  fields += ",\"train_length_m\":";
  append_number(fields, now.length_confirmed->si);
}

void append_consist_end(std::string& fields, const char* name, const ConsistEnd& end) {
  fields += name;
  append_number(fields, end.nominal.si);
  fields += ',';
  append_number(fields, end.min.si);
  fields += ',';
  append_number(fields, end.max.si);
  fields += ']';
}

void append_consist(std::string& fields, const kernel::TrainSignals& before, const kernel::TrainSignals& now) {
  if (before.consist == now.consist) return;
  fields += fields.empty() ? "\"safe_consist_length\":" : ",\"safe_consist_length\":";
  if (!now.consist) {
    fields += "null";
    return;
  }
  append_consist_end(fields, "{\"front_m\":[", now.consist->front);
  append_consist_end(fields, ",\"rear_m\":[", now.consist->rear);
  fields += '}';
}

/// Appends what changed in the signals as `,"train":{...}`.
void append_signals(std::string& out, kernel::TrainSignals& before, const kernel::TrainSignals& now) {
  std::string fields;
  const auto flag = [&](const char* key, bool kernel::TrainSignals::*signal) {
    if (before.*signal == now.*signal) return;
    fields += fields.empty() ? "\"" : ",\"";
    fields += key;
    fields += now.*signal ? "\":true" : "\":false";
  };
  using S = kernel::TrainSignals;
  flag("powered", &S::powered);
  flag("isolated", &S::isolated);
  // Of cab A without its name, as before there were two.
  if (now.cab == kernel::Cab::A && before.cab == kernel::Cab::A) {
    flag("desk_open", &S::desk_open);
  } else if (before.desk_open != now.desk_open || (now.desk_open && before.cab != now.cab)) {
    fields += fields.empty() ? "" : ",";
    fields += now.desk_open ? std::string("\"cab\":\"") + texts::kCabNames[static_cast<std::size_t>(now.cab)] + '"'
                            : std::string("\"cab\":null");
  }
  flag("sleeping", &S::sleeping);
  flag("non_leading", &S::non_leading);
  flag("passive_shunting", &S::passive_shunting);
  flag("service_brake_feedback", &S::service_brake_feedback);
  flag("regenerative_brake_active", &S::regenerative_brake_active);
  flag("eddy_current_brake_active", &S::eddy_current_brake_active);
  flag("magnetic_shoe_brake_active", &S::magnetic_shoe_brake_active);
  flag("ep_brake_active", &S::ep_brake_active);
  flag("additional_brake_active", &S::additional_brake_active);
  flag("antenna_alarm", &S::antenna_alarm);
  flag("radio_registered", &S::radio_registered);
  if (before.direction_controller != now.direction_controller) {
    fields += fields.empty() ? "" : ",";
    fields += "\"direction_controller\":\"";
    fields += texts::kDirectionNames[static_cast<std::size_t>(now.direction_controller)];
    fields += '"';
  }
  if (before.brake_pressure_kpa != now.brake_pressure_kpa) {
    fields += fields.empty() ? "" : ",";
    fields += "\"brake_pressure_kpa\":";
    if (now.brake_pressure_kpa)
      append_number(fields, *now.brake_pressure_kpa);
    else
      fields += "null";
  }
  append_integrity(fields, before, now);
  append_consist(fields, before, now);
  before = now;
  if (!fields.empty()) out += ",\"train\":{" + fields + "}";
}

void append_moved(std::string& out, std::optional<bool>& before, const kernel::Inputs& now) {
  if (before == now.moved) return;
  before = now.moved;
  if (!now.moved || !now.train.powered) return;
  out += *now.moved ? ",\"power\":{\"on\":true,\"moved\":true}" : ",\"power\":{\"on\":true,\"moved\":false}";
}

void append_national(std::string& out, kernel::NationalSystem& before, const kernel::NationalSystem& now) {
  if (before == now) return;
  before = now;
  out += ",\"national_system\":{\"available\":[";
  bool first = true;
  for (unsigned n = 0; n < 64; ++n) {
    if (((now.available >> n) & 1u) == 0) continue;
    if (!first) out += ',';
    first = false;
    append_number(out, static_cast<std::int64_t>(n));
  }
  out += now.trip_active ? "],\"trip_active\":true" : "],\"trip_active\":false";
  out += now.service_brake ? ",\"service_brake\":true" : ",\"service_brake\":false";
  out += now.emergency_brake ? ",\"emergency_brake\":true}" : ",\"emergency_brake\":false}";
}

void append_automatic_operation(std::string& out, kernel::AutomaticOperation& before,
                                const kernel::AutomaticOperation& now) {
  if (before == now) return;
  before = now;
  out += now.requests_AD ? ",\"ato\":{\"requests_AD\":true" : ",\"ato\":{\"requests_AD\":false";
  out += now.active ? ",\"selector\":\"active\"}" : ",\"selector\":\"stand_by\"}";
}

/// The windows that opened or closed.
void append_windows(std::string& out, std::int64_t t_ms, Set<kernel::Window>& before, Set<kernel::Window> now) {
  for (std::size_t n = 0; n < texts::kWindowNames.size(); ++n) {
    const auto window = static_cast<kernel::Window>(n);
    if (before.has(window) == now.has(window)) continue;
    out += opened(t_ms) + ",\"driver\":{\"window\":{\"" + (now.has(window) ? "opened" : "closed") + "\":\"" +
           texts::kWindowNames[n] + "\"}}}\n";
  }
  before = now;
}

void append_digits_member(std::string& out, const char* key, std::uint32_t packed) {
  out += key;
  out += '"';
  append_packed(out, packed);
  out += '"';
}

/// The train's document with what a driver may have entered otherwise (015560 11.3.9.6).
std::string entered_document(const std::string& train_document, const train::TrainData& data) {
  Json document = Json::parse(train_document, nullptr, false);
  if (!document.is_object()) document = Json::object();
  document["length_m"] = data.L_TRAIN.si;
  // A speed that was entered is a whole number of km/h.
  document["max_speed_kmh"] = std::nearbyint(data.V_MAXTRAIN.si * 3.6e6) / 1e6;
  if (data.brake_model == train::BrakeModel::lambda) document["brake_percentage"] = data.brake_percentage;
  constexpr const char* kPositions[] = {"PassengerP", "FreightP", "FreightG"};
  document["brake_position"] = kPositions[static_cast<std::size_t>(data.brake_position)];
  Json& category = document["category"];
  if (!category.is_object()) category = Json::object();
  category["cant_deficiency_mm"] = data.cant_deficiency_mm;
  category["other"] = Json::array();
  for (std::size_t n = 0; n < kOtherCategoryNames.size(); ++n)
    if (((data.other_categories >> n) & 1u) != 0) category["other"].push_back(kOtherCategoryNames[n]);
  category["axle_load"] = terms::kNames<kAxleLoadRows>[terms::index(data.axle_load)];
  category["loading_gauge"] = terms::kNames<kLoadingGaugeRows>[terms::index(data.loading_gauge)];
  category["airtight"] = data.airtight;
  return document.dump();
}

void append_enter(std::string& out, const CycleInputs& cycle, const std::string& train_document) {
  const auto& d = cycle.levels.driver;
  std::string fields;
  if (d.driver_id) {
    fields += ",\"driver_id\":";
    append_string(fields, d.driver_id->view());
  }
  if (d.level) {
    fields += ",\"level\":\"";
    fields += name(*d.level);
    fields += '"';
    if (*d.level == Level::NTC) {
      fields += ",\"nid_ntc\":";
      append_number(fields, static_cast<std::int64_t>(d.nid_ntc));
    }
  }
  if (d.rbc_contact) {
    fields += ",\"rbc\":";
    append_contact(fields, d.rbc_contact->NID_C, d.rbc_contact->NID_RBC, d.rbc_contact->NID_RADIO);
  }
  if (d.network) fields += ",\"network\":\"" + digits_of_NID_MN(*d.network) + '"';
  if (d.cover) {
    fields += ",\"vbc\":{\"NID_C\":";
    append_number(fields, static_cast<std::int64_t>(d.cover->NID_C));
    fields += ",\"NID_VBCMK\":";
    append_number(fields, static_cast<std::int64_t>(d.cover->NID_VBCMK));
    fields += ",\"T_VBC\":";
    append_number(fields, static_cast<std::int64_t>(d.cover->T_VBC));
    fields += '}';
  }
  if (d.V_sr) {
    fields += ",\"V_sr_kmh\":";
    append_number(fields, d.V_sr->si * 3.6);
  }
  if (d.D_sr) {
    fields += ",\"D_sr_m\":";
    append_number(fields, d.D_sr->si);
  }
  if (d.language) {
    fields += ",\"language\":";
    append_string(fields, d.language->view());
  }
  if (d.set_speed) {
    fields += ",\"set_speed_kmh\":";
    append_number(fields, d.set_speed->si * 3.6);
  }
  if (cycle.train_data) fields += ",\"train_data\":" + train_document;
  if (d.train_running_number) append_digits_member(fields, ",\"train_running_number\":", *d.train_running_number);
  if (!fields.empty()) out += opened(cycle.t_ms) + ",\"driver\":{\"enter\":{" + fields.substr(1) + "}}}\n";
}

void append_driver(std::string& out, const CycleInputs& cycle, const std::string& train_document) {
  append_enter(out, cycle, train_document);
  const auto bits = [&](std::uint32_t set, const char* key, std::span<const char* const> names) {
    for (std::size_t n = 0; n < names.size(); ++n)
      if (((set >> n) & 1u) != 0) out += opened(cycle.t_ms) + ",\"driver\":{\"" + key + "\":\"" + names[n] + "\"}}\n";
  };
  bits(cycle.levels.driver.selected, "select", texts::kSelectNames);
  std::uint32_t acknowledged = cycle.levels.driver.acknowledged;
  if (const std::uint16_t id = cycle.levels.driver.acknowledged_text; id != 0) {
    acknowledged &= ~(1u << static_cast<unsigned>(Ack::text));
    out += opened(cycle.t_ms) + ",\"driver\":{\"ack\":{\"id\":" + std::to_string(id) + "}}}\n";
  }
  bits(acknowledged, "ack", terms::kNames<kAckRows>);
}

/// `more`: further members.
void append_received(std::string& out, std::int64_t t_ms, const char* key, const sim::Bits& bits,
                     const std::string& more = {}) {
  out += opened(t_ms) + ",\"" + key + "\":{\"message\":\"";
  append_hex(out, bits.bytes);
  out += '"' + more + "}}\n";
}

const char* radio_key(bool infill_unit) { return infill_unit ? "radio_in_fill" : "radio"; }

/// The member that names the RBC or radio infill unit of a radio input; nothing where it is the one called last.
std::string named(const std::optional<kernel::RbcIdentity>& with, bool infill_unit) {
  if (!with) return {};
  return ",\"to\":{\"NID_C\":" + std::to_string(with->NID_C) + (infill_unit ? ",\"NID_RIU\":" : ",\"NID_RBC\":") +
         std::to_string(with->NID_RBC) + '}';
}

}  // namespace

void InputWriter::append(std::string& out, const CycleInputs& cycle) {
  out += config_line_;
  config_line_.clear();
  out += opened(cycle.t_ms);
  append_odometer(out, cycle.levels.odometry, cycle.t_ms);
  append_signals(out, signals_, cycle.levels.train);
  append_moved(out, moved_, cycle.levels);
  append_national(out, national_, cycle.levels.national_system);
  append_automatic_operation(out, automatic_operation_, cycle.levels.automatic_operation);
  if (safety_fault_ != cycle.levels.safety_fault)
    out += cycle.levels.safety_fault ? ",\"fault\":{\"safety\":true}" : ",\"fault\":{\"safety\":false}";
  safety_fault_ = cycle.levels.safety_fault;
  out += "}\n";
  for (const auto& t : cycle.balises) {
    out += opened(cycle.t_ms);
    if (t.bits.size == 0) {
      out += ",\"balise_failed\":{";
    } else {
      out += ",\"balise\":{\"telegram\":\"";
      append_hex(out, t.bits.bytes);
      out += "\",";
    }
    if (t.passed) {
      out += "\"at_ms\":";
      append_number(out, t.passed->si * 1000.0);
    } else {
      out += "\"at_m\":";
      append_number(out, t.at.from_origin.si);
    }
    // 830 and 210 bits follow from the number of digits (the reader's user_bits).
    if (t.bits.size != 0 && t.bits.size != 830 && t.bits.size != 210) {
      out += ",\"bits\":";
      append_number(out, static_cast<std::int64_t>(t.bits.size));
    }
    out += "}}\n";
  }
  for (const auto& loop : cycle.loops) append_received(out, cycle.t_ms, "loop", loop);
  if (cycle.levels.radio_link != RadioLink::unchanged)
    out += opened(cycle.t_ms) + ",\"" + radio_key(cycle.levels.radio_link_of_infill_unit) + "\":{\"session\":\"" +
           terms::kNames<kRadioLinkRows>[terms::index(cycle.levels.radio_link)] + '"' +
           named(cycle.levels.radio_link_with, cycle.levels.radio_link_of_infill_unit) + "}}\n";
  for (const auto& message : cycle.radio)
    append_received(out, cycle.t_ms, radio_key(message.infill_unit), message, named(message.from, message.infill_unit));
  append_acts(out, cycle);
  if (!cycle.levels.utc) return;
  out += opened(cycle.t_ms) + ",\"clock\":{\"utc\":\"";
  append_date_time(out, *cycle.levels.utc);
  out += "Z\"}}\n";
}

void InputWriter::append_acts(std::string& out, const CycleInputs& cycle) {
  // Of data that were not changed the document stays as it was given.
  const bool changed = cycle.train_data && !(*cycle.train_data == train_);
  append_driver(out, cycle, changed ? entered_document(train_document_, *cycle.train_data) : train_document_);
  append_windows(out, cycle.t_ms, windows_, cycle.levels.windows);
}

void InputWriter::append_cab(std::string& out, const CycleInputs& cycle) {
  std::string signals;
  append_signals(signals, signals_, cycle.levels.train);
  if (!signals.empty()) out += opened(cycle.t_ms) + signals + "}\n";
  append_acts(out, cycle);
}

std::string configuration_document(const Configuration& c) {
  std::string out = "{\"cycle_ms\":";
  append_number(out, c.cycle_ms);
  out += std::string(",\"srs\":\"") + name(c.srs) + "\",\"train\":" + c.train.document + ",\"levels\":[";
  bool first = true;
  for (std::size_t n = 0; n < kLevels; ++n) {
    if (!c.levels[n]) continue;
    out += std::string(first ? "\"" : ",\"") + name(static_cast<Level>(n)) + "\"";
    first = false;
  }
  out += ']';
  if (c.terminals) out += ",\"terminals\":" + std::to_string(*c.terminals);
  first = true;
  for (const std::uint32_t NID_MN : c.networks) {
    out += (first ? ",\"networks\":[\"" : ",\"") + digits_of_NID_MN(NID_MN) + '"';
    first = false;
  }
  return out + (first ? "}" : "]}");
}

}  // namespace evc::io
