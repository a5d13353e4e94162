#include "deceleration/train_document.h"

#include <algorithm>
#include <cmath>

#include "io/train_file.h"
#include "train/train_data.h"

namespace evc::deceleration {
namespace {

using io::Json;
using io::JsonPlace;

constexpr double kStandardTop_kmh = 160.0;
constexpr double kLongestTime_s = 120.0;  // 3.13.2.2.3.2

/// The fastest that a train of this block runs; that of the standard train where it does not say.
double top_of(const Json& train) {
  const auto top = train.find("max_speed_kmh");
  return top != train.end() && top->is_number() ? top->get<double>() : kStandardTop_kmh;
}

/// The spec with the computed keys in its `train`.
Json completed(const Spec& spec, std::span<const Step> steps, std::optional<double> build_up_s) {
  Json document = spec.document;
  Json& train = document["train"];
  train["schema"] = "etcs-train/1";
  if (!train.contains("name") && !spec.name.empty()) train["name"] = spec.name;
  train["brake_model"] = "gamma";
  for (const char* key : {"A_brake_emergency", "Kdry_rst"}) train[key] = Json::array();
  for (const Step& step : steps) {
    train["A_brake_emergency"].push_back({step.from_kmh, step.A_brake_emergency});
    Json row = {step.from_kmh};
    for (const double factor : step.Kdry_rst) row.push_back(factor);
    train["Kdry_rst"].push_back(row);
  }
  if (build_up_s) train["T_brake_emergency_s"] = std::ceil(*build_up_s * 100.0 - 1e-9) / 100.0;
  if (!train.contains("dynamics")) train["dynamics"] = Json::object();
  if (train["dynamics"].is_object() && !train["dynamics"].contains("mass_t")) train["dynamics"]["mass_t"] = spec.mass_t;
  return document;
}

/// The unit that responds last: its key was written, that of the train file was not.
std::string place_of_response(const Spec& spec) {
  const auto latest = [](const UnitGroup& group) { return group.response_s->range().second; };
  const auto last = std::max_element(spec.groups.begin(), spec.groups.end(),
                                     [&](const auto& a, const auto& b) { return latest(a) < latest(b); });
  return last->place + "/response_s";
}

void require_build_up(const Spec& spec, double build_up_s) {
  if (build_up_s <= kLongestTime_s) return;
  // Of a variable without an upper bound, where the samples do not reach the level.
  const std::string found = std::isfinite(build_up_s) ? "a build-up time of " + std::to_string(build_up_s) + " s"
                                                      : "no upper bound of the build-up time";
  throw io::ReadError{{spec.file, place_of_response(spec), found + " at level " + std::to_string(spec.response_level),
                       "at most " + std::to_string(static_cast<int>(kLongestTime_s)) +
                           " s: a truncated variable, more samples, or a lower response_level"}};
}

/// The errors of the reader of train files, at the places of the spec.
void require_train(const Json& document, const std::string& file) {
  (void)io::read_train(JsonPlace(document, file)["train"]);
}

}  // namespace

io::Result<bool> check_train(const Spec& spec) {
  return io::guarded([&] {
    const auto train = JsonPlace(spec.document, spec.file).find("train");
    if (!train) return false;
    if (!train->is_object()) train->fail("an object");
    for (const char* key : {"A_brake_emergency", "Kdry_rst", "brake_model"})
      if (const auto p = train->find(key)) p->fail(std::string("the key ") + key, "no such key: it is computed");
    if (const auto p = train->find("T_brake_emergency_s"); p && spec.has_response())
      p->fail("the key T_brake_emergency_s", "no such key: it is computed from response_s");
    Step step;
    step.A_brake_emergency = 1.0;
    step.Kdry_rst.fill(1.0);
    // A reaction time may be as long as the time that is computed.
    std::optional<double> time;
    if (spec.has_response()) time = kLongestTime_s;
    require_train(completed(spec, {&step, 1}, time), spec.file);
    return true;
  });
}

std::vector<Step> train_steps(const Spec& spec, std::span<const Step> steps) {
  if (!spec.document.contains("train"))
    return joined(steps, train::kSpeedSteps, std::max(kStandardTop_kmh, steps.back().from_kmh));
  const double top_kmh = top_of(spec.document["train"]);
  for (std::size_t most = train::kSpeedSteps; most > 1; --most) {
    auto joint = joined(steps, most, top_kmh);
    const auto fits = io::guarded([&] {
      std::optional<double> time;
      if (spec.has_response()) time = kLongestTime_s;
      require_train(completed(spec, joint, time), spec.file);
      return true;
    });
    if (fits) return joint;
  }
  return joined(steps, 1, top_kmh);
}

io::Result<std::string> train_document(const Spec& spec, std::span<const Step> steps,
                                       std::optional<double> build_up_s) {
  return io::guarded([&] {
    if (build_up_s) require_build_up(spec, *build_up_s);
    const Json document = completed(spec, steps, build_up_s);
    require_train(document, spec.file);
    return document["train"].dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  });
}

}  // namespace evc::deceleration
