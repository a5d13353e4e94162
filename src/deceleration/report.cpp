#include "deceleration/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "deceleration/train_document.h"
#include "io/diagnostic.h"

namespace evc::deceleration {
namespace {

using Json = nlohmann::ordered_json;

std::string band(const Spec& spec, double from_kmh) {
  const auto next = std::upper_bound(spec.speeds_kmh.begin(), spec.speeds_kmh.end(), from_kmh);
  return next == spec.speeds_kmh.end() ? fmt::format("{:g} -", from_kmh) : fmt::format("{:g} - {:g}", from_kmh, *next);
}

std::string heading(const char* first) {
  std::string line = fmt::format("{:>13}  {:>6}", first, "nom.");
  for (std::size_t k = 0; k < kLevels; ++k) line += fmt::format("  {:>6}", k);
  return line + "\n";
}

/// How many of the levels that a plain run reaches have bounds in common with those of the estimate.
struct Agreement {
  std::size_t compared = 0, equal = 0;
  double farthest = 0.0;  // largest difference of the two estimates
};
Agreement agreement(const Guaranteed& result, const PlainRun& run) {
  Agreement agreement;
  for (std::size_t s = 0; s < result.steps.size(); ++s)
    for (std::size_t k = 0; k < kLevels; ++k) {
      if (!run.steps[s][k]) continue;
      const Quantile& plain = *run.steps[s][k];
      const Quantile& estimate = result.steps[s].Kdry_rst[k];
      ++agreement.compared;
      if (plain.low <= estimate.high && estimate.low <= plain.high) ++agreement.equal;
      agreement.farthest = std::max(agreement.farthest, std::abs(plain.value - estimate.value));
    }
  return agreement;
}

Json json_of(const Quantile& q) { return {{"value", q.value}, {"low", q.low}, {"high", q.high}}; }

template <class List>
Json list_of(const List& list) {
  Json out = Json::array();
  for (const auto& q : list) out.push_back(json_of(q));
  return out;
}

Json json_of(const Guaranteed::AtSpeed& step, const PlainQuantiles* plain) {
  Json out{{"from_kmh", step.from_kmh},
           {"A_brake_emergency_mps2", step.A_brake_emergency},
           {"Kdry_rst", list_of(step.Kdry_rst)}};
  if (step.build_up_s) out["T_brake_emergency_s"] = list_of(*step.build_up_s);
  if (plain != nullptr) {
    out["plain_run"] = Json::array();
    for (const auto& q : *plain) out["plain_run"].push_back(q ? json_of(*q) : Json(nullptr));
  }
  return out;
}

}  // namespace

std::string table(const Spec& spec, const Guaranteed& result) {
  std::string out;
  if (!spec.name.empty()) out += io::printable(spec.name, 200) + "\n";
  out +=
      fmt::format("{} brake units, {} steps of speed, {:g} t\n\n", spec.units(), spec.speeds_kmh.size(), spec.mass_t);
  out += "A_brake_emergency (m/s2) and Kdry_rst by M_NVEBCL\n" + heading("km/h");
  for (const auto& step : result.steps) {
    out += fmt::format("{:>13}  {:6.3f}", band(spec, step.from_kmh), step.A_brake_emergency);
    for (const Quantile& q : step.Kdry_rst) out += fmt::format("  {:6.3f}", q.value);
    out += '\n';
  }
  out += fmt::format("{:>13}  {:6}", "95 % +-", "");
  for (std::size_t k = 0; k < kLevels; ++k) out += fmt::format("  {:6.4f}", result.error_at(k));
  out += "\n\nfor the train file: the low bounds, safe for every speed of their step\n" + heading("from km/h");
  for (const Step& step : train_steps(spec, result.safe_steps())) {
    out += fmt::format("{:>13}  {:6.3f}", fmt::format("{:g}", step.from_kmh), step.A_brake_emergency);
    for (const double factor : step.Kdry_rst) out += fmt::format("  {:6.3f}", factor);
    out += '\n';
  }
  if (spec.has_response()) {
    out += fmt::format("\n{:>21}", "T_brake_emergency (s)");
    for (std::size_t k = 0; k < kLevels; ++k) out += fmt::format("  {:6.2f}", *result.build_up_at(k));
    out += '\n';
  }
  if (result.plain) {
    const Agreement a = agreement(result, *result.plain);
    out += fmt::format(
        "\nplain run: {} samples in {:.1f} s, values to {:.2g}\n"
        "plain run: bounds in common in {} of {} cases, largest difference {:.2g}\n",
        result.plain->samples, result.plain->seconds, result.plain->resolution, a.equal, a.compared, a.farthest);
  }
  return out + fmt::format("\ncomputed in {:.1f} s\n", result.seconds);
}

std::string json(const Spec& spec, const Guaranteed& result) {
  Json out{{"schema", "evc-brakes-result/1"},
           {"name", spec.name},
           {"brake_units", spec.units()},
           {"mass_t", spec.mass_t},
           {"dynamic_mass_t", spec.dynamic_mass_t},
           {"seed", spec.seed},
           {"samples", spec.samples},
           {"steps", Json::array()},
           {"train_steps", Json::array()}};
  for (std::size_t s = 0; s < result.steps.size(); ++s)
    out["steps"].push_back(json_of(result.steps[s], result.plain ? &result.plain->steps[s] : nullptr));
  for (const Step& step : train_steps(spec, result.safe_steps()))
    out["train_steps"].push_back(
        {{"from_kmh", step.from_kmh}, {"A_brake_emergency_mps2", step.A_brake_emergency}, {"Kdry_rst", step.Kdry_rst}});
  if (result.plain) {
    const Agreement a = agreement(result, *result.plain);
    out["plain_run"] = {{"samples", result.plain->samples},
                        {"resolution", result.plain->resolution},
                        {"compared", a.compared},
                        {"in_common", a.equal},
                        {"largest_difference", a.farthest}};
  }
  return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace evc::deceleration
