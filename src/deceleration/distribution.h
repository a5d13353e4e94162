#pragma once
#include <utility>
#include <variant>
#include <vector>

namespace evc::deceleration {

/// A normal variable, of which only the values from `from` to `to` occur if `is_cut`.
struct Normal {
  double mean = 0.0, deviation = 1.0;
  bool is_cut = false;
  double from = 0.0, to = 0.0;
};

/// Values that are equally likely from `from` to `to`, one value if these are equal, with this probability together.
struct Piece {
  double from = 0.0, to = 0.0;
  double probability = 1.0;
};

/// The values of a tilted variable (Distribution::tilted), by their quantile.
class Tilted {
 public:
  Tilted(const Normal& normal, double theta);
  Tilted(const std::vector<Piece>& pieces, double theta);
  /// The value for a uniform share, 0 < share < 1: uniform shares give values of the tilted distribution.
  double at(double share) const;

 private:
  struct Part {
    double from, to, until;  // until: the probability of this part and those before
  };
  double in_part(const Part& part, double share) const;

  bool normal_ = false, cut_ = false;
  double mean_ = 0.0, deviation_ = 0.0;
  double from_ = 0.0, to_ = 0.0;
  bool upper_ = false;  // most of the cut part is above the mean: probabilities are counted from above
  double first_ = 0.0, last_ = 0.0;
  double theta_ = 0.0;
  std::vector<Part> parts_;
};

/// How a factor of a braking force, or a response time, varies.
class Distribution {
 public:
  /// Always this value.
  explicit Distribution(double value = 1.0) : how_(std::vector<Piece>{{value, value, 1.0}}) {}
  /// The deviation above 0; if cut, from < to.
  explicit Distribution(const Normal& normal) : how_(normal) {}
  /// At least one; the probabilities together are made 1.
  explicit Distribution(std::vector<Piece> pieces);

  double mean() const;
  /// The logarithm of the mean of exp(-theta value); not finite where theta is so large that it cannot be computed.
  double log_transform(double theta) const;
  /// The distribution whose density is this one's times exp(-theta value), norm apart: for theta above 0 small values
  /// are more likely. Only where log_transform is finite.
  Tilted tilted(double theta) const;
  /// The bounds of its values; infinite for a normal variable that is not cut.
  std::pair<double, double> range() const;

 private:
  std::variant<Normal, std::vector<Piece>> how_;
};

}  // namespace evc::deceleration
