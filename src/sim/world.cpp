#include "sim/world.h"

#include <algorithm>
#include <cmath>

namespace evc::sim {
namespace {

constexpr int kStepsPerCycle = 10;
constexpr double kStandardRotating = 6.0;           // % of the mass where the train data give none
constexpr std::int64_t kStandsForGood_ms = 90'000;  // no movement and nothing to come
constexpr std::int64_t kLongest_ms = 6LL * 3600'000;

double last_group(const Line& line) { return line.balises.empty() ? line.length_m : line.balises.back().position_m; }

}  // namespace

World::World(const Line& line, const train::TrainData& train, const Dynamics& dynamics, const Settings& settings)
    : line_(line),
      train_(train),
      settings_(settings),
      random_(settings.seed),
      heights_(line.gradient),
      motion_(dynamics, train.L_TRAIN.si, train.M_rotating_nom.value_or(kStandardRotating), heights_,
              line.start_front_m, settings.adhesion_mps2),
      odometer_(settings.odometer, random_),
      radio_(line, settings.last_ma, random_),
      driver_(settings.driver, line, train),
      start_m_(line.start_front_m),
      end_m_(line.end_m.value_or(last_group(line) + train.L_TRAIN.si)) {
  stood_at_m_ = start_m_;
  // The national systems of the train: those at the start, and those of the NTC levels of the line.
  inputs_.levels.national_system.available = line.start_nid_ntc < 64 ? std::uint64_t{1} << line.start_nid_ntc : 0;
}

CycleInputs& World::advance() {
  inputs_.clear();
  return advance_further();
}

CycleInputs& World::advance_further() {
  if (first_)
    inputs_.levels.utc = settings_.utc;
  else
    move_one_cycle();
  first_ = false;
  inputs_.levels.odometry = odometer_.read(motion_.speed());
  radio_.deliver(inputs_.t_ms, motion_.front(), inputs_);
  if (settings_.by_hand) {
    inputs_.levels.train.desk_open = desk_.open;
    inputs_.levels.train.direction_controller = desk_.direction;
  } else {
    driver_.act(seen_, inputs_.t_ms, inputs_);
  }
  return inputs_;
}

void World::move_one_cycle() {
  inputs_.t_ms += settings_.cycle_ms;
  const double cycle_s = static_cast<double>(settings_.cycle_ms) / 1000.0;
  const double step_s = cycle_s / kStepsPerCycle;
  Handle handle = settings_.by_hand ? handle_of(desk_) : driver_.handle(seen_, motion_, cycle_s);
  handle.cut_off = seen_.tco;
  handle.service = seen_.sb;
  handle.emergency = handle.emergency || seen_.eb;
  inputs_.levels.train.service_brake_feedback = train_.service_brake_feedback && seen_.sb;
  for (int i = 0; i < kStepsPerCycle; ++i) {
    const double before = motion_.front();
    const double nominal_before = odometer_.nominal_after(0.0);
    motion_.move(handle, step_s);
    odometer_.move(motion_.front() - before, step_s);
    odometer_.accelerate(motion_.acceleration(), step_s);
    const double antenna = train_.L_antenna_front.si;
    read_balises(before - antenna, motion_.front() - antenna, nominal_before, odometer_.nominal_after(0.0));
  }
  if (std::abs(motion_.front() - stood_at_m_) > 1.0) {
    stood_at_m_ = motion_.front();
    moved_at_ms_ = inputs_.t_ms;
  }
}

void World::read_balises(double antenna_before, double antenna_after, double nominal_before, double nominal_after) {
  if (antenna_before == antenna_after) return;
  const bool forwards = antenna_after > antenna_before;
  const double low = std::min(antenna_before, antenna_after);
  const double high = std::max(antenna_before, antenna_after);
  const auto& balises = line_.balises;
  const auto place_after = [](double x, const Balise& b) { return x < b.position_m; };
  auto first = std::upper_bound(balises.begin(), balises.end(), low, place_after);
  auto last = std::upper_bound(first, balises.end(), high, place_after);
  std::vector<const Balise*> passed;
  for (auto it = first; it != last; ++it) passed.push_back(&*it);
  if (!forwards) std::reverse(passed.begin(), passed.end());
  for (const Balise* b : passed) {
    const double share = (b->position_m - antenna_before) / (antenna_after - antenna_before);
    const double nominal = nominal_before + share * (nominal_after - nominal_before);
    CycleInputs::Telegram t{b->telegram, {{std::nearbyint(nominal * 1e3) / 1e3 + 0.0}}};
    inputs_.balises.push_back(std::move(t));
    ++telegrams_read_;
    // Header: Q_UPDOWN 1, M_VERSION 7, Q_MEDIA 1, N_PIG 3, N_TOTAL 3, M_DUP 2, M_MCOUNT 8, NID_C 10, NID_BG 14.
    const Passing passing{static_cast<std::uint16_t>(b->telegram.number(25, 10)),
                          static_cast<std::uint16_t>(b->telegram.number(35, 14)), b->position_m, nominal, b->group};
    const bool reference = b->telegram.number(9, 3) == 0;
    if (passings_.empty() || passings_.back().group != b->group)
      passings_.push_back(passing);
    else if (reference)
      passings_.back() = passing;
  }
}

void World::observe(const port::Outputs& outputs) {
  seen_ = Seen(outputs);
  radio_.hear(outputs, inputs_.t_ms);
}

std::optional<World::Ending> World::ending() const {
  if (motion_.front() >= end_m_) return Ending::end_of_line;
  if (inputs_.t_ms >= kLongest_ms) return Ending::too_long;
  if (!settings_.by_hand && inputs_.t_ms - moved_at_ms_ > kStandsForGood_ms && radio_.waiting() == 0)
    return Ending::stands_for_good;
  return std::nullopt;
}

std::optional<World::Reference> World::reference(const port::NidLrbg& lrbg) const {
  for (auto it = passings_.rbegin(); it != passings_.rend(); ++it)
    if (it->NID_C == lrbg.NID_C && it->NID_BG == lrbg.NID_BG)
      return Reference{it->position_m, it->nominal_m - train_.L_antenna_front.si};
  return std::nullopt;
}

}  // namespace evc::sim
