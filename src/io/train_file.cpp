#include "io/train_file.h"

#include <algorithm>

#include "io/number.h"
#include "io/refuse.h"
#include "io/steps.h"

namespace evc::io {
namespace {

using train::TrainData;

constexpr std::initializer_list<const char*> kTrainKeys = {
    "schema",
    "name",
    "brake_model",
    "brake_position",
    "brake_percentage",
    "A_brake_emergency",
    "A_brake_service",
    "A_brake_normal_service",
    "A_brake_normal_service_G",
    "Kdry_rst",
    "Kwet_rst",
    "Kn_plus",
    "Kn_minus",
    "T_brake_emergency_s",
    "T_brake_service_s",
    "T_brake_emergency_react_s",
    "T_brake_service_react_s",
    "length_m",
    "max_speed_kmh",
    "L_antenna_front_m",
    "M_rotating_nom_pct",
    "T_traction_cut_off_s",
    "traction_cut_off_interface",
    "service_brake_interface",
    "service_brake_feedback",
    "special_brakes",
    "category",
    "dynamics",
};

/// The clauses of the ranges (SUBSET-026).
constexpr Clause kModels = "3.13.2.2.3.1"_srs;
constexpr Clause kTimes = "3.13.2.2.3.2"_srs;
constexpr Clause kNormalService = "3.13.2.2.3.1.9"_srs;
constexpr Clause kCorrection = "3.13.2.2.9.1"_srs;
constexpr Clause kOnGradients = "3.13.2.2.9.2.1"_srs;

train::DecelerationSteps read_decelerations(const JsonPlace& table, Clause clause = kModels) {
  return read_steps<train::DecelerationSteps>(table, kKmh, clause, [clause](const JsonPlace& row) {
    require_row(row, 2);
    return Acceleration{row[1].number(0.0, 10.0, clause)};
  });
}

using ConfidenceFactors = std::array<train::Factor, train::kConfidenceLevels>;
using DryFactors = StepFunction<Speed, ConfidenceFactors, train::kSpeedSteps>;
using WetFactors = StepFunction<Speed, train::Factor, train::kSpeedSteps>;

train::Factor read_factor(const JsonPlace& place) {
  return train::Factor::of(number_or(place, 0.0, 1.0, train::Fault::correction_factor));
}

/// One factor for all confidence levels, or one for each of M_NVEBCL 0..9.
DryFactors read_dry_factors(const JsonPlace& table) {
  return read_steps<DryFactors>(table, kKmh, kCorrection, [](const JsonPlace& row) {
    ConfidenceFactors factors{};
    const bool per_level = row.size() == 1 + train::kConfidenceLevels;
    if (!per_level) require_row(row, 2);
    for (std::size_t n = 0; n < train::kConfidenceLevels; ++n) factors[n] = read_factor(row[per_level ? n + 1 : 1]);
    return factors;
  });
}

WetFactors read_wet_factors(const JsonPlace& table) {
  return read_steps<WetFactors>(table, kKmh, kCorrection, [](const JsonPlace& row) {
    require_row(row, 2);
    return read_factor(row[1]);
  });
}

/// Deceleration and factors on common steps (3.13.2.2.9.2): the union of their change points, each
/// with the values of the three tables in that step (a step includes its upper limit).
train::EmergencySteps read_emergency_steps(const JsonPlace& model) {
  const JsonPlace table = model["A_brake_emergency"];
  const auto a = read_decelerations(table);
  const auto dry = model.find("Kdry_rst");
  const auto wet = model.find("Kwet_rst");
  const DryFactors kdry = dry ? read_dry_factors(*dry) : DryFactors{};
  const WetFactors kwet = wet ? read_wet_factors(*wet) : WetFactors{};
  std::vector<Speed> from;
  for (const auto& s : a.steps) from.push_back(s.from);
  for (const auto& s : kdry.steps) from.push_back(s.from);
  for (const auto& s : kwet.steps) from.push_back(s.from);
  std::sort(from.begin(), from.end());
  from.erase(std::unique(from.begin(), from.end()), from.end());
  train::EmergencySteps steps;
  for (const Speed v : from) {
    // `at` includes the lower limit: at the change point it returns the step that begins there.
    train::EmergencyStep step;
    step.A_brake_emergency = a.at(v);
    step.Kwet_rst = kwet.empty() ? train::Factor::of(1.0) : kwet.at(v);
    step.Kdry_rst.fill(train::Factor::of(1.0));
    if (!kdry.empty()) step.Kdry_rst = kdry.at(v);
    if (!steps.steps.push_back({v, step}))
      table.fail("at most 7 common steps of deceleration and factors" + of_clause("3.13.2.2.9.2"_srs));
  }
  return steps;
}

constexpr std::initializer_list<const char*> kInterfaces = {"no interface", "status affects EB only",
                                                            "status affects SB only", "affects both"};

train::SpecialBrakeInterface read_interface(const JsonPlace& brakes, const char* key) {
  const auto place = brakes.find(key);
  return place ? static_cast<train::SpecialBrakeInterface>(place->one_of(kInterfaces))
               : train::SpecialBrakeInterface::none;
}

template <std::size_t N>
void add(InplaceVector<train::BuildUpTime, N>& times, const JsonPlace& model, const char* key, const char* react,
         train::BrakeSet with) {
  const auto place = model.find(key);
  const auto reaction = model.find(react);
  if (!place && !reaction) return;
  train::BuildUpTime time;
  time.T_brake = {model[key].number(0.0, 120.0, kTimes)};
  time.T_brake_react = time.T_brake;  // unknown: the time cannot be reduced (A.3.12)
  if (reaction) time.T_brake_react = {number_or(*reaction, 0.0, time.T_brake.si, train::Fault::build_up_time)};
  time.with = with;
  if (!times.push_back(time)) place->fail("at most " + std::to_string(N) + " build-up times");
}

/// The brake models of one combination of special brakes in use.
void read_models(TrainData& data, const JsonPlace& model, train::BrakeSet with) {
  if (model.find("A_brake_emergency") && !data.emergency.push_back({read_emergency_steps(model), with}))
    model.fail("at most 4 models of the emergency brake");
  for (const char* key : {"Kdry_rst", "Kwet_rst"}) {
    const auto factors = model.find(key);
    if (factors && !model.find("A_brake_emergency")) factors->fail("A_brake_emergency in the same block");
  }
  if (const auto service = model.find("A_brake_service"))
    if (!data.service.push_back({read_decelerations(*service), with}))
      service->fail("at most 4 models of the service brake");
  add(data.T_emergency, model, "T_brake_emergency_s", "T_brake_emergency_react_s", with);
  add(data.T_service, model, "T_brake_service_s", "T_brake_service_react_s", with);
}

train::BrakeSet read_brake_set(const JsonPlace& names) {
  train::BrakeSet set = 0;
  for (std::size_t i = 0; i < names.size(); ++i)
    set = static_cast<train::BrakeSet>(
        set | (1u << names[i].one_of({"regenerative", "eddy current", "magnetic shoe", "ep"})));
  return set;
}

void read_special_brakes(TrainData& data, const JsonPlace& brakes) {
  brakes.know_only({"regenerative", "eddy current", "magnetic shoe", "ep", "regenerative_needs_line_voltage",
                    "adhesion_independent_brake", "models"});
  data.regenerative = read_interface(brakes, "regenerative");
  data.eddy_current = read_interface(brakes, "eddy current");
  data.magnetic_shoe = read_interface(brakes, "magnetic shoe");
  data.electro_pneumatic = read_interface(brakes, "ep");
  // The table of 3.13.2.2.6 does not have these cases.
  for (const char* key : {"magnetic shoe", "ep"}) {
    const auto place = brakes.find(key);
    if (!place) continue;
    const std::size_t interface = place->one_of(kInterfaces);
    const bool magnetic = std::string(key) == "magnetic shoe";
    if ((magnetic && interface >= 2) || (!magnetic && interface == 1)) place->fail("an interface of 3.13.2.2.6");
  }
  if (const auto p = brakes.find("regenerative_needs_line_voltage"))
    data.regenerative_needs_line_voltage = p->boolean();
  if (const auto p = brakes.find("adhesion_independent_brake")) data.adhesion_independent_brake = p->boolean();
  if (const auto models = brakes.find("models"))
    for (std::size_t i = 0; i < models->size(); ++i) {
      const JsonPlace model = (*models)[i];
      model.know_only({"with", "A_brake_emergency", "Kdry_rst", "Kwet_rst", "A_brake_service", "T_brake_emergency_s",
                       "T_brake_service_s", "T_brake_emergency_react_s", "T_brake_service_react_s"});
      read_models(data, model, read_brake_set(model["with"]));
    }
}

/// One table for every full service deceleration, or the three models with their limits.
train::NormalServiceModels read_normal_service(const JsonPlace& place) {
  train::NormalServiceModels normal;
  if (place.is_array()) {
    normal.A_brake_normal_service.fill(read_decelerations(place, kNormalService));
    return normal;
  }
  place.know_only({"A_SB01", "A_SB12", "models"});
  normal.A_SB01 = {place["A_SB01"].number(0.0, 10.0, kNormalService)};
  normal.A_SB12 = {place["A_SB12"].number(normal.A_SB01.si, 10.0, kNormalService)};
  require_row(place["models"], normal.A_brake_normal_service.size());
  for (std::size_t i = 0; i < normal.A_brake_normal_service.size(); ++i)
    normal.A_brake_normal_service[i] = read_decelerations(place["models"][i], kNormalService);
  return normal;
}

train::KnSteps read_kn(const JsonPlace& table) {
  return read_steps<train::KnSteps>(table, kKmh, kOnGradients, [](const JsonPlace& row) {
    require_row(row, 2);
    return Acceleration{row[1].number(0.0, 10.0, kOnGradients)};
  });
}

void read_category(TrainData& data, const JsonPlace& category) {
  category.know_only(
      {"cant_deficiency_mm", "other", "axle_load", "loading_gauge", "traction_systems", "airtight", "axles"});
  if (const auto p = category.find("cant_deficiency_mm"))
    data.cant_deficiency_mm = static_cast<std::uint16_t>(p->integer(0, 400));
  if (const auto other = category.find("other"))
    for (std::size_t i = 0; i < other->size(); ++i)
      data.other_categories =
          static_cast<std::uint16_t>(data.other_categories | (1u << (*other)[i].one_of(kOtherCategoryNames)));
  if (const auto p = category.find("axle_load")) data.axle_load = p->term<kAxleLoadRows>();
  if (const auto p = category.find("loading_gauge")) data.loading_gauge = p->term<kLoadingGaugeRows>();
  if (const auto p = category.find("airtight")) data.airtight = p->boolean();
  if (const auto p = category.find("axles")) data.axles = static_cast<std::uint16_t>(p->integer(1, 1022));
  const auto systems = category.find("traction_systems");
  for (std::size_t i = 0; systems && i < systems->size(); ++i) {
    const JsonPlace system = (*systems)[i];
    train::TractionSystem read;
    if (system.is_object()) {
      system.know_only({"M_VOLTAGE", "NID_CTRACTION"});
      read.M_VOLTAGE = static_cast<std::uint8_t>(system["M_VOLTAGE"].integer(0, 15));
      if (const auto p = system.find("NID_CTRACTION"))
        read.NID_CTRACTION = static_cast<std::uint16_t>(p->integer(0, 1023));
    } else {
      read.M_VOLTAGE = static_cast<std::uint8_t>(system.integer(0, 15));
    }
    if (!data.traction_systems.push_back(read)) systems->fail("at most 8 traction systems");
  }
}

sim::Dynamics::Table read_table(const JsonPlace& table, double least, double most) {
  sim::Dynamics::Table read;
  if (table.size() == 0) table.fail("at least one [km/h, value]");
  for (std::size_t i = 0; i < table.size(); ++i) {
    require_row(table[i], 2);
    const double kmh = table[i][0].number(0.0, 1000.0);
    if (!read.empty() && !(kmh > read.back().first)) table[i][0].fail("a speed above the one before");
    read.emplace_back(kmh, table[i][1].number(least, most));
  }
  return read;
}

sim::Dynamics read_dynamics(const JsonPlace& place) {
  place.know_only({"mass_t", "davis", "tractive_effort", "brake"});
  sim::Dynamics d;
  if (const auto p = place.find("mass_t")) d.mass_t = p->number(1.0, 20000.0);
  if (const auto p = place.find("davis")) {
    require_row(*p, 3);
    for (std::size_t i = 0; i < 3; ++i) d.davis[i] = (*p)[i].number(0.0, 1e6);
  }
  if (const auto p = place.find("tractive_effort")) d.tractive_effort = read_table(*p, 0.0, 5000.0);
  if (const auto brake = place.find("brake")) {
    brake->know_only({"emergency", "service", "build_up_s"});
    if (const auto p = brake->find("emergency")) d.emergency_brake = read_table(*p, 0.05, 5.0);
    if (const auto p = brake->find("service")) d.service_brake = read_table(*p, 0.05, 5.0);
    if (const auto p = brake->find("build_up_s")) d.build_up_s = p->number(0.0, 60.0);
  }
  return d;
}

void read_brakes(TrainData& data, const JsonPlace& place) {
  if (const auto p = place.find("brake_model"))
    data.brake_model = static_cast<train::BrakeModel>(p->one_of({"lambda", "gamma"}));
  if (const auto p = place.find("brake_position"))
    data.brake_position = static_cast<train::BrakePosition>(p->one_of({"PassengerP", "FreightP", "FreightG"}));
  // The range that can be entered and sent; below 30 % the conversion model does not apply.
  if (const auto p = place.find("brake_percentage"))
    data.brake_percentage = number_or(*p, 10.0, 250.0, train::Fault::brake_percentage);
  read_models(data, place, 0);
  if (const auto p = place.find("special_brakes"); p && !p->is_null()) read_special_brakes(data, *p);
  if (const auto p = place.find("A_brake_normal_service")) data.normal_service = read_normal_service(*p);
  if (const auto p = place.find("A_brake_normal_service_G")) data.normal_service_G = read_normal_service(*p);
  if (const auto p = place.find("Kn_plus")) data.Kn_plus = read_kn(*p);
  if (const auto p = place.find("Kn_minus")) data.Kn_minus = read_kn(*p);
  if (data.brake_model == train::BrakeModel::lambda) return;
  for (const char* key : {"A_brake_emergency", "A_brake_service", "T_brake_emergency_s", "T_brake_service_s"})
    if (!place.find(key)) place.fail("no key \"" + std::string(key) + "\"", "this key: brake_model is gamma");
}

/// The name of a train in charts if its file gives none.
std::string name_of(const TrainData& data) {
  if (data.brake_model == train::BrakeModel::gamma) return "train with its own decelerations";
  std::string percentage;
  append_number(percentage, data.brake_percentage);
  percentage += " %";
  if (data.brake_position == train::BrakePosition::PassengerP) return "passenger, " + percentage;
  return data.brake_position == train::BrakePosition::FreightP ? "freight in P, " + percentage
                                                               : "freight in G, " + percentage;
}

}  // namespace

Train read_entered_train(const JsonPlace& place) {
  place.know_only(kTrainKeys);
  if (place.find("schema")) place.require_schema("etcs-train/1");
  Train train;
  TrainData& data = train.data;
  read_brakes(data, place);
  const auto named = place.find("name");
  train.name = named ? named->string() : name_of(data);
  if (const auto p = place.find("length_m")) data.L_TRAIN = {number_or(*p, 1.0, 4095.0, train::Fault::train_length)};
  if (const auto p = place.find("max_speed_kmh"))
    data.V_MAXTRAIN = {number_or(*p, 5.0, 600.0, train::Fault::maximum_speed) / kKmh};
  if (const auto p = place.find("L_antenna_front_m"))
    data.L_antenna_front = {number_or(*p, 0.0, data.L_TRAIN.si, train::Fault::antenna)};
  if (const auto p = place.find("M_rotating_nom_pct"); p && !p->is_null())
    data.M_rotating_nom = number_or(*p, 0.0, 100.0, train::Fault::rotating_mass);
  if (const auto p = place.find("T_traction_cut_off_s"))
    data.T_traction_cut_off = {number_or(*p, 0.0, 60.0, train::Fault::traction_cut_off_time)};
  if (const auto p = place.find("traction_cut_off_interface")) data.traction_cut_off_interface = p->boolean();
  if (const auto p = place.find("service_brake_interface")) data.service_brake_interface = p->boolean();
  if (const auto p = place.find("service_brake_feedback")) data.service_brake_feedback = p->boolean();
  if (const auto p = place.find("category")) read_category(data, *p);
  if (const auto p = place.find("dynamics")) train.dynamics = read_dynamics(*p);
  train.document = place.value().dump();
  return train;
}

Train read_train(const JsonPlace& place) {
  Train train = read_entered_train(place);
  refuse(place, train::check(train.data));
  return train;
}

Result<Train> read_train(std::string_view text, const std::string& file) {
  return guarded([&] {
    const Json document = parse_json(text, file);
    const JsonPlace place(document, file);
    place.require_schema("etcs-train/1");
    return read_train(place);
  });
}

}  // namespace evc::io
