// Numbers are read and written with points, whatever the user's locale says.
#include <clocale>
#include <cstdio>
#include <cstdlib>

#include <catch2/catch.hpp>

#include "engine/formula.hpp"
#include "targets.hpp"
#include "tests/shell.hpp"
#include "tests/temporary_folder.hpp"

using namespace packstone;
using namespace packstone::fuzz;

namespace {

/// The locale of a country with decimal commas, compiled from the C library's sources; empty where these are missing.
class DecimalComma {
 public:
  DecimalComma() {
    testing::shell("localedef -i de_DE -f UTF-8 " + testing::quoted(folder_ / "de_DE.UTF-8"));
    setenv("LOCPATH", folder_.path().c_str(), 1);
    set_ = std::setlocale(LC_ALL, "de_DE.UTF-8") != nullptr;
  }
  ~DecimalComma() {
    std::setlocale(LC_ALL, "C");
    unsetenv("LOCPATH");
  }
  bool is_set() const { return set_; }

 private:
  testing::TemporaryFolder folder_;
  bool set_ = false;
};

}  // namespace

TEST_CASE("with a decimal comma all files are read and written as ever") {
  std::vector<std::vector<std::string>> before;
  for (const Target& target : targets()) before.push_back(target.seeds());
  const DecimalComma comma;
  if (!comma.is_set()) {
    WARN("skipped: the package locales, which has de_DE, is not there");
    return;
  }
  char text[8];
  std::snprintf(text, sizeof text, "%.1f", 1.5);
  REQUIRE(std::string(text) == "1,5");
  for (std::size_t k = 0; k < targets().size(); ++k) {
    INFO(targets()[k].name);
    CHECK((targets()[k].seeds() == before[k]));
    for (const std::string& seed : before[k]) CHECK(is_accepted(targets()[k], seed));
  }
  CHECK(engine::Formula("0.5*x", {"x"})({3}) == 1.5);
}
