#include "analysis/structure/pair_distribution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "analysis/point_grid.hpp"
#include "core/geometry.hpp"
#include "core/random.hpp"

namespace packstone::analysis {

namespace {

constexpr std::uint64_t sample_seed = 20260101;  // fixed: the same packing gives the same numbers
constexpr double pair_budget = 1.5e7;            // pairs counted at most, about
constexpr std::size_t fewest_references = 1000;
constexpr std::size_t blocks = 32;                              // of references, summed each by one thread
constexpr double cells_a_range = 4;                             // cells of the search along the range
constexpr double direction_budget = 1e6;                        // random directions for the shares of shells, about
constexpr double fewest_directions = 1, most_directions = 256;  // from each particle

struct Sample {
  std::vector<std::uint32_t> rows;        // in the window
  std::vector<std::uint32_t> references;  // of them
};

Sample sampled(const Snapshot& snapshot, const Window& window, double range) {
  Sample sample;
  for (std::size_t i = 0; i < snapshot.size(); ++i) {
    if (window.contains(snapshot.domain.wrapped(snapshot.position[i]))) {
      sample.rows.push_back(static_cast<std::uint32_t>(i));
    }
  }
  const double density = static_cast<double>(sample.rows.size()) / window.volume();
  const double affordable = pair_budget / std::max(1.0, density * sphere_volume(range));
  const auto wanted = std::max(fewest_references, static_cast<std::size_t>(affordable));
  sample.references = sample.rows;
  if (wanted < sample.rows.size()) {
    Random random(sample_seed, RandomStream::reference_sample, 0);
    shuffle(sample.references, random);
    sample.references.resize(wanted);
    std::sort(sample.references.begin(), sample.references.end());  // near each other in memory
  }
  return sample;
}

/// Place of the curve of labels a and b among those of labels a <= b.
std::size_t curve_of(std::size_t a, std::size_t b, std::size_t labels) {
  const std::size_t low = std::min(a, b), high = std::max(a, b);
  return low * labels - low * (low + 1) / 2 + high;
}

/// Shares of shells of radius r in the middle of the bins, (bins) each.
using Shares = std::vector<double>;

/// Mean share of a shell around a uniform place of the window that lies in it: E prod_k (1 - r |n_k|/L_k) over the
/// directions n and the sides L_k that are not periodic, with E|n_x| = 1/2, E|n_x n_y| = 2/(3 pi),
/// E|n_x n_y n_z| = 1/(4 pi).
Shares mean_shares(const Window& window, double bin, std::size_t bins) {
  using std::numbers::pi;
  Vec3 per_side = Vec3::Zero();
  for (int k = 0; k < 3; ++k) {
    if (!window.periodic[k]) per_side[k] = 1 / window.size()[k];
  }
  const double singles = per_side.sum();
  const double doubles = per_side[0] * per_side[1] + per_side[1] * per_side[2] + per_side[2] * per_side[0];
  Shares shares(bins);
  for (std::size_t k = 0; k < bins; ++k) {
    const double r = (static_cast<double>(k) + 0.5) * bin;
    shares[k] = 1 - r / 2 * singles + 2 / (3 * pi) * r * r * doubles - r * r * r / (4 * pi) * per_side.prod();
  }
  return shares;
}

/// How far a ray from a place inside goes until it leaves the window.
double way_out(const Window& window, const Vec3& place, const Vec3& direction) {
  double way = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    if (window.periodic[k] || direction[k] == 0) continue;
    way = std::min(way, ((direction[k] > 0 ? window.max[k] : window.min[k]) - place[k]) / direction[k]);
  }
  return way;
}

/// Counts, for every label, the rays from its particles by the first bin whose middle they do not reach inside.
std::vector<std::size_t> rays_by_bin(const Snapshot& snapshot, const Window& window,
                                     const std::vector<std::uint32_t>& rows, std::span<const std::int32_t> label,
                                     std::size_t labels, double bin, std::size_t bins, int directions) {
  std::vector<std::vector<std::size_t>> partial(blocks);
#pragma omp parallel for schedule(dynamic)
  for (std::size_t b = 0; b < blocks; ++b) {
    partial[b].assign(labels * (bins + 1), 0);
    for (std::size_t k = rows.size() * b / blocks; k < rows.size() * (b + 1) / blocks; ++k) {
      const std::uint32_t row = rows[k];
      const Vec3 place = snapshot.domain.wrapped(snapshot.position[row]);
      const std::size_t first = (labels == 1 ? 0 : static_cast<std::size_t>(label[row])) * (bins + 1);
      Random random(sample_seed, RandomStream::shell_direction, row);
      for (int d = 0; d < directions; ++d) {
        const double z = random.uniform(-1, 1), phi = random.uniform(0, 2 * std::numbers::pi);
        const double across = std::sqrt(1 - z * z);
        const double way = way_out(window, place, Vec3(across * std::cos(phi), across * std::sin(phi), z)) / bin;
        const double reached = std::clamp(std::floor(way + 0.5), 0.0, static_cast<double>(bins));
        ++partial[b][first + static_cast<std::size_t>(reached)];
      }
    }
  }
  std::vector<std::size_t> rays(labels * (bins + 1), 0);
  for (const auto& block : partial) {
    for (std::size_t k = 0; k < rays.size(); ++k) rays[k] += block[k];
  }
  return rays;
}

/// Particles of one label, and the mean share of their shells that lies in the window.
struct Group {
  double count = 0;
  Shares share;
};

/// (labels) of the rows.
std::vector<Group> groups_of(const Snapshot& snapshot, const Window& window, const std::vector<std::uint32_t>& rows,
                             std::span<const std::int32_t> label, std::size_t labels, double bin, std::size_t bins) {
  std::vector<Group> groups(labels);
  for (const std::uint32_t row : rows) ++groups[labels == 1 ? 0 : static_cast<std::size_t>(label[row])].count;
  const bool sides = !(window.periodic[0] && window.periodic[1] && window.periodic[2]);
  if (!sides) {
    for (Group& group : groups) group.share.assign(bins, 1.0);
    return groups;
  }
  const double affordable = direction_budget / std::max(1.0, static_cast<double>(rows.size()));
  const int directions = static_cast<int>(std::clamp(affordable, fewest_directions, most_directions));
  const auto rays = rays_by_bin(snapshot, window, rows, label, labels, bin, bins, directions);
  for (std::size_t g = 0; g < labels; ++g) {
    double inside = groups[g].count * directions;
    const double all = std::max(1.0, inside);
    for (std::size_t k = 0; k < bins; ++k) {
      inside -= static_cast<double>(rays[g * (bins + 1) + k]);
      groups[g].share.push_back(inside / all);
    }
  }
  return groups;
}

/// The groups as one.
Group together(const std::vector<Group>& groups) {
  Group all{0, Shares(groups.front().share.size(), 0.0)};
  for (const Group& group : groups) {
    all.count += group.count;
    for (std::size_t k = 0; k < all.share.size(); ++k) all.share[k] += group.count * group.share[k];
  }
  for (double& share : all.share) share /= std::max(1.0, all.count);
  return all;
}

double shell_volume(std::size_t k, double bin) {
  const double inner = static_cast<double>(k), cells = 3 * inner * inner + 3 * inner + 1;
  return 4.0 / 3.0 * std::numbers::pi * bin * bin * bin * cells;
}

}  // namespace

PairDistribution pair_distribution(const Snapshot& snapshot, const Window& window, std::span<const std::int32_t> label,
                                   std::size_t labels, double bin, std::size_t bins) {
  const double range = bin * static_cast<double>(bins);
  const Sample sample = sampled(snapshot, window, range);
  // No pairs through a side that the window is cut off from.
  std::vector<Vec3> place;
  place.reserve(snapshot.size());
  for (const Vec3& p : snapshot.position) place.push_back(snapshot.domain.wrapped(p));
  Domain domain = snapshot.domain;
  domain.periodic = window.periodic;
  const PointGrid grid(place, sample.rows, domain, range / cells_a_range);

  const std::size_t kinds = std::max<std::size_t>(labels, 1);  // without labels the total is the only curve
  const std::size_t curves = kinds * (kinds + 1) / 2;
  const auto label_of = [&](std::uint32_t row) { return kinds == 1 ? 0 : static_cast<std::size_t>(label[row]); };
  std::vector<std::vector<std::size_t>> partial(blocks);
  const std::size_t references = sample.references.size();
#pragma omp parallel for schedule(dynamic)
  for (std::size_t b = 0; b < blocks; ++b) {
    partial[b].assign(curves * bins, 0);
    for (std::size_t k = references * b / blocks; k < references * (b + 1) / blocks; ++k) {
      const std::uint32_t i = sample.references[k];
      grid.for_each_within(place[i], range, [&](std::uint32_t j, const Vec3&, double squared) {
        if (j == i) return;
        const auto at = std::min(static_cast<std::size_t>(std::sqrt(squared) / bin), bins - 1);
        ++partial[b][curve_of(label_of(i), label_of(j), kinds) * bins + at];
      });
    }
  }
  std::vector<std::size_t> pairs(curves * bins, 0), all_pairs(bins, 0);
  for (const auto& block : partial) {
    for (std::size_t k = 0; k < pairs.size(); ++k) pairs[k] += block[k];
  }
  for (std::size_t k = 0; k < pairs.size(); ++k) all_pairs[k % bins] += pairs[k];

  const Shares mean_share = mean_shares(window, bin, bins);
  const double all = static_cast<double>(sample.rows.size());
  const double twice = 1 + static_cast<double>(references) / std::max(1.0, all);
  const auto curve_from = [&](const std::size_t* count, const std::vector<Group>& centres,
                              const std::vector<Group>& others, std::size_t a, std::size_t b) {
    PairCurve curve{std::vector<double>(bins, 0.0), std::vector<double>(bins, 0.0)};
    for (std::size_t k = 0; k < bins; ++k) {
      const auto seen = [&](std::size_t centre, std::size_t other) {
        const double partners = others[other].count - (centre == other ? 1 : 0);
        return centres[centre].count * partners * centres[centre].share[k] * others[other].share[k] / mean_share[k];
      };
      const double expected = (a == b ? seen(a, a) : seen(a, b) + seen(b, a)) * shell_volume(k, bin) / window.volume();
      if (!(expected > 0)) continue;
      curve.g[k] = static_cast<double>(count[k]) / expected;
      curve.error[k] = std::sqrt(twice * static_cast<double>(count[k])) / expected;
    }
    return curve;
  };
  PairDistribution result{.bin = bin, .bins = bins, .particles = sample.rows.size(), .references = references};
  const auto grouped = [&](const std::vector<std::uint32_t>& rows) {
    return groups_of(snapshot, window, rows, label, kinds, bin, bins);
  };
  const std::vector<Group> others = grouped(sample.rows);
  const std::vector<Group> centres = references == sample.rows.size() ? others : grouped(sample.references);
  result.total = curve_from(all_pairs.data(), {together(centres)}, {together(others)}, 0, 0);
  for (std::size_t a = 0; a < labels; ++a) {
    for (std::size_t b = a; b < labels; ++b) {
      const std::size_t* const count = pairs.data() + curve_of(a, b, labels) * bins;
      result.partial.push_back(curve_from(count, centres, others, a, b));
    }
  }
  return result;
}

}  // namespace packstone::analysis
