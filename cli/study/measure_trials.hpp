// Ways to measure one packing: exact, by points, by voxels; finer and coarser surfaces.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "analysis/context.hpp"
#include "analysis/packing/region.hpp"
#include "cli/study/trials.hpp"
#include "cli/study/variants.hpp"

namespace packstone::cli {

/// What is measured of a packing.
class MeasureStudy {
 public:
  /// quantity: as quantity_of gives it. Throws InputError where there is only one way to measure it, and where the
  /// packing does not have it.
  MeasureStudy(const Snapshot& snapshot, const std::string& quantity);

  /// As asked for, else what a user would first ask about; with the exact one, where there is one. Throws InputError
  /// for one that the study does not know.
  std::vector<Variant> variants(const std::vector<std::string>& vary) const;
  /// Label of the exact one; empty where there is none.
  std::string reference() const { return surface_ ? "" : exact; }

  /// Settings: of packing.bulk_fraction points=N, even_points=N or voxels=EDGE, over the mean radius, none for the
  /// exact volumes; of surface.surface_volume columns=DISTANCE, over the volume-mean radius. The seed sets points and
  /// the grid's start. Cost: median of several times.
  Trial run(const Variant& variant, std::int64_t seed) const;

 private:
  static constexpr const char* exact = "exact";

  const std::vector<std::string>& keys() const;
  double value(const std::string& key, double number, std::int64_t seed) const;

  const Snapshot& snapshot_;
  std::string quantity_;
  bool surface_;
  analysis::Context context_;
  analysis::RegionShape bulk_;
};

}  // namespace packstone::cli
