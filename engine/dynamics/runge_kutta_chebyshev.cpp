// Runge-Kutta-Chebyshev of second order: Sommeijer, Shampine & Verwer, J. Comput. Appl. Math. 88 (1998) 315. As many
// stages as the step asks for: s of them are stable to 0.65 s^2 over the largest rate of the motion.
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "engine/block_sum.hpp"
#include "engine/dynamics/integrator.hpp"

namespace packstone::engine {

namespace {

constexpr double damping = 2.0 / 13;
constexpr int most_stages = 250;

/// Chebyshev polynomials T_j at w with their first two derivatives, j = 0..stages.
struct Chebyshev {
  std::vector<double> value, first, second;

  Chebyshev(int stages, double w) : value{1, w}, first{0, 1}, second{0, 0} {
    for (int j = 2; j <= stages; ++j) {
      const auto k = static_cast<std::size_t>(j);
      value.push_back(2 * w * value[k - 1] - value[k - 2]);
      first.push_back(2 * value[k - 1] + 2 * w * first[k - 1] - first[k - 2]);
      second.push_back(4 * first[k - 1] + 2 * w * second[k - 1] - second[k - 2]);
    }
  }
};

/// Stages whose stability reaches to a step times the largest rate.
int stages_for(double length_by_rate) {
  return std::max(2, 1 + static_cast<int>(std::sqrt(1 + 1.54 * length_by_rate)));
}

class RungeKuttaChebyshev final : public OverdampedMethod {
 public:
  explicit RungeKuttaChebyshev(double bed_rate) : bed_rate_(bed_rate), rate_(bed_rate) {}

  Attempt attempt(OverdampedSystem& system, const MotionStep& step) override {
    const int stages = stages_for(step.length * rate_);
    const double h = step.length;
    const std::size_t n = system.slots();
    const double w0 = 1 + damping / (stages * stages);
    const Chebyshev T(stages, w0);
    const double w1 = T.first[stages] / T.second[stages];
    const auto b = [&](int j) {
      return T.second[std::max(j, 2)] / (T.first[std::max(j, 2)] * T.first[std::max(j, 2)]);
    };
    const auto a = [&](int j) { return 1 - (j == 0 ? b(0) : b(j) * T.value[j]); };
    // b_1 is b_2 as well, and so c_1 = c_2/T_2'(w0).
    const auto instant = [&](int j) {
      const double share = j > 1 ? w1 * T.second[j] / T.first[j] : w1 * T.second[2] / T.first[2] / T.first[2];
      return step.time + h * share;
    };
    before_ = step.x0;
    stage_.resize(n);
    for_each_index(n, [&](std::size_t s) { stage_[s] = step.x0[s] + b(1) * w1 * h * step.v0[s]; });
    Attempt made;
    DrivenWork power = step.power;
    double seen = step.time;  // contacts may close and open within the step: trapezia from stage to stage
    const auto pass = [&](double time, const StepSums& sums) {
      made.work += 0.5 * (time - seen) * power;
      power = power_of(sums, h);
      made.work += 0.5 * (time - seen) * power;
      seen = time;
    };
    for (int j = 2; j <= stages; ++j) {
      pass(instant(j - 1), system.velocities(instant(j - 1), h, stage_, velocity_));
      const double mu = 2 * b(j) * w0 / b(j - 1), nu = -b(j) / b(j - 2), mu_rate = 2 * b(j) * w1 / b(j - 1);
      const double gamma_rate = -a(j - 1) * mu_rate;
      for_each_index(n, [&](std::size_t s) {
        const Vec3 next = (1 - mu - nu) * step.x0[s] + mu * stage_[s] + nu * before_[s] + mu_rate * h * velocity_[s] +
                          gamma_rate * h * step.v0[s];
        before_[s] = next;
      });
      std::swap(before_, stage_);
    }
    step.x1 = stage_;
    made.sums = system.velocities(step.time + h, h, step.x1, step.v1);
    pass(step.time + h, made.sums);
    for_each_index(
        n, [&](std::size_t s) { before_[s] = 0.8 * (step.x0[s] - step.x1[s]) + 0.4 * h * (step.v0[s] + step.v1[s]); });
    made.error = system.size_of(before_);
    return made;
  }

  void archive(Archive& a) override { a(rate_); }

  int error_order() const override { return 3; }
  bool ends_with_velocity() const override { return true; }

  double stable_step(OverdampedSystem& system, double time) override {
    constexpr double closing_contacts = 1.2;  // of those that close within the step
    rate_ = std::max(bed_rate_, closing_contacts * system.linearised(time).largest_rate(system.mobility()));
    return (static_cast<double>(most_stages) * most_stages) / 1.54 / rate_;
  }

 private:
  double bed_rate_, rate_;  ///< rate_: bound on that of the motion [1/s]
  SlotVectors stage_, before_, velocity_;
};

}  // namespace

std::unique_ptr<OverdampedMethod> make_runge_kutta_chebyshev(double bed_rate) {
  return std::make_unique<RungeKuttaChebyshev>(bed_rate);
}

}  // namespace packstone::engine
