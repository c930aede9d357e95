#include <cmath>

#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/geometry.hpp"
#include "core/scene.hpp"
#include "tests/sample_scene.hpp"
#include "tests/temporary_folder.hpp"

using namespace packstone;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;
using testing::file_scene;
using testing::small_scene;
using testing::small_scene_with;

namespace {

/// The message that a change of the small scene brings.
std::string error_after(const std::string& from, const std::string& to, const std::vector<std::string>& set = {}) {
  try {
    parse_scene(from.empty() ? small_scene : small_scene_with(from, to), "s.toml", set);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace

TEST_CASE("a scene is read in SI with its defaults") {
  const Scene s = parse_scene(small_scene, "s.toml");
  CHECK(s.title == "Small");
  CHECK(s.dynamics.time_step == Approx(20e-6));
  CHECK(s.particles.at(1).radius.value() == Approx(0.02));
  CHECK(s.particles.at(1).name == "heavy");
  CHECK(s.boundaries.at(0).material == "light");
  CHECK(s.contact.tangential == TangentialModel::none);
  CHECK(s.gravity.present);
  CHECK(s.domain.open == std::vector<int>{Face::z_max});
  CHECK(s.output.history_interval == Approx(1e-3));
  CHECK(s.box().periodic == std::array<bool, 3>{true, true, false});
}

TEST_CASE("a box can follow from the particles' volume") {
  const Scene s = parse_scene(
      small_scene_with("min = [0, 0, 0]\nmax = [0.2, 0.2, 0.4]", "volume_factor = 2\naspect = [1, 1, 2]"), "s.toml");
  const Vec3 size = s.box().size();
  CHECK(size.prod() == Approx(2 * 120 * sphere_volume(0.02)));
  CHECK(size[0] == Approx(size[1]));
  CHECK(size[2] == Approx(2 * size[0]));
}

TEST_CASE("the filled-in scene reads back as the same scene") {
  const Scene s = parse_scene(small_scene, "s.toml");
  const std::string text = to_toml(s);
  const Scene again = parse_scene(text, "again.toml");
  CHECK(to_toml(again) == text);
  // Of a run that goes on, the scene's every bit.
  const Scene zero = parse_scene(to_toml(parse_scene(small_scene, "t.toml", {"domain.min=[-0.0, 0, 0]"})), "t.toml");
  CHECK(std::signbit((*zero.domain.min)[0]));
  CHECK(scene_hash(again) == scene_hash(s));
  CHECK(scene_hash(parse_scene(small_scene, "s.toml", {"seed=4"})) != scene_hash(s));
}

TEST_CASE("titles with quotes, backslashes and control characters survive") {
  const std::string title = "a \"b\" \\ \xc3\xa9 \t end";
  Scene s = parse_scene(small_scene, "s.toml");
  s.title = title;
  CHECK(parse_scene(to_toml(s), "t.toml").title == title);
}

TEST_CASE("a key can be overridden from the command line") {
  const Scene s =
      parse_scene(small_scene, "s.toml",
                  {"dynamics.time_step=30 us", "particles[0].count=7", "title=\"Other\"", "monitor.overlap_limit=0.1"});
  CHECK(s.dynamics.time_step == Approx(30e-6));
  CHECK(s.particles[0].count == 7);
  CHECK(s.title == "Other");
  CHECK(s.monitor.overlap_limit == 0.1);
  CHECK_THAT(error_after("", "", {"dynamics.timestep=1"}),
             StartsWith("--set dynamics.timestep=1: dynamics.timestep: unknown key") && Contains("time_step"));
  CHECK_THAT(error_after("", "", {"dynamics.time_step=-1"}), StartsWith("--set dynamics.time_step=-1: "));
  CHECK_THAT(error_after("", "", {"particles[5].count=1"}), Contains("no entry [5]"));
  CHECK_THAT(error_after("", "", {"nonsense"}), Contains("KEY=VALUE"));
}

TEST_CASE("a wrong key is one line: file, line, column, key, what is right") {
  CHECK_THAT(error_after("duration = \"80 ms\"", "durtion = \"80 ms\""),
             StartsWith("s.toml:5:1: dynamics.durtion: unknown key; did you mean \"duration\"?"));
  CHECK_THAT(error_after("duration = \"80 ms\"\n", ""), StartsWith("s.toml:3:2: dynamics: needs duration"));
  CHECK_THAT(error_after("start = \"40 ms\"", "strat = \"40 ms\""),
             StartsWith("s.toml:13:1: gravity.strat: unknown key; did you mean \"start\"?"));
  CHECK_THAT(error_after("radius = \"20 mm\"", "radius = -0.02"),
             StartsWith("s.toml:29:1: particles[0].radius: -0.02 m is out of range; it must be greater than 0"));
  CHECK_THAT(error_after("material = \"light\"", "material = \"ligth\""),
             StartsWith("s.toml:27:1: particles[0].material: no material \"ligth\"; did you mean \"light\"?"));
  CHECK_THAT(error_after("normal = \"hysteretic\"", "normal = \"hysteric\""),
             StartsWith("s.toml:15:1: contact.normal: \"hysteric\" is unknown; did you mean \"hysteretic\"?"));
  CHECK_THAT(error_after("duration = \"80 ms\"", "duration = \"20 mm\""), Contains("wrong dimension"));
  CHECK_THAT(error_after("density = 1200", "density = true"), Contains("expected a number in kg/m3"));
  CHECK_THAT(error_after("count = 60", "count = 1.5"), Contains("whole number"));
  CHECK_THAT(error_after("count = 60", "count = 0"), Contains("from 1 to"));
  CHECK_THAT(error_after("max = [0.2, 0.2, 0.4]", "max = [0.2, 0.2]"), Contains("three numbers"));
  CHECK_THAT(error_after("seed = 3", "seed = 3\nseed = 4"), StartsWith("s.toml:3:") && Contains("not valid TOML"));
  CHECK_THAT(error_after("[output]", "[outptu]"), Contains("outptu: unknown key; did you mean \"output\"?"));
  CHECK_THAT(error_after("[[boundary]]", "[boundary]"), Contains("expected tables, [[boundary]]"));
}

TEST_CASE("keys are checked against each other") {
  CHECK_THAT(error_after("max = [0.2, 0.2, 0.4]\n", ""), Contains("either min and max, or volume_factor"));
  CHECK_THAT(error_after("max = [0.2, 0.2, 0.4]", "max = [0.2, -0.2, 0.4]"), Contains("must lie above"));
  CHECK_THAT(error_after("open = [\"z+\"]", "open = [\"x+\"]"), Contains("periodic side"));
  CHECK_THAT(error_after("normal_damping = 0.7", "normal_damping = 1"), Contains("would pull on unloading"));
  CHECK_THAT(error_after("normal_damping = 0.7", "restitution = 0.5\nnormal_damping = 0.7"), Contains("keep one"));
  CHECK_THAT(error_after("normal_damping = 0.7\n", ""), Contains("needs normal_damping or restitution"));
  CHECK_THAT(error_after("normal = [0, 0, 1]", "normal = [0, 0, 0]"), Contains("has no length"));
  CHECK_THAT(error_after("name = \"heavy\"", "name = \"light\""), Contains("its own name"));
  CHECK_THAT(error_after("normal = \"hysteretic\"", "normal = \"hysteretic\"\ntangential = \"cundall-strack\""),
             Contains("needs tangential_stiffness"));
  const Scene s = parse_scene(small_scene, "s.toml");
  std::string text = to_toml(s);
  for (auto [from, to] : {std::pair{"normal = \"hysteretic\"", "normal = \"linear\""},
                          {"zero-overlap", "zero-force"},
                          {"normal_damping = 0.7", "restitution = 0.1"}}) {
    text.replace(text.find(from), std::string(from).size(), to);
  }
  CHECK_THROWS_WITH(parse_scene(text, "s.toml"), Contains("cannot be reached with contact.release"));
}

TEST_CASE("damping of two kinds and a wall that leans to a periodic side are refused") {
  CHECK_THAT(error_after("normal = [0, 0, 1]", "normal = [0.1, 0, 1]"),
             Contains("component along x, which is periodic"));
  std::string text = small_scene_with("normal = \"hysteretic\"", "normal = \"linear\"");
  text.replace(text.find("normal_damping = 0.7"), 20, "restitution = 0.5   ");
  CHECK_THROWS_WITH(parse_scene(text, "s.toml"), Contains("material[1]") && Contains("or all give restitution"));
}

TEST_CASE("growth needs count, radius and duration, and no path") {
  CHECK_THAT(error_after("count = 60\n", ""), StartsWith("s.toml:26:1: particles[0]: needs count"));
  CHECK_THAT(error_after("radius = \"20 mm\"\n", ""), StartsWith("s.toml:26:1: particles[0]: needs radius"));
  CHECK_THAT(error_after("kind = \"growth\"\nduration = \"40 ms\"", "kind = \"growth\""),
             StartsWith("s.toml:34:2: filling: needs duration"));
  CHECK_THAT(error_after("kind = \"growth\"", "kind = \"growth\"\npath = \"a.csv\""),
             StartsWith("s.toml:36:1: filling.path: is given beside filling.kind = \"growth\""));
}

TEST_CASE("a file brings places and radii: what else would decide them is refused") {
  const auto error = [](const std::vector<std::string>& set) -> std::string {
    try {
      parse_scene(file_scene("start.csv"), "s.toml", set);
    } catch (const InputError& refusal) {
      return refusal.what();
    }
    return "no error";
  };
  CHECK(error({}) == "no error");
  CHECK_THAT(error({"particles[1].count=5"}), Contains("particles[1].count: is given beside filling.kind = \"file\""));
  CHECK_THAT(error({"particles[0].radius=0.02"}), Contains("the file says how many particles there are"));
  CHECK_THAT(error({"filling.duration=1"}), Contains("filling.duration: is given") && Contains("leave it out"));
  CHECK_THAT(error({"filling.region_min=[0, 0, 0]"}), Contains("filling.region_min: is given"));
  CHECK_THAT(error({"filling.region_max=[0.1, 0.1, 0.1]"}), Contains("filling.region_max: is given"));
  CHECK_THAT(error({"domain.volume_factor=2", "domain.aspect=[1, 1, 2]"}), Contains("give min and max"));
  CHECK_THAT(error({"filling.path=\"\""}), Contains("filling.path: expected a text"));
  std::string text = file_scene("start.csv");
  text.erase(text.find("path = \"start.csv\""), 18);
  CHECK_THROWS_WITH(parse_scene(text, "s.toml"), Contains("filling: needs path"));
}

TEST_CASE("a relative path is seen from the scene's folder, in an override from the current one") {
  const testing::TemporaryFolder folder;
  write_text_file(folder / "scene.toml", file_scene("../beds/start.csv"));
  const auto expected = (folder.path().parent_path() / "beds/start.csv").string();
  const Scene s = read_scene(folder / "scene.toml");
  CHECK(s.filling.path == expected);
  CHECK(s.filling.over() == 0);
  CHECK(parse_scene(to_toml(s), "elsewhere.toml").filling.path == expected);
  CHECK(scene_hash(parse_scene(to_toml(s), "elsewhere.toml")) == scene_hash(s));
  const std::string here = (std::filesystem::current_path() / "a.csv").string();
  CHECK(read_scene(folder / "scene.toml", {"filling.path=a.csv"}).filling.path == here);
  CHECK(parse_scene(file_scene("a.csv"), "s.toml").filling.path == here);
}

TEST_CASE("docs/scene.md is what the program says of its keys") {
  CHECK(read_text_file(std::string(PACKSTONE_SOURCE_DIR) + "/docs/scene.md") == scene_reference_markdown());
}

TEST_CASE("a scene that does not exist is named") {
  CHECK_THROWS_WITH(read_scene("/no/such/scene.toml"), Contains("/no/such/scene.toml: no such file"));
}
