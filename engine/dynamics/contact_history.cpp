#include "engine/dynamics/contact_history.hpp"

#include <algorithm>

#include "engine/threads.hpp"

namespace packstone::engine {

namespace {

/// Calls visit(id, memory, row, lane, partner) for each entry and wall of the group.
template <class History, class Visit>
void for_each_contact(const NeighbourList& list, const WallList& wall_list, const Particles& p,
                      std::size_t group_number, History& history, Visit&& visit) {
  const NeighbourGroup& group = list.groups()[group_number];
  for (int lane = 0; lane < list.width(); ++lane) {
    const bool occupied = group.shared || (group.lanes >> lane & 1u) != 0;
    if (!occupied) continue;
    const std::int64_t id = p.id[group.shared ? group.slot : group.slot + lane];
    for (std::int64_t row = group.first_row; row < group.first_row + group.rows; ++row) {
      const std::int32_t neighbour = NeighbourList::slot(list.row(row)[lane]);
      if (neighbour != p.nobody()) visit(id, history.pairs, row, lane, static_cast<std::int64_t>(p.id[neighbour]));
    }
    if (group.shared && lane > 0) continue;
    const int width = wall_list.width();
    const WallSeat& seat = wall_list.seat(group_number, lane / width);
    for (std::int64_t row = seat.first_row; row < seat.first_row + seat.rows; ++row) {
      const WallEntry& entry = wall_list.row(row)[lane % width];
      if (entry.there()) visit(id, history.walls, row, lane % width, -1 - wall_list.key(entry));
    }
  }
}

}  // namespace

template <class Number>
StoredContacts ContactHistory<Number>::store(const NeighbourList& list, const WallList& wall_list,
                                             const Particles& p) const {
  StoredContacts stored;
  stored.end.assign(p.size() + 1, 0);
  if (list.builds() == 0) return stored;
  const auto for_all = [&](auto&& visit) {
    const auto groups = static_cast<std::ptrdiff_t>(list.groups().size());
#pragma omp parallel for schedule(static) num_threads(useful_threads(p.size()))
    for (std::ptrdiff_t g = 0; g < groups; ++g) {
      for_each_contact(list, wall_list, p, static_cast<std::size_t>(g), *this,
                       [&](std::int64_t id, const auto& memory, std::int64_t row, int lane, std::int64_t partner) {
                         if (memory.touched(row, lane)) visit(id, memory, row, lane, partner);
                       });
    }
  };
  // Counts move one place on, so that filling in leaves each particle's end where it belongs.
  for_all([&](std::int64_t id, const auto&, std::int64_t, int, std::int64_t) { ++stored.end[id + 1]; });
  for (std::size_t id = 0; id < p.size(); ++id) stored.end[id + 1] += stored.end[id];
  stored.partner.resize(static_cast<std::size_t>(stored.end.back()));
  stored.numbers.resize(stored.partner.size() * numbers);
  for_all([&](std::int64_t id, const auto& memory, std::int64_t row, int lane, std::int64_t partner) {
    const std::int64_t contact = stored.end[id]++;
    stored.partner[contact] = partner;
    memory.get(row, lane, numbers, stored.numbers.data() + contact * numbers);
  });
  return stored;
}

template <class Number>
void ContactHistory<Number>::restore(const StoredContacts& stored, const NeighbourList& list, const WallList& wall_list,
                                     const Particles& p) {
  pairs.resize(list.rows(), list.width(), numbers);
  walls.resize(wall_list.rows(), wall_list.width(), numbers);
  const auto groups = static_cast<std::ptrdiff_t>(list.groups().size());
#pragma omp parallel for schedule(static) num_threads(useful_threads(p.size()))
  for (std::ptrdiff_t g = 0; g < groups; ++g) {
    for_each_contact(list, wall_list, p, static_cast<std::size_t>(g), *this,
                     [&](std::int64_t id, auto& memory, std::int64_t row, int lane, std::int64_t partner) {
                       for (std::int64_t c = id == 0 ? 0 : stored.end[id - 1]; c < stored.end[id]; ++c) {
                         if (stored.partner[c] != partner) continue;
                         memory.set(row, lane, numbers, stored.numbers.data() + c * numbers);
                         break;
                       }
                     });
  }
}

template struct ContactHistory<double>;
template struct ContactHistory<float>;

}  // namespace packstone::engine
