// Text, JSON and CSV.
#include <filesystem>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "analysis/writers.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "tests/analysis/fixtures.hpp"
#include "tests/temporary_folder.hpp"

using namespace packstone;
using namespace packstone::analysis;
using namespace packstone::fixtures;
using Catch::Matchers::Contains;

namespace {

std::vector<MeasureResult> made_up() {
  MeasureResult result{.name = "packing"};
  result.quantities = {{.key = "bulk_fraction",
                        .label = "fraction",
                        .value = 0.636271,
                        .uncertainty = 0.00123,
                        .definition = "of \"solid\", by volume"},
                       {.key = "bed_height", .label = "height", .value = 0.1, .unit = "m", .definition = "up"},
                       not_applicable({.key = "lacey", .label = "index", .definition = "M"}, "one type")};
  result.tables = {{.key = "profile",
                    .caption = "by height",
                    .columns = {{"lower", "m"}, {"count", "", ColumnFormat::integer}, {"fraction"}},
                    .rows = {{0.0, 3, 0.5}, {0.1, 4, std::nan("")}}}};
  return {result};
}

}  // namespace

TEST_CASE("JSON holds value, unit, uncertainty and definition by measure and key") {
  Snapshot s = cubic_bed(4, 4, 6);
  label_at_random(s, 1);
  const auto json = to_json(analyze(s));
  CHECK(json["packing"]["bulk_fraction"]["value"].is_number());
  CHECK(json["structure"]["coordination_mean"]["value"].is_number());
  CHECK(json["segregation"]["lacey"]["value"].is_number());
  for (const char* key : {"value", "unit", "uncertainty", "definition"}) {
    CHECK(json["packing"]["bed_height"].contains(key));
  }
  const auto& profile = json["packing"]["profile"];
  CHECK(profile["columns"] == nlohmann::json({"lower", "upper", "fraction"}));
  CHECK(profile["units"] == nlohmann::json({"m", "m", ""}));
  CHECK(profile["rows"][0].size() == 3);
  CHECK(json.dump().find("nan") == std::string::npos);
}

TEST_CASE("JSON: what does not apply is null, with its reason") {
  const auto json = to_json(made_up())["packing"];
  CHECK(json["lacey"]["value"].is_null());
  CHECK(json["lacey"]["note"] == "one type");
  CHECK(json["profile"]["rows"][1][2].is_null());
  CHECK(json["profile"]["rows"][0][1].is_number_integer());
  CHECK_FALSE(json["bed_height"].contains("note"));
}

TEST_CASE("JSON of a series tells the instants apart") {
  const auto json = to_json(std::vector<TimedResults>{{0.5, 10, made_up()}, {1.0, 20, made_up()}});
  REQUIRE(json.size() == 2);
  CHECK(json[1]["at"]["time"] == 1.0);
  CHECK(json[1]["at"]["step"] == 20);
  CHECK(json[1]["packing"]["bed_height"]["value"] == 0.1);
}

TEST_CASE("text tells a reason that many numbers share once") {
  MeasureResult result{.name = "segregation"};
  const auto missing = [](const std::string& label, const std::string& reason) {
    return not_applicable({.key = label, .label = label}, reason);
  };
  result.quantities = {missing("a", "one type"),
                       missing("b", "one type"),
                       missing("c", "one type"),
                       missing("d", "no mass"),
                       {.key = "e", .label = "e", .value = 1}};
  const std::string text = to_text({result});
  CHECK_THAT(text, Contains("a  n/a  (one type)\n  ... 2 more numbers do not exist for this reason\n  d"));
  CHECK_THAT(text, !Contains("b  "));
  CHECK_THAT(text, Contains("e  1"));
}

TEST_CASE("CSV quotes what needs quotes") {
  const testing::TemporaryFolder folder;
  write_csv(folder.path(), made_up());
  CHECK(read_text_file(folder / "measures.csv") ==
        "measure,key,value,uncertainty,unit,definition,note\n"
        "packing,bulk_fraction,0.636271,0.00123,,\"of \"\"solid\"\", by volume\",\n"
        "packing,bed_height,0.1,,m,up,\n"
        "packing,lacey,,,,M,one type\n");
  CHECK(read_text_file(folder / "packing_profile.csv") ==
        "lower [m],count,fraction\n"
        "0,3,0.5\n"
        "0.1,4,\n");
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) files += entry.is_regular_file();
  CHECK(files == 2);  // no temporary file is left
}

TEST_CASE("CSV of a series has a leading time") {
  const testing::TemporaryFolder folder;
  write_csv(folder.path(), std::vector<TimedResults>{{0.5, 10, made_up()}, {1.0, 20, made_up()}});
  CHECK(read_text_file(folder / "packing_profile.csv") ==
        "time [s],lower [m],count,fraction\n"
        "0.5,0,3,0.5\n"
        "0.5,0.1,4,\n"
        "1,0,3,0.5\n"
        "1,0.1,4,\n");
  CHECK_THAT(read_text_file(folder / "measures.csv"), Contains("\n1,packing,bed_height,0.1,,m,up,\n"));
}

TEST_CASE("a file that cannot be written is an error") {
  const testing::TemporaryFolder folder;
  write_text_file(folder / "file", "");
  CHECK_THROWS_AS(write_csv(folder / "file" / "inside", made_up()), RunError);
  CHECK_THROWS_AS(write_json(folder / "absent" / "x.json", to_json(made_up())), RunError);
}

TEST_CASE("text is aligned and says what does not apply") {
  const std::string text = to_text(made_up());
  CHECK_THAT(text, Contains("  fraction  0.6363 ± 0.0012\n"));
  CHECK_THAT(text, Contains("  height    0.1             m\n"));
  CHECK_THAT(text, Contains("  index     n/a              (one type)\n"));
  CHECK_THAT(text, Contains("lower [m]  count  fraction"));
  CHECK_THAT(to_text(made_up(), 1), Contains("1 more rows"));
  CHECK_THAT(to_text(made_up(), 0), !Contains("by height"));
}

TEST_CASE("a value keeps the digits its uncertainty allows") {
  const auto text = [](double value, double uncertainty) {
    return value_text({.value = value, .uncertainty = uncertainty});
  };
  CHECK(text(0.636271, 0.00123) == "0.6363 ± 0.0012");
  CHECK(text(12.3456, 1.2) == "12.3 ± 1.2");
  CHECK(text(12345.6, 210) == "12346 ± 2.1e+02");
  CHECK(text(0.5, 0) == "0.5");
  CHECK(value_text({.value = 3.14159265}) == "3.1416");
  CHECK(value_text({}) == "n/a");
}
