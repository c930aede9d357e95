// The picture verbs where nothing can be written or what is asked for is not there: one line, an exit code, nothing
// half-written, and what was there before unharmed.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <vector>

#include <catch2/catch.hpp>

#include "faults.hpp"
#include "small_run.hpp"

using namespace packstone;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;
using testing::check_one_line;
using testing::check_refusal;
using testing::contents;
using testing::packstone_command;
using testing::SmallDisk;
using testing::SmallRun;
using testing::TemporaryFolder;
namespace fs = std::filesystem;

namespace {

/// What a verb is asked for, and the name of the file or folder it comes to.
struct Output {
  std::string call;
  std::string name;

  bool is_folder() const { return !fs::path(name).has_extension(); }
  std::string in(const fs::path& folder) const { return call + " -o " + (folder / name).string(); }
  /// One of the files that come.
  fs::path file_in(const fs::path& folder) const {
    if (!is_folder()) return folder / name;
    const bool vectors = call.find("--frame-format svg") != std::string::npos;
    return folder / name / (name == "plots" ? "energy.png" : vectors ? "frame_000001.svg" : "frame_000001.png");
  }
};

const std::string small = " --size 320x240 --supersampling 1 --quiet";

std::vector<Output> films(const std::string& run) {
  const std::string render = "render " + run + small, sweep = "slice " + run + small + " --sweep z=10mm:0.2:6";
  return {{render, "x.mp4"},
          {render, "x.gif"},
          {render + " --workers 1", "frames"},
          {render + " --workers 2", "frames"},
          {sweep, "x.mp4"},
          {sweep, "frames"},
          {sweep + " --frame-format svg", "frames"},
          {"slice " + run + small + " --plane z=20mm --frames :", "x.gif"}};
}

std::vector<Output> all_outputs(const std::string& run) {
  std::vector<Output> outputs = films(run);
  outputs.push_back({"render " + run + small, "x.png"});
  for (const char* name : {"x.png", "x.svg", "x.pdf"}) {
    outputs.push_back({"slice " + run + " --plane z=20mm", name});
    outputs.push_back({"plot " + run + " --what energy", name});
  }
  outputs.push_back({"plot " + run + " --what energy,profile", "plots"});
  outputs.push_back({"report " + run, "x.html"});
  return outputs;
}

/// Something of an earlier call in the output's place.
void put_before(const Output& output, const fs::path& folder) {
  const fs::path file = output.file_in(folder);
  fs::create_directories(file.parent_path());
  std::ofstream(file) << "before";
}

/// A dump of one instant of a box with so many particles.
void write_dump(const fs::path& path, int particles) {
  std::ofstream dump(path);
  dump << "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n"
       << particles << "\nITEM: BOX BOUNDS pp pp ff\n0 0.1\n0 0.1\n0 0.1\nITEM: ATOMS id type x y z radius\n";
  for (int k = 1; k <= particles; ++k) dump << k << " 1 0.05 0.05 0.02 0.01\n";
}

}  // namespace

TEST_CASE("no output is written where none can be") {
  const SmallRun run;
  for (const Output& output : all_outputs(run.path)) {
    const TemporaryFolder folder;
    std::ofstream(folder / "file") << "a file";
    check_refusal(output.in(folder / "file"), "Not a directory", folder.path());
    check_refusal(output.in("/proc"), "No such file or directory", folder.path());
    if (output.is_folder()) {
      check_refusal(output.call + " -o " + (folder / "file").string(), "is a file; name a folder", folder.path());
    } else {
      check_refusal(output.in(folder / "missing"), "No such file or directory", folder.path());
      fs::create_directory(folder / output.name);
      check_refusal(output.in(folder.path()), "is a folder; name a file", folder.path());
    }
  }
}

TEST_CASE("a limit of the size of files is an error, and what was there stays") {
  const SmallRun run;
  for (const Output& output : all_outputs(run.path)) {
    const TemporaryFolder folder, temporary;
    put_before(output, folder.path());
    check_refusal(output.in(folder.path()), "File too large", folder.path(),
                  "ulimit -c 0; ulimit -f 0; TMPDIR=" + temporary.path().string());
    CHECK(fs::is_empty(temporary.path()));
  }
}

TEST_CASE("a full disk and one that is read only are errors, and what was there stays") {
  SmallDisk small_disk;
  if (!small_disk.can_be_made()) {
    WARN("skipped: this user may not mount a file system in a namespace");
    return;
  }
  const SmallRun run;
  for (const Output& output : all_outputs(run.path)) {
    fs::remove_all(small_disk.old());
    put_before(output, small_disk.old());
    const auto check_unharmed = [&](const std::string& words, const std::string& prepare) {
      const auto result = small_disk.run(output.in(small_disk.disk()), "size=4k", prepare);
      INFO(output.call << " " << output.name << "\n" << result.output);
      check_one_line(result);
      CHECK(result.exit_code == 1);
      CHECK_THAT(result.output, Contains(words) && Contains(small_disk.disk().string()));
      CHECK((contents(small_disk.left()) == contents(small_disk.old())));
    };
    check_unharmed("No space left on device", "true");
    check_unharmed("Read-only file system", "mount -o remount,ro " + testing::quoted(small_disk.disk()));
  }
}

TEST_CASE("on a disk that fills up frames are whole or absent") {
  SmallDisk small_disk;
  if (!small_disk.can_be_made()) {
    WARN("skipped: this user may not mount a file system in a namespace");
    return;
  }
  const SmallRun run;
  const TemporaryFolder whole;
  for (const Output& output : films(run.path)) {
    if (!output.is_folder()) continue;
    REQUIRE(packstone_command(output.in(whole.path())).exit_code == 0);
    const auto frames = contents(whole / output.name);
    const auto result = small_disk.run(output.in(small_disk.disk()), "size=24k");
    INFO(output.call << "\n" << result.output);
    check_one_line(result);
    CHECK_THAT(result.output, Contains("No space left on device"));
    if (!fs::exists(small_disk.left() / output.name)) continue;  // by chance none got through
    const auto left = contents(small_disk.left() / output.name);
    CHECK(left.size() < frames.size());
    for (const auto& [name, bytes] : left) CHECK((frames.count(name) == 1 && frames.at(name) == bytes));
    fs::remove_all(whole / output.name);
  }
}

TEST_CASE("what an ended worker left of a frame goes with the others") {
  const SmallRun run;
  const TemporaryFolder folder;
  fs::create_directory(folder / "frames");
  std::ofstream(folder / "frames/.frame_000003.partial.png") << "half";
  const auto result = testing::shell("ulimit -f 1; " PACKSTONE_COMMAND " render " + run.path + small + " -o " +
                                     (folder / "frames").string());
  INFO(result.output);
  check_one_line(result);
  CHECK(fs::is_empty(folder / "frames"));
}

TEST_CASE("what is not in the run is refused, whatever the output") {
  const SmallRun run;
  const TemporaryFolder folder;
  const auto refused = [&](const Output& output, const std::string& option, const std::string& words) {
    check_refusal(output.in(folder.path()) + " " + option, words, folder.path());
  };
  std::vector<Output> pictures = films(run.path);
  pictures.push_back({"render " + run.path + small, "x.png"});
  pictures.push_back({"slice " + run.path + " --plane z=20mm", "x.svg"});
  for (const Output& output : pictures) {
    refused(output, "--color sped", "did you mean 'speed'");
    refused(output, "--color speed --range 5:5", "5 to 5 is not ascending");
    refused(output, "--color speed --range 5:1", "5 to 1 is not ascending");
    refused(output, "--color speed --range nan:1", "\"nan\" is not a number");
    refused(output, "--color speed --range 1", "expected LOW:HIGH");
    if (output.call.starts_with("render")) refused(output, "--arrows spin", "no vectors 'spin'");
  }
  const Output picture{"render " + run.path + small, "x.png"}, slice{"slice " + run.path + " --plane z=20mm", "x.pdf"},
      sweep{"slice " + run.path + small + " --sweep z=10mm:0.2:6", "frames"};
  for (const Output& output : {picture, slice, sweep}) {
    refused(output, "--at 999", "snapshot 999 does not exist");
    refused(output, "--at t=9", "no snapshot near t=9");
    refused(output, "--at t=-1", "has t=0 to 0.08 s");
    refused(output, "--at t=nan", "\"nan\" is not a number");
  }
  for (const char* name : {"x.mp4", "x.gif", "frames"}) {
    for (const std::string& call : {"render " + run.path, "slice " + run.path + " --plane z=20mm"}) {
      refused({call + small, name}, "--frames 3:1", "the last frame comes before the first");
      refused({call + small, name}, "--frames 5:2", "snapshot 5 does not exist");
      refused({call + small, name}, "--frames 900:", "snapshot 900 does not exist");
      refused({call + small, name}, "--frames 0:4:0", "expected FIRST:LAST");
    }
  }
  refused({"plot " + run.path + " --what energy,enrgy", "plots"}, "", "did you mean \"energy\"");
}

TEST_CASE("a run without snapshots is refused, whatever the output") {
  const SmallRun run;
  for (const auto& file : fs::directory_iterator(run.path + "/snapshots")) fs::remove(file);
  for (Output output : all_outputs(run.path)) {
    if (output.name != "plots" && output.call.starts_with("plot")) output.call = "plot " + run.path + " --what profile";
    check_refusal(output.in(run.folder.path()), "holds no snapshot yet", run.folder.path());
  }
}

TEST_CASE("no particle, one particle and none left by a cut make pictures") {
  const SmallRun run;
  const TemporaryFolder folder;
  const auto drawn = [&](const std::string& call, const char* name) {
    const auto result = packstone_command(call + " -o " + (folder / name).string());
    INFO(call << "\n" << result.output);
    CHECK(result.exit_code == 0);
    CHECK(result.output.empty());
    CHECK(fs::exists(folder / name));
    fs::remove_all(folder / name);
  };
  for (const int particles : {0, 1}) {
    const std::string path = (folder / "bed.dump").string();
    write_dump(path, particles);
    for (const char* name : {"x.png", "x.mp4", "frames"}) {
      for (const std::string colour :
           {"", " --color radius", " --color radius --occlusion 1 --trajectories random:3"}) {
        drawn("render " + path + small + colour, name);
      }
    }
    for (const char* colour : {"", " --color radius"}) {
      for (const char* name : {"x.png", "x.svg", "x.pdf"}) drawn("slice " + path + " --plane z=20mm" + colour, name);
      for (const char* name : {"x.gif", "frames"})
        drawn("slice " + path + small + " --sweep z=0:0.09:3" + colour, name);
    }
    drawn("report " + path, "x.html");
  }
  for (const char* options : {"", " --color speed", " --color speed --range 0:1 --contacts"}) {
    drawn("render " + run.path + small + " --cut \"x>-1\"" + options, "x.png");
    drawn("render " + run.path + small + " --cut \"x>-1\"" + options, "frames");
  }
}
