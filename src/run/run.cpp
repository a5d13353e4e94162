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
#include "run/rounded.h"
#include "run/stop_signals.h"
#include "run/summary.h"

namespace evc::run {
namespace {

using io::complain;
using nlohmann::ordered_json;

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
  fmt::print("energy              {} kWh at the wheels\n", number(s["energy_kwh"]));
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

}  // namespace

int run(const RunOptions& options) {
  const auto line = load_line(options.line);
  if (!line) return complain(line.error());
  const auto train = load_train(options.train);
  if (!train) return complain(train.error());
  if (const auto folder = prepare_folder(options.output); !folder) return complain(folder.error());
  sim::World::Settings settings;
  settings.driver = static_cast<sim::DriverKind>(std::find(kDriverNames.begin(), kDriverNames.end(), options.driver) -
                                                 kDriverNames.begin());
  settings.seed = options.seed;
  settings.cycle_ms = options.cycle_ms;
  settings.utc = options.utc;
  if (options.odometer != "random")
    settings.odometer = options.odometer == "over" ? sim::Odometer::Errors::over() : sim::Odometer::Errors::under();
  if (options.last_ma >= 0) settings.last_ma = options.last_ma;
  io::Configuration configuration;
  configuration.cycle_ms = options.cycle_ms;
  configuration.srs = options.srs;
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
  ordered_json summary = summary_of(journey, *world, *line, on_board, &records.outputs);
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
  const auto fault = stopped ? std::nullopt : fault_of(line_file(options.line), *world, journey);
  if (fault) (void)complain(*fault);
  return fault ? 1 : 0;
}

}  // namespace evc::run
