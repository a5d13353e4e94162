#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/file.h"
#include "io/input_writer.h"
#include "io/json_pointer.h"
#include "io/line_file.h"
#include "io/named_document.h"
#include "io/train_file.h"
#include "run/display_lists.h"
#include "run/drive.h"
#include "run/journey.h"
#include "run/on_board.h"
#include "run/report.h"
#include "run/sha256.h"
#include "run/summary.h"
#include "sim/world.h"
#include "sweep/document.h"
#include "sweep/kinds.h"

namespace evc::sweep {
namespace {

using io::Json;
using io::JsonPlace;
using nlohmann::ordered_json;

/// What of a summary depends on the machine, or on nothing: no measure.
constexpr const char* kNoMeasures[] = {"schema", "line", "cycle_us", "real_time_factor"};

constexpr File kFiles[] = {{"line", "lines"}, {"train", "trains"}, {"national_values", "national_values"}};

/// The leaves of a summary, with the names of the members on the way joined by dots.
void append_leaves(std::vector<std::string>& names, const ordered_json& value, const std::string& name) {
  if (!value.is_object()) {
    names.push_back(name);
    return;
  }
  for (const auto& [key, member] : value.items()) {
    const bool left_out =
        name.empty() && std::find(std::begin(kNoMeasures), std::end(kNoMeasures), key) != std::end(kNoMeasures);
    if (!left_out) append_leaves(names, member, name.empty() ? key : name + "." + key);
  }
}

/// The member of a summary with this name.
const ordered_json& leaf(const ordered_json& summary, const std::string& name) {
  const ordered_json* at = &summary;
  for (std::size_t begin = 0; begin <= name.size();) {
    const std::size_t end = std::min(name.find('.', begin), name.size());
    at = &at->at(name.substr(begin, end - begin));
    begin = end + 1;
  }
  return *at;
}

/// A journey as it is asked for, with its files read.
struct Asked {
  std::shared_ptr<const sim::Line> line;
  io::Configuration configuration;
  sim::World::Settings settings;
};

sim::DriverKind read_driver(const JsonPlace& place) {
  return static_cast<sim::DriverKind>(place.one_of(run::kDriverNames));
}
std::uint64_t read_seed(const JsonPlace& place) { return static_cast<std::uint64_t>(place.integer(0, INT64_MAX)); }
std::optional<int> read_last_ma(const JsonPlace& place) {
  return place.is_null() ? std::nullopt : std::optional(static_cast<int>(place.integer(0, 1000000)));
}
sim::Odometer::Errors read_odometer(const JsonPlace& place) {
  place.know_only({"error"});
  const auto error = place.find("error");
  if (!error || error->is_null()) return {};
  // Beyond that the declared bound would be most of the way.
  return sim::Odometer::Errors::constant(error->number(-0.3, 0.3));
}

sim::World::Settings read_settings(const JsonPlace& root) {
  sim::World::Settings settings;
  settings.driver = read_driver(root["driver"]);
  settings.seed = read_seed(root["seed"]);
  settings.last_ma = read_last_ma(root["last_ma"]);
  settings.odometer = read_odometer(root["odometer"]);
  return settings;
}

class RunWork final : public Work {
 public:
  explicit RunWork(const Spec& spec) {
    load(spec);
    places_ = places_of(spec, [](const auto&) { return false; });
    require_places(spec, places_, document_, [](const JsonPlace& root) { read_small(root); }, {"line"});
    named_ = named_documents(spec, places_, kFiles);
    // A number with a fraction is none in any case; a driver that there is not is a case that failed.
    require_values(spec, places_, document_, named_, read_member, [](const std::string& member) {
      return member == "seed" || member == "last_ma" ? Judged::whole : Judged::form;
    });
    documents_ = document_.dump();
    for (const auto& [key, named] : named_) {
      documents_ += named.document.dump();
      if (key.first == "line")
        lines_[key.second] = std::make_shared<const sim::Line>(io::read_line(JsonPlace(named.document, named.file)));
    }
    // What no entry varies is read once; an error of it is one of the sweep.
    const Json whole{{"base", document_}};
    const auto place = [&](const char* key, const std::string& file) {
      return file.empty() ? JsonPlace(whole, spec.file)["base"][key] : JsonPlace(document_[key], file);
    };
    if (!places_.below("train")) train_ = io::read_train(place("train", train_file_));
    if (!places_.below("national_values"))
      national_values_ = io::read_national_values(place("national_values", values_file_));
    if (!places_.below("line")) {
      line_ = std::make_shared<const sim::Line>(io::read_line(place("line", line_file_)));
      document_.erase("line");  // each case has a copy of the document
    }
    choose_measures(spec);
  }

  std::string documents() const override { return documents_; }

  Outcome compute(const std::vector<Json>& values, Scratch&) const override {
    Outcome outcome;
    outcome.measures.resize(measures_.size());
    const auto asked = io::guarded([&] { return read_case(values); });
    if (!asked) {
      outcome.error = reason_of(asked.error());
      return outcome;
    }
    const auto world = world_of(*asked);
    run::OnBoard on_board(asked->configuration.for_kernel());
    run::Journey journey(*world, run::Journey::Keep::measures);
    std::string outputs;
    do {
      sim::CycleInputs& inputs = world->advance();
      const run::Truth truth{world->front_m(), world->radio().deliveries().size()};
      const kernel::Outputs& out = on_board.step(inputs.view());
      world->observe(out);
      journey.record(inputs, out, truth);
      if (hashed_) io::append_output(outputs, inputs.t_ms, out);
    } while (!world->finished());
    const ordered_json summary = run::summary_of(journey, *world, *asked->line, on_board, hashed_ ? &outputs : nullptr);
    for (std::size_t i = 0; i < measures_.size(); ++i) outcome.measures[i] = value_of(leaf(summary, measures_[i]));
    if (const auto fault = run::fault_of("", *world, journey)) outcome.error = reason_of(*fault);
    return outcome;
  }

  io::Result<bool> record(const std::vector<Json>& values, const std::string& folder) const override {
    auto asked = io::guarded([&] { return read_case(values); });
    if (!asked) return tl::unexpected(asked.error());
    asked->configuration.document = configuration_document(*asked, values);
    const auto world = world_of(*asked);
    run::OnBoard on_board(asked->configuration.for_kernel(), run::OnBoard::Costs::kept);
    run::Journey journey(*world);
    run::DisplayLists displays;
    run::Recorder recorder(*world, journey, asked->configuration, &displays);
    run::drive(*world, on_board, recorder);
    const run::Records& records = recorder.records();
    const ordered_json summary = run::summary_of(journey, *world, *asked->line, on_board, &records.outputs);
    const std::string driver = run::kDriverNames[static_cast<std::size_t>(asked->settings.driver)];
    return run::write_records(folder, records, summary,
                              run::report_page(journey, *world, *asked->line, asked->configuration.train.name, driver,
                                               summary.dump(), displays));
  }

 private:
  /// `base` with its files read in place, and what it leaves out.
  void load(const Spec& spec) {
    const Json given{{"base", spec.base}};
    JsonPlace(given, spec.file)["base"].know_only(
        {"line", "train", "national_values", "driver", "srs", "seed", "last_ma", "odometer"});
    document_ = {{"line", "brunnental"},
                 {"train", {{"schema", "etcs-train/1"}}},
                 {"national_values", Json::object()},
                 {"driver", "perfect"},
                 {"srs", "3.6.0"},
                 {"seed", 1},
                 {"last_ma", nullptr},
                 {"odometer", {{"error", nullptr}}}};
    document_.update(spec.base);
    if (document_["odometer"].is_object() && !document_["odometer"].contains("error"))
      document_["odometer"]["error"] = nullptr;
    const Json whole{{"base", document_}};
    const JsonPlace base = JsonPlace(whole, spec.file)["base"];
    const auto in_place = [&](const File& file) { return io::put_named(document_, file.member, file.folder, base); };
    line_file_ = in_place(kFiles[0]);
    train_file_ = in_place(kFiles[1]);
    values_file_ = in_place(kFiles[2]);
    read_scalars(base, spec);
  }

  /// The document of a case; of a line that is named the name alone.
  Json document_of(const std::vector<Json>& values) const {
    Json document = document_;
    places_.put(document, values);
    for (const char* member : {"train", "national_values"}) put_document(document, member, named_);
    return document;
  }

  std::shared_ptr<const sim::Line> line_of(const JsonPlace& place) const {
    if (place.is_string()) return lines_.at(place.string());
    return std::make_shared<const sim::Line>(io::read_line(place));
  }

  /// What `base` itself gives and no entry replaces must be readable.
  static void read_scalars(const JsonPlace& root, const Spec& spec) {
    const auto varied = [&](const std::string& member) {
      return std::any_of(spec.vary.begin(), spec.vary.end(),
                         [&](const Entry& entry) { return io::tokens_of(entry.at).front() == member; });
    };
    if (!varied("srs")) (void)io::read_srs_version(root["srs"]);
    if (!varied("driver")) (void)read_driver(root["driver"]);
    if (!varied("seed")) (void)read_seed(root["seed"]);
    if (!varied("last_ma")) (void)read_last_ma(root["last_ma"]);
    if (!varied("odometer")) (void)read_odometer(root["odometer"]);
  }

  /// One member of the case.
  static void read_member(const std::string& member, const JsonPlace& root) {
    if (member == "line") {
      (void)io::read_line(root["line"]);
    } else if (member == "train") {
      (void)io::read_train(root["train"]);
    } else if (member == "national_values") {
      (void)io::read_national_values(root["national_values"]);
    } else if (member == "srs") {
      (void)io::read_srs_version(root["srs"]);
    } else {
      (void)read_settings(root);
    }
  }

  /// All but the line.
  static void read_small(const JsonPlace& root) {
    (void)read_settings(root);
    (void)io::read_national_values(root["national_values"]);
    (void)io::read_train(root["train"]);
  }

  Asked read_case(const std::vector<Json>& values) const {
    const Json document = document_of(values);
    const JsonPlace root(document, "");
    Asked asked;
    asked.settings = read_settings(root);
    asked.configuration.srs = io::read_srs_version(root["srs"]);
    asked.configuration.train = train_ ? *train_ : io::read_train(root["train"]);
    asked.configuration.national_values =
        national_values_ ? *national_values_ : io::read_national_values(root["national_values"]);
    asked.line = line_ ? line_ : line_of(root["line"]);
    return asked;
  }

  /// The configuration of the case for `inputs.jsonl`, so that `evc replay` gives its outputs.
  std::string configuration_document(const Asked& asked, const std::vector<Json>& values) const {
    const Json document = document_of(values);
    Json configuration = io::parse_json(io::configuration_document(asked.configuration), "");
    configuration["national_values"] = document.at("national_values");
    return configuration.dump();
  }

  static std::unique_ptr<sim::World> world_of(const Asked& asked) {
    const io::Train& train = asked.configuration.train;
    return std::make_unique<sim::World>(*asked.line, train.data, train.dynamics, asked.settings);
  }

  /// All that the summary of a journey has.
  void choose_measures(const Spec& spec) {
    const sim::Line line;
    const io::Train train;
    const sim::World world(line, train.data, train.dynamics, {});
    const run::Journey journey(world);
    const run::OnBoard on_board{kernel::Config{}};
    const std::string none;
    std::vector<std::string> all;
    append_leaves(all, run::summary_of(journey, world, line, on_board, &none), "");
    measures_ = chosen(spec, all,
                       [&](const std::string& name) { return std::find(all.begin(), all.end(), name) != all.end(); });
    hashed_ = std::find(measures_.begin(), measures_.end(), "output_hash") != measures_.end();
  }

  Json document_;
  std::string line_file_, train_file_, values_file_, documents_;
  Places places_;
  std::shared_ptr<const sim::Line> line_;
  std::optional<io::Train> train_;
  std::optional<train::NationalValues> national_values_;
  NamedDocuments named_;
  std::map<std::string, std::shared_ptr<const sim::Line>> lines_;
  bool hashed_ = false;
};

}  // namespace

std::unique_ptr<Work> make_run_work(const Spec& spec) { return std::make_unique<RunWork>(spec); }

}  // namespace evc::sweep
