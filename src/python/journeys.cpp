#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "io/date_time.h"
#include "io/input_writer.h"
#include "io/line_file.h"
#include "io/named_document.h"
#include "io/train_file.h"
#include "python/bind.h"
#include "python/interruption.h"
#include "python/values.h"
#include "run/display_lists.h"
#include "run/drive.h"
#include "run/journey.h"
#include "run/on_board.h"
#include "run/report.h"
#include "run/summary.h"
#include "sim/world.h"

// `openevc.run`: a journey as that of `evc run`.
namespace evc::python {
namespace {

/// The arguments, read.
struct Asked {
  std::string line_name;  // for errors
  sim::Line line;
  io::Configuration configuration;
  sim::World::Settings settings;
  std::string output;  // folder; empty: none
};

sim::Odometer::Errors read_odometer(const io::JsonPlace& place) {
  if (place.is_object()) {
    place.know_only({"error"});
    return sim::Odometer::Errors::constant(place["error"].number(-0.3, 0.3));
  }
  switch (place.one_of({"random", "over", "under"})) {
    case 1:
      return sim::Odometer::Errors::over();
    case 2:
      return sim::Odometer::Errors::under();
    default:
      return {};
  }
}

/// None: the default.
Asked read_asked(const py::dict& arguments) {
  constexpr const char* kFile = "run";
  io::Json document = json_of(arguments, kFile);
  for (auto member = document.begin(); member != document.end();)
    member = member->is_null() ? document.erase(member) : std::next(member);
  Asked asked;
  asked.line_name = document.contains("line") && document["line"].is_string() ? document["line"] : "line";
  if (!document.contains("line")) document["line"] = "brunnental";
  const std::string line_file = io::put_named(document, "line", "lines", {document, kFile});
  const std::string train_file = io::put_named(document, "train", "trains", {document, kFile});
  const std::string values_file = io::put_named(document, "national_values", "national_values", {document, kFile});
  const io::JsonPlace root(document, kFile);
  root.know_only({"line", "train", "national_values", "srs", "driver", "odometer", "seed", "cycle_ms", "last_ma", "utc",
                  "output"});
  // An error names the file that it is in.
  const auto place = [&](const char* member, const std::string& file) {
    return file.empty() ? root[member] : io::JsonPlace(document[member], file);
  };
  asked.line = io::read_line(place("line", line_file));
  if (root.find("train")) asked.configuration.train = io::read_train(place("train", train_file));
  if (root.find("national_values"))
    asked.configuration.national_values = io::read_national_values(place("national_values", values_file));
  if (const auto p = root.find("srs")) asked.configuration.srs = io::read_srs_version(*p);
  if (const auto p = root.find("driver"))
    asked.settings.driver = static_cast<sim::DriverKind>(p->one_of(run::kDriverNames));
  if (const auto p = root.find("odometer")) asked.settings.odometer = read_odometer(*p);
  if (const auto p = root.find("seed"))
    asked.settings.seed = static_cast<std::uint64_t>(p->integer(0, std::numeric_limits<std::int64_t>::max()));
  if (const auto p = root.find("cycle_ms")) asked.settings.cycle_ms = p->integer(1, 1000);
  if (const auto p = root.find("last_ma")) asked.settings.last_ma = static_cast<int>(p->integer(0, 1000000));
  if (const auto p = root.find("utc")) asked.settings.utc = io::read_utc(*p);
  if (const auto p = root.find("output")) asked.output = p->string();
  asked.configuration.cycle_ms = asked.settings.cycle_ms;
  asked.configuration.document = io::configuration_document(asked.configuration);
  if (document.contains("national_values")) {
    io::Json configuration = io::parse_json(asked.configuration.document, kFile);
    configuration["national_values"] = document["national_values"];
    asked.configuration.document = configuration.dump();
  }
  return asked;
}

/// A journey that was driven, to its end or until a signal.
struct Driven {
  nlohmann::ordered_json summary;
  run::Records records;
  std::optional<io::Diagnostic> fault;
};

Driven drive(const Asked& asked, Interruption& interruption, Unlocked& unlocked) {
  const io::Train& train = asked.configuration.train;
  const auto world = std::make_unique<sim::World>(asked.line, train.data, train.dynamics, asked.settings);
  run::OnBoard on_board(asked.configuration.for_kernel(), run::OnBoard::Costs::kept);
  run::Journey journey(*world);
  run::DisplayLists displays;
  const bool reported = !asked.output.empty();
  run::Recorder recorder(*world, journey, asked.configuration, reported ? &displays : nullptr,
                         run::Recorder::Shows::nothing);
  run::drive(*world, on_board, recorder, [&] { return interruption.seen(unlocked); });
  Driven driven;
  driven.summary = run::summary_of(journey, *world, asked.line, on_board, &recorder.records().outputs);
  if (reported) {
    const std::string driver = run::kDriverNames[static_cast<std::size_t>(asked.settings.driver)];
    (void)value_of(run::write_records(
        asked.output, recorder.records(), driven.summary,
        run::report_page(journey, *world, asked.line, train.name, driver, driven.summary.dump(), displays)));
  }
  driven.records = std::move(recorder.records());
  driven.fault = run::fault_of(asked.line_name, *world, journey);
  return driven;
}

py::dict run_journey(const py::dict& arguments) {
  const Asked asked = read_asked(arguments);
  (void)value_of(run::prepare_folder(asked.output));
  Interruption interruption;
  const Driven driven = [&] {
    Unlocked unlocked;
    return drive(asked, interruption, unlocked);
  }();
  const py::object error = interruption.error();
  const bool failed = driven.fault && error.is_none();
  return py::dict(py::arg("summary") = object_of(driven.summary.dump()), py::arg("trace") = driven.records.trace,
                  py::arg("inputs") = driven.records.inputs, py::arg("outputs") = driven.records.outputs,
                  py::arg("fault") = failed ? py::object(py::str(driven.fault->text())) : py::none(),
                  py::arg("interruption") = error);
}

}  // namespace

void bind_journeys(py::module_& module) { module.def("run", run_journey); }

}  // namespace evc::python
