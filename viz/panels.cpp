#include "viz/panels.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace packstone::viz {

int panel_columns(int asked_for, std::size_t panels) {
  constexpr std::size_t most_in_a_row = 3;
  if (asked_for > 0) return std::min(asked_for, static_cast<int>(panels));
  return static_cast<int>(panels <= most_in_a_row ? panels : std::ceil(std::sqrt(static_cast<double>(panels))));
}

std::string lettered(std::size_t panel, const std::string& title) {
  constexpr std::size_t letters = 26;
  const std::string letter = fmt::format("({})", static_cast<char>('a' + panel % letters));
  return title.empty() ? letter : letter + " " + title;
}

}  // namespace packstone::viz
