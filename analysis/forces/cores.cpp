#include "analysis/forces/cores.hpp"

#include <algorithm>
#include <numeric>

#include "analysis/forces/parts.hpp"

namespace packstone::analysis {

namespace {

/// Nodes in the order of their degree, kept so while degrees fall by one at a time.
class ByDegree {
 public:
  explicit ByDegree(const std::vector<int>& degree) : node_(degree.size()), place_(degree.size()) {
    const int most = degree.empty() ? 0 : *std::max_element(degree.begin(), degree.end());
    begin_.assign(static_cast<std::size_t>(most) + 2, 0);
    for (const int d : degree) ++begin_[static_cast<std::size_t>(d) + 1];
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    std::vector<std::size_t> next = begin_;
    for (std::uint32_t i = 0; i < degree.size(); ++i) {
      place_[i] = next[static_cast<std::size_t>(degree[i])]++;
      node_[place_[i]] = i;
    }
  }

  std::uint32_t operator[](std::size_t place) const { return node_[place]; }

  /// Before a node of this degree gets one less: the first of its degree and it change places.
  void lower(std::uint32_t node, int degree) {
    const std::size_t first = begin_[static_cast<std::size_t>(degree)]++;
    const std::uint32_t other = node_[first];
    std::swap(node_[first], node_[place_[node]]);
    std::swap(place_[other], place_[node]);
  }

 private:
  std::vector<std::uint32_t> node_;
  std::vector<std::size_t> place_;
  std::vector<std::size_t> begin_;  ///< place of the first node of every degree
};

}  // namespace

std::vector<int> core_numbers(const Adjacency& near) {
  const std::size_t n = near.begin.size() - 1;
  std::vector<int> core(n);
  for (std::size_t i = 0; i < n; ++i) core[i] = static_cast<int>(near.of(i).size());
  ByDegree order(core);
  for (std::size_t place = 0; place < n; ++place) {
    const std::uint32_t i = order[place];
    for (const std::uint32_t other : near.of(i)) {
      if (core[other] > core[i]) order.lower(other, core[other]--);
    }
  }
  return core;
}

void add_cores(MeasureResult& result, const Snapshot& snapshot, const Context& context) {
  Quantity largest{.key = "core_max",
                   .label = "largest k of a k-core",
                   .definition =
                       "largest k for which some particles have k contacts or more among themselves (Seidman, Social "
                       "Networks 5 (1983) 269); contacts with boundaries are not counted",
                   .note = context.contacts.source()};
  Quantity mean{.key = "core_mean",
                .label = "mean core number",
                .definition = "mean over all particles of the largest k of a k-core that holds the particle",
                .note = context.contacts.source()};
  Table table{.key = "core_numbers",
              .caption = "Particles by core number k: in the k-core of the network of contacts, not in the (k+1)-core",
              .columns = {{"core", "", ColumnFormat::integer}, {"particles", "", ColumnFormat::integer}, {"share"}}};
  if (snapshot.size() == 0) {
    for (Quantity* q : {&largest, &mean}) *q = not_applicable(*q, "no particles");
  } else {
    const auto core = core_numbers(adjacency(context.contacts.pairs, snapshot.size()));
    const double n = static_cast<double>(core.size());
    const int most = *std::max_element(core.begin(), core.end());
    std::vector<double> particles(static_cast<std::size_t>(most) + 1, 0.0);
    for (const int k : core) ++particles[static_cast<std::size_t>(k)];
    double sum = 0;
    for (std::size_t k = 0; k < particles.size(); ++k) {
      sum += static_cast<double>(k) * particles[k];
      table.rows.push_back({static_cast<double>(k), particles[k], particles[k] / n});
    }
    largest.value = most;
    mean.value = sum / n;
  }
  result.quantities.push_back(largest);
  result.quantities.push_back(mean);
  result.tables.push_back(table);
}

}  // namespace packstone::analysis
