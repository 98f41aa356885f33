// SPDX-License-Identifier: LGPL-2.1-or-later
#include "theories/fastsim.hpp"

#include "contact/base/errors.hpp"
#include "contact/iteration/compliance.hpp"
#include "theories/polach.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>

namespace rollfem::theories {

namespace {

StripAt strips_of(const EllipticPatch& patch, BoundShape shape) {
  const double largest = patch.friction * patch.hertz.max_pressure *
                         (shape == BoundShape::parabolic ? 4.0 / 3.0 : 1.0);
  return [&patch, largest, shape](double y) {
    BrushStrip strip = ellipse_strip(patch.hertz, y, largest, shape);
    strip.law = patch.falling.get();
    return strip;
  };
}

BrushTotals sum_grid_strips(const BrushProblem& problem, const halfspace::HertzContact& ellipse,
                            const StripAt& strip_at, int strips) {
  const double width = 2.0 * ellipse.semi_axis_y / strips;
  BrushTotals totals;
  for (int j = 0; j < strips; ++j) {
    const BrushStrip strip = strip_at(-ellipse.semi_axis_y + (j + 0.5) * width);
    const StripElements elements = grid_elements(strip, ellipse.semi_axis_x, problem.elements);
    const contact::Creepage creepage = strip_creepage(problem.geometry, problem.creepage, strip.y);
    add_strip(strip, solve_strip(strip, problem.flexibilities, creepage, elements), width, totals);
  }
  return totals;
}

BrushTotals sum_ellipse(const EllipticPatch& patch, const contact::Creepage& creepage,
                        const BrushFlexibilities& flexibilities, const StripAt& strip_at,
                        const FastsimOptions& options) {
  if (options.strips < 1 || options.strip_elements < 1)
    throw contact::InputError("FASTSIM needs at least one strip and one element in each");
  const BrushProblem problem{patch.geometry, creepage, flexibilities, options.strip_elements};
  if (options.elements == FastsimElements::grid)
    return sum_grid_strips(problem, patch.hertz, strip_at, options.strips);
  return sum_strips(problem, strip_at, patch.hertz.semi_axis_y, options.strips);
}

/// Order of convergence, measured: 2; 1.5 with the elliptic bound, taken as 1; 1 where spin turns
/// the direction of slip.
int convergence_order(const FastsimOptions& options, const contact::Creepage& creepage,
                      bool falling) {
  const bool second = !falling && options.elements == FastsimElements::chord &&
                      options.bound == BoundShape::parabolic && creepage.spin == 0.0;
  return second ? 2 : 1;
}

}  // namespace

double slope_factor(const EllipticPatch& patch, const contact::Creepage& creepage,
                    const std::array<double, 3>& reduction) {
  const auto& [start, end, decay] = reduction;
  if (patch.friction == 0.0) return start;
  const halfspace::CreepForces linear = halfspace::linear_creep_forces(
      patch.hertz.semi_axis_x, patch.hertz.semi_axis_y, patch.material.shear_modulus,
      patch.material.poisson_ratio, creepage);
  const double slip = std::hypot(creepage.longitudinal, creepage.lateral);
  const double friction = patch.falling ? patch.falling->at(slip).value : patch.friction;
  const double gradient = start * polach_gradient(std::hypot(linear.longitudinal, linear.lateral),
                                                  friction * patch.hertz.normal_force);
  return start * (end + (1.0 - end) / (1.0 + decay * gradient));
}

BrushFlexibilities fastsim_flexibilities(const EllipticPatch& patch,
                                         const contact::Creepage& creepage,
                                         const FastsimOptions& options) {
  const double a = patch.hertz.semi_axis_x;
  const double b = patch.hertz.semi_axis_y;
  const double factor = slope_factor(patch, creepage, options.slope_reduction);
  BrushFlexibilities three =
      kalker_flexibilities(a, b, patch.material.shear_modulus, patch.material.poisson_ratio);
  // A layer between the bodies is one more bed of brushes.
  for (double* flexibility : {&three.longitudinal, &three.lateral, &three.spin})
    *flexibility = *flexibility / factor + patch.material.layer;
  return options.flexibilities == Flexibilities::three
             ? three
             : single_flexibility(three, creepage, std::sqrt(a * b));
}

StripElements grid_elements(const BrushStrip& strip, double semi_axis_x, int count) {
  const double step = 2.0 * semi_axis_x / count;
  StripElements elements{0.0, step, step, 0,
                         contact::upstream_of_spin(contact::UpwindOrder::first, 1.0)};
  for (int i = count - 1; i >= 0; --i) {
    const double x = -semi_axis_x + (i + 0.5) * step;
    if (std::abs(x) >= strip.half_length) continue;
    if (elements.count++ == 0) elements.x_first = x;
  }
  return elements;
}

BrushTotals fastsim(const EllipticPatch& patch, const contact::Creepage& creepage,
                    const FastsimOptions& options) {
  return fastsim(patch, creepage, fastsim_flexibilities(patch, creepage, options), options);
}

BrushTotals fastsim(const EllipticPatch& patch, const contact::Creepage& creepage,
                    const BrushFlexibilities& flexibilities, const FastsimOptions& options) {
  return sum_ellipse(patch, creepage, flexibilities, strips_of(patch, options.bound), options);
}

namespace {

/// A model on brushes of an ellipse: its strips at given creepages, and its order in the elements.
struct BrushModel {
  const char* name;
  const char* label;
  std::function<StripAt(const EllipticPatch&, const contact::Creepage&)> strips;
  std::function<int(const EllipticPatch&, const contact::Creepage&)> order;
};

contact::ModelResult run_brushes(const BrushModel& model, const contact::Scene& scene,
                                 const contact::Progress& progress, const FastsimOptions& options) {
  const EllipticPatch patch = elliptic_patch(scene);
  FastsimOptions half = options;
  half.strips = (options.strips + 1) / 2;
  half.strip_elements = (options.strip_elements + 1) / 2;
  long unknowns = 0;
  const auto fill = [&](contact::PointResult& point) {
    const contact::Creepage& creepage = point.creepage;
    const BrushFlexibilities flexibilities = fastsim_flexibilities(patch, creepage, options);
    const StripAt strip_at = model.strips(patch, creepage);
    const BrushProblem problem{patch.geometry, creepage, flexibilities, options.strip_elements};
    fill_brush_fields(patch.grid, problem, strip_at, point);
    const BrushTotals totals = sum_ellipse(patch, creepage, flexibilities, strip_at, options);
    set_totals(totals, point);
    estimate_error(totals, sum_ellipse(patch, creepage, flexibilities, strip_at, half),
                   model.order(patch, creepage), point);
    unknowns = 2 * totals.elements;
  };
  contact::ModelResult result =
      run_theory(scene, patch.grid, patch.normal, model.name, progress, fill);
  result.unknowns = unknowns;
  result.notes.push_back(
      fmt::format("{}: error estimates cover the resolution only; see model_error for the error of "
                  "the theory itself",
                  model.label));
  return result;
}

/// Strips under Hertz's pressure with the adhesion of strip theory.
StripAt strips_with_theory(const EllipticPatch& patch, const contact::Creepage& creepage) {
  return [&patch, creepage, plain = strips_of(patch, BoundShape::elliptic)](double y) {
    BrushStrip strip = plain(y);
    if (strip.bound > 0.0)
      strip.theory.emplace(patch.hertz, patch.material,
                           patch.friction * patch.hertz.max_pressure / patch.hertz.semi_axis_x,
                           strip_creepage(patch.geometry, creepage, y), y);
    return strip;
  };
}

}  // namespace

contact::ModelResult run_fastsim(const contact::Scene& scene, const contact::Progress& progress,
                                 const FastsimOptions& options) {
  const auto strips = [&](const EllipticPatch& patch, const contact::Creepage&) {
    return strips_of(patch, options.bound);
  };
  const auto order = [&](const EllipticPatch& patch, const contact::Creepage& creepage) {
    return convergence_order(options, creepage, patch.falling != nullptr);
  };
  return run_brushes({"fastsim", "FASTSIM", strips, order}, scene, progress, options);
}

contact::ModelResult run_fastrip(const contact::Scene& scene, const contact::Progress& progress,
                                 const FastsimOptions& options) {
  // The tractions begin and end with a root.
  const auto first = [](const EllipticPatch&, const contact::Creepage&) { return 1; };
  FastsimOptions one = options;
  one.flexibilities = Flexibilities::one;
  one.slope_reduction = FastsimOptions().slope_reduction;
  return run_brushes({"fastrip", "FaStrip", strips_with_theory, first}, scene, progress, one);
}

}  // namespace rollfem::theories
