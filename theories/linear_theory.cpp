#include "theories/linear_theory.hpp"

#include "halfspace/closed_forms/kalker.hpp"
#include "theories/brush.hpp"
#include "theories/elliptic_patch.hpp"

#include <limits>

namespace rollfem::theories {

contact::ModelResult run_linear(const contact::Scene& scene, const contact::Progress& progress) {
  const EllipticPatch patch = elliptic_patch(scene);
  const double a = patch.hertz.semi_axis_x;
  const double b = patch.hertz.semi_axis_y;
  const contact::CombinedMaterial& material = patch.material;
  const BrushFlexibilities flexibilities =
      kalker_flexibilities(a, b, material.shear_modulus, material.poisson_ratio);
  const auto strip_at = [&](double y) {
    return ellipse_strip(patch.hertz, y, std::numeric_limits<double>::infinity(),
                         BoundShape::parabolic);
  };
  return run_theory(scene, patch.grid, patch.normal, "linear", progress,
                    [&](contact::PointResult& point) {
                      if (patch.friction == 0.0) return;
                      const BrushProblem problem{patch.geometry, point.creepage, flexibilities, 64};
                      fill_brush_fields(patch.grid, problem, strip_at, point);
                      const halfspace::CreepForces forces = halfspace::linear_creep_forces(
                          a, b, material.shear_modulus, material.poisson_ratio, point.creepage);
                      set_forces(forces, point);
                      set_largest_tractions(point);
                    });
}

}  // namespace rollfem::theories
