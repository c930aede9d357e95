// Real spherical harmonics of degrees 4 and 6.
#pragma once

#include <array>
#include <cmath>

#include "core/vec3.hpp"

namespace packstone::analysis {

inline constexpr int harmonics_of_4 = 9;   ///< 2 l + 1
inline constexpr int harmonics_of_6 = 13;  ///< 2 l + 1

/// Values or sums of sqrt(4 pi/(2 l + 1)) Y_lm with real orthonormal Y_lm: those of degree 4, then those of degree 6,
/// each in the order m = 0, then cosine and sine of m = 1 .. l.
using Harmonics = std::array<double, harmonics_of_4 + harmonics_of_6>;

/// Factors of the recurrence for K_lm = sqrt((l - m)!/(l + m)!) P_lm(z)/(1 - z^2)^(m/2), without Condon and Shortley's
/// sign:
///   K_mm = sqrt((2 m - 1)/(2 m)) K_{m-1,m-1},
///   sqrt(l^2 - m^2) K_lm = (2 l - 1) z K_{l-1,m} - sqrt((l - 1)^2 - m^2) K_{l-2,m}.
/// Source: NIST Digital Library of Mathematical Functions, 14.10.3, normalised.
class HarmonicsRecurrence {
 public:
  HarmonicsRecurrence() {
    double diagonal = 1;
    for (int m = 0; m <= degree; ++m) {
      if (m > 0) diagonal *= std::sqrt((2 * m - 1) / (2.0 * m));
      start_[m] = m == 0 ? 1 : std::sqrt(2.0) * diagonal;  // the sqrt(2) makes cosine and sine orthonormal
      for (int l = m + 1; l <= degree; ++l) {
        const double norm = std::sqrt(static_cast<double>(l * l - m * m));
        up_[m][l] = (2 * l - 1) / norm;
        down_[m][l] = l > m + 1 ? std::sqrt(static_cast<double>((l - 1) * (l - 1) - m * m)) / norm : 0;
      }
    }
  }

  /// Adds the harmonics of a unit vector.
  void add(const Vec3& n, Harmonics& sum) const {
    double cosine = 1, sine = 0;  // of m phi, times sin(theta)^m: (x + i y)^m
#pragma GCC unroll 7
    for (int m = 0; m <= degree; ++m) {
      double before = 0, value = start_[m], of_4 = m == 4 ? value : 0;
#pragma GCC unroll 7
      for (int l = m + 1; l <= degree; ++l) {
        const double next = up_[m][l] * n.z() * value - down_[m][l] * before;
        before = value;
        value = next;
        if (l == 4) of_4 = value;
      }
      double* const four = sum.data() + (m == 0 ? 0 : 2 * m - 1);
      double* const six = four + harmonics_of_4;
      if (m <= 4) four[0] += of_4 * cosine;
      six[0] += value * cosine;
      if (m > 0) {
        if (m <= 4) four[1] += of_4 * sine;
        six[1] += value * sine;
      }
      const double turned = cosine * n.x() - sine * n.y();
      sine = cosine * n.y() + sine * n.x();
      cosine = turned;
    }
  }

 private:
  static constexpr int degree = 6;
  std::array<double, degree + 1> start_{};
  std::array<std::array<double, degree + 1>, degree + 1> up_{}, down_{};  // by m, then l
};

/// Scalar products of the parts of degree 4 and 6; of two unit vectors P_4 and P_6 of the cosine between them.
inline double product_of_4(const Harmonics& a, const Harmonics& b) {
  double sum = 0;
  for (int k = 0; k < harmonics_of_4; ++k) sum += a[k] * b[k];
  return sum;
}
inline double product_of_6(const Harmonics& a, const Harmonics& b) {
  double sum = 0;
  for (int k = harmonics_of_4; k < harmonics_of_4 + harmonics_of_6; ++k) sum += a[k] * b[k];
  return sum;
}

}  // namespace packstone::analysis
