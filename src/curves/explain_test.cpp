#include "curves/explain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <regex>
#include <sstream>

#include "curves/curves_test.h"

namespace evc::curves {
namespace {

using nlohmann::json;

const std::string kCurves = kSource + "/data/curves/";

/// A calculator: + - * / ^ min max and parentheses.
class Calculator {
 public:
  explicit Calculator(const std::string& text) : text_(text) {}
  double value() {
    const double v = sum();
    if (peek() != '\0') wrong();
    return v;
  }

 private:
  char peek() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  bool take(char c) {
    if (peek() != c) return false;
    ++at_;
    return true;
  }
  void wrong() {
    ADD_FAILURE() << "cannot be computed: " << text_ << " at " << at_;
    at_ = text_.size();
  }
  double sum() {
    double v = product();
    for (;;) {
      if (take('+'))
        v += product();
      else if (take('-'))
        v -= product();
      else
        return v;
    }
  }
  double product() {
    double v = power();
    for (;;) {
      if (take('*'))
        v *= power();
      else if (take('/'))
        v /= power();
      else
        return v;
    }
  }
  double power() {
    const double v = atom();
    return take('^') ? std::pow(v, power()) : v;
  }
  double atom() {
    if (take('-')) return -power();
    if (take('(')) return closed(sum());
    for (const bool greatest : {false, true}) {
      const std::string name = greatest ? "max(" : "min(";
      if (peek() == '\0' || text_.compare(at_, name.size(), name) != 0) continue;
      at_ += name.size();
      double v = sum();
      while (take(',')) {
        const double other = sum();
        v = greatest ? std::max(v, other) : std::min(v, other);
      }
      return closed(v);
    }
    const char* begin = text_.c_str() + at_;
    char* end = nullptr;
    const double v = std::strtod(begin, &end);
    if (end == begin) wrong();
    at_ += static_cast<std::size_t>(end - begin);
    return v;
  }
  double closed(double v) {
    if (!take(')')) wrong();
    return v;
  }

  std::string text_;
  std::size_t at_ = 0;
};

/// A formula with its values and the printed result.
struct Computed {
  std::string numbers, unit;
  double value;
};
std::vector<Computed> computed(const std::string& page) {
  std::vector<Computed> all;
  static const std::regex kEnd(R"(^(.*?) *= +(-?[0-9.]+) (\S*) *\[[A0-9.]+\]$)");
  std::istringstream lines(page);
  std::string open;  // a formula continued on the next line
  for (std::string line; std::getline(lines, line);) {
    const bool begins = line.compare(0, 23, std::string(21, ' ') + "= ") == 0;
    if (!begins && (open.empty() || line.compare(0, 21, std::string(21, ' ')) != 0)) {
      open.clear();
      continue;
    }
    const std::string part = (begins ? line.substr(23) : line.substr(21)) + "\n";
    std::smatch end;
    const std::string text = part.substr(0, part.size() - 1);
    if (std::regex_match(text, end, kEnd)) {
      all.push_back({open + end[1].str(), end[3].str(), std::stod(end[2].str())});
      open.clear();
    } else {
      open += text + " ";
    }
  }
  return all;
}

/// The value at the end of the `nth` step with this symbol.
double value_of(const std::string& page, const std::string& symbol, int nth = 0) {
  std::size_t at = 0;
  for (int i = 0; i <= nth; ++i) {
    at = page.find("\n   " + symbol + " ", at + 1);
    if (at == std::string::npos) return std::nan("");
  }
  const std::size_t clause = page.find(" [", at);
  const std::size_t equals = page.rfind("= ", clause);
  return std::stod(page.substr(equals + 2));
}

/// Every computed step can be checked with the printed numbers, within the precision of their decimals.
void check_by_calculator(const std::string& page) {
  const auto steps = computed(page);
  EXPECT_GE(steps.size(), 19u);
  for (const Computed& c : steps) {
    const double tolerance = c.unit == "m/s2" ? 2.1e-5 : c.unit == "m" ? 0.02 : c.unit == "s" ? 1e-3 : 2.1e-4;
    EXPECT_NEAR(Calculator(c.numbers).value(), c.value, tolerance) << c.numbers << " [" << c.unit << "]";
  }
}
/// Every arc: its components add up to its deceleration, and it ends at the place and speed where the next one begins.
void check_arcs(const std::string& page) {
  static const std::regex kRow(
      R"(^ +([0-9.-]+) +([0-9.]+) +([0-9.]+)(\*?) +(-?[0-9.]+) +([+-] [0-9.]+)( +[+-] [0-9.]+)? +(-?[0-9.]+)$)");
  const auto number = [](std::string text) {
    text.erase(std::remove(text.begin(), text.end(), ' '), text.end());
    return text.empty() ? 0.0 : std::stod(text);
  };
  std::istringstream lines(page);
  std::optional<std::array<double, 3>> before;  // x, v, A
  int rows = 0;
  for (std::string line; std::getline(lines, line);) {
    std::smatch m;
    if (!std::regex_match(line, m, kRow)) {
      before.reset();
      continue;
    }
    const double x = number(m[1]), v = number(m[2]), A = number(m[8]);
    EXPECT_NEAR(number(m[3]) + number(m[6]) + number(m[7]), A, 1.6e-5) << line;
    if (before) {
      const double v0 = (*before)[1] / 3.6, v1 = v / 3.6;
      EXPECT_NEAR((*before)[0] - (v1 * v1 - v0 * v0) / (2.0 * (*before)[2]), x, 0.12) << line;
    }
    before = {x, v, A};
    ++rows;
  }
  EXPECT_GE(rows, 1);
}

TEST(CurvesExplain, EveryStepOfEveryShippedInputCanBeComputedFromItsNumbers) {
  for (const std::string& file : shipped())
    for (const char* srs : {"3.4.0", "3.6.0", "4.0.0"}) {
      json document = load_json(file);
      document["srs"] = srs;
      const Approached a = approached(document);
      for (const double v : {10.0, 45.0, 70.0, 100.0, 155.0}) {
        SCOPED_TRACE(file + " " + srs + " at " + std::to_string(v));
        const std::string page = explain_text(a, v);
        check_by_calculator(page);
        check_arcs(page);
      }
    }
}

/// The conversion model by hand: 75 % in G, 650 m, at 90 km/h, towards a stop and towards 40 km/h.
TEST(CurvesExplain, TheConversionModelByHand) {
  json document = load_json(kCurves + "freight_downhill.json");
  document["train"] = {{"brake_model", "lambda"},
                       {"brake_position", "FreightG"},
                       {"brake_percentage", 75},
                       {"length_m", 650},
                       {"max_speed_kmh", 100}};
  const std::string page = explain_text(approached(document), 90);
  EXPECT_NEAR(value_of(page, "V_lim"), 106.9365, 1e-4);  // 16.85 * 75^0.428
  EXPECT_NEAR(value_of(page, "AD_0"), 0.6385, 1e-9);     // 0.0075 * 75 + 0.076
  EXPECT_NEAR(value_of(page, "AD_2"), 0.60513, 1e-5);    // 0.11517 - 0.02554 + 0.3855 + 0.13
  EXPECT_TRUE(std::isnan(value_of(page, "AD_1"))) << "ignored: V_lim >= 100";
  EXPECT_NEAR(value_of(page, "A_brake_emergency"), 0.6385, 1e-9);
  EXPECT_NEAR(value_of(page, "Kv_int(V)"), 0.72, 1e-9);            // conventional_line.json, above 80 km/h
  EXPECT_NEAR(value_of(page, "Kr_int(L_TRAIN)"), 0.94, 1e-9);      // 500 < 650 <= 700
  EXPECT_NEAR(value_of(page, "A_brake_safe"), 0.43214, 1e-5);      // 0.72 * 0.94 * 0.6385
  EXPECT_NEAR(value_of(page, "T_brake_basic_eb"), 14.1125, 1e-4);  // 12 + 0.05 * 6.5^2
  EXPECT_NEAR(value_of(page, "T_brake_emergency"), 14.1125, 1e-4);
  EXPECT_NEAR(value_of(page, "T_be"), 14.8181, 1e-4);             // * 1.05
  EXPECT_NEAR(value_of(page, "T_brake_basic_sb"), 21.005, 1e-4);  // 3 + 2.77 * 6.5
  EXPECT_NEAR(value_of(page, "T_bs"), 21.005, 1e-4);
  EXPECT_TRUE(std::isnan(value_of(page, "kto")));
  document["target"] = {{"type", "LOA"}, {"location_m", 8000}, {"speed_kmh", 40}};
  const std::string LOA = explain_text(approached(document), 90);
  EXPECT_NEAR(value_of(LOA, "kto"), 1.16, 1e-9);
  EXPECT_NEAR(value_of(LOA, "T_brake_emergency"), 16.3705, 1e-4);  // 1.16 * 14.1125
  EXPECT_NEAR(value_of(LOA, "T_bs"), 24.3658, 1e-4);               // 1.16 * 21.005
  EXPECT_NEAR(value_of(LOA, "dV_ebi(V_target)"), 7.5, 1e-9);
  EXPECT_NEAR(value_of(LOA, "V_EBD(d_target)"), 47.5, 1e-9);
}

/// Kv_int between its two subsets (3.13.6.2.1.8.1): 120 % in P.
TEST(CurvesExplain, KvIntIsInterpolated) {
  json document = load_json(kCurves + "passenger_eoa.json");
  document["train"]["brake_percentage"] = 120;
  document["national_values"] = {
      {"A_NVP12", 0.9}, {"A_NVP23", 1.2}, {"Kv_int_passenger", {{0, 0.72, 0.78}, {100, 0.7, 0.76}}}};
  const std::string page = explain_text(approached(document), 120);
  EXPECT_NEAR(value_of(page, "A_ebmax"), 0.976, 1e-9);  // AD_0 = 0.0075 * 120 + 0.076
  EXPECT_NEAR(value_of(page, "Kv_int_a"), 0.70, 1e-9);
  EXPECT_NEAR(value_of(page, "Kv_int_b"), 0.76, 1e-9);
  EXPECT_NEAR(value_of(page, "Kv_int(V)"), 0.7152, 1e-9);      // 0.7 + 0.076 / 0.3 * 0.06
  EXPECT_NEAR(value_of(page, "A_brake_safe"), 0.62823, 1e-5);  // 0.7152 * 0.9 * 0.976
  document["national_values"]["A_NVP12"] = 1.0;
  EXPECT_NE(explain_text(approached(document), 120).find("Kv_int_a: A_ebmax <= A_NVP12 = 1 m/s2"), std::string::npos);
}

/// A gamma train at 300 km/h: 0.82 m/s2, Kdry 0.80, Kwet 0.88, M_NVAVADH 0.7; 4 per mille down, rotating mass 4 %.
TEST(CurvesExplain, AGammaTrainByHand) {
  const std::string page = explain_text(approached(kCurves + "high_speed_stop.json"), 300);
  EXPECT_NEAR(value_of(page, "A_brake_emergency"), 0.82, 1e-9);
  EXPECT_NEAR(value_of(page, "Kdry_rst"), 0.80, 1e-9);
  EXPECT_NEAR(value_of(page, "Kwet_rst"), 0.88, 1e-9);
  EXPECT_NEAR(value_of(page, "M_NVAVADH"), 0.7, 1e-9);
  EXPECT_NEAR(value_of(page, "A_brake_safe"), 0.63238, 1e-5);  // 0.8 * (0.88 + 0.7 * 0.12) * 0.82
  EXPECT_NEAR(value_of(page, "grad"), -4.0, 1e-9);
  EXPECT_NEAR(value_of(page, "M_rotating"), 4.0, 1e-9);
  EXPECT_NEAR(value_of(page, "A_gradient"), -0.03773, 1e-5);  // 9.81 * -4 / 1040
  EXPECT_NEAR(value_of(page, "A_safe"), 0.59465, 1e-5);
  EXPECT_NEAR(value_of(page, "A_brake_service"), 0.52, 1e-9);
  EXPECT_NE(page.find("special brakes that count for the service brake: regenerative"), std::string::npos);
  EXPECT_NE(page.find("GUI from its foot"), std::string::npos);
}

/// The lowest gradient under 400 m of train, with unknown rotating mass (3.13.4).
TEST(CurvesExplain, GradientsUnderTheTrain) {
  json document = load_json(kCurves + "passenger_eoa.json");
  document["track"]["gradient"] = {{0, -3}, {6300, 8}, {6600, 2}};
  const std::string page = explain_text(approached(document), 100);
  // The EBD has 100 km/h near 6500 m: the train is on 8 and, at its rear, still on -3 per mille.
  EXPECT_NE(page.find("= min(-3, 8)"), std::string::npos) << page;
  EXPECT_NEAR(value_of(page, "grad"), -3.0, 1e-9);
  EXPECT_NEAR(value_of(page, "M_rotating"), 2.0, 1e-9);
  EXPECT_NEAR(value_of(page, "A_gradient"), -0.02885, 1e-5);  // 9.81 * -3 / 1020
  document["track"]["gradient"] = {{0, 6}};
  const std::string uphill = explain_text(approached(document), 100);
  EXPECT_NEAR(value_of(uphill, "M_rotating"), 15.0, 1e-9);
  EXPECT_NEAR(value_of(uphill, "A_gradient"), 0.05118, 1e-5);  // 9.81 * 6 / 1150
}

TEST(CurvesExplain, ReducedAdhesionAndTheDefaultGradient) {
  const std::string page = explain_text(approached(kCurves + "regional_restriction.json"), 100);
  EXPECT_NEAR(value_of(page, "A_MAXREDADH"), 0.7, 1e-9);
  EXPECT_NE(page.find("min(A_brake_safe, A_MAXREDADH) + A_gradient"), std::string::npos);
  EXPECT_NE(page.find("* A_MAXREDADH: adhesion is reduced there"), std::string::npos);
  json document = load_json(kCurves + "regional_restriction.json");
  document["track"]["gradient"] = {{0, 0, 2000}};
  const std::string unknown = explain_text(approached(document), 100);
  EXPECT_NE(unknown.find("default gradient for TSR"), std::string::npos);
  EXPECT_NEAR(value_of(unknown, "grad"), -5.0, 1e-9);
}

/// The front on the profile, the rear in rear of it: the default counts there (3.13.4.1.3), and the page says so.
TEST(CurvesExplain, TheDefaultGradientUnderTheRear) {
  json document = load_json(kCurves + "regional_restriction.json");
  document["target"] = {{"type", "MRSP"}, {"location_m", 5000}, {"speed_kmh", 60}, {"due_to_TSR", true}};
  document["track"] = {{"gradient", {{4800, 3, 5200}}}, {"default_gradient", -10}, {"mrsp", {{0, 120}}}};
  document["train"] = {{"length_m", 400}};
  document["query"] = {{"speeds_kmh", {80}}};
  const std::string page = explain_text(approached(document), 80);
  EXPECT_NE(page.find("the default gradient for TSR under its rear"), std::string::npos) << page;
  EXPECT_NE(page.find("= min(0, 3, -10)"), std::string::npos) << page;
  EXPECT_NEAR(value_of(page, "grad"), -10.0, 1e-9);
  // A rise is no safe side: unknown track counts as level.
  document["track"]["default_gradient"] = 7;
  EXPECT_NE(explain_text(approached(document), 80).find("= min(0, 3)"), std::string::npos);
}

/// 4.0.0: every branch of A.3.12, each step computed again.
TEST(CurvesExplain, ReducedBuildUpTimes) {
  json base = load_json(kCurves + "passenger_eoa.json");
  base["srs"] = "4.0.0";
  const json LOA = {{"type", "LOA"}, {"location_m", 7000}, {"speed_kmh", 40}};
  std::string all;
  for (const bool stop : {true, false})
    for (const double A_est : {0.0, 0.3, 0.9})
      for (const char* fitted : {"both", "no service brake", "no cut-off"}) {
        json document = base;
        document["state"] = {{"A_est", A_est}, {"V_ura_kmh", 1}};
        document["train"]["T_traction_cut_off_s"] = 3.5;
        if (std::string(fitted) == "no service brake") document["train"]["service_brake_interface"] = false;
        if (std::string(fitted) == "no cut-off") document["train"]["traction_cut_off_interface"] = false;
        if (!stop) document["target"] = LOA;
        const Approached a = approached(document);
        for (const double v : {0.0, 1.0, 3.0, 8.0, 30.0, 38.0, 40.0, 42.0, 45.0, 50.0, 140.0}) {
          SCOPED_TRACE(document["state"].dump() + fitted + (stop ? " stop at " : " LOA at ") + std::to_string(v));
          const std::string page = explain_text(a, v);
          check_by_calculator(page);
          all += page;
        }
      }
  for (const char* clause : {"2.1", "2.2", "2.3", "2.4", "2.5", "2.6", "2.7", "2.8", "3.1", "3.2", "3.4", "3.5", "4.1",
                             "4.2", "4.3", "4.4", "4.5", "4.6", "5.1", "5.2", "6.1", "6.2", "7.1", "7.2", "8.1"})
    EXPECT_NE(all.find("[A.3.12." + std::string(clause) + "]"), std::string::npos) << clause;
  // By hand, the service brake at 3 km/h: 10.6 s, reaction 1.06 s, 1.0885 and 1.04041 m/s2.
  const std::string page = explain_text(approached(base), 3);
  EXPECT_NEAR(value_of(page, "t_enough"), 6.4650, 2e-4);     // 1.06 + sqrt(2 * 0.83333 * 19.08 / 1.0885)
  EXPECT_NEAR(value_of(page, "D_enough"), 3.8861, 2e-4);     // 0.83333 * 6.465 - 1.0885 * 5.405^3 / 114.48
  EXPECT_NEAR(value_of(page, "t_step_dist"), 4.2628, 2e-4);  // 3.8861 / 0.83333 - 0.83333 / 2.08082
  EXPECT_NEAR(value_of(page, "T_bs_reduced"), 4.2628, 2e-4);
  // With a separate EOA the SBD has a separate time.
  base["target"]["svl_location_m"] = 7100;
  base["state"] = {{"est_front_m", 5000}};
  const std::string both = explain_text(approached(base), 8);
  EXPECT_FALSE(std::isnan(value_of(both, "A_SB", 1))) << "once to the SvL, once to the EOA";
  check_by_calculator(both);
}

TEST(CurvesExplain, ASpeedThatIsNowhereAllowed) {
  json document = load_json(kCurves + "passenger_eoa.json");
  document["national_values"]["Kv_int_passenger"] = {{0, 0, 0}};
  document["track"]["gradient"] = {{0, 0}};
  const std::string page = explain_text(approached(document), 100);
  EXPECT_NE(page.find("V_bec is allowed nowhere (A <= 0)"), std::string::npos) << page;
  EXPECT_EQ(page.find("1000000"), std::string::npos) << page;
  EXPECT_NE(page.find("d_SBI1"), std::string::npos);
}

TEST(CurvesExplain, ATrackThatIsTooSteep) {
  json document = load_json(kCurves + "passenger_eoa.json");
  document["track"]["gradient"] = {{0, 0}, {5000, -90}, {6000, 0}};
  const std::string page = explain_text(approached(document), 140);
  EXPECT_NE(page.find("level: no deceleration here (A <= 0)"), std::string::npos) << page;
  EXPECT_NE(page.find("note: "), std::string::npos);
}

TEST(CurvesExplain, APlotBesideAnExplanation) {
  const Scratch plot("explained.svg");
  const Ended ran = run(kSource + "/data/curves/passenger_eoa.json --explain 140 --plot " + plot.path());
  EXPECT_EQ(ran.exit_code, 0) << ran.errors;
  EXPECT_NE(ran.output.find("3.13"), std::string::npos);
  EXPECT_NE(text_of(plot.path()).find("<svg"), std::string::npos);
  EXPECT_EQ(run("--model workbook --explain 100").exit_code, 2);
}

TEST(CurvesExplain, ExplainsWhatItComputed) {
  const Approached a = approached(kSource + "/data/curves/passenger_eoa.json");
  const std::string text = explain_text(a, 140);
  const SpeedRow row = speed_row(a, 140);
  for (const char* expected : {"V_bec", "D_bec", "T_traction", "T_indication", "d_EBI", "d_SBI1", "d_SBI2", "d_W",
                               "d_P", "d_I", "3.13.9.3.2.10", "3.13.9.3.6.1", "A_safe", "A_expected"})
    EXPECT_NE(text.find(expected), std::string::npos) << expected;
  for (const Value& v : {row.EBD, row.EBI, row.FLOI, row.W, row.P, row.I})
    EXPECT_NE(text.find(fixed(v, 3) + " m before"), std::string::npos) << *v;
}

/// The clause at the end of the first step of a symbol.
std::string clause_of(const std::string& text, const std::string& symbol) {
  const std::size_t line = text.find("\n   " + symbol + " ");
  if (line == std::string::npos) return "no " + symbol;
  const std::size_t from = text.find('[', line);
  return text.substr(from + 1, text.find(']', from) - from - 1);
}

TEST(CurvesExplain, ExplainsByTheClauseOfEveryStep) {
  const std::string text = explain_text(approached(kSource + "/data/curves/passenger_eoa.json"), 140);
  for (const auto& [symbol, clause] : std::map<std::string, std::string>{{"A_brake_emergency", "A.3.7.2"},
                                                                         {"A_brake_safe", "3.13.6.2.1.4"},
                                                                         {"A_gradient", "3.13.4.3.2"},
                                                                         {"A_safe", "3.13.6.2.1.3"},
                                                                         {"A_brake_service", "A.3.7.2"},
                                                                         {"A_expected", "3.13.6.3.1.3"},
                                                                         {"T_be", "3.13.6.2.2.3"},
                                                                         {"T_bs", "3.13.6.3.2.4"},
                                                                         {"T_bs1", "3.13.9.3.3.3"},
                                                                         {"T_traction", "3.13.9.3.2.3"},
                                                                         {"T_berem", "3.13.9.3.2.6"},
                                                                         {"T_indication", "3.13.9.3.6.2"},
                                                                         {"V_delta0", "3.13.9.3.2.1"},
                                                                         {"A_est1", "3.13.9.3.2.8"},
                                                                         {"A_est2", "3.13.9.3.2.9"},
                                                                         {"V_bec", "3.13.9.3.2.10"},
                                                                         {"D_bec", "3.13.9.3.2.10"},
                                                                         {"d_EBD(V_bec)", "3.13.8.3.2"},
                                                                         {"d_EBI", "3.13.9.3.2.12"},
                                                                         {"d_SBI2", "3.13.9.3.3.2"},
                                                                         {"d_W", "3.13.9.3.4.1"},
                                                                         {"d_P", "3.13.9.3.5.1"},
                                                                         {"d_I", "3.13.9.3.6.1"},
                                                                         {"d_SBD(V)", "3.13.8.4.1"},
                                                                         {"d_SBI1", "3.13.9.3.3.1"},
                                                                         {"lambda_0", "A.3.7.1"},
                                                                         {"V_lim", "A.3.7.3"},
                                                                         {"AD_0", "A.3.7.4"},
                                                                         {"AD_3", "A.3.7.5"},
                                                                         {"A_ebmax", "3.13.6.2.1.8.2"},
                                                                         {"Kv_int(V)", "3.13.6.2.1.8.1"},
                                                                         {"Kr_int(L_TRAIN)", "3.13.2.3.7.12"},
                                                                         {"grad", "3.13.4.2.1"},
                                                                         {"M_rotating", "A.3.1"},
                                                                         {"L", "A.3.8.1"},
                                                                         {"T_brake_basic_eb", "A.3.8.1"},
                                                                         {"T_brake_emergency", "A.3.8.4"},
                                                                         {"T_brake_basic_sb", "A.3.9.1"},
                                                                         {"T_brake_service", "A.3.9.4"}})
    EXPECT_EQ(clause_of(text, symbol), clause) << symbol;
  // Without the service brake command, on slippery rail, towards a restriction.
  json document = passenger();
  document["national_values"]["Q_NVSBTSMPERM"] = false;
  document["state"]["slippery_rail"] = true;
  document["target"] = {{"type", "MRSP"}, {"location_m", 5000}, {"speed_kmh", 80}};
  const std::string other = explain_text(Approached(*io::read_curves(document.dump(), "a")), 20);
  EXPECT_EQ(clause_of(other, "T_bs1"), "3.13.9.3.3.5");
  EXPECT_EQ(clause_of(other, "d_EBD(V_bec)"), "3.13.8.3.1");
  EXPECT_NE(other.find("min(A_brake_safe, A_MAXREDADH) + A_gradient"), std::string::npos);
}

}  // namespace
}  // namespace evc::curves
