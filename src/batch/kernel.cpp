#include "batch/kernel.h"

#include <limits>

#include "batch/tables.h"

// Each set of instructions is a compilation of this file: foreach_target.h includes it again and again. SSSE3 is slower
// than one number at a time. Targets with lower bits than AVX-512 (HWY_AVX3) are its variants with further
// instructions, more of them in each version of Highway; they would bring nothing for numbers of 64 bits.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | (HWY_AVX3 - 1))
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "batch/kernel.cpp"
#include <hwy/foreach_target.h>
// It must come after it.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace evc::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::ScalableTag<double>;
using DI = hn::RebindToSigned<D>;
using V = hn::Vec<D>;
using VI = hn::Vec<DI>;
using M = hn::Mask<D>;

/// Groups of lanes that are computed in turn, so that one waits while another one is computed.
constexpr std::size_t kUnrolled = 4;

HWY_INLINE V number(double x) { return hn::Set(D(), x); }
HWY_INLINE V at(const double* numbers, VI index) { return hn::GatherIndex(D(), numbers, index); }
HWY_INLINE VI index_at(const double* numbers, VI index) { return hn::BitCast(DI(), at(numbers, index)); }
HWY_INLINE VI plus(VI index, std::int64_t n) { return hn::Add(index, hn::Set(DI(), n)); }
HWY_INLINE VI choose(M which, VI yes, VI no) { return hn::IfThenElse(hn::RebindMask(DI(), which), yes, no); }
HWY_INLINE V choose(M which, V yes, V no) { return hn::IfThenElse(which, yes, no); }
// The bits of std::min and std::max, also for zeros of both signs.
HWY_INLINE V least(V a, V b) { return choose(hn::Lt(b, a), b, a); }
HWY_INLINE V greatest(V a, V b) { return choose(hn::Lt(a, b), b, a); }
HWY_INLINE bool any(M m) { return !hn::AllFalse(D(), m); }
HWY_INLINE M flag(const double* of) { return hn::Gt(hn::Load(D(), of), number(0.5)); }

HWY_INLINE std::size_t cases_of_a_group() { return kUnrolled * hn::Lanes(D()); }

/// Whether the group of case `k` has one train and class of targets.
HWY_INLINE bool alike(const Block& b, std::size_t k) { return b.alike[k / cases_of_a_group()]; }
/// A value of the train and its class of targets, of the lanes from case `k` on.
HWY_INLINE V value_of(const Block& b, std::size_t k, TrainValue which) {
  if (alike(b, k)) return number(b.numbers[b.values[k] + which]);
  return at(b.numbers, plus(hn::Load(DI(), b.values.data() + k), which));
}
HWY_INLINE VI index_of(const Block& b, std::size_t k, TrainValue which) {
  return hn::BitCast(DI(), value_of(b, k, which));
}
/// Where all lanes have the same one.
HWY_INLINE std::int64_t only_index_of(const Block& b, std::size_t k, TrainValue which) {
  return as_index(b.numbers[b.values[k] + which]);
}

/// A curve of each lane.
struct Curve {
  V x, w;      // the anchor
  VI segment;  // index of the segment upstream of it
  V w_top;     // the curve ends here
};

/// What is known of a cell.
struct Cell {
  V twice_A, upto, begin;
};

/// The cells of all lanes. A cell is loaded at once, and those of the lanes are transposed: gathering value by value
/// takes twice the time of everything else.
HWY_INLINE Cell cells_at(const double* numbers, VI cell) {
  static_assert(kTwiceA == 0 && kUpto == 1 && kBegin == 2 && kCellValues == 4);
#if HWY_ARCH_X86 && HWY_TARGET <= HWY_AVX2
  alignas(64) std::int64_t index[hn::MaxLanes(D())];
  hn::Store(cell, DI(), index);
  const hn::FixedTag<double, 4> quarter;
#if HWY_ARCH_X86 && HWY_TARGET <= HWY_AVX3
  const auto load = [&](int k) HWY_ATTR {
    return hn::Combine(D(), hn::LoadU(quarter, numbers + index[k + 4]), hn::LoadU(quarter, numbers + index[k]));
  };
#else
  const auto load = [&](int k) HWY_ATTR { return hn::LoadU(quarter, numbers + index[k]); };
#endif
  const V c0 = load(0);
  const V c1 = load(1);
  const V c2 = load(2);
  const V c3 = load(3);
  // In blocks of two lanes: A of 0 and 1, begin of 0 and 1 (and of 4 and 5), and so on.
  const V A_begin_01 = hn::InterleaveLower(D(), c0, c1);
  const V A_begin_23 = hn::InterleaveLower(D(), c2, c3);
  const V upto_01 = hn::InterleaveUpper(D(), c0, c1);
  const V upto_23 = hn::InterleaveUpper(D(), c2, c3);
  return {hn::OddEvenBlocks(hn::SwapAdjacentBlocks(A_begin_23), A_begin_01),
          hn::OddEvenBlocks(hn::SwapAdjacentBlocks(upto_23), upto_01),
          hn::OddEvenBlocks(A_begin_23, hn::SwapAdjacentBlocks(A_begin_01))};
#else
  return {at(numbers, cell), at(numbers, plus(cell, kUpto)), at(numbers, plus(cell, kBegin))};
#endif
}

/// The number of `values`, `step` apart, of which `below(value)` holds.
template <class Below>
HWY_INLINE VI count_of(const double* values, std::int64_t number_of_values, std::int64_t step, Below below) {
  VI n = hn::Zero(DI());
  for (std::int64_t i = 0; i < number_of_values; ++i) n = choose(below(number(values[i * step])), plus(n, 1), n);
  return n;
}

/// segment_upstream_of: the last segment that begins in rear of `x`, or the first one. `k` is the first lane's case.
HWY_INLINE VI segment_upstream(const Block& b, std::size_t k, V x) {
  static_assert(kSegmentValues == 4);
  const VI first = index_of(b, k, kFirstSegment);
  if (hn::Lanes(D()) > 1 && alike(b, k) && only_index_of(b, k, kSegments) <= kLookUpSegments) {
    // All lanes have the same segments: comparing with each one is faster than bisecting, which loads from different
    // places.
    const double* second = b.numbers + only_index_of(b, k, kFirstSegment) + kSegmentValues;
    const VI in_rear = count_of(second, only_index_of(b, k, kSegments) - 1, kSegmentValues,
                                [&](V from) HWY_ATTR { return hn::Lt(from, x); });
    return hn::Add(first, hn::ShiftLeft<2>(in_rear));
  }
  VI low = first;
  VI high = hn::Add(first, hn::ShiftLeft<2>(index_of(b, k, kSegments)));
  for (std::size_t i = 0; i < b.bisections; ++i) {
    const VI middle = hn::Add(low, hn::ShiftLeft<2>(hn::ShiftRight<3>(hn::Sub(high, low))));
    const M in_rear = hn::Lt(at(b.numbers, middle), x);
    low = choose(in_rear, middle, low);
    high = choose(in_rear, high, middle);
  }
  return low;
}

// The track of each lane's train and the bands of speed: for any trains, and for one train with few segments and bands.
// Both have the same functions.

/// The lanes have any trains: a position is the index of a cell.
class AnyTrains {
 public:
  struct Position {
    VI cell, stride;
  };

  AnyTrains(const Block& b, SegmentValue kind) : b_(b), kind_(kind) {}

  /// Of the lanes from case `k` on, upstream of the anchor: the first band that ends above its speed.
  HWY_INLINE Position upstream_of(const Curve& c, std::size_t k) const {
    static_assert(kStrideSBD - kStrideEBD == kCellSBD - kCellEBD && kStrideGUI - kStrideEBD == kCellGUI - kCellEBD);
    Position p;
    p.cell = index_at(b_.numbers, plus(c.segment, kind_));
    p.stride = index_of(b_, k, static_cast<TrainValue>(kStrideEBD + (kind_ - kCellEBD)));
    // Each band ends above 0.
    if (hn::AllTrue(D(), hn::Le(c.w, number(0.0)))) return p;
    for (;;) {
      const M below = hn::Le(at(b_.numbers, plus(p.cell, kUpto)), c.w);
      if (!any(below)) return p;
      p.cell = choose(below, plus(p.cell, kCellValues), p.cell);
    }
  }
  HWY_INLINE Cell at_position(const Position& p) const { return cells_at(b_.numbers, p.cell); }
  /// The next segment upstream, where `crossed`, and the next band, where `risen`.
  HWY_INLINE Position next(const Position& p, M crossed, M risen) const {
    const VI upstream = choose(crossed, hn::Sub(p.cell, p.stride), p.cell);
    return {choose(risen, plus(upstream, kCellValues), upstream), p.stride};
  }

 private:
  const Block& b_;
  SegmentValue kind_;
};

#if HWY_ARCH_X86 && HWY_TARGET <= HWY_AVX3
static_assert(hn::MaxLanes(D()) == 8, "512 bits: the tables are permuted as a whole");

/// All lanes have the same train, whose look-up tables are in registers: a permutation with the numbers of the lanes'
/// segments or bands as index takes the place of eight loads from different places.
class OneTrain {
 public:
  /// Numbers of segment and band; segment 0 is what is upstream of the first one.
  struct Position {
    VI segment, band;
  };

  /// The train of case `k`.
  OneTrain(const Block& b, SegmentValue kind, std::size_t k) : first_(only_index_of(b, k, kFirstSegment)) {
    static_assert(kLookUpBands == 8 && kLookUpSegments == 32);
    table_ = b.numbers + first_ - (kSegmentValues - kind) * kLookUpValues;
    upto_ = hn::LoadU(D(), table_ + kLookUpUpto);
    twice_A_ = hn::LoadU(D(), table_ + kLookUpTwiceA);
    for (int i = 0; i < 4; ++i) {
      begin_[i] = hn::LoadU(D(), table_ + kLookUpBegin + 8 * i);
      twice_gradient_[i] = hn::LoadU(D(), table_ + kLookUpTwiceGradient + 8 * i);
    }
  }

  HWY_INLINE Position upstream_of(const Curve& c, std::size_t) const {
    static_assert(kSegmentValues == 4);
    Position p{plus(hn::ShiftRight<2>(plus(c.segment, -first_)), 1), hn::Zero(DI())};
    if (hn::AllTrue(D(), hn::Le(c.w, number(0.0)))) return p;
    p.band = count_of(table_ + kLookUpUpto, kLookUpBands, 1, [&](V upto) HWY_ATTR { return hn::Le(upto, c.w); });
    return p;
  }
  HWY_INLINE Cell at_position(const Position& p) const {
    const auto band = hn::IndicesFromVec(D(), p.band);
    const M beyond_16 = hn::RebindMask(D(), hn::TestBit(p.segment, hn::Set(DI(), 16)));
    const V twice_A = hn::TableLookupLanes(twice_A_, band);
    return {hn::Add(twice_A, of_segment(twice_gradient_, p.segment, beyond_16)), hn::TableLookupLanes(upto_, band),
            of_segment(begin_, p.segment, beyond_16)};
  }
  HWY_INLINE Position next(const Position& p, M crossed, M risen) const {
    return {choose(crossed, plus(p.segment, -1), p.segment), choose(risen, plus(p.band, 1), p.band)};
  }

 private:
  HWY_INLINE V of_segment(const V (&table)[4], VI segment, M beyond_16) const {
    // Highway has no permutation of two vectors before 1.0.5.
    const V low{_mm512_permutex2var_pd(table[0].raw, segment.raw, table[1].raw)};
    const V high{_mm512_permutex2var_pd(table[2].raw, segment.raw, table[3].raw)};
    return choose(beyond_16, high, low);
  }

  std::int64_t first_;  // segment
  const double* table_;
  V upto_, twice_A_;                // of each band
  V begin_[4], twice_gradient_[4];  // of each segment
};
#endif

/// The end of the arc from `x`, `w` upstream: at the border of the segment, or where it has the speed `upper`.
struct Arc {
  V x_next, w_next;
};
HWY_INLINE Arc arc_upstream(V x, V w, const Cell& c, V upper) {
  const V at_border = hn::Add(w, hn::Mul(c.twice_A, hn::Sub(x, c.begin)));
  const V there = hn::Sub(x, hn::Div(hn::Sub(upper, w), c.twice_A));
  return {choose(hn::Lt(at_border, upper), c.begin, hn::Max(c.begin, there)), hn::Min(at_border, upper)};
}

/// Curves that are followed upstream along `Track`, each lane one.
template <class Track>
struct Followed {
  V x, w;  // where the arc begins
  typename Track::Position position;

  /// To the end of the arc, in the lanes `on`. The others are inside their segment and band, and stay there.
  HWY_INLINE void go(const Track& track, const Cell& c, const Arc& arc, M on) {
    x = choose(on, arc.x_next, x);
    w = choose(on, arc.w_next, w);
    position = track.next(position, hn::Le(x, c.begin), hn::Ge(w, c.upto));
  }
};

/// d(V) of the curves upstream of their anchors, for the square `wanted` of the speed; the anchor for a speed not above
/// its own. The same arcs as those of sdm::trace, and place_at on the last one: no knots are stored. A lane whose arc
/// reaches the speed computes that arc again until the last lane is there: a branch for each lane would cost more.
template <class Track>
HWY_INLINE void place_upstream_on(const Track& track, std::size_t k, const Curve* curves, const V* wanted,
                                  const M* asked, V* place) {
  const M none = hn::Lt(number(0.0), number(0.0));
  Followed<Track> f[kUnrolled];
  V goal[kUnrolled];
  M beyond_top[kUnrolled];
  M more = none;
  for (std::size_t u = 0; u < kUnrolled; ++u) {
    place[u] = curves[u].x;
    more = hn::Or(more, hn::And(asked[u], hn::Gt(wanted[u], curves[u].w)));
  }
  if (!any(more)) return;
  more = none;
  for (std::size_t u = 0; u < kUnrolled; ++u) {
    f[u] = {curves[u].x, curves[u].w, track.upstream_of(curves[u], k + u * hn::Lanes(D()))};
    // Up to V_top it is of no importance where the curve ends. Lanes that are not asked stay at their anchor.
    goal[u] = choose(asked[u], hn::Min(wanted[u], curves[u].w_top), curves[u].w);
    beyond_top[u] = hn::And(asked[u], hn::Gt(wanted[u], curves[u].w_top));
    more = hn::Or(more, beyond_top[u]);
  }
  const bool any_beyond_top = any(more);
  do {
    more = none;
    for (std::size_t u = 0; u < kUnrolled; ++u) {
      const Cell c = track.at_position(f[u].position);
      const Arc arc = arc_upstream(f[u].x, f[u].w, c, c.upto);
      const M on = hn::Lt(arc.w_next, goal[u]);
      f[u].go(track, c, arc, on);
      more = hn::Or(more, on);
    }
  } while (any(more));
  if (any_beyond_top)
    for (std::size_t u = 0; u < kUnrolled; ++u) {
      // To V_top: beyond it the arc that begins there is continued.
      const Cell c = track.at_position(f[u].position);
      const Arc arc = arc_upstream(f[u].x, f[u].w, c, hn::Min(curves[u].w_top, c.upto));
      f[u].go(track, c, arc, hn::And(beyond_top[u], hn::Lt(f[u].w, curves[u].w_top)));
    }
  for (std::size_t u = 0; u < kUnrolled; ++u) {
    const Cell c = track.at_position(f[u].position);
    const V on_arc = hn::Sub(f[u].x, hn::Div(hn::Sub(wanted[u], f[u].w), c.twice_A));
    place[u] = choose(hn::Gt(wanted[u], curves[u].w), on_arc, place[u]);
  }
}

/// The same for curves of one kind; `k` is the first lane's case.
HWY_NOINLINE void place_upstream(const Block& b, SegmentValue kind, std::size_t k, const Curve* curves, const V* wanted,
                                 const M* asked, V* place) {
#if HWY_ARCH_X86 && HWY_TARGET <= HWY_AVX3
  if (alike(b, k) && b.numbers[b.values[k] + kLookedUp] > 0.5)
    return place_upstream_on(OneTrain(b, kind, k), k, curves, wanted, asked, place);
#endif
  place_upstream_on(AnyTrains(b, kind), k, curves, wanted, asked, place);
}

/// Of curves with their foot beyond the target: d(V) for speeds up to that at the anchor. `place` keeps its value for
/// higher speeds.
HWY_INLINE void place_downstream(Block& b, std::size_t i, const Curve& c, V w_foot, V wanted, V& place) {
  V x = c.x;
  V w = c.w;
  const VI stride = index_of(b, i, kStrideEBD);
  VI cell = index_at(b.numbers, plus(c.segment, kCellEBD));
  // segment_index: the segment that begins at the anchor counts.
  const VI next = hn::Add(cell, stride);
  cell = choose(hn::Le(at(b.numbers, plus(next, kBegin)), x), next, cell);
  // band_below: the band that includes the speed.
  for (;;) {
    const M below = hn::Lt(at(b.numbers, plus(cell, kUpto)), w);
    if (!any(below)) break;
    cell = choose(below, plus(cell, kCellValues), cell);
  }
  const M here = hn::Le(wanted, w);
  M open = hn::Gt(w, w_foot);
  for (std::size_t arcs = 0; any(open) && arcs < kMostArcsDownstream; ++arcs) {
    const V twice_A = at(b.numbers, plus(cell, kTwiceA));
    const V border = at(b.numbers, plus(hn::Add(cell, stride), kBegin));
    const V above = at(b.numbers, plus(cell, kAbove));
    const V lower = greatest(w_foot, above);
    const V to_band = hn::Add(x, hn::Div(hn::Sub(w, lower), twice_A));
    const M in_segment = hn::Lt(to_band, border);
    const V at_border = greatest(lower, hn::Sub(w, hn::Mul(twice_A, hn::Sub(border, x))));
    const V w_next = choose(in_segment, lower, at_border);
    const V x_next = choose(in_segment, to_band, border);
    const M hit = hn::And(hn::And(open, here), hn::And(hn::Gt(wanted, w_next), hn::Le(wanted, w)));
    place = choose(hit, hn::Sub(x_next, hn::Div(hn::Sub(wanted, w_next), twice_A)), place);
    const VI downstream = choose(hn::AndNot(in_segment, open), hn::Add(cell, stride), cell);
    cell = choose(hn::And(open, hn::Le(w_next, above)), plus(downstream, -kCellValues), downstream);
    x = choose(open, x_next, x);
    w = choose(open, w_next, w);
    open = hn::And(open, hn::Gt(w, w_foot));
  }
  place = choose(hn::Le(wanted, w_foot), x, place);
  hn::Store(choose(open, number(1.0), hn::Load(D(), b.left_out.data() + i)), D(), b.left_out.data() + i);
}

HWY_INLINE void put(const Block& b, Output which, std::size_t i, M exists, V location, V place) {
  if (b.out[which] == nullptr) return;
  const M somewhere = hn::And(exists, hn::Gt(place, number(-kFarthest.si)));
  const V none = number(std::numeric_limits<double>::quiet_NaN());
  hn::Store(choose(somewhere, hn::Sub(location, place), none), D(), b.out[which] + i);
}

/// Whether one of the outputs is wanted.
HWY_INLINE bool wanted(const Block& b, Output from, Output to) {
  for (std::size_t k = from; k <= to; ++k)
    if (b.out[k] != nullptr) return true;
  return false;
}

/// The limits of an EBD or an SBD (limits_of_EBD, limits_of_SBD) from d_SBI on.
struct Places {
  V SBI, W, P, I;
};

/// One group of lanes: cases `i` to `i + kUnrolled * lanes`.
HWY_INLINE void compute_group(Block& b, std::size_t i) {
  const std::size_t N = hn::Lanes(D());
  Curve EBD[kUnrolled];
  V squared[kUnrolled];
  V bec_squared[kUnrolled];
  V D_bec[kUnrolled];
  V w_foot[kUnrolled];
  V d_curve[kUnrolled];
  V d_EBD[kUnrolled];
  V d_SBD[kUnrolled];
  V d_GUI[kUnrolled];
  V d_GUI_EOA[kUnrolled];
  V d_P_foot[kUnrolled];
  M all[kUnrolled];
  M has_SBD[kUnrolled];
  M has_GUI[kUnrolled];
  const bool limits = wanted(b, kEBI, kI_SvL);
  const bool SBD = b.out[kSBD] != nullptr || wanted(b, kSBI1, kSBI1) || wanted(b, kFLOI, kI_EOA);
  for (std::size_t u = 0; u < kUnrolled; ++u) {
    const std::size_t k = i + u * N;
    const V speed = hn::Load(D(), b.V.data() + k);
    const V V_target = hn::Load(D(), b.V_target.data() + k);
    all[u] = hn::Eq(speed, speed);
    // A speed that is not a number has no limits.
    has_SBD[u] = hn::And(flag(b.has_SBD.data() + k), all[u]);
    has_GUI[u] = hn::And(hn::Gt(value_of(b, k, kGuided), number(0.5)), all[u]);
    squared[u] = hn::Mul(speed, speed);
    w_foot[u] = hn::Mul(V_target, V_target);
    EBD[u].x = hn::Load(D(), b.d_target.data() + k);
    EBD[u].w = hn::Load(D(), b.anchor_squared.data() + k);
    EBD[u].segment = segment_upstream(b, k, EBD[u].x);
    EBD[u].w_top = value_of(b, k, kTopSquared);
    if (!limits) continue;
    // before_emergency_effort.
    const V T_traction = value_of(b, k, kTTraction);
    const V T_berem = value_of(b, k, kTBerem);
    const V with_error = hn::Add(speed, value_of(b, k, kVDelta0));
    const V after_traction = greatest(hn::Add(with_error, value_of(b, k, kVDelta1)), V_target);
    const V V_bec = hn::Add(after_traction, value_of(b, k, kVDelta2));
    bec_squared[u] = hn::Mul(V_bec, V_bec);
    const V meanwhile = greatest(hn::Add(with_error, value_of(b, k, kHalfVDelta1)), V_target);
    D_bec[u] = hn::Add(hn::Mul(meanwhile, T_traction),
                       hn::Mul(hn::Add(after_traction, value_of(b, k, kHalfVDelta2)), T_berem));
  }
  if (limits) {
    place_upstream(b, kCellEBD, i, EBD, bec_squared, all, d_curve);
    if (b.at_speed)
      for (std::size_t u = 0; u < kUnrolled; ++u)
        place_downstream(b, i + u * N, EBD[u], w_foot[u], bec_squared[u], d_curve[u]);
  }
  if (b.out[kEBD] != nullptr) {
    place_upstream(b, kCellEBD, i, EBD, squared, all, d_EBD);
    if (b.at_speed)
      for (std::size_t u = 0; u < kUnrolled; ++u)
        place_downstream(b, i + u * N, EBD[u], w_foot[u], squared[u], d_EBD[u]);
    for (std::size_t u = 0; u < kUnrolled; ++u)
      put(b, kEBD, i + u * N, all[u], hn::Load(D(), b.location.data() + i + u * N), d_EBD[u]);
  }
  // The curves whose foot is the EOA; for other targets they are not asked for.
  Curve EOA[kUnrolled];
  if (SBD || b.guided)
    for (std::size_t u = 0; u < kUnrolled; ++u) {
      EOA[u].x = hn::Load(D(), b.location.data() + i + u * N);
      EOA[u].w = number(0.0);
      EOA[u].segment = segment_upstream(b, i + u * N, EOA[u].x);
      EOA[u].w_top = EBD[u].w_top;
    }
  if (SBD) place_upstream(b, kCellSBD, i, EOA, squared, has_SBD, d_SBD);
  if (b.guided && (b.out[kGUI] != nullptr || wanted(b, kFLOI, kI_SvL))) {
    // 3.13.8.5.2: foot at EOA and SvL, else where P has the target speed.
    V V_foot_squared[kUnrolled];
    M elsewhere[kUnrolled];
    for (std::size_t u = 0; u < kUnrolled; ++u) {
      const V V_foot = hn::Load(D(), b.V_foot.data() + i + u * N);
      V_foot_squared[u] = hn::Mul(V_foot, V_foot);
      elsewhere[u] = hn::AndNot(has_SBD[u], has_GUI[u]);
    }
    place_upstream(b, kCellEBD, i, EBD, V_foot_squared, elsewhere, d_P_foot);
    Curve curves[kUnrolled];
    M with_EOA[kUnrolled];
    for (std::size_t u = 0; u < kUnrolled; ++u) {
      const std::size_t k = i + u * N;
      if (b.at_speed) place_downstream(b, k, EBD[u], w_foot[u], V_foot_squared[u], d_P_foot[u]);
      const V V_target = hn::Load(D(), b.V_target.data() + k);
      const V V_foot = hn::Load(D(), b.V_foot.data() + k);
      // d_P_at_target_speed.
      const V d_EBI = hn::Sub(d_P_foot[u], hn::Mul(V_foot, value_of(b, k, kTBeFoot)));
      const V d_P = hn::Sub(d_EBI, hn::Mul(V_target, value_of(b, k, kTPFoot)));
      curves[u].x = choose(elsewhere[u], d_P, EBD[u].x);
      curves[u].w = w_foot[u];
      curves[u].segment = segment_upstream(b, k, curves[u].x);
      curves[u].w_top = EBD[u].w_top;
      with_EOA[u] = hn::And(has_GUI[u], has_SBD[u]);
    }
    place_upstream(b, kCellGUI, i, curves, squared, has_GUI, d_GUI);
    place_upstream(b, kCellGUI, i, EOA, squared, with_EOA, d_GUI_EOA);
  }
  for (std::size_t u = 0; u < kUnrolled; ++u) {
    const std::size_t k = i + u * N;
    const V location = hn::Load(D(), b.location.data() + k);
    const M guided = b.guided ? has_GUI[u] : hn::Lt(location, location);
    put(b, kSBD, k, has_SBD[u], location, SBD ? d_SBD[u] : location);
    if (b.guided)
      put(b, kGUI, k, guided, location, choose(has_SBD[u], least(d_GUI[u], d_GUI_EOA[u]), d_GUI[u]));
    else
      put(b, kGUI, k, guided, location, location);
    if (!limits) continue;
    const V speed = hn::Load(D(), b.V.data() + k);
    const V run_warning = hn::Mul(speed, value_of(b, k, kTWarning));
    const V run_driver = hn::Mul(speed, value_of(b, k, kTDriver));
    const V run_indication = hn::Mul(speed, value_of(b, k, kTIndication));
    const V d_EBI = hn::Sub(d_curve[u], D_bec[u]);
    Places e;
    e.SBI = hn::Sub(d_EBI, hn::Mul(speed, value_of(b, k, kTBs2)));
    e.W = hn::Sub(e.SBI, run_warning);
    e.P = hn::Sub(e.SBI, run_driver);
    if (b.guided) e.P = choose(guided, least(e.P, d_GUI[u]), e.P);
    const V cap = value_of(b, k, kCapPAtTarget);
    const V d_target = hn::Load(D(), b.d_target.data() + k);
    e.P = choose(hn::Gt(cap, number(1.5)), least(e.P, d_target), e.P);
    e.I = hn::Sub(e.P, run_indication);
    put(b, kEBI, k, all[u], location, d_EBI);
    put(b, kSBI2, k, all[u], location, e.SBI);
    put(b, kW_SvL, k, all[u], location, e.W);
    put(b, kP_SvL, k, all[u], location, e.P);
    put(b, kI_SvL, k, all[u], location, e.I);
    Places nearer = e;
    nearer.P = choose(hn::Eq(cap, number(1.0)), least(e.P, d_target), e.P);
    if (SBD) {
      Places s;
      s.SBI = hn::Sub(d_SBD[u], hn::Mul(speed, value_of(b, k, kTBs1)));
      s.W = hn::Sub(s.SBI, run_warning);
      s.P = hn::Sub(s.SBI, run_driver);
      if (b.guided) s.P = choose(guided, least(s.P, d_GUI_EOA[u]), s.P);
      s.I = hn::Sub(s.P, run_indication);
      put(b, kSBI1, k, has_SBD[u], location, s.SBI);
      put(b, kW_EOA, k, has_SBD[u], location, s.W);
      put(b, kP_EOA, k, has_SBD[u], location, s.P);
      put(b, kI_EOA, k, has_SBD[u], location, s.I);
      nearer.SBI = choose(has_SBD[u], least(nearer.SBI, s.SBI), nearer.SBI);
      nearer.W = choose(has_SBD[u], least(nearer.W, s.W), nearer.W);
      nearer.P = choose(has_SBD[u], least(nearer.P, s.P), nearer.P);
      nearer.I = choose(has_SBD[u], least(nearer.I, s.I), nearer.I);
    }
    put(b, kFLOI, k, all[u], location, nearer.SBI);
    put(b, kW, k, all[u], location, nearer.W);
    put(b, kP, k, all[u], location, nearer.P);
    put(b, kI, k, all[u], location, nearer.I);
  }
}

void compute_block(Block& b) {
  static_assert(kUnrolled % Block::kLeastGroup == 0 && Block::kMost % (kUnrolled * hn::MaxLanes(D())) == 0);
  for (std::size_t i = 0; i < b.size; i += cases_of_a_group()) compute_group(b, i);
}

std::size_t group_size() { return cases_of_a_group(); }

}  // namespace HWY_NAMESPACE
}  // namespace evc::batch
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace evc::batch {

HWY_EXPORT(group_size);
HWY_EXPORT(compute_block);

std::size_t group() { return HWY_DYNAMIC_DISPATCH(group_size)(); }

void compute(Block& block) { HWY_DYNAMIC_DISPATCH(compute_block)(block); }

std::size_t instructions(std::array<Instructions, 8>& found) {
  std::size_t n = 0;
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets())
    if (n < found.size()) found[n++] = {target, hwy::TargetName(target)};
  return n;
}

void use_only(std::int64_t target) { hwy::SetSupportedTargetsForTest(target); }

}  // namespace evc::batch
#endif
