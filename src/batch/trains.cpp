#include <algorithm>
#include <bit>
#include <limits>
#include <utility>

#include "batch/tables.h"
#include "sdm/evaluate.h"
#include "sdm/limits.h"

namespace evc::batch {
namespace {

constexpr Speed kMargin{100.0 / kKmh};  // of curves above the speeds of train and MRSP, as in src/sdm

Speed V_top_of(const sdm::Inputs& in) {
  Speed top = in.train.V_MAXTRAIN;
  for (const auto& step : in.mrsp.steps) top = std::max(top, step.value);
  return in.V_top.value_or(top + kMargin);
}

/// No target is upstream of where the track begins, and no limit.
bool from_nowhere(const sdm::Segments& segments) { return segments.front().from.from_origin.si <= -kNowhere; }

/// The same special brakes everywhere: then there is one table of bands.
bool one_stage(const sdm::Segments& segments) {
  return std::all_of(segments.begin(), segments.end(),
                     [](const sdm::Segment& s) { return s.emergency == 0 && s.service == 0; });
}

bool decelerates(const sdm::Bands& bands, const sdm::Segments& segments) {
  for (const sdm::Segment& s : segments)
    for (const sdm::Band& b : bands)
      if (!(sdm::deceleration(b, s).si > 0.0)) return false;
  return true;
}

/// The deceleration of every cell is the sum of one of its band and one of its segment, as it is without reduced
/// adhesion and corrections for gradients, and the tables suffice.
bool can_be_looked_up(const sdm::Bands& bands, const sdm::Segments& segments) {
  if (bands.size() > static_cast<std::size_t>(kLookUpBands)) return false;
  if (segments.size() + 1 > static_cast<std::size_t>(kLookUpSegments)) return false;
  for (const sdm::Segment& s : segments)
    for (const sdm::Band& b : bands) {
      const double sum = 2.0 * b.A[0].si + 2.0 * s.A_gradient.si;
      if (std::bit_cast<std::uint64_t>(sum) != std::bit_cast<std::uint64_t>(2.0 * sdm::deceleration(b, s).si))
        return false;
    }
  return true;
}

class Layout {
 public:
  explicit Layout(std::vector<double>& numbers) : numbers_(numbers) {}

  std::int64_t here() const { return static_cast<std::int64_t>(numbers_.size()); }
  void number(double value) { numbers_.push_back(value); }
  void index(std::int64_t value) { numbers_.push_back(as_number(value)); }

  static std::int64_t stride(const sdm::Bands& bands) { return kCellValues * static_cast<std::int64_t>(bands.size()); }

  /// The cells of all segments; returns the index of the first one.
  std::int64_t cells(const sdm::Bands& bands, const sdm::Segments& segments) {
    row(bands, before(segments));
    const std::int64_t first = here();
    for (const sdm::Segment& s : segments) row(bands, s);
    sdm::Segment never = segments.back();
    never.from = {{kNowhere}};
    row(bands, never);
    return first;
  }

  /// The segments with their cells and look-up tables; returns the index of the first one.
  std::int64_t segments(const sdm::Decelerations& d, const sdm::Segments& segments, bool guidance, bool looked_up) {
    const std::int64_t EBD = cells(d.safe[0], segments);
    const std::int64_t SBD = cells(d.expected[0], segments);
    const std::int64_t GUI = guidance ? cells(d.normal_service[0], segments) : 0;
    if (looked_up)
      for (const sdm::Bands* bands : {&d.safe[0], &d.expected[0], guidance ? &d.normal_service[0] : &d.expected[0]})
        look_up(*bands, segments);
    const std::int64_t first = here();
    for (std::size_t i = 0; i < segments.size(); ++i) {
      const auto n = static_cast<std::int64_t>(i);
      number(segments[i].from.from_origin.si);
      index(EBD + n * stride(d.safe[0]));
      index(SBD + n * stride(d.expected[0]));
      index(GUI + n * (guidance ? stride(d.normal_service[0]) : 0));
    }
    return first;
  }

 private:
  static sdm::Segment before(const sdm::Segments& segments) {
    sdm::Segment none = segments.front();
    none.from = {{-std::numeric_limits<double>::infinity()}};
    return none;
  }

  /// In the order of LookUpValue; what is behind the last value is never looked at.
  void look_up(const sdm::Bands& bands, const sdm::Segments& segments) {
    constexpr double kNone = std::numeric_limits<double>::infinity();
    const auto values = [&](const auto& of, std::int64_t most, auto value) {
      for (const auto& one : of) number(value(one));
      for (auto i = static_cast<std::int64_t>(of.size()); i < most; ++i) number(kNone);
    };
    values(bands, kLookUpBands, [](const sdm::Band& b) { return b.w_upto.si; });
    values(bands, kLookUpBands, [](const sdm::Band& b) { return 2.0 * b.A[0].si; });
    number(before(segments).from.from_origin.si);
    values(segments, kLookUpSegments - 1, [](const sdm::Segment& s) { return s.from.from_origin.si; });
    number(2.0 * before(segments).A_gradient.si);
    values(segments, kLookUpSegments - 1, [](const sdm::Segment& s) { return 2.0 * s.A_gradient.si; });
  }

  /// In the order of CellValue.
  void row(const sdm::Bands& bands, const sdm::Segment& s) {
    double above = -std::numeric_limits<double>::infinity();
    for (const sdm::Band& b : bands) {
      for (const double value : {2.0 * sdm::deceleration(b, s).si, b.w_upto.si, s.from.from_origin.si, above})
        number(value);
      above = b.w_upto.si;
    }
  }

  std::vector<double>& numbers_;
};

/// In the order of TrainValue, from `kTTraction` on.
void lay_times(Layout& out, const sdm::Times& t, const sdm::Approach& a, const train::FixedValues& fixed) {
  const Speed V_delta1 = a.A_est1 * t.T_traction;
  const Speed V_delta2 = a.A_est2 * t.T_berem;
  for (const double value :
       {t.T_traction.si, t.T_berem.si, t.T_bs1.si, t.T_bs2.si, t.T_indication.si, V_delta1.si, (V_delta1 / 2.0).si,
        V_delta2.si, (V_delta2 / 2.0).si, (t.T_berem + t.T_traction).si, (fixed.T_driver + t.T_bs2).si})
    out.number(value);
}

/// A.3.12.3 and .4: what the speed before and after the ramp is below the train's speed does not depend on that speed.
/// A case nearer to the border than rounding reaches counts as one that may be reduced.
double full_above(const sdm::Derived& d, const train::BuildUpTimes& build_up, sdm::Approach a, const sdm::Times& t) {
  constexpr double kRounding = 1e-6;
  a.V = Speed{1000.0};  // no ramp ends with a standstill
  return (a.V - sdm::full_build_up_below(d, build_up, a, t)).si + kRounding;
}

}  // namespace

Trains::Trains() : tables_(std::make_unique<Tables>()) {}
Trains::~Trains() = default;
Trains::Trains(Trains&&) noexcept = default;
Trains& Trains::operator=(Trains&&) noexcept = default;

std::size_t Trains::size() const { return tables_->trains.size(); }
bool Trains::vectorised(std::uint32_t train) const { return tables_->trains.at(train).vectorised; }
void Trains::clear() {
  tables_->numbers.clear();
  tables_->trains.clear();
  tables_->most_segments = 1;
}

std::uint32_t Trains::add(const sdm::Inputs& in, const State& state) {
  sdm::Decelerations& d = tables_->scratch->decelerations;
  sdm::determine(d, in.train, in.national_values, in.fixed, in.brakes, in.gradient, in.conditions);
  const sdm::Rules rules = sdm::rules_of(in.srs);
  tables_->scratch->fixed = in.fixed;
  tables_->scratch->time_config = sdm::time_config(in.train, in.national_values);
  TrainEntry entry;
  entry.guidance = in.national_values.Q_NVGUIPERM && !d.normal_service[0].empty();
  entry.Q_NVINHSMICPERM = in.national_values.Q_NVINHSMICPERM;
  entry.fixed = in.fixed;
  const sdm::Segments& TSR = d.segments_of(true);
  const std::size_t bands = std::max({d.safe[0].size(), d.expected[0].size(), d.normal_service[0].size()});
  const std::size_t arcs = std::max(d.segments.size(), TSR.size()) + bands;
  entry.vectorised = !(rules.reduced_build_up && entry.guidance) && arcs + kMostArcsDownstream < sdm::kMaxKnots;
  for (const sdm::Segments* segments : {&std::as_const(d).segments, &TSR})
    entry.vectorised = entry.vectorised && from_nowhere(*segments) && one_stage(*segments) &&
                       decelerates(d.safe[0], *segments) && decelerates(d.expected[0], *segments) &&
                       (!entry.guidance || decelerates(d.normal_service[0], *segments));
  bool looked_up = entry.vectorised;
  for (const sdm::Segments* segments : {&std::as_const(d).segments, &TSR})
    looked_up = looked_up && can_be_looked_up(d.safe[0], *segments) && can_be_looked_up(d.expected[0], *segments) &&
                (!entry.guidance || can_be_looked_up(d.normal_service[0], *segments));
  const Speed V_top = V_top_of(in);
  if (!entry.vectorised || rules.reduced_build_up || arcs > kMostArcsDownstream) {
    auto whole = std::make_unique<Whole>(Whole{in, state});
    whole->in.V_top = V_top;
    entry.whole = std::move(whole);
  }
  if (entry.vectorised) {
    Layout out(tables_->numbers);
    const std::int64_t first = out.segments(d, d.segments, entry.guidance, looked_up);
    const std::int64_t first_TSR = &TSR == &d.segments ? first : out.segments(d, TSR, entry.guidance, looked_up);
    tables_->most_segments = std::max({tables_->most_segments, d.segments.size(), TSR.size()});
    entry.values = out.here();
    const sdm::Approach a = sdm::approach({}, entry.Q_NVINHSMICPERM ? Speed{0.0} : state.V_ura, state.A_est, in.fixed);
    const sdm::TimeConfig& config = tables_->scratch->time_config;
    for (const bool due_to_TSR : {false, true})
      for (const bool above_zero : {false, true}) {
        EVC_REQUIRE(out.here() == entry.values + class_of_targets(above_zero, due_to_TSR));
        const double cap = rules.P_not_beyond_target ? 2.0 : rules.pre_indication ? 1.0 : 0.0;
        // In the order of TrainValue.
        for (const double value : {a.V_delta0.si, (V_top * V_top).si, in.fixed.T_warning.si, in.fixed.T_driver.si, cap,
                                   entry.guidance ? 1.0 : 0.0, looked_up ? 1.0 : 0.0})
          out.number(value);
        out.index(Layout::stride(d.safe[0]));
        out.index(Layout::stride(d.expected[0]));
        out.index(entry.guidance ? Layout::stride(d.normal_service[0]) : 0);
        out.index(due_to_TSR ? first_TSR : first);
        out.index(static_cast<std::int64_t>((due_to_TSR ? TSR : d.segments).size()));
        const auto build_up = train::build_up_times(in.train, in.national_values, in.brakes, !above_zero);
        const sdm::Times times = sdm::times(config, build_up, std::nullopt, rules, in.fixed);
        lay_times(out, times, a, in.fixed);
        if (rules.reduced_build_up)
          entry.full_above[above_zero ? 1 : 0] = full_above(*tables_->scratch, build_up, a, times);
      }
  }
  tables_->trains.push_back(std::move(entry));
  return static_cast<std::uint32_t>(tables_->trains.size() - 1);
}

}  // namespace evc::batch
