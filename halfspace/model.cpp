#include "halfspace/model.hpp"

#include "contact/errors.hpp"
#include "contact/geometry.hpp"
#include "halfspace/hertz.hpp"
#include "halfspace/level.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

namespace rollfem::halfspace {

using contact::Case;
using contact::ModelResult;
using contact::PointResult;

namespace {

/// Orders of the discretisation, measured (tests/verification/halfspace_normal.cpp,
/// halfspace_rolling.cpp): two for pressure and approach; forces of steady rolling and the patch
/// size converge between first and second order and not evenly.
constexpr double smooth_order = 2.0;
constexpr double rolling_order = 1.0;
/// Estimates are made larger by this factor, as is usual for two grids (Roache 1994).
constexpr double safety = 1.25;

/// Below this many elements across, a coarser level helps nobody.
constexpr int fewest_elements_across = 10;

struct Cell {
  double dx;
  double dy;
  int across;  ///< elements along the smaller side of the patch
};

Cell finest_cell(const Case& input) {
  const HertzContact hertz = hertz_of_case(input);
  const double length = 2.0 * hertz.semi_axis_x;
  const double width = 2.0 * hertz.semi_axis_y;
  if (input.contact_grid.cell_size) {
    const auto& [dx, dy] = *input.contact_grid.cell_size;
    return {dx, dy, static_cast<int>(std::min(length / dx, width / dy))};
  }
  const int across = input.contact_grid.elements_across;
  return {length / across, width / across, across};
}

/// The finest level last. There are always two, for the error estimate.
std::vector<Cell> cells_of_levels(const Case& input) {
  std::vector<Cell> cells{finest_cell(input)};
  while (cells.size() < 2 || cells.back().across / 2 >= fewest_elements_across) {
    const Cell& fine = cells.back();
    cells.push_back({2.0 * fine.dx, 2.0 * fine.dy, fine.across / 2});
  }
  std::reverse(cells.begin(), cells.end());
  return cells;
}

void check(const Case& input) {
  const contact::CombinedMaterial material =
      contact::combine(input.wheel.material, input.rail.material);
  if (std::abs(material.difference) > 1e-12)
    throw contact::InputError(fmt::format(
        "{}: model halfspace: wheel and rail are of unlike materials (K = {:.4g}): normal and "
        "tangential problem are coupled, which this model does not do yet; allowed: equal "
        "young_modulus and poisson_ratio; do: run with --model fem",
        input.file, material.difference));
}

/// Discretisation error of the finer of two values, relative to it or to `scale` where that is
/// larger (a quantity that vanishes has no relative error). `floor`: no estimate is better, for the
/// two values may agree by chance.
double two_level_error(double fine, double coarse, double scale, double order, double floor) {
  const double reference = std::max(std::abs(fine), scale);
  if (reference == 0.0) return 0.0;
  const double change = std::abs(fine - coarse) / (std::pow(2.0, order) - 1.0);
  return std::max(safety * change / reference, floor);
}

void estimate_errors(PointResult& fine, const PointResult& coarse, double friction, int across) {
  const double element = 1.0 / std::max(across, 1);
  const auto set = [&](const char* name, double PointResult::*quantity, double scale,
                       double order) {
    const double floor = (order == smooth_order ? 0.1 : 0.5) * element * element;
    fine.error_estimate[name] =
        two_level_error(fine.*quantity, coarse.*quantity, scale, order, floor);
  };
  const double sliding = friction * fine.normal_force;
  set("max_pressure", &PointResult::max_pressure, 0.0, smooth_order);
  set("normal_force", &PointResult::normal_force, 0.0, smooth_order);
  set("approach", &PointResult::approach, 0.0, smooth_order);
  set("semi_axis_x", &PointResult::semi_axis_x, 0.0, rolling_order);
  set("semi_axis_y", &PointResult::semi_axis_y, 0.0, rolling_order);
  set("contact_area", &PointResult::contact_area, 0.0, rolling_order);
  set("longitudinal_force", &PointResult::longitudinal_force, 0.01 * sliding, rolling_order);
  set("lateral_force", &PointResult::lateral_force, 0.01 * sliding, rolling_order);
  set("spin_moment", &PointResult::spin_moment,
      0.01 * sliding * std::sqrt(fine.semi_axis_x * fine.semi_axis_y), rolling_order);
  set("traction_coefficient", &PointResult::traction_coefficient, 0.01 * friction, rolling_order);
  set("max_traction_x", &PointResult::max_traction_x, 0.01 * friction * fine.max_pressure,
      rolling_order);
}

void add_notes(const Case& input, ModelResult& result) {
  result.notes.push_back(fmt::format(
      "elastic half-spaces; contact elements of {:.4g} by {:.4g} mm with constant tractions; "
      "{}-order upwind difference along rolling",
      result.grid.dx, result.grid.dy,
      input.rolling.upwind_order == contact::UpwindOrder::first ? "first" : "second"));
  result.notes.push_back(
      "error estimates: 1.25 times the change between this grid and one of twice the cells, "
      "divided "
      "by 3 for pressure, force and approach (order 2), by 1 for the rest (order 1)");
}

}  // namespace

ModelResult run_halfspace(const Case& input, const contact::Progress& progress) {
  const auto begin = std::chrono::steady_clock::now();
  check(input);
  std::optional<LevelResult> coarse;
  std::optional<LevelResult> fine;
  const std::vector<Cell> cells = cells_of_levels(input);
  ModelResult result;
  result.name = "halfspace";
  for (const Cell& cell : cells) {
    coarse = std::move(fine);
    const bool last = &cell == &cells.back();
    const std::string prefix = last ? "" : fmt::format("{} across: ", cell.across);
    fine = solve_level(input, cell.dx, cell.dy, coarse ? &*coarse : nullptr, prefix, progress);
    result.seconds["setup"] += fine->setup_seconds;
    result.seconds["normal"] += fine->normal_seconds;
    result.seconds["tangential"] += fine->tangential_seconds;
  }
  for (std::size_t k = 0; k < fine->points.size(); ++k)
    estimate_errors(fine->points[k], coarse->points[k], input.friction_coefficient,
                    cells.back().across);
  result.grid = fine->grid;
  result.contact_elements = fine->normal.contact_elements;
  result.unknowns = 3L * fine->normal.contact_elements;
  result.points = std::move(fine->points);
  add_notes(input, result);
  result.seconds["total"] =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

}  // namespace rollfem::halfspace
