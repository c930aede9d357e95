// render under mpirun: the files of one process, and one line from all ranks together.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

#include <catch2/catch.hpp>

#include "command.hpp"
#include "core/files.hpp"
#include "small_run.hpp"

using namespace packstone;
using Catch::Matchers::Contains;
using testing::SmallRun;

namespace {

/// Whatever the number of processors, and as whatever user.
const std::string launch =
    "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 "
    "OMPI_MCA_rmaps_base_oversubscribe=1 timeout 60 " PACKSTONE_MPIRUN " -n 3 ";

testing::Result by_three(const std::string& program) { return testing::shell(launch + program); }

/// What packstone says, without mpirun's own words.
std::vector<std::string> lines_of_packstone(const std::string& output) {
  std::vector<std::string> lines;
  std::istringstream text(output);
  for (std::string line; std::getline(text, line);) {
    if (line.rfind("packstone: ", 0) == 0) lines.push_back(line);
  }
  return lines;
}

std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> names;
  for (const auto& file : std::filesystem::directory_iterator(folder)) names.push_back(file.path().filename());
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

TEST_CASE("ranks change no byte of a picture, a film or frames, and the first alone speaks") {
  const SmallRun run;
  const std::string look = " --size 322x242 --color speed --title \"Three ranks\" --occlusion 0.5 -o ";
  const auto make = [&](const std::string& name, const std::string& options, bool ranks) {
    const std::string call =
        std::string(PACKSTONE_COMMAND) + " render " + run.path + look + (run.folder / name).string();
    const auto result = ranks ? by_three(call + options) : testing::shell(call + options + " --workers 1");
    INFO(call << "\n" << result.output);
    REQUIRE(result.exit_code == 0);
    return result.output;
  };
  for (const std::string tiles : {" --tiles 4x3 --quiet", " --tiles 1x1 --quiet"}) {
    CHECK(make("ranks.png", tiles, true).empty());
    make("one.png", " --quiet", false);
    CHECK((read_text_file(run.folder / "ranks.png") == read_text_file(run.folder / "one.png")));
  }
  make("one.mp4", " --quiet", false);
  make("ranks.mp4", " --quiet", true);
  CHECK((read_text_file(run.folder / "ranks.mp4") == read_text_file(run.folder / "one.mp4")));
  make("one", " --quiet", false);
  const std::string told = make("ranks", "", true);
  CHECK_THAT(told, Contains("frames 5/5"));
  CHECK(told.find("5/5") == told.rfind("5/5"));
  const auto names = files_in(run.folder / "one");
  CHECK(names.size() == 5);
  CHECK(files_in(run.folder / "ranks") == names);
  for (const auto& name : names) {
    CHECK((read_text_file(run.folder / "ranks" / name) == read_text_file(run.folder / "one" / name)));
  }
}

TEST_CASE("ranks make the same vectors, and the same frames beside a film") {
  const SmallRun run;
  const std::string command = std::string(PACKSTONE_COMMAND) + " slice " + run.path +
                              " --size 320x240 --quiet --sweep z=10mm:0.2:5 --color speed -o ";
  const auto both = [&](const std::string& one, const std::string& ranks) {
    for (const auto& result : {testing::shell(command + one + " --workers 1"), by_three(command + ranks)}) {
      INFO(command + one << "\n" << result.output);
      REQUIRE(result.exit_code == 0);
    }
  };
  const auto path = [&](const char* name) { return (run.folder / name).string(); };
  both(path("one") + " --frame-format svg", path("ranks") + " --frame-format svg");
  both(path("one.gif") + " --frame-format pdf --keep-frames " + path("one"),
       path("ranks.gif") + " --frame-format pdf --keep-frames " + path("ranks"));
  both(path("one.mp4") + " --keep-frames " + path("one"), path("ranks.mp4") + " --keep-frames " + path("ranks"));
  const auto names = files_in(run.folder / "one");
  CHECK(names.size() == 15);
  CHECK(files_in(run.folder / "ranks") == names);
  for (const auto& name : names) {
    CHECK((read_text_file(run.folder / "ranks" / name) == read_text_file(run.folder / "one" / name)));
  }
  CHECK((read_text_file(path("one.gif")) == read_text_file(path("ranks.gif"))));
}

TEST_CASE("an error of any rank ends all of them with one line") {
  const SmallRun run;
  const std::string picture = (run.folder / "x.png").string();
  const auto refused = [&](const std::string& program, int exit_code, const std::string& words) {
    const auto result = by_three(program);
    INFO(program << "\n" << result.output);
    CHECK(result.exit_code == exit_code);
    const auto lines = lines_of_packstone(result.output);
    REQUIRE(lines.size() == 1);
    CHECK_THAT(lines.front(), Contains(words));
    CHECK_FALSE(std::filesystem::exists(picture));
  };
  const std::string command = PACKSTONE_COMMAND;
  const std::string call = command + " render " + run.path + " --size 200x100 -o ";
  refused(call + picture + " --wrong", 2, "not expected: --wrong");
  refused(call + picture + " --tiles 4", 2, "--tiles 4: expected");
  refused(call + picture + " --tiles 4x2 --color sped", 2, "did you mean 'speed'");
  refused(call + "/proc/x.png --tiles 4x2", 1, "/proc/x.png: cannot be written");
  // The last rank alone sees no run, or another instant of it.
  const auto script = run.folder / "different.sh";
  const auto last_rank = [&](const std::string& other) {
    std::ofstream(script) << "[ $OMPI_COMM_WORLD_RANK = 2 ] && exec " + other + "\nexec " + call + picture;
    return "sh " + script.string();
  };
  refused(last_rank(command + " render /no/such/run -o " + picture), 2, "/no/such/run: no such file");
  refused(last_rank(call + picture + " --at 0"), 1, "does not see the same run");
}

TEST_CASE("a rank that is killed ends the film, and nothing of it stays") {
  const SmallRun run;
  const auto script = run.folder / "killed.sh";
  // The last rank dies while it reads, draws or waits.
  const std::string call = std::string(PACKSTONE_COMMAND) + " render " + run.path +
                           " --quiet --size 1600x1200 --supersampling 4 -o " + (run.folder / "film.mp4").string();
  std::ofstream(script) << "[ $OMPI_COMM_WORLD_RANK = 2 ] && exec timeout -s KILL 0.9 " + call + "\nexec " + call;
  const auto before = files_in(run.folder.path());
  const auto result = by_three("sh " + script.string());
  INFO(result.output);
  CHECK(result.exit_code != 0);
  CHECK(files_in(run.folder.path()) == before);
}
