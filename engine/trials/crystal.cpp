#include "engine/trials/crystal.h"

#include <cmath>

namespace furnas {
namespace {

/// `cells` cubic cells of edge `a` along each axis, with spheres at the `basis` [a].
Packing cubic_crystal(double a, int cells, const std::vector<Vec3<double>>& basis) {
  std::vector<Ball> balls;
  for (int x = 0; x < cells; ++x)
    for (int y = 0; y < cells; ++y)
      for (int z = 0; z < cells; ++z)
        for (const Vec3<double>& b : basis)
          balls.push_back({.position = a * Vec3<double>{x + b.x, y + b.y, z + b.z}});
  return packing_of(cube(cells * a), balls);
}

}  // namespace

Packing simple_cubic(double r, int cells) { return cubic_crystal(r, cells, {{}}); }

Packing face_centred(double r, int cells) {
  return cubic_crystal(std::sqrt(2) * r, cells, {{0, 0, 0}, {0, 0.5, 0.5}, {0.5, 0, 0.5}, {0.5, 0.5, 0}});
}

Packing face_centred_primitive(double r) {
  return packing_of({r, std::sqrt(3) / 2 * r, std::sqrt(2.0 / 3) * r, r / (2 * std::sqrt(3)), r / 2, r / 2},
                    {{}});
}

double contact_pressure(const Packing& p) { return p.stress.contacts.trace() / (3 * p.cell.volume()); }

Packing with_forces(const Model& model, const Packing& packing) { return after(model, packing, 0); }

Eigen::Matrix3d stress_per_strain(Model model, const Packing& crystal, const Triangle& strain) {
  model.barostat = {.freedom = CellFreedom::triclinic, .pressure = 0, .inertia = 1e300};
  model.affine_velocity = true;
  constexpr int steps = 100;
  constexpr double size = 1e-7;
  const double rate = size / (steps * model.time_step);
  Packing p = with_forces(model, crystal);
  const Eigen::Matrix3d before = p.stress.contacts / p.cell.volume();
  p.cell.rate = rate * strain;
  for (auto& spin : p.spin) spin = (rate / 2) * Vec3<double>{-strain.yz, strain.xz, -strain.xy};
  p = after(model, p, steps);
  return (p.stress.contacts / p.cell.volume() - before) / size;
}

double shear_modulus_of_face_centred(double r, double tangential_stiffness) {
  return std::sqrt(2) * (1 + tangential_stiffness) / (2 * r);
}

}  // namespace furnas
