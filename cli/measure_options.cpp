#include "cli/measure_options.hpp"

#include <map>
#include <string>
#include <vector>

#include "analysis/layers.hpp"

namespace packstone::cli {

namespace {

constexpr double right_angle = 90;  // [degrees]

/// Options of one kind of measures, under its heading in the help.
class Group {
 public:
  Group(Verb& verb, std::string heading) : verb_(verb), heading_(std::move(heading)) {}

  template <class Value>
  Option add(const std::string& name, Value& value, const std::string& description) {
    return verb_.add(name, value, description).heading(heading_);
  }
  /// Above 0; what stands for the default is in the description.
  template <class Value>
  void add_positive(const std::string& name, Value& value, const std::string& description) {
    add(name, value, description).positive();
  }
  void add_flag(const std::string& name, bool& value, const std::string& description) {
    verb_.add_flag(name, value, description).heading(heading_);
  }
  /// One of some words.
  template <class Choice>
  void add_choice(const std::string& name, Choice& value, const std::map<std::string, Choice>& choices,
                  const std::string& description) {
    std::vector<std::string> words;
    for (const auto& choice : choices) words.push_back(choice.first);
    const auto read = [&value, choices](const std::string& word) { value = choices.at(word); };
    verb_.add_word(name, read, description).one_of(words).heading(heading_);
  }
  /// May be repeated.
  void add_words(const std::string& name, std::function<void(const std::string&)> read,
                 const std::string& description) {
    verb_.add_words(name, std::move(read), description).heading(heading_);
  }

 private:
  Verb& verb_;
  std::string heading_;
};

void add_packing(Verb& verb, analysis::Options& o) {
  Group group(verb, "Packing");
  group.add_positive("--profile-layer", o.profile_layer,
                     "Thickness of the vertical profile's layers [m] [one mean radius]");
  group.add_positive("--wall-layer", o.wall_layer,
                     "Width of the rings and shells of the profiles from the side walls [m] [one mean radius]");
  group
      .add("--interior-margin", o.interior_margin,
           "Distance of the interior from walls, floor and surface, in mean diameters weighted by volume")
      .not_negative()
      .shows_default();
  group.add_words(
      "--region", [&o](const std::string& text) { o.regions.push_back(analysis::parse_region(text)); },
      "Region whose solid fraction to measure, again for more: box:x0,y0,z0,x1,y1,z1; "
      "slab:AXIS,lower,upper; sphere:x,y,z,radius; cylinder:AXIS,u,v,lower,upper,radius; "
      "ring:AXIS,u,v,lower,upper,inner,outer; u, v: the axis' place in the other two coordinates");
  group.add_positive("--map-cell", o.map_cell, "Width of the map's cells [m] [one mean diameter weighted by volume]");
  group.add_positive("--surface-probe", o.surface_probe,
                     "Radius of the ball that rolls over the free surface [m] [mean radius weighted by volume]");
  group.add_positive("--surface-step", o.surface_step,
                     "Between the columns of the free surface [m] [an eighth of the ball's or that radius]");
  group.add_flag("--voronoi-cells", o.voronoi_cells, "Measure voronoi also lists the cell of every particle");
}

void add_structure(Verb& verb, analysis::Options& o) {
  Group group(verb, "Structure");
  group.add_positive("--rdf-range", o.rdf_range, "Range of the radial distribution function [m] [five mean diameters]");
  group.add_positive("--rdf-bin", o.rdf_bin, "Width of its bins [m] [a twentieth of the mean diameter]");
  group.add("--bond-cutoff", o.bond_cutoff, "Bond order: neighbours have centres nearer than so many sums of radii")
      .shows_default();
  group.add_positive("--bond-neighbours", o.bond_neighbours,
                     "Bond order: so many nearest neighbours instead [by cut-off]");
  group.add("--pore-points", o.pore_points, "Random points for the pore sizes").shows_default();
}

void add_segregation(Verb& verb, analysis::Options& o) {
  using analysis::AlongAxis, analysis::ShareBy;
  Group group(verb, "Segregation");
  group.add_positive("--segregation-layer", o.segregation_layer,
                     "Thickness of the layers of composition and segregation [m] [one mean diameter]");
  group.add_positive("--segregation-cells", o.segregation_cell,
                     "Edge of the cells of segregation [m] [three mean diameters]");
  group
      .add("--segregation-rings", o.segregation_rings,
           "Number of rings of segregation about the axis [outermost one diameter wide]")
      .between(2, static_cast<int>(analysis::most_layers));
  group.add_choice<ShareBy>("--segregation-by", o.segregation_by,
                            {{"number", ShareBy::number}, {"volume", ShareBy::volume}, {"mass", ShareBy::mass}},
                            "What shares are of [volume]");
  group.add_choice<AlongAxis>("--segregation-axis", o.segregation_axis,
                              {{"up", AlongAxis::up}, {"x", AlongAxis::x}, {"y", AlongAxis::y}, {"z", AlongAxis::z}},
                              "Axis of the layers and rings of segregation [up]");
}

void add_clusters(Verb& verb, analysis::ClusterOptions& o) {
  Group group(verb, "Clusters");
  group.add_positive("--cluster-gap", o.gap,
                     "Clusters of particles whose surfaces are nearer than this [m] [contacts]");
  group.add_positive("--cluster-force", o.least_force,
                     "Clusters of contacts that press by more than so many mean normal forces");
  group.add_flag("--cluster-any-type", o.any_type, "Clusters of any types, not of like ones");
}

void add_forces(Verb& verb, analysis::ForceOptions& o) {
  using analysis::Kernel;
  Group group(verb, "Forces");
  group.add("--chain-threshold", o.chain_threshold, "Stress of particles in force chains, in means")
      .not_negative()
      .shows_default();
  group.add("--chain-angle", o.chain_angle, "Largest angle of a chain to its particles' stress [degrees]")
      .between(0.0, right_angle)
      .shows_default();
  group.add_choice<Kernel>("--kernel", o.kernel, {{"lucy", Kernel::lucy}, {"gaussian", Kernel::gaussian}},
                           "Kernel of coarse-grained fields [lucy]");
  group.add_positive("--kernel-width", o.kernel_width,
                     "Standard deviation of that kernel along an axis [m] [one mean radius]");
  group.add_positive("--coarse-cell", o.coarse_cell,
                     "Width of the cells of --coarse [m] [two widths of the kernel, or as many cells as particles]");
  group.add("--community-resolution", o.resolution, "Larger values give smaller communities")
      .positive()
      .shows_default();
}

}  // namespace

void add_measure_options(Verb& verb, analysis::Options& options) {
  add_packing(verb, options);
  add_structure(verb, options);
  add_segregation(verb, options);
  add_clusters(verb, options.clusters);
  add_forces(verb, options.forces);
}

}  // namespace packstone::cli
