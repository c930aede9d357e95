// What is written into a checkpoint comes back; what cannot be one is refused.
#include <fstream>

#include <catch2/catch.hpp>

#include "core/checkpoint_file.hpp"
#include "core/files.hpp"
#include "core/scene_difference.hpp"
#include "core/vec3.hpp"
#include "tests/temporary_folder.hpp"

using namespace packstone;
using Catch::Matchers::Contains;
using packstone::testing::TemporaryFolder;

namespace {

struct Inner {
  bool flag = false;
  std::string text;

  void archive(Archive& a) { a(flag, text); }
  bool operator==(const Inner&) const = default;
};

/// One of each kind of value.
struct State {
  double number = 0;
  std::vector<Vec3> vectors;
  std::vector<Inner> inner;
  std::optional<Inner> there, absent;
  std::array<float, 3> few = {};

  void archive(Archive& a) { a(number, vectors, inner, there, absent, few); }
  bool operator==(const State&) const = default;
};

State some_state() {
  return {0.1,      {Vec3(1, 2, 3), Vec3(-4, 5, 1e-300)}, {{true, "a"}, {false, ""}}, Inner{true, "b"}, std::nullopt,
          {1, 2, 3}};
}

void write_state(const std::filesystem::path& file, State state) {
  CheckpointWriter writer(file);
  std::string name = "first";
  writer.begin("name");
  writer(name);
  writer.begin("state");
  writer(state);
  writer.commit();
}

}  // namespace

TEST_CASE("a checkpoint gives back what was written, part by part and again") {
  const TemporaryFolder folder;
  write_state(folder / "c", some_state());
  CheckpointReader reader(folder / "c");
  for (int k = 0; k < 2; ++k) {
    State state;
    state.absent = Inner{};
    reader.begin("state");
    reader(state);
    CHECK(state == some_state());
    std::string name;
    reader.begin("name");
    reader(name);
    CHECK(name == "first");
  }
  CHECK_THROWS_WITH(reader.begin("other"), Contains("no part \"other\""));
}

TEST_CASE("a checkpoint that is not committed leaves nothing") {
  const TemporaryFolder folder;
  { CheckpointWriter writer(folder / "c"); }
  CHECK(std::filesystem::is_empty(folder.path()));
}

TEST_CASE("a part that holds less or more than is read is another state") {
  const TemporaryFolder folder;
  write_state(folder / "c", some_state());
  CheckpointReader reader(folder / "c");
  std::uint64_t number = 0;
  reader.begin("name");
  reader(number);
  CHECK_THROWS_WITH(reader(number), Contains("another state"));  // five letters are left
  CheckpointReader more(folder / "c");
  more.begin("name");
  more(number);
  CHECK_THROWS_WITH(more.begin("state"), Contains("another state"));
  // A count that the part cannot hold allocates nothing: the number 0.1 as one.
  CheckpointReader count(folder / "c");
  std::vector<double> huge;
  count.begin("state");
  CHECK_THROWS_WITH(count(huge), Contains("another state"));
}

TEST_CASE("a checkpoint cut anywhere, or of another version, is refused") {
  const TemporaryFolder folder;
  write_state(folder / "c", some_state());
  const std::string good = read_text_file(folder / "c");
  for (std::size_t size = 0; size < good.size(); ++size) {
    std::ofstream(folder / "cut", std::ios::binary) << good.substr(0, size);
    CHECK_THROWS_AS(CheckpointReader(folder / "cut"), InputError);
  }
  std::string newer = good;
  newer[8] = 9;
  std::ofstream(folder / "newer", std::ios::binary) << newer;
  CHECK_THROWS_WITH(CheckpointReader(folder / "newer"), Contains("version 9") && Contains("reads version 1"));
}

TEST_CASE("keys in which scenes differ are named") {
  const std::string one = "a = 1\n[b]\nc = \"auto\"\n[[d]]\ne = [1, 2]\n[[d]]\ne = [3]\n";
  CHECK(differing_keys(one, one).empty());
  CHECK(differing_keys(one, "a = 1\n[b]\nc = 4\nf = 1\n[[d]]\ne = [1, 2]\n[[d]]\ne = [4]\n") ==
        std::vector<std::string>{"b.c", "d[1].e", "b.f"});
}
