// A run of the built command, for pictures to be made of.
#pragma once

#include <fstream>
#include <string>

#include <catch2/catch.hpp>

#include "command.hpp"
#include "tests/sample_scene.hpp"
#include "tests/temporary_folder.hpp"

namespace packstone::testing {

/// small_scene's, of five snapshots, in a folder where there is room beside it.
struct SmallRun {
  TemporaryFolder folder;
  std::string path;

  SmallRun() {
    std::ofstream(folder / "scene.toml") << small_scene;
    path = (folder / "run").string();
    const auto made = packstone_command("run " + (folder / "scene.toml").string() + " --quiet --threads 1 -o " + path);
    REQUIRE(made.exit_code == 0);
  }
  std::string out(const std::string& name) const { return " -o " + (folder / name).string(); }
};

}  // namespace packstone::testing
