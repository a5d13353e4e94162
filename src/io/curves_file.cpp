#include "io/curves_file.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "io/file.h"

namespace evc::io {
namespace {

constexpr double kFar_m = 1e7;  // longer than any line
constexpr std::size_t kMostQueries = 200000;

void require_between(const JsonPlace& row, std::size_t least, std::size_t most) {
  if (row.size() < least || row.size() > most)
    row.fail("an array of " + std::to_string(least) + " to " + std::to_string(most));
}
double location(const JsonPlace& place) { return place.number(-kFar_m, kFar_m); }

/// The separate document that `place` names, or the place itself.
class Referred {
 public:
  Referred(const JsonPlace& place, const char* what) : place_(place) {
    if (!place.is_string()) return;
    const auto beside = std::filesystem::path(place.file()).parent_path() / place.string();
    if (beside == "-") place.fail(what);
    const auto text = read_text(beside.string());
    if (!text) place.fail(what);
    document_ = parse_json(*text, beside.string());
    place_ = JsonPlace(document_, beside.string());
  }
  Referred(const Referred&) = delete;
  Referred& operator=(const Referred&) = delete;
  const JsonPlace& place() const { return place_; }

 private:
  Json document_;
  JsonPlace place_;
};

/// Fixed values.
constexpr Clause kFixed = "A.3.1"_srs;

void read_fixed_values(train::FixedValues& f, const JsonPlace& place) {
  place.know_only({"dV_ebi_min", "dV_ebi_max", "V_ebi_min",       "V_ebi_max",      "dV_sbi_min",     "dV_sbi_max",
                   "V_sbi_min",  "V_sbi_max",  "dV_warning_min",  "dV_warning_max", "V_warning_min",  "V_warning_max",
                   "T_warning",  "T_driver",   "T_preindication", "T_dispTTI",      "M_rotating_max", "M_rotating_min",
                   "g",          "T41_balise", "T41_eoa"});
  const auto speed = [&](Speed& v, const char* key) {
    if (const auto p = place.find(key)) v = {p->number(0.0, 600.0, kFixed) / kKmh};
  };
  const auto time = [&](Duration& t, const char* key) {
    if (const auto p = place.find(key)) t = {p->number(0.0, 600.0, kFixed)};
  };
  const auto ceiling = [&](Speed& dV_min, Speed& dV_max, Speed& V_min, Speed& V_max, const std::string& limit) {
    const std::string keys[] = {"dV_" + limit + "_min", "dV_" + limit + "_max", "V_" + limit + "_min",
                                "V_" + limit + "_max"};
    speed(dV_min, keys[0].c_str());
    speed(dV_max, keys[1].c_str());
    speed(V_min, keys[2].c_str());
    speed(V_max, keys[3].c_str());
    if (!(dV_min <= dV_max))
      place.fail(keys[0] + " above " + keys[1], "the minimum not above the maximum (SUBSET-026 A.3.1)");
    if (!(V_min < V_max)) place.fail(keys[2] + " not below " + keys[3], "it below (SUBSET-026 A.3.1)");
  };
  ceiling(f.dV_ebi_min, f.dV_ebi_max, f.V_ebi_min, f.V_ebi_max, "ebi");
  ceiling(f.dV_sbi_min, f.dV_sbi_max, f.V_sbi_min, f.V_sbi_max, "sbi");
  ceiling(f.dV_warning_min, f.dV_warning_max, f.V_warning_min, f.V_warning_max, "warning");
  time(f.T_warning, "T_warning");
  time(f.T_driver, "T_driver");
  time(f.T_preindication, "T_preindication");
  time(f.T_dispTTI, "T_dispTTI");
  time(f.T41_balise, "T41_balise");
  time(f.T41_eoa, "T41_eoa");
  if (const auto p = place.find("M_rotating_max")) f.M_rotating_max = p->number(0.0, 100.0, kFixed);
  if (const auto p = place.find("M_rotating_min")) f.M_rotating_min = p->number(0.0, 100.0, kFixed);
  if (const auto p = place.find("g")) f.g = {p->number(9.0, 10.0)};
}

void read_gradient(sdm::GradientProfile& gradient, const JsonPlace& table) {
  for (std::size_t i = 0; i < table.size(); ++i) {
    const JsonPlace row = table[i];
    const bool last = i + 1 == table.size();
    require_between(row, 2, last ? 3 : 2);
    const double from = location(row[0]);
    if (i > 0 && !(from > table[i - 1][0].number())) row[0].fail("a location beyond the one before");
    if (!gradient.permille.append({{from}}, row[1].number(-254.0, 254.0, "7.5.1.37"_srs)))
      table.fail("at most " + std::to_string(sdm::kGradientSteps) + " changes of gradient");
    if (row.size() == 3) {
      const double to = location(row[2]);
      if (!(to > from)) row[2].fail("a location beyond the element's start");
      gradient.known_to = Place{{to}};
    }
  }
}

void read_mrsp(sdm::Mrsp& mrsp, const JsonPlace& table) {
  if (table.size() == 0) table.fail("at least one [from_m, km/h]");
  for (std::size_t i = 0; i < table.size(); ++i) {
    const JsonPlace row = table[i];
    require_between(row, 2, 2);
    const double from = location(row[0]);
    if (i > 0 && !(from > table[i - 1][0].number())) row[0].fail("a location beyond the one before");
    if (!mrsp.append({{from}}, {row[1].number(0.0, 600.0, "7.5.1.171"_srs) / kKmh}))
      table.fail("at most " + std::to_string(sdm::kMrspSteps - 1) + " changes of speed");
  }
}

/// The earliest start applies up to the foot of every curve (3.13.5.1).
void from_earliest(std::optional<Place>& start, Place from) {
  if (!start || from < *start) start = from;
}

void read_inhibitions(sdm::TrackConditions& c, const JsonPlace& table) {
  for (std::size_t i = 0; i < table.size(); ++i) {
    const JsonPlace row = table[i];
    require_between(row, 2, 6);
    const Place from{{location(row[0])}};
    if (!(location(row[1]) > from.from_origin.si)) row[1].fail("a location beyond the zone's start");
    bool off[4] = {row.size() == 2, row.size() == 2, row.size() == 2, row.size() == 2};
    for (std::size_t k = 2; k < row.size(); ++k)
      off[row[k].one_of({"regenerative", "eddy current emergency", "eddy current service", "magnetic shoe"})] = true;
    if (off[0]) from_earliest(c.regenerative_off, from);
    if (off[1]) from_earliest(c.eddy_current_emergency_off, from);
    if (off[2]) from_earliest(c.eddy_current_service_off, from);
    if (off[3]) from_earliest(c.magnetic_shoe_off, from);
  }
}

void read_track(sdm::Inputs& in, const JsonPlace& track) {
  track.know_only({"gradient", "default_gradient", "mrsp", "adhesion", "brake_inhibition", "powerless"});
  if (const auto p = track.find("gradient")) read_gradient(in.gradient, *p);
  if (const auto p = track.find("default_gradient"); p && !p->is_null())
    in.gradient.default_for_TSR = p->number(-254.0, 254.0, "7.5.1.38"_srs);
  if (const auto p = track.find("mrsp")) read_mrsp(in.mrsp, *p);
  if (const auto p = track.find("adhesion"))
    for (std::size_t i = 0; i < p->size(); ++i) {
      require_between((*p)[i], 2, 2);
      const double from = location((*p)[i][0]);
      const double to = location((*p)[i][1]);
      if (!(to > from)) (*p)[i][1].fail("a location beyond the zone's start");
      if (!in.conditions.reduced_adhesion.push_back({{{from}}, {{to}}}))
        p->fail("at most " + std::to_string(sdm::kZones) + " zones");
    }
  if (const auto p = track.find("brake_inhibition")) read_inhibitions(in.conditions, *p);
  if (const auto p = track.find("powerless"))
    for (std::size_t i = 0; i < p->size(); ++i) {
      require_between((*p)[i], 2, 2);
      from_earliest(in.conditions.powerless, {{location((*p)[i][0])}});
    }
}

void read_release_speed(sdm::Authority& a, const JsonPlace& place) {
  if (place.is_null()) return;
  if (place.is_string()) {
    a.release_speed =
        place.one_of({"national", "on_board"}) == 0 ? ReleaseSpeedChoice::national : ReleaseSpeedChoice::on_board;
    return;
  }
  a.release_speed = ReleaseSpeedChoice::value;
  a.V_release = {place.number(0.0, 600.0, "7.5.1.168"_srs) / kKmh};
}

/// The restriction used as target becomes a step of the MRSP, unless it is one already.
void set_restriction(sdm::Inputs& in, Place from, Speed V, bool due_to_TSR, const JsonPlace& target) {
  sdm::Mrsp merged;
  bool done = false;
  Speed before{};
  bool known = true;
  const auto insert = [&] {
    if (merged.empty() || !(V < before)) target["speed_kmh"].fail("a speed below the MRSP before the target");
    known = merged.append(from, V) && known;
    done = true;
  };
  for (const auto& step : in.mrsp.steps) {
    if (!done && from <= step.from) {
      insert();
      if (from == step.from) continue;
    }
    known = merged.append(step.from, step.value) && known;
    before = step.value;
  }
  if (!done) insert();
  if (!known) target.fail("room for another change of speed in the MRSP");
  in.mrsp = merged;
  for (std::size_t i = 0; i < in.mrsp.size(); ++i)
    if (in.mrsp.steps[i].from == from) in.mrsp_due_to_TSR[i] = due_to_TSR;
}

void read_target(CurvesInput& out, const JsonPlace& target) {
  target.know_only({"type", "location_m", "svl_location_m", "speed_kmh", "release_speed_kmh", "level", "reference_m",
                    "Q_LOCACC_m", "due_to_TSR"});
  sdm::Inputs& in = out.inputs;
  sdm::Authority& a = in.authority;
  const std::size_t type = target["type"].one_of({"EOA_SvL", "LOA", "MRSP", "SR"});
  out.target_location = {{location(target["location_m"])}};
  const auto speed = target.find("speed_kmh");
  const Speed V_target{speed && !speed->is_null() ? speed->number(0.0, 600.0, "7.5.1.171"_srs) / kKmh : 0.0};
  const auto TSR = target.find("due_to_TSR");
  if (type == 2) {
    out.target = sdm::TargetKind::MRSP;
    (void)target["speed_kmh"];
    set_restriction(in, out.target_location, V_target, TSR && TSR->boolean(), target);
    return;
  }
  if (type == 3) {
    out.target = sdm::TargetKind::SR_end;
    in.SR_end = out.target_location;
    if (V_target.si > 0.0) speed->fail("0: the distance to run in SR ends with a stop (3.13.8.2.1 d)");
    return;
  }
  a.EOA = a.SvL = out.target_location;
  if (type == 1) {
    out.target = sdm::TargetKind::LOA;
    a.kind = sdm::Authority::Kind::LOA;
    a.V_LOA = V_target;
    return;
  }
  a.kind = sdm::Authority::Kind::EOA_SvL;
  if (V_target.si > 0.0) speed->fail("0: a limit of authority has a speed, an end of authority has none (3.8.1.1)");
  if (const auto p = target.find("svl_location_m"); p && !p->is_null()) {
    a.SvL = {{location(*p)}};
    if (a.SvL < a.EOA) p->fail("a location not before the EOA");
  }
  if (const auto p = target.find("release_speed_kmh")) read_release_speed(a, *p);
  if (const auto p = target.find("level")) a.level_1_at_EOA = p->integer(1, 3) == 1;
  if (const auto p = target.find("reference_m")) a.reference = {{location(*p)}};
  a.Q_LOCACC_reference = in.national_values.Q_NVLOCACC;
  if (const auto p = target.find("Q_LOCACC_m")) a.Q_LOCACC_reference = {p->number(0.0, 63.0, "7.5.1.115"_srs)};
}

/// The state of the service brake feedback: "locked", or its pressures.
sdm::BrakePressure read_feedback(const JsonPlace& place) {
  sdm::BrakePressure b;
  if (place.is_string()) {
    if (place.string() != "locked") place.fail("\"locked\", or the pressures p0_kpa and p_kpa");
    b.locked = true;
    return b;
  }
  place.know_only({"p0_kpa", "p_kpa", "started"});
  if (const auto p = place.find("p0_kpa")) b.p0 = p->number(400.0, 550.0, "A.3.10.2"_srs);
  b.p = place["p_kpa"].number(0.0, 1000.0);
  if (const auto p = place.find("started")) b.started = p->boolean();
  return b;
}

void read_state(CurvesInput& out, const JsonPlace& state) {
  state.know_only({"A_est", "V_ura_kmh", "est_front_m", "max_safe_front_m", "min_safe_front_m", "slippery_rail",
                   "special_brakes_active", "service_brake_feedback"});
  if (const auto p = state.find("service_brake_feedback"); p && !p->is_null())
    out.assumed.brake_pressure = read_feedback(*p);
  if (const auto p = state.find("A_est")) out.A_est = {p->number(-10.0, 10.0)};
  if (const auto p = state.find("V_ura_kmh")) {
    if (p->is_string())
      out.assumed.V_ura_of_041 = p->one_of({"f41"}) == 0;
    else
      out.V_ura = {p->number(0.0, 100.0) / kKmh};
  }
  if (const auto p = state.find("slippery_rail")) out.inputs.conditions.slippery_rail = p->boolean();
  if (const auto p = state.find("special_brakes_active")) {
    p->know_only({"regenerative", "eddy current", "magnetic shoe", "ep", "adhesion independent"});
    train::BrakeStatus& b = out.inputs.brakes;
    const auto flag = [&](bool& active, const char* key) {
      if (const auto v = p->find(key)) active = v->boolean();
    };
    flag(b.regenerative, "regenerative");
    flag(b.eddy_current, "eddy current");
    flag(b.magnetic_shoe, "magnetic shoe");
    flag(b.electro_pneumatic, "ep");
    flag(b.adhesion_independent, "adhesion independent");
  }
  const auto est = state.find("est_front_m");
  for (const char* key : {"max_safe_front_m", "min_safe_front_m"})
    if (!est && state.find(key)) state[key].fail("est_front_m as well");
  if (!est) return;
  sdm::Motion m;
  m.est_front = m.max_safe_front = m.min_safe_front = Place{{location(*est)}};
  if (const auto p = state.find("max_safe_front_m")) {
    m.max_safe_front = {{location(*p)}};
    if (m.max_safe_front < m.est_front) p->fail("a place not in rear of est_front_m");
  }
  if (const auto p = state.find("min_safe_front_m")) {
    m.min_safe_front = {{location(*p)}};
    if (m.min_safe_front > m.est_front) p->fail("a place not ahead of est_front_m");
  }
  m.A_est = out.A_est;
  m.V_ura = out.V_ura;
  out.motion = m;
}

/// A list, or a range with both ends.
std::vector<double> read_list(const JsonPlace& place, double least, double most) {
  std::vector<double> list;
  if (place.is_array()) {
    if (place.size() > kMostQueries) place.fail("at most " + std::to_string(kMostQueries) + " values");
    for (std::size_t i = 0; i < place.size(); ++i) list.push_back(place[i].number(least, most));
    return list;
  }
  place.know_only({"from", "to", "step"});
  const double from = place["from"].number(least, most);
  const double to = place["to"].number(from, most);
  const double step = place["step"].number(1e-6, most - least);
  const double count = (to - from) / step + 1e-9;
  if (count >= static_cast<double>(kMostQueries))
    place["step"].fail("at most " + std::to_string(kMostQueries) + " values");
  for (std::size_t i = 0; i <= static_cast<std::size_t>(count); ++i)
    list.push_back(std::min(from + static_cast<double>(i) * step, to));
  return list;
}

PbdQuery read_PBD(const JsonPlace& place) {
  place.know_only({"D_PBD", "G_PBDSR", "Q_PBDSR"});
  PbdQuery q;
  q.D_PBD = {place["D_PBD"].number(0.0, kFar_m)};
  if (const auto p = place.find("G_PBDSR")) q.G_PBDSR = p->number(-254.0, 254.0, "7.5.1.37.1"_srs);
  if (const auto p = place.find("Q_PBDSR")) {
    const double brake = p->number(0.0, 1.0);
    if (brake != 0.0 && brake != 1.0) p->fail("0 (emergency brake) or 1 (service brake)");
    q.service_brake = brake == 1.0;
  }
  return q;
}
LxQuery read_LX(const JsonPlace& place) {
  place.know_only({"D_LX", "V_LX"});
  return {Place{{location(place["D_LX"])}}, Speed{place["V_LX"].number(0.0, 600.0, "7.5.1.157.1"_srs) / kKmh}};
}
template <class Query>
void read_all(std::vector<Query>& out, const JsonPlace& list, Query (*read)(const JsonPlace&)) {
  if (!list.is_array()) list.fail("a list");
  if (list.size() > kMostQueries) list.fail("at most " + std::to_string(kMostQueries) + " values");
  for (std::size_t i = 0; i < list.size(); ++i) out.push_back(read(list[i]));
}

void read_details(CurvesInput& out, const JsonPlace& list) {
  if (!list.is_array()) list.fail("a list");
  CurvesDetails& d = out.details;
  bool* const flags[] = {&d.ceilings, &d.times, &d.locations, &d.arcs, &d.targets, &d.confidence_interval};
  for (std::size_t i = 0; i < list.size(); ++i)
    *flags[list[i].one_of({"ceilings", "times", "locations", "arcs", "targets", "confidence_interval"})] = true;
  if (d.confidence_interval && !out.motion) list.fail("confidence_interval", "state.est_front_m as well");
}

void read_query(CurvesInput& out, const JsonPlace& query) {
  query.know_only({"speeds_kmh", "positions_m", "PBD", "LX", "details"});
  if (const auto p = query.find("details")) read_details(out, *p);
  if (const auto p = query.find("PBD")) read_all(out.PBD, *p, read_PBD);
  if (const auto p = query.find("LX")) read_all(out.LX, *p, read_LX);
  if (const auto p = query.find("speeds_kmh")) out.speeds_kmh = read_list(*p, 0.0, 600.0);
  if (const auto p = query.find("positions_m")) out.positions_m = read_list(*p, -kFar_m, kFar_m);
}

void read_workbook(WorkbookInputs& w, const JsonPlace& place) {
  place.know_only({"quantum_m", "length_m", "DT_s", "DX_m", "DV_ms", "dV_ms", "A_safe"});
  if (const auto p = place.find("quantum_m")) w.quantum = {p->number(0.1, 1000.0)};
  if (const auto p = place.find("length_m")) w.length = {p->number(w.quantum.si, 10000.0 * w.quantum.si)};
  if (const auto p = place.find("DT_s")) w.DT = {p->number(0.0, 100.0)};
  if (const auto p = place.find("DX_m")) w.DX = {p->number(0.0, 1000.0)};
  if (const auto p = place.find("DV_ms")) w.DV = {p->number(0.0, 50.0)};
  if (const auto p = place.find("dV_ms")) w.dV = {p->number(0.0, 50.0)};
  if (const auto p = place.find("A_safe")) w.A_safe = {p->number(0.01, 10.0)};
}

Speed fastest(const CurvesInput& c) {
  Speed V = c.inputs.train.V_MAXTRAIN;
  for (const auto& step : c.inputs.mrsp.steps) V = std::max(V, step.value);
  for (const double kmh : c.speeds_kmh) V = std::max(V, Speed{kmh / kKmh});
  return V;
}

CurvesInput read(const JsonPlace& root) {
  root.require_schema("evc-curves/1");
  root.know_only({"schema", "name", "srs", "train", "national_values", "fixed_values", "track", "target", "state",
                  "query", "workbook"});
  CurvesInput out;
  sdm::Inputs& in = out.inputs;
  in.revision = 1;
  out.name = std::filesystem::path(root.file()).stem().string();
  if (const auto p = root.find("name")) out.name = p->string();
  if (const auto p = root.find("srs")) in.srs = read_srs_version(*p);
  const Referred train(root["train"], "a train, or the name of a train file");
  const Train read = read_train(train.place());
  in.train = read.data;
  out.train_name = read.name;
  if (const auto p = root.find("national_values")) {
    const Referred values(*p, "national values, or the name of a file with them");
    in.national_values = read_national_values(values.place());
  }
  if (const auto p = root.find("fixed_values")) read_fixed_values(in.fixed, *p);
  if (const auto p = root.find("track")) read_track(in, *p);
  // Without a speed profile the maximum train speed is the only restriction.
  if (in.mrsp.empty() && !in.mrsp.append({{-kFar_m}}, in.train.V_MAXTRAIN)) __builtin_trap();
  read_target(out, root["target"]);
  if (const auto p = root.find("state")) read_state(out, *p);
  if (const auto p = root.find("query")) read_query(out, *p);
  if (const auto p = root.find("workbook")) {
    out.workbook = WorkbookInputs{};
    read_workbook(*out.workbook, *p);
    out.workbook->mrsp = {};
    for (const auto& step : in.mrsp.steps)
      if (!out.workbook->mrsp.append(step.from.from_origin, step.value)) __builtin_trap();
  }
  if (out.motion) in.authority.confidence_interval = out.motion->max_safe_front - out.motion->min_safe_front;
  in.authority.V_ura = out.V_ura;
  // Curves reach the highest V_bec of any speed asked for (3.13.9.3.2.10).
  const Acceleration A_est = std::max(out.A_est, Acceleration{0.0});
  const Speed V_ura = out.assumed.V_ura_of_041 ? train::f41(fastest(out)) : out.V_ura;
  in.V_top = fastest(out) + V_ura + A_est * Duration{120.0} + Speed{100.0 / kKmh};
  if (out.speeds_kmh.empty() && out.positions_m.empty()) {
    double top = 0.0;
    for (const auto& step : in.mrsp.steps) top = std::max(top, step.value.si * kKmh);
    for (double kmh = 0.0; kmh < top - 1e-6; kmh += 10.0) out.speeds_kmh.push_back(kmh);
    // Where the curves begin, without the rounding noise of km/h, and where they end.
    out.speeds_kmh.push_back(std::nearbyint(top * 1e9) / 1e9);
    const auto end = root["target"].find("speed_kmh");
    if (const double V_target = end && !end->is_null() ? end->number() : 0.0; V_target < top) {
      const auto at = std::lower_bound(out.speeds_kmh.begin(), out.speeds_kmh.end(), V_target);
      if (at == out.speeds_kmh.end() || *at != V_target) out.speeds_kmh.insert(at, V_target);
    }
  }
  return out;
}

}  // namespace

const sdm::Target* target_of(const CurvesInput& input, const sdm::Derived& derived) {
  for (const sdm::Target& t : derived.targets) {
    const Place at = t.kind == sdm::TargetKind::EOA_SvL ? t.d_EOA : t.d_target;
    if (t.kind == input.target && at == input.target_location) return &t;
  }
  return derived.targets.empty() ? nullptr : &derived.targets.back();
}

Result<CurvesInput> read_curves(std::string_view text, const std::string& file) {
  return guarded([&] {
    const Json document = parse_json(text, file);
    return read(JsonPlace(document, file));
  });
}

Result<CurvesInput> curves_of(const Json& document, const std::string& file) {
  return guarded([&] { return read(JsonPlace(document, file)); });
}

Result<Json> curves_document(std::string_view text, const std::string& file) {
  return guarded([&] {
    Json document = parse_json(text, file);
    const JsonPlace root(document, file);
    root.require_schema("evc-curves/1");
    for (const char* key : {"train", "national_values"}) {
      const auto named = root.find(key);
      if (!named || !named->is_string()) continue;
      Json in_place = Referred(*named, "the name of a file").place().value();
      document[key] = std::move(in_place);
    }
    return document;
  });
}

}  // namespace evc::io
