#include "analysis/particle_fields.hpp"

#include <iterator>

#include "analysis/measures.hpp"
#include "core/error.hpp"
#include "core/text.hpp"

namespace packstone::analysis {

namespace {

/// The measures that have any, for a message.
std::string measures_with_fields() {
  std::vector<std::string> names;
  for (const auto& measure : all_measures()) {
    if (measure.fields) names.push_back(measure.name);
  }
  return joined(names);
}

}  // namespace

std::vector<ParticleField> without_values(std::vector<ParticleField> fields, const std::string& reason) {
  for (ParticleField& field : fields) {
    field.values.clear();
    field.missing = reason;
  }
  return fields;
}

std::vector<ParticleField> particle_fields(const Snapshot& snapshot, const std::vector<std::string>& selection,
                                           const Options& options) {
  std::vector<const Measure*> measures = selected_measures(selection);
  std::erase_if(measures, [](const Measure* measure) { return !measure->fields; });
  if (measures.empty()) {
    throw InputError("none of the measures chosen has values of particles; those that have are " +
                     measures_with_fields());
  }
  const Context context = make_context(snapshot, options);
  std::vector<ParticleField> fields;
  for (const Measure* measure : measures) {
    auto more = measure->fields(snapshot, context);
    fields.insert(fields.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  }
  return fields;
}

}  // namespace packstone::analysis
