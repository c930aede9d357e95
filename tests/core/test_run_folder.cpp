#include <fstream>

#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/run_folder.hpp"
#include "tests/temporary_folder.hpp"

using namespace packstone;
using Catch::Matchers::Contains;

namespace {

Snapshot empty_snapshot(double time) {
  Snapshot s;
  s.time = time;
  return s;
}

void write_run(const std::filesystem::path& path) {
  RunWriter writer(path, false);
  writer.write_scene("title = \"x\"\n");
  for (double time : {0.0, 0.1, 0.2, 0.3}) {
    writer.write_snapshot(empty_snapshot(time));
    writer.append_history({"time", "energy"}, {time, 2 * time});
  }
  RunRecord record;
  record.title = "x";
  record.status = RunStatus::failed;
  record.reason = "because";
  record.seed = 42;
  record.filling_hash = "00ff";
  record.warnings = {"careful"};
  writer.write_record(record);
}

}  // namespace

TEST_CASE("a run folder comes back as it was written") {
  const testing::TemporaryFolder folder;
  write_run(folder / "run");
  const RunReader run(folder / "run");
  CHECK(run.snapshot_count() == 4);
  CHECK(run.times() == std::vector<double>{0, 0.1, 0.2, 0.3});
  CHECK(run.record().status == RunStatus::failed);
  CHECK(run.record().reason == "because");
  CHECK(run.record().seed == 42);
  CHECK(run.record().filling_hash == "00ff");
  CHECK(run.record().warnings == std::vector<std::string>{"careful"});
  CHECK(run.history().column("energy") == std::vector<double>{0, 0.2, 0.4, 0.6});
  CHECK(run.scene_text() == "title = \"x\"\n");
  CHECK_THAT(read_text_file(folder / "run/snapshots/snapshots.vtkhdf.series"), Contains("snapshot_000003.vtkhdf"));
}

TEST_CASE("snapshots are found by place, number and time") {
  const testing::TemporaryFolder folder;
  write_run(folder / "run");
  const RunReader run(folder / "run");
  CHECK(run.index_at("last") == 3);
  CHECK(run.index_at("first") == 0);
  CHECK(run.index_at("2") == 2);
  CHECK(run.index_at("-2") == 2);
  CHECK(run.index_at("t=0.12") == 1);
  CHECK(run.index_at("t=260 ms") == 3);
  CHECK(run.index_at("t=0.34") == 3);
  CHECK(run.index_at("t=-40 ms") == 0);
  CHECK_THROWS_WITH(run.index_at("t=0.36"), Contains("no snapshot near t=0.36") && Contains("t=0 to 0.3 s"));
  CHECK_THROWS_AS(run.index_at("t=-0.06"), InputError);
  CHECK_THROWS_WITH(run.index_at("4"), Contains("numbers 0 to 3"));
  CHECK_THROWS_WITH(run.index_at("lst"), Contains("names no snapshot"));
}

TEST_CASE("an earlier run and other people's files are not overwritten") {
  const testing::TemporaryFolder folder;
  write_run(folder / "run");
  CHECK_THROWS_WITH(RunWriter(folder / "run", false), Contains("--overwrite"));
  CHECK(RunReader(folder / "run").snapshot_count() == 4);
  RunWriter(folder / "run", true);
  CHECK_FALSE(std::filesystem::exists(folder / "run/run.json"));

  std::filesystem::create_directory(folder / "thesis");
  std::ofstream(folder / "thesis/chapter.tex") << "text";
  CHECK_THROWS_AS(RunWriter(folder / "thesis", true), InputError);
  CHECK(std::filesystem::exists(folder / "thesis/chapter.tex"));
  CHECK_THROWS_AS(RunWriter(folder / "thesis/chapter.tex", true), InputError);
  CHECK_THROWS_AS(RunWriter("/proc/packstone", false), InputError);
}

TEST_CASE("a folder that is no run is refused") {
  const testing::TemporaryFolder folder;
  CHECK_THROWS_WITH(RunReader(folder.path()), Contains("not a run folder"));
  CHECK_THROWS_WITH(RunReader(folder / "absent"), Contains("no such"));
  write_run(folder / "run");
  std::ofstream(folder / "run/run.json") << "{";
  CHECK_THROWS_WITH(RunReader(folder / "run").record(), Contains("damaged"));
}
