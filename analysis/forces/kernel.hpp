// Kernels of coarse-graining and their integrals.
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "analysis/options.hpp"

namespace packstone::analysis {

/// A spherical kernel phi(r) of integral 1, and its mean over planes.
/// Lucy: phi = 105 / (16 pi c^3) (1 + 3 q) (1 - q)^3, q = r/c < 1, range c = sqrt(12) width.
/// Gaussian: phi ~ exp(-r^2 / (2 width^2)), cut off at 3 widths and normalised.
/// width: standard deviation along one axis (of the Gaussian before its cut).
/// Sources: Lucy, Astron. J. 82 (1977) 1013; Goldhirsch, Granular Matter 12 (2010) 239; Weinhart, Thornton, Luding,
/// Bokhove, Granular Matter 14 (2012) 289.
class CoarseKernel {
 public:
  /// width > 0 [m].
  CoarseKernel(Kernel kind, double width);

  double width() const { return width_; }

  /// phi is 0 from this distance on [m].
  double range() const { return range_; }

  /// phi at eight distances at once, by their squares [m2] [1/m3].
  using Eight = Eigen::Array<double, 8, 1>;
  Eight densities(const Eight& squares) const {
    if (kind_ == Kernel::gaussian) {
      return (squares < range_ * range_).select(peak_ * (-0.5 * per_scale_ * per_scale_ * squares).exp(), 0);
    }
    Eight q = per_scale_ * per_scale_ * squares;
    for (double& each : q) each = std::sqrt(each < 1 ? each : 1);  // Eigen's root is not exact with AVX-512
    const Eight rest = 1 - q;
    return peak_ * (1 + 3 * q) * rest * rest * rest;
  }

  /// phi [1/m3].
  double density(double r) const { return densities(Eight::Constant(r * r))[0]; }

  /// Share of the kernel below a plane at signed height h over its centre: 0 for h <= -range, 1 for h >= range.
  double below(double h) const;

  /// Integral of below() from -infinity to h [m]: its difference over a line gives the mean of below() along the line.
  double below_integral(double h) const;

 private:
  double integral_from_middle(double distance) const;

  Kernel kind_;
  double width_;
  double range_;
  double per_scale_;  ///< 1 / range of Lucy's kernel, 1 / width of the Gaussian [1/m]
  double peak_;       ///< [1/m3]
  double integral_at_range_;
};

}  // namespace packstone::analysis
