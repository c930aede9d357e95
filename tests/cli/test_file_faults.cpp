// run, analyze, convert and info where disks are full, files damaged, rights missing: one line, an exit code, and what
// was there before unharmed. The picture verbs have test_picture_faults.cpp.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <vector>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "core/history.hpp"
#include "core/run_folder.hpp"
#include "faults.hpp"
#include "small_run.hpp"

using namespace packstone;
using Catch::Matchers::Contains;
using testing::check_one_line;
using testing::check_refusal;
using testing::contents;
using testing::packstone_command;
using testing::quoted;
using testing::shell;
using testing::SmallDisk;
using testing::SmallRun;
using testing::TemporaryFolder;
namespace fs = std::filesystem;

namespace {

/// A call that ends in the name of the file it writes.
struct Call {
  std::string words;
  std::string name;

  std::string in(const fs::path& folder) const { return words + quoted(folder / name); }
};

/// All that convert and analyze write into files.
std::vector<Call> file_calls(const std::string& run) {
  std::vector<Call> calls;
  for (const char* name : {"x.vtkhdf", "x.dump", "x.data", "x.csv", "x.xyz", "x.vtu", "x.vtp"}) {
    calls.push_back({"convert " + run + " --quiet --overwrite ", name});
  }
  const std::string analyze = "analyze " + run + " --quiet --only structure ";
  calls.push_back({analyze + "--json ", "x.json"});
  calls.push_back({analyze + "--particles ", "x.csv"});
  calls.push_back({analyze + "--particles ", "x.vtkhdf"});
  calls.push_back({analyze + "--map ", "x.vti"});
  calls.push_back({analyze + "--surface ", "x.vtp"});
  calls.push_back({"check " + (fs::path(run).parent_path() / "scene.toml").string() + " --minimal ", "x.toml"});
  return calls;
}

bool has_leftovers(const fs::path& folder) {
  const auto all = contents(folder);
  return std::any_of(all.begin(), all.end(), [](const auto& entry) {
    return fs::path(entry.first).filename().string().find(".partial") != std::string::npos;
  });
}

/// What a run that ended early owes: every snapshot whole and history of whole rows...
void check_snapshots(const fs::path& folder) {
  const RunReader run(folder);
  for (std::size_t k = 0; k < run.snapshot_count(); ++k) CHECK(run.snapshot(k).size() == 120);
  if (fs::exists(folder / "history.csv")) CHECK_NOTHROW(run.history());
}

/// ...and nothing half-written, where it still finds its folder.
void check_readable(const fs::path& folder) {
  CHECK_FALSE(has_leftovers(folder));
  check_snapshots(folder);
}

/// A user without rights, as whom a command runs: this one where it is not root.
const std::string as_nobody = geteuid() == 0 ? "setpriv --reuid 65534 --regid 65534 --clear-groups " : "";

bool nobody_can_run_it() { return shell(as_nobody + PACKSTONE_COMMAND + " --version").exit_code == 0; }

}  // namespace

TEST_CASE("convert and analyze write nothing where nothing can be written") {
  const SmallRun run;
  for (const Call& call : file_calls(run.path)) {
    const TemporaryFolder folder;
    std::ofstream(folder / call.name) << "before";
    check_refusal(call.in("/proc"), "No such file or directory", folder.path());
    check_refusal(call.in(folder / "missing"), "No such file or directory", folder.path());
    check_refusal(call.in(folder.path()), "File too large", folder.path(), "ulimit -c 0; ulimit -f 0;");
    fs::remove(folder / call.name);
    fs::create_directory(folder / call.name);
    check_refusal(call.in(folder.path()), "is a folder; name a file", folder.path());
  }
}

TEST_CASE("convert and analyze on a disk that is full or read only leave what was there") {
  SmallDisk disk;
  if (!disk.can_be_made()) {
    WARN("skipped: this user may not mount a file system in a namespace");
    return;
  }
  const SmallRun run;
  for (const Call& call : file_calls(run.path)) {
    fs::remove_all(disk.old());
    fs::create_directory(disk.old());
    std::ofstream(disk.old() / call.name) << "before";
    const auto check_unharmed = [&](const std::string& words, const std::string& prepare) {
      const auto result = disk.run(call.in(disk.disk()), "size=4k", prepare);
      INFO(call.words << call.name << "\n" << result.output);
      check_one_line(result);
      CHECK(result.exit_code == 1);
      CHECK_THAT(result.output, Contains(words));
      CHECK((contents(disk.left()) == contents(disk.old())));
    };
    check_unharmed("No space left on device", "true");
    check_unharmed("Read-only file system", "mount -o remount,ro " + quoted(disk.disk()));
  }
}

TEST_CASE("a run that meets the limit of the size of files fails, and its record says why") {
  const TemporaryFolder folder;
  std::ofstream(folder / "scene.toml") << testing::small_scene;
  const auto result = packstone_command(
      "run " + quoted(folder / "scene.toml") + " --quiet --threads 1 -o " + quoted(folder / "run"),
      "ulimit -c 0; ulimit -f 20;");  // of 512 bytes or 1 KiB: more than the texts, less than a snapshot
  INFO(result.output);
  check_one_line(result);
  CHECK(result.exit_code == 1);
  CHECK_THAT(result.output, Contains("File too large"));
  check_readable(folder / "run");
  CHECK(RunReader(folder / "run").record().status == RunStatus::failed);
  CHECK_THAT(RunReader(folder / "run").record().reason, Contains("File too large"));
}

TEST_CASE("a run that fills the disk keeps every snapshot that was complete") {
  SmallDisk disk;
  if (!disk.can_be_made()) {
    WARN("skipped: this user may not mount a file system in a namespace");
    return;
  }
  const TemporaryFolder folder;
  std::ofstream(folder / "scene.toml") << testing::small_scene;
  const auto result = disk.run(
      "run " + quoted(folder / "scene.toml") + " --quiet --threads 1 -o " + quoted(disk.disk() / "run"), "size=160k");
  INFO(result.output);
  check_one_line(result);
  CHECK(result.exit_code == 1);
  CHECK_THAT(result.output, Contains("No space left on device"));
  check_readable(disk.left() / "run");
  const RunReader run(disk.left() / "run");
  CHECK(run.snapshot_count() > 0);
  CHECK(run.snapshot_count() < 5);
  CHECK(run.record().status != RunStatus::finished);
}

TEST_CASE("a run whose folder is gone ends with one line") {
  const TemporaryFolder folder;
  std::ofstream(folder / "scene.toml") << testing::small_scene;
  const auto result = shell("(cd " + quoted(folder.path()) + "; " + PACKSTONE_COMMAND +
                            " run scene.toml --quiet --threads 1 -o run --set 'dynamics.duration=\"60 s\"' & job=$!; "
                            "while [ ! -e run/snapshots/snapshot_000001.vtkhdf ]; do sleep 0.01; done; "
                            "mv run moved; wait $job)");
  INFO(result.output);
  check_one_line(result);
  CHECK(result.exit_code == 1);
  CHECK_THAT(result.output, Contains("error: run/") && Contains("o such file"));
  check_snapshots(folder / "moved");
}

TEST_CASE("without the right to write nothing is begun, without the right to read nothing is said of the contents") {
  if (!nobody_can_run_it()) {
    WARN("skipped: a user without rights cannot start the command here");
    return;
  }
  const SmallRun run;
  fs::permissions(run.folder.path(), fs::perms(0555));
  const auto refused = [&](const std::string& call, const std::string& words) {
    const auto before = contents(run.folder.path());
    const auto result = shell(as_nobody + PACKSTONE_COMMAND + " " + call);
    INFO(call << "\n" << result.output);
    check_one_line(result);
    CHECK_THAT(result.output, Contains(words));
    CHECK((contents(run.folder.path()) == before));
  };
  const std::string scene = quoted(run.folder / "scene.toml");
  refused("run " + scene + " -o " + quoted(run.folder / "other"), "name a folder you may write to");
  refused("convert " + run.path + " " + quoted(run.folder / "x.csv"), "Permission denied");
  refused("analyze " + run.path + " --only packing --json " + quoted(run.folder / "x.json"), "Permission denied");
  fs::permissions(run.folder / "scene.toml", fs::perms(0));
  fs::permissions(run.path + "/snapshots/snapshot_000004.vtkhdf", fs::perms(0));
  const auto unreadable = [&](const std::string& call) {
    const auto result = shell(as_nobody + PACKSTONE_COMMAND + " " + call);
    INFO(call << "\n" << result.output);
    check_one_line(result);
    CHECK(result.exit_code == 2);
    CHECK_THAT(result.output, Contains("cannot be read"));
  };
  unreadable("check " + scene);
  unreadable("info " + run.path + "/snapshots/snapshot_000004.vtkhdf");
  unreadable("analyze " + run.path);
  fs::permissions(run.folder.path(), fs::perms(0755));
}

TEST_CASE("every verb tells a damaged snapshot by its name") {
  const SmallRun run;
  const fs::path last = fs::path(run.path) / "snapshots" / "snapshot_000004.vtkhdf";
  const std::string whole = read_text_file(last);
  std::string flipped = whole;
  flipped[whole.size() / 2] = static_cast<char>(flipped[whole.size() / 2] ^ 4);
  for (const std::string& bytes : {whole.substr(0, whole.size() / 2), flipped, std::string()}) {
    std::ofstream(last, std::ios::binary) << bytes;
    for (const std::string& call : {"analyze " + run.path, "info " + last.string(),
                                    "convert " + run.path + " " + (run.folder / "x.csv").string()}) {
      check_refusal(call, "snapshot_000004.vtkhdf", run.folder.path());
    }
  }
}

TEST_CASE("a full standard output is an error") {
  const SmallRun run;
  for (const std::string& call :
       {"info " + run.path, "analyze " + run.path + " --only packing --json -", std::string("run --help")}) {
    const auto result = shell("(exec 2>&1 >/dev/full; " PACKSTONE_COMMAND " " + call + ")");
    INFO(call << "\n" << result.output);
    CHECK(result.exit_code == 1);
    check_one_line(result);
    CHECK_THAT(result.output, Contains("standard output: cannot") && Contains("No space left on device"));
  }
}

TEST_CASE("any name is a good name") {
  for (const std::string name : {"with space", "\xc3\xa4\xc3\xb6\xc3\xbc \xc3\x9f", "\xe7\xb2\x89\xe4\xbd\x93", "it\"s",
                                 "a;b&c", "100%", "-dash", "{brace}"}) {
    const TemporaryFolder outer;
    const fs::path folder = outer / name;
    fs::create_directory(folder);
    std::ofstream(folder / (name + ".toml")) << testing::small_scene;
    const std::string run = quoted(folder / name);
    const auto succeeds = [&](const std::string& call) {
      const auto result = packstone_command(call);
      INFO(call << "\n" << result.output);
      CHECK(result.exit_code == 0);
    };
    succeeds("check " + quoted(folder / (name + ".toml")));
    succeeds("run " + quoted(folder / (name + ".toml")) + " --quiet --threads 1 -o " + run);
    succeeds("info " + run);
    succeeds("analyze " + run + " --only packing --quiet --json " + quoted(folder / (name + ".json")));
    for (const char* extension : {".csv", ".dump", ".vtkhdf", ".xyz", ".vtu"}) {
      succeeds("convert " + run + " --at last --quiet " + quoted(folder / (name + extension)));
    }
    succeeds("info " + quoted(folder / (name + ".dump")));
#ifdef PACKSTONE_HAS_VTK
    const std::string small = " --size 160x120 --supersampling 1 --quiet -o ";
    succeeds("render " + run + small + quoted(folder / (name + ".png")));
    succeeds("render " + run + small + quoted(folder / (name + ".mp4")));
    succeeds("slice " + run + " --plane z=20mm" + small + quoted(folder / (name + ".svg")));
    succeeds("plot " + run + " --what energy -o " + quoted(folder / (name + ".pdf")));
    succeeds("report " + run + " -o " + quoted(folder / (name + ".html")));
#endif
  }
}

TEST_CASE("no particle, one and two are run, measured and converted, or refused with one line") {
  const TemporaryFolder folder;
  for (const int count : {0, 1, 2}) {
    std::string scene = testing::small_scene;
    for (std::size_t at; (at = scene.find("count = 60")) != std::string::npos;) {
      scene.replace(
          at, 10,
          "count = " +
              std::to_string(count / 2 + (scene.find("count = 60", at + 1) == std::string::npos ? count % 2 : 0)));
    }
    std::ofstream(folder / "scene.toml") << scene;
    const std::string run = quoted(folder / ("run" + std::to_string(count)));
    const auto made = packstone_command("run " + quoted(folder / "scene.toml") + " --quiet --threads 1 -o " + run);
    INFO(count << " particles\n" << made.output);
    if (made.exit_code != 0) check_one_line(made);
    std::ofstream table(folder / "bed.csv");
    table << "x,y,z,radius,density\n";
    for (int k = 0; k < count; ++k) table << 0.1 + 0.039 * k << ",0.1,0.02,0.02,2500\n";
    table.close();
    for (const std::string& call :
         {std::string("analyze ") + quoted(folder / "bed.csv"), "info " + quoted(folder / "bed.csv"),
          "convert --overwrite " + quoted(folder / "bed.csv") + " " + quoted(folder / "x.vtkhdf"),
          "convert --overwrite " + quoted(folder / "bed.csv") + " " + quoted(folder / "x.dump"),
          "convert --overwrite " + quoted(folder / "bed.csv") + " " + quoted(folder / "x.data"),
          "convert --overwrite " + quoted(folder / "bed.csv") + " " + quoted(folder / "x.xyz"),
          "analyze " + quoted(folder / "x.vtkhdf"), "analyze " + quoted(folder / "x.dump")}) {
      const auto result = packstone_command(call);
      INFO(count << " particles: " << call << "\n" << result.output);
      if (result.exit_code != 0) check_one_line(result);
      CHECK_THAT(result.output, !Contains("nan") && !Contains("inf "));
    }
    if (made.exit_code == 0) CHECK(packstone_command("analyze " + run).exit_code == 0);
  }
}
