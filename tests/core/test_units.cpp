#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "core/units.hpp"

using namespace packstone;
using Catch::Matchers::Contains;

TEST_CASE("quantities are turned into SI") {
  CHECK(parse_quantity("20 mm", unit::metre) == Approx(0.02));
  CHECK(parse_quantity("20mm", unit::metre) == Approx(0.02));
  CHECK(parse_quantity("50 us", unit::second) == Approx(50e-6));
  CHECK(parse_quantity("50 \u00b5s", unit::second) == Approx(50e-6));
  CHECK(parse_quantity("2 min", unit::second) == Approx(120));
  CHECK(parse_quantity("7.8 g/cm3", unit::density) == Approx(7800));
  CHECK(parse_quantity("7800 kg m^-3", unit::density) == Approx(7800));
  CHECK(parse_quantity("9.8 m/s2", unit::acceleration) == Approx(9.8));
  CHECK(parse_quantity("10 kN/mm", unit::stiffness) == Approx(1e7));
  CHECK(parse_quantity("3 N s/m", unit::damping) == Approx(3));
  CHECK(parse_quantity("3 kg/s", unit::damping) == Approx(3));
  CHECK(parse_quantity("50 %", unit::none) == Approx(0.5));
  CHECK(parse_quantity("1e-3", unit::metre) == Approx(1e-3));
  CHECK(parse_quantity(" -2.5 ", unit::none) == Approx(-2.5));
}

TEST_CASE("a wrong quantity is answered with the unit that would be right") {
  CHECK_THROWS_WITH(parse_quantity("20 kg", unit::metre), Contains("wrong dimension") && Contains("1 m"));
  CHECK_THROWS_WITH(parse_quantity("20 furlong", unit::metre), Contains("unknown unit"));
  CHECK_THROWS_WITH(parse_quantity("much", unit::metre), Contains("not a number"));
  for (const char* text :
       {"", " ", "1e999", "nan", "inf", "2 m m/", "2 m/", "2 m//s", "2 m2", "3 m/q", "3 m^", "3 m3x"}) {
    INFO(text);
    CHECK_THROWS_AS(parse_quantity(text, unit::metre), InputError);
  }
}
