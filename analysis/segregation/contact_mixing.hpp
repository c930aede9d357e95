// How often unlike particles touch, against random mixing.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "analysis/neighbours.hpp"
#include "analysis/relabelling.hpp"
#include "analysis/species.hpp"

namespace packstone::analysis {

/// Contacts between particles of different types over all contacts; 0 without contacts.
double unlike_share(std::span<const NearPair> contacts, std::span<const std::int32_t> label);

/// Expected share of unlike contacts for types permuted among the particles, whatever the network: the expectation of
/// join counts without replacement, 1 - sum_s n_s (n_s - 1) / (N (N - 1)), n_s particles of type s
/// (Moran, J. R. Stat. Soc. B 10 (1948) 243).
double unlike_share_of_labels(const SpeciesList& list);

/// Mean and standard deviation of the share of unlike contacts when the M contacts' 2 M ends are joined at random, each
/// particle keeping its number of contacts: for types that differ in size, since large particles touch more others.
/// With e_s ends on type s the mean is 1 - sum_s e_s (e_s - 1) / (2 M (2 M - 1)), so that the index of mixing is 1 - r
/// with Newman's coefficient of assortativity r (Phys. Rev. E 67 (2003) 026126) but for the finite number. Exact; no
/// percentiles. All zero without contacts.
RandomReference unlike_share_of_ends(std::span<const NearPair> contacts, const SpeciesList& list);

}  // namespace packstone::analysis
