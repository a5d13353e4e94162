#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "check/rules.h"
#include "io/input_stream.h"
#include "run/on_board.h"
#include "sim/world.h"

namespace evc::check {
namespace {

using enum Severity;

/// More than the permitted speed falls in a cycle along a braking curve.
constexpr Speed kLowered{3.0 / 3.6};

/// The train runs at the permitted speed: what lowers the limits below its speed came too late.
class Watch {
 public:
  Watch(const Trackside& trackside, const sim::World& world, Findings& out)
      : trackside_(trackside), world_(world), out_(out) {}

  void look(const port::Outputs& o) {
    note_received();
    const bool too_fast = o.status >= Status::Warning && o.V_P && o.mode != Mode::TR && o.mode != Mode::PT;
    // In one cycle, and not because the unit brakes already.
    const bool lowered = before_.V_P && o.V_P && *before_.V_P - *o.V_P > kLowered && !before_.braking;
    before_ = {o.V_P, o.sb || o.eb};
    if (!too_fast) return end();
    if (!late_ && lowered) late_ = text(o);
    intervention_ = intervention_ || o.status == Status::Intervention;
  }
  void end() {
    if (late_ && received_) out_.add(intervention_ ? error : warning, *received_, "3.13.1.1"_srs, *late_);
    late_.reset();
    intervention_ = false;
  }

 private:
  /// The last group or message of the line before now.
  void note_received() {
    if (const auto& passings = world_.passings(); !passings.empty() && passings.back().group != group_) {
      group_ = passings.back().group;
      for (const Group& group : trackside_.groups)
        if (group.index == group_ && !late_) received_ = group.where();
    }
    const auto& deliveries = world_.radio().deliveries();
    for (; next_ < deliveries.size(); ++next_)
      for (const Message& message : trackside_.messages)
        if (message.sent->seq == deliveries[next_].seq && !late_) received_ = message.where();
  }
  std::string text(const port::Outputs& o) const {
    const auto kmh = [](Speed v) { return v.si * 3.6; };
    std::string s =
        fmt::format("it reaches the train too late to brake: at {:.1f} m it runs {:.1f} km/h, permitted are {:.1f}",
                    world_.front_m(), kmh(o.v), kmh(*o.V_P));
    if (o.V_target && o.d_target)
      s += fmt::format("; target {:.0f} km/h in {:.0f} m", kmh(*o.V_target), o.d_target->si);
    return s;
  }

  struct Before {
    std::optional<Speed> V_P;
    bool braking = false;
  };

  const Trackside& trackside_;
  const sim::World& world_;
  Findings& out_;
  Before before_;
  std::optional<std::size_t> group_;
  std::size_t next_ = 0;
  std::optional<Where> received_;
  std::optional<std::string> late_;
  bool intervention_ = false;
};

}  // namespace

void check_braking(const Trackside& trackside, const io::Train& train, Findings& out) {
  io::Configuration configuration;
  configuration.train = train;
  const auto world = std::make_unique<sim::World>(*trackside.line, train.data, train.dynamics, sim::World::Settings{});
  run::OnBoard on_board(configuration.for_kernel());
  Watch watch(trackside, *world, out);
  do {
    const port::Outputs& outputs = on_board.step(world->advance().view());
    world->observe(outputs);
    watch.look(outputs);
  } while (!world->finished());
  watch.end();
  using Ending = sim::World::Ending;
  if (world->ending() != Ending::end_of_line)
    out.add(note, {world->front_m(), {}, {}}, "docs/check.md",
            "the train stops here: what is ahead was not checked with it");
}

}  // namespace evc::check
