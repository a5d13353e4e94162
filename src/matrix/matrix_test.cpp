#include "matrix/matrix.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <type_traits>
#include <vector>

#include "base/test_paths.h"
#include "io/line_file.h"
#include "io/make_line.h"
#include "io/program_test.h"
#include "matrix/drive.h"
#include "run/load.h"
#include "sim/random.h"

namespace evc::matrix {
namespace {

using nlohmann::json;

TEST(Quantum, ByTheTargetDistanceTheFinerOneAtTheLimits) {
  EXPECT_EQ(quantum_for(20000_m), 50_m);
  EXPECT_EQ(quantum_for(2000.1_m), 50_m);
  EXPECT_EQ(quantum_for(2000_m), 5_m);
  EXPECT_EQ(quantum_for(200.1_m), 5_m);
  EXPECT_EQ(quantum_for(200_m), 0.5_m);
  EXPECT_EQ(quantum_for(1_m), 0.5_m);
}

double between(sim::Random& random, double least, double most) { return random.between(least, most); }
int whole(sim::Random& random, int least, int most) {
  return static_cast<int>(std::floor(random.between(least, most + 1.0)));
}

/// Steps of random length and value over [-200, end + 200].
json profile(sim::Random& random, double end, int least, int most, int unit) {
  json steps = json::array();
  double from = -200.0;
  while (from < end + 200.0) {
    const double to = from + std::floor(between(random, end / 14.0, end / 5.0)) + 20.0;
    steps.push_back({from, to, unit * whole(random, least, most)});
    from = to;
  }
  return steps;
}

/// One authority in level 1 with restrictions, an axle load profile and slippery track.
std::string random_line(sim::Random& random, double end) {
  json orders = {{{"authority", {{"to_m", end}, {"danger_point_m", end + 60.0}, {"release_kmh", 20}}}}};
  for (int i = 0; i < 3; ++i) {
    const double from = std::floor(between(random, 100.0, end));
    orders.push_back({{"temporary_speed_restriction",
                       {{"NID_TSR", i}, {"from_m", from}, {"to_m", from + 200.0}, {"kmh", 5 * whole(random, 6, 30)}}}});
  }
  const int at = whole(random, 0, static_cast<int>(end));
  orders.push_back({{"packet",
                     {{"NID_PACKET", 71},
                      {"Q_DIR", 1},
                      {"Q_SCALE", 1},
                      {"D_ADHESION", at},
                      {"L_ADHESION", at / 3 + 50},
                      {"M_ADHESION", 0}}}});
  orders.push_back({{"packet",
                     {{"NID_PACKET", 51},
                      {"Q_DIR", 1},
                      {"Q_SCALE", 1},
                      {"Q_TRACKINIT", 0},
                      {"D_AXLELOAD", at},
                      {"L_AXLELOAD", 300},
                      {"Q_FRONT", 0},
                      {"categories", {{{"M_AXLELOADCAT", 0}, {"V_AXLELOAD", whole(random, 6, 20)}}}},
                      {"restrictions", json::array()}}}});
  const json description = {{"schema", "evc-line-description/1"},
                            {"name", "random"},
                            {"NID_C", 1},
                            {"length_m", end + 200.0},
                            {"start", {{"front_m", -40}, {"level", "1"}}},
                            {"gradient", profile(random, end, -12, 12, 1)},
                            {"ssp", profile(random, end, 10, 32, 5)},
                            {"groups", {{{"NID_BG", 1}, {"at_m", 0}, {"balises", 8}, {"orders", orders}}}},
                            {"radio", json::array()}};
  const auto line = io::make_line(description.dump(), "random");
  EXPECT_TRUE(line) << line.error().text();
  if (!line) return {};
  json run = json::parse(*line);
  run["end_m"] = end;  // otherwise it ends behind the last group
  return run.dump();
}

struct Compared {
  std::size_t speeds = 0, decelerations = 0, curves = 0;
  std::size_t ASP = 0, TSR = 0, Adh = 0;  // rows that have one
};

std::size_t step_of(const Matrix& m, Speed v) {
  std::size_t k = 0;
  while (k < m.steps.size() && m.steps[k] && v > *m.steps[k]) ++k;
  return k;
}

/// The emergency brake at a place, without the gradient.
Acceleration brake_alone(const sdm::Decelerations& d, Speed v, Place x) {
  std::size_t i = 0;
  while (i + 1 < d.segments.size() && d.segments[i + 1].from <= x) ++i;
  const sdm::Segment& segment = d.segments[i];
  const sdm::Bands& bands = d.bands(sdm::CurveKind::EBD, segment);
  return bands[sdm::band_below(bands, v * v)].A[segment.reduced_adhesion ? 1 : 0];
}

/// 3.13.7, 3.13.6.2: at places and speeds inside a row.
void compare_row(const Matrix& m, const Row& row, const kernel::Derived::Curves& exact, Compared& compared) {
  const sdm::Decelerations& d = exact.sdm.decelerations;
  for (const double share : {0.0, 0.3, 0.5, 0.9, 0.999}) {
    const Place x = row.from + share * (row.to - row.from);
    ASSERT_LE(row.MRSP, exact.inputs.mrsp.at(x));
    ++compared.speeds;
    for (double v = 0.0; v < 80.0; v += 4.9) {
      ASSERT_LE(row.Asafe[step_of(m, Speed{v})].si, d.at(sdm::CurveKind::EBD, Speed{v}, x).si);
      ASSERT_LE(row.Aeb[step_of(m, Speed{v})].si, brake_alone(d, Speed{v}, x).si);
      ++compared.decelerations;
    }
  }
  ASSERT_LE(row.MRSP, row.SSP.value_or(track::kNoLimit));
  ASSERT_LE(row.MRSP, row.ASP.value_or(track::kNoLimit));
  ASSERT_LE(row.MRSP, row.TSR.value_or(track::kNoLimit));
  compared.ASP += row.ASP ? 1u : 0u;
  compared.TSR += row.TSR ? 1u : 0u;
  compared.Adh += row.Adh ? 1u : 0u;
}

/// v^2 at the upstream end of a stretch, with the lowest deceleration of the speed steps that are passed.
double upstream(const Matrix& m, const Row& row, double w, double length) {
  std::size_t k = step_of(m, Speed{std::sqrt(w)});
  double A = row.Asafe[k].si;
  for (;;) {
    const double next = w + 2.0 * A * length;
    if (next < 0.0 || k + 1 == kSteps || !m.steps[k] || Speed{std::sqrt(next)} <= *m.steps[k]) return next;
    A = std::min(A, row.Asafe[++k].si);
  }
}

/// The emergency brake deceleration curve of a target computed from the rows, from its foot upstream (3.13.8.3).
void compare_curve(const Matrix& m, const sdm::CurveView& exact, Compared& compared) {
  // The foot of a curve to the SvL is beyond the last row.
  Place x = std::min(exact.foot(), m.rows.back().to);
  double w = exact.speed_squared_at(x).si;
  for (std::size_t i = m.rows.size(); i-- > 0;) {
    const Row& row = m.rows[i];
    if (row.from >= x) continue;
    for (const Place to : {row.from + 0.5 * (x - row.from), row.from}) {
      const double next = upstream(m, row, w, (x - to).si);
      if (next < w || next > exact.knots.back().w.si) return;  // no deceleration; the end of the exact curve
      ASSERT_LE(next, exact.speed_squared_at(to).si * (1.0 + 1e-12) + 1e-9);
      ++compared.curves;
      w = next;
      x = to;
    }
  }
}

static_assert(!std::is_constructible_v<DrivenTrain, sim::Line, io::Train>, "its world refers to the line");

void compare(const DrivenTrain& run, Distance quantum, Compared& compared) {
  const Matrix m = matrix_of(run.state, run.derived, quantum);
  ASSERT_LE(m.rows.size(), kMostRows);
  const kernel::Derived::Curves& exact = run.derived.in_force;
  for (const Row& row : m.rows) ASSERT_NO_FATAL_FAILURE(compare_row(m, row, exact, compared));
  for (const sdm::Target& target : exact.sdm.targets) {
    if (target.due_to_TSR || target.warnings.no_deceleration || target.warnings.truncated) continue;
    const sdm::CurveView curve = exact.sdm.view(target.EBD);
    if (curve.exists() && !m.rows.empty()) {
      ASSERT_NO_FATAL_FAILURE(compare_curve(m, curve, compared));
    }
  }
}

/// A coarser quantum never gives a higher limit than the exact profile and curve.
TEST(Matrix, NeverAboveTheExactProfilesAndCurves) {
  std::vector<io::Train> trains;
  for (const auto& entry : std::filesystem::directory_iterator(evc::test::source_folder() + "/data/trains"))
    trains.push_back(*run::load_train(entry.path().string()));
  Compared compared[3];
  int driven = 0;
  sim::Random random(42);
  for (int n = 0; n < 48; ++n) {
    const double end = std::floor(n % 3 == 0 ? between(random, 900.0, 2500.0) : between(random, 2500.0, 24000.0));
    const std::string text = random_line(random, end);
    const auto line = io::read_line(text, "random");
    ASSERT_TRUE(line) << line.error().text();
    const auto run = std::make_unique<DrivenTrain>(*line, trains[static_cast<std::size_t>(n) % trains.size()]);
    if (!run->drive_to(between(random, 150.0, 0.9 * end))) continue;  // it stops where the brakes are too weak
    ++driven;
    int i = 0;
    for (const double quantum : {0.5, 5.0, 50.0}) {
      SCOPED_TRACE("line " + std::to_string(n) + ", quantum " + std::to_string(quantum));
      ASSERT_NO_FATAL_FAILURE(compare(*run, Distance{quantum}, compared[i++]));
    }
  }
  EXPECT_GT(driven, 40);
  for (const Compared& c : compared) {
    EXPECT_GT(c.speeds, 5000u);
    EXPECT_GT(c.decelerations, 100000u);
    EXPECT_GT(c.curves, 2000u);
    EXPECT_GT(c.ASP, 20u);
    EXPECT_GT(c.TSR, 20u);
    EXPECT_GT(c.Adh, 20u);
    RecordProperty("compared", std::to_string(c.speeds) + " speeds, " + std::to_string(c.decelerations) +
                                   " decelerations, " + std::to_string(c.curves) + " places of curves");
  }
}

std::unique_ptr<DrivenTrain> shipped_at(double at_m) {
  static const auto line = run::load_line(evc::test::source_folder() + "/data/lines/brunnental.json");
  auto run = std::make_unique<DrivenTrain>(*line, io::Train{});
  EXPECT_TRUE(run->drive_to(at_m));
  return run;
}

/// Any target distance: the rule of the quantum, at most 400 rows, and they reach the target up to 20 km.
TEST(Matrix, NeverMoreThan400Rows) {
  const auto run = shipped_at(12000.0);
  auto state = std::make_unique<kernel::State>(run->state);
  const Place front = matrix_of(run->state, run->derived).front;
  for (double distance = 0.25; distance < 25000.0; distance *= 1.07) {
    state->basis.authority.EOA = front + Distance{distance};
    const Matrix m = matrix_of(*state, run->derived);
    ASSERT_EQ(m.quantum, quantum_for(*state->basis.authority.EOA - front));
    ASSERT_LE(m.rows.size(), kMostRows);
    ASSERT_EQ(m.cut, distance > 20000.0);
    if (m.cut) continue;
    ASSERT_EQ(m.rows.back().to, *state->basis.authority.EOA);
    ASSERT_EQ(m.rows.back().V_LOA, Speed{});
  }
  state->basis.authority.EOA = front + 20000_m;
  EXPECT_EQ(matrix_of(*state, run->derived).rows.size(), 400u);
  state->basis.authority.EOA = front + 2000_m;
  EXPECT_EQ(matrix_of(*state, run->derived).rows.size(), 400u);
  state->basis.authority.EOA = front + 200_m;
  EXPECT_EQ(matrix_of(*state, run->derived).rows.size(), 400u);
  state->basis.authority.EOA = front;
  EXPECT_TRUE(matrix_of(*state, run->derived).rows.empty()) << "nothing is ahead";
}

/// An LOA has its speed in the last row (3.8.1.1 b).
TEST(Matrix, TheSpeedOfALimitOfAuthority) {
  const auto run = shipped_at(12000.0);
  auto state = std::make_unique<kernel::State>(run->state);
  state->basis.authority = {};
  state->basis.authority.LOA = matrix_of(run->state, run->derived).front + 1001_m;
  state->basis.authority.V_LOA = 60_km_h;
  const Matrix m = matrix_of(*state, run->derived);
  ASSERT_EQ(m.rows.size(), 201u);
  EXPECT_EQ(m.rows.back().V_LOA, 60_km_h);
  EXPECT_FALSE(m.rows[199].V_LOA);
}

TEST(Matrix, BeforeTheMissionNothingIsStored) {
  const auto run = shipped_at(-40.0);
  EXPECT_TRUE(matrix_of(run->state, run->derived).rows.empty());
}

json track(const std::string& arguments) {
  const Ended e = ended("track --format json " + arguments);
  EXPECT_EQ(e.exit_code, 0) << e.errors;
  return json::parse(e.output);
}

/// The description of the shipped line: at 12 km SSP 160 km/h, a restriction of 90 km/h from 13.4 to 14.6 km, the next
/// group at 13 km. The speed rises when the rear end has left the restriction (3.11.5.3).
TEST(TrackCommand, TheShippedLine) {
  const json document = json::parse(text_of(evc::test::source_folder() + "/data/lines/brunnental.description.json"));
  double from = 0.0, to = 0.0;
  for (const json& message : document["radio"])
    for (const json& order : message["orders"])
      if (order.contains("temporary_speed_restriction") && from == 0.0) {
        from = order["temporary_speed_restriction"]["from_m"];
        to = order["temporary_speed_restriction"]["to_m"];
        EXPECT_EQ(order["temporary_speed_restriction"]["kmh"], 90);
      }
  const json t = track("--at 12000");
  EXPECT_EQ(t["schema"], "evc-track/1");
  EXPECT_EQ(t["mode"], "FS");
  EXPECT_EQ(t["level"], "2");
  EXPECT_EQ(t["LRBG"], "1000/111");
  EXPECT_EQ(t["quantum_m"], 50.0);
  EXPECT_EQ(t["rows"][0]["LRBG"], "1000/111");
  EXPECT_EQ(t["rows"].back()["V_LOA"], 0.0);
  const double length = io::Train{}.data.L_TRAIN.si;
  for (const json& row : t["rows"]) {
    const double x = 12000.0 + row["d_m"].get<double>();
    if (x > 17000.0) break;     // before the next restriction
    const double doubt = 60.0;  // the row, and the position of the on-board against the true one
    if (x > from + doubt && x < to - doubt) {
      EXPECT_EQ(row["TSR"], 90.0);
    }
    if (x < from - doubt || x > to + doubt) {
      EXPECT_TRUE(row["TSR"].is_null()) << x;
    }
    if (x > from + doubt && x < to + length - doubt) {
      EXPECT_EQ(row["MRSP"], 90.0) << x;
    }
    if (x < from - doubt) {
      EXPECT_EQ(row["MRSP"], row["SSP"]);
    }
  }
  EXPECT_EQ(track("--at 12000 --quantum 0.5")["rows"].size(), kMostRows);
  EXPECT_EQ(track("--at 12000 --quantum 0.5")["cut"], true);
  EXPECT_EQ(track("--at 12000 --quantum 5")["rows"][1]["d_m"], 5.0);
}

TEST(TrackCommand, TableAndCsvHaveTheSameRows) {
  const Ended csv = ended("track --at 12000 --format csv");
  const Ended table = ended("track --at 12000");
  EXPECT_EQ(csv.exit_code, 0) << csv.errors;
  EXPECT_EQ(table.exit_code, 0) << table.errors;
  const std::string header =
      "d_m,LRBG,SSP,QF,Grd,ASP,V_LOA,TSR,Adh,Aeb0,Aeb1,Aeb2,Aeb3,MRSP,Asafe0,Asafe1,Asafe2,Asafe3\n";
  EXPECT_EQ(csv.output.substr(0, header.size()), header);
  const auto lines = [](const std::string& s) { return std::count(s.begin(), s.end(), '\n'); };
  EXPECT_EQ(lines(csv.output), 1 + static_cast<std::ptrdiff_t>(track("--at 12000")["rows"].size()));
  EXPECT_EQ(lines(table.output), lines(csv.output) + 5);
}

TEST(TrackCommand, WrongInputIsRefused) {
  const auto refused = [](const std::string& arguments, const char* text, int exit_code = 2) {
    const Ended e = ended("track " + arguments);
    EXPECT_EQ(e.exit_code, exit_code) << arguments;
    EXPECT_NE(e.errors.find(text), std::string::npos) << e.errors;
    EXPECT_EQ(std::count(e.errors.begin(), e.errors.end(), '\n'), 1) << e.errors;
    EXPECT_EQ(e.output, "");
  };
  refused("", "--at");
  refused("--at nan", "--at");
  refused("--at 50000", "--at: found 50000, expected a place on the line, -40 to");
  refused("--at 100 --quantum 1", "--quantum");
  refused("--at 100 --format xml", "--format");
  refused("/nonexistent.json --at 100", "/nonexistent.json");
  refused("--at 100 --train /nonexistent.json", "/nonexistent.json");
  // A train that gets no authority beyond the first one stops before the place.
  const Folder folder("track");
  sim::Random random(1);
  ASSERT_TRUE(io::write_whole(folder / "l.json", random_line(random, 1500.0)));
  json line = json::parse(text_of(folder / "l.json"));
  line["end_m"] = 5000.0;
  ASSERT_TRUE(io::write_whole(folder / "l.json", line.dump()));
  refused("'" + folder / "l.json" + "' --at 4000", "expected one to 4000 m", 1);
}

}  // namespace
}  // namespace evc::matrix
