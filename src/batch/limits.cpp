#include "batch/limits.h"

#include <algorithm>
#include <bit>
#include <limits>

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
    for (double* const one : out_)
      if (one != nullptr) one[i] = std::numeric_limits<double>::quiet_NaN();
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
    if (out_[which] != nullptr && place.from_origin.si > -1e8) out_[which][at_] = (location_ - place).si;
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

/// A block that is filled case by case.
class Filling {
 public:
  Filling(const Trains::Tables& tables, const Pointers& wanted) {
    block_.numbers = tables.numbers.data();
    for (std::size_t k = 0; k < kOutputs; ++k) block_.out[k] = wanted[k] != nullptr ? results_[k].data() : nullptr;
  }

  bool full() const { return block_.size == Block::kMost; }

  /// Case `i` of the caller.
  void add(const TrainEntry& train, const Target& t, double speed, std::size_t i) {
    const std::size_t k = block_.size++;
    const bool EOA = t.kind == sdm::TargetKind::EOA_SvL;
    const bool at_speed = t.kind == sdm::TargetKind::MRSP || t.kind == sdm::TargetKind::LOA;
    // As sdm::rebuild makes it: the others end with a stop.
    const Speed V_target = at_speed ? t.V_target : Speed{};
    const bool zero = V_target.si <= 0.0;
    const bool TSR = t.kind == sdm::TargetKind::MRSP && t.due_to_TSR;
    const Place d_target = EOA ? t.SvL : t.location;
    number_[k] = i;
    block_.values[k] = train.values;
    block_.times[k] = train.values + kTimesZero + (zero ? std::int64_t{0} : std::int64_t{kTimesValues});
    block_.segments[k] = TSR ? train.TSR : train.segments;
    block_.count[k] = TSR ? train.count_TSR : train.count;
    block_.V[k] = speed;
    block_.V_target[k] = V_target.si;
    block_.location[k] = t.location.from_origin.si;
    block_.d_target[k] = d_target.from_origin.si;
    const Speed V_anchor = at_speed ? V_target + sdm::dV_ebi(V_target, train.fixed) : Speed{};
    block_.anchor_squared[k] = (V_anchor * V_anchor).si;
    block_.has_SBD[k] = EOA ? 1.0 : 0.0;
    block_.has_GUI[k] = train.guidance ? 1.0 : 0.0;
    block_.V_foot[k] = 0.0;
    if (train.guidance) block_.V_foot[k] = (V_target + (train.Q_NVINHSMICPERM ? Speed{0.0} : train::f41(V_target))).si;
    block_.left_out[k] = 0.0;
    alike_ = alike_ && block_.times[k] == block_.times[0] && block_.segments[k] == block_.segments[0];
    looked_up_ = looked_up_ && train.looked_up;
    at_speed_ = at_speed_ || at_speed;
    guided_ = guided_ || train.guidance;
    segments_ = std::max({segments_, train.count, train.count_TSR});
  }

  void compute(const Pointers& out) {
    if (block_.size == 0) return;
    const std::size_t whole = block_.size;
    fill_up();
    block_.alike = alike_;
    block_.looked_up = looked_up_;
    block_.at_speed = at_speed_;
    block_.guided = guided_;
    block_.bisections = static_cast<std::size_t>(std::bit_width(static_cast<std::uint64_t>(segments_)));
    batch::compute(block_);
    block_.size = whole;
    const bool in_a_row = number_[whole - 1] - number_[0] + 1 == whole;
    for (std::size_t k = 0; k < kOutputs; ++k) {
      if (out[k] == nullptr) continue;
      if (in_a_row)
        std::copy_n(results_[k].data(), whole, out[k] + number_[0]);
      else
        for (std::size_t n = 0; n < whole; ++n) out[k][number_[n]] = results_[k][n];
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
    alike_ = looked_up_ = true;
    at_speed_ = guided_ = false;
    segments_ = 1;
  }

 private:
  void fill_up() {
    const std::size_t last = block_.size - 1;
    const std::size_t end = (block_.size + Block::kGroup - 1) / Block::kGroup * Block::kGroup;
    for (auto* const all : {&block_.values, &block_.times, &block_.segments, &block_.count})
      std::fill(all->begin() + static_cast<std::ptrdiff_t>(block_.size),
                all->begin() + static_cast<std::ptrdiff_t>(end), (*all)[last]);
    for (auto* const all : {&block_.V, &block_.V_target, &block_.location, &block_.d_target, &block_.anchor_squared,
                            &block_.has_SBD, &block_.has_GUI, &block_.V_foot, &block_.left_out})
      std::fill(all->begin() + static_cast<std::ptrdiff_t>(block_.size),
                all->begin() + static_cast<std::ptrdiff_t>(end), (*all)[last]);
    block_.size = end;
  }

  Block block_;
  alignas(64) std::array<std::array<double, Block::kMost>, kOutputs> results_;
  std::array<std::size_t, Block::kMost> number_;
  bool alike_ = true, looked_up_ = true, at_speed_ = false, guided_ = false;
  std::int64_t segments_ = 1;
};

}  // namespace

void limits(const Trains& trains, std::span<const Target> targets, const Cases& cases, const LimitsOut& out) {
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
  for (std::size_t i = 0; i < cases.speed.size(); ++i) {
    const TrainEntry& train = tables.trains[train_of(i)];
    if (!train.vectorised) {
      alone(i);
      continue;
    }
    filling->add(train, targets[target_of(i)], cases.speed[i], i);
    if (filling->full()) finish();
  }
  finish();
}

}  // namespace evc::batch
