#include "engine/filling/population.hpp"

#include <algorithm>
#include <limits>

namespace packstone::engine {

Population population_of(const Scene& scene, const StartingState& start) {
  Population population(scene.particles.size());
  for (std::size_t i = 0; i < start.size(); ++i) {
    GroupSizes& group = population[start.type[i]];
    const double radius = start.radius[i];
    group.smallest_radius = group.count == 0 ? radius : std::min(group.smallest_radius, radius);
    group.largest_radius = std::max(group.largest_radius, radius);
    ++group.count;
  }
  return population;
}

double smallest_radius(const Population& population) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const GroupSizes& group : population) {
    if (group.count > 0) smallest = std::min(smallest, group.smallest_radius);
  }
  return smallest;
}

double largest_radius(const Population& population) {
  double largest = 0;
  for (const GroupSizes& group : population) largest = std::max(largest, group.largest_radius);
  return largest;
}

}  // namespace packstone::engine
