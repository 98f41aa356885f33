// SPDX-License-Identifier: LGPL-2.1-or-later
#include "theories/strip.hpp"

#include "base/count.hpp"
#include "base/errors.hpp"
#include "base/pi.hpp"
#include "base/root.hpp"
#include "case/keys/key_builder.hpp"
#include "halfspace/patch/patch_search.hpp"
#include "halfspace/patch/ridge.hpp"
#include "theories/equivalent_ellipse.hpp"
#include "theories/theory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rollfem::theories {

namespace {

using contact::pi;

double smallest_distance(const StripProfile& profile) {
  return *std::min_element(profile.distance.begin(), profile.distance.end());
}

/// g(y) of one strip, positive where the profiles overlap.
double overlap(const StripProfile& profile, int strip, double level) {
  return level - profile.distance[strip];
}

/// Where the overlap vanishes between a strip in contact and its neighbour out of contact; the
/// border of the profile when there is none.
double edge(const StripProfile& profile, int inside, int outside, double level) {
  const double half = 0.5 * (outside - inside) * profile.width;
  if (outside < 0 || outside >= profile.size()) return profile.y(inside) + half;
  const double within = overlap(profile, inside, level);
  return profile.y(inside) + 2.0 * half * within / (within - overlap(profile, outside, level));
}

/// The run of overlapping strips that begins at `first`.
StripPatch find_patch(const StripProfile& profile, int first, double level) {
  StripPatch patch;
  patch.first = patch.last = patch.deepest = first;
  while (patch.last + 1 < profile.size() && overlap(profile, patch.last + 1, level) > 0.0) {
    ++patch.last;
    if (profile.distance[patch.last] < profile.distance[patch.deepest]) patch.deepest = patch.last;
  }
  patch.y_lower = edge(profile, first, first - 1, level);
  patch.y_upper = edge(profile, patch.last, patch.last + 1, level);
  return patch;
}

/// Strips of one patch from Hertz's ellipse. A parabola B y^2 penetrating to the depth g0 has the
/// volume 4/3 g0 sqrt(g0/B); the ellipse's B gives the same depth and volume.
void solve_as_hertz(const StripProfile& profile, const StripLaw& law, double level,
                    StripPatch& patch, StripNormalSolution& solution) {
  const double depth = overlap(profile, patch.deepest, level);
  double volume = 0.0;
  for (int j = patch.first; j <= patch.last; ++j)
    volume += profile.width * overlap(profile, j, level);
  const double half_width = 0.75 * volume / depth;
  const double A = profile.curvature[patch.deepest];
  const double B = depth / (half_width * half_width);
  const halfspace::HertzContact shape = halfspace::hertz_from_force(A, B, law.contact_modulus, 1.0);
  const double aspect = shape.semi_axis_x / shape.semi_axis_y;
  patch.semi_axis_y = half_width;
  patch.semi_axis_x = aspect * half_width;
  // All of Hertz's figures scale with the size of the ellipse: p0 with a, the approach with a^2.
  const double scale = patch.semi_axis_x / shape.semi_axis_x;
  patch.max_pressure = shape.max_pressure * scale;
  patch.approach = shape.approach * scale * scale;
  for (int j = patch.first; j <= patch.last; ++j) {
    const double relative_curvature = profile.curvature[j] / A;
    const double length =
        patch.semi_axis_x * std::sqrt(overlap(profile, j, level) / (depth * relative_curvature));
    const double pressure = patch.max_pressure * relative_curvature * length / patch.semi_axis_x;
    solution.half_length[j] = length;
    solution.max_pressure[j] = pressure;
    solution.normal_force += 0.5 * pi * pressure * length * profile.width;
  }
}

/// Integral of sqrt(a^2 - x^2) / r over a strip of half length a whose middle is at lateral
/// distance `distance` from the origin of r, mm^2; x_m = 0.
double strip_potential(double a, double distance, double width) {
  // x = a sin(pi/2 u^2): points are dense at x = 0, where the integral of 1/r over the origin's own
  // strip is logarithmic, and the root at the ends becomes smooth.
  constexpr int places = 32;
  double sum = 0.0;
  for (int k = 0; k < places; ++k) {
    const double u = (k + 0.5) / places;
    const double angle = 0.5 * pi * u * u;
    const double x = a * std::sin(angle);
    const double across =
        std::asinh((distance + 0.5 * width) / x) - std::asinh((distance - 0.5 * width) / x);
    sum += u * std::pow(std::cos(angle), 2) * across;
  }
  return 2.0 * pi * a * a * sum / places;
}

/// Strips of one patch from its virtual penetration.
void solve_by_penetration(const StripProfile& profile, const StripLaw& law, double level,
                          StripPatch& patch, StripNormalSolution& solution) {
  const double depth = overlap(profile, patch.deepest, level);
  const double A = profile.curvature[patch.deepest];
  patch.semi_axis_y = 0.5 * (patch.y_upper - patch.y_lower);
  const double B = depth / (patch.semi_axis_y * patch.semi_axis_y);
  const halfspace::HertzContact shape = halfspace::hertz_from_force(A, B, law.contact_modulus, 1.0);
  patch.semi_axis_x = patch.semi_axis_y * shape.semi_axis_x / shape.semi_axis_y;
  const double stretch = patch.semi_axis_x / std::sqrt(depth / A);
  double potential = 0.0;
  for (int j = patch.first; j <= patch.last; ++j) {
    const double length = stretch * std::sqrt(overlap(profile, j, level) / profile.curvature[j]);
    solution.half_length[j] = length;
    potential += strip_potential(length, profile.y(j) - profile.y(patch.deepest), profile.width);
  }
  patch.approach = depth / *law.virtual_penetration;
  // The displacement of both surfaces under p is 1/(pi E*) times the integral of p / r.
  const double kappa = patch.approach * pi * law.contact_modulus / potential;
  patch.max_pressure = kappa * patch.semi_axis_x;
  for (int j = patch.first; j <= patch.last; ++j) {
    const double length = solution.half_length[j];
    solution.max_pressure[j] = kappa * length;
    solution.normal_force += 0.5 * pi * kappa * length * length * profile.width;
  }
}

/// Solution at the penetration at which `value`, which increases with it, reaches `target`.
StripNormalSolution find_penetration(const StripProfile& profile, const StripLaw& law,
                                     double target, const char* quantity,
                                     double StripNormalSolution::*value) {
  const double available =
      std::min(profile.distance.front(), profile.distance.back()) - smallest_distance(profile);
  const auto solve = [&](double g) { return strips_at_penetration(profile, law, g); };
  if (!(available > 0.0) || solve(available).*value < target)
    throw contact::SolveError(fmt::format(
        "strip model: at the {} of {:g} the patch reaches the end of the profiles; give "
        "profiles wider than the contact",
        quantity, target));
  // Bisected to the last digit, because the force jumps where two patches merge.
  const StripNormalSolution solution =
      solve(contact::bracketed_root([&](double g) { return solve(g).*value / target - 1.0; }, 0.0,
                                    available, 0.0, "strip model: penetration"));
  const double error = std::abs(solution.*value / target - 1.0);
  if (error > 1e-6)
    throw contact::SolveError(
        fmt::format("strip model: no penetration gives the {} of {:g}, because two patches merge "
                    "there (closest: a relative error of {:.2g}); use the model halfspace",
                    quantity, target, error));
  return solution;
}

// The model "strip": a case by the strip theory of strip.hpp.

/// Extent of the strips, in semi-axes of Hertz's ellipse.
constexpr double reach = 1.25;

/// Strips over all y at which the profiles overlap at the half-space's approach.
StripProfile profile_of_patch(const contact::Scene& scene, int strips) {
  const halfspace::PatchSearch search(scene);
  const halfspace::ExpectedPatch& expected = search.patch();
  const halfspace::Box overlap = search.ridge().overlap(expected.approach).box;
  const double lower = overlap.y_lower;
  const double upper = overlap.y_upper;
  const int count =
      std::max(4, contact::count_of(std::round(strips * (upper - lower) / expected.width),
                                    "strips (strip.strips)"));
  StripProfile profile;
  profile.width = (upper - lower) / count;
  profile.y_first = lower + 0.5 * profile.width;
  for (int j = 0; j < count; ++j) {
    const halfspace::RidgePoint point =
        halfspace::ridge_point(*scene.geometry.surface.profiles, profile.y(j));
    profile.distance.push_back(point.distance);
    profile.curvature.push_back(point.curvature);
    profile.middle.push_back(point.x);
  }
  return profile;
}

/// Profile of the radii or the patch of a case; with a patch, over the y at which the distance is
/// below the approach of expected_patch, beyond which there is no contact.
StripProfile strip_profile(const contact::Scene& scene, int strips,
                           const std::optional<double>& virtual_penetration) {
  if (scene.has_profiles()) return profile_of_patch(scene, strips);
  const contact::Curvatures curvatures = halfspace::curvatures_of_scene(scene);
  const halfspace::HertzContact hertz = halfspace::hertz_of_scene(scene);
  // The undeformed surfaces may overlap more widely than Hertz's ellipse.
  const double half_overlap =
      std::sqrt(virtual_penetration.value_or(0.0) * hertz.approach / curvatures.B);
  const double half_width = reach * std::max(hertz.semi_axis_y, half_overlap);
  const int count = std::max(4, static_cast<int>(std::lround(reach * strips)));
  StripProfile profile;
  profile.width = 2.0 * half_width / count;
  profile.y_first = -half_width + 0.5 * profile.width;
  for (int j = 0; j < count; ++j) {
    const double y = profile.y_first + j * profile.width;
    profile.distance.push_back(contact::undeformed_distance(curvatures, 0.0, y));
    profile.curvature.push_back(curvatures.A);
  }
  return profile;
}

struct StripContact {
  const contact::Scene& scene;
  contact::ChartedGeometry geometry;
  StripProfile profile;
  StripNormalSolution normal;
};

StripContact strip_contact(const contact::Scene& scene, int strips,
                           const std::optional<double>& virtual_penetration) {
  StripContact contact{scene,
                       contact::ChartedGeometry(scene.geometry, contact::Chart::plane),
                       strip_profile(scene, strips, virtual_penetration),
                       {}};
  const StripLaw law{scene.material.contact_modulus, virtual_penetration};
  const contact::NormalLoad load = contact::largest_load(scene);
  contact.normal = load.force ? strips_for_force(contact.profile, law, *load.force)
                              : strips_for_approach(contact.profile, law, load.approach.value());
  return contact;
}

/// The parabola of the same friction force as mu times the elliptic pressure of the strip.
BrushStrip brush_strip(const StripSection& section, double y, double friction) {
  return {y, section.half_length, 3.0 * pi / 8.0 * friction * section.max_pressure,
          BoundShape::parabolic, section.middle};
}

contact::Field strip_pressure(const StripContact& contact, const contact::ContactGrid& grid) {
  contact::Field pressure = contact::Field::Zero(grid.size());
  for (int j = 0; j < grid.ny; ++j) {
    const StripSection section = strip_section(contact.profile, contact.normal, grid.y(j));
    for (int i = 0; i < grid.nx; ++i) {
      const double t = (grid.x(i) - section.middle) / section.half_length;
      if (std::abs(t) < 1.0)
        pressure[grid.index(i, j)] = section.max_pressure * std::sqrt((1.0 - t) * (1.0 + t));
    }
  }
  return pressure;
}

/// The squares of the half lengths are linear between the strips and up to the edges.
double contact_area(const StripContact& contact) {
  double area = 0.0;
  const auto add = [&area](double width, double a, double b) {
    if (a + b > 0.0) area += 4.0 / 3.0 * width * (a * a + a * b + b * b) / (a + b);
  };
  for (const StripPatch& patch : contact.normal.patches) {
    double y = patch.y_lower;
    double length = 0.0;
    for (int j = patch.first; j <= patch.last; ++j) {
      add(contact.profile.y(j) - y, length, contact.normal.half_length[j]);
      y = contact.profile.y(j);
      length = contact.normal.half_length[j];
    }
    add(patch.y_upper - y, length, 0.0);
  }
  return area;
}

contact::PointResult normal_part(const StripContact& contact, const contact::ContactGrid& grid) {
  const StripNormalSolution& normal = contact.normal;
  contact::PointResult point;
  point.fields =
      resting_fields(grid, strip_pressure(contact, grid), contact.scene.friction_coefficient());
  point.normal_force = normal.normal_force;
  point.approach = normal.approach;
  const auto largest = [](const std::vector<double>& v) {
    return *std::max_element(v.begin(), v.end());
  };
  point.max_pressure = largest(normal.max_pressure);
  point.semi_axis_x = largest(normal.half_length);
  point.contact_length = 2.0 * point.semi_axis_x;
  point.contact_width = normal.patches.back().y_upper - normal.patches.front().y_lower;
  point.semi_axis_y = 0.5 * point.contact_width;
  point.contact_area = contact_area(contact);
  point.patch_count = static_cast<int>(normal.patches.size());
  point.adhesion_area = point.contact_area;
  if (contact.scene.has_profiles()) {
    const int deepest = normal.patches.front().deepest;
    point.patch_x_middle = contact.profile.middle[deepest];
    point.patch_y_middle = 0.5 * (normal.patches.front().y_lower + normal.patches.back().y_upper);
  }
  return point;
}

BrushProblem brush_problem(const StripContact& contact, const StripPatch& patch,
                           const contact::Creepage& creepage, int elements) {
  return {contact.geometry, creepage,
          kalker_flexibilities(patch.semi_axis_x, patch.semi_axis_y,
                               contact.scene.material.shear_modulus,
                               contact.scene.material.poisson_ratio),
          elements};
}

/// The grid of the scene with more elements around it where strips reach beyond it.
contact::ContactGrid grid_around(const StripContact& contact) {
  const halfspace::PatchSearch search(contact.scene);
  const contact::ContactGrid grid = search.grid();
  double more = 0.0;
  for (int j = 0; j < contact.profile.size(); ++j) {
    const double half = contact.normal.half_length[j], y = contact.profile.y(j);
    const double x = contact.profile.middle.empty() ? 0.0 : contact.profile.middle[j];
    if (half > 0.0)
      more = std::max({more, (grid.x_first - x + half) / grid.dx, (grid.y_first - y) / grid.dy,
                       (x + half - grid.x(grid.nx - 1)) / grid.dx,
                       (y - grid.y(grid.ny - 1)) / grid.dy});
  }
  constexpr int margin = 4;
  return more > 0.0 ? search.grid(grid.dx, grid.dy, margin + static_cast<int>(more)) : grid;
}

/// The strips of one patch.
StripAt strips_in(const StripContact& contact, const StripPatch& patch) {
  return [&](double y) -> BrushStrip {
    if (y < patch.y_lower || y > patch.y_upper) return {y, 0.0, 0.0, BoundShape::parabolic, 0.0};
    return brush_strip(strip_section(contact.profile, contact.normal, y), y,
                       contact.scene.friction_coefficient());
  };
}

BrushTotals strip_totals(const StripContact& contact, const contact::Creepage& creepage,
                         int elements) {
  BrushTotals totals;
  for (const StripPatch& patch : contact.normal.patches) {
    std::vector<StripPlace> places;
    for (int j = patch.first; j <= patch.last; ++j)
      places.push_back({contact.profile.y(j), contact.profile.width});
    add_strips(brush_problem(contact, patch, creepage, elements), strips_in(contact, patch), places,
               totals);
  }
  return totals;
}

/// From half as many strips. Sizes end at a boundary within a strip, so their bar is the full
/// change.
void estimate_normal_errors(const contact::PointResult& coarse, contact::PointResult& normal) {
  const auto estimate = [&](const char* name, double part) {
    normal.error_estimate[name] =
        part * std::abs(contact::quantity(normal, name) - contact::quantity(coarse, name));
  };
  for (const char* name : {"max_pressure", "normal_force", "approach"}) estimate(name, 1.0 / 3.0);
  for (const char* name : {"semi_axis_x", "semi_axis_y", "contact_area"}) estimate(name, 1.0);
  if (normal.patch_x_middle && coarse.patch_x_middle)
    for (const char* name : {"patch_x_middle", "patch_y_middle"}) estimate(name, 1.0);
}

}  // namespace

StripNormalSolution strips_at_penetration(const StripProfile& profile, const StripLaw& law,
                                          double penetration) {
  const double level = smallest_distance(profile) + penetration;
  StripNormalSolution solution;
  solution.half_length.assign(profile.size(), 0.0);
  solution.max_pressure.assign(profile.size(), 0.0);
  solution.penetration = penetration;
  double deepest = 0.0;
  for (int j = 0; j < profile.size(); ++j) {
    if (!(overlap(profile, j, level) > 0.0)) continue;
    StripPatch patch = find_patch(profile, j, level);
    (law.virtual_penetration ? solve_by_penetration : solve_as_hertz)(profile, law, level, patch,
                                                                      solution);
    if (overlap(profile, patch.deepest, level) > deepest) {
      deepest = overlap(profile, patch.deepest, level);
      solution.approach = patch.approach;
    }
    solution.patches.push_back(patch);
    j = patch.last;
  }
  return solution;
}

StripNormalSolution strips_for_force(const StripProfile& profile, const StripLaw& law,
                                     double normal_force) {
  return find_penetration(profile, law, normal_force, "normal force",
                          &StripNormalSolution::normal_force);
}

StripNormalSolution strips_for_approach(const StripProfile& profile, const StripLaw& law,
                                        double approach) {
  return find_penetration(profile, law, approach, "approach", &StripNormalSolution::approach);
}

StripSection strip_section(const StripProfile& profile, const StripNormalSolution& solution,
                           double y) {
  const double position = (y - profile.y_first) / profile.width;
  if (!(position >= 0.0) || position > profile.size() - 1) return {};
  const int j = std::min(static_cast<int>(position), profile.size() - 2);
  const double weight = position - j;
  const auto at = [&](const std::vector<double>& values) {
    const double square =
        (1.0 - weight) * values[j] * values[j] + weight * values[j + 1] * values[j + 1];
    return std::sqrt(square);
  };
  const double middle = profile.middle.empty()
                            ? 0.0
                            : (1.0 - weight) * profile.middle[j] + weight * profile.middle[j + 1];
  return {at(solution.half_length), at(solution.max_pressure), middle};
}

contact::ModelResult run_strip(const contact::Scene& scene, const contact::Progress& progress) {
  const auto& options = scene.options.of<StripOptions>();
  if (options.strips < 8 || options.strip_elements < 4)
    throw contact::InputError("the strip model needs at least 8 strips of 4 elements");
  const StripContact fine = strip_contact(scene, options.strips, options.virtual_penetration);
  const StripContact coarse = strip_contact(scene, options.strips / 2, options.virtual_penetration);
  const contact::ContactGrid grid = grid_around(fine);
  contact::PointResult normal = normal_part(fine, grid);
  estimate_normal_errors(normal_part(coarse, grid), normal);
  long unknowns = 0;
  const auto fill = [&](contact::PointResult& point) {
    contact::Field rows = contact::Field::Zero(grid.ny);
    for (const StripPatch& patch : fine.normal.patches)
      rows += fill_brush_fields(grid,
                                brush_problem(fine, patch, point.creepage, options.strip_elements),
                                strips_in(fine, patch), point);
    const BrushTotals totals = strip_totals(fine, point.creepage, options.strip_elements);
    set_totals(totals, grid, rows, point);
    const int order = point.creepage.spin == 0.0 ? 2 : 1;
    estimate_error(totals, strip_totals(coarse, point.creepage, options.strip_elements / 2), order,
                   point);
    unknowns = 2 * totals.elements;
  };
  const auto transmitted = [&](const contact::Creepage& creepage) -> contact::TransmittedForce {
    const halfspace::CreepForces forces =
        strip_totals(fine, creepage, options.strip_elements).forces;
    return {{forces.longitudinal, forces.lateral},
            scene.friction_coefficient() * normal.normal_force};
  };
  contact::ModelResult result = run_theory(with_creepages_of_forces(scene, transmitted), grid,
                                           normal, "strip", progress, fill);
  result.unknowns = unknowns;
  result.notes.push_back(
      {"bars",
       "strip model: error estimates cover the resolution only; no gap outside the contact"});
  if (options.virtual_penetration)
    contact::add_note(result.notes, "virtual_penetration",
                      "virtual penetration of {:g} of the approach: an elliptic patch agrees with "
                      "Hertz only at its own value of this fraction",
                      *options.virtual_penetration);
  return result;
}

namespace {

void add_strip_keys() {
  using contact::between, contact::otherwise;
  contact::Keys<StripOptions> keys("strip", "Model `strip`");
  keys.add("strips", &StripOptions::strips, between(16, 2000), "Strips across the patch.");
  keys.add("strip_elements", &StripOptions::strip_elements, between(4, 2000),
           "Elements along each strip.");
  keys.add("virtual_penetration", &StripOptions::virtual_penetration, between(0.3, 1.0),
           otherwise("from the equivalent ellipse"),
           "Penetration of the undeformed profiles over approach, which defines the patch; Kik and "
           "Piotrowski: 0.55.");
  keys.section().position = 2;
  contact::add_section(keys);
}

}  // namespace

contact::ModelInfo strip_model() {
  using contact::Demand;
  contact::ModelInfo model = theory(
      "strip", "strip", "strips along rolling, each with Hertzian pressure and brushes",
      {Demand::tangential_force, Demand::profiles, Demand::sections, Demand::lateral_creepage,
       Demand::spin, Demand::extra_slip, Demand::extra_slip_on_profiles},
      with_pass_work([](const contact::Scene& scene, const contact::Progress& progress) {
        return run_each_load(run_strip, scene, progress);
      }),
      {true, false});
  model.add_keys = add_strip_keys;
  model.refinements = {
      refined_strips<StripOptions, &StripOptions::strips, &StripOptions::strip_elements>()};
  model.own_bound = model.in_compare = true;
  return model;
}

}  // namespace rollfem::theories
