#include "cli/report_findings.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "analysis/time/rest.hpp"
#include "analysis/writers.hpp"
#include "core/error.hpp"

namespace packstone::cli {

namespace {

using analysis::MeasureResult;
using analysis::Quantity;
using Results = std::vector<MeasureResult>;

constexpr double weakly_segregated = 0.9;  ///< Lacey's index above which a bed is called mostly mixed
constexpr double significant_z = 3;        ///< deviations further off than this are not chance
constexpr double account_share = 0.1;      ///< of the energy put in, beyond which the account is said to be open

std::string text(const Results& results, const char* measure, const char* key) {
  const Quantity& q = quantity(results, measure, key);
  return analysis::value_text(q) + (q.unit.empty() ? "" : " " + q.unit);
}

std::string rest(const ReportedMeasures& m) {
  const Quantity& ratio = quantity(m.end, "time", "kinetic_energy_ratio");
  if (!ratio.value) return "Whether the bed is at rest cannot be said: " + ratio.note + ".";
  return fmt::format(
      "At t = {:g} s the bed is {}: its kinetic energy is {:.2g} of the sum of m g d (at rest: below {:g}), with {} "
      "contacts a "
      "particle and a mean speed of {}.",
      m.end_time, *ratio.value < analysis::rest_threshold ? "at rest" : "not at rest", *ratio.value,
      analysis::rest_threshold, text(m.end, "time", "contacts_per_particle"), text(m.end, "time", "mean_speed"));
}

std::string packing(const ReportedMeasures& m) {
  return fmt::format(
      "The bed's bulk, from a tenth to four fifths of its height, has the solid fraction {}; the equivalent "
      "height is {}. A particle has {} contacts with others on average.",
      text(m.end, "packing", "bulk_fraction"), text(m.end, "packing", "bed_height"),
      text(m.end, "structure", "coordination_mean"));
}

std::string segregation(const ReportedMeasures& m) {
  const Quantity& before = quantity(m.filled, "segregation", "lacey");
  const Quantity& after = quantity(m.end, "segregation", "lacey");
  if (!after.value || !before.value) {
    return "Segregation by layers does not apply: " + (after.value ? before : after).note + ".";
  }
  const double z_before = quantity(m.filled, "segregation", "lacey_z").value.value_or(0);
  const double z_after = quantity(m.end, "segregation", "lacey_z").value.value_or(0);
  return fmt::format(
      "Lacey's index (1: mixed at random, 0: separated) is {} {} the filling (t = {:g} s, {:.1f} standard "
      "deviations from random mixing) and {} at the end ({:.1f}). {} The types' centres are {} of the bed's height "
      "apart.",
      analysis::value_text(before), m.filling_over ? "right after" : "during", m.filled_time, z_before,
      analysis::value_text(after), z_after,
      std::abs(z_after) < significant_z ? "The bed as a whole is as mixed as chance would have it."
      : z_after > 0                     ? "The layers are more alike than chance would have it."
      : *after.value > weakly_segregated
          ? "So the bed is segregated beyond chance, but weakly: most of it is still mixed."
          : "So the bed is segregated.",
      text(m.end, "segregation", "height_difference"));
}

std::string layers(const RunReader& run, const ReportedMeasures& m) {
  const auto measure = std::find_if(m.end.begin(), m.end.end(), [](const auto& r) { return r.name == "segregation"; });
  const analysis::Table* table = measure->table("composition");
  if (!table) return "";
  enum Column { lower, upper, type, share, expected, spread, z };
  const Snapshot last = run.snapshot(run.index_at("last"));
  std::vector<std::string> deviating;
  int layers = 0;
  for (const auto& row : table->rows) {
    if (row[type] != 0) continue;
    ++layers;
    if (std::abs(row[z]) < significant_z) continue;
    deviating.push_back(
        fmt::format("{:.3g} to {:.3g} m: {:.0f} % (z = {:+.1f})", row[lower], row[upper], 100 * row[share], row[z]));
  }
  std::string list;
  for (const auto& entry : deviating) list += (list.empty() ? "" : "; ") + entry;
  return fmt::format(
      "Of {} layers one diameter thick, {} hold a share of \"{}\" more than three standard deviations from "
      "random mixing{}.",
      layers, deviating.size(), last.groups.front().name, list.empty() ? "" : ": " + list);
}

std::string clusters(const ReportedMeasures& m) {
  const Quantity& largest = quantity(m.end, "clusters", "largest");
  if (!largest.value) return "Clusters of like particles do not apply: " + largest.note + ".";
  const double z = quantity(m.end, "clusters", "largest_z").value.value_or(0);
  return fmt::format(
      "Touching like particles form {} clusters, of {} expected when the labels are dealt at random on the same "
      "contacts; "
      "the largest has {} particles, of {} expected ({:+.1f} standard deviations); {} of the contacts join like "
      "particles, "
      "of {} expected. {}",
      text(m.end, "clusters", "count"), text(m.end, "clusters", "count_random"), text(m.end, "clusters", "largest"),
      text(m.end, "clusters", "largest_random"), z, text(m.end, "clusters", "like_contact_share"),
      text(m.end, "clusters", "like_contact_share_random"),
      std::abs(z) < significant_z ? "The clusters seen in a picture are those of chance."
      : z > 0                     ? "Like particles are together more than chance would have it."
                                  : "Like particles are together less than chance would have it.");
}

/// A number against its random value, as the last clause of a sentence.
std::string verdict(double z, const char* more, const char* less) {
  return std::abs(z) < significant_z ? "as mixed as chance would have it" : z > 0 ? more : less;
}

std::string neighbours(const ReportedMeasures& m) {
  const Quantity& contacts = quantity(m.end, "segregation", "contact_mixing");
  const Quantity& cells = quantity(m.end, "segregation", "cell_lacey");
  if (!contacts.value || !cells.value) return "";
  const double z_contacts = quantity(m.end, "segregation", "contact_mixing_z").value.value_or(0);
  const double z_cells = quantity(m.end, "segregation", "cell_lacey_z").value.value_or(0);
  return fmt::format(
      "From neighbour to neighbour the types are {} (contact mixing index {}, z = {:+.1f}), in cells of three "
      "diameters "
      "{} (Lacey's index {}, z = {:+.1f}).",
      verdict(z_contacts, "more mixed than chance would have it", "less mixed than chance would have it"),
      analysis::value_text(contacts), z_contacts,
      verdict(z_cells, "more mixed than chance would have it", "less mixed than chance would have it"),
      analysis::value_text(cells), z_cells);
}

std::string chains(const ReportedMeasures& m) {
  const Quantity& share = quantity(m.end, "forces", "chain_particle_share");
  const Quantity& count = quantity(m.end, "forces", "chain_count");
  if (!share.value || !count.value || *count.value == 0) return "";
  return fmt::format("Forces run in {} chains of {} particles on average, which hold {:.0f} % of the particles.",
                     analysis::value_text(count), text(m.end, "forces", "chain_length_mean"), 100 * *share.value);
}

std::string account(const RunReader& run) {
  const History h = run.history();
  double input = 0;
  for (const char* work : {"growth_work", "gravity_work", "wall_work"}) {
    if (h.rows() > 0 && h.has(work)) input += h.column(work).back();  // older runs have no wall_work
  }
  if (input <= 0) return "Nothing has put energy in yet.";
  const double error = h.column("energy_error").back();
  return fmt::format(
      "Growth, gravity and moving boundaries put in {:.4g} J; the contact law took out {:.4g} J; {:.3g} J ({:.1f} % of "
      "the input) are not "
      "accounted for. {}",
      input, h.column("dissipated").back(), error, 100 * error / input,
      std::abs(error) > account_share * input
          ? "The time step feeds that energy in, and the law takes it out again: the bed is kept moving."
          : "The account closes.");
}

}  // namespace

const Quantity& quantity(const Results& results, const std::string& measure, const std::string& key) {
  for (const auto& result : results) {
    const Quantity* found = result.name == measure ? result.quantity(key) : nullptr;
    if (found) return *found;
  }
  throw RunError(fmt::format("there is no quantity {}.{}", measure, key));
}

std::vector<std::string> findings(const RunReader& run, const ReportedMeasures& m) {
  std::vector<std::string> sentences = {rest(m),       packing(m),  segregation(m), layers(run, m),
                                        neighbours(m), clusters(m), chains(m),      account(run)};
  std::erase(sentences, "");
  return sentences;
}

}  // namespace packstone::cli
