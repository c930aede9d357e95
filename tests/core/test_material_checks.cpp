// Nonsense in materials and contact laws is refused with a line that says what would be right.
#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "core/scene.hpp"
#include "tests/sample_scene.hpp"

using namespace packstone;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

/// The message for the small scene with other laws, and other keys in place of both materials' damping.
std::string error_of(const std::string& contact, const std::string& keys) {
  std::string text = testing::small_scene_with("normal = \"hysteretic\"", contact);
  const std::string damping = "normal_stiffness = 1e6\nnormal_damping = 0.7";
  for (std::size_t at = 0; (at = text.find(damping, at)) != std::string::npos; at += keys.size()) {
    text.replace(at, damping.size(), keys);
  }
  try {
    parse_scene(text, "s.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

const std::string elastic = "young_modulus = 1e8\npoisson_ratio = 0.3\n", stiff = "normal_stiffness = 1e6\n";

}  // namespace

TEST_CASE("each law takes the keys it needs") {
  CHECK(error_of("normal = \"hertz\"", elastic + "restitution = 0.5") == "no error");
  CHECK(error_of("normal = \"hertz\"", elastic + "normal_damping = 3") == "no error");
  CHECK(error_of("normal = \"kuwabara-kono\"", elastic + "dissipation_time = 1e-5") == "no error");
  CHECK(error_of("normal = \"kuwabara-kono\"", elastic + "shear_viscosity = 1e4\nbulk_viscosity = \"2e4 Pa s\"") ==
        "no error");
  CHECK(error_of("normal = \"walton-braun\"", stiff + "unloading_stiffness = 2e6") == "no error");
  CHECK(error_of("normal = \"walton-braun\"", stiff + "restitution = 0.5") == "no error");
  CHECK(error_of("normal = \"linear\"\ntangential = \"mindlin-deresiewicz\"", stiff + elastic + "restitution = 0.5") ==
        "no error");
}

TEST_CASE("a law's missing key is named, with the law") {
  CHECK_THAT(error_of("normal = \"hertz\"", stiff + "restitution = 0.5"),
             StartsWith("s.toml:16") && Contains("material[0]: needs young_modulus for contact.normal = \"hertz\""));
  CHECK_THAT(error_of("normal = \"hertz\"", "young_modulus = 1e8\nrestitution = 0.5"), Contains("needs poisson_ratio"));
  CHECK_THAT(error_of("normal = \"linear\"", elastic + "restitution = 0.5"), Contains("needs normal_stiffness"));
  CHECK_THAT(error_of("normal = \"walton-braun\"", stiff), Contains("needs unloading_stiffness or restitution"));
  CHECK_THAT(error_of("normal = \"kuwabara-kono\"", elastic), Contains("needs dissipation_time, or shear_viscosity"));
  CHECK_THAT(error_of("normal = \"kuwabara-kono\"", elastic + "shear_viscosity = 3"), Contains("and bulk_viscosity"));
  const std::string linear = "normal = \"linear\"\ntangential = ";
  CHECK_THAT(error_of(linear + "\"haff-werner\"", stiff + "restitution = 1"), Contains("needs tangential_damping"));
  CHECK_THAT(error_of(linear + "\"walton-braun\"", stiff + "restitution = 1"), Contains("needs tangential_stiffness"));
  CHECK_THAT(error_of(linear + "\"mindlin-deresiewicz\"", stiff + "restitution = 1"),
             Contains("needs young_modulus for contact.tangential = \"mindlin-deresiewicz\""));
}

TEST_CASE("what makes no sense is refused") {
  const std::string viscous = "shear_viscosity = 1e4\nbulk_viscosity = 2e4";
  CHECK_THAT(error_of("normal = \"kuwabara-kono\"", "young_modulus = 1e8\npoisson_ratio = 0\n" + viscous),
             Contains("material[0].poisson_ratio") && Contains("infinite"));
  CHECK_THAT(error_of("normal = \"kuwabara-kono\"", elastic + "restitution = 0.5"),
             Contains("restitution") && Contains("falls with the speed"));
  CHECK_THAT(error_of("normal = \"kuwabara-kono\"", elastic + "dissipation_time = 1e-5\n" + viscous),
             Contains("keep one of the two"));
  CHECK_THAT(error_of("normal = \"kuwabara-kono\"", elastic + "shear_viscosity = 0\nbulk_viscosity = 0"),
             Contains("both viscosities are 0"));
  CHECK_THAT(error_of("normal = \"hysteretic\"", stiff + "normal_damping = 1"), Contains("would pull on unloading"));
  CHECK_THAT(error_of("normal = \"walton-braun\"", stiff + "unloading_stiffness = 9e5"),
             Contains("material[0].unloading_stiffness") && Contains("gain energy"));
  CHECK_THAT(error_of("normal = \"walton-braun\"", stiff + "unloading_stiffness = 2e6\nrestitution = 0.5"),
             Contains("keep one of the two"));
  CHECK_THAT(error_of("normal = \"walton-braun\"", stiff + "normal_damping = 5\nrestitution = 0.5"),
             Contains("plastic"));
  CHECK_THAT(error_of("normal = \"hertz\"", "young_modulus = 1e8\npoisson_ratio = 0.6\nrestitution = 1"),
             Contains("poisson_ratio") && Contains("from 0 to 0.5"));
  CHECK_THAT(error_of("normal = \"hertz\"\nrelease = \"zero-force\"", elastic + "restitution = 0.1"),
             Contains("cannot be reached"));
  CHECK_THAT(error_of("normal = \"linear\"\nsign_speed = 0.1", stiff + "restitution = 1"),
             Contains("contact.sign_speed") && Contains("hysteretic"));
}

TEST_CASE("attraction has a constant, and ends beyond its smallest gap") {
  const std::string hysteretic = "normal = \"hysteretic\"\n[contact.van_der_waals]\n";
  const std::string keys = stiff + "normal_damping = 0.7";
  CHECK(error_of(hysteretic + "hamaker = 1e-19", keys) == "no error");
  CHECK_THAT(error_of(hysteretic + "min_gap = 1e-9", keys), Contains("contact.van_der_waals.hamaker: is missing"));
  CHECK_THAT(error_of(hysteretic + "hamaker = 1e-19\nmin_gap = 1e-8\ncutoff = 1e-9", keys),
             Contains("contact.van_der_waals.cutoff") && Contains("larger than min_gap"));
  CHECK_THAT(error_of(hysteretic + "hamaker = -1e-19", keys), Contains("greater than 0"));
}

TEST_CASE("a scene with every law's keys reads back as itself") {
  const std::string text =
      testing::small_scene_with("normal = \"hysteretic\"",
                                "normal = \"hysteretic\"\nsign_speed = 0.01\n[contact.van_der_waals]\nhamaker = 1e-19");
  const Scene scene = parse_scene(text, "s.toml");
  CHECK(*scene.contact.van_der_waals.cutoff == Approx(1e-7));
  const std::string written = to_toml(scene);
  CHECK(to_toml(parse_scene(written, "again.toml")) == written);
}
