#include "engine/rest/relaxation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/run_verdict.hpp"
#include "engine/block_sum.hpp"
#include "engine/boundary/boundaries.hpp"
#include "engine/dynamics/force_field.hpp"
#include "engine/dynamics/make_particles.hpp"
#include "engine/filling/growth.hpp"
#include "engine/filling/population.hpp"
#include "engine/stopwatch.hpp"
#include "engine/time_step.hpp"

namespace packstone::engine {

namespace {

// Of the method; as in its papers but for the step, which is a share of sqrt(m/k).
constexpr double first_turning = 0.1;   ///< share of the velocity that is turned towards the force
constexpr double least_turning = 0.02;  ///< 0 in the papers; without it beds shoot past and swing
constexpr double turning_decay = 0.99, step_growth = 1.1, step_cut = 0.5;
constexpr double first_step = 0.05, shortest_step = 0.02;  ///< of the longest
constexpr int steps_before_growth = 20;

constexpr double longest_step_over_recommended = 3;  ///< 0.5 sqrt(m/k)
constexpr double longest_move = 0.05;                ///< of its radius, that a particle may make in a step
constexpr double list_share = 0.02;                  ///< of its radius, that each may move while a list serves
constexpr std::int64_t look_steps = 50;              ///< between two looks at contact forces
constexpr double no_limit = 1e3;                     ///< of overlaps on the way: the end is checked

/// Without what is not elastic.
Scene elastic_part(Scene scene) {
  scene.contact.normal = is_hertzian(scene.contact.normal) ? NormalModel::hertz : NormalModel::linear;
  scene.contact.tangential = TangentialModel::none;
  scene.contact.release = Release::zero_overlap;
  for (MaterialSpec& m : scene.materials) {
    m.restitution.reset();
    m.normal_damping = 0;
    m.friction = 0;
  }
  return scene;
}

/// Sums over particles of one instant.
struct Instant {
  double power = 0, force_squared = 0, speed_squared = 0;  ///< by inertia: speeds sqrt(m) v, forces F/sqrt(m)
  double net_force = 0;                                    ///< of absolute values [N]

  Instant& operator+=(const Instant& o) {
    power += o.power;
    force_squared += o.force_squared;
    speed_squared += o.speed_squared;
    net_force += o.net_force;
    return *this;
  }
};

struct Moved {
  Vec3 sum = Vec3::Zero();
  double share_squared = 0;

  Moved& operator+=(const Moved& o) {
    sum += o.sum;
    share_squared = std::max(share_squared, o.share_squared);
    return *this;
  }
};

class Relaxer {
 public:
  Relaxer(const Scene& scene, const StartingState& start)
      : scene_(elastic_part(scene)),
        domain_(scene_.box()),
        boundaries_(scene_, domain_),
        field_(scene_.contact.normal == NormalModel::hertz ? make_hertz_forces(scene_, domain_, boundaries_)
                                                           : make_linear_forces(scene_, domain_, boundaries_)),
        particles_(make_particles(scene_, start)),
        gravity_(scene_.gravity.acceleration) {
    const Population population = population_of(scene_, start);
    smallest_radius_ = smallest_radius(population);
    longest_step_ = longest_step_over_recommended * step_limit(scene_, population).recommended;
    step_ = first_step * longest_step_;
    input_ = {longest_step_, Growth{}, gravity_, no_limit, 0.0};
    boundaries_.go_to(0, longest_step_, 0);
    for (Row& row : particles_.now.rows) row.velocity.setZero();
  }

  Relaxation to(const RelaxationLimits& limits, const std::function<bool()>& should_stop) {
    const Stopwatch clock;
    Relaxation done;
    double contact_force = std::numeric_limits<double>::infinity();
    while (true) {
      if (done.work.steps % look_steps == 0) {
        if (should_stop && should_stop()) throw Interrupted("stopped while forces were being brought into balance");
        contact_force = mean_contact_force();
      }
      renew_list();
      field_->find(particles_, input_, nullptr);
      const Instant now = instant();
      const bool last = done.work.steps >= limits.most_steps;
      if (last || mean_net_force(now) <= limits.unbalanced * contact_force) {
        contact_force = mean_contact_force();
        if (last || mean_net_force(now) <= limits.unbalanced * contact_force) {
          done.balance = {mean_net_force(now) / contact_force, largest_over_weight()};
          break;
        }
      }
      advance(now);
      ++done.work.steps;
    }
    done.work.loop_seconds = clock.seconds();
    done.work.list_seconds = list_seconds_;
    done.work.list_builds = field_->neighbours().builds();
    return done;
  }

  /// Throws RunFailure naming the deepest contact where that is beyond the limit.
  void check_overlap(double limit) {
    if (deepest_ <= limit) return;
    const Contacts contacts = look().contacts;
    std::vector<std::size_t> slot_of(particles_.size());
    for (std::size_t s = 0; s < particles_.slots(); ++s) {
      if (particles_.is_particle(s)) slot_of[particles_.id[s]] = s;
    }
    const auto radius = [&](std::int64_t id) { return particles_.now.rows[slot_of[id]].radius; };
    const auto named = [&](std::int64_t id) {
      return NamedParticle{id, scene_.particles[particles_.type[slot_of[id]]].name};
    };
    RunVerdict v{FailureKind::overlap};
    for (std::size_t k = 0; k < contacts.size(); ++k) {
      const std::int64_t first = contacts.first[k], second = contacts.second[k];
      const double share = contacts.overlap[k] / (second < 0 ? radius(first) : std::min(radius(first), radius(second)));
      if (share <= v.value) continue;
      v.value = share;
      v.place = domain_.wrapped(contacts.point[k]);
      v.particles = {named(first)};
      v.boundaries.clear();
      second < 0 ? v.boundaries.push_back(scene_.boundaries[-1 - second].name) : v.particles.push_back(named(second));
    }
    v.quantity = "overlap over the smaller radius";
    v.limit = limit;
    v.what = fmt::format(
        "at rest {} and {} overlap by {:.3g} of the smaller radius at {}, more than "
        "monitor.overlap_limit = {:g}",
        told(v.particles.front()), v.boundaries.empty() ? told(v.particles.back()) : "boundary " + v.boundaries.front(),
        v.value, told(*v.place), limit);
    v.cause = "the bed's weight is too much for the stiffness";
    v.advice = "make the material stiffer or raise the limit";
    const char* stiffness = is_hertzian(scene_.contact.normal) ? "young_modulus" : "normal_stiffness";
    const int material = particles_.material[slot_of[v.particles.front().id]];
    v.remedies = {{fmt::format("material[{}].{}", material, stiffness)}, {"monitor.overlap_limit"}};
    throw RunFailure(v);
  }

  /// Where the particles are.
  void tell(StartingState& state) const {
    for (std::size_t s = 0; s < particles_.slots(); ++s) {
      if (!particles_.is_particle(s)) continue;
      state.position[particles_.id[s]] = domain_.wrapped(particles_.now.rows[s].position);
      state.velocity[particles_.id[s]].setZero();
    }
  }

 private:
  Vec3 net_force(std::size_t slot) const { return particles_.force.get(slot) + particles_.mass[slot] * gravity_; }

  /// The larger a particle, the more contacts it has; inertia that goes with its surface lets all take the same step.
  double inertia(std::size_t slot) const {
    const Row& row = particles_.now.rows[slot];
    const double ratio = row.radius / smallest_radius_;
    return particles_.mass[slot] / ratio;
  }

  void renew_list() {
    if (!field_->neighbours().outdated(Growth{}) && !field_->walls().outdated(field_->neighbours())) return;
    const Stopwatch clock;
    field_->rebuild(particles_, Growth{}, longest_step_, list_share);
    list_seconds_ += clock.seconds();
  }

  Instant instant() const {
    return sum_in_blocks<Instant>(particles_.slots(), Instant{}, [&](std::size_t s) {
      if (!particles_.is_particle(s)) return Instant{};
      const Vec3 force = net_force(s);
      const Vec3& v = particles_.now.rows[s].velocity;
      const double m = inertia(s);
      return Instant{force.dot(v), force.squaredNorm() / m, m * v.squaredNorm(), force.norm()};
    });
  }

  double mean_net_force(const Instant& now) const { return now.net_force / static_cast<double>(particles_.size()); }

  /// Forces and contacts as they are.
  Recorder look() {
    renew_list();
    Recorder recorder;
    recorder.want_contacts = true;
    recorder.velocity.resize(particles_.size());
    recorder.force.resize(particles_.size());
    const StepSums sums = field_->find(particles_, input_, &recorder);
    deepest_ = sums.largest_overlap_share;
    return recorder;
  }

  /// 0 without contacts, so that nothing counts as balanced then [N].
  double mean_contact_force() {
    const std::vector<Vec3> forces = look().contacts.force;
    double sum = 0;
    for (const Vec3& force : forces) sum += force.norm();
    return forces.empty() ? 0 : sum / static_cast<double>(forces.size());
  }

  double largest_over_weight() const {
    double largest = 0;
    for (std::size_t s = 0; s < particles_.slots(); ++s) {
      if (particles_.is_particle(s)) {
        largest = std::max(largest, net_force(s).norm() / (particles_.mass[s] * gravity_.norm()));
      }
    }
    return largest;
  }

  void advance(const Instant& now) {
    const bool downhill = now.power > 0 || now.speed_squared == 0;
    double kept = 1, turned = 0;  // v = kept v + turned F/m
    if (downhill) {
      kept = 1 - turning_;
      turned = now.force_squared > 0 ? turning_ * std::sqrt(now.speed_squared / now.force_squared) : 0;
      if (++downhill_steps_ > steps_before_growth) {
        step_ = std::min(step_growth * step_, longest_step_);
        turning_ = std::max(turning_decay * turning_, least_turning);
      }
    } else {
      downhill_steps_ = 0;
      step_ = std::max(step_cut * step_, shortest_step * longest_step_);
      turning_ = first_turning;
    }
    NeighbourList& list = field_->neighbours();
    const Vec3 common = list.expected_displacement();
    const Moved moved = sum_in_blocks<Moved>(particles_.slots(), Moved{}, [&](std::size_t s) {
      if (!particles_.is_particle(s)) return Moved{};
      Row& row = particles_.now.rows[s];
      if (!downhill) {  // back to the middle of the step that went uphill, at rest
        row.position -= 0.5 * step_ * row.velocity;
        row.velocity.setZero();
      }
      const Vec3 push = net_force(s) / inertia(s);
      row.velocity = kept * (row.velocity + step_ * push) + turned * push;
      const double way = step_ * row.velocity.norm(), longest = longest_move * row.radius;
      if (way > longest) row.velocity *= longest / way;
      row.position += step_ * row.velocity;
      const Vec3 from_list = row.position - list.reference().get(s);
      return Moved{from_list, (from_list - common).squaredNorm() * list.inverse_margin_squared()[s]};
    });
    list.moved(moved.share_squared, moved.sum, step_);
  }

  Scene scene_;
  Domain domain_;
  Boundaries boundaries_;
  std::unique_ptr<ForceField> field_;
  Particles particles_;
  Vec3 gravity_;
  double smallest_radius_ = 0;
  double longest_step_ = 0, step_ = 0;  ///< [s]
  double turning_ = first_turning;
  int downhill_steps_ = 0;
  double deepest_ = 0;  ///< overlap when contacts were last looked at, over the smaller radius
  double list_seconds_ = 0;
  StepInput input_;
};

}  // namespace

bool can_relax(const Scene& scene) {
  return scene.contact.normal != NormalModel::walton_braun && !scene.contact.van_der_waals.present && !rotates(scene);
}

Relaxation relax(const Scene& scene, StartingState& state, const RelaxationLimits& limits,
                 const std::function<bool()>& should_stop) {
  Relaxer relaxer(scene, state);
  const Relaxation done = relaxer.to(limits, should_stop);
  relaxer.tell(state);
  relaxer.check_overlap(limits.overlap);
  return done;
}

}  // namespace packstone::engine
