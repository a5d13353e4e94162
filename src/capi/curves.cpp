#include "openevc/curves.h"

#include <cmath>
#include <string_view>
#include <type_traits>

#include "capi/guard.h"
#include "io/curves_file.h"

using evc::Acceleration;
using evc::Distance;
using evc::Place;
using evc::Speed;
using evc::capi::kNone;
using evc::capi::Why;
namespace sdm = evc::sdm;

/// The contents of a document and everything computed from it, without pointers: it may be moved as
/// bytes.
struct openevc_curves {
  static constexpr std::uint64_t kTag = 0x6F65766363757276;  // "oevccurv"
  std::uint64_t tag = 0;
  sdm::Inputs inputs;
  sdm::Derived derived;
  sdm::Target target;
  Place target_location;  // reference of distances
  Speed V_ura{};
  Acceleration A_est{};
  std::optional<sdm::Motion> motion;
  sdm::Assumed assumed;
};
static_assert(std::is_trivially_copyable_v<openevc_curves>);
static_assert(alignof(openevc_curves) <= evc::capi::kAlignment);

namespace {

/// For a speed that is allowed nowhere (A <= 0), a curve returns a place out of range.
double before(const openevc_curves& c, std::optional<Place> place) {
  return place && place->from_origin.si > -1e8 ? (c.target_location - *place).si : kNone;
}

bool usable(const openevc_curves* curves) {
  return curves != nullptr && evc::capi::aligned(curves) && curves->tag == openevc_curves::kTag;
}

}  // namespace

size_t openevc_curves_size(void) noexcept { return sizeof(openevc_curves); }

openevc_result openevc_curves_build(void* memory, size_t memory_size, const char* document, size_t length,
                                    openevc_curves** curves, char* why_text, size_t why_size) noexcept {
  const Why why{why_text, why_size};
  if (curves == nullptr) return why.because(OPENEVC_BAD_ARGUMENT, "curves: null");
  *curves = nullptr;
  if (const char* refused = evc::capi::refuse_memory(memory, memory_size, sizeof(openevc_curves)))
    return why.because(OPENEVC_BAD_ARGUMENT, refused);
  if (document == nullptr) return why.because(OPENEVC_BAD_ARGUMENT, "document: null");
  return evc::capi::guarded(why, [&] {
    const auto read = evc::io::read_curves({document, length}, "document");
    if (!read) return why.because(OPENEVC_REFUSED, read.error().text());
    auto& c = *new (memory) openevc_curves;
    c.inputs = read->inputs;
    sdm::rebuild(c.derived, c.inputs);
    const sdm::Target* target = evc::io::target_of(*read, c.derived);
    if (target == nullptr) return why.because(OPENEVC_REFUSED, "document: /target: nothing is supervised there");
    c.target = *target;
    c.target_location = read->target_location;
    c.V_ura = read->V_ura;
    c.A_est = read->A_est;
    c.motion = read->motion;
    c.assumed = read->assumed;
    c.tag = openevc_curves::kTag;
    *curves = &c;
    return OPENEVC_OK;
  });
}

openevc_result openevc_curves_at_speed(const openevc_curves* curves, double speed,
                                       openevc_distances* distances) noexcept {
  if (!usable(curves) || !(speed >= 0.0 && speed <= 1000.0)) return OPENEVC_BAD_ARGUMENT;
  const openevc_curves& c = *curves;
  const sdm::Explanation e = sdm::explain(c.derived, c.inputs, c.target, Speed{speed}, c.V_ura, c.A_est,
                                          c.motion ? &*c.motion : nullptr, c.assumed);
  openevc_distances d{};
  d.A_safe = e.A_safe.si;
  d.A_expected = e.d_SBD ? e.A_expected.si : kNone;
  d.EBD = before(c, e.d_EBD);
  d.SBD = before(c, e.d_SBD);
  d.GUI = before(c, e.d_GUI);
  d.EBI = before(c, e.EBD.d_EBI);
  d.SBI1 = e.SBD ? before(c, e.SBD->d_SBI) : kNone;
  d.SBI2 = before(c, e.EBD.d_SBI);
  d.FLOI = before(c, e.d_FLOI);
  d.W = before(c, e.d_W);
  d.P = before(c, e.d_P);
  d.I = before(c, e.d_I);
  return evc::capi::give(distances, d) ? OPENEVC_OK : OPENEVC_BAD_ARGUMENT;
}

openevc_result openevc_curves_at_position(const openevc_curves* curves, double position,
                                          openevc_speeds* speeds) noexcept {
  if (!usable(curves) || !(std::abs(position) <= 1e7)) return OPENEVC_BAD_ARGUMENT;
  const openevc_curves& c = *curves;
  const Distance under_reading = c.motion ? c.motion->est_front - c.motion->min_safe_front : Distance{0.0};
  const Distance over_reading = c.motion ? c.motion->max_safe_front - c.motion->est_front : Distance{0.0};
  const sdm::PositionRow p = sdm::supervised_speeds_at(c.derived, c.inputs, c.target, Place{{position}}, c.V_ura,
                                                       c.A_est, under_reading, over_reading, c.assumed);
  const double SBD = c.target.kind == sdm::TargetKind::EOA_SvL ? p.SBD.si : kNone;
  const openevc_speeds s{0, 0, p.EBD.si, SBD, p.EBI.si, p.SBI.si, p.W.si, p.P.si, p.I.si};
  return evc::capi::give(speeds, s) ? OPENEVC_OK : OPENEVC_BAD_ARGUMENT;
}
