#include <array>
#include <cstdio>
#include <memory>
#include <string>

#include <catch2/catch.hpp>

#include "engine/run.hpp"
#include "tests/sample_scene.hpp"
#include "tests/temporary_folder.hpp"

using namespace packstone;

TEST_CASE("a small h5py script reads every dataset of a snapshot") {
  const testing::TemporaryFolder folder;
  engine::run_scene(parse_scene(testing::small_scene, "s.toml"), folder / "run", {});
  const std::string command = std::string(PACKSTONE_PYTHON) +
                              " " PACKSTONE_SOURCE_DIR "/tests/format/check_snapshot.py " +
                              (folder / "run/snapshots/snapshot_000004.vtkhdf").string() + " 2>&1";
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::string output;
  std::array<char, 256> buffer;
  while (std::fgets(buffer.data(), buffer.size(), pipe.get())) output += buffer.data();
  CHECK(output == "ok 120 particles\n");
}
