// Explicit Euler: x1 = x0 + h v0. Stable up to 2 over the largest rate of the motion.
#include <algorithm>

#include "engine/block_sum.hpp"
#include "engine/dynamics/integrator.hpp"

namespace packstone::engine {

namespace {

class Euler final : public OverdampedMethod {
 public:
  explicit Euler(double bed_rate) : bed_rate_(bed_rate) {}

  Attempt attempt(OverdampedSystem& system, const MotionStep& step) override {
    const std::size_t n = system.slots();
    step.x1.resize(n);
    for_each_index(n, [&](std::size_t s) { step.x1[s] = step.x0[s] + step.length * step.v0[s]; });
    Attempt made;
    made.sums = system.velocities(step.time + step.length, step.length, step.x1, step.v1);
    made.work = 0.5 * step.length * step.power;
    made.work += 0.5 * step.length * power_of(made.sums, step.length);
    difference_.resize(n);
    // What the trapezium rule would add.
    for_each_index(n, [&](std::size_t s) { difference_[s] = 0.5 * step.length * (step.v1[s] - step.v0[s]); });
    made.error = system.size_of(difference_);
    return made;
  }

  void archive(Archive& a) override { a(rate_, calls_); }

  int error_order() const override { return 2; }
  bool ends_with_velocity() const override { return true; }

  double stable_step(OverdampedSystem& system, double time) override {
    constexpr int calls_apart = 32;
    // Contacts that close in between are few beside what Gershgorin's bound is too large.
    if (calls_++ % calls_apart == 0) rate_ = system.linearised(time).largest_rate(system.mobility());
    return 2 / std::max(rate_, bed_rate_);
  }

 private:
  SlotVectors difference_;
  double bed_rate_, rate_ = 0;  ///< [1/s]
  std::int64_t calls_ = 0;
};

}  // namespace

std::unique_ptr<OverdampedMethod> make_euler(double bed_rate) { return std::make_unique<Euler>(bed_rate); }

}  // namespace packstone::engine
