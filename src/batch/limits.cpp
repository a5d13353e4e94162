#include "batch/limits.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

#include "batch/kernel.h"
#include "batch/tables.h"

namespace evc::batch {
namespace {

using Pointers = std::array<double*, kOutputs>;

/// In the order of Output.
Pointers pointers_of(const LimitsOut& out) {
  Pointers all{};
  std::size_t n = 0;
  for (const std::span<double>& one : {out.EBD, out.SBD, out.GUI, out.EBI, out.SBI1, out.SBI2, out.FLOI, out.W, out.P,
                                       out.I, out.W_EOA, out.P_EOA, out.I_EOA, out.W_SvL, out.P_SvL, out.I_SvL})
    all[n++] = one.empty() ? nullptr : one.data();
  return all;
}

/// Limits by `sdm::explain`, which has no restriction. What was computed for a train and a target serves the next
/// speeds.
class OneByOne {
 public:
  OneByOne(const Trains::Tables& tables, std::span<const Target> targets, const Pointers& out)
      : tables_(tables), targets_(targets), out_(out) {}

  void compute(std::uint32_t train, std::uint32_t target, double speed, std::size_t i) {
    for (double* const one : out_)
      if (one != nullptr) one[i] = std::numeric_limits<double>::quiet_NaN();
    if (std::isnan(speed)) return;
    const Whole& whole = *tables_.trains[train].whole;
    const Target& t = targets_[target];
    if (!derived_ || train_ != train || target_ != target) build(whole, t);
    train_ = train;
    target_ = target;
    const sdm::Target& computed = derived_->targets.back();
    const sdm::Explanation e = sdm::explain(*derived_, inputs_, computed, Speed{speed}, whole.state.V_ura,
                                            whole.state.A_est, whole.state.motion ? &*whole.state.motion : nullptr);
    location_ = t.location;
    at_ = i;
    put(kEBD, e.d_EBD);
    if (e.d_SBD) put(kSBD, *e.d_SBD);
    if (e.d_GUI) put(kGUI, *e.d_GUI);
    put(kEBI, *e.EBD.d_EBI);
    put(kSBI2, e.EBD.d_SBI);
    put(kFLOI, e.d_FLOI);
    put(kW, e.d_W);
    put(kP, e.d_P);
    put(kI, e.d_I);
    put(kW_SvL, e.EBD.d_W);
    put(kP_SvL, e.EBD.d_P);
    put(kI_SvL, e.EBD.d_I);
    if (!e.SBD) return;
    put(kSBI1, e.SBD->d_SBI);
    put(kW_EOA, e.SBD->d_W);
    put(kP_EOA, e.SBD->d_P);
    put(kI_EOA, e.SBD->d_I);
  }

 private:
  /// The target alone, on the track of the train.
  void build(const Whole& whole, const Target& t) {
    inputs_ = whole.in;
    inputs_.authority = {};
    inputs_.SR_end.reset();
    inputs_.mrsp = {};
    inputs_.mrsp_due_to_TSR = {};
    inputs_.supervise_targets = t.kind == sdm::TargetKind::MRSP;
    sdm::Authority& a = inputs_.authority;
    bool known = inputs_.mrsp.append({{-2.0 * kNowhere}}, t.V_target + Speed{1.0});
    switch (t.kind) {
      case sdm::TargetKind::MRSP:
        known = inputs_.mrsp.append(t.location, t.V_target) && known;
        inputs_.mrsp_due_to_TSR[1] = t.due_to_TSR;
        break;
      case sdm::TargetKind::LOA:
        a.kind = sdm::Authority::Kind::LOA;
        a.EOA = t.location;
        a.V_LOA = t.V_target;
        break;
      case sdm::TargetKind::EOA_SvL:
        a.kind = sdm::Authority::Kind::EOA_SvL;
        a.EOA = t.location;
        a.SvL = t.SvL;
        break;
      case sdm::TargetKind::SR_end:
        inputs_.SR_end = t.location;
        break;
    }
    EVC_REQUIRE(known);
    if (!derived_) derived_ = std::make_unique<sdm::Derived>();
    derived_->valid = false;
    (void)sdm::rebuild(*derived_, inputs_);
  }

  void put(Output which, Place place) {
    if (out_[which] != nullptr && place.from_origin.si > -kFarthest.si) out_[which][at_] = (location_ - place).si;
  }

  const Trains::Tables& tables_;
  std::span<const Target> targets_;
  Pointers out_;
  std::unique_ptr<sdm::Derived> derived_;
  sdm::Inputs inputs_;
  std::uint32_t train_ = 0, target_ = 0;
  Place location_{};
  std::size_t at_ = 0;
};

bool has_speed(const Target& t) { return t.kind == sdm::TargetKind::MRSP || t.kind == sdm::TargetKind::LOA; }

/// As sdm::rebuild makes it: the others end with a stop.
Speed V_target_of(const Target& t) { return has_speed(t) ? t.V_target : Speed{}; }

/// Whether a build-up time may be reduced (A.3.12 of 4.0.0): then the limits depend on the track ahead.
bool may_be_reduced(const TrainEntry& train, const Target& t, double speed) {
  const double V_target = V_target_of(t).si;
  return speed <= V_target + train.full_above[V_target > 0.0 ? 1 : 0];
}

/// A block that is filled case by case.
class Filling {
 public:
  Filling(const Trains::Tables& tables, const Pointers& wanted) {
    block_.numbers = tables.numbers.data();
    group_ = group();
    block_.bisections = static_cast<std::size_t>(std::bit_width(tables.most_segments));
    block_.V_foot.fill(0.0);
    for (std::size_t k = 0; k < kOutputs; ++k) block_.out[k] = wanted[k] != nullptr ? results_[k].data() : nullptr;
  }

  /// Adds case `i` of the caller; false: there is no room.
  bool add(const TrainEntry& train, const Target& t, double speed, std::size_t i) {
    const bool EOA = t.kind == sdm::TargetKind::EOA_SvL;
    const bool at_speed = has_speed(t);
    const Speed V_target = V_target_of(t);
    const bool TSR = t.kind == sdm::TargetKind::MRSP && t.due_to_TSR;
    const std::int64_t values = train.values + class_of_targets(V_target.si > 0.0, TSR);
    go_on_with(values);
    if (block_.size == Block::kMost) return false;
    const std::size_t k = block_.size++;
    if (used_ == 0) block_.alike[k / group_] = true;
    if (++used_ == group_) used_ = 0;
    number_[k] = i;
    block_.values[k] = values;
    block_.V[k] = speed;
    block_.V_target[k] = V_target.si;
    block_.location[k] = t.location.from_origin.si;
    block_.d_target[k] = (EOA ? t.SvL : t.location).from_origin.si;
    const Speed V_anchor = at_speed ? V_target + sdm::dV_ebi(V_target, train.fixed) : Speed{};
    block_.anchor_squared[k] = (V_anchor * V_anchor).si;
    block_.has_SBD[k] = EOA ? 1.0 : 0.0;
    if (train.guidance) block_.V_foot[k] = (V_target + (train.Q_NVINHSMICPERM ? Speed{0.0} : train::f41(V_target))).si;
    at_speed_ = at_speed_ || at_speed;
    guided_ = guided_ || train.guidance;
    return true;
  }

  void compute(const Pointers& out) {
    if (block_.size == 0) return;
    end_group();
    block_.at_speed = at_speed_;
    block_.guided = guided_;
    if (at_speed_) block_.left_out.fill(0.0);
    batch::compute(block_);
    for (std::size_t first = 0; first < block_.size;) {
      // As far as the numbers of the cases are in a row.
      std::size_t end = first + 1;
      while (end < block_.size && number_[end] == number_[end - 1] + 1) ++end;
      for (std::size_t k = 0; k < kOutputs; ++k) {
        if (out[k] == nullptr) continue;
        if (end == first + 1)
          out[k][number_[first]] = results_[k][first];
        else
          std::copy_n(results_[k].data() + first, end - first, out[k] + number_[first]);
      }
      first = end;
    }
  }

  /// Calls `again(i)` for each case that the kernel left out.
  template <class F>
  void left_out(F again) const {
    if (!at_speed_) return;
    for (std::size_t n = 0; n < block_.size; ++n)
      if (block_.left_out[n] > 0.5) again(number_[n]);
  }

  void clear() {
    block_.size = 0;
    at_speed_ = guided_ = false;
  }

 private:
  /// A group of one train and class of targets is faster, so another train begins a new one: where the rest that stays
  /// empty is no more than half of the group or a fifth of what the train needs.
  void go_on_with(std::int64_t values) {
    ++alike_;
    if (values == values_) return;
    values_ = values;
    const std::size_t alike = std::exchange(alike_, 1);
    if (used_ == 0) return;
    bool& only = block_.alike[block_.size / group_];
    if (only && (used_ >= group_ / 2 || alike > 4 * group_))
      end_group();
    else
      only = false;
  }

  /// Repeats the last case until the group is full.
  void end_group() {
    const std::size_t size = block_.size;
    const std::size_t end = (size + group_ - 1) / group_ * group_;
    const auto repeat = [&](auto& all) { std::fill(all.begin() + size, all.begin() + end, all[size - 1]); };
    repeat(number_);
    repeat(block_.values);
    for (auto* all : {&block_.V, &block_.V_target, &block_.location, &block_.d_target, &block_.anchor_squared,
                      &block_.has_SBD, &block_.V_foot})
      repeat(*all);
    block_.size = end;
    used_ = 0;
  }

  Block block_;
  alignas(64) std::array<std::array<double, Block::kMost>, kOutputs> results_;
  std::array<std::size_t, Block::kMost> number_;
  std::size_t group_ = 0;
  std::size_t used_ = 0;      // of the group that is not full
  std::int64_t values_ = -1;  // of the last case
  std::size_t alike_ = 0;     // so many of the last cases have the same ones
  bool at_speed_ = false, guided_ = false;
};

/// Brings together the cases of each train, where trains come in turn and there are enough cases of each one.
class ByTrain {
 public:
  static constexpr std::size_t kMost = 16384;  // so many results stay in the cache
  static constexpr std::size_t kEnough = 24;   // cases of a train on average

  explicit ByTrain(std::size_t trains) : trains_(trains), worth_it_(group() >= 16) {}

  /// False: the order may stay as it is.
  bool sort(std::span<const std::uint32_t> train) {
    if (!worth_it_ || train.size() < trains_ * kEnough) return false;
    std::size_t changes = 0;
    for (std::size_t i = 1; i < train.size(); ++i) changes += train[i] != train[i - 1] ? 1u : 0u;
    if (changes < 2 * trains_) return false;
    // By counting: where the cases of each train begin.
    begin_.assign(trains_ + 1, 0);
    for (const std::uint32_t t : train) ++begin_[t + 1];
    for (std::size_t t = 0; t < trains_; ++t) begin_[t + 1] += begin_[t];
    order_.resize(train.size());
    for (std::size_t i = 0; i < train.size(); ++i) order_[begin_[train[i]]++] = static_cast<std::uint32_t>(i);
    return true;
  }
  const std::vector<std::uint32_t>& order() const { return order_; }

 private:
  std::size_t trains_;
  bool worth_it_;  // narrow vectors load their lanes from different places in about the same time
  std::vector<std::uint32_t> begin_, order_;
};

}  // namespace

bool in_range(const Target& target) {
  const auto known = [](Place place) { return std::abs(place.from_origin.si) <= kFarthest.si; };  // no NaN either
  return known(target.location) && (target.kind != sdm::TargetKind::EOA_SvL || known(target.SvL));
}

void limits(const Trains& trains, std::span<const Target> targets, const Cases& cases, const LimitsOut& out) {
  // Beyond the end of every track, segments would have no border, and arcs no end.
  EVC_REQUIRE(std::all_of(targets.begin(), targets.end(), in_range));
  const Trains::Tables& tables = trains.tables();
  const Pointers pointers = pointers_of(out);
  const auto filling = std::make_unique<Filling>(tables, pointers);
  OneByOne one_by_one(tables, targets, pointers);
  const auto train_of = [&](std::size_t i) { return cases.train.empty() ? 0u : cases.train[i]; };
  const auto target_of = [&](std::size_t i) { return cases.target.empty() ? 0u : cases.target[i]; };
  const auto alone = [&](std::size_t i) { one_by_one.compute(train_of(i), target_of(i), cases.speed[i], i); };
  const auto finish = [&] {
    filling->compute(pointers);
    filling->left_out(alone);
    filling->clear();
  };
  ByTrain by_train(tables.trains.size());
  std::vector<std::size_t> lonely;
  for (std::size_t first = 0; first < cases.speed.size(); first += ByTrain::kMost) {
    const std::size_t n = std::min(cases.speed.size() - first, ByTrain::kMost);
    const bool sorted = !cases.train.empty() && by_train.sort(cases.train.subspan(first, n));
    for (std::size_t j = 0; j < n; ++j) {
      const std::size_t i = first + (sorted ? by_train.order()[j] : j);
      const TrainEntry& train = tables.trains[train_of(i)];
      const Target& target = targets[target_of(i)];
      if (!train.vectorised || may_be_reduced(train, target, cases.speed[i]))
        lonely.push_back(i);
      else
        while (!filling->add(train, target, cases.speed[i], i)) finish();
    }
    // Those of a train and target share what is computed first.
    std::sort(lonely.begin(), lonely.end(), [&](std::size_t a, std::size_t b) {
      return std::tuple(train_of(a), target_of(a), a) < std::tuple(train_of(b), target_of(b), b);
    });
    std::for_each(lonely.begin(), lonely.end(), alone);
    lonely.clear();
  }
  finish();
}

}  // namespace evc::batch
