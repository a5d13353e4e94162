#include "random/draws.h"

#include <boost/random/sobol.hpp>
#include <cmath>
#include <span>

#include "random/philox.h"

namespace evc::random {
namespace {

/// The upper 53 bits as a share of 1.
double share_of(std::uint64_t bits) { return static_cast<double>(bits >> 11) / 9007199254740992.0; }

/// Coefficients from the lowest power.
double polynomial(std::span<const double> coefficients, double x) {
  double sum = 0.0;
  for (std::size_t i = coefficients.size(); i-- > 0;) sum = sum * x + coefficients[i];
  return sum;
}

// Wichura, The percentage points of the normal distribution, Applied Statistics 37 (1988): PPND16.
constexpr double kCentre[] = {3.3871328727963666080e0,  1.3314166789178437745e+2, 1.9715909503065514427e+3,
                              1.3731693765509461125e+4, 4.5921953931549871457e+4, 6.7265770927008700853e+4,
                              3.3430575583588128105e+4, 2.5090809287301226727e+3};
constexpr double kCentreBelow[] = {1.0,
                                   4.2313330701600911252e+1,
                                   6.8718700749205790830e+2,
                                   5.3941960214247511077e+3,
                                   2.1213794301586595867e+4,
                                   3.9307895800092710610e+4,
                                   2.8729085735721942674e+4,
                                   5.2264952788528545610e+3};
constexpr double kSide[] = {1.42343711074968357734e0,  4.63033784615654529590e0, 5.76949722146069140550e0,
                            3.64784832476320460504e0,  1.27045825245236838258e0, 2.41780725177450611770e-1,
                            2.27238449892691845833e-2, 7.74545014278341407640e-4};
constexpr double kSideBelow[] = {1.0,
                                 2.05319162663775882187e0,
                                 1.67638483018380384940e0,
                                 6.89767334985100004550e-1,
                                 1.48103976427480074590e-1,
                                 1.51986665636164571966e-2,
                                 5.47593808499534494600e-4,
                                 1.05075007164441684324e-9};
constexpr double kTail[] = {6.65790464350110377720e0,  5.46378491116411436990e0,  1.78482653991729133580e0,
                            2.96560571828504891230e-1, 2.65321895265761230930e-2, 1.24266094738807843860e-3,
                            2.71155556874348757815e-5, 2.01033439929228813265e-7};
constexpr double kTailBelow[] = {1.0,
                                 5.99832206555887937690e-1,
                                 1.36929880922735805310e-1,
                                 1.48753612908506148525e-2,
                                 7.86869131145613259100e-4,
                                 1.84631831751005468180e-5,
                                 1.42151175831644588870e-7,
                                 2.04426310338993978564e-15};

}  // namespace

double uniform_draw(std::uint64_t seed, std::uint64_t number, std::uint32_t entry) {
  const auto low = [](std::uint64_t word) { return static_cast<std::uint32_t>(word); };
  const auto high = [](std::uint64_t word) { return static_cast<std::uint32_t>(word >> 32); };
  const auto bits = philox({low(number), high(number), entry, 0}, {low(seed), high(seed)});
  return share_of(std::uint64_t{bits[1]} << 32 | bits[0]);
}

double normal_quantile(double p) {
  const double q = p - 0.5;
  if (std::abs(q) <= 0.425) {
    const double r = 0.180625 - q * q;
    return q * polynomial(kCentre, r) / polynomial(kCentreBelow, r);
  }
  const double r = std::sqrt(-std::log(q < 0.0 ? p : 1.0 - p));
  const double side = r <= 5.0 ? polynomial(kSide, r - 1.6) / polynomial(kSideBelow, r - 1.6)
                               : polynomial(kTail, r - 5.0) / polynomial(kTailBelow, r - 5.0);
  return q < 0.0 ? -side : side;
}

Sobol::Sobol(std::size_t dimensions) : directions_(dimensions) {
  if (dimensions == 0) return;
  boost::random::sobol engine(dimensions);
  for (std::size_t bit = 0; bit < kBits; ++bit) {
    // The Gray code of 2^(bit + 1) - 1 has this bit alone: the point is its direction number. Boost counts without the
    // origin.
    engine.seed((std::uint64_t{2} << bit) - 2);
    for (auto& direction : directions_) direction[bit] = engine();
  }
}

double Sobol::at(std::uint64_t number, std::size_t dimension) const {
  const std::uint64_t gray = (number + 1) ^ ((number + 1) >> 1);
  std::uint64_t bits = 0;
  for (std::size_t bit = 0; bit < kBits; ++bit)
    if ((gray >> bit & 1u) != 0) bits ^= directions_[dimension][bit];
  return share_of(bits);
}

}  // namespace evc::random
