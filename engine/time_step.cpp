#include "engine/time_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "engine/contact/collision.hpp"
#include "engine/contact/contact_scales.hpp"
#include "engine/contact_pairs.hpp"
#include "engine/dynamics/step.hpp"

namespace packstone::engine {

namespace {

constexpr double packing_share = 0.17;        ///< of sqrt(m/k), for a sphere with many contacts
constexpr double solid_sphere_sliding = 3.5;  ///< 1 + m R^2/I: the contact point's share of inertia in sliding
constexpr double dashpot_share = 0.5;         ///< of the dashpot's limit

std::string in_microseconds(double seconds) { return fmt::format("{:.3g} us", seconds * 1e6); }

}  // namespace

StepLimit step_limit(const Scene& scene, const Population& population) {
  StepLimit tightest;
  tightest.limit = tightest.recommended = std::numeric_limits<double>::infinity();
  for (const ContactPair& c : contact_pairs(scene, population)) {
    const double m = c.effective_mass();
    const ContactScales scales =
        contact_scales(scene, *c.a, *c.b, c.size, scene.monitor.overlap_limit * c.smaller_radius);
    const double tangential = scales.tangential_stiffness;
    const double steepest = std::max(scales.steepest, solid_sphere_sliding * tangential);
    const double dashpot = std::max(scales.damping, solid_sphere_sliding * scales.tangential_damping);
    const double dashpot_limit = dashpot > 0 ? m / dashpot : std::numeric_limits<double>::infinity();
    const double recommended =
        std::min(packing_share * std::sqrt(2 * m / std::max({scales.stiffness, tangential, scales.attraction_slope})),
                 dashpot_share * dashpot_limit);
    tightest.recommended = std::min(tightest.recommended, recommended);
    const double limit = std::min(2 / std::sqrt(steepest / m), dashpot_limit);
    if (limit >= tightest.limit) continue;
    tightest.limit = limit;
    tightest.contact_time = undamped_contact_time(scales.stiffness, m);
    tightest.stiffness = steepest;
    tightest.effective_mass = m;
    tightest.pair = c.name;
  }
  return tightest;
}

double checked_time_step(const Scene& scene, const StepLimit& limit, std::vector<std::string>& warnings) {
  if (!scene.dynamics.time_step) return limit.recommended;
  const double dt = *scene.dynamics.time_step;
  if (dt > limit.limit) {
    scene.fail("dynamics.time_step",
               fmt::format("{} is beyond the stability limit {} (2/omega) of the contact {} (k = {:.4g} N/m, m_eff = "
                           "{:.4g} kg); take at most {}",
                           in_microseconds(dt), in_microseconds(limit.limit), limit.pair, limit.stiffness,
                           limit.effective_mass, in_microseconds(limit.recommended)));
  }
  if (dt > limit.recommended) {
    warnings.push_back(fmt::format(
        "dynamics.time_step: {} is {:.1f} steps in the contact {} ({} long); {} or less is recommended in a packing, "
        "and results may depend on the step",
        in_microseconds(dt), limit.contact_time / dt, limit.pair, in_microseconds(limit.contact_time),
        in_microseconds(limit.recommended)));
  }
  return dt;
}

}  // namespace packstone::engine
