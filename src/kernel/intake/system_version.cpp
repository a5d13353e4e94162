#include "kernel/intake/system_version.h"

#include "kernel/intake/filter.h"
#include "kernel/intake/levels.h"
#include "kernel/intake/national_values.h"
#include "lang/decode.h"
#include "lang/packets/packet_2.h"
#include "lang/packets/packet_3.h"
#include "modes/active_functions.h"
#include "terms/packet_numbers.h"

namespace evc::kernel {
namespace {

constexpr std::uint8_t X_of(std::uint64_t M_VERSION) { return static_cast<std::uint8_t>(M_VERSION >> 4); }

void operate(Reception& r, std::uint8_t X, Clause clause) {
  if (X == r.state.operated_X) return;
  r.state.operated_X = X;
  ++r.state.revision;  // of axle load restrictions others hold (6.6.4.1.3)
  r.log.note({.what = What::version_operated, .id = operated_M_VERSION(X, r.state.srs), .clause = clause});
}

struct RbcVersion {
  std::uint8_t X = 0;
  Clause clause;
};

/// The RBC whose version takes precedence when the unit is in `level`, and was in `before`; none: the balise groups
/// count (3.17.2.8).
std::optional<RbcVersion> version_of_rbc(const Reception& r, Level before, Level level) {
  const State& s = r.state;
  if (!level_2_or_3(level)) return std::nullopt;  // a, d
  const radio::Session* session = &s.radio.supervising.session;
  Clause clause = level_2_or_3(before) ? "3.17.2.8 b"_srs : "3.17.2.8 a"_srs;
  if (const std::optional<track::RbcTransition>& order = s.handover.order) {
    const auto accepting = [&](const radio::Session& of) {
      return of.rbc.same_id(radio::Rbc{order->NID_C, order->NID_RBC, order->NID_RADIO});
    };
    // c, e: beyond the border the handing over RBC does not count any more.
    if (!accepting(*session) && r.out.here.max_safe_front >= order->at) {
      session = &s.radio.other.session;
      clause = "3.17.2.8 c"_srs;
      if (!accepting(*session)) return std::nullopt;
    }
  }
  if (!session->established()) return std::nullopt;
  return RbcVersion{X_of(session->M_VERSION), clause};
}

/// Packet 2 for the train's direction, if a filter does not reject it.
std::optional<std::uint8_t> ordered_X(Evaluation& e) {
  std::optional<std::uint8_t> X;
  for (std::size_t i = 0; i < e.information.packets.size(); ++i) {
    const lang::PacketView& view = e.information.packets[i];
    if (view.NID_PACKET != packet::system_version_order || !judged(e, i)) continue;
    lang::Packet2 p;
    if (judge_packet(e, i).verdict != modes::Verdict::accepted || lang::decode(view, p) != lang::Fault::none) continue;
    X = X_of(p.M_VERSION.raw);
  }
  return X;
}

/// National values that come into force with this group are those with which its country is compared (3.17.2.6 of
/// 4.0.0).
bool differs_from_own_values(const Evaluation& e, bool differs) {
  if (e.r.state.srs != SrsVersion::v4_0_0) return differs;
  for (std::size_t i = 0; i < e.information.packets.size(); ++i) {
    const lang::PacketView& view = e.information.packets[i];
    lang::Packet3 p;
    if (view.NID_PACKET != packet::national_values || !judged(e, i) || lang::decode(view, p) != lang::Fault::none)
      continue;
    const bool at_once = !start_of_validity(p, view.sv.x);
    if (!at_once || modes::accept(evc::Information::national_values, e.context).verdict != modes::Verdict::accepted)
      continue;
    differs = p.NID_C.raw != e.information.group.NID_C;
    for (const auto& area : p.areas) differs = differs && area.NID_C.raw != e.information.group.NID_C;
  }
  return differs;
}

}  // namespace

void determine_version(Evaluation& e) {
  Reception& r = e.r;
  const std::optional<SenderVersion>& group = e.information.version;
  if (!group) return;
  const std::optional<std::uint8_t> ordered = ordered_X(e);
  if (!modes::active(modes::Function::system_version, r.state.mode)) return;
  const Level level = executes_order(r) ? r.order->decision.to.level : r.state.level.level;
  if (const auto rbc = version_of_rbc(r, r.state.level.level, level)) return operate(r, rbc->X, rbc->clause);
  if (ordered) {
    if (*ordered >= 1 && *ordered <= highest_X(r.state.srs)) operate(r, *ordered, "3.17.2.5"_srs);
    return;  // 3.17.2.7: one that is not supported changes nothing
  }
  if (differs_from_own_values(e, group->other_country)) return operate(r, group->X, "3.17.2.6"_srs);
  if (group->X > r.state.operated_X) operate(r, group->X, "3.17.2.3"_srs);
}

void operate_version_of_infill_unit(Reception& r, std::uint8_t M_VERSION) {
  if (!modes::active(modes::Function::system_version, r.state.mode)) return;
  const Level level = r.state.level.level;
  if (!version_of_rbc(r, level, level) && X_of(M_VERSION) > r.state.operated_X)
    operate(r, X_of(M_VERSION), "3.17.2.3"_srs);
}

void operate_version_of_rbc(Reception& r, Level before) {
  if (!modes::active(modes::Function::system_version, r.state.mode)) return;
  if (const auto rbc = version_of_rbc(r, before, r.state.level.level)) operate(r, rbc->X, rbc->clause);
}

}  // namespace evc::kernel
