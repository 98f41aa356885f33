#include "halfspace/model/model.hpp"

#include "contact/base/available_memory.hpp"
#include "contact/base/count.hpp"
#include "contact/base/errors.hpp"
#include "contact/result/quantities.hpp"
#include "contact/result/refinement.hpp"
#include "contact/scene/geometry.hpp"
#include "halfspace/closed_forms/hertz.hpp"
#include "halfspace/model/level.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

namespace rollfem::halfspace {

using contact::ModelResult;
using contact::PointResult;
using contact::Scene;

namespace {

/// How a quantity converges, measured (tests/verification/halfspace_normal.cpp and
/// halfspace_rolling.cpp) with n elements across.
struct Convergence {
  double order;
  double floor;  ///< coefficient of the smallest error believed: two grids may agree by chance
  double floor_power;
};
constexpr Convergence smooth{2.0, 0.1, 2.0};      ///< pressure, approach
constexpr Convergence patch_size{1.0, 0.5, 2.0};  ///< not evenly, between 1 and 2
/// Forces of partial slip converge with order 1.5 to 2 on the whole, but unevenly: the change is
/// taken as if the order were 1.
constexpr Convergence partial_slip{1.0, contact::least_rolling_error, 1.0};

/// Below this many elements across, a coarser level helps nobody.
constexpr int fewest_elements_across = 10;

struct Cell {
  double dx;
  double dy;
  int across;  ///< elements along the smaller side of the patch
};

Cell finest_cell(const Scene& scene, const AreaOfPatch& area) {
  const auto [length, width] = area.extent();
  if (scene.contact_grid.cell_size) {
    const auto& [dx, dy] = *scene.contact_grid.cell_size;
    return {dx, dy,
            contact::count_of(std::min(length / dx, width / dy),
                              "elements across the patch (contact_grid.cell_size)")};
  }
  const int across = scene.contact_grid.elements_across;
  return {length / across, width / across, across};
}

/// The finest level last. There are always two, for the error estimate; a history gains nothing
/// from more, for its steps start from each other.
std::vector<Cell> cells_of_levels(const Scene& scene, const AreaOfPatch& area) {
  std::vector<Cell> cells{finest_cell(scene, area)};
  while (cells.size() < 2 ||
         (!scene.is_history() && cells.back().across / 2 >= fewest_elements_across)) {
    const Cell& fine = cells.back();
    cells.push_back({2.0 * fine.dx, 2.0 * fine.dy, fine.across / 2});
  }
  std::reverse(cells.begin(), cells.end());
  return cells;
}

/// Discretisation error of the finer of two values; the smallest one believed is a part of it, or
/// of `scale` where that is larger.
double two_level_error(double fine, double coarse, double scale, const Convergence& convergence,
                       int across) {
  const double reference = std::max(std::abs(fine), scale);
  if (reference == 0.0 || (fine == 0.0 && coarse == 0.0)) return 0.0;
  const double change = std::abs(fine - coarse) / (std::pow(2.0, convergence.order) - 1.0);
  const double floor = convergence.floor /
                       std::pow(static_cast<double>(std::max(across, 1)), convergence.floor_power);
  return std::max(contact::uneven_safety * change, floor * reference);
}

void estimate_errors(PointResult& fine, const PointResult& coarse, double friction, int across) {
  const auto set = [&](const char* name, const Convergence& convergence) {
    const double value = contact::quantity(fine, name);
    const double before = contact::quantity(coarse, name);
    const double scale =
        0.01 * contact::full_sliding(contact::quantity_named(name), fine, friction);
    fine.error_estimate[name] = two_level_error(value, before, scale, convergence, across);
    fine.richardson[name] = value + (value - before) / (std::pow(2.0, convergence.order) - 1.0);
  };
  // Without an adhesion area tractions are the bound, as smooth as the pressure.
  const Convergence& rolling =
      fine.adhesion_area == 0.0 && coarse.adhesion_area == 0.0 ? smooth : partial_slip;
  for (const char* name : {"max_pressure", "normal_force", "approach"}) set(name, smooth);
  for (const char* name : {"semi_axis_x", "semi_axis_y", "contact_area"}) set(name, patch_size);
  for (const char* name : {"longitudinal_force", "lateral_force", "spin_moment",
                           "traction_coefficient", "max_traction_x"})
    set(name, rolling);
}

/// Creepages found for a prescribed force carry an error, where given ones do not.
void estimate_found_creepages(PointResult& fine, const PointResult& coarse,
                              const contact::PrescribedForce& wanted, int across) {
  const contact::Creepage& a = fine.creepage;
  const contact::Creepage& b = coarse.creepage;
  const double scale = 0.01 * std::hypot(a.longitudinal, a.lateral);
  if (wanted.longitudinal)
    fine.error_estimate["longitudinal_creepage"] =
        two_level_error(a.longitudinal, b.longitudinal, scale, partial_slip, across);
  if (wanted.lateral)
    fine.error_estimate["lateral_creepage"] =
        two_level_error(a.lateral, b.lateral, scale, partial_slip, across);
}

/// A given extent need not hold the patch on coarser elements, which reach farther than it by a
/// part of one and are fewer than the whole ones that fit: there it is two larger on each side.
Scene with_room(Scene scene, const Cell& cell) {
  if (auto& extent = scene.contact_grid.extent; extent && !scene.geometry.distance_values) {
    (*extent)[0] += 4.0 * cell.dx;
    (*extent)[1] += 4.0 * cell.dy;
  }
  return scene;
}

/// Friction on a tilted plane carries a part of the load.
bool shares_load(const Scene& scene) {
  return std::any_of(scene.points.begin(), scene.points.end(), [](const contact::LoadPoint& point) {
    return point.load.direction[0] != 0.0;
  });
}

/// A level that only helps the finer ones: none where its elements do not fit, or where no state
/// of unlike materials is found on it: the finest one says so if there is none. Past the limit of
/// Nadal each level says so itself: without a start from coarser ones the finest may come upon a
/// balance at many times the load.
std::optional<contact::LevelResult> coarser_level(const Scene& scene, const AreaOfPatch& area,
                                                  const Cell& cell,
                                                  const contact::LevelResult* start,
                                                  const std::string& prefix,
                                                  const contact::Progress& progress,
                                                  const GridElasticity& elasticity) {
  try {
    const Scene roomy = with_room(scene, cell);
    return solve_level(roomy, scene.contact_grid.extent ? AreaOfPatch(roomy) : area, cell.dx,
                       cell.dy, start, prefix, progress, nullptr, elasticity);
  } catch (const contact::UnfitGrid&) {
    return {};
  } catch (const contact::SolveError&) {
    // Only between unlike materials may one grid have a state that is found and another none.
    if (shares_load(scene) || !scene.material.couples()) throw;
    return {};
  } catch (const contact::InputError&) {
    return {};  // they may reach beyond the points of a file
  }
}

void add_notes(const Scene& scene, ModelResult& result) {
  const bool first = scene.upwind_order == contact::UpwindOrder::first;
  result.notes.push_back(fmt::format(
      "elastic half-spaces; contact elements of {:.4g} by {:.4g} mm with constant tractions; "
      "{}-order upwind difference along rolling{}",
      result.grid.dx, result.grid.dy, first ? "first" : "second",
      first ? ", the spin taken a sixth of its step upstream, as CONTACT does" : ""));
  result.notes.push_back(
      "error estimates: 1.5 times the change between this grid and one of twice the cells, divided "
      "by 3 for pressure, force and approach (order 2), by 1 for the rest (order 1); for the "
      "forces of partial slip at least 0.15 over the number of elements across");
  if (scene.follows_surface > 0.0 && scene.follows_surface < 1.0)
    result.notes.push_back(fmt::format(
        "the normals of this contact spread too much for one plane and little for a curved "
        "surface: it lies on a surface between both, with {:.2f} of the slopes of the common "
        "surface",
        scene.follows_surface));
  if (scene.follows_surface > 0.0)
    result.notes.push_back(
        "curved contact, as halfspace.surface or the spread of the normals asks for: y of the "
        "contact grid and contact_width are arc lengths along the common surface, tractions along "
        "its local tangents and normal, forces along x, y, z; compliance of the surface rolled out "
        "flat; normal_force holds the part of the tangential tractions along z, which the given "
        "force leaves out");
  const double difference = scene.material.difference;
  if (std::abs(difference) > 1e-12)
    result.notes.push_back(fmt::format(
        "unlike materials, K = {:.4g}: normal and tangential problem coupled; iterations are outer "
        "ones",
        difference));
}

/// Errors of the finest level so far from the one below it.
void estimate_level(const Scene& scene, contact::LevelResult& fine,
                    const contact::LevelResult& coarse, int across) {
  for (std::size_t k = 0; k < fine.points.size(); ++k) {
    estimate_errors(fine.points[k], coarse.points[k], scene.friction_coefficient(), across);
    estimate_found_creepages(fine.points[k], coarse.points[k], scene.points[k].force, across);
  }
}

/// Largest resident memory, measured with 42 to 165 thousand elements and up to 10 load points:
/// this within 15 %, for unlike materials up to two thirds more.
double predicted_bytes(double elements, double points) {
  constexpr double program = 30e6, per_element = 1300.0, per_element_and_point = 200.0;
  return program + elements * (per_element + per_element_and_point * points);
}

void refuse_beyond_memory(const Scene& scene, const contact::ContactGrid& grid) {
  const double points = static_cast<double>(scene.points.size());
  const double needed = predicted_bytes(grid.size(), points);
  const double available = contact::available_bytes();
  if (needed <= available) return;
  throw contact::SolveError(fmt::format(
      "this run needs about {} and {} are available: {:.3g} million elements of the contact grid "
      "and {} load points, whose fields are kept; do: take fewer elements "
      "(contact_grid.elements_across or cell_size), or fewer load points",
      contact::in_gigabytes(needed), contact::in_gigabytes(available), 1e-6 * grid.size(), points));
}

/// Beyond this many elements across nothing is refined further for an accuracy.
constexpr int most_elements_across = 320;

/// Whether another level is wanted for the accuracy of the case; says in the result when it is and
/// cannot be had.
bool refine_further(const Scene& scene, const contact::LevelResult& fine, const Cell& cell,
                    ModelResult& result) {
  if (!scene.accuracy.relative) return false;
  const contact::WorstError worst =
      contact::worst_error(scene.accuracy, scene.friction_coefficient(), fine.points);
  if (worst.error <= *scene.accuracy.relative) {
    result.notes.push_back(
        fmt::format("accuracy {:g} asked for: {} elements across; largest estimated error {}",
                    *scene.accuracy.relative, cell.across, worst.text()));
    return false;
  }
  if (2 * cell.across <= most_elements_across) return true;
  result.shortfall = contact::shortfall_text(
      scene.accuracy, worst,
      fmt::format("{} elements across are the most; do: ask for less, or give a smaller "
                  "contact_grid.cell_size",
                  cell.across));
  return false;
}

}  // namespace

ModelResult run_halfspace(const Scene& scene, const contact::Progress& progress,
                          contact::Checkpoint* checkpoint, const GridElasticity& elasticity) {
  const auto begin = std::chrono::steady_clock::now();
  std::optional<contact::LevelResult> coarse;
  std::optional<contact::LevelResult> fine;
  const AreaOfPatch area(scene);
  std::vector<Cell> cells = cells_of_levels(scene, area);
  area.check_shape_of_cells(cells.back().dx, cells.back().dy);
  // A grid too large to have is refused before the coarser ones are computed.
  refuse_beyond_memory(scene, area.grid(cells.back().dx, cells.back().dy, 0));
  ModelResult result;
  result.name = elasticity.model;
  for (std::size_t level = 0; level < cells.size(); ++level) {
    const Cell cell = cells[level];
    coarse = std::move(fine);
    const bool last = level + 1 == cells.size();
    const std::string prefix =
        last && !scene.accuracy.relative ? "" : fmt::format("{} across: ", cell.across);
    const contact::LevelResult* start = coarse ? &*coarse : nullptr;
    fine = last ? solve_level(scene, area, cell.dx, cell.dy, start, prefix, progress, checkpoint,
                              elasticity)
                : coarser_level(scene, area, cell, start, prefix, progress, elasticity);
    if (!fine) continue;
    result.seconds["setup"] += fine->setup_seconds;
    result.seconds["normal"] += fine->normal_seconds;
    result.seconds["tangential"] += fine->tangential_seconds;
    if (!last) continue;
    if (!coarse && !scene.accuracy.relative) {
      result.notes.push_back(
          "no error estimates: elements of twice the size do not hold the patch on the given grid, "
          "or no solution was found on them");
      break;
    }
    if (coarse) estimate_level(scene, *fine, *coarse, cell.across);
    if (!coarse || refine_further(scene, *fine, cell, result))
      cells.push_back({0.5 * cell.dx, 0.5 * cell.dy, 2 * cell.across});
  }
  result.grid = fine->grid;
  result.contact_elements = fine->contact_elements;
  result.unknowns = 3L * fine->contact_elements;
  result.points = std::move(fine->points);
  add_notes(scene, result);
  result.seconds["total"] =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

}  // namespace rollfem::halfspace
