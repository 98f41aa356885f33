// SPDX-License-Identifier: LGPL-2.1-or-later
#include "theories/fastsim.hpp"

#include "base/errors.hpp"
#include "case/keys/key_builder.hpp"
#include "contact/iteration/compliance.hpp"
#include "theories/closed_forms.hpp"
#include "theories/theory.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <vector>

namespace rollfem::theories {

namespace {

BrushStrip strip_of(const EllipticPatch& patch, BoundShape shape, double y) {
  const double largest = patch.friction * patch.hertz.max_pressure *
                         (shape == BoundShape::parabolic ? 4.0 / 3.0 : 1.0);
  BrushStrip strip = ellipse_strip(patch.hertz, y, largest, shape);
  strip.law = patch.falling.get();
  return strip;
}

StripAt strips_of(const EllipticPatch& patch, BoundShape shape) {
  return [&patch, shape](double y) { return strip_of(patch, shape, y); };
}

BrushTotals sum_ellipse(const EllipticPatch& patch, const contact::Creepage& creepage,
                        const BrushFlexibilities& flexibilities, const StripAt& strip_at,
                        const FastsimOptions& options) {
  if (options.strips < 1 || options.strip_elements < 1)
    throw contact::InputError("FASTSIM needs at least one strip and one element in each");
  const BrushProblem problem{patch.geometry, creepage, flexibilities, options.strip_elements};
  const auto [a, b] = std::array{patch.hertz.semi_axis_x, patch.hertz.semi_axis_y};
  BrushTotals totals;
  if (options.elements == FastsimElements::chord) {
    add_strips(problem, strip_at, strip_places(b, options.strips), totals);
    return totals;
  }
  const double width = 2.0 * b / options.strips;
  std::vector<StripPlace> places;
  for (int j = 0; j < options.strips; ++j) places.push_back({-b + (j + 0.5) * width, width});
  add_strips(problem, strip_at, places, totals, [&, a = a](const BrushStrip& strip) {
    return grid_elements(strip, a, problem.elements);
  });
  return totals;
}

/// Order of convergence, measured: 2; 1.5 with the elliptic bound, taken as 1; 1 where spin turns
/// the direction of slip.
int convergence_order(const FastsimOptions& options, const contact::Creepage& creepage,
                      bool falling) {
  const bool second = !falling && options.elements == FastsimElements::chord &&
                      options.bound == BoundShape::parabolic && creepage.spin == 0.0;
  return second ? 2 : 1;
}

/// k_0 (alpha_inf + (1 - alpha_inf)/(1 + beta eps)), by which the slope of a creep curve is reduced
/// (Spiryagin, Polach and Cole 2013, Vehicle System Dynamics 51, 1765-1783). eps is Polach's
/// gradient for the slope reduced by k_0, with the friction of the rigid slip in the middle.
double slope_factor(const EllipticPatch& patch, const contact::Creepage& creepage,
                    const std::array<double, 3>& reduction) {
  const auto& [start, end, decay] = reduction;
  if (patch.friction == 0.0) return start;
  const halfspace::CreepForces linear = patch.linear_forces(creepage);
  const double gradient =
      start * polach_gradient(std::hypot(linear.longitudinal, linear.lateral),
                              patch.friction_at(creepage) * patch.hertz.normal_force);
  return start * (end + (1.0 - end) / (1.0 + decay * gradient));
}

/// Flexibilities of a patch at given creepages: the linear theory's over the case's reduction of
/// the slope, and a layer in series.
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

}  // namespace

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

/// Strips under Hertz's pressure with the adhesion of strip theory.
StripAt strips_with_theory(const EllipticPatch& patch, const contact::Creepage& creepage) {
  return [&patch, creepage](double y) {
    BrushStrip strip = strip_of(patch, BoundShape::elliptic, y);
    if (strip.bound > 0.0)
      strip.theory.emplace(patch.hertz, patch.material,
                           patch.friction * patch.hertz.max_pressure / patch.hertz.semi_axis_x,
                           strip_creepage(patch.geometry, creepage, y), y);
    return strip;
  };
}

void add_fastsim_keys() {
  using contact::between, contact::symbol;
  contact::Keys<FastsimOptions> keys("fastsim",
                                     "Model `fastsim`; `fastrip` takes strips and elements");
  keys.add(
      "bound", &FastsimOptions::bound,
      {{"parabolic", BoundShape::parabolic}, {"elliptic", BoundShape::elliptic}},
      "Traction bound: `parabolic` 4/3 mu p0 (1 - r^2); `elliptic` mu p0 sqrt(1 - r^2), Hertz's.");
  keys.add(
      "flexibilities", &FastsimOptions::flexibilities,
      {{"three", Flexibilities::three}, {"one", Flexibilities::one}},
      "Flexibility of the brushes for each creepage, or their mean weighted by the creepages.");
  keys.add("elements", &FastsimOptions::elements,
           {{"chord", FastsimElements::chord}, {"grid", FastsimElements::grid}},
           "`chord` divides every strip equally; `grid` is a common grid with the spin a sixth of "
           "a step upstream, as in CONTACT (first order).");
  keys.add("strips", &FastsimOptions::strips, between(8, 2000), "Strips across the patch.");
  keys.add("strip_elements", &FastsimOptions::strip_elements, between(4, 2000),
           "Elements along each strip.");
  keys.add("slope_reduction", &FastsimOptions::slope_reduction, symbol("k_0, alpha_inf, beta"),
           between(1e-6, 100.0),
           "Softer brushes on contaminated surfaces (docs/theory.md); all 1: Kalker's slope. Not "
           "for `fastrip`.");
  keys.section().position = 1;
  contact::add_section(keys);
}

/// FASTSIM, or FaStrip with the adhesion of strip theory.
contact::ModelResult run_brushes(bool adhesion_of_strips, const contact::Scene& scene,
                                 const contact::Progress& progress, const FastsimOptions& options) {
  const EllipticPatch patch = elliptic_patch(scene);
  FastsimOptions half = options;
  half.strips = (options.strips + 1) / 2;
  half.strip_elements = (options.strip_elements + 1) / 2;
  const auto strips_at = [&](const contact::Creepage& creepage) {
    return adhesion_of_strips ? strips_with_theory(patch, creepage)
                              : strips_of(patch, options.bound);
  };
  const auto transmitted = [&](const contact::Creepage& creepage) -> contact::TransmittedForce {
    const halfspace::CreepForces forces =
        sum_ellipse(patch, creepage, fastsim_flexibilities(patch, creepage, options),
                    strips_at(creepage), options)
            .forces;
    return {{forces.longitudinal, forces.lateral},
            patch.friction_at(creepage) * patch.hertz.normal_force};
  };
  long unknowns = 0;
  const auto fill = [&](contact::PointResult& point) {
    const contact::Creepage& creepage = point.creepage;
    const BrushFlexibilities flexibilities = fastsim_flexibilities(patch, creepage, options);
    const StripAt strip_at = strips_at(creepage);
    const BrushProblem problem{patch.geometry, creepage, flexibilities, options.strip_elements};
    const contact::Field rows = fill_brush_fields(patch.grid, problem, strip_at, point);
    const BrushTotals totals = sum_ellipse(patch, creepage, flexibilities, strip_at, options);
    set_totals(totals, patch.grid, rows, point);
    // In FaStrip the tractions begin and end with a root.
    const int order =
        adhesion_of_strips ? 1 : convergence_order(options, creepage, patch.falling != nullptr);
    estimate_error(totals, sum_ellipse(patch, creepage, flexibilities, strip_at, half), order,
                   point);
    unknowns = 2 * totals.elements;
  };
  contact::ModelResult result =
      run_theory(with_creepages_of_forces(scene, transmitted, patch.falling != nullptr), patch.grid,
                 patch.normal, adhesion_of_strips ? "fastrip" : "fastsim", progress, fill);
  result.unknowns = unknowns;
  contact::add_note(
      result.notes, "bars",
      "{}: error estimates cover the resolution only; see model_error for the error of "
      "the theory itself",
      adhesion_of_strips ? "FaStrip" : "FASTSIM");
  return result;
}

}  // namespace

contact::ModelResult run_fastsim(const contact::Scene& scene, const contact::Progress& progress) {
  return run_brushes(false, scene, progress, scene.options.of<FastsimOptions>());
}

contact::ModelResult run_fastrip(const contact::Scene& scene, const contact::Progress& progress) {
  FastsimOptions one = scene.options.of<FastsimOptions>();
  one.flexibilities = Flexibilities::one;
  one.slope_reduction = FastsimOptions().slope_reduction;
  return run_brushes(true, scene, progress, one);
}

contact::ModelInfo fastsim_model() {
  using contact::Demand;
  contact::ModelInfo model = theory(
      "fastsim", "FASTSIM", "Kalker's simplified theory on an ellipse",
      {Demand::tangential_force, Demand::profiles, Demand::sections, Demand::lateral_creepage,
       Demand::spin, Demand::extra_slip, Demand::falling_friction, Demand::layer},
      with_pass_work(elliptic(run_fastsim)), strips_on_ellipse);
  model.add_keys = add_fastsim_keys;
  model.refinements = {
      refined_strips<FastsimOptions, &FastsimOptions::strips, &FastsimOptions::strip_elements>()};
  model.own_bound = model.in_compare = true;
  return model;
}

contact::ModelInfo fastrip_model() {
  using contact::Demand;
  contact::ModelInfo model = theory(
      "fastrip", "FaStrip", "FASTSIM's direction of slip with the adhesion area of strip theory",
      {Demand::tangential_force, Demand::profiles, Demand::sections, Demand::lateral_creepage,
       Demand::spin, Demand::extra_slip},
      with_pass_work(elliptic(run_fastrip)), strips_on_ellipse);
  model.add_keys = add_fastsim_keys;
  model.refinements = {
      refined_strips<FastsimOptions, &FastsimOptions::strips, &FastsimOptions::strip_elements>()};
  return model;
}

}  // namespace rollfem::theories
