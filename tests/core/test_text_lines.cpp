#include <cmath>

#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "core/hash.hpp"
#include "core/text_lines.hpp"

using namespace packstone;

TEST_CASE("lines come without comments, blanks and line ends, with their numbers") {
  TextLines lines("\xef\xbb\xbf# head\r\n\r\n a, b # tail \r\n\t\n#\nlast", "t.csv");
  REQUIRE(lines.next());
  CHECK(lines.line() == "a, b");
  CHECK(lines.comment() == "tail");
  CHECK(lines.number() == 3);
  CHECK_THROWS_WITH(lines.fail("is wrong"), "t.csv:3: is wrong");
  REQUIRE(lines.next());
  CHECK(lines.line() == "last");
  CHECK(lines.comment().empty());
  CHECK(lines.number() == 6);
  CHECK_FALSE(lines.next());
  CHECK_FALSE(TextLines("", "empty").next());
}

TEST_CASE("fields are split at separators, words at blanks") {
  CHECK(split(" a ,b,, c\r", ',') == std::vector<std::string_view>{"a", "b", "", "c"});
  CHECK(split("", ',') == std::vector<std::string_view>{""});
  CHECK(words("  1\t2   xlo ") == std::vector<std::string_view>{"1", "2", "xlo"});
  CHECK(words(" \t").empty());
}

TEST_CASE("numbers are whole texts in C notation") {
  CHECK(parsed_number("1.5e-3") == 1.5e-3);
  CHECK(parsed_number("+2") == 2.0);
  CHECK(parsed_number("-.5") == -0.5);
  CHECK(std::isnan(parsed_number("nan").value()));
  for (const char* wrong : {"", "1,5", "1.5m", "0x10", "+-2", "one", "1 2"}) CHECK_FALSE(parsed_number(wrong));
  CHECK(parsed_integer("3.000e0") == 3);
  for (const char* wrong : {"0.5", "nan", "inf", "1e300", ""}) CHECK_FALSE(parsed_integer(wrong));
}

TEST_CASE("the fingerprint is FNV-1a") {
  // Test vectors of the FNV authors.
  CHECK(content_hash("") == "cbf29ce484222325");
  CHECK(content_hash("a") == "af63dc4c8601ec8c");
  CHECK(content_hash("foobar") == "85944171f73967e8");
}
