#include <fstream>

#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "core/history.hpp"
#include "tests/temporary_folder.hpp"

using namespace packstone;
using Catch::Matchers::Contains;

namespace {

std::filesystem::path written(const testing::TemporaryFolder& folder, const std::string& text) {
  std::ofstream(folder / "history.csv") << text;
  return folder / "history.csv";
}

}  // namespace

TEST_CASE("a history is read column by column") {
  const testing::TemporaryFolder folder;
  const History h = read_history(written(folder, "step,time\n0,0\n1,0.5\n"));
  CHECK(h.rows() == 2);
  CHECK(h.column("time") == std::vector<double>{0, 0.5});
  CHECK_THROWS_WITH(h.column("energy"), Contains("step, time"));
}

TEST_CASE("a row that a kill cut short is left out") {
  const testing::TemporaryFolder folder;
  CHECK(read_history(written(folder, "a,b\n1,2\n3,4.5")).rows() == 1);
}

TEST_CASE("a damaged history is refused with file and line") {
  const testing::TemporaryFolder folder;
  CHECK_THROWS_WITH(read_history(written(folder, "a,b\n1,2\n3\n")), Contains("history.csv:3"));
  CHECK_THROWS_WITH(read_history(written(folder, "a,b\n1,x\n")), Contains("history.csv:2") && Contains("\"x\""));
  CHECK_THROWS_AS(read_history(folder / "absent.csv"), InputError);
}
