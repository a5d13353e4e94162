#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "io/file.h"
#include "io/input_stream.h"
#include "io/named_document.h"
#include "io/output_lines.h"
#include "run/course.h"
#include "run/on_board.h"
#include "run/sha256.h"
#include "sweep/document.h"
#include "sweep/kinds.h"

namespace evc::sweep {
namespace {

using io::Json;
using io::JsonPlace;

/// The measures of a replay: of the outputs alone, as nobody knows where the train was.
constexpr const char* kMeasures[] = {"duration_s",
                                     "cycles",
                                     "modes",
                                     "levels",
                                     "interventions.tco",
                                     "interventions.sb",
                                     "interventions.eb",
                                     "interventions.trip",
                                     "min_margin_to_EBI_kmh",
                                     "max_speed_kmh",
                                     "output_hash"};

/// What the outputs of a stream were, as the summary of a run has it.
class Measured {
 public:
  void record(std::int64_t t_ms, const kernel::Outputs& o) {
    ++cycles_;
    last_ms_ = t_ms;
    course_.record(o);
    max_speed_kmh_ = std::max(max_speed_kmh_, o.v.si * 3.6);
  }

  Value of(const std::string& measure, const std::string& outputs) const {
    const run::Course::Interventions& interventions = course_.interventions();
    if (measure == "duration_s") return static_cast<double>(last_ms_) / 1000.0;
    if (measure == "cycles") return cycles_;
    if (measure == "modes") return value_of(Json(course_.modes()));
    if (measure == "levels") return value_of(Json(course_.levels()));
    if (measure == "interventions.tco") return std::int64_t{interventions.tco};
    if (measure == "interventions.sb") return std::int64_t{interventions.sb};
    if (measure == "interventions.eb") return std::int64_t{interventions.eb};
    if (measure == "interventions.trip") return std::int64_t{interventions.trip};
    if (measure == "max_speed_kmh") return max_speed_kmh_;
    if (measure == "output_hash") return run::sha256(outputs);
    const auto margin = course_.min_margin_to_EBI_kmh();
    return margin ? Value(*margin) : Value();
  }

 private:
  std::int64_t cycles_ = 0, last_ms_ = 0;
  run::Course course_;
  double max_speed_kmh_ = 0.0;
};

/// Lines of a text that lives as long as the sweep.
io::InputStream::NextLine lines_in(const std::string& text) {
  return [at = std::size_t{0}, &text](std::string& line) mutable {
    if (at >= text.size()) return false;
    const std::size_t end = std::min(text.find('\n', at), text.size());
    line.assign(text, at, end - at);
    at = end + 1;
    return true;
  };
}

class ReplayWork final : public Work {
 public:
  explicit ReplayWork(const Spec& spec) {
    load(spec);
    places_ = places_of(spec, [](const auto& tokens) { return tokens[0] == "inputs"; });
    const auto read = [](const JsonPlace& root) { (void)read_configuration(root.value()); };
    require_places(spec, places_, document_, read, {});
    require_values(
        spec, places_, document_, {}, [&](const std::string&, const JsonPlace& root) { read(root); },
        [](const std::string&) { return Judged::form; });
    const std::vector<std::string> all(std::begin(kMeasures), std::end(kMeasures));
    measures_ = chosen(spec, all,
                       [&](const std::string& name) { return std::find(all.begin(), all.end(), name) != all.end(); });
    hashed_ = std::find(measures_.begin(), measures_.end(), "output_hash") != measures_.end();
  }

  std::string documents() const override { return document_.dump() + run::sha256(text_); }

  Outcome compute(const std::vector<Json>& values, Scratch&) const override {
    Outcome outcome;
    outcome.measures.resize(measures_.size());
    Measured measured;
    std::string outputs;
    const auto replayed = replay(values, [&](std::int64_t t_ms, const kernel::Outputs& out) {
      measured.record(t_ms, out);
      if (hashed_) io::append_output(outputs, t_ms, out);
    });
    if (!replayed) {
      outcome.error = reason_of(replayed.error());
      return outcome;
    }
    for (std::size_t i = 0; i < measures_.size(); ++i) outcome.measures[i] = measured.of(measures_[i], outputs);
    return outcome;
  }

  io::Result<bool> record(const std::vector<Json>& values, const std::string& folder) const override {
    Json document = document_;
    places_.put(document, values);
    const std::string config = document["config"].dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
    if (const auto written = io::write_whole(folder + "/config.json", config); !written) return written;
    if (const auto written = io::write_whole(folder + "/inputs.jsonl", text_); !written) return written;
    std::string outputs;
    const auto replayed =
        replay(values, [&](std::int64_t t_ms, const kernel::Outputs& out) { io::append_output(outputs, t_ms, out); });
    if (!replayed) return replayed;
    return io::write_whole(folder + "/outputs.jsonl", outputs);
  }

 private:
  void load(const Spec& spec) {
    const Json given{{"base", spec.base}};
    const JsonPlace base = JsonPlace(given, spec.file)["base"];
    base.know_only({"inputs"});
    const JsonPlace inputs = base["inputs"];
    if (!inputs.is_string()) inputs.fail("the name of a file (JSON Lines of inputs)");
    io::Named named = io::read_named(inputs, "inputs");
    file_ = named.file;
    text_ = std::move(named.text);
    const Json first = io::parse_json(std::string_view(text_).substr(0, text_.find('\n')), file_, "line 1");
    document_ = {{"config", first.is_object() && first.contains("config") ? first["config"] : Json::object()}};
    // A stream that cannot be read is an error of the sweep, not of each case.
    if (const auto read = replay({}, [](std::int64_t, const kernel::Outputs&) {}); !read)
      throw io::ReadError{read.error()};
  }

  static io::Configuration read_configuration(const Json& document) {
    auto read = io::read_configuration(document.at("config").dump(), "");
    if (!read) {
      read.error().where = "/config" + (read.error().where == "/" ? "" : read.error().where);
      throw io::ReadError{read.error()};
    }
    return *std::move(read);
  }

  template <class Take>
  io::Result<bool> replay(const std::vector<Json>& values, Take take) const {
    auto configuration = io::guarded([&] {
      Json document = document_;
      places_.put(document, values);
      return read_configuration(document);
    });
    if (!configuration) return tl::unexpected(configuration.error());
    auto stream = io::InputStream::open(file_, lines_in(text_), *std::move(configuration));
    if (!stream) return tl::unexpected(stream.error());
    run::OnBoard on_board(stream->configuration().for_kernel());
    sim::CycleInputs cycle;
    for (;;) {
      const auto more = stream->next(cycle);
      if (!more) return more;
      if (!*more) return true;
      take(cycle.t_ms, on_board.step(cycle.view()));
    }
  }

  std::string file_, text_;
  Json document_;
  Places places_;
  bool hashed_ = false;
};

}  // namespace

std::unique_ptr<Work> make_replay_work(const Spec& spec) { return std::make_unique<ReplayWork>(spec); }

}  // namespace evc::sweep
