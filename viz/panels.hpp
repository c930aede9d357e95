// What panels of a figure have in common, in space and as slices.
#pragma once

#include <cstddef>
#include <string>

namespace packstone::viz {

/// How many panels stand in a row where so many are asked for, 0 for the usual.
int panel_columns(int asked_for, std::size_t panels);

/// "(b) title"
std::string lettered(std::size_t panel, const std::string& title);

}  // namespace packstone::viz
