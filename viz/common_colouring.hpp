// One meaning of the colours for several packings shown together.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "viz/colouring.hpp"

namespace packstone::viz {

/// Colours of each snapshot as colour_particles gives them, with one key, which each of the results has: a scale spans
/// the values of all, unless a range is given; groups and materials of one name have one colour, in the order in which
/// the names come first. One snapshot has its own colours. Throws InputError as colour_particles does.
std::vector<Colouring> colour_together(const std::vector<ParticleView>& packings, const std::string& name,
                                       std::optional<ValueRange> range);

}  // namespace packstone::viz
