// How overdamped motion gets from one instant to the next, one method a file.
#pragma once

#include <memory>

#include "engine/dynamics/overdamped_system.hpp"

namespace packstone::engine {

/// Of growing radii and of moving boundaries on the particles, at an instant [W] or over a step [J].
struct DrivenWork {
  double growth = 0, walls = 0;

  void archive(Archive& a) { a(growth, walls); }

  DrivenWork& operator+=(const DrivenWork& o) {
    growth += o.growth;
    walls += o.walls;
    return *this;
  }
  friend DrivenWork operator*(double a, const DrivenWork& w) { return {a * w.growth, a * w.walls}; }
};

/// dt: of the step that the sums were found for [s].
inline DrivenWork power_of(const StepSums& sums, double dt) { return {sums.growth_work / dt, sums.wall_work / dt}; }

/// From an instant to a later one; by slot.
struct MotionStep {
  double time, length;    ///< [s]
  DrivenWork power;       ///< at its beginning [W]
  const SlotVectors& x0;  ///< [m]
  const SlotVectors& v0;  ///< [m/s]
  SlotVectors& x1;
  SlotVectors& v1;
};

struct Attempt {
  bool solved = true;  ///< else x1 and v1 are nothing
  double error = 0;    ///< of the positions, root mean square over the mean radius
  StepSums sums;       ///< at the step's end; length of the step as dt
  DrivenWork work;     ///< over the step, by the method's own quadrature [J]
};

class OverdampedMethod {
 public:
  virtual ~OverdampedMethod() = default;

  virtual Attempt attempt(OverdampedSystem& system, const MotionStep& step) = 0;

  /// What it keeps from step to step.
  virtual void archive(Archive& a) = 0;

  /// An error goes as the step's length to this power.
  virtual int error_order() const = 0;
  /// Whether v1 is the velocity at x1 rather than the mean over the step.
  virtual bool ends_with_velocity() const = 0;
  /// Longest stable step with the contacts that there are [s].
  virtual double stable_step(OverdampedSystem& system, double time) = 0;
};

/// bed_rate: largest rate of the motion to be expected in a bed, contacts that close within a step included [1/s].
std::unique_ptr<OverdampedMethod> make_euler(double bed_rate);
std::unique_ptr<OverdampedMethod> make_runge_kutta_chebyshev(double bed_rate);
/// tolerance: of the step, to which equations are solved finely enough.
std::unique_ptr<OverdampedMethod> make_backward_euler(double tolerance);

}  // namespace packstone::engine
