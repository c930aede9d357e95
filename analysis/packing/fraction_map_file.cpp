// The map as a file of VTK.
#include "analysis/image_data.hpp"
#include "analysis/packing/fraction_map.hpp"
#include "core/error.hpp"

namespace packstone::analysis {

void write_vti(const std::filesystem::path& path, const FractionMap& map) {
  require_image_extension(path, "a map");
  if (map.cells() == 0) throw InputError(path.string() + ": there is nothing to map, no particle lies above the floor");
  write_image_data(path, map, {{"solid_fraction", {}, [&](std::size_t k, double* f) { *f = map.fraction[k]; }}});
}

void write_fraction_map(const std::filesystem::path& path, const Snapshot& snapshot, const Options& options) {
  require_image_extension(path, "a map");  // before the work
  const Context context = make_context(snapshot, options);
  write_vti(path, fraction_map(snapshot, context, container_of(snapshot, context.frame)));
}

}  // namespace packstone::analysis
