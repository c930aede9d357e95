// Which keys of a material each contact law needs, and which go together.
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/scene_checks.hpp"
#include "core/text.hpp"

namespace packstone {

const ChoiceNames normal_laws = {"linear", "hertz", "kuwabara-kono", "walton-braun", "hysteretic"};
const ChoiceNames tangential_laws = {"none",        "coulomb", "haff-werner", "cundall-strack", "mindlin-deresiewicz",
                                     "walton-braun"};

namespace {

/// Restitution exp(-2) of a critically damped contact that ends with its force.
constexpr double least_zero_force_restitution = 0.1353352832366127;

/// Keys of one material, held against what the laws need.
class MaterialCheck {
 public:
  MaterialCheck(const Scene& scene, std::size_t index)
      : scene_(scene), material_(scene.materials[index]), path_(fmt::format("material[{}]", index)) {}

  void normal() const {
    switch (scene_.contact.normal) {
      case NormalModel::linear:
        need("normal_stiffness", material_.normal_stiffness.has_value());
        damping_or_restitution();
        reachable_restitution();
        return;
      case NormalModel::hertz:
        elastic_moduli(normal_law());
        damping_or_restitution();
        reachable_restitution();
        return;
      case NormalModel::kuwabara_kono:
        elastic_moduli(normal_law());
        viscosities();
        return;
      case NormalModel::walton_braun:
        need("normal_stiffness", material_.normal_stiffness.has_value());
        unloading();
        return;
      case NormalModel::hysteretic:
        need("normal_stiffness", material_.normal_stiffness.has_value());
        damping_or_restitution();
        if (material_.normal_damping.value_or(0) >= 1) {
          fail("normal_damping", fmt::format("{:g} would pull on unloading; hysteretic damping is from 0 to below 1",
                                             *material_.normal_damping));
        }
        return;
    }
  }

  void tangential() const {
    switch (scene_.contact.tangential) {
      case TangentialModel::none:
      case TangentialModel::coulomb:
        return;
      case TangentialModel::haff_werner:
        need("tangential_damping", material_.tangential_damping.has_value(), tangential_law());
        return;
      case TangentialModel::cundall_strack:
      case TangentialModel::walton_braun:
        need("tangential_stiffness", material_.tangential_stiffness.has_value(), tangential_law());
        return;
      case TangentialModel::mindlin_deresiewicz:
        elastic_moduli(tangential_law());
        return;
    }
  }

 private:
  [[noreturn]] void fail(const std::string& key, const std::string& what) const {
    scene_.fail(key.empty() ? path_ : path_ + "." + key, what);
  }
  std::string normal_law() const {
    return fmt::format("contact.normal = \"{}\"", normal_laws[static_cast<std::size_t>(scene_.contact.normal)]);
  }
  std::string tangential_law() const {
    return fmt::format("contact.tangential = \"{}\"",
                       tangential_laws[static_cast<std::size_t>(scene_.contact.tangential)]);
  }

  void need(const std::string& key, bool given, const std::string& law) const {
    if (!given) fail("", fmt::format("needs {} for {}", key, law));
  }
  void need(const std::string& key, bool given) const { need(key, given, normal_law()); }

  void elastic_moduli(const std::string& law) const {
    need("young_modulus", material_.young_modulus.has_value(), law);
    need("poisson_ratio", material_.poisson_ratio.has_value(), law);
  }

  void damping_or_restitution() const {
    if (material_.normal_damping && material_.restitution) {
      fail("restitution", "is given beside normal_damping; keep one of the two");
    }
    if (!material_.normal_damping && !material_.restitution) fail("", "needs normal_damping or restitution");
  }

  void reachable_restitution() const {
    if (scene_.contact.release != Release::zero_force ||
        material_.restitution.value_or(1) >= least_zero_force_restitution) {
      return;
    }
    fail("restitution",
         fmt::format("{:g} cannot be reached with contact.release = \"zero-force\", whose restitution is "
                     "{:.3f} at critical damping; take \"zero-overlap\"",
                     *material_.restitution, least_zero_force_restitution));
  }

  void viscosities() const {
    if (material_.restitution || material_.normal_damping) {
      fail(material_.restitution ? "restitution" : "normal_damping",
           "does not go with contact.normal = \"kuwabara-kono\", whose restitution falls with the speed; give "
           "dissipation_time [s], or shear_viscosity and bulk_viscosity [Pa s]");
    }
    const bool both = material_.shear_viscosity && material_.bulk_viscosity;
    const bool either = material_.shear_viscosity || material_.bulk_viscosity;
    if (material_.dissipation_time && either) {
      fail("dissipation_time", "is given beside viscosities; keep one of the two");
    }
    if (!material_.dissipation_time && !both) {
      fail("", "needs dissipation_time, or shear_viscosity and bulk_viscosity, for " + normal_law());
    }
    if (!both) return;
    if (*material_.poisson_ratio == 0) {
      fail("poisson_ratio",
           "0 makes kuwabara-kono's dissipation time from viscosities infinite; it is divided by its "
           "square: take a larger one, or give dissipation_time instead of the viscosities");
    }
    if (*material_.shear_viscosity + *material_.bulk_viscosity == 0) {
      fail("shear_viscosity", "both viscosities are 0; give dissipation_time = 0 for a contact without damping");
    }
  }

  void unloading() const {
    if (material_.normal_damping) {
      fail("normal_damping",
           "does not go with contact.normal = \"walton-braun\", which dissipates by plastic "
           "deformation; give unloading_stiffness or restitution");
    }
    if (material_.unloading_stiffness && material_.restitution) {
      fail("restitution", "is given beside unloading_stiffness; keep one of the two");
    }
    if (!material_.unloading_stiffness && !material_.restitution) {
      fail("", "needs unloading_stiffness or restitution for " + normal_law());
    }
    if (material_.unloading_stiffness && *material_.unloading_stiffness < *material_.normal_stiffness) {
      fail("unloading_stiffness",
           fmt::format("{:g} N/m is below normal_stiffness, {:g} N/m: a rebound would gain energy; give at least that",
                       *material_.unloading_stiffness, *material_.normal_stiffness));
    }
  }

  const Scene& scene_;
  const MaterialSpec& material_;
  std::string path_;
};

/// Dashpots mix with dashpots, restitutions with restitutions.
void check_damping_kinds(const Scene& s) {
  if (s.contact.normal != NormalModel::linear && s.contact.normal != NormalModel::hertz) return;
  for (std::size_t k = 1; k < s.materials.size(); ++k) {
    if (s.materials[k].restitution.has_value() == s.materials.front().restitution.has_value()) continue;
    s.fail(fmt::format("material[{}]", k),
           fmt::format("with contact.normal = \"{}\" all materials give normal_damping, or all give restitution",
                       normal_laws[static_cast<std::size_t>(s.contact.normal)]));
  }
}

void check_attraction(const Scene& s) {
  const VanDerWaalsSpec& w = s.contact.van_der_waals;
  if (w.present && *w.cutoff <= w.min_gap) {
    s.fail("contact.van_der_waals.cutoff",
           fmt::format("{:g} m must be larger than min_gap, {:g} m", *w.cutoff, w.min_gap));
  }
}

}  // namespace

void check_materials(const Scene& scene) {
  for (std::size_t k = 0; k < scene.materials.size(); ++k) {
    const MaterialCheck check(scene, k);
    check.normal();
    check.tangential();
  }
  check_damping_kinds(scene);
  check_attraction(scene);
  if (scene.contact.sign_speed > 0 && scene.contact.normal != NormalModel::hysteretic) {
    scene.fail("contact.sign_speed", "goes with contact.normal = \"hysteretic\" alone; leave it out");
  }
}

}  // namespace packstone
