#include "screen/command.h"
#include "screen/player.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <memory>
#include <string_view>
#include <utility>

#include "io/file.h"
#include "io/input_stream.h"
#include "paint/png.h"
#include "paint/svg.h"
#include "run/drive.h"
#include "run/journey.h"
#include "run/load.h"
#include "run/on_board.h"
#include "run/stream.h"
#include "screen/cases.h"
#include "screen/screen_json.h"
#include "sim/world.h"

namespace evc::screen {
namespace {

using io::complain;

bool ends_with(std::string_view text, std::string_view end) {
  return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

Duration seconds(std::int64_t ms) { return Duration{static_cast<double>(ms) / 1000.0}; }

/// The inputs of a journey along the shipped line, as `evc run` records them.
io::Result<io::InputStream> shipped_journey() {
  const auto line = run::load_line("");
  if (!line) return tl::unexpected(line.error());
  const auto train = run::load_train("");
  if (!train) return tl::unexpected(train.error());
  io::Configuration configuration;
  configuration.train = *train;
  configuration.document = io::configuration_document(configuration);
  const sim::World::Settings settings;
  const auto world = std::make_unique<sim::World>(*line, train->data, train->dynamics, settings);
  run::OnBoard on_board(configuration.for_kernel());
  run::Journey journey(*world);
  run::Recorder recorder(*world, journey, configuration);
  run::drive(*world, on_board, recorder);
  return io::InputStream::open(run::line_file(""), io::lines_of(std::move(recorder.records().inputs)));
}

/// What the driver did on the display, added to the inputs of a cycle.
void add_actions(port::DriverActions& to, const port::DriverActions& done) {
  for (unsigned n = 0; n < static_cast<unsigned>(port::Select::count); ++n)
    if (((done.selected >> n) & 1u) != 0) to.selected = port::with_selection(to.selected, 1u << n);
  to.acknowledged |= done.acknowledged;
  if (done.acknowledged_text != 0) to.acknowledged_text = done.acknowledged_text;
  const auto take = [](auto& field, const auto& entered) {
    if (entered) field = entered;
  };
  take(to.driver_id, done.driver_id);
  take(to.level, done.level);
  if (done.level) to.nid_ntc = done.nid_ntc;
  take(to.train_running_number, done.train_running_number);
  take(to.rbc_contact, done.rbc_contact);
  take(to.cover, done.cover);
  take(to.network, done.network);
  take(to.V_sr, done.V_sr);
  take(to.D_sr, done.D_sr);
  take(to.set_speed, done.set_speed);
  take(to.language, done.language);
}

/// The unit with its display, cycle by cycle.
class Replay {
 public:
  Replay(io::InputStream& stream, const Options& options)
      : stream_(stream), options_(options), on_board_(stream.configuration().for_kernel()) {
    presses_ = options.presses;
    std::stable_sort(presses_.begin(), presses_.end(), [](const Press& a, const Press& b) { return a.ms < b.ms; });
  }

  /// Runs to the moment. The error of the stream; else whether every press hit something.
  io::Result<bool> run() {
    sim::CycleInputs cycle;
    bool before = false;
    for (;;) {
      const auto more = stream_.next(cycle);
      if (!more) return more;
      if (!*more || (options_.at_ms && cycle.t_ms > *options_.at_ms)) break;
      if (before && !touch_until(cycle.t_ms)) return false;
      step(cycle);
      last_ms_ = cycle.t_ms;
      before = true;
    }
    // Behind the last cycle there is nothing to see.
    const std::int64_t cycle_ms = stream_.configuration().cycle_ms;
    const std::int64_t at = options_.at_ms.value_or(last_ms_);
    if (!before || at >= last_ms_ + cycle_ms)
      return tl::unexpected(io::Diagnostic{options_.input.empty() ? "the shipped line" : options_.input, "",
                                           fmt::format("a journey that ends at {} s", seconds(last_ms_).si),
                                           fmt::format("a cycle at {} s", seconds(at).si)});
    if (!touch_until(at + 1)) return false;
    if (next_ < presses_.size())
      return tl::unexpected(io::Diagnostic{"evc dmi", "--press",
                                           fmt::format("a press at {} s", seconds(presses_[next_].ms).si),
                                           fmt::format("one up to {} s", seconds(at).si)});
    dmi::draw(*state_, seconds(at), *screen_);
    return true;
  }
  const dmi::Screen& screen() const { return *screen_; }
  /// With `run` false: the press that hit nothing.
  const Press& missed() const { return presses_[next_]; }

 private:
  void step(sim::CycleInputs& cycle) {
    const dmi::Commands done = dmi::take(*state_);
    const Set<port::Window> windows = cycle.levels.windows;
    add_actions(cycle.levels.driver, done.actions);
    cycle.levels.windows |= done.windows;
    if (done.train_data) {
      const train::TrainData& before = train_ ? *train_ : stream_.configuration().train.data;
      train_ = dmi::with_entered(before, *done.train_data);
      cycle.train_data = *train_;
    }
    on_board_.step(cycle.view());
    cycle.levels.windows = windows;
    dmi::show(*state_, on_board_.show());
  }

  /// The finger's touches and releases before this time; false: a press hits nothing.
  bool touch_until(std::int64_t ms) {
    for (;;) {
      const bool release_due = release_ms_ && *release_ms_ < ms;
      const bool press_due = next_ < presses_.size() && presses_[next_].ms < ms;
      if (!release_due && !press_due) return true;
      if (release_due && (!press_due || *release_ms_ <= presses_[next_].ms)) {
        dmi::release(*state_, seconds(*release_ms_));
        release_ms_.reset();
        continue;
      }
      const Press& press = presses_[next_];
      if (!dmi::press(*state_, press.at, seconds(press.ms))) return false;
      const bool delayed = state_->pressed.target.type == dmi::ButtonType::delay;
      release_ms_ = press.ms + (delayed ? kDelayed : kTap);
      ++next_;
    }
  }

  io::InputStream& stream_;
  const Options& options_;
  run::OnBoard on_board_;
  std::unique_ptr<dmi::State> state_ = std::make_unique<dmi::State>();
  std::unique_ptr<dmi::Screen> screen_ = std::make_unique<dmi::Screen>();
  std::vector<Press> presses_;
  std::size_t next_ = 0;
  std::optional<std::int64_t> release_ms_;
  std::optional<train::TrainData> train_;
  std::int64_t last_ms_ = 0;
};

std::string document_of(const dmi::Screen& screen, const std::string& file) {
  constexpr int pixels = 2;  // of a cell
  if (ends_with(file, ".svg")) return paint::svg_of(screen);
  if (ends_with(file, ".png")) return paint::png_of(screen, pixels);
  return screen_json(screen);
}

}  // namespace

std::optional<Press> press_of(const std::string& text) {
  const char *at = text.data(), *end = text.data() + text.size();
  const auto take = [&](auto& number) {
    const auto [stop, error] = std::from_chars(at, end, number);
    const bool taken = error == std::errc{} && stop != at;
    at = stop;
    return taken;
  };
  const auto skip = [&](char c) { return at != end && *at++ == c; };
  constexpr dmi::Rect screen = dmi::rect_of(dmi::Area::screen);
  constexpr double longest = 1e9;  // s
  Press press;
  double when = 0.0;
  if (!take(press.at.x) || !skip(',') || !take(press.at.y) || !skip('@') || !take(when) || at != end)
    return std::nullopt;
  if (!dmi::inside(screen, press.at.x, press.at.y) || !(when >= 0.0) || !(when <= longest)) return std::nullopt;
  press.ms = static_cast<std::int64_t>(when * 1000.0 + 0.5);
  return press;
}

int show(const Options& options) {
  if (!options.cases.empty()) return cases(options.cases, options.output);
  const bool known = options.output == "-" || ends_with(options.output, ".svg") || ends_with(options.output, ".png") ||
                     ends_with(options.output, ".json");
  if (!known) return complain({"evc dmi", "-o", options.output, "a file named .svg, .png or .json"});
  for (const std::string& input : {options.input, options.config})
    if (const auto apart = io::not_the_input(input, options.output); !apart) return complain(apart.error());
  auto stream = options.input.empty() ? shipped_journey() : run::open_stream(options.input, options.config);
  if (!stream) return complain(stream.error());
  Replay replay(*stream, options);
  const auto hit = replay.run();
  if (!hit) return complain(options.input.empty() ? hit.error() : run::of_stream(hit.error(), options.input));
  if (!*hit) {
    const Press& missed = replay.missed();
    (void)complain(
        {"evc dmi", "--press",
         fmt::format("nothing to touch at {},{} after {} s", missed.at.x, missed.at.y, seconds(missed.ms).si),
         "a place that `touch` of the display list names, and enabled"});
    return 1;
  }
  const auto written = io::write_whole(options.output, document_of(replay.screen(), options.output));
  return written ? 0 : complain(written.error());
}

}  // namespace evc::screen
