// Items that add to ranges of cells, by all threads, the same bits for any number of them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace packstone::analysis {

/// Cells along one axis, both ends included; beyond the ends of a periodic axis they count on.
struct CellSpan {
  std::ptrdiff_t first, last;
};

/// Calls add(worker, item) for the items 0 .. n-1; each adds to the cells of its span_of(item) along an axis of so many
/// cells, and to no others. Items are sorted into bands by their first cell, bands as thick as the longest span or
/// thicker, so that one adds to its own band and the next: first every other band is filled, then the bands between, by
/// a thread each, in the order of the items. make_worker() makes what one thread needs. n below 2^32.
template <class SpanOf, class MakeWorker, class Add>
void add_in_bands(std::size_t n, std::size_t cells, SpanOf&& span_of, MakeWorker&& make_worker, Add&& add) {
  constexpr std::size_t most_bands = 128;
  const auto count = static_cast<std::ptrdiff_t>(cells);
  std::ptrdiff_t longest = 1;
#pragma omp parallel for reduction(max : longest)
  for (std::size_t k = 0; k < n; ++k) {
    const CellSpan span = span_of(k);
    longest = std::max(longest, span.last - span.first + 1);
  }
  // An even number, so that the last band and the first are not filled at once where the axis is periodic.
  const std::size_t pairs = std::min(most_bands, cells / static_cast<std::size_t>(longest)) / 2;
  const std::size_t bands = std::max<std::size_t>(1, 2 * pairs);
  const auto band_of = [&](std::size_t k) {
    const std::ptrdiff_t first = ((span_of(k).first % count) + count) % count;
    return static_cast<std::size_t>(first) * bands / cells;
  };
  std::vector<std::size_t> begin(bands + 1, 0);
  for (std::size_t k = 0; k < n; ++k) ++begin[band_of(k) + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<std::uint32_t> item(n);
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  for (std::size_t k = 0; k < n; ++k) item[next[band_of(k)]++] = static_cast<std::uint32_t>(k);
#pragma omp parallel
  {
    auto worker = make_worker();
    for (std::size_t parity = 0; parity < 2; ++parity) {
#pragma omp for schedule(dynamic)
      for (std::size_t band = parity; band < bands; band += 2) {
        for (std::size_t k = begin[band]; k < begin[band + 1]; ++k) add(worker, std::size_t{item[k]});
      }
    }
  }
}

}  // namespace packstone::analysis
