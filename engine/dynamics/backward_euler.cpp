// Backward Euler: x1 = x0 + h v(x1), by Newton's method with the contacts' stiffnesses; each linear system by conjugate
// gradients, preconditioned by the 3 x 3 blocks on its diagonal. Overdamped motion runs down its energy, and so does
// this method: x1 is where the energy and the sum of mu (x1 - x0)^2 / 2h are least. Prestress is left out of the
// matrix, which it would make indefinite; a search along each correction makes up for that and for contacts that open
// and close.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/block_sum.hpp"
#include "engine/dynamics/integrator.hpp"

namespace packstone::engine {

namespace {

constexpr int most_newton_steps = 30;
constexpr int most_conjugate_directions = 400;
constexpr double overshoot = 0.3;         ///< of a correction's slope, uphill: beyond, it is cut short
constexpr double residual_share = 0.002;  ///< of the step's tolerance, that solving may leave
constexpr double forcing = 0.03;          ///< residual that a linear system may leave, of what it began with

double dot_of(const SlotVectors& a, const SlotVectors& b) {
  return sum_in_blocks<double>(a.size(), 0.0, [&](std::size_t s) { return a[s].dot(b[s]); });
}

class BackwardEuler final : public OverdampedMethod {
 public:
  explicit BackwardEuler(double tolerance) : residual_limit_(residual_share * tolerance) {}

  Attempt attempt(OverdampedSystem& system, const MotionStep& step) override {
    const std::size_t n = system.slots();
    const double h = step.length, time = step.time + h;
    step.x1.resize(n);
    step.v1.resize(n);
    residual_.resize(n);
    for_each_index(n, [&](std::size_t s) { step.x1[s] = step.x0[s] + h * step.v0[s]; });
    Attempt made;
    made.solved = false;
    for (int k = 0; k <= most_newton_steps && !made.solved; ++k) {
      made.sums = system.velocities(time, h, step.x1, velocity_);
      for_each_index(n, [&](std::size_t s) { residual_[s] = step.x0[s] + h * velocity_[s] - step.x1[s]; });
      const double left = system.size_of(residual_);
      if (!std::isfinite(left)) return made;
      made.solved = left <= residual_limit_;
      if (made.solved || k == most_newton_steps) break;
      if (k > 0 && cut_short(system, h, step.x1)) continue;
      correct(system, time, h, step.x1);
    }
    for_each_index(n, [&](std::size_t s) {
      step.v1[s] = (step.x1[s] - step.x0[s]) / h;
      residual_[s] = 0.5 * h * (step.v1[s] - step.v0[s]);
    });
    made.error = system.size_of(residual_);
    return made;
  }

  int error_order() const override { return 2; }
  bool ends_with_velocity() const override { return false; }
  double stable_step(OverdampedSystem&, double) override { return std::numeric_limits<double>::infinity(); }

 private:
  /// Takes back a part of the last correction where it has gone too far down the energy and up again.
  bool cut_short(const OverdampedSystem& system, double h, SlotVectors& x) {
    const std::vector<double>& mobility = system.mobility();
    const double slope = sum_in_blocks<double>(x.size(), 0.0, [&](std::size_t s) {
      return mobility[s] > 0 ? residual_[s].dot(correction_[s]) / (h * mobility[s]) : 0.0;
    });
    if (slope > -overshoot * slope_before_) return false;
    const double kept = slope_before_ / (slope_before_ - slope);
    for_each_index(x.size(), [&](std::size_t s) {
      x[s] -= (1 - kept) * correction_[s];
      correction_[s] *= kept;
    });
    slope_before_ *= kept;
    return true;
  }

  /// One step of Newton's method.
  void correct(OverdampedSystem& system, double time, double h, SlotVectors& x) {
    const std::vector<double>& mobility = system.mobility();
    const std::size_t n = x.size();
    const ContactMatrix& matrix = system.linearised(time);
    matrix.invert_diagonal(mobility, 1 / h, inverse_);
    correction_.assign(n, Vec3::Zero());
    direction_.assign(n, Vec3::Zero());
    image_.assign(n, Vec3::Zero());
    preconditioned_.assign(n, Vec3::Zero());
    const auto precondition = [&] {
      for_each_index(n, [&](std::size_t s) {
        if (mobility[s] > 0) preconditioned_[s] = inverse_[s] * residual_[s];
      });
    };
    for_each_index(n, [&](std::size_t s) {
      residual_[s] = mobility[s] > 0 ? Vec3(residual_[s] / (h * mobility[s])) : Vec3::Zero();  // a force
    });
    force_ = residual_;
    precondition();
    direction_ = preconditioned_;
    double square = dot_of(residual_, preconditioned_);
    const double enough = forcing * forcing * square;
    for (int k = 0; k < most_conjugate_directions && square > enough; ++k) {
      matrix.multiply(mobility, 1 / h, direction_, image_);
      const double curvature = dot_of(direction_, image_);
      const double length = square / curvature;
      for_each_index(n, [&](std::size_t s) {
        correction_[s] += length * direction_[s];
        residual_[s] -= length * image_[s];
      });
      precondition();
      const double before = std::exchange(square, dot_of(residual_, preconditioned_));
      for_each_index(n, [&](std::size_t s) { direction_[s] = preconditioned_[s] + square / before * direction_[s]; });
    }
    slope_before_ = dot_of(force_, correction_);
    for_each_index(n, [&](std::size_t s) { x[s] += correction_[s]; });
  }

  double slope_before_ = 0;  ///< of the energy along the last correction, downwards [J]
  double residual_limit_;    ///< over the mean radius
  SlotVectors velocity_, residual_, force_, correction_, direction_, image_, preconditioned_;
  std::vector<Mat3> inverse_;
};

}  // namespace

std::unique_ptr<OverdampedMethod> make_backward_euler(double tolerance) {
  return std::make_unique<BackwardEuler>(tolerance);
}

}  // namespace packstone::engine
