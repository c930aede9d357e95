// Which way the contacts point.
#include <Eigen/Eigenvalues>
#include <cmath>

#include "analysis/blocks.hpp"
#include "analysis/forces/stress.hpp"
#include "analysis/structure/parts.hpp"
#include "core/bed.hpp"

namespace packstone::analysis {

namespace {

/// From the deviator of the fabric tensor to the second-order density of contact directions,
/// E(n) = (1 + F_ij n_i n_j)/(4 pi): F = 15/2 (phi - 1/3).
constexpr double density_factor = 7.5;

struct Normals {
  std::vector<Vec3> all, bulk;  // one a contact
};

struct Fabric {
  Mat3 tensor;      // phi, trace 1
  Vec3 eigenvalue;  // descending
  Vec3 principal;   // unit vector of the largest, upper half space
  double anisotropy;
  double error;  // of the anisotropy
};

Normals contact_normals(const Snapshot& snapshot, const Context& context) {
  const BedFrame& frame = context.frame;
  Normals normals;
  for (const NearPair& pair : context.contacts.pairs) {
    const Vec3 apart = snapshot.domain.separation(snapshot.position[pair.first], snapshot.position[pair.second]);
    const double distance = apart.norm();
    if (!(distance > 0)) continue;
    normals.all.push_back(apart / distance);
    // Half way from the second centre to the first, whose image may be beyond a periodic side.
    const double middle = frame.height[pair.second] + frame.sign * apart[frame.axis] / 2;
    const double share = middle / context.bed.height;
    if (frame.periodic || (share >= bulk_lower && share <= bulk_upper)) normals.bulk.push_back(normals.all.back());
  }
  return normals;
}

Fabric fabric_of(const std::vector<Vec3>& normals, const Vec3& up) {
  const double n = static_cast<double>(normals.size());
  Fabric fabric;
  const Mat3 zero = Mat3::Zero();
  fabric.tensor = sum_in_blocks(normals.size(), zero,
                                [&](Mat3& sum, std::size_t k) { sum += normals[k] * normals[k].transpose(); }) /
                  n;
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(fabric.tensor);
  fabric.eigenvalue = solver.eigenvalues().reverse();
  fabric.principal = solver.eigenvectors().col(2);
  if (fabric.principal.dot(up) < 0) fabric.principal = -fabric.principal;

  const Mat3 deviator = fabric.tensor - Mat3::Identity() / 3;
  const double size = deviator.norm();
  fabric.anisotropy = density_factor * std::sqrt(1.5) * size;
  fabric.error = 0;
  if (!(size > 0)) return fabric;
  // The anisotropy moves with the mean of n.D n, D the deviator of length 1.
  const Mat3 direction = deviator / size;
  const double squares = sum_in_blocks(normals.size(), 0.0, [&](double& sum, std::size_t k) {
    const double off = normals[k].dot(direction * normals[k]) - size;
    sum += off * off;
  });
  fabric.error = density_factor * std::sqrt(1.5 * squares) / n;
  return fabric;
}

struct FabricQuantities {
  Quantity anisotropy, random, vertical, angle;
};

FabricQuantities fabric_quantities(const std::string& note) {
  const std::string region =
      "contacts between particles whose middle lies between 10 % and 80 % of the bed's height, "
      "all of them where the domain is periodic along up";
  return {{.key = "fabric_anisotropy",
           .label = "anisotropy of contacts",
           .definition = "sqrt(3/2 F:F), F = 15/2 (phi - 1/3) the deviatoric fabric of phi_ij = <n_i n_j>, n along the "
                         "centres of " +
                         region +
                         " (Satake 1982; Oda 1982; Kanatani, Int. J. Eng. Sci. 22 (1984) 149);"
                         " uncertainty: standard error to first order, as if contacts were independent",
           .note = note},
          {.key = "fabric_anisotropy_random",
           .label = "anisotropy of contacts, random",
           .definition = "15/2 / sqrt(contacts): root mean square of fabric_anisotropy if as many contacts had "
                         "independent isotropic directions",
           .note = note},
          {.key = "fabric_vertical",
           .label = "vertical fabric",
           .definition = "<n_up^2> over the contacts of fabric_anisotropy; 1/3 when isotropic; uncertainty: standard "
                         "error, as if contacts were independent",
           .note = note},
          {.key = "fabric_principal_angle",
           .label = "principal direction of contacts, from up",
           .unit = "degrees",
           .definition = "angle between up and the eigenvector of phi's largest eigenvalue, over the contacts of "
                         "fabric_anisotropy; 0 to 90",
           .note = note}};
}

void set_vertical(Quantity& vertical, const Fabric& fabric, const std::vector<Vec3>& normals, int axis) {
  const double n = static_cast<double>(normals.size());
  const double mean = fabric.tensor(axis, axis);
  vertical.value = mean;
  if (normals.size() < 2) return;
  const double squares = sum_in_blocks(normals.size(), 0.0, [&](double& sum, std::size_t k) {
    const double off = normals[k][axis] * normals[k][axis] - mean;
    sum += off * off;
  });
  vertical.uncertainty = std::sqrt(squares / (n - 1) / n);
}

}  // namespace

void add_fabric(MeasureResult& result, const Snapshot& snapshot, const Context& context) {
  FabricQuantities q = fabric_quantities(context.contacts.source());
  Table table{.key = "fabric",
              .caption =
                  "Fabric tensor phi_ij = <n_i n_j> of the contacts between particles, its eigenvalues, its "
                  "anisotropy (as fabric_anisotropy) with error, and the unit vector of its largest eigenvalue; "
                  "bulk 1: contacts between 10 % and 80 % of the bed's height (all, where periodic along up), "
                  "0: all contacts",
              .columns = {{"bulk", "", ColumnFormat::integer},
                          {"contacts", "", ColumnFormat::integer},
                          {"xx"},
                          {"yy"},
                          {"zz"},
                          {"xy"},
                          {"xz"},
                          {"yz"},
                          {"eigenvalue_1"},
                          {"eigenvalue_2"},
                          {"eigenvalue_3"},
                          {"anisotropy"},
                          {"error"},
                          {"principal_x"},
                          {"principal_y"},
                          {"principal_z"}}};
  const BedFrame& frame = context.frame;
  const Vec3 up = frame.sign * Vec3::Unit(frame.axis);
  const Normals normals = contact_normals(snapshot, context);
  const auto add_row = [&](double bulk, const std::vector<Vec3>& each) {
    const Fabric f = fabric_of(each, up);
    const Mat3& t = f.tensor;
    table.rows.push_back({bulk, static_cast<double>(each.size()), t(0, 0), t(1, 1), t(2, 2), t(0, 1), t(0, 2), t(1, 2),
                          f.eigenvalue[0], f.eigenvalue[1], f.eigenvalue[2], f.anisotropy,
                          each.size() > 1 ? f.error : no_value, f.principal[0], f.principal[1], f.principal[2]});
    return f;
  };
  if (!normals.all.empty()) add_row(0, normals.all);
  if (normals.bulk.empty()) {
    const std::string reason = normals.all.empty() ? "no contacts between particles" : "no contacts in the bulk";
    for (Quantity* each : {&q.anisotropy, &q.random, &q.vertical, &q.angle}) *each = not_applicable(*each, reason);
  } else {
    const Fabric fabric = add_row(1, normals.bulk);
    q.anisotropy.value = fabric.anisotropy;
    if (normals.bulk.size() > 1) q.anisotropy.uncertainty = fabric.error;
    q.random.value = density_factor / std::sqrt(static_cast<double>(normals.bulk.size()));
    set_vertical(q.vertical, fabric, normals.bulk, frame.axis);
    q.angle.value = angle_to_vertical(fabric.principal, frame);
  }
  for (const Quantity& each : {q.anisotropy, q.random, q.vertical, q.angle}) result.quantities.push_back(each);
  result.tables.push_back(std::move(table));
}

}  // namespace packstone::analysis
