// The tables of the segregation measure.
#pragma once

#include "analysis/result.hpp"
#include "analysis/segregation/arrangement.hpp"

namespace packstone::analysis {

/// "composition": share of each type by layer, beside its expectation and spread for random mixing.
Table layer_table(const MixedBed& bed);

/// "rings": the same by ring.
Table ring_table(const MixedBed& bed);

/// "types": each type alone.
Table type_table(const MixedBed& bed);

/// "scale": the indices over the size of the cells, as found, at random and separated.
Table scale_table(const MixedBed& bed, const MixingNumbers& numbers);

}  // namespace packstone::analysis
