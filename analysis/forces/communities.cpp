#include "analysis/forces/communities.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "analysis/union_find.hpp"

namespace packstone::analysis {

namespace {

constexpr double least_gain = 1e-12;  // in mean weights: anything below is rounding
constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

using Labels = std::vector<std::uint32_t>;

double mean_weight(std::span<const WeightedEdge> edges) {
  double sum = 0;
  for (const auto& edge : edges) sum += edge.weight;
  return sum / static_cast<double>(edges.size());
}

/// Edges as seen from each node.
class Neighbourhood {
 public:
  struct End {
    std::uint32_t node;
    double gain;
  };

  Neighbourhood(std::span<const WeightedEdge> edges, std::size_t nodes) : begin_(nodes + 1, 0), end_(2 * edges.size()) {
    for (const auto& edge : edges) {
      ++begin_[edge.first + 1];
      ++begin_[edge.second + 1];
    }
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
    for (const auto& edge : edges) {
      end_[next[edge.first]++] = {edge.second, edge.weight};
      end_[next[edge.second]++] = {edge.first, edge.weight};
    }
  }

  std::size_t nodes() const { return begin_.size() - 1; }
  std::span<const End> of(std::uint32_t node) const {
    return std::span(end_).subspan(begin_[node], begin_[node + 1] - begin_[node]);
  }

 private:
  std::vector<std::size_t> begin_;
  std::vector<End> end_;
};

/// Moves single nodes to where they gain most, into a community of their own where all others lose.
class LocalMoves {
 public:
  LocalMoves(const Neighbourhood& near, Labels& label)
      : near_(near), label_(label), gain_(near.nodes(), 0.0), members_(near.nodes(), 0) {
    for (const std::uint32_t l : label_) ++members_[l];
    for (std::uint32_t l = 0; l < members_.size(); ++l) {
      if (members_[l] == 0) empty_.push_back(l);
    }
  }

  /// Whether anything moved.
  bool run() {
    bool moved = false;
    std::vector<std::uint32_t> queue(near_.nodes());
    std::iota(queue.begin(), queue.end(), 0u);
    std::vector<char> waiting(near_.nodes(), 1);
    while (!queue.empty()) {
      std::vector<std::uint32_t> next;
      for (const std::uint32_t node : queue) {
        waiting[node] = 0;
        if (!move(node)) continue;
        moved = true;
        for (const auto& end : near_.of(node)) {
          if (waiting[end.node] || label_[end.node] == label_[node]) continue;
          waiting[end.node] = 1;
          next.push_back(end.node);
        }
      }
      queue = std::move(next);
    }
    return moved;
  }

 private:
  bool move(std::uint32_t node) {
    touched_.clear();
    for (const auto& end : near_.of(node)) {
      const std::uint32_t l = label_[end.node];
      if (gain_[l] == 0) touched_.push_back(l);
      gain_[l] += end.gain;
    }
    const std::uint32_t here = label_[node];
    const double staying = gain_[here];
    std::uint32_t best = none;
    double most = staying + least_gain;
    for (const std::uint32_t l : touched_) {
      if (l != here && gain_[l] > most) {
        best = l;
        most = gain_[l];
      }
    }
    if (0 > most && members_[here] > 1) best = empty_.back();
    for (const std::uint32_t l : touched_) gain_[l] = 0;
    if (best == none) return false;
    if (members_[best]++ == 0) empty_.pop_back();
    if (--members_[here] == 0) empty_.push_back(here);
    label_[node] = best;
    return true;
  }

  const Neighbourhood& near_;
  Labels& label_;
  std::vector<double> gain_;  ///< of the node at hand, by community; 0 in between
  std::vector<std::uint32_t> members_;
  std::vector<std::uint32_t> empty_;
  std::vector<std::uint32_t> touched_;
};

/// Numbers the labels 0, 1, ... in the order of their first nodes; their count.
std::uint32_t renumber(Labels& label) {
  std::vector<std::uint32_t> number(label.size(), none);
  std::uint32_t count = 0;
  for (auto& l : label) {
    if (number[l] == none) number[l] = count++;
    l = number[l];
  }
  return count;
}

/// Splits communities that local moves have left in several pieces.
std::uint32_t split_disconnected(std::span<const WeightedEdge> edges, Labels& label) {
  UnionFind sets(label.size());
  for (const auto& edge : edges) {
    if (label[edge.first] == label[edge.second]) sets.join(edge.first, edge.second);
  }
  for (std::uint32_t i = 0; i < label.size(); ++i) label[i] = sets.root(i);
  return renumber(label);
}

/// Edges between communities, weights added up; what lies inside does not matter any more.
std::vector<WeightedEdge> edges_between(std::span<const WeightedEdge> edges, const Labels& label) {
  std::vector<WeightedEdge> between;
  for (const auto& edge : edges) {
    const auto [low, high] = std::minmax(label[edge.first], label[edge.second]);
    if (low != high) between.push_back({low, high, edge.weight});
  }
  std::stable_sort(between.begin(), between.end(), [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first < b.first : a.second < b.second;
  });
  std::vector<WeightedEdge> merged;
  for (const auto& edge : between) {
    if (!merged.empty() && merged.back().first == edge.first && merged.back().second == edge.second) {
      merged.back().weight += edge.weight;
    } else {
      merged.push_back(edge);
    }
  }
  return merged;
}

/// Moves whole communities until none gains. Whether any did.
bool merge_communities(std::span<const WeightedEdge> edges, Labels& label, std::uint32_t count) {
  bool merged = false;
  std::vector<WeightedEdge> between = edges_between(edges, label);
  for (;;) {
    Labels community(count);
    std::iota(community.begin(), community.end(), 0u);
    const Neighbourhood near(between, count);
    if (!LocalMoves(near, community).run()) return merged;
    merged = true;
    count = split_disconnected(between, community);
    for (auto& l : label) l = community[l];
    between = edges_between(between, community);
  }
}

}  // namespace

double geographic_modularity(std::span<const WeightedEdge> edges, std::span<const std::uint32_t> label, double gamma) {
  const double mean = mean_weight(edges);
  double sum = 0;
  for (const auto& edge : edges) {
    if (label[edge.first] == label[edge.second]) sum += edge.weight - gamma * mean;
  }
  return sum / (mean * static_cast<double>(edges.size()));
}

std::vector<std::uint32_t> communities(std::span<const WeightedEdge> edges, std::size_t nodes, double gamma) {
  const double mean = mean_weight(edges);
  std::vector<WeightedEdge> gains(edges.begin(), edges.end());
  for (auto& edge : gains) edge.weight = edge.weight / mean - gamma;
  const Neighbourhood near(gains, nodes);
  Labels label(nodes);
  std::iota(label.begin(), label.end(), 0u);
  for (;;) {
    LocalMoves(near, label).run();
    const std::uint32_t count = split_disconnected(gains, label);
    if (!merge_communities(gains, label, count)) break;
  }
  return label;
}

}  // namespace packstone::analysis
