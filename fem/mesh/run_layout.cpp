// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/mesh/run_layout.hpp"

#include "base/count.hpp"
#include "base/errors.hpp"
#include "base/root.hpp"
#include "fem/mesh/body_mesh.hpp"
#include "fem/mesh/surface_shape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rollfem::fem {

namespace {

using contact::ContactGrid;
using contact::Scene;

/// Extent of the finest cells in semi-axes: on case a 1.5 was no improvement.
constexpr double default_reach = 1.1;

constexpr const char* of_grid = "contact elements across the patch (fem.cell_size)";

/// Elements of the potential contact area beyond the expected patch, each side.
constexpr int usual_margin = 3;

/// On the lattice of the FE faces, an even number of elements in each direction.
ContactGrid lattice_grid(const PatchBox& patch, double cell, int margin) {
  const int half_x = contact::count_of(std::ceil(patch.half_length / cell), of_grid) + margin;
  const int half_y = contact::count_of(std::ceil(patch.half_width / cell), of_grid) + margin;
  return ContactGrid::centred(2 * half_x, 2 * half_y, cell, cell, 0.0, patch.middle);
}

/// Default extent of segments: eight larger half sizes of the patch, limited by the allowed extent
/// in a small wheel (check in body_mesh.cpp) as long as four remain.
double default_extent(const Scene& scene, const PatchBox& patch) {
  constexpr double most = 0.7, in_steps_of = 0.95;  // of the radius
  const contact::ContactSurface& surface = scene.geometry.surface;
  const double least = 4.0 * patch.larger();
  double extent = 2.0 * least;
  if (!scene.geometry.has_surfaces()) return extent;
  const auto reaches_in = [&](double reach) {
    const auto of_body = [&](bool rigid, contact::ProfileDrop drop, double radius) {
      const double inwards = surface.profiles ? 0.0 : drop.value;
      return rigid ? 0.0 : std::max(reach + inwards, reach) / std::abs(radius);
    };
    return std::max(
        of_body(scene.wheel.material.rigid(), surface.wheel_drop(reach), surface.rolling_radius),
        of_body(scene.rail.material.rigid(), surface.rail_drop(reach),
                surface.rail_rolling_radius));
  };
  while (reaches_in(extent) > most && extent * in_steps_of > least) extent *= in_steps_of;
  return extent;
}

/// How much longer and wider than between elastic bodies the patch becomes where a body is pressed
/// until it yields all over the contact: it bears a mean pressure of at least 2.3 times its yield
/// stress (up to three; Johnson 1985, section 6.3), the softer one of two bodies.
double growth_by_yielding(const Scene& scene) {
  constexpr double least_mean = 2.3, mean_part = 2.0 / 3.0;
  if (!scene.is_history()) return 1.0;
  double area = 1.0;
  for (const auto& steel : {scene.wheel.plasticity, scene.rail.plasticity})
    if (steel)
      area = std::max(area, mean_part * PatchSearch(scene).patch().max_pressure /
                                (least_mean * (steel->yield_stress + std::min(0.0, steel->rise))));
  return std::sqrt(area);
}

PatchBox expected_box(const Scene& scene) {
  PatchBox box = PatchSearch(scene).box();
  const double growth = growth_by_yielding(scene);
  for (double* length : {&box.half_length, &box.half_width, &box.half_loaded}) *length *= growth;
  return box;
}

/// The part of the surface that contact elements cover, without margin: contact_grid.extent, or the
/// expected patch.
PatchBox covered(const Scene& scene) {
  PatchBox box = expected_box(scene);
  const contact::GridOptions& grid = scene.contact_grid;
  if (!grid.extent) return box;
  PatchSearch(scene).check_extent();
  box.half_length = 0.5 * (*grid.extent)[0] + std::abs(grid.middle[0]);
  box.half_width = 0.5 * (*grid.extent)[1];
  box.middle = grid.middle[1];
  return box;
}

/// Meshed surfaces of a patch of true profiles.
std::vector<SurfaceShape> meshed_surfaces(const Scene& scene) {
  std::vector<SurfaceShape> shapes;
  for (const bool is_wheel : {true, false})
    if (!(is_wheel ? scene.wheel : scene.rail).material.rigid())
      shapes.push_back(profile_surface(scene.geometry.surface.profiles, is_wheel));
  return shapes;
}

/// The box of the family `structured` ends where one of the profiles ends or becomes steep, but has
/// a least extent, up to which it follows the steep profile.
void fit_to_profiles(const Scene& scene, const PatchBox& patch, BodyOptions& options) {
  for (const SurfaceShape& shape : meshed_surfaces(scene))
    if (std::min(options.middle - shape.lower_t(), shape.upper_t() - options.middle) <
        options.fine_half_width)
      throw contact::InputError(
          scene.where(),
          "the patch and the cells around it extend from y = {:.4g} to {:.4g} mm, the profile of "
          "the {} can be meshed from {:.4g} to {:.4g} mm, where it ends or becomes too steep for "
          "the frame of the patch; do: give a smaller [fem] fine_extent or cell_size, a smaller "
          "load, or a longer profile",
          options.middle - options.fine_half_width, options.middle + options.fine_half_width,
          shape.is_wheel ? "wheel" : "rail", shape.lower_t(), shape.upper_t());
  if (has_true_sections(scene)) return;
  for (const contact::FreeEnd& end : scene.geometry.surface.profiles->free_ends())
    if (std::abs(end.y - options.middle) < options.fine_half_width)
      throw contact::InputError(
          scene.where(),
          "the {} ends at y = {:.4g} mm, within the cells under the patch (free_ends), and a "
          "box of cells cannot end there; allowed: true sections; do: write `mesh = \"gmsh\"` and "
          "a rim_thickness that the bodies have under [fem], or use the model halfspace",
          end.of_wheel ? "wheel" : "rail", end.y);
  const double reach =
      std::max({halfspace::gentle_reach(scene, options.middle),
                halfspace::least_box_reach * patch.larger(), options.fine_half_width});
  options.half_width = std::min(options.reach_t(), reach);
}

/// Width, depth, length and mesh family of the case.
void set_segment_sizes(const Scene& scene, BodyOptions& options) {
  const FemOptions& asked = options_of(scene);
  options.family = asked.mesh.value_or(MeshFamily::structured);
  if (asked.width) options.half_width = 0.5 * *asked.width;
  if (asked.length) options.half_length = 0.5 * *asked.length;
  options.depth = asked.depth;
}

BodyOptions body_options(const Scene& scene, const PatchBox& patch, const ContactGrid& grid,
                         double cell) {
  const double reach = options_of(scene).fine_extent.value_or(default_reach);
  BodyOptions options;
  options.cell_size = cell;
  options.fine_half_length = std::max(reach * patch.half_length, 0.5 * grid.nx * grid.dx);
  options.fine_half_width = std::max(reach * patch.half_width, 0.5 * grid.ny * grid.dy);
  options.middle = patch.middle;
  options.extent = scene.body_extent.value_or(
      std::max(default_extent(scene, expected_box(scene)),
               2.0 * std::max(options.fine_half_length, options.fine_half_width)));
  options.half = scene.is_symmetric() && patch.middle == 0.0;
  options.degree = options_of(scene).degree;
  if (scene.feels_inertia()) options.speed = scene.speed;
  set_segment_sizes(scene, options);
  if (scene.has_profiles()) fit_to_profiles(scene, patch, options);
  return options;
}

}  // namespace

double default_cell_size(const Scene& scene) {
  const FemOptions& options = options_of(scene);
  // A larger region that yields has larger cells, so that it costs about as much.
  const auto& growth = options.plastic_growth;
  const double larger = scene.yields() ? std::max(1.0, options.plastic_extent) *
                                             std::cbrt(growth[0] * growth[1] * growth[2])
                                       : 1.0;
  return options.cell_size ? *options.cell_size : larger * expected_box(scene).smaller() / 8.0;
}

RunLayout run_layout(const Scene& scene, double cell) {
  RunLayout layout;
  layout.patch = covered(scene);
  // Aligns with the lattice; the displacement is added on both sides.
  const double exact = layout.patch.middle;
  layout.patch.middle = std::round(exact / cell) * cell;
  layout.patch.half_width += std::abs(layout.patch.middle - exact);
  // Linear displacements cannot follow an independent traction on every face: with elements of one
  // face the traction oscillates, and the contact iteration does not converge.
  layout.grid = lattice_grid(layout.patch, options_of(scene).degree == 1 ? 2.0 * cell : cell,
                             scene.contact_grid.extent ? 0 : usual_margin);
  layout.bodies = body_options(scene, layout.patch, layout.grid, cell);
  return layout;
}

namespace {

/// Depth in semi-axes down to which sqrt(J2) exceeds this part of the largest pressure, below the
/// middle of Hertz's line contact (in plane strain) or of a circular one (Johnson 1985,
/// sections 4.2 and 3.4); at least where that of the line contact is largest.
double depth_of_stress(double part, double poisson_ratio, bool line) {
  const auto root_j2 = [&](double z) {
    const double root = std::hypot(1.0, z);
    if (!line) {
      const double radial =
          (1.0 + poisson_ratio) * (1.0 - z * std::atan(1.0 / z)) - 0.5 / (root * root);
      return std::abs(1.0 / (root * root) - radial) / std::sqrt(3.0);
    }
    const double down = 1.0 / root, along = (1.0 + 2.0 * z * z) / root - 2.0 * z;
    const double across = poisson_ratio * (down + along);
    return std::sqrt(
        (std::pow(down - along, 2) + std::pow(down - across, 2) + std::pow(along - across, 2)) /
        6.0);
  };
  double depth = 0.8;
  while (root_j2(depth) > part && depth < 20.0) depth += 0.05;
  return depth;
}

/// Stress in shear, MPa, that steel bears after this plastic strain, without turning back.
double shear_borne(const contact::BodyPlasticity& steel, double strain) {
  double stress = steel.yield_stress_at(strain);
  for (const auto& back : steel.back_stresses)
    stress += back.recovery > 0.0
                  ? -back.modulus / back.recovery * std::expm1(-back.recovery * strain)
                  : back.modulus * strain;
  return stress / std::sqrt(3.0);
}

/// Height of the first row, mm: so thin that the strain at its first material points is within a
/// tenth of that at the surface, or of the yield strain. There the shear is the traction, and falls
/// below the middle of a line contact in full slip as mu p0 (1 - 2 depth/a) (Johnson 1985,
/// section 7.1): steel flows until it bears this. Tractions that it never bears fall as the contact
/// conforms.
double chosen_row(const Scene& scene, const contact::BodyPlasticity& steel, double young_modulus,
                  const PatchBox& patch) {
  constexpr double first_point = 0.2;  // of the row
  constexpr double least = 0.01;       // of the semi-axis
  constexpr double much = 1.0, part_borne = 0.97;
  const double traction =
      std::min(scene.friction_coefficient() * PatchSearch(scene).patch().max_pressure,
               part_borne * shear_borne(steel, much));
  const auto strain = [&](double depth) {
    const double shear = traction * (1.0 - 2.0 * depth / patch.smaller());
    const auto spare = [&](double of) { return shear_borne(steel, of) - shear; };
    return spare(0.0) >= 0.0 ? 0.0
                             : contact::bracketed_root(spare, 0.0, much, 1e-9, "plastic strain");
  };
  const double at_surface = strain(0.0);
  const double allowed = 0.1 * std::max(at_surface, steel.yield_stress / young_modulus);
  double height = patch.smaller();
  while (height > least * patch.smaller() && strain(first_point * height) < at_surface - allowed)
    height *= 0.8;
  return height;
}

/// Height of a first row, mm, whose first material points, a fifth of it deep, have the temperature
/// of the surface within a tenth: the heated layer is sqrt(kappa 2a/V). Infinite without heat.
double row_of_heat(const Scene& scene, bool is_wheel) {
  if (!scene.heat) return contact::infinity;
  return scene.heat->layer(is_wheel ? scene.heat->wheel : scene.heat->rail,
                           2.0 * expected_box(scene).half_length) /
         3.0;
}

/// Rows of fine cells and of streamlines that may yield down to this depth, mm.
void set_depths(double depth, BodyOptions& options) {
  const double h = options.cell_size;
  const auto rows = [&](double to) { return std::ceil(options.rows.even(to) / h - 1e-6); };
  options.plastic_depth = rows(depth);
  // Below, plastic strain is small and smooth: cells may grow.
  constexpr double fine_part = 0.7;
  options.fine_depth = std::max(rows(fine_part * options.rows.depth(options.plastic_depth * h)),
                                options.rows.reach() / h);
}

/// Of bodies with a first row of this height (mm) the one with the fewest unknowns: larger coarse
/// cells outside, or a closer fit of the rows.
BodyOptions with_thin_rows(double first, double depth, const BodyOptions& equal) {
  constexpr int most_at_once = 8;
  BodyOptions best;
  double fewest = contact::infinity;
  for (int at_once = most_at_once; at_once > 1; at_once /= 2) {
    BodyOptions options = equal;
    options.rows = GradedDepth(first, options.cell_size, at_once);
    set_depths(depth, options);
    const double unknowns = predicted_unknowns(options, fewest);
    if (unknowns < fewest) best = options;
    fewest = std::min(fewest, unknowns);
  }
  return best;
}

}  // namespace

BodyOptions options_of(const Scene& scene, bool is_wheel, const BodyOptions& both) {
  const contact::SceneBody& body = is_wheel ? scene.wheel : scene.rail;
  BodyOptions options = both;
  options.yields = body.plasticity.has_value();
  if (!options.yields) return options;
  const PatchBox patch = expected_box(scene);
  const double part = body.plasticity->shear_yield_stress() *
                      std::pow(growth_by_yielding(scene), 2) /
                      PatchSearch(scene).patch().max_pressure;
  const double nu = body.material.poisson_ratio, roundness = patch.smaller() / patch.larger();
  // Plastic flow of the first passes reaches deeper than the elastic stress.
  constexpr double deeper = 1.2;
  const double depth = deeper * patch.smaller() *
                       (roundness * depth_of_stress(part, nu, false) +
                        (1.0 - roundness) * depth_of_stress(part, nu, true));
  const double h = options.cell_size;
  std::array<double, 3> extent = options_of(scene).plastic_growth;
  for (double& of : extent) of *= options_of(scene).plastic_extent;
  const auto extended = [h](double least, double length) {
    return std::ceil(std::max(least, length) / h - 1e-6) * h;
  };
  options.fine_half_length =
      extended(options.fine_half_length, extent[0] * (patch.half_length + 0.35 * depth));
  options.plastic_half_width = extended(0.0, extent[1] * (patch.half_width + 0.25 * depth));
  options.fine_half_width = extended(options.fine_half_width, options.plastic_half_width);
  set_depths(extent[2] * depth, options);
  // The segment grows with the region that may yield; a given extent is kept.
  constexpr double beyond = 1.25;
  if (!scene.body_extent)
    options.extent = std::max(options.extent,
                              beyond * std::max({options.fine_half_length, options.fine_half_width,
                                                 options.fine_depth * h}));
  const double first = options_of(scene).surface_layer.value_or(
      std::min(chosen_row(scene, *body.plasticity, body.material.young_modulus, patch),
               row_of_heat(scene, is_wheel)));
  if (first > 0.0 && first < h) options = with_thin_rows(first, extent[2] * depth, options);
  return options;
}

bool resolves_heat(const Scene& scene, bool is_wheel, const BodyOptions& own) {
  constexpr double rounding = 1e-6;
  return scene.heat &&
         own.rows.depth(own.cell_size) <= (1.0 + rounding) * row_of_heat(scene, is_wheel);
}

}  // namespace rollfem::fem
