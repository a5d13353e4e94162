#include "run/summary.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

#include "io/file.h"
#include "run/rounded.h"
#include "run/sha256.h"

namespace evc::run {

using nlohmann::ordered_json;

namespace {

constexpr double kJoules_a_kWh = 3.6e6;

/// Distribution of the cost of a cycle, in microseconds.
struct Cost {
  double median = 0.0, p99_9 = 0.0, max = 0.0, total_s = 0.0;
};

Cost cost_of(std::vector<float> seconds) {
  Cost cost;
  if (seconds.empty()) return cost;
  for (const float s : seconds) cost.total_s += static_cast<double>(s);
  std::sort(seconds.begin(), seconds.end());
  const auto at = [&](double share) {
    const auto i = static_cast<std::size_t>(share * static_cast<double>(seconds.size() - 1) + 0.5);
    return std::nearbyint(static_cast<double>(seconds[i]) * 1e8) / 100.0;
  };
  cost.median = at(0.5);
  cost.p99_9 = at(0.999);
  cost.max = at(1.0);
  return cost;
}

double thousandth(double v) { return std::nearbyint(v * 1000.0) / 1000.0 + 0.0; }

ordered_json balise_counts(const Journey& journey, const sim::World& world, const sim::Line& line) {
  std::vector<bool> read(line.groups, false);
  for (const sim::Passing& p : world.passings()) read[p.group] = true;
  const auto& counts = journey.counts();
  return {{"on_line", line.groups},
          {"read", std::count(read.begin(), read.end(), true)},
          {"linked_ok", counts.groups_linked_ok},
          {"missed", counts.groups_missed},
          {"rejected", counts.groups_rejected}};
}

}  // namespace

ordered_json summary_of(const Journey& journey, const sim::World& world, const sim::Line& line, const OnBoard& on_board,
                        const std::string* outputs) {
  const auto& counts = journey.counts();
  const auto& interventions = journey.interventions();
  const Cost cost = cost_of(on_board.costs());
  const auto& deliveries = world.radio().deliveries();
  const auto received =
      std::count_if(deliveries.begin(), deliveries.end(), [](const sim::Delivery& d) { return d.seq >= 0; });
  const double duration = journey.samples().empty() ? 0.0 : journey.samples().back().t_s;
  const auto optional = [](const std::optional<double>& v) { return v ? ordered_json(*v) : ordered_json(nullptr); };
  ordered_json s;
  s["schema"] = "evc-summary/1";
  s["line"] = line.name;
  // As recorded: a world that was stopped may have made one more cycle.
  s["distance_m"] = journey.samples().empty() ? 0.0 : tenth(journey.samples().back().x_m - world.start_m());
  s["duration_s"] = duration;
  s["cycles"] = journey.cycles();
  s["modes"] = journey.modes();
  s["levels"] = journey.levels();
  s["balise_groups"] = balise_counts(journey, world, line);
  s["telegrams"] = {{"decoded", world.telegrams_read() - static_cast<std::size_t>(counts.telegrams_rejected)},
                    {"rejected", counts.telegrams_rejected}};
  s["radio_messages"] = {{"received", received},
                         {"accepted", counts.messages_accepted},
                         {"refused", counts.messages_refused},
                         {"rejected", counts.messages_rejected},
                         {"absent", line.absent_messages},
                         {"withheld", world.radio().withheld()},
                         {"undelivered", world.radio().undelivered()},
                         {"unanswered_calls", world.radio().unanswered_calls()}};
  s["movement_authorities"] = {{"received", counts.authorities_received}, {"accepted", counts.authorities_accepted}};
  s["interventions"] = {
      {"tco", interventions.tco}, {"sb", interventions.sb}, {"eb", interventions.eb}, {"trip", interventions.trip}};
  const auto margin = journey.min_margin_to_EBI_kmh();
  s["min_margin_to_EBI_kmh"] = margin ? ordered_json(tenth(*margin)) : ordered_json(nullptr);
  s["max_position_error_m"] = thousandth(journey.max_position_error_m());
  s["confidence_interval_violations"] = journey.confidence_interval_violations();
  const auto overrun = journey.svl_overrun_m();
  s["svl_overrun_m"] = optional(overrun ? std::optional(thousandth(*overrun)) : std::nullopt);
  s["energy_kwh"] = thousandth(world.motion().traction_energy() / kJoules_a_kWh);
  if (outputs != nullptr) s["output_hash"] = sha256(*outputs);
  s["cycle_us"] = {{"median", cost.median}, {"p99_9", cost.p99_9}, {"max", cost.max}};
  s["state_bytes"] = OnBoard::state_bytes();
  s["allocations_in_step"] = on_board.allocations_in_step();
  s["real_time_factor"] = cost.total_s > 0.0 ? std::nearbyint(duration / cost.total_s) : 0.0;
  return s;
}

std::optional<io::Diagnostic> fault_of(const std::string& line, const sim::World& world, const Journey& journey) {
  using Ending = sim::World::Ending;
  const bool too_long = world.ending() == Ending::too_long;
  if (world.ending() == Ending::end_of_line || (world.has_moved() && !too_long)) return std::nullopt;
  const Sample& last = journey.samples().back();
  const auto now = fmt::format("mode {}, level {}, {} radio messages undelivered", name(static_cast<Mode>(last.mode)),
                               name(static_cast<Level>(last.level)), world.radio().undelivered());
  return too_long ? io::Diagnostic{line, "", "a run without an end, " + now, "one within 6 h"}
                  : io::Diagnostic{line, "", "a train that never moved, " + now, "a mission that begins"};
}

io::Result<bool> write_records(const std::string& folder, const Records& records, const ordered_json& summary,
                               const std::string& page) {
  const std::string totals = summary.dump(2) + "\n";
  // The summary is last: a folder with a summary has all files, and all of one run.
  const std::pair<const char*, const std::string*> texts[] = {{"inputs.jsonl", &records.inputs},
                                                              {"outputs.jsonl", &records.outputs},
                                                              {"trace.csv", &records.trace},
                                                              {"report.html", &page},
                                                              {"summary.json", &totals}};
  std::vector<io::WholeFile> files;
  files.reserve(std::size(texts));
  for (const auto& [name, text] : texts) {
    auto file = io::WholeFile::create(folder + "/" + name);
    if (!file) return tl::unexpected(file.error());
    file->write(*text);
    if (const auto whole = file->finish(); !whole) return whole;
    files.push_back(std::move(*file));
  }
  const std::string old = folder + "/summary.json";
  std::error_code error;
  std::filesystem::remove(old, error);
  if (error) return tl::unexpected(io::Diagnostic{old, "", error.message(), "a file that can be written"});
  for (io::WholeFile& file : files)
    if (const auto named = file.commit(); !named) return named;
  return true;
}

io::Result<bool> prepare_folder(const std::string& folder) {
  if (folder.empty()) return true;
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return tl::unexpected(io::Diagnostic{folder, "", error.message(), "a folder that can be written"});
  return io::can_be_written_in(folder);
}

}  // namespace evc::run
