// Backward Euler: x1 = x0 + h v(x1), by Newton's method with the contacts' stiffnesses; each linear system by conjugate
// gradients, preconditioned by the 3 x 3 blocks on its diagonal. Overdamped motion runs down its energy, and so does
// this method: x1 is where Phi = energy + sum of mu (x1 - x0)^2 / 2h is least near x0. Prestress is left out of the
// matrix, which it would make indefinite. Each correction is searched along until Phi falls, so that contacts which
// open and close cannot lead uphill, and no step is taken without one: in steps short enough, going on at the velocity
// of the step before would count as solved, and a sphere went on into the floor with it.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/block_sum.hpp"
#include "engine/dynamics/integrator.hpp"

namespace packstone::engine {

namespace {

constexpr int most_newton_steps = 40;
constexpr int most_conjugate_directions = 400;
constexpr int most_cuts = 12;                            ///< of one correction
constexpr double shortest_cut = 0.1, longest_cut = 0.7;  ///< share of a correction that a cut may leave
constexpr double longest_correction = 0.3;               ///< of its radius, that a particle may go in one
constexpr double overshoot = 0.3;                        ///< of a correction's slope, uphill: beyond, it is cut short
constexpr double residual_share = 0.02;   ///< of the step's tolerance, that solving may leave, root mean square
constexpr double largest_over_mean = 10;  ///< of one particle's residual over that
constexpr double forcing = 0.03;          ///< residual that a linear system may leave, of what it began with
constexpr double rounding = 1e-10;        ///< of the energies that Phi is the sum of

double dot_of(const SlotVectors& a, const SlotVectors& b) {
  return sum_in_blocks<double>(a.size(), 0.0, [&](std::size_t s) { return a[s].dot(b[s]); });
}

class BackwardEuler final : public OverdampedMethod {
 public:
  explicit BackwardEuler(double tolerance) : residual_limit_(residual_share * tolerance) {}

  Attempt attempt(OverdampedSystem& system, const MotionStep& step) override {
    const std::size_t n = system.slots();
    const double h = step.length;
    Attempt made;
    made.solved = false;
    step.x1 = step.x0;
    made.sums = look(system, step);
    for (int k = 0; k < most_newton_steps && !made.solved; ++k) {
      if (!std::isfinite(system.size_of(residual_))) return made;
      correct(system, h);
      if (!go_down(system, step, made.sums)) return made;
      made.solved =
          system.size_of(residual_) <= residual_limit_ && largest_share(system) <= largest_over_mean * residual_limit_;
    }
    step.v1.resize(n);
    for_each_index(n, [&](std::size_t s) {
      step.v1[s] = (step.x1[s] - step.x0[s]) / h;
      residual_[s] = 0.5 * h * (step.v1[s] - step.v0[s]);
    });
    made.error = system.size_of(residual_);
    made.work = h * power_of(made.sums, h);  // as the forces of the step are those at its end
    return made;
  }

  void archive(Archive&) override {}

  int error_order() const override { return 2; }
  bool ends_with_velocity() const override { return false; }
  double stable_step(OverdampedSystem&, double) override { return std::numeric_limits<double>::infinity(); }

 private:
  /// What Phi is made of [J].
  struct Energy {
    double stored = 0, drag = 0, fallen = 0;
    double sum() const { return stored + drag - fallen; }
    double noise() const { return rounding * (stored + drag + std::abs(fallen)); }
  };

  /// Forces, stiffnesses, residual and Phi where the particles are.
  StepSums look(OverdampedSystem& system, const MotionStep& step) {
    const double h = step.length, time = step.time + h;
    const StepSums sums = system.velocities(time, h, step.x1, velocity_);
    const std::vector<double>& mobility = system.mobility();
    residual_.resize(step.x1.size());
    for_each_index(step.x1.size(), [&](std::size_t s) { residual_[s] = step.x0[s] + h * velocity_[s] - step.x1[s]; });
    matrix_ = &system.linearised(time);
    energy_ = {matrix_->energy(), 0, 0};
    for (std::size_t s = 0; s < step.x1.size(); ++s) {
      if (mobility[s] <= 0) continue;
      const Vec3 moved = step.x1[s] - step.x0[s];
      energy_.drag += moved.squaredNorm() / (2 * h * mobility[s]);
      energy_.fallen += system.weight(s).dot(moved);
    }
    return sums;
  }

  double largest_share(const OverdampedSystem& system) const {
    double largest = 0;
    for (std::size_t s = 0; s < residual_.size(); ++s) {
      if (system.mobility()[s] > 0) largest = std::max(largest, residual_[s].norm() / system.radius(s));
    }
    return largest;
  }

  /// Applies the correction, as much of it as lowers Phi. False if none does.
  bool go_down(OverdampedSystem& system, const MotionStep& step, StepSums& sums) {
    const std::vector<double>& mobility = system.mobility();
    const Energy before = energy_;
    start_ = step.x1;
    const auto slope = [&] {
      return sum_in_blocks<double>(start_.size(), 0.0, [&](std::size_t s) {
        return mobility[s] > 0 ? residual_[s].dot(correction_[s]) / (step.length * mobility[s]) : 0.0;
      });
    };
    for (int k = 0; k <= most_cuts; ++k) {
      for_each_index(start_.size(), [&](std::size_t s) { step.x1[s] = start_[s] + correction_[s]; });
      sums = look(system, step);
      const double now = slope();
      const bool lower = energy_.sum() <= before.sum() + before.noise() + energy_.noise();
      if (lower && now >= -overshoot * slope_) return true;
      // Where the slopes along the correction have it vanish.
      const double kept = std::clamp(slope_ / (slope_ - now), shortest_cut, longest_cut);
      for_each_index(start_.size(), [&](std::size_t s) { correction_[s] *= kept; });
      slope_ *= kept;
    }
    return false;
  }

  /// Newton's, from where the particles were last looked at.
  void correct(OverdampedSystem& system, double h) {
    const std::vector<double>& mobility = system.mobility();
    const std::size_t n = residual_.size();
    matrix_->invert_diagonal(mobility, 1 / h, inverse_);
    correction_.assign(n, Vec3::Zero());
    image_.assign(n, Vec3::Zero());
    preconditioned_.assign(n, Vec3::Zero());
    const auto precondition = [&] {
      for_each_index(n, [&](std::size_t s) {
        if (mobility[s] > 0) preconditioned_[s] = inverse_[s] * force_[s];
      });
    };
    for_each_index(n, [&](std::size_t s) {
      residual_[s] = mobility[s] > 0 ? Vec3(residual_[s] / (h * mobility[s])) : Vec3::Zero();  // a force
    });
    force_ = residual_;
    precondition();
    direction_ = preconditioned_;
    double square = dot_of(force_, preconditioned_);
    const double enough = forcing * forcing * square;
    for (int k = 0; k < most_conjugate_directions && square > enough; ++k) {
      matrix_->multiply(mobility, 1 / h, direction_, image_);
      const double curvature = dot_of(direction_, image_);
      const double length = square / curvature;
      for_each_index(n, [&](std::size_t s) {
        correction_[s] += length * direction_[s];
        force_[s] -= length * image_[s];
      });
      precondition();
      const double before = std::exchange(square, dot_of(force_, preconditioned_));
      for_each_index(n, [&](std::size_t s) { direction_[s] = preconditioned_[s] + square / before * direction_[s]; });
    }
    double farthest = 0;  // over the radius
    for (std::size_t s = 0; s < n; ++s) {
      if (mobility[s] > 0) farthest = std::max(farthest, correction_[s].norm() / system.radius(s));
    }
    const double kept = farthest > longest_correction ? longest_correction / farthest : 1.0;
    for_each_index(n, [&](std::size_t s) { correction_[s] *= kept; });
    slope_ = dot_of(residual_, correction_);
  }

  const ContactMatrix* matrix_ = nullptr;  ///< where the particles were last looked at
  Energy energy_;                          ///< there
  double slope_ = 0;                       ///< of Phi along the correction, downwards [J]
  double residual_limit_;                  ///< over the mean radius
  SlotVectors start_, velocity_, residual_, force_, correction_, direction_, image_, preconditioned_;
  std::vector<Mat3> inverse_;
};

}  // namespace

std::unique_ptr<OverdampedMethod> make_backward_euler(double tolerance) {
  return std::make_unique<BackwardEuler>(tolerance);
}

}  // namespace packstone::engine
