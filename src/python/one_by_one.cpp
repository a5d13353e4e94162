#include "python/one_by_one.h"

#include <limits>
#include <memory>

#include "curves/result.h"

namespace evc::python::one_by_one {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// The track of a train with this target alone.
sdm::Inputs with(const sdm::Inputs& train, const Target& target) {
  sdm::Inputs in = train;
  in.authority = {};
  in.SR_end.reset();
  switch (target.kind) {
    case sdm::TargetKind::MRSP: {
      sdm::Mrsp mrsp;
      const Speed before = in.V_top.value_or(in.train.V_MAXTRAIN);
      if (!mrsp.append({{-1e7}}, before) || !mrsp.append(target.location, target.V_target)) __builtin_trap();
      in.mrsp = mrsp;
      in.mrsp_due_to_TSR = {};
      in.mrsp_due_to_TSR[1] = target.due_to_TSR;
      break;
    }
    case sdm::TargetKind::LOA:
      in.authority.kind = sdm::Authority::Kind::LOA;
      in.authority.EOA = in.authority.SvL = target.location;
      in.authority.V_LOA = target.V_target;
      break;
    case sdm::TargetKind::EOA_SvL:
      in.authority.kind = sdm::Authority::Kind::EOA_SvL;
      in.authority.EOA = target.location;
      in.authority.SvL = target.SvL;
      break;
    case sdm::TargetKind::SR_end:
      in.SR_end = target.location;
      break;
  }
  return in;
}

void put(std::span<double> out, std::size_t i, const Target& target, const std::optional<Place>& place) {
  if (out.empty()) return;
  out[i] = place && curves::is_somewhere(*place) ? (target.location - *place).si : kNone;
}

const sdm::Target* of_kind(const sdm::Derived& derived, sdm::TargetKind kind) {
  for (const sdm::Target& t : derived.targets)
    if (t.kind == kind) return &t;
  return nullptr;
}

}  // namespace

std::uint32_t Trains::add(const sdm::Inputs& in, const State& state) {
  trains_.push_back({in, state});
  return static_cast<std::uint32_t>(trains_.size() - 1);
}

void limits(const Trains& trains, std::span<const Target> targets, const Cases& cases, const LimitsOut& out) {
  const auto derived = std::make_unique<sdm::Derived>();
  sdm::Inputs in;
  const sdm::Target* supervised = nullptr;
  for (std::size_t i = 0; i < cases.speed.size(); ++i) {
    const Target& target = targets[cases.target[i]];
    const Trains::Train& train = trains[cases.train[i]];
    if (i == 0 || cases.target[i] != cases.target[i - 1] || cases.train[i] != cases.train[i - 1]) {
      in = with(train.in, target);
      derived->valid = false;
      sdm::rebuild(*derived, in);
      supervised = of_kind(*derived, target.kind);
    }
    std::optional<sdm::Explanation> e;
    if (supervised != nullptr)
      e = sdm::explain(*derived, in, *supervised, {cases.speed[i]}, train.state.V_ura, train.state.A_est,
                       train.state.motion ? &*train.state.motion : nullptr);
    const auto give = [&](std::span<double> column, std::optional<Place> place) { put(column, i, target, place); };
    const auto of_SBD = [&](Place sdm::Limits::*limit) {
      return e && e->SBD ? std::optional((*e->SBD).*limit) : std::nullopt;
    };
    const auto of_EBD = [&](Place sdm::Limits::*limit) { return e ? std::optional(e->EBD.*limit) : std::nullopt; };
    const auto of_both = [&](Place sdm::Explanation::*limit) { return e ? std::optional((*e).*limit) : std::nullopt; };
    give(out.EBD, of_both(&sdm::Explanation::d_EBD));
    give(out.SBD, e ? e->d_SBD : std::nullopt);
    give(out.GUI, e ? e->d_GUI : std::nullopt);
    give(out.EBI, e ? e->EBD.d_EBI : std::nullopt);
    give(out.SBI1, of_SBD(&sdm::Limits::d_SBI));
    give(out.SBI2, of_EBD(&sdm::Limits::d_SBI));
    give(out.FLOI, of_both(&sdm::Explanation::d_FLOI));
    give(out.W, of_both(&sdm::Explanation::d_W));
    give(out.P, of_both(&sdm::Explanation::d_P));
    give(out.I, of_both(&sdm::Explanation::d_I));
    give(out.W_EOA, of_SBD(&sdm::Limits::d_W));
    give(out.P_EOA, of_SBD(&sdm::Limits::d_P));
    give(out.I_EOA, of_SBD(&sdm::Limits::d_I));
    give(out.W_SvL, of_EBD(&sdm::Limits::d_W));
    give(out.P_SvL, of_EBD(&sdm::Limits::d_P));
    give(out.I_SvL, of_EBD(&sdm::Limits::d_I));
  }
}

}  // namespace evc::python::one_by_one
