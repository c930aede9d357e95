// Particles on boundaries of every kind: the same answer from different shapes, and the answers of mechanics.
#include <cmath>
#include <fstream>
#include <numbers>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "hand_made.hpp"
#include "tests/temporary_folder.hpp"

using namespace packstone;
using namespace packstone::engine;
using Catch::Contains;
using engine::testing::contact_scene;
using engine::testing::HandMade;
using engine::testing::Sphere;
using packstone::testing::TemporaryFolder;

namespace {

constexpr double g = 9.8, ball_radius = 0.02;
const std::string smooth = "normal = \"linear\"\n", rough = "normal = \"linear\"\ntangential = \"cundall-strack\"\n";
const std::string elastic = "restitution = 1\n", lossy = "restitution = 0.3\n",
                  grips = "restitution = 0.3\nfriction = 0.8\ntangential_stiffness = 1e6\n";

std::string boundary(const std::string& keys, const std::string& name = "b") {
  return "[[boundary]]\nname = \"" + name + "\"\n" + keys;
}

const std::string plane_floor = "kind = \"plane\"\npoint = [0, 0, 0.1]\nnormal = [0, 0, 1]\n";
/// The same floor in other shapes; triangles' sides run below where the spheres go.
const std::string other_floors[] = {
    "kind = \"box\"\nmin = [0, 0, 0.1]\nmax = [1, 1, 0.9]\n",
    "kind = \"polygons\"\npolygons = [[[0,0,0.1],[0.5,0,0.1],[0.5,1,0.1],[0,1,0.1]], "
    "[[0.5,0,0.1],[1,0,0.1],[1,1,0.1],[0.5,1,0.1]]]\n",
    "kind = \"surface\"\nformula = \"0.1\"\ntolerance = 1e-3\n",
    "kind = \"cylinder\"\npoint = [0.5, 0.5, 0.1]\nradius = 0.7\nlength = 0.8\nclosed = [\"bottom\"]\n"};

/// Positions of a sphere thrown along a floor and of one laid upon it, after a while.
std::vector<Vec3> thrown(const std::string& floor, bool friction) {
  const Scene scene = friction ? contact_scene(rough, grips, false, boundary(floor))
                               : contact_scene(smooth, lossy, false, boundary(floor));
  HandMade run(
      scene,
      {{Vec3(0.3, 0.31, 0.15), Vec3(0.8, 0.7, -0.5), ball_radius}, {Vec3(0.5, 0.5, 0.12), Vec3::Zero(), ball_radius}},
      1e-5, ContactVelocity::half_step);
  run.input.gravity = Vec3(0, 0, -g);
  for (int n = 0; n < 40000; ++n) run.step();
  return {run.position(0), run.position(1)};
}

}  // namespace

TEST_CASE("a floor is a floor in whatever shape it is given") {
  const bool friction = GENERATE(false, true);
  const std::vector<Vec3> expected = thrown(plane_floor, friction);
  CHECK(expected[0].x() > 0.45);  // it went across sides and corners
  for (const std::string& floor : other_floors) {
    INFO(floor);
    const std::vector<Vec3> found = thrown(floor, friction);
    CHECK((found[0] - expected[0]).norm() < 1e-9);
    CHECK((found[1] - expected[1]).norm() < 1e-9);
  }
}

TEST_CASE("a sphere over a side or corner that triangles share has one contact") {
  const Scene scene = contact_scene(smooth, elastic, false, boundary(other_floors[2]));
  const double x = GENERATE(0.5, 0.375, 0.6);  // a corner of four cells, a side, a face
  HandMade run(scene, {{Vec3(x, 0.5, 0.1 + 0.99 * ball_radius), Vec3::Zero(), ball_radius}}, 1e-6);
  Recorder recorder;
  recorder.want_contacts = true;
  recorder.velocity.resize(1);
  recorder.force.resize(1);
  run.step(&recorder);
  REQUIRE(recorder.contacts.size() == 1);
  CHECK(recorder.contacts.force[0].z() == Approx(1e6 * 0.01 * ball_radius).epsilon(1e-9));
  CHECK(recorder.contacts.point[0].z() == Approx(0.1 - 0.5 * 0.01 * ball_radius).epsilon(1e-9));
  CHECK(run.dynamics->wall_loads()[0].force.z() == Approx(-1e6 * 0.01 * ball_radius).epsilon(1e-9));
}

TEST_CASE("a sphere that rolls off an edge goes round it with its energy") {
  // A table that ends at x = 0.5: frictionless and elastic, the sphere falls round the edge and swings free of it.
  const std::string table = "kind = \"polygons\"\npolygons = [[[0,0,0.5],[0.5,0,0.5],[0.5,1,0.5],[0,1,0.5]]]\n";
  const Scene scene = contact_scene(smooth, elastic, false, boundary(table));
  HandMade run(scene, {{Vec3(0.45, 0.5, 0.5 + ball_radius), Vec3(0.1, 0, 0), ball_radius}}, 2e-6);
  run.input.gravity = Vec3(0, 0, -g);
  const double m = run.mass(0);
  double least = 1;
  for (int n = 0; n < 400000; ++n) {
    run.step();
    if (run.position(0).x() > 0.5) least = std::min(least, (run.position(0) - Vec3(0.5, 0.5, 0.5)).norm());
  }
  CHECK(least > 0.98 * ball_radius);
  CHECK(run.position(0).x() > 0.5);
  const double energy = 0.5 * m * run.velocity(0).squaredNorm() + m * g * run.position(0).z();
  CHECK(energy == Approx(0.5 * m * 0.01 + m * g * (0.5 + ball_radius)).epsilon(1e-4));
}

TEST_CASE("a ball rolls to and fro in a round trough with the period of mechanics") {
  // T = 2 pi sqrt(7 (a - R) / (5 g)) for small swings of a sphere that rolls, sqrt((a - R)/g) of one that slides; the
  // contact goes from facet to facet in the trough of plates and keeps its spring.
  const bool rolls = GENERATE(true, false), facets = GENERATE(false, true);
  CAPTURE(rolls, facets);
  constexpr double a = 0.3, swing = 0.03;
  std::string trough = "kind = \"cylinder\"\npoint = [0.5, 0, 0.5]\naxis = [0, 1, 0]\nradius = 0.3\n";
  if (facets) {
    trough = "kind = \"polygons\"\npolygons = [";
    const int plates = 400;
    for (int k = 0; k < plates; ++k) {
      const auto corner = [&](int at, double y) {
        const double angle = 2 * std::numbers::pi * at / plates;
        return fmt::format("[{:.17g},{:g},{:.17g}]", 0.5 + a * std::cos(angle), y, 0.5 + a * std::sin(angle));
      };
      trough += fmt::format("{}[{},{},{},{}]", k > 0 ? "," : "", corner(k, 0), corner(k + 1, 0), corner(k + 1, 1),
                            corner(k, 1));
    }
    trough += "]\n";
  }
  const Scene scene = rolls ? contact_scene(rough, grips, false, boundary(trough))
                            : contact_scene(smooth, lossy, false, boundary(trough));
  const double dt = 2e-5, angle = swing / (a - ball_radius);
  HandMade run(scene,
               {{Vec3(0.5 + (a - ball_radius) * std::sin(angle), 0.5, 0.5 - (a - ball_radius) * std::cos(angle))}}, dt,
               ContactVelocity::half_step);
  run.input.gravity = Vec3(0, 0, -g);
  std::vector<double> crossings;
  double before = run.position(0).x(), largest = 0;
  for (int n = 1; crossings.size() < 4; ++n) {
    REQUIRE(n < 300000);
    run.step();
    const double now = run.position(0).x();
    if (before > 0.5 && now <= 0.5) crossings.push_back(n * dt);
    if (crossings.size() == 3) largest = std::max(largest, now - 0.5);
    before = now;
  }
  const double amplitude_correction = 1 + angle * angle / 16;
  const double period =
      2 * std::numbers::pi * std::sqrt((rolls ? 1.4 : 1.0) * (a - ball_radius) / g) * amplitude_correction;
  CHECK((crossings[3] - crossings[0]) / 3 == Approx(period).epsilon(facets ? 5e-3 : 1e-5));
  CHECK(largest == Approx((a - ball_radius) * std::sin(angle)).epsilon(facets ? 1e-2 : 1e-4));  // rolling loses nothing
}

TEST_CASE("a sphere that slides round in a smooth cylinder keeps energy and angular momentum") {
  const Scene scene =
      contact_scene(smooth, elastic, false,
                    boundary("kind = \"cylinder\"\npoint = [0.5, 0.5, 0]\nradius = 0.3\nside = \"inside\"\n"));
  HandMade run(scene, {{Vec3(0.7, 0.5, 0.5), Vec3(0.3, 1, 0.1), ball_radius}}, 2e-6);
  for (int n = 0; n < 200000; ++n) run.step();
  const Vec3 from_axis = run.position(0) - Vec3(0.5, 0.5, 0), v = run.velocity(0);
  CHECK(v.norm() == Approx(Vec3(0.3, 1, 0.1).norm()).epsilon(1e-4));
  CHECK(from_axis.cross(v).z() == Approx(0.2 * 1).epsilon(1e-6));
  CHECK(v.z() == Approx(0.1).epsilon(1e-12));
}

TEST_CASE("a floor that rises lifts its load, and its work is the load's energy") {
  const std::string lift =
      "kind = \"plane\"\npoint = [0, 0, 0.1]\nnormal = [0, 0, 1]\n[boundary.motion]\n"
      "displacement = [\"0\", \"0\", \"0.05*(1-cos(pi*t/0.4))\"]\nend = 0.4\n";
  const Scene scene = contact_scene(smooth, "restitution = 0.5\n", false, boundary(lift));
  HandMade run(scene, {{Vec3(0.5, 0.5, 0.12)}}, 5e-6);
  run.input.gravity = Vec3(0, 0, -g);
  run.step();
  double work = 0, dissipated = 0;
  for (int n = 0; n < 120000; ++n) {
    const StepSums sums = run.step();
    work += sums.wall_work;
    dissipated += sums.dissipated();
  }
  CHECK(run.position(0).z() == Approx(0.22).margin(1e-5));
  CHECK(work == Approx(run.mass(0) * g * 0.1 + dissipated).epsilon(2e-3));
}

TEST_CASE("what lies on a turntable goes round with it") {
  // Friction holds the sphere's contact; a sphere held from turning against the table goes round as the table does.
  const std::string table =
      "kind = \"plane\"\npoint = [0.5, 0.5, 0.1]\nnormal = [0, 0, 1]\n[boundary.motion]\n"
      "[boundary.motion.rotation]\naxis = [0, 0, 1]\nangle = \"2*t\"\n";
  const Scene scene = contact_scene(rough, grips, false, boundary(table));
  HandMade run(scene, {{Vec3(0.6, 0.5, 0.12 - 1e-6), Vec3(0, 0.2, 0), ball_radius}}, 1e-5, ContactVelocity::half_step);
  run.input.gravity = Vec3(0, 0, -g);
  for (int n = 0; n < 50000; ++n) {
    run.step();
    run.set_spin(0, Vec3(0, 0, 2));
  }
  const double angle = 2 * 0.5;
  CHECK(run.position(0).x() == Approx(0.5 + 0.1 * std::cos(angle)).margin(2e-4));
  CHECK(run.position(0).y() == Approx(0.5 + 0.1 * std::sin(angle)).margin(2e-4));
}

TEST_CASE("a vibrating floor goes as its sine") {
  const std::string floor =
      "kind = \"plane\"\npoint = [0, 0, 0.1]\nnormal = [0, 0, 1]\n[boundary.motion]\nstart = 0.01\n"
      "[boundary.motion.vibration]\namplitude = [0, 0, 1e-3]\nfrequency = 50\nphase = 0.5\n";
  const Scene scene = contact_scene(smooth, elastic, false, boundary(floor));
  Boundaries walls(scene, scene.box());
  for (const double t : {0.0, 0.005, 0.013, 0.02}) {
    walls.go_to(t, 1e-5, 0.5e-5);
    const double local = std::max(0.0, t - 0.01), phase = 2 * std::numbers::pi * 50 * local + 0.5;
    CHECK(walls.records()[0].point.z() == Approx(0.1 + 1e-3 * (std::sin(phase) - std::sin(0.5))).epsilon(1e-12));
    const double rate = t > 0.01 ? 1e-3 * 2 * std::numbers::pi * 50 * std::cos(phase) : 0;
    CHECK(walls[0].rate.velocity.z() == Approx(rate).epsilon(1e-5));
  }
}

TEST_CASE("a lid that is free presses with its weight and its force, and stops at its limit") {
  const std::string lid =
      "kind = \"plane\"\npoint = [0, 0, 0.1402]\nnormal = [0, 0, -1]\n[boundary.motion.free]\naxis = [0, 0, -1]\n"
      "mass = 2\nforce = \"30\"\n";
  const std::string material = "restitution = 0.1\n";
  const Scene scene = contact_scene(smooth, material, false, boundary(plane_floor, "floor") + boundary(lid, "lid"));
  HandMade run(scene, {{Vec3(0.5, 0.5, 0.12)}}, 1e-5);
  run.input.gravity = Vec3(0, 0, -g);
  for (int n = 0; n < 50000; ++n) run.step();
  const double weight = 2 * g + 30;
  CHECK(run.dynamics->wall_loads()[1].force.z() == Approx(weight).epsilon(1e-6));
  CHECK(run.dynamics->wall_loads()[0].force.z() == Approx(-weight - run.mass(0) * g).epsilon(1e-6));
  CHECK((*run.boundaries)[1].travel == Approx(0.0002 + weight / 1e6 + (weight + run.mass(0) * g) / 1e6).epsilon(1e-3));

  const Scene falls = contact_scene(smooth, material, false, boundary(lid + "limit = 0.005\n", "lid"));
  HandMade free_fall(falls, {{Vec3(0.5, 0.5, 0.05)}}, 1e-5);
  free_fall.input.gravity = Vec3(0, 0, -g);
  const double dt = 1e-5, a = g + 15;
  for (int n = 0; n < 1000; ++n) free_fall.step();
  CHECK((*free_fall.boundaries)[0].travel == Approx(0.5 * a * 0.01 * 0.01).epsilon(1e-2 * dt / 1e-5));
  for (int n = 0; n < 3000; ++n) free_fall.step();
  CHECK((*free_fall.boundaries)[0].travel == 0.005);
}

TEST_CASE("a boundary is there in its time only") {
  const Scene scene = contact_scene(smooth, lossy, false, boundary(plane_floor + "until = 0.2\n"));
  HandMade run(scene, {{Vec3(0.5, 0.5, 0.12)}}, 1e-5);
  run.input.gravity = Vec3(0, 0, -g);
  for (int n = 0; n < 20000; ++n) run.step();
  CHECK(run.position(0).z() == Approx(0.12).margin(1e-5));
  CHECK_FALSE(run.boundaries->records()[0].normal.isZero(0));
  for (int n = 0; n < 5000; ++n) run.step();
  CHECK(run.position(0).z() == Approx(0.12 - 0.5 * g * 0.05 * 0.05).epsilon(1e-3));
  CHECK(run.boundaries->records()[0].normal.isZero(0));
}

TEST_CASE("a surface goes on across a periodic side") {
  const auto rolled = [](const std::string& floor) {
    Scene scene = contact_scene(rough, grips, false, boundary(floor));
    scene.domain.periodic = {0, 1};
    HandMade run(scene, {{Vec3(0.9, 0.5, 0.12), Vec3(1, 0.3, 0), ball_radius}}, 1e-5, ContactVelocity::half_step);
    run.input.gravity = Vec3(0, 0, -g);
    for (int n = 0; n < 50000; ++n) run.step();
    return scene.box().wrapped(run.position(0));
  };
  const Vec3 expected = rolled(plane_floor);
  CHECK(expected.x() < 0.5);  // it went across
  CHECK((rolled("kind = \"surface\"\nformula = \"0.1\"\ntolerance = 1e-3\n") - expected).norm() < 1e-9);
}

TEST_CASE("nothing goes through a thin plate at half a radius a step") {
  const std::string plate = "kind = \"polygons\"\npolygons = [[[0,0,0.5],[1,0,0.5],[1,1,0.5],[0,1,0.5]]]\n";
  Scene scene = contact_scene(smooth, elastic, false, boundary(plate));
  const double speed = 20, dt = 0.5 * ball_radius / speed;
  scene.materials[0].normal_stiffness =
      0.05 * 1200 * std::pow(ball_radius, 3) / (dt * dt);  // soft enough for such steps
  for (int phase = 0; phase < 20; ++phase) {
    HandMade run(scene, {{Vec3(0.5, 0.5, 0.9 + phase * speed * dt / 20), Vec3(0, 0, -speed), ball_radius}}, dt);
    run.input.overlap_limit = 1;
    bool stopped = false;
    for (int n = 0; n < 200 && !stopped; ++n) stopped = run.step().offence.has_value();
    CHECK((stopped || run.velocity(0).z() > 0));
  }
}

TEST_CASE("meshes of every kind of file are the same") {
  const TemporaryFolder folder;
  const double corner[4][3] = {{0, 0, 0}, {1000, 0, 0}, {1000, 1000, 0}, {0, 1000, 0}};  // a floor in millimetres
  const int triangle[2][3] = {{0, 1, 2}, {0, 2, 3}};
  {
    std::ofstream stl(folder / "m.stl"), obj(folder / "m.obj"), ply(folder / "m.ply"), vtk(folder / "m.vtk");
    stl << "solid m\n";
    ply << "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
           "element face 2\nproperty list uchar int vertex_indices\nend_header\n";
    vtk << "# vtk DataFile Version 3.0\nm\nASCII\nDATASET POLYDATA\nPOINTS 4 double\n";
    for (const auto& c : corner) {
      obj << "v " << c[0] << ' ' << c[1] << ' ' << c[2] << '\n';
      ply << c[0] << ' ' << c[1] << ' ' << c[2] << '\n';
      vtk << c[0] << ' ' << c[1] << ' ' << c[2] << '\n';
    }
    vtk << "POLYGONS 2 8\n";
    for (const auto& t : triangle) {
      stl << "facet normal 0 0 1\nouter loop\n";
      for (const int k : t) stl << "vertex " << corner[k][0] << ' ' << corner[k][1] << ' ' << corner[k][2] << '\n';
      stl << "endloop\nendfacet\n";
      obj << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
      ply << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
      vtk << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
    }
    stl << "endsolid m\n";
  }
  const std::vector<Vec3> expected = thrown(plane_floor, true);
  for (const char* file : {"m.stl", "m.obj", "m.ply", "m.vtk"}) {
    INFO(file);
    const std::string path = (folder / file).string();
    const std::vector<Vec3> found =
        thrown("kind = \"mesh\"\npath = \"" + path + "\"\nscale = 0.001\noffset = [0, 0, 0.1]\n", true);
    CHECK((found[0] - expected[0]).norm() < 1e-9);
  }
  std::ofstream(folder / "bad.stl") << "this is no mesh\n";
  const auto built = [&](const std::string& keys) {
    const Scene scene = contact_scene(smooth, lossy, false, boundary(keys));
    return Boundaries(scene, scene.box()).size();
  };
  const auto mesh = [&](const char* file) { return "kind = \"mesh\"\npath = \"" + (folder / file).string() + "\"\n"; };
  CHECK_THROWS_WITH(built(mesh("bad.stl")), Contains("no triangles"));
  CHECK_THROWS_WITH(built(mesh("none.stl")), Contains("no such file"));
  CHECK_THROWS_WITH(built(mesh("m.stl") + "side = \"inside\"\n"),
                    Contains("boundary[0].side") && Contains("closed surface"));
}

TEST_CASE("boundaries that make no sense are refused with what would") {
  const auto refusal = [](const std::string& keys) {
    const Scene scene = contact_scene(smooth, lossy, false, boundary(keys));
    Boundaries(scene, scene.box());
  };
  const std::string cylinder = "kind = \"cylinder\"\npoint = [0, 0, 0]\n";
  CHECK_THROWS_WITH(refusal(cylinder + "radius = -0.1\n"), Contains("out of range"));
  CHECK_THROWS_WITH(refusal(cylinder + "radius = 0\n"), Contains("greater than 0"));
  CHECK_THROWS_WITH(refusal(cylinder + "radius = 1\nlength = -1\n"), Contains("length") && Contains("out of range"));
  CHECK_THROWS_WITH(refusal(cylinder + "radius = 1\nclosed = [\"top\"]\n"), Contains("no ends to close"));
  CHECK_THROWS_WITH(refusal(cylinder + "radius = 1\nnormal = [0, 0, 1]\n"), Contains("goes with kind = \"plane\""));
  CHECK_THROWS_WITH(refusal("kind = \"plane\"\nnormal = [0, 0, 1]\n"), Contains("needs point"));
  CHECK_THROWS_WITH(refusal("kind = \"box\"\nmin = [0, 0, 1]\nmax = [1, 1, 0]\n"), Contains("inside out"));
  CHECK_THROWS_WITH(
      refusal("kind = \"funnel\"\npoint = [0, 0, 0]\nradius = 0.1\noutlet_radius = 0.2\ncone_length = 1\n"),
      Contains("upside down"));
  CHECK_THROWS_WITH(refusal("kind = \"polygons\"\npolygons = [[[0,0,0],[1,0,0]]]\n"), Contains("stays open"));
  CHECK_THROWS_WITH(refusal("kind = \"polygons\"\npolygons = [[[0,0,0],[1,0,0],[1,1,0.5],[0,1,0]]]\n"),
                    Contains("not flat"));
  CHECK_THROWS_WITH(refusal("kind = \"polygons\"\nside = \"inside\"\npolygons = [[[0,0,0],[1,0,0],[1,1,0]]]\n"),
                    Contains("closed surface"));
  CHECK_THROWS_WITH(refusal("kind = \"surface\"\n"), Contains("either formula or grid"));
  CHECK_THROWS_WITH(refusal("kind = \"surface\"\nformula = \"0.1/x\"\n"), Contains("not a number at x = 0"));
  CHECK_THROWS_WITH(refusal("kind = \"surface\"\nformula = \"sqrt(x - 0.5)\"\n"), Contains("not a number"));
  CHECK_THROWS_WITH(refusal("kind = \"surface\"\nformula = \"sin(2*q)\"\n"), Contains("no formula in x, y"));
  CHECK_THROWS_WITH(refusal("kind = \"surface\"\nformula = \"x > 0.3 ? 0.1 : 0.2\"\n"),
                    Contains("tolerance") && Contains("smooth"));
  CHECK_THROWS_WITH(refusal(plane_floor + "[boundary.motion]\ndisplacement = [\"t\"]\n"), Contains("three are needed"));
  CHECK_THROWS_WITH(refusal(plane_floor + "[boundary.motion]\ndisplacement = [\"t\", \"0\", \"2*\"]\n"),
                    Contains("no formula in t"));
  CHECK_THROWS_WITH(refusal(plane_floor + "[boundary.motion]\nstart = 1\n"), Contains("says nothing of how it moves"));
  CHECK_THROWS_WITH(refusal(plane_floor + "from = 2\nuntil = 1\n"), Contains("must lie after from"));
}

TEST_CASE("a grid file is joined up, and one with a hole is refused") {
  const TemporaryFolder folder;
  const std::string path = (folder / "grid.csv").string();
  std::ofstream(path) << "x,y,z\n0,0,0.1\n1,0,0.1\n0,1,0.3\n1,1,0.3\n";
  const std::string keys = "kind = \"surface\"\ngrid = \"" + path + "\"\n";
  const auto built = [&] {
    const Scene scene = contact_scene(smooth, lossy, false, boundary(keys));
    return Boundaries(scene, scene.box());
  };
  const double slope = std::atan(0.2);
  const double distance = (0.5 - 0.2) * std::cos(slope);
  CHECK(built().leave_room(Vec3(0.4, 0.5, 0.5), 0.999999 * distance));
  CHECK_FALSE(built().leave_room(Vec3(0.4, 0.5, 0.5), 1.000001 * distance));
  CHECK_FALSE(built().leave_room(Vec3(0.4, 0.5, 0.1), 0.01));  // below it
  std::ofstream(path) << "x,y,z\n0,0,0.1\n1,0,0.1\n0,1,0.3\n";
  CHECK_THROWS_WITH(built(), Contains("do not fill a grid"));
  std::ofstream(path) << "x,y,z\n0,0,0.1\n1,0,nan\n0,1,0.3\n";
  CHECK_THROWS_WITH(built(), Contains("grid.csv:3") && Contains("not a finite number"));
}

TEST_CASE("what a contact keeps does not follow a sphere round a corner") {
  // It leaves one wall and touches the other in the same step, with a spring that lies almost across the other.
  const Scene scene =
      contact_scene(rough, grips, false, boundary("kind = \"box\"\nmin = [0, 0, 0]\nmax = [1, 1, 1]\n"));
  constexpr double overlap = 1e-5;
  HandMade run(scene, {{Vec3(ball_radius - overlap, ball_radius + overlap, 0.5), Vec3(0, 0.05, 5e-5), ball_radius}},
               1e-5, ContactVelocity::half_step);
  for (int n = 0; n < 5; ++n) run.step();
  run.hold(0, Vec3(ball_radius + overlap, ball_radius - overlap, 0.5));
  Recorder recorder;
  recorder.want_contacts = true;
  recorder.velocity.resize(1);
  recorder.angular_velocity.resize(1);
  recorder.force.resize(1);
  const StepSums sums = run.step(&recorder);
  REQUIRE(recorder.contacts.size() == 1);
  const Vec3 force = recorder.contacts.force[0];
  CHECK(force.y() == Approx(1e6 * overlap).epsilon(1e-6));
  CHECK(std::hypot(force.x(), force.z()) < 1e-12);
  CHECK(std::abs(sums.dissipated()) < 1e-12);
}

TEST_CASE("a wall is what a big heavy sphere comes to") {
  const std::string law = GENERATE("linear", "hertz");
  INFO(law);
  constexpr double small = 1e-3, big = 0.45, speed = 0.5, dt = 2e-7;
  const std::string material = "restitution = 0.6\nyoung_modulus = 1e8\npoisson_ratio = 0.3\n";
  const auto rebound = [&](bool wall) {
    const Scene scene =
        contact_scene("normal = \"" + law + "\"\n", material, false,
                      wall ? boundary("kind = \"plane\"\npoint = [0, 0, 0.95]\nnormal = [0, 0, 1]\n") : "");
    std::vector<Sphere> spheres = {{Vec3(0.5, 0.5, 0.95 + 1.01 * small), Vec3(0, 0, -speed), small}};
    if (!wall) spheres.push_back({Vec3(0.5, 0.5, 0.5), Vec3::Zero(), big});
    HandMade run(scene, spheres, dt);
    double lowest = 1;
    int steps = 0;
    for (; run.velocity(0).z() <= 0 || run.position(0).z() < 0.95 + small; ++steps) {
      REQUIRE(steps < 100000);
      run.step();
      lowest = std::min(lowest, run.position(0).z());
    }
    return Vec3(run.velocity(0).z(), lowest - 0.95, steps * dt);
  };
  const Vec3 plane = rebound(true), sphere = rebound(false);
  const double stiffer = law == "hertz" ? small / big : 1e-6;  // R_eff of the pair is less by their ratio
  CHECK(sphere[0] == Approx(plane[0]).epsilon(1e-3));
  CHECK(plane[0] == Approx(0.6 * speed).epsilon(0.03));
  CHECK(small - sphere[1] == Approx(small - plane[1]).epsilon(stiffer + 1e-4));
  CHECK(sphere[2] == Approx(plane[2]).epsilon(stiffer + 2e-3));
}
