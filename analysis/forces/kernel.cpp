#include "analysis/forces/kernel.hpp"

#include <cmath>
#include <numbers>

namespace packstone::analysis {

namespace {

constexpr double gaussian_cut = 3;  // widths
const double lucy_range = std::sqrt(12.0);

const double gaussian_at_cut = std::exp(-gaussian_cut * gaussian_cut / 2);
const double root_two_pi = std::sqrt(2 * std::numbers::pi);

/// Share of the whole Gaussian inside the cut: erf(c / sqrt 2) - sqrt(2 / pi) c exp(-c^2 / 2).
const double gaussian_inside =
    std::erf(gaussian_cut / std::numbers::sqrt2) - 2 / root_two_pi * gaussian_cut * gaussian_at_cut;

// The mean over a plane at height x (widths) is g = (exp(-x^2/2) - exp(-c^2/2)) / (sqrt(2 pi) inside); from 0:
double gaussian_share(double x) {
  return (0.5 * std::erf(x / std::numbers::sqrt2) - x * gaussian_at_cut / root_two_pi) / gaussian_inside;
}

double gaussian_share_integral(double x) {
  const double of_erf = 0.5 * x * std::erf(x / std::numbers::sqrt2) + (std::exp(-x * x / 2) - 1) / root_two_pi;
  return (of_erf - 0.5 * x * x * gaussian_at_cut / root_two_pi) / gaussian_inside;
}

// The mean over a plane at height q >= 0 (ranges) is g = 105/8 (1/10 - q^2/2 + 3/2 q^4 - 8/5 q^5 + q^6/2); from 0:
double lucy_share(double q) {
  const double q2 = q * q;
  return 105.0 / 8 * q * (0.1 + q2 * (-1.0 / 6 + q2 * (0.3 + q * (-4.0 / 15 + q / 14))));
}

double lucy_share_integral(double q) {
  const double q2 = q * q;
  return 105.0 / 8 * q2 * (0.05 + q2 * (-1.0 / 24 + q2 * (0.05 + q * (-4.0 / 105 + q / 112))));
}

/// phi in the middle [1/m3].
double peak(Kernel kind, double width) {
  if (kind == Kernel::gaussian) return 1 / (std::pow(root_two_pi * width, 3) * gaussian_inside);
  return 105 / (16 * std::numbers::pi * std::pow(lucy_range * width, 3));
}

}  // namespace

CoarseKernel::CoarseKernel(Kernel kind, double width)
    : kind_(kind),
      width_(width),
      range_(width * (kind == Kernel::lucy ? lucy_range : gaussian_cut)),
      per_scale_(1 / (kind == Kernel::lucy ? range_ : width_)),
      peak_(peak(kind, width)),
      integral_at_range_(integral_from_middle(range_)) {}

double CoarseKernel::integral_from_middle(double distance) const {
  const double x = distance * per_scale_;
  return (kind_ == Kernel::lucy ? lucy_share_integral(x) : gaussian_share_integral(x)) / per_scale_;
}

double CoarseKernel::below(double h) const {
  if (h <= -range_) return 0;
  if (h >= range_) return 1;
  const double x = std::abs(h) * per_scale_;
  return 0.5 + std::copysign(kind_ == Kernel::lucy ? lucy_share(x) : gaussian_share(x), h);
}

double CoarseKernel::below_integral(double h) const {
  if (h <= -range_) return 0;
  if (h >= range_) return h;  // the kernel is even
  return 0.5 * (h + range_) + integral_from_middle(std::abs(h)) - integral_at_range_;
}

}  // namespace packstone::analysis
