#include "analysis/segregation/contact_mixing.hpp"

#include <algorithm>
#include <cmath>

namespace packstone::analysis {

namespace {

/// Ordered pairs among n.
double pairs_among(double n) { return n * (n - 1); }

}  // namespace

double unlike_share(std::span<const NearPair> contacts, std::span<const std::int32_t> label) {
  if (contacts.empty()) return 0;
  std::size_t unlike = 0;
  for (const NearPair& pair : contacts) unlike += label[pair.first] != label[pair.second] ? 1 : 0;
  return static_cast<double>(unlike) / static_cast<double>(contacts.size());
}

double unlike_share_of_labels(const SpeciesList& list) {
  double like = 0;
  for (const auto& species : list.species) like += pairs_among(static_cast<double>(species.count));
  return 1 - like / pairs_among(static_cast<double>(list.label.size()));
}

RandomReference unlike_share_of_ends(std::span<const NearPair> contacts, const SpeciesList& list) {
  if (contacts.empty()) return {};
  std::vector<double> ends(list.size(), 0.0);
  for (const NearPair& pair : contacts) {
    ++ends[static_cast<std::size_t>(list.label[pair.first])];
    ++ends[static_cast<std::size_t>(list.label[pair.second])];
  }
  const double m = static_cast<double>(contacts.size()), n = 2 * m;
  double like = 0;  // chance that one contact is
  for (const double e : ends) like += pairs_among(e) / pairs_among(n);
  double both_like = 0;  // chance that two contacts are: four ends drawn, two by two
  if (contacts.size() > 1) {
    for (const double e : ends) {
      const double rest = like * pairs_among(n) - pairs_among(e);
      both_like += pairs_among(e) / pairs_among(n) * (pairs_among(e - 2) + rest) / pairs_among(n - 2);
    }
  }
  const double variance = (m - 1) / m * both_like + like / m - like * like;
  return {1 - like, std::sqrt(std::max(0.0, variance))};
}

}  // namespace packstone::analysis
