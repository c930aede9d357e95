// Regions as the user writes them, and what of them lies in the domain.
#include <cmath>
#include <limits>
#include <map>
#include <vector>

#include <fmt/format.h>

#include "analysis/packing/region.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "core/text_lines.hpp"
#include "core/units.hpp"

namespace packstone::analysis {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double side_rounding = 1e-9;  // of the domain's length: by so much a region may exceed a periodic side

/// Kinds with what follows the colon.
const std::map<std::string, std::string> kinds = {
    {"box", "x0,y0,z0,x1,y1,z1"},
    {"slab", "AXIS,lower,upper"},
    {"sphere", "x,y,z,radius"},
    {"cylinder", "AXIS,u,v,lower,upper,radius"},
    {"ring", "AXIS,u,v,lower,upper,inner,outer"},
};

std::string all_forms() {
  std::vector<std::string> forms;
  for (const auto& [kind, values] : kinds) forms.push_back(kind + ":" + values);
  return joined(forms, "; ");
}

/// The text of one region, taken apart.
class Reader {
 public:
  explicit Reader(const std::string& text) : text_(text) {
    const std::size_t colon = text.find(':');
    kind_ = std::string(trimmed(text.substr(0, colon)));
    const auto form = kinds.find(kind_);
    if (form == kinds.end() || colon == std::string::npos) fail("no such kind; the regions are " + all_forms());
    words_ = split(std::string_view(text_).substr(colon + 1), ',');
    const std::size_t wanted = split(form->second, ',').size();
    if (words_.size() != wanted) {
      fail(fmt::format("{} values, but {} are expected: {}:{}", words_.size(), wanted, kind_, form->second));
    }
  }

  const std::string& kind() const { return kind_; }

  int axis(std::size_t word) const {
    for (int k = 0; k < 3; ++k) {
      if (words_[word] == axis_names[k]) return k;
    }
    fail(fmt::format("\"{}\" is no axis; expected x, y or z", words_[word]));
  }

  double length(std::size_t word) const {
    try {
      return parse_quantity(std::string(words_[word]), unit::metre);
    } catch (const InputError& error) {
      fail(error.what());
    }
  }

  Vec3 point(std::size_t word) const { return {length(word), length(word + 1), length(word + 2)}; }

  void require(bool condition, const std::string& what) const {
    if (!condition) fail(what);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw InputError("region \"" + text_ + "\": " + what); }

  std::string text_;
  std::string kind_;
  std::vector<std::string_view> words_;
};

RegionShape box_from(const Reader& read) {
  const BoxRegion box{read.point(0), read.point(3)};
  read.require((box.max - box.min).minCoeff() > 0, "the second corner must be above the first along every axis");
  return box;
}

RegionShape slab_from(const Reader& read) {
  BoxRegion box{Vec3::Constant(-infinity), Vec3::Constant(infinity)};
  const int axis = read.axis(0);
  box.min[axis] = read.length(1);
  box.max[axis] = read.length(2);
  read.require(box.max[axis] > box.min[axis], "upper must be above lower");
  return box;
}

RegionShape sphere_from(const Reader& read) {
  const SphereRegion sphere{read.point(0), read.length(3)};
  read.require(sphere.radius > 0, "the radius must be above 0");
  return sphere;
}

RegionShape ring_from(const Reader& read, bool hollow) {
  RingRegion ring{.axis = read.axis(0), .centre = Vec3::Zero(), .inner = 0, .outer = 0, .lower = 0, .upper = 0};
  std::size_t word = 1;
  for (int k = 0; k < 3; ++k) {
    if (k != ring.axis) ring.centre[k] = read.length(word++);
  }
  ring.lower = read.length(3);
  ring.upper = read.length(4);
  ring.inner = hollow ? read.length(5) : 0;
  ring.outer = read.length(hollow ? 6 : 5);
  read.require(ring.upper > ring.lower, "upper must be above lower");
  read.require(ring.inner >= 0, "the inner radius must be 0 or above");
  read.require(ring.outer > ring.inner, hollow ? "outer must be above inner" : "the radius must be above 0");
  return ring;
}

/// Whether the region can be cut off across an axis and stay of its kind.
bool flat_across(const RegionShape& shape, int axis) {
  const auto* ring = std::get_if<RingRegion>(&shape);
  return std::holds_alternative<BoxRegion>(shape) || (ring && ring->axis == axis);
}

}  // namespace

NamedRegion parse_region(const std::string& text) {
  const Reader read(text);
  if (read.kind() == "box") return {text, box_from(read)};
  if (read.kind() == "slab") return {text, slab_from(read)};
  if (read.kind() == "sphere") return {text, sphere_from(read)};
  return {text, ring_from(read, read.kind() == "ring")};
}

RegionShape clipped(const NamedRegion& region, const Domain& domain) {
  const auto fail = [&](const std::string& what, int axis) {
    throw InputError(fmt::format("region \"{}\" {}, which along {} is from {:g} to {:g} m", region.text, what,
                                 axis_names[axis], domain.min[axis], domain.max[axis]));
  };
  RegionShape shape = region.shape;
  for (int k = 0; k < 3; ++k) {
    const BoxRegion box = bounds(shape);
    const double length = domain.size()[k];
    const bool endless = !std::isfinite(box.min[k]);
    if (domain.periodic[k] && !endless) {
      if (box.max[k] - box.min[k] > length * (1 + side_rounding)) fail("is longer than the periodic domain", k);
      continue;
    }
    const double lower = std::max(box.min[k], domain.min[k]), upper = std::min(box.max[k], domain.max[k]);
    if (!(upper > lower)) fail("lies outside of the domain", k);
    if (lower == box.min[k] && upper == box.max[k]) continue;
    if (!flat_across(shape, k)) fail("has a round side that reaches out of the domain", k);
    shape = between(shape, k, lower, upper);
  }
  return shape;
}

}  // namespace packstone::analysis
