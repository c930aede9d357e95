#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/geometry.hpp"
#include "tests/shell.hpp"
#include "tests/temporary_folder.hpp"
#include "tests/viz/packings.hpp"
#include "viz/common_colouring.hpp"
#include "viz/save_drawing.hpp"
#include "viz/slice_drawing.hpp"
#include "viz/svg.hpp"

using namespace packstone;
using namespace packstone::viz;

namespace {

bool centre_inside(const Disc& disc, const Domain& domain, PlaneAxes axes) {
  return disc.u >= domain.min[axes.u] && disc.u < domain.max[axes.u] && disc.v >= domain.min[axes.v] &&
         disc.v < domain.max[axes.v];
}

}  // namespace

TEST_CASE("the discs of all slices add up to the volume of the spheres") {
  const Snapshot snapshot = testing::layered_packing(1);
  double volume = 0;
  for (const double r : snapshot.radius) volume += sphere_volume(r);
  constexpr int slices = 2000;
  for (int axis = 0; axis < 3; ++axis) {
    const double thickness = snapshot.domain.size()[axis] / slices;
    const PlaneAxes axes = axes_in_plane(axis);
    double sum = 0;
    for (int i = 0; i < slices; ++i) {
      for (const Disc& disc : slice_discs(snapshot, {axis, (i + 0.5) * thickness})) {
        if (centre_inside(disc, snapshot.domain, axes)) sum += M_PI * disc.radius * disc.radius * thickness;
      }
    }
    CHECK(sum == Approx(volume).epsilon(1e-3));
  }
}

TEST_CASE("a disc has the true radius, and images where it sticks out of a periodic side") {
  Snapshot snapshot = testing::empty_box(Vec3::Ones());
  testing::add_particle(snapshot, Vec3(0.05, 0.02, 0.5), 0.1, 0);
  const auto discs = slice_discs(snapshot, {2, 0.56});
  REQUIRE(discs.size() == 4);  // a corner: itself, one image a side and one beyond both
  for (const Disc& disc : discs) CHECK(disc.radius == Approx(0.08));
  // The plane close to the other end cuts the image along its own axis.
  REQUIRE(slice_discs(snapshot, {1, 0.96}).size() == 2);
  CHECK(slice_discs(snapshot, {1, 0.96}).front().radius == Approx(0.08));
  snapshot.domain.periodic = {false, false, false};
  CHECK(slice_discs(snapshot, {2, 0.56}).size() == 1);
  CHECK(slice_discs(snapshot, {1, 0.96}).empty());
}

TEST_CASE("oblique slices add up to the volume, too, and their discs are those of the plane") {
  const Snapshot snapshot = [] {
    Snapshot box = testing::empty_box(Vec3(1, 0.8, 1.2));
    box.domain.periodic = {false, false, false};
    testing::add_particle(box, Vec3(0.3, 0.4, 0.3), 0.2, 0);
    testing::add_particle(box, Vec3(0.7, 0.3, 0.8), 0.25, 1);
    testing::add_particle(box, Vec3(0.5, 0.5, 0.6), 0.05, 1);
    return box;
  }();
  double volume = 0;
  for (const double r : snapshot.radius) volume += sphere_volume(r);
  for (const Vec3& normal : {Vec3(1, 1, 0), Vec3(-1, 2, 3), Vec3(0.01, 0, 1)}) {
    constexpr int slices = 3000;
    constexpr double thickness = 2.0 / slices;
    double sum = 0;
    for (int i = 0; i < slices; ++i) {
      const Vec3 point = Vec3(0.5, 0.4, 0.6) + (-1 + (i + 0.5) * thickness) * normal.normalized();
      const SlicePlane plane(point, normal);
      if (section(snapshot.domain, plane).empty()) continue;
      for (const Disc& disc : slice_discs(snapshot, plane)) {
        sum += M_PI * disc.radius * disc.radius * thickness;
        const Vec3 centre = plane.origin + disc.u * plane.right + disc.v * plane.up;
        const double r = snapshot.radius[disc.row], h = (snapshot.position[disc.row] - centre).norm();
        if (std::abs(h * h + disc.radius * disc.radius - r * r) > 1e-12) FAIL("not the plane's disc");
      }
    }
    CHECK(sum == Approx(volume).epsilon(1e-3));
  }
  CHECK_THROWS_AS(slice_discs(snapshot, SlicePlane(Vec3(3, 0, 0), Vec3(1, 1, 0))), InputError);
  CHECK_THROWS_AS(SlicePlane(Vec3::Zero(), Vec3::Zero()), InputError);
}

TEST_CASE("an oblique plane through a periodic box cuts the images, so that no area is lost") {
  // A sphere in the corner: the plane x + y = L cuts its images only.
  Snapshot snapshot = testing::empty_box(Vec3::Ones());
  testing::add_particle(snapshot, Vec3(0.02, 0.02, 0.5), 0.2, 0);
  const auto discs = slice_discs(snapshot, SlicePlane(Vec3(0.5, 0.5, 0.5), Vec3(1, 1, 0)));
  REQUIRE(discs.size() == 2);
  for (const Disc& disc : discs) {
    CHECK(disc.radius == Approx(std::sqrt(0.04 - 0.04 * 0.04 / 2)));
    CHECK(std::abs(disc.u) == Approx(std::sqrt(0.5)).margin(1e-9));
  }
}

TEST_CASE("the part of the domain in a plane is a polygon of the right area") {
  Domain domain;
  domain.max = Vec3(1, 2, 3);
  const auto area = [&](const SlicePlane& plane) {
    const auto corners = section(domain, plane);
    double twice = 0;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const InPlane &a = corners[k], &b = corners[(k + 1) % corners.size()];
      twice += a.u * b.v - b.u * a.v;
    }
    return std::abs(twice) / 2;
  };
  CHECK(area({2, 1}) == Approx(2));
  CHECK(area({Vec3(0.5, 1, 1.5), Vec3(1, 0, 0)}) == Approx(6));
  CHECK(area({Vec3(0.5, 1, 1.5), Vec3(2, 1, 0)}) == Approx(3 * std::sqrt(5)));  // along the diagonal of the floor
  // Through the centre of a cube, square to its diagonal: a regular hexagon of side sqrt(1/2).
  domain.max = Vec3::Ones();
  const SlicePlane hexagon(Vec3::Constant(0.5), Vec3::Ones());
  CHECK(section(domain, hexagon).size() == 6);
  CHECK(area(hexagon) == Approx(1.5 * std::sqrt(3) / 2));
  CHECK(distance_from(section(domain, hexagon), {0, 0}) == 0);
  CHECK(distance_from(section(domain, hexagon), {10, 0}) > 9);
}

TEST_CASE("panels have one scale of length and of colour, and a letter each") {
  Snapshot small = testing::empty_box(Vec3::Ones()), large = testing::empty_box(Vec3(2, 1, 1.5));
  testing::add_particle(small, Vec3(0.5, 0.5, 0.5), 0.1, 0);
  testing::add_particle(large, Vec3(0.5, 0.5, 0.5), 0.2, 0);
  SliceOptions options;
  options.color = "radius";
  options.title = "";
  const Drawing drawing = slice_drawing({{small, {1, 0.5}, "small"}, {large, {1, 0.5}, "large"}}, options);
  std::vector<const DiscMark*> discs;
  std::vector<std::string> texts;
  for (const Mark& mark : drawing.marks) {
    if (const auto* disc = std::get_if<DiscMark>(&mark)) discs.push_back(disc);
    if (const auto* text = std::get_if<TextMark>(&mark)) texts.push_back(text->text);
  }
  REQUIRE(discs.size() == 2);
  CHECK(discs[1]->radius == Approx(2 * discs[0]->radius));
  CHECK(discs[0]->fill.colour == sequential_colour(0));
  CHECK(discs[1]->fill.colour == sequential_colour(1));
  CHECK(discs[0]->centre.x < discs[1]->centre.x);
  CHECK(std::count(texts.begin(), texts.end(), "(a) small") == 1);
  CHECK(std::count(texts.begin(), texts.end(), "(b) large") == 1);
  options.columns = 1;
  const Drawing below = slice_drawing({{small, {1, 0.5}, ""}, {large, {1, 0.5}, ""}}, options);
  discs.clear();
  for (const Mark& mark : below.marks) {
    if (const auto* disc = std::get_if<DiscMark>(&mark)) discs.push_back(disc);
  }
  CHECK(discs[0]->centre.y < discs[1]->centre.y);
}

TEST_CASE("panels of different groups have one legend, in which a colour means one name") {
  Snapshot sand = testing::empty_box(Vec3::Ones()), mixture = sand;
  sand.groups.resize(1);
  sand.groups[0].name = "sand";
  mixture.groups.resize(2);
  mixture.groups[0].name = "clay";
  mixture.groups[1].name = "sand";
  testing::add_particle(sand, Vec3(0.5, 0.5, 0.5), 0.1, 0);
  testing::add_particle(mixture, Vec3(0.3, 0.5, 0.5), 0.1, 0);
  testing::add_particle(mixture, Vec3(0.7, 0.5, 0.5), 0.1, 1);
  const Drawing drawing = slice_drawing({{sand, {1, 0.5}, ""}, {mixture, {1, 0.5}, ""}}, {});
  std::vector<Colour> cut, swatches;
  std::vector<std::string> texts;
  for (const Mark& mark : drawing.marks) {
    if (const auto* disc = std::get_if<DiscMark>(&mark)) (disc->outline ? cut : swatches).push_back(disc->fill.colour);
    if (const auto* text = std::get_if<TextMark>(&mark)) texts.push_back(text->text);
  }
  const Colour first = category_colour(0), second = category_colour(1);
  CHECK((cut == std::vector<Colour>{first, second, first}));
  CHECK((swatches == std::vector<Colour>{first, second}));
  const auto place = [&](const char* name) { return std::find(texts.begin(), texts.end(), name) - texts.begin(); };
  CHECK(std::count(texts.begin(), texts.end(), "sand") == 1);
  CHECK(std::count(texts.begin(), texts.end(), "clay") == 1);
  CHECK(place("sand") < place("clay"));
}

TEST_CASE("panels of numbered categories have the numbers of all in their legend") {
  Snapshot low = testing::empty_box(Vec3::Ones()), high = low;
  testing::add_particle(low, Vec3(0.5, 0.5, 0.5), 0.1, 0);
  testing::add_particle(high, Vec3(0.5, 0.5, 0.5), 0.1, 0);
  low.fields["cluster"] = Field{1, "", {2}};
  high.fields["cluster"] = Field{1, "", {10}};
  const auto legend = [&](const Snapshot& a, const Snapshot& b) {
    const auto colourings = colour_together({a, b}, "category:cluster", std::nullopt);
    std::string names;
    for (const LegendEntry& entry : colourings[0].entries) names += entry.name + " ";
    CHECK(colourings[1].entries.size() == colourings[0].entries.size());
    return names;
  };
  CHECK(legend(low, high) == "2 10 ");
  CHECK(legend(high, low) == "2 10 ");
  CHECK(legend(low, low) == "2 ");
  Snapshot empty = testing::empty_box(Vec3::Ones());
  empty.fields["cluster"] = Field{};
  CHECK(legend(low, empty) == "2 ");
}

TEST_CASE("categories of a slice are whole numbers") {
  Snapshot snapshot = testing::empty_box(Vec3::Ones());
  testing::add_particle(snapshot, Vec3(0.5, 0.5, 0.5), 0.1, 0);
  snapshot.fields["cluster"] = Field{1, "", {3}};
  SliceOptions options;
  options.color = "category:cluster";
  CHECK_NOTHROW(slice_drawing(snapshot, {1, 0.5}, options));
  snapshot.fields["cluster"].values = {3.5};
  CHECK_THROWS_AS(slice_drawing(snapshot, {1, 0.5}, options), InputError);
  options.color = "category:radius";
  CHECK_THROWS_AS(slice_drawing(snapshot, {1, 0.5}, options), InputError);
}

TEST_CASE("the PDF of a slice holds a filled curve for every disc, as poppler reads it") {
  const testing::TemporaryFolder folder;
  const Snapshot snapshot = testing::layered_packing(1);
  SliceOptions options;
  options.color = "radius";
  options.legend = false;
  const SlicePlane plane{1, 0.29};
  save_drawing(folder / "a.pdf", slice_drawing(snapshot, plane, options), 1, "");
  const auto result =
      testing::shell("pdftocairo -svg " + testing::quoted(folder / "a.pdf") + " " + testing::quoted(folder / "a.svg"));
  REQUIRE(result.exit_code == 0);
  const std::string svg = read_text_file(folder / "a.svg");
  std::size_t discs = 0;
  for (std::size_t at = svg.find("<path"); at != std::string::npos; at = svg.find("<path", at + 1)) {
    const std::string path = svg.substr(at, svg.find('>', at) - at);
    if (path.find("fill:rgb") != std::string::npos && path.find(" C ") != std::string::npos) ++discs;
  }
  CHECK(discs == slice_discs(snapshot, plane).size());
  CHECK(discs > 10);
}

TEST_CASE("an empty panel takes the scale of the others") {
  Snapshot empty = testing::empty_box(Vec3::Ones()), one = empty;
  testing::add_particle(one, Vec3(0.5, 0.5, 0.5), 0.1, 0);
  const auto colourings = colour_together({empty, one}, "radius", std::nullopt);
  CHECK((colourings[0].range == colourings[1].range));
  CHECK(colourings[0].range->first == Approx(0.05));
  CHECK(colourings[0].range->second == Approx(0.15));
}

TEST_CASE("titles too long for their room have smaller letters") {
  const Snapshot snapshot = testing::layered_packing(1);
  SliceOptions options;
  options.width = 400;
  options.height = 800;
  options.title = "A title that is a good deal longer than the picture is wide";
  const std::string heading = "a heading that is much longer than its panel";
  const SlicePlane plane{1, 0.29};
  options.columns = 2;
  const Drawing drawing = slice_drawing({{snapshot, plane, heading}, {snapshot, plane, heading}}, options);
  std::vector<const TextMark*> headings;
  for (const Mark& mark : drawing.marks) {
    const auto* text = std::get_if<TextMark>(&mark);
    if (text == nullptr) continue;
    if (text->text == options.title) CHECK(text_width(text->text, text->style.size, true) <= options.width);
    if (text->text.ends_with(heading)) headings.push_back(text);
  }
  REQUIRE(headings.size() == 2);
  CHECK(headings[0]->at.x + text_width(headings[0]->text, headings[0]->style.size) <= headings[1]->at.x);
  CHECK(headings[1]->at.x + text_width(headings[1]->text, headings[1]->style.size) <= options.width);
}

TEST_CASE("an oblique plane is told by point and normal, without negative zeros") {
  CHECK(plane_text(SlicePlane(Vec3(0.1, 0, 0.2), Vec3(1, -1e-20, 0))) == "through (0.1, 0, 0.2) m, normal (1, 0, 0)");
  CHECK(through_text(SlicePlane(Vec3(0.001, 0.02, -0.003), Vec3(1, 1, 1))) == "through (1, 20, -3) mm");
  CHECK(through_text(SlicePlane(Vec3::Zero(), Vec3(1, 1, 1))) == "through (0, 0, 0) m");
  CHECK(vector_text(Vec3(-0.0, 1, -1e-17), 2) == "(0, 1, 0)");
}

TEST_CASE("a plane outside the domain is refused") {
  const Snapshot snapshot = testing::layered_packing(1);
  CHECK_THROWS_AS(slice_discs(snapshot, {2, 1.7}), InputError);
  CHECK_THROWS_AS(slice_discs(snapshot, {2, std::nan("")}), InputError);
}

TEST_CASE("a plane is read from text") {
  CHECK(plane_from_text("z=0.1").axis == 2);
  CHECK(plane_from_text(" y = 290 mm").axis == 1);
  CHECK(plane_from_text("y = 290 mm").position == Approx(0.29));
  const SlicePlane oblique = plane_from_text("through 100 mm,0.2,0.3 normal 0,3,4");
  CHECK((oblique.normal - Vec3(0, 0.6, 0.8)).norm() < 1e-15);
  CHECK(oblique.height(Vec3(7, 0.2, 0.3)) == Approx(0).margin(1e-15));
  CHECK(oblique.right == Vec3::UnitX());
  for (const char* text : {"", "w=1", "z", "z=", "zz=1", "z=high", "z=1 s", "through 1,2,3", "through 1,2 normal 0,0,1",
                           "through 1,2,3 normal 0,0,0", "through 1,2,3 normal 0,0,1,1"})
    CHECK_THROWS_AS(plane_from_text(text), InputError);
}

TEST_CASE("a slice shows the cut particles in their colours, and paper between them") {
  Snapshot snapshot = testing::empty_box(Vec3::Ones());
  testing::add_particle(snapshot, Vec3(0.3, 0.5, 0.3), 0.15, 0);
  testing::add_particle(snapshot, Vec3(0.7, 0.5, 0.7), 0.15, 1);
  SliceOptions options;
  options.width = 400;
  options.height = 300;
  const SlicePlane plane{1, 0.5};
  const Drawing drawing = slice_drawing(snapshot, plane, options);
  const Image image = draw_slice(snapshot, plane, options);
  int discs = 0;
  for (const Mark& mark : drawing.marks) {
    const auto* disc = std::get_if<DiscMark>(&mark);
    if (disc == nullptr || !disc->outline) continue;  // the legend's swatches have none
    const Colour expected = category_colour(static_cast<std::size_t>(discs++));
    CHECK(image.at(static_cast<int>(disc->centre.x), static_cast<int>(disc->centre.y)) == expected);
    const int beside = static_cast<int>(disc->centre.x + 1.15 * disc->radius);
    CHECK(image.at(beside, static_cast<int>(disc->centre.y)) == paper);
  }
  CHECK(discs == 2);
}

TEST_CASE("the SVG of a slice holds a circle for every disc and the labels as text") {
  const Snapshot snapshot = testing::layered_packing(1e-6);
  SliceOptions options;
  options.legend = false;
  const SlicePlane plane{1, 0.29e-6};
  const std::string svg = svg_text(slice_drawing(snapshot, plane, options), "cut <1>");
  std::size_t circles = 0;
  for (std::size_t at = svg.find("<circle"); at != std::string::npos; at = svg.find("<circle", at + 1)) ++circles;
  CHECK(circles == slice_discs(snapshot, plane).size());
  CHECK(svg.find("y = 0.29 µm") != std::string::npos);
  CHECK(svg.find("x [µm]") != std::string::npos);
  CHECK(svg.find("<title>cut &lt;1&gt;</title>") != std::string::npos);
}

TEST_CASE("an empty packing has an empty slice") {
  CHECK_NOTHROW(draw_slice(testing::empty_box(Vec3::Ones()), {2, 0.5}, {}));
}
