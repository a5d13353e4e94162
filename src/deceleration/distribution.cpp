#include "deceleration/distribution.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "random/draws.h"

namespace evc::deceleration {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

/// The probability of a standard normal variable above z.
double above(double z) { return 0.5 * std::erfc(z / std::numbers::sqrt2); }

double density(double z) { return std::exp(-0.5 * z * z) / std::sqrt(2.0 * std::numbers::pi); }

/// The probability between a and b, a < b, without cancellation in the upper tail.
double between(double a, double b) { return a > 0.0 ? above(a) - above(b) : above(-b) - above(-a); }

/// The mean of exp(-h share) over uniform shares, h >= 0.
double uniform_transform(double h) { return h < 1e-9 ? 1.0 - 0.5 * h : -std::expm1(-h) / h; }

/// The logarithm of the mean of exp(-theta value) in a piece.
double log_transform_of(const Piece& piece, double theta) {
  const double h = theta * (piece.to - piece.from);
  return -theta * (h >= 0.0 ? piece.from : piece.to) + std::log(uniform_transform(std::abs(h)));
}

double log_of_sum(const std::vector<double>& logarithms) {
  const double largest = *std::max_element(logarithms.begin(), logarithms.end());
  double sum = 0.0;
  for (const double l : logarithms) sum += std::exp(l - largest);
  return largest + std::log(sum);
}

std::vector<double> logarithms_of(const std::vector<Piece>& pieces, double theta) {
  std::vector<double> logarithms;
  logarithms.reserve(pieces.size());
  for (const Piece& piece : pieces) logarithms.push_back(std::log(piece.probability) + log_transform_of(piece, theta));
  return logarithms;
}

}  // namespace

Tilted::Tilted(const Normal& normal, double theta)
    : normal_(true),
      cut_(normal.is_cut),
      mean_(normal.mean - theta * normal.deviation * normal.deviation),
      deviation_(normal.deviation),
      from_(normal.from),
      to_(normal.to) {
  if (!cut_) return;
  const double a = (from_ - mean_) / deviation_, b = (to_ - mean_) / deviation_;
  upper_ = a + b > 0.0;
  first_ = above(upper_ ? a : -a);
  last_ = above(upper_ ? b : -b);
}

Tilted::Tilted(const std::vector<Piece>& pieces, double theta) : theta_(theta) {
  const std::vector<double> logarithms = logarithms_of(pieces, theta);
  const double all = log_of_sum(logarithms);
  double until = 0.0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    until += std::exp(logarithms[i] - all);
    parts_.push_back({pieces[i].from, pieces[i].to, until});
  }
}

double Tilted::in_part(const Part& part, double share) const {
  const double length = part.to - part.from;
  const double h = theta_ * length;
  if (std::abs(h) < 1e-9) return std::min(part.from + share * length, part.to);
  const double step = -std::log1p(share * std::expm1(-std::abs(h))) / std::abs(theta_);
  return h > 0.0 ? std::min(part.from + step, part.to) : std::max(part.to - step, part.from);
}

double Tilted::at(double share) const {
  if (normal_) {
    if (!cut_) return mean_ + deviation_ * random::normal_quantile(share);
    // The sum is rounded: it must not become 0 or 1.
    const double p = std::clamp(first_ + share * (last_ - first_), 1e-300, 1.0 - kEpsilon);
    const double z = random::normal_quantile(p);
    return std::clamp(mean_ + deviation_ * (upper_ ? -z : z), from_, to_);
  }
  std::size_t i = 0;
  while (i + 1 < parts_.size() && !(share < parts_[i].until)) ++i;
  const Part& part = parts_[i];
  if (part.from == part.to) return part.from;
  const double before = i == 0 ? 0.0 : parts_[i - 1].until;
  return in_part(part, std::clamp((share - before) / (part.until - before), 0.0, 1.0));
}

Distribution::Distribution(std::vector<Piece> pieces) {
  double all = 0.0;
  for (const Piece& piece : pieces) all += piece.probability;
  for (Piece& piece : pieces) piece.probability /= all;
  how_ = std::move(pieces);
}

double Distribution::mean() const {
  if (const auto* pieces = std::get_if<std::vector<Piece>>(&how_)) {
    double sum = 0.0;
    for (const Piece& piece : *pieces) sum += piece.probability * 0.5 * (piece.from + piece.to);
    return sum;
  }
  const Normal& normal = std::get<Normal>(how_);
  if (!normal.is_cut) return normal.mean;
  const double a = (normal.from - normal.mean) / normal.deviation;
  const double b = (normal.to - normal.mean) / normal.deviation;
  const double mean = normal.mean + normal.deviation * (density(a) - density(b)) / between(a, b);
  return std::clamp(mean, normal.from, normal.to);
}

double Distribution::log_transform(double theta) const {
  if (const auto* pieces = std::get_if<std::vector<Piece>>(&how_)) return log_of_sum(logarithms_of(*pieces, theta));
  const Normal& normal = std::get<Normal>(how_);
  const double moved = normal.mean - theta * normal.deviation * normal.deviation;
  const double whole = -theta * 0.5 * (normal.mean + moved);
  if (!normal.is_cut) return whole;
  const auto inside = [&](double mean) {
    return between((normal.from - mean) / normal.deviation, (normal.to - mean) / normal.deviation);
  };
  // Beyond this the tail has too few digits: the caller tilts less.
  if (inside(moved) < 1e-280) return kInfinity;
  return whole + std::log(inside(moved) / inside(normal.mean));
}

Tilted Distribution::tilted(double theta) const {
  return std::visit([theta](const auto& how) { return Tilted(how, theta); }, how_);
}

std::pair<double, double> Distribution::range() const {
  if (const auto* normal = std::get_if<Normal>(&how_))
    return normal->is_cut ? std::pair(normal->from, normal->to) : std::pair(-kInfinity, kInfinity);
  std::pair<double, double> range{kInfinity, -kInfinity};
  for (const Piece& piece : std::get<std::vector<Piece>>(how_))
    range = {std::min(range.first, piece.from), std::max(range.second, piece.to)};
  return range;
}

}  // namespace evc::deceleration
