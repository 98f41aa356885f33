// SPDX-License-Identifier: LGPL-2.1-or-later
#include "result/validity.hpp"

#include "base/errors.hpp"
#include "result/free_ends.hpp"
#include "result/patch_size.hpp"
#include "result/quantities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace rollfem::contact {

namespace {

/// Largest negative pressure due to rounding, relative to the largest pressure.
constexpr double rounding = 1e-6;

/// "load point 2 of 7: "
std::string place_of(const ValidatedPoint& at) {
  return fmt::format("load point {} of {}: ", at.index + 1, at.count);
}

[[noreturn]] void refuse(const ValidatedPoint& at, const std::string& wrong) {
  throw SolveError(place_of(at) + wrong);
}

template <class Values>
bool all_finite(const Values& values) {
  return std::all_of(values.begin(), values.end(), [](const auto& value) {
    return std::all_of(value.begin(), value.end(), [](double v) { return std::isfinite(v); });
  });
}

void check_scalars(const ValidatedPoint& at) {
  const PointResult& point = at.point;
  if (!point.converged)
    refuse(at, fmt::format("not converged, residual {:.3g}; do: use another grid or model",
                           point.residual));
  for (const Quantity& quantity : quantities()) {
    const double absent = quantity.member.may_be_absent ? 0.0 : std::nan("");
    const double value = quantity.value(point).value_or(absent);
    if (!std::isfinite(value))
      refuse(at, fmt::format("{} = {}; allowed: finite numbers; do: check the case for extremely "
                             "large or small values",
                             quantity.name, value));
  }
}

/// Checks displacements and stresses in the bodies, and the fields on the contact.
void check_fields(const ValidatedPoint& at) {
  const PointResult& point = at.point;
  const auto fail = [&](const std::string& what) {
    refuse(at,
           what + " that are not finite; do: check the case for extremely large or small values");
  };
  for (const PointField& field : point_fields())
    if (!field.value(point.fields).allFinite()) fail(std::string(field.name) + ": values");
  for (const SubsurfaceField& field : point.subsurface)
    if (!all_finite(field.stress) || !all_finite(field.displacement)) fail("stresses");
  for (const StressMaximum& maximum : point.stress_maxima)
    if (!std::isfinite(maximum.value)) fail("stresses");
  for (const BodyValues& body : point.bodies)
    if (!all_finite(body.stress) || !all_finite(body.displacement)) fail("stresses");
}

/// Columns and rows of the grid with an element under pressure.
std::array<Eigen::Index, 2> elements_across(const ContactGrid& grid, const Field& pressure) {
  const auto loaded = Eigen::Map<const Eigen::ArrayXXd>(pressure.data(), grid.nx, grid.ny) > 0.0;
  return {loaded.rowwise().any().count(), loaded.colwise().any().count()};
}

bool has_grid(const ValidatedPoint& at) {
  const ContactGrid& grid = at.grid;
  return grid.size() > 0 && at.point.fields.traction.n.size() == grid.size();
}

void check_fineness(const ValidatedPoint& at) {
  const ContactGrid& grid = at.grid;
  const auto [along, across] = elements_across(grid, at.point.fields.traction.n);
  if (at.given_grid || (grid.is_line() ? along : std::min(along, across)) >= fewest_elements_across)
    return;
  throw UnfitGrid(place_of(at) + few_elements_text(along, across, grid));
}

void check_held(const ValidatedPoint& at) {
  const PointResult& point = at.point;
  const ContactGrid& grid = at.grid;
  const double x = point.patch_x_middle.value_or(0.0);
  const double y = point.patch_y_middle.value_or(0.0);
  const auto beyond = [](double middle, double extent, double first, double cell, int count) {
    const double lower = first - 0.5 * cell;
    return std::max(lower - (middle - 0.5 * extent), middle + 0.5 * extent - lower - count * cell) /
           cell;
  };
  // A sampled pressure may fill the grid to its border; a solved one must end before.
  const bool held =
      at.kind.elastic
          ? at.ends_with_grid || !touches_border(grid, point.fields.traction.n)
          : std::max(beyond(x, point.contact_length, grid.x_first, grid.dx, grid.nx),
                     beyond(y, point.contact_width, grid.y_first, grid.dy, grid.ny)) < 1.0;
  if (!held)
    throw UnfitGrid(
        place_of(at) +
        fmt::format("the patch of {:.4g} by {:.4g} mm reaches beyond the contact grid of {:.4g} by "
                    "{:.4g} mm; allowed: a grid that contains the patch; do: choose a larger "
                    "contact_grid.extent, or move contact_grid.middle",
                    point.contact_length, point.contact_width, grid.nx * grid.dx,
                    grid.ny * grid.dy));
}

void check_bounds(const ValidatedPoint& at) {
  const ContactFields& fields = at.point.fields;
  const Field& pressure = fields.traction.n;
  if (pressure.size() == 0) return;
  const double largest = pressure.maxCoeff();
  if (pressure.minCoeff() < -rounding * largest)
    refuse(at, fmt::format("the pressure falls to {:.4g} MPa; allowed: 0 or more; do: please "
                           "report this case, it is a defect of the program",
                           pressure.minCoeff()));
  const auto [gap, excess] = contact_residual(fields);
  if (!(gap <= largest_residual.gap))
    refuse(at, fmt::format(
                   "the bodies are apart under pressure, or overlap beside it, by {:.2g} of the "
                   "largest displacement; allowed: at most {:g}; do: use another grid or model",
                   gap, largest_residual.gap));
  if (at.kind.bounded && !(excess <= largest_residual.excess))
    refuse(at, fmt::format("a tangential traction exceeds the bound of friction by {:.4g} MPa; "
                           "allowed: at most {:.2g} of the largest bound, {:.4g} MPa; do: please "
                           "report this case, it is a defect of the program",
                           excess * fields.traction_bound.maxCoeff(), largest_residual.excess,
                           fields.traction_bound.maxCoeff()));
}

void check_balance(const ValidatedPoint& at) {
  const NormalLoad& load = at.load;
  if (!load.force || *load.force == 0.0) return;
  const PointResult& point = at.point;
  const double carried =
      load.direction[0] * point.lateral_force + load.direction[1] * point.normal_force;
  const double imbalance = std::abs(carried / *load.force - 1.0);
  if (imbalance <= largest_imbalance) return;
  refuse(at, fmt::format("the patch carries {:.9g} N instead of {:.9g} N, a relative error of "
                         "{:.2g}; allowed: {:g}; do: use another grid or model",
                         carried, *load.force, imbalance, largest_imbalance));
}

/// Bodies under load must have a positive approach.
void check_approach(const ValidatedPoint& at) {
  if (!at.touching || at.point.approach > 0.0 || at.load.force == 0.0) return;
  refuse(at, fmt::format("the bodies have come together by {:.4g} mm and carry {:.6g} N; allowed: "
                         "more than 0; do: please report this case, it is a defect of the program",
                         at.point.approach, at.point.normal_force));
}

/// The largest value of a figure over the load points, for a warning.
struct Worst {
  double part = 0.0;
  std::size_t point = 0;
  std::string what;
  void raise(double candidate, std::size_t k, const std::string& text) {
    if (!(candidate > part)) return;
    part = candidate;
    point = k + 1;
    what = text;
  }
};

/// Sine of half the angle between the normals at both ends of the patch; at an end of a body, of
/// its surface before that end.
double slope_change(const HeightCurve& curve, const std::vector<FreeEnd>& ends, double middle,
                    double width) {
  double lower = middle - 0.5 * width, upper = middle + 0.5 * width;
  const double before = 0.01 * width;
  for (const FreeEnd& end : ends)
    if (end.y < middle)
      lower = std::max(lower, end.y + before);
    else
      upper = std::min(upper, end.y - before);
  const auto angle = [&](double y) { return std::atan(curve.at(y).slope); };
  return std::sin(0.5 * std::abs(angle(upper) - angle(lower)));
}

void compare_with_radii(const Scene& scene, const PointResult& point, std::size_t k, Worst& worst) {
  const ContactSurface& surface = scene.geometry.surface;
  const auto raise = [&](double extent, double radius, const char* body) {
    worst.raise(extent / std::abs(radius), k,
                fmt::format("half the patch, {:.4g} mm, against the {} of {:.4g} mm", extent, body,
                            std::abs(radius)));
  };
  raise(point.semi_axis_x, surface.rolling_radius, "rolling radius");
  raise(point.semi_axis_x, surface.rail_rolling_radius, "rolling radius of the rail");
  if (!scene.has_profiles()) {
    raise(point.semi_axis_y, surface.wheel_transverse_radius, "wheel's transverse radius");
    raise(point.semi_axis_y, surface.rail_transverse_radius, "rail's transverse radius");
    return;
  }
  const double middle = point.patch_y_middle.value_or(0.0);
  for (const auto& [curve, body] : {std::pair{&surface.profiles->rail(), "rail"},
                                    std::pair{&surface.profiles->wheel(), "wheel"}}) {
    const double part =
        slope_change(*curve, surface.profiles->free_ends(), middle, point.contact_width);
    worst.raise(part, k,
                fmt::format("the {} turns by {:.3g} rad across the patch of {:.4g} mm", body,
                            2.0 * std::asin(part), point.contact_width));
  }
}

double smallest_radius(const Scene& scene) {
  const ContactSurface& surface = scene.geometry.surface;
  const double rolling = std::min(surface.rolling_radius, std::abs(surface.rail_rolling_radius));
  if (scene.has_profiles()) return rolling;
  return std::min({rolling, std::abs(surface.wheel_transverse_radius),
                   std::abs(surface.rail_transverse_radius)});
}

}  // namespace

std::string few_elements_text(long along, long across, const ContactGrid& grid) {
  return fmt::format(
      "the patch has only {} by {} contact elements of {:.4g} by {:.4g} mm; allowed: at least {} "
      "in each direction; do: choose smaller elements (contact_grid.elements_across or cell_size, "
      "with the model fem fem.cell_size), or check load and radii",
      along, across, grid.dx, grid.dy, fewest_elements_across);
}

bool gives_grid(const Scene& scene) {
  return scene.contact_grid.cell_size && scene.contact_grid.extent;
}

bool ends_with_grid(const Scene& scene, const ContactGrid& grid) {
  const bool only_border = !grid.is_line() && std::min(grid.nx, grid.ny) < 3;
  return gives_grid(scene) && (only_border || scene.geometry.distance_values);
}

void check_point(const ValidatedPoint& at) {
  check_scalars(at);
  check_fields(at);
  const bool pressed = at.load.force != 0.0;
  if (has_grid(at)) {
    if (pressed) check_fineness(at);
    check_held(at);
  }
  check_bounds(at);
  check_balance(at);
  check_approach(at);
}

void check_validity(const Scene& scene, const ModelResult& result, const ResultKind& kind) {
  const std::size_t count = result.points.size();
  const bool touching = scene.geometry.has_surfaces() && !scene.given_pressure;
  for (std::size_t k = 0; k < count; ++k) {
    if (!is_solved(result.points[k])) continue;
    NormalLoad load;
    // A given pressure is the load; a model with one result for all load points uses the largest.
    if (!scene.given_pressure)
      load = count == scene.points.size() ? scene.points[k].load : largest_load(scene);
    check_point({result.grid, result.points[k], load, touching, kind, k, count, gives_grid(scene),
                 ends_with_grid(scene, result.grid)});
  }
}

namespace {

/// Part of the patch rolled in one step of a transient; with half of it, forces of a settled state
/// are about 1 % of mu N off, with twice of it 20 %.
constexpr double largest_step_part = 0.1;

void warn_of_long_steps(const Scene& scene, const ModelResult& result,
                        std::vector<Note>& warnings) {
  Worst step;
  for (std::size_t k = 0; k < result.points.size(); ++k) {
    const double length = result.points[k].contact_length;
    if (scene.problem_of(k) != Problem::transient || !(length > 0.0)) continue;
    if (scene.points[k].step_length <= result.grid.dx) continue;
    step.raise(scene.points[k].step_length / length, k,
               fmt::format("{:.4g} mm against {:.4g} mm", scene.points[k].step_length, length));
  }
  if (step.part > largest_step_part)
    add_warning(warnings, "step_length",
                "the wheel rolls over much of its patch in one step: {} (load point {}), a ratio "
                "of {:.2g} where an element or {:g} is usual; give a smaller history.step_length",
                step.what, step.point, step.part, largest_step_part);
}

/// Of grids that the case gives.
void warn_of_grid(const Scene& scene, const ModelResult& result, std::vector<Note>& warnings) {
  const ContactGrid& grid = result.grid;
  Worst fewest, border;
  for (std::size_t k = 0; k < result.points.size() && gives_grid(scene); ++k) {
    const Field& pressure = result.points[k].fields.traction.n;
    if (grid.size() == 0 || pressure.size() != grid.size()) continue;
    const auto [along, across] = elements_across(grid, pressure);
    const auto least = static_cast<double>(grid.is_line() ? along : std::min(along, across));
    fewest.raise(1.0 / std::max(1.0, least), k, fmt::format("{} by {}", along, across));
    if (touches_border(grid, pressure)) border.raise(1.0, k, "");
  }
  if (fewest.part > 1.0 / fewest_elements_across)
    add_warning(warnings, "few_elements",
                "the patch has only {} of the elements that the case gives (load point {}), where "
                "at least {} in each direction are usual: its numbers are those of the elements",
                fewest.what, fewest.point, fewest_elements_across);
  if (border.part > 0.0 && scene.geometry.distance_values)
    add_warning(warnings, "grid_border",
                "the patch reaches the border of the contact grid (load point {}), beyond which "
                "no undeformed distance is given: load that acts there is missing",
                border.point);
}

/// With the size of what half-spaces leave out at the ends of bodies; empty without loaded ends.
std::string free_end_text(const Scene& scene, const ModelResult& result) {
  LoadedEnds worst;
  for (const PointResult& point : result.points)
    if (LoadedEnds loaded = loaded_ends(scene, result.grid, point); loaded.share > worst.share)
      worst = std::move(loaded);
  if (worst.ends.empty()) return "";
  std::string places;
  for (const FreeEnd& end : worst.ends)
    places += fmt::format("{}the {} at y = {:.4g} mm", places.empty() ? "" : ", ",
                          end.of_wheel ? "wheel" : "rail", end.y);
  return fmt::format(
      "bodies end inside the patch ({}), beside which a half-space has material and they "
      "have none: {:.2g} % of the load lies within half the patch's length from these ends, where "
      "the pressure is too high",
      places, 100.0 * worst.share);
}

}  // namespace

std::vector<Note> validity_warnings(const Scene& scene, const ModelResult& result,
                                    const ResultKind& kind) {
  Worst patch, approach, pressure;
  const bool surfaces = scene.geometry.has_surfaces() && !scene.given_pressure;
  for (std::size_t k = 0; k < result.points.size(); ++k) {
    const PointResult& point = result.points[k];
    pressure.raise(point.max_pressure, k, "");
    if (!surfaces) continue;
    if (kind.half_spaces) compare_with_radii(scene, point, k, patch);
    approach.raise(
        point.approach / smallest_radius(scene), k,
        fmt::format("{:.4g} mm against {:.4g} mm", point.approach, smallest_radius(scene)));
  }
  std::vector<Note> warnings;
  if (patch.part > largest_patch_part)
    add_warning(warnings, "patch_size",
                "the patch is not small against the bodies, as half-spaces require: "
                "{} (load point {}), a ratio of {:.2g} where at most {:g} is usual; check load "
                "and radii, or use the models hybrid or fem, or auto, which chooses",
                patch.what, patch.point, patch.part, largest_patch_part);
  if (approach.part > largest_approach_part)
    add_warning(warnings, "approach",
                "the approach is not small against the radii, as linear elasticity "
                "requires: {} (load point {}), a ratio of {:.2g} where at most {:g} is usual; "
                "check load, radii and moduli",
                approach.what, approach.point, approach.part, largest_approach_part);
  if (pressure.part > largest_elastic_pressure)
    add_warning(warnings, "pressure",
                "the largest pressure, {:.4g} MPa (load point {}), exceeds {:g} MPa, which no "
                "rail or wheel steel carries elastically; check load, radii and their units",
                pressure.part, pressure.point, largest_elastic_pressure);
  warn_of_long_steps(scene, result, warnings);
  warn_of_grid(scene, result, warnings);
  if (kind.half_spaces)
    if (std::string text = free_end_text(scene, result); !text.empty())
      warnings.push_back({"free_ends", std::move(text), Note::warning});
  return warnings;
}

ContactResidual contact_residual(const ContactFields& fields) {
  ContactResidual residual;
  const Field& pressure = fields.traction.n;
  const Eigen::Index n = pressure.size();
  if (n == 0) return residual;
  if (fields.gap.size() == n && fields.displacement.n.size() == n) {
    double violation = 0.0;
    for (Eigen::Index k = 0; k < n; ++k)
      violation = std::max(violation, pressure[k] > 0.0 ? std::abs(fields.gap[k]) : -fields.gap[k]);
    const double displacement = fields.displacement.n.cwiseAbs().maxCoeff();
    if (violation > 0.0) residual.gap = violation / displacement;
  }
  const Field& bound = fields.traction_bound;
  if (bound.size() != n || fields.traction.x.size() != n || fields.traction.y.size() != n)
    return residual;
  double excess = 0.0;
  for (Eigen::Index k = 0; k < n; ++k)
    excess = std::max(excess, std::hypot(fields.traction.x[k], fields.traction.y[k]) - bound[k]);
  if (excess > 0.0) residual.excess = excess / bound.maxCoeff();
  return residual;
}

}  // namespace rollfem::contact
