#include "run/run.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "io/file.h"
#include "io/train_file.h"
#include "run/display_lists.h"
#include "run/drive.h"
#include "run/journey.h"
#include "run/load.h"
#include "run/on_board.h"
#include "run/report.h"
#include "run/sha256.h"
#include "run/stop_signals.h"

namespace evc::run {
namespace {

using io::complain;
using nlohmann::ordered_json;

constexpr const char* kDriverNames[] = {"perfect", "late", "reckless"};

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

double tenth(double v) { return std::nearbyint(v * 10.0) / 10.0 + 0.0; }
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

ordered_json summary_of(const Journey& journey, const sim::World& world, const sim::Line& line, const OnBoard& on_board,
                        const std::string& outputs) {
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
  s["output_hash"] = sha256(outputs);
  s["cycle_us"] = {{"median", cost.median}, {"p99_9", cost.p99_9}, {"max", cost.max}};
  s["state_bytes"] = OnBoard::state_bytes();
  s["allocations_in_step"] = on_board.allocations_in_step();
  s["real_time_factor"] = cost.total_s > 0.0 ? std::nearbyint(duration / cost.total_s) : 0.0;
  return s;
}

ordered_json json_of(const realtime::Times& times, double unit_ns) {
  const auto in_unit = [&](realtime::Nanoseconds t) { return tenth(static_cast<double>(t.count()) / unit_ns); };
  return {{"median", in_unit(times.share(0.5))}, {"p99_9", in_unit(times.share(0.999))}, {"max", in_unit(times.max())}};
}

ordered_json json_of(const RealTime& r) {
  return {{"cycle_ms", r.cycle_ms},
          {"missed", r.timing.missed},
          {"without_inputs", r.without_inputs},
          {"lost", r.lost},
          {"jitter_us", json_of(r.timing.jitter, 1e3)},
          {"response_us", json_of(r.timing.response, 1e3)},
          {"inputs_age_ms", json_of(r.age, 1e6)}};
}

std::string joined(const std::vector<std::string>& names) { return fmt::format("{}", fmt::join(names, " > ")); }

void print_summary(const ordered_json& s, const std::string& train, const std::string& driver) {
  const auto number = [](const ordered_json& v) { return v.is_null() ? std::string("-") : v.dump(); };
  const double t = s["duration_s"].get<double>();
  fmt::print("line                {}\n", io::printable(s["line"].get<std::string>()));
  fmt::print("train, driver       {}, {}\n", io::printable(train), driver);
  fmt::print("distance, time      {:.2f} km, {:.0f} min {:02.0f} s\n", s["distance_m"].get<double>() / 1000.0,
             std::floor(t / 60.0), t - 60.0 * std::floor(t / 60.0));
  fmt::print("modes               {}\n", joined(s["modes"].get<std::vector<std::string>>()));
  fmt::print("levels              {}\n", joined(s["levels"].get<std::vector<std::string>>()));
  const auto& g = s["balise_groups"];
  fmt::print("balise groups       {} of {} read, {} as linked, {} missed, {} rejected; {} telegrams, {} rejected\n",
             number(g["read"]), number(g["on_line"]), number(g["linked_ok"]), number(g["missed"]),
             number(g["rejected"]), number(s["telegrams"]["decoded"]), number(s["telegrams"]["rejected"]));
  const auto& m = s["radio_messages"];
  fmt::print("radio messages      {} received: {} accepted, {} refused; {} absent, {} withheld{}\n",
             number(m["received"]), number(m["accepted"]), number(m["refused"]), number(m["absent"]),
             number(m["withheld"]), m["undelivered"] == 0 ? "" : ", " + number(m["undelivered"]) + " undelivered");
  if (m["unanswered_calls"] != 0)
    fmt::print("calls unanswered    {}: one RBC is simulated, no other one and no radio infill unit\n",
               number(m["unanswered_calls"]));
  fmt::print("authorities         {} received, {} accepted\n", number(s["movement_authorities"]["received"]),
             number(s["movement_authorities"]["accepted"]));
  const auto& i = s["interventions"];
  fmt::print("interventions       {} traction cut-off, {} service brake, {} emergency brake, {} trip\n",
             number(i["tco"]), number(i["sb"]), number(i["eb"]), number(i["trip"]));
  fmt::print("margin to the EBI   {} km/h minimum\n", number(s["min_margin_to_EBI_kmh"]));
  fmt::print("position error      {} m at most, {} cycles outside the confidence interval\n",
             number(s["max_position_error_m"]), number(s["confidence_interval_violations"]));
  if (!s["svl_overrun_m"].is_null()) fmt::print("SvL overrun         {} m\n", number(s["svl_overrun_m"]));
  const auto& c = s["cycle_us"];
  fmt::print("cost of a cycle     median {} us, 99.9 % {} us, max {} us; {} cycles, {} times real time\n",
             number(c["median"]), number(c["p99_9"]), number(c["max"]), number(s["cycles"]),
             s["real_time_factor"].get<double>());
  if (!s.contains("real_time")) return;
  const auto& r = s["real_time"];
  const auto times = [&](const char* key) {
    return fmt::format("median {}, 99.9 % {}, max {}", number(r[key]["median"]), number(r[key]["p99_9"]),
                       number(r[key]["max"]));
  };
  fmt::print("real time           cycle of {} ms: {} missed, {} without inputs, {} lost\n", number(r["cycle_ms"]),
             number(r["missed"]), number(r["without_inputs"]), number(r["lost"]));
  fmt::print("  begin after due   {} us\n", times("jitter_us"));
  fmt::print("  end after due     {} us\n", times("response_us"));
  fmt::print("  age of inputs     {} ms\n", times("inputs_age_ms"));
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

/// 1, with the reason, for a journey that did not take place: the train never moved, or found no end in time.
int verdict(const std::string& line, const sim::World& world, const Journey& journey) {
  using Ending = sim::World::Ending;
  const bool too_long = world.ending() == Ending::too_long;
  if (world.ending() == Ending::end_of_line || (world.has_moved() && !too_long)) return 0;
  const Sample& last = journey.samples().back();
  const auto now = fmt::format("mode {}, level {}, {} radio messages undelivered", name(static_cast<Mode>(last.mode)),
                               name(static_cast<Level>(last.level)), world.radio().undelivered());
  (void)complain(too_long ? io::Diagnostic{line, "", "a run without an end, " + now, "one within 6 h"}
                          : io::Diagnostic{line, "", "a train that never moved, " + now, "a mission that begins"});
  return 1;
}

/// Before the run, so that a long simulation is not lost because the folder cannot be written.
io::Result<bool> prepare_folder(const std::string& folder) {
  if (folder.empty()) return true;
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return tl::unexpected(io::Diagnostic{folder, "", error.message(), "a folder that can be written"});
  return io::can_be_written_in(folder);
}

}  // namespace

int run(const RunOptions& options) {
  const auto line = load_line(options.line);
  if (!line) return complain(line.error());
  const auto train = load_train(options.train);
  if (!train) return complain(train.error());
  if (const auto folder = prepare_folder(options.output); !folder) return complain(folder.error());
  const auto driver = static_cast<sim::DriverKind>(
      std::find(std::begin(kDriverNames), std::end(kDriverNames), options.driver) - std::begin(kDriverNames));
  sim::World::Settings settings;
  settings.driver = driver;
  settings.seed = options.seed;
  settings.cycle_ms = options.cycle_ms;
  if (options.odometer != "random")
    settings.odometer = options.odometer == "over" ? sim::Odometer::Errors::over() : sim::Odometer::Errors::under();
  if (options.last_ma >= 0) settings.last_ma = options.last_ma;
  io::Configuration configuration;
  configuration.cycle_ms = options.cycle_ms;
  configuration.train = *train;
  configuration.document = io::configuration_document(configuration);
  const auto world = std::make_unique<sim::World>(*line, train->data, train->dynamics, settings);
  OnBoard on_board(configuration.for_kernel(), OnBoard::Costs::kept);
  Journey journey(*world);
  DisplayLists displays;
  Recorder recorder(*world, journey, configuration, options.output.empty() ? nullptr : &displays);
  std::optional<RealTime> real_time;
  bool stopped = false;
  if (options.real_time) {
    const StopSignals signals;
    realtime::MonotonicClock clock;
    Exchange exchange;
    OnBoard twin(configuration.for_kernel());
    real_time = drive_in_real_time(
        *world, on_board, recorder, options.cycle_ms, clock, exchange, [&] { return signals.seen(); }, &twin);
    stopped = signals.seen();
  } else {
    drive(*world, on_board, recorder);
  }
  const Records& records = recorder.records();
  ordered_json summary = summary_of(journey, *world, *line, on_board, records.outputs);
  if (real_time) summary["real_time"] = json_of(*real_time);
  io::Result<bool> written = true;
  // The files first: they do not depend on standard output.
  if (!options.output.empty())
    written = write_records(options.output, records, summary,
                            report_page(journey, *world, *line, train->name, options.driver, summary.dump(), displays));
  print_summary(summary, train->name, options.driver);
  if (!written) return complain(written.error());
  if (options.output.empty())
    fmt::print("(-o DIR writes report.html, trace.csv, inputs.jsonl, outputs.jsonl and summary.json)\n");
  else
    fmt::print("report              {}/report.html\n", options.output);
  return stopped ? 0 : verdict(line_file(options.line), *world, journey);
}

}  // namespace evc::run
