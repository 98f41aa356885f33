// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/model/halfspace_model.hpp"

#include "base/available_memory.hpp"
#include "base/count.hpp"
#include "base/errors.hpp"
#include "base/progress.hpp"
#include "contact/solve/side_by_side.hpp"
#include "contact/solve/state_record.hpp"
#include "halfspace/closed_forms/hertz.hpp"
#include "halfspace/elasticity/preconditioned_elasticity.hpp"
#include "halfspace/model/error_bars.hpp"
#include "halfspace/model/step_errors.hpp"
#include "halfspace/model/step_lattice.hpp"
#include "halfspace/patch/coverage.hpp"
#include "halfspace/patch/patch_search.hpp"
#include "halfspace/stress/stress_maxima.hpp"
#include "halfspace/stress/subsurface.hpp"
#include "result/derived.hpp"
#include "result/free_ends.hpp"
#include "result/heat/temperature.hpp"
#include "result/quantities.hpp"
#include "result/refinement.hpp"
#include "result/validity.hpp"
#include "scene/geometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace rollfem::halfspace {

using contact::ContactGrid;
using contact::ModelInput;
using contact::ModelResult;
using contact::PatchSize;
using contact::PointResult;
using contact::RefinedInput;
using contact::Refinement;
using contact::Scene;

namespace {

/// Elements of a line contact have its full width on every level.
double factor_across(const Scene& scene, double factor) {
  return scene.geometry.line ? 1.0 : factor;
}

/// Below this many elements across, a coarser level is not worth solving.
constexpr int fewest_elements_across = 10;

struct Cell {
  double dx;
  double dy;
  int across;  ///< elements along the smaller side of the patch
};

Cell finest_cell(const Scene& scene, const PatchSearch& area) {
  const auto [length, width] = area.extent();
  if (scene.contact_grid.cell_size) {
    const auto& [dx, dy] = *scene.contact_grid.cell_size;
    return {dx, dy,
            contact::count_of(scene.geometry.line ? length / dx : std::min(length / dx, width / dy),
                              "elements across the patch (contact_grid.cell_size)")};
  }
  const int across = scene.contact_grid.elements_across;
  return {length / across, scene.geometry.line ? width : width / across, across};
}

/// Fewest elements across of a level used only for error bars.
constexpr int fewest_for_bars = 4;

/// The finest level last: always two, for the error bars, and a third one if possible. More do not
/// help a history, because its steps start from each other.
std::vector<Cell> cells_of_levels(const Scene& scene, const PatchSearch& area) {
  std::vector<Cell> cells{finest_cell(scene, area)};
  if (scene.past) {
    const auto [length, width] = area.extent();
    cells.clear();
    for (const contact::PastLevel& level : scene.past->levels)
      cells.push_back({level.cell[0], level.cell[1],
                       static_cast<int>(std::min(length / level.cell[0], width / level.cell[1]))});
    return cells;
  }
  const auto another = [&] {
    const int across = cells.back().across / 2;
    return cells.size() < 2 || (cells.size() < 3 && across >= fewest_for_bars) ||
           (!scene.is_history() && across >= fewest_elements_across);
  };
  while (another()) {
    const Cell& fine = cells.back();
    cells.push_back({2.0 * fine.dx, factor_across(scene, 2.0) * fine.dy, fine.across / 2});
  }
  std::reverse(cells.begin(), cells.end());
  return cells;
}

/// Whether the level after one with these cells starts from its solution; `last`: the finest level.
/// A level used only for error bars must not influence the start of the others.
bool is_a_start(const Scene& scene, const Cell& cell, bool last) {
  return last || (!scene.is_history() && cell.across >= fewest_elements_across);
}

/// A given extent need not hold the patch on coarser elements, because fewer whole elements fit
/// into it and the patch reaches further by a fraction of an element: there the grid has two more
/// on each side.
Scene with_room(Scene scene, const Cell& cell) {
  if (auto& extent = scene.contact_grid.extent; extent && !scene.geometry.distance_values) {
    (*extent)[0] += 4.0 * cell.dx;
    if (!scene.geometry.line) (*extent)[1] += 4.0 * cell.dy;
  }
  return scene;
}

SearchDetail detail_for(const Scene& scene) {
  return scene.contact_grid.cell_size ? SearchDetail::box : SearchDetail::extents;
}

/// A level that only helps the finer ones: skipped if its elements do not fit, or if no solution
/// for unlike materials is found on it; the finest level reports an error if it has none. Beyond
/// Nadal's limit every level reports the error, because without a start from coarser levels the
/// finest may find a balance at many times the load. `dispensable`: no level starts from it.
std::optional<contact::LevelResult> coarser_level(const Scene& scene, const PatchSearch& area,
                                                  const Cell& cell,
                                                  const contact::LevelResult* start,
                                                  bool dispensable,
                                                  const contact::Progress& progress,
                                                  const GridElasticity& elasticity) {
  try {
    const Scene roomy = with_room(scene, cell);
    return solve_level(
        roomy, scene.contact_grid.extent ? PatchSearch(roomy, detail_for(scene)) : area, cell.dx,
        cell.dy, start, fmt::format("{} across: ", cell.across), progress, nullptr, elasticity);
  } catch (const contact::UnfitGrid&) {
    return {};
  } catch (const contact::SolveError&) {
    // Only for unlike materials may one grid have a solution and another none.
    if (!dispensable && (scene.shares_load() || !scene.material.couples())) throw;
    return {};
  } catch (const contact::InputError&) {
    return {};  // they may extend beyond the points of a file
  }
}

std::string discretisation_words(const Scene& scene) {
  const bool first = scene.upwind_order == contact::UpwindOrder::first;
  const char* order = first ? "first" : "second";
  const char* spin = first ? ", the spin taken a sixth of its step upstream, as in CONTACT" : "";
  switch (scene.problem) {
    case contact::Problem::frictionless:
      return "with constant pressure; normal problem only";
    case contact::Problem::shift:
      return "with constant tractions; shift without rolling";
    case contact::Problem::transient:
      return fmt::format(
          "with constant tractions; transient rolling{}, {}-order difference over the "
          "steps{}",
          scene.starts_steady ? " from a steady state, the first step" : "", order, spin);
    case contact::Problem::steady:
      break;
  }
  return fmt::format("with constant tractions; {}-order upwind difference along rolling{}", order,
                     spin);
}

void add_seconds(const contact::LevelResult& level, ModelResult& result) {
  result.seconds["setup"] += level.setup_seconds;
  result.seconds["normal"] += level.normal_seconds;
  result.seconds["tangential"] += level.tangential_seconds;
}

void add_notes(const Scene& scene, ModelResult& result) {
  contact::tell_of_heat(scene, result);
  contact::add_note(result.notes, "grid",
                    "elastic half-spaces; contact elements of {:.4g} by {:.4g} mm {}",
                    result.grid.dx, result.grid.dy, discretisation_words(scene));
  result.notes.push_back(
      {"bars",
       "error bars: from grids with cells of this, twice and four times the size, and from the "
       "solution near edges and peaks; they hold in about 95 of 100 random contacts "
       "(docs/accuracy.md)"});
  if (const auto& line = scene.geometry.line)
    contact::add_note(
        result.notes, "line_contact",
        "line contact: endless rollers in plane strain; forces, moments, areas and "
        "work refer to a width of {:g} mm; displacements are relative to {}",
        line->width,
        std::isinf(line->reference)
            ? "distant points, in the middle of this width"
            : fmt::format("the surface at {:g} mm from a line load", line->reference));
  if (scene.follows_surface > 0.0 && scene.follows_surface < 1.0)
    contact::add_note(result.notes, "partly_curved",
                      "the normals of this contact spread too much for a plane and too little for "
                      "the full curved surface: the grid lies on a surface in between, with {:.2f} "
                      "of the slopes of the common surface",
                      scene.follows_surface);
  if (scene.follows_surface > 0.0)
    result.notes.push_back(
        {"curved",
         "curved contact, because of halfspace.surface or the spread of the normals: y of the "
         "contact grid and contact_width are arc lengths along the common surface, tractions along "
         "its local tangents and normal, forces along x, y, z; compliance of the unrolled surface; "
         "normal_force includes the tangential tractions along z, which the given force does not"});
  const double difference = scene.material.difference;
  if (std::abs(difference) > 1e-12)
    contact::add_note(result.notes, "unlike_materials",
                      "unlike materials, K = {:.4g}: normal and tangential problem are coupled; "
                      "iterations are outer iterations",
                      difference);
}

/// The finest level so far and the coarser ones; null if missing.
struct Levels {
  std::optional<contact::LevelResult> coarsest, coarse, fine;

  void push(std::optional<contact::LevelResult> finer) {
    coarsest = std::move(coarse);
    coarse = std::move(fine);
    fine = std::move(finer);
  }
  const PointResult* coarsest_point(std::size_t k) const {
    return coarsest && contact::is_solved(coarsest->points[k]) ? &coarsest->points[k] : nullptr;
  }
};

bool solved_twice(const Levels& levels, std::size_t k) {
  return levels.coarse && contact::is_solved(levels.coarse->points[k]) &&
         contact::is_solved(levels.fine->points[k]);
}

/// Returns a warning where waves of rough profiles are too short for the elements.
std::string set_bars(const Scene& scene, Levels& levels) {
  const contact::ContactGrid& grid = levels.fine->grid;
  std::optional<WaveErrors> waves;
  std::string warning;
  for (std::size_t k = 0; k < levels.fine->points.size(); ++k) {
    PointResult& point = levels.fine->points[k];
    if (!solved_twice(levels, k)) continue;
    if (!waves || scene.is_history() || !(scene.points[k].load == scene.points[k - 1].load))
      waves = wave_errors(scene, k, grid, point);
    set_error_bars(scene, k, grid, levels.coarse->points[k], levels.coarsest_point(k), point,
                   waves ? &*waves : nullptr);
    // At a sharp end no elements follow the profile.
    if (waves && warning.empty() && contact::loaded_ends(scene, grid, point).ends.empty())
      warning = wave_warning(grid, point, *waves);
  }
  return warning;
}

/// The finest level, or one that helps it.
std::optional<contact::LevelResult> level_of(const Scene& scene, const PatchSearch& area,
                                             const std::vector<Cell>& cells, std::size_t level,
                                             const contact::LevelResult* start,
                                             const contact::Progress& progress,
                                             contact::Checkpoint* checkpoint,
                                             const GridElasticity& elasticity) {
  const Cell& cell = cells[level];
  if (level + 1 == cells.size())
    return solve_level(scene, area, cell.dx, cell.dy, start,
                       scene.accuracy.relative ? fmt::format("{} across: ", cell.across) : "",
                       progress, checkpoint, elasticity);
  return coarser_level(scene, area, cell, start,
                       !is_a_start(scene, cell, level + 2 == cells.size()), progress, elasticity);
}

/// The bars of a step of a wheel's history from the length of its steps.
void count_doubled_step(const Scene& scene, const Cell& cell, Levels& levels,
                        const contact::Progress& progress, const GridElasticity& elasticity,
                        ModelResult& result) {
  if (!scene.past->doubled) return;
  const contact::DoubledStep& doubled = *scene.past->doubled;
  Scene merged = on_lattice(scene, doubled.level);
  merged.points.front().step_length = doubled.step_length;
  merged.points.front().creepage = doubled.creepage;
  std::optional<contact::LevelResult> whole;
  if (levels.coarse)
    whole = coarser_level(merged, PatchSearch(merged, detail_for(merged)), cell, nullptr, true,
                          progress, elasticity);
  scene.past->left->push_back(whole ? left_by(*whole) : contact::PastPatch());
  // Of order 1 the change is the error; on coarse elements it is up to a quarter smaller.
  if (whole)
    add_step_errors(levels.coarse->points, whole->points, {0}, 1.5, levels.fine->points);
  else
    result.notes.push_back({"steps", steps_left_out});
}

/// On cells of twice the size, because with four elements across the changes are uneven; the
/// accuracy asked for must hold with these errors too.
void count_steps(const Scene& scene, const PatchSearch& area, const std::vector<Cell>& cells,
                 Levels& levels, const contact::Progress& progress,
                 const GridElasticity& elasticity, ModelResult& result) {
  if (scene.past && cells.size() > 1)
    return count_doubled_step(scene, cells[cells.size() - 2], levels, progress, elasticity, result);
  if (scene.problem != contact::Problem::transient || scene.past || !levels.coarse) return;
  const DividedSteps steps = divided_steps(scene, area.extent().length);
  const auto divided = coarser_level(steps.scene, area, cells[cells.size() - 2], nullptr, true,
                                     progress, elasticity);
  if (!divided) {
    result.notes.push_back({"steps", steps_left_out});
    return;
  }
  add_step_errors(levels.coarse->points, divided->points, steps.ends, 2.0, levels.fine->points);
  if (!scene.accuracy.relative || !result.shortfall.empty()) return;
  const contact::WorstError worst =
      contact::worst_error(scene.accuracy, scene.friction_coefficient(), levels.fine->points);
  if (worst.error > *scene.accuracy.relative)
    result.shortfall = contact::shortfall_text(
        scene.accuracy, worst, "the steps are too long; do: give a smaller history.step_length");
}

/// Subsurface stresses requested by the case, with their error bars.
void add_stresses(const Scene& scene, const GridElasticity& elasticity, Levels& levels,
                  ModelResult& result) {
  const bool maxima = scene.output.stress_maxima;
  if (!scene.asks_for_stress() && !elasticity.add_stresses) return;
  const contact::Stopwatch watch;
  for (auto* level : {&levels.coarsest, &levels.coarse, &levels.fine}) {
    if (!*level) continue;
    for (PointResult& point : (*level)->points) {
      if (!contact::is_solved(point)) continue;
      if (elasticity.add_stresses) {
        elasticity.add_stresses((*level)->grid, point);
        continue;
      }
      point.subsurface = subsurface_fields(scene, (*level)->grid, point.fields.traction);
      if (maxima) point.stress_maxima = stress_maxima(scene, (*level)->grid, point);
    }
  }
  const double element = levels.fine->grid.longer_side();
  for (std::size_t k = 0; k < levels.fine->points.size(); ++k) {
    if (!solved_twice(levels, k)) continue;
    mark_near_surface(1.5 * element, levels.fine->points[k]);
    mark_near_surface(2.2 * element, levels.coarse->points[k]);
    set_stress_bars(levels.fine->grid, levels.coarse->points[k], levels.coarsest_point(k),
                    levels.fine->points[k]);
  }
  result.seconds["subsurface"] = watch.seconds();
}

/// Half-spaces stay elastic.
void note_yielding(const Scene& scene, const Levels& levels, ModelResult& result) {
  if (!scene.yields()) return;
  const auto maxima = stress_maxima(scene, levels.fine->grid, levels.fine->points.front());
  for (const contact::StressMaximum& maximum : maxima) {
    const auto& steel = (maximum.body == "wheel" ? scene.wheel : scene.rail).plasticity;
    if (!steel || maximum.measure != "von_mises" || maximum.value <= steel->yield_stress) continue;
    contact::add_note(
        result.notes, fmt::format("yield_{}", maximum.body),
        "the half-space is elastic: the largest von Mises stress in the {} is {:.4g} "
        "MPa, {:.3g} times the yield stress; model fem takes plastic flow into account",
        maximum.body, maximum.value, maximum.value / steel->yield_stress);
  }
}

/// Largest resident memory, measured with 42 to 165 thousand elements and up to 10 load points:
/// within 15 % of this, for unlike materials up to two thirds more.
double predicted_bytes(double elements, double points) {
  constexpr double program = 30e6, per_element_and_point = 200.0;
  return program + elements * (contact::bytes_per_element + per_element_and_point * points);
}

void refuse_beyond_memory(const Scene& scene, const contact::ContactGrid& grid) {
  const double points = static_cast<double>(scene.points.size());
  const double needed = predicted_bytes(grid.size(), points);
  const double available = contact::available_bytes();
  if (needed <= available) return;
  throw contact::SolveError(fmt::format(
      "this run needs about {} and {} are available: {:.3g} million elements of the contact grid "
      "and {} load points with stored fields; do: use fewer elements (contact_grid.elements_across "
      "or cell_size), or fewer load points",
      contact::in_gigabytes(needed), contact::in_gigabytes(available), 1e-6 * grid.size(), points));
}

/// Largest number of elements across for a requested accuracy.
constexpr int most_elements_across = 320;

contact::Rung rung_of(const Scene& scene, const PatchSearch& area, const Cell& cell) {
  contact::Rung rung{fmt::format("{} elements across", cell.across), "", true};
  if (2 * cell.across > most_elements_across)
    rung.no_finer = rung.cells +
                    " are the maximum; do: request less accuracy, or give a smaller "
                    "contact_grid.cell_size";
  try {
    if (scene.accuracy.relative)
      refuse_beyond_memory(scene, area.grid(0.5 * cell.dx, factor_across(scene, 0.5) * cell.dy, 0));
  } catch (const contact::SolveError& error) {
    rung.no_finer = error.what();
  }
  return rung;
}

// Refinement levels of the half-space in a study.

RefinedInput grid_level(ModelInput input, int k, int /*n*/) {
  const double factor = std::exp2(k - 2);
  if (auto& cell = input.contact_grid.cell_size) {
    (*cell)[0] /= factor;
    if (!input.geometry.line) (*cell)[1] /= factor;
    const double side = (*cell)[0];
    return {fmt::format("{:.4g} mm", side), side, std::move(input)};
  }
  const int across = input.contact_grid.elements_across =
      std::max(contact::fewest_elements_across, input.contact_grid.elements_across / 4) << k;
  return {fmt::format("{} across", across), static_cast<double>(across), std::move(input)};
}

/// Transient rolling uses values up to two steps upstream.
int columns_for_steps(const Scene& scene, const PatchSearch& area, double dx) {
  if (scene.problem != contact::Problem::transient || scene.past || scene.contact_grid.extent ||
      scene.geometry.distance_values)
    return 0;
  double longest = 0.0;
  for (const contact::LoadPoint& point : scene.points)
    longest = std::max(longest, point.step_length);
  const double extent = area.extent().length;
  return contact::count_of(std::ceil(std::min(2.0 * longest, extent) / dx),
                           "columns covering two steps (history.step_length, contact_grid)");
}

class HalfspaceElasticity : public PreconditionedElasticity {
 public:
  HalfspaceElasticity(const Scene& scene, const contact::ChartedGeometry& geometry,
                      Halfspaces halfspaces)
      : PreconditionedElasticity(scene, std::move(halfspaces)),
        scene_(scene),
        geometry_(geometry) {}

  void check_patch(const PatchSize& found) const override {
    PatchSize patch = found;
    contact::cut_at_ends(scene_, patch);
    check_profiles_reach(scene_, geometry_.lateral_place(patch.y_lower),
                         geometry_.lateral_place(patch.y_upper));
  }

 private:
  const Scene& scene_;
  const contact::ChartedGeometry& geometry_;
};

std::string why_no_grid_holds(const Scene& scene, const contact::ChartedGeometry& geometry,
                              const ContactGrid& grid) {
  const double border = geometry.lateral_place(grid.y(grid.ny - 1));
  if (geometry.curved()) {
    const std::string why = contact::why_flanks_touch(geometry.geometry(), border);
    if (!why.empty()) return why;
  }
  const bool pulled = scene.friction() != nullptr && scene.material.couples();
  return fmt::format(
      "the contact patch reaches the border of the potential contact area ({} by {} elements), or "
      "the bodies touch beyond it: {}; do: give a larger contact_grid.extent",
      grid.nx, grid.ny,
      pulled ? "friction of unlike bodies moves and widens the patch, or the surfaces conform over "
               "a wider area than their curvatures suggest"
             : "the surfaces conform over a wider area than their curvatures suggest");
}

}  // namespace

ModelResult run_halfspace(const Scene& scene, const contact::Progress& progress,
                          contact::Checkpoint* checkpoint, const GridElasticity& elasticity) {
  const contact::Stopwatch watch;
  Levels levels;
  const PatchSearch area(scene, detail_for(scene));
  std::vector<Cell> cells = cells_of_levels(scene, area);
  area.check_shape_of_cells(cells.back().dx, cells.back().dy);
  // A grid too large for memory is rejected before the coarser ones are computed.
  refuse_beyond_memory(scene, area.grid(cells.back().dx, cells.back().dy, 0));
  ModelResult result;
  std::string warning;
  result.name = elasticity.model;
  if (scene.past) scene.past->left->clear();
  for (std::size_t level = 0; level < cells.size(); ++level) {
    const Cell cell = cells[level];
    const bool last = level + 1 == cells.size();
    const contact::LevelResult* start =
        levels.fine && is_a_start(scene, cells[level - 1], last) ? &*levels.fine : nullptr;
    const auto solved = [&](const Scene& here, const PatchSearch& around) {
      return level_of(here, around, cells, level, start, progress, checkpoint, elasticity);
    };
    if (scene.past) {
      const Scene here = on_lattice(scene, scene.past->levels[level]);
      levels.push(solved(here, PatchSearch(here, detail_for(here))));
      scene.past->left->push_back(levels.fine ? left_by(*levels.fine) : contact::PastPatch());
    } else {
      levels.push(solved(scene, area));
    }
    if (!levels.fine) continue;
    add_seconds(*levels.fine, result);
    if (!last) continue;
    if (!levels.coarse && !scene.accuracy.relative) {
      result.notes.push_back(
          {"no_bars",
           "no error estimates: the given grid cannot contain the patch with elements of twice the "
           "size, or has no solution with them"});
      break;
    }
    if (levels.coarse) warning = set_bars(scene, levels);
    if (!levels.coarse ||
        contact::refine_further(scene.accuracy, scene.friction_coefficient(),
                                rung_of(scene, area, cell), levels.fine->points, result))
      cells.push_back({0.5 * cell.dx, factor_across(scene, 0.5) * cell.dy, 2 * cell.across});
  }
  count_steps(scene, area, cells, levels, progress, elasticity, result);
  add_stresses(scene, elasticity, levels, result);
  note_yielding(scene, levels, result);
  contact::LevelResult& fine = *levels.fine;
  result.grid = fine.grid;
  result.contact_elements = fine.contact_elements;
  result.unknowns = 3L * fine.contact_elements;
  contact::warn_of_steep_friction(fine, scene.friction(), result.notes);
  result.points = std::move(fine.points);
  contact::place_pass_work(halfspace_geometry(scene), scene.place, result);
  add_notes(scene, result);
  if (!warning.empty()) result.notes.push_back({"waves", std::move(warning)});
  result.seconds["total"] = watch.seconds();
  if (fine.unsolved.empty()) return result;
  const std::string why =
      fmt::format("{} of {} load points are left empty, because they have no solution: {}",
                  fine.unsolved.size(), scene.points.size(), fine.unsolved.begin()->second);
  result.shortfall = why;
  result.notes.push_back({"unsolved", why, contact::Note::warning});
  throw contact::PartlySolved(why, std::move(result));
}

Scene on_few_elements(Scene scene, int elements_across) {
  if (!scene.geometry.distance_values) {
    scene.contact_grid = {};
    scene.contact_grid.elements_across = elements_across;
  }
  scene.accuracy = {};
  scene.subsurface.clear();
  scene.output.stress_maxima = false;
  return scene;
}

Refinement contact_grid() {
  return {"grid", "", "contact grid", 2.0, 5, false, grid_level};
}

std::unique_ptr<contact::Elasticity> halfspace_elasticity(const Scene& scene,
                                                          const contact::ChartedGeometry& geometry,
                                                          const ContactGrid& grid) {
  return halfspace_elasticity_of(scene, geometry, Halfspaces(scene.material, grid));
}

std::unique_ptr<contact::Elasticity> halfspace_elasticity_of(
    const Scene& scene, const contact::ChartedGeometry& geometry, Halfspaces halfspaces) {
  return std::make_unique<HalfspaceElasticity>(scene, geometry, std::move(halfspaces));
}

contact::LevelResult solve_level(const Scene& scene, const PatchSearch& area, double dx, double dy,
                                 const contact::LevelResult* coarser,
                                 const std::string& stage_prefix, const contact::Progress& progress,
                                 contact::Checkpoint* checkpoint,
                                 const GridElasticity& elasticity) {
  const contact::ChartedGeometry geometry = halfspace_geometry(scene);
  contact::RunOptions options;
  options.model = elasticity.model;
  options.stage_prefix = stage_prefix;
  options.force_accuracy = accuracy_of_force_search;
  options.coarser = coarser;
  // The balance of a wheel needs all load points.
  options.independent = elasticity.independent_points;
  options.leaves_unsolved = elasticity.independent_points && !scene.place;
  ContactGrid grid =
      area.grid(dx, dy, free_elements).widened(columns_for_steps(scene, area, dx), 0);
  constexpr int most_enlargements = 4;
  for (int attempt = 0;; ++attempt) {
    std::optional<contact::PointStore> store;
    if (checkpoint)
      store.emplace(*checkpoint, fmt::format("{}-{}x{}", elasticity.model, grid.nx, grid.ny));
    if (scene.past) options.inherited = inherited_on(scene, geometry, grid);
    std::optional<contact::LevelResult> result =
        contact::solve_points(scene, geometry, options, progress, store ? &*store : nullptr, grid,
                              [&] { return elasticity.make(scene, geometry, grid); });
    if (result) {
      const ContactGrid larger = grid_of_all_patches(scene, geometry, area, grid, result->points);
      if (larger.ny == grid.ny) return *std::move(result);
      grid = larger;
      if (attempt < most_enlargements && !scene.contact_grid.extent) continue;
    }
    if (attempt == most_enlargements || scene.contact_grid.extent)
      throw contact::UnfitGrid(why_no_grid_holds(scene, geometry, grid));
    grid = grid.widened(grid.nx / 4 + free_elements, grid.ny / 4 + free_elements);
  }
}

}  // namespace rollfem::halfspace
