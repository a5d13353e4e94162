#include "deceleration/spec.h"

#include <algorithm>
#include <cmath>

namespace evc::deceleration {
namespace {

using io::JsonPlace;

constexpr double kLargestForce_kN = 1000.0;
constexpr double kLargestDeceleration = 10.0;  // m/s2, as in a train file (3.13.2.2.3.1)
constexpr double kLargestFactor = 10.0;
constexpr double kLongestResponse_s = 60.0;
/// Below that a normal variable is with a probability of 9.9e-10.
constexpr double kDeviationsAboveZero = 6.0;
constexpr std::size_t kMostPieces = 1000;
/// Of the probabilities of a table: decimals that are added.
constexpr double kRounding = 1e-9;

constexpr const char* kKinds = "a number, or one of normal, truncated, uniform, discrete, tabulated";

Normal read_normal(const JsonPlace& place, double largest, bool cut) {
  if (place.size() != (cut ? 4U : 2U)) place.fail(cut ? "[mean, deviation, from, to]" : "[mean, deviation]");
  Normal normal;
  normal.mean = place[0].number(0.0, largest);
  normal.deviation = place[1].number(0.0, largest);
  if (!(normal.deviation >= 1e-6)) place[1].fail("a deviation of at least 0.000001");
  normal.is_cut = cut;
  // No friction, pressure or time is negative. Where the last level of confidence does not see such values the curve is
  // taken as it is; otherwise its tail is a matter of the measurement, which the description has to say.
  if (!cut && !(normal.mean >= kDeviationsAboveZero * normal.deviation))
    place.fail("a normal variable that is negative in more than 1 of 1e9 cases",
               "a mean of at least 6 deviations, or {\"truncated\": [mean, deviation, 0, to]}");
  if (!cut) return normal;
  normal.from = place[2].number(0.0, largest);
  normal.to = place[3].number(normal.from, largest);
  if (!(normal.to - normal.from >= 1e-6)) place[3].fail("more than the lower bound");
  // Otherwise it is the tail alone that counts: another distribution.
  if (normal.from > normal.mean + 6.0 * normal.deviation || normal.to < normal.mean - 6.0 * normal.deviation)
    place.fail("bounds within six deviations of the mean");
  return normal;
}

/// [[value, probability], ...]
std::vector<Piece> read_discrete(const JsonPlace& place, double largest) {
  if (place.size() == 0) place.fail("an empty list", "at least one [value, probability]");
  if (place.size() > kMostPieces) place.fail("at most " + std::to_string(kMostPieces) + " values");
  std::vector<Piece> pieces;
  double sum = 0.0;
  for (std::size_t i = 0; i < place.size(); ++i) {
    if (place[i].size() != 2) place[i].fail("[value, probability]");
    const double value = place[i][0].number(0.0, largest);
    const double probability = place[i][1].number(0.0, 1.0);
    if (!(probability > 0.0)) place[i][1].fail("a probability above 0");
    pieces.push_back({value, value, probability});
    sum += probability;
  }
  if (!(std::abs(sum - 1.0) <= kRounding)) place.fail("probabilities of " + std::to_string(sum), "a sum of 1");
  return pieces;
}

/// [[value, probability of at most this value], ...], linear between.
std::vector<Piece> read_tabulated(const JsonPlace& place, double largest) {
  if (place.size() < 2) place.fail("at least two [value, probability of at most this value]");
  if (place.size() > kMostPieces) place.fail("at most " + std::to_string(kMostPieces) + " points");
  std::vector<Piece> pieces;
  double value = 0.0, below = 0.0;
  for (std::size_t i = 0; i < place.size(); ++i) {
    if (place[i].size() != 2) place[i].fail("[value, probability of at most this value]");
    const double next = place[i][0].number(0.0, largest);
    const double until = place[i][1].number(0.0, 1.0);
    if (i == 0 && until != 0.0) place[i][1].fail("0 at the lowest value");
    if (i > 0 && !(next > value)) place[i][0].fail("a value above the one before");
    if (i > 0 && !(until >= below)) place[i][1].fail("no less than before");
    if (i > 0 && until > below) pieces.push_back({value, next, until - below});
    value = next;
    below = until;
  }
  if (below != 1.0) place[place.size() - 1][1].fail("1 at the highest value");
  return pieces;
}

Distribution read_distribution(const JsonPlace& place, double largest) {
  if (place.value().is_number()) return Distribution(place.number(0.0, largest));
  if (!place.is_object()) place.fail(kKinds);
  place.know_only({"normal", "truncated", "uniform", "discrete", "tabulated"});
  if (place.value().size() != 1) place.fail(std::to_string(place.value().size()) + " kinds", kKinds);
  if (const auto p = place.find("normal")) return Distribution(read_normal(*p, largest, false));
  if (const auto p = place.find("truncated")) return Distribution(read_normal(*p, largest, true));
  if (const auto p = place.find("discrete")) return Distribution(read_discrete(*p, largest));
  if (const auto p = place.find("tabulated")) return Distribution(read_tabulated(*p, largest));
  const JsonPlace uniform = place["uniform"];
  if (uniform.size() != 2) uniform.fail("[from, to]");
  const double from = uniform[0].number(0.0, largest);
  return Distribution(std::vector<Piece>{{from, uniform[1].number(from, largest), 1.0}});
}

Distribution read_factor(const JsonPlace& place, const char* key) {
  const auto p = place.find(key);
  if (!p) return Distribution(1.0);
  Distribution read = read_distribution(*p, kLargestFactor);
  if (!(read.mean() > 0.0)) p->fail("a mean above 0");
  return read;
}

std::vector<std::pair<double, double>> read_table(const JsonPlace& table, double largest, const char* row_text) {
  if (table.size() == 0) table.fail("an empty list", std::string("at least one ") + row_text);
  if (table.size() > kMostSpeeds) table.fail("at most " + std::to_string(kMostSpeeds) + " steps");
  std::vector<std::pair<double, double>> read;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const JsonPlace row = table[i];
    if (row.size() != 2) row.fail(row_text);
    const double from = row[0].number(0.0, 600.0);
    if (i == 0 && from != 0.0) row[0].fail("0: the first step begins at 0");
    if (i > 0 && !(from > read.back().first)) row[0].fail("a step further than the one before");
    read.emplace_back(from, row[1].number(0.0, largest));
  }
  return read;
}

/// A unit's force is still in kN where `force` is set: the mass of the train is known when all are read.
struct ReadGroup {
  UnitGroup group;
  bool force = false;
};

ReadGroup read_group(const JsonPlace& place, std::size_t vehicles) {
  place.know_only({"name", "count", "force_kN", "deceleration_mps2", "friction", "pressure", "response_s", "failure"});
  ReadGroup read;
  UnitGroup& group = read.group;
  if (const auto p = place.find("name")) group.name = p->string();
  group.units = vehicles;
  if (const auto p = place.find("count"))
    group.units *= static_cast<std::size_t>(p->integer(1, static_cast<std::int64_t>(kMostUnits)));
  const auto force = place.find("force_kN"), deceleration = place.find("deceleration_mps2");
  if (force.has_value() == deceleration.has_value())
    place.fail(force ? "both" : "no braking force", "one of force_kN, deceleration_mps2");
  read.force = force.has_value();
  group.nominal = force ? read_table(*force, kLargestForce_kN, "[from km/h, kN]")
                        : read_table(*deceleration, kLargestDeceleration, "[from km/h, m/s2]");
  group.friction = read_factor(place, "friction");
  group.pressure = read_factor(place, "pressure");
  if (const auto p = place.find("response_s")) group.response_s = read_distribution(*p, kLongestResponse_s);
  if (const auto p = place.find("failure")) group.failure = p->number(0.0, kLargestFailure);
  return read;
}

void read_vehicles(Spec& spec, const JsonPlace& vehicles) {
  if (!vehicles.is_array()) vehicles.fail("a list of vehicles");
  if (vehicles.size() == 0) vehicles.fail("an empty list", "at least one vehicle");
  std::vector<ReadGroup> read;
  std::size_t all = 0;
  for (std::size_t i = 0; i < vehicles.size(); ++i) {
    const JsonPlace vehicle = vehicles[i];
    vehicle.know_only({"name", "count", "mass_t", "rotating_mass_pct", "brake_units"});
    if (const auto p = vehicle.find("name")) (void)p->string();
    std::size_t count = 1;
    if (const auto p = vehicle.find("count")) count = static_cast<std::size_t>(p->integer(1, 500));
    const double mass_t = vehicle["mass_t"].number(0.1, 1000.0) * static_cast<double>(count);
    const auto rotating = vehicle.find("rotating_mass_pct");
    spec.mass_t += mass_t;
    spec.dynamic_mass_t += mass_t * (1.0 + (rotating ? rotating->number(0.0, 100.0) : 0.0) / 100.0);
    const auto units = vehicle.find("brake_units");  // one without brakes is only a mass
    if (units && !units->is_array()) units->fail("a list of brake units");
    for (std::size_t u = 0; units && u < units->size(); ++u) {
      read.push_back(read_group((*units)[u], count));
      read.back().group.place = "/vehicles/" + std::to_string(i) + "/brake_units/" + std::to_string(u);
      all += read.back().group.units;
      if (all > kMostUnits)
        (*units)[u].fail(std::to_string(all) + " brake units", "at most " + std::to_string(kMostUnits));
      if (read.back().group.response_s.has_value() != read.front().group.response_s.has_value())
        (*units)[u].fail("response_s of some units only", "that of all units, or of none");
    }
  }
  if (all == 0) vehicles.fail("no brake unit", "at least one");
  for (ReadGroup& one : read) {
    if (one.force)
      for (auto& [from, value] : one.group.nominal) value /= spec.dynamic_mass_t;  // kN / t is m/s2
    spec.groups.push_back(std::move(one.group));
  }
}

void find_steps(Spec& spec, const JsonPlace& vehicles) {
  for (const UnitGroup& group : spec.groups)
    for (const auto& [from, value] : group.nominal) spec.speeds_kmh.push_back(from);
  std::sort(spec.speeds_kmh.begin(), spec.speeds_kmh.end());
  spec.speeds_kmh.erase(std::unique(spec.speeds_kmh.begin(), spec.speeds_kmh.end()), spec.speeds_kmh.end());
  if (spec.speeds_kmh.size() > kMostSpeeds)
    vehicles.fail(std::to_string(spec.speeds_kmh.size()) + " steps of speed",
                  "at most " + std::to_string(kMostSpeeds) + " of all units together");
  for (const double from : spec.speeds_kmh) {
    double sum = 0.0;
    for (const UnitGroup& group : spec.groups) sum += static_cast<double>(group.units) * at_speed(group.nominal, from);
    if (!(sum >= 0.001 && sum <= kLargestDeceleration))
      vehicles.fail(std::to_string(sum) + " m/s2 from " + std::to_string(static_cast<int>(from)) + " km/h",
                    "a deceleration of 0.001 to 10 m/s2 at every speed");
  }
}

Spec read(std::string_view text, const std::string& file) {
  Spec spec;
  spec.file = file;
  spec.document = io::parse_json(text, file);
  const JsonPlace root(spec.document, file);
  root.require_schema("evc-brakes/1");
  root.know_only({"schema", "name", "seed", "samples", "response_level", "vehicles", "all_units", "train"});
  if (const auto p = root.find("name")) spec.name = p->string();
  if (const auto p = root.find("seed")) spec.seed = static_cast<std::uint64_t>(p->integer(0, INT64_MAX));
  if (const auto p = root.find("samples")) spec.samples = static_cast<std::size_t>(p->integer(1000, 1000000));
  const JsonPlace vehicles = root["vehicles"];
  read_vehicles(spec, vehicles);
  find_steps(spec, vehicles);
  spec.all_units = read_factor(root, "all_units");
  if (const auto p = root.find("response_level")) {
    if (!spec.has_response()) p->fail("no response_level: no unit has response_s");
    spec.response_level = static_cast<std::size_t>(p->integer(0, 9));
  }
  return spec;
}

}  // namespace

std::size_t Spec::units() const {
  std::size_t units = 0;
  for (const UnitGroup& group : groups) units += group.units;
  return units;
}

double at_speed(const std::vector<std::pair<double, double>>& table, double from_kmh) {
  double value = table.front().second;
  for (const auto& [from, step] : table)
    if (from <= from_kmh) value = step;
  return value;
}

io::Result<Spec> read_spec(std::string_view text, const std::string& file) {
  return io::guarded([&] { return read(text, file); });
}

}  // namespace evc::deceleration
