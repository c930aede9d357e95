#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "core/files.hpp"
#include "tests/temporary_folder.hpp"
#include "viz/image.hpp"
#include "viz/report.hpp"

using namespace packstone;
using namespace packstone::viz;
using Catch::Matchers::Contains;

namespace {

Report small_report(const std::filesystem::path& png) {
  Report report;
  report.title = "Beds <1> & 2";
  report.subtitle = "by \"packstone\"";
  ReportSection section;
  section.title = "Results";
  section.paragraphs = {"5 < 6 & 7 > 2"};
  section.tables = {{"Numbers", {"Name", "Value"}, {{"a<b", "0.61 ± 0.02"}, {"c", "-3e-5"}}}};
  section.images = {{png, "A picture"}};
  section.preformatted = "[domain]\n<x>";
  report.sections = {section};
  return report;
}

}  // namespace

TEST_CASE("a report holds its text escaped and its pictures inside") {
  testing::TemporaryFolder folder;
  // Bytes whose base64 is known: RFC 4648 gives "Zm9vYmE=" for "fooba".
  write_text_file(folder / "p.png", "fooba");
  write_report(folder / "r.html", small_report(folder / "p.png"));
  const std::string page = read_text_file(folder / "r.html");
  CHECK_THAT(page, Contains("<h1>Beds &lt;1&gt; &amp; 2</h1>"));
  CHECK_THAT(page, Contains("by &quot;packstone&quot;"));
  CHECK_THAT(page, Contains("5 &lt; 6 &amp; 7 &gt; 2"));
  CHECK_THAT(page, Contains("<td>a&lt;b</td><td class=\"number\">0.61 ± 0.02</td>"));
  CHECK_THAT(page, Contains("src=\"data:image/png;base64,Zm9vYmE=\""));
  CHECK_THAT(page, Contains("[domain]\n&lt;x&gt;</pre>"));
  CHECK_THAT(page, !Contains("http") && !Contains("<script"));
}

TEST_CASE("a report without its picture, or its place, is not written") {
  testing::TemporaryFolder folder;
  CHECK_THROWS_AS(write_report(folder / "r.html", small_report(folder / "missing.png")), RunError);
  CHECK_FALSE(std::filesystem::exists(folder / "r.html"));
  CHECK_THROWS_AS(write_report(folder / "missing/r.html", Report{}), RunError);
}
