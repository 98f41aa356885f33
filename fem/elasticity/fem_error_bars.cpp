// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/elasticity/fem_error_bars.hpp"

#include "base/errors.hpp"
#include "contact/solve/side_by_side.hpp"
#include "fem/mesh/run_layout.hpp"
#include "fem/plasticity/pass_results.hpp"
#include "halfspace/model/error_bars.hpp"
#include "halfspace/model/halfspace_model.hpp"
#include "halfspace/model/step_errors.hpp"
#include "result/free_ends.hpp"
#include "result/quantities.hpp"
#include "result/refinement.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <string>
#include <utility>

namespace rollfem::fem {

namespace {

using contact::ContactGrid;
using contact::LevelResult;
using contact::ModelResult;
using contact::PointResult;
using contact::Scene;

/// Default order of finite elements relative to the half-space, where levels do not show one.
constexpr double assumed_order = 1.5;

/// Limits of the finest grid of half-spaces, which takes seconds per load point.
constexpr int most_elements = 200'000;

ContactGrid refined(const ContactGrid& grid) {
  return {2 * grid.nx,
          2 * grid.ny,
          0.5 * grid.dx,
          0.5 * grid.dy,
          grid.x_first - 0.25 * grid.dx,
          grid.y_first - 0.25 * grid.dy};
}

/// With a margin for the larger extent of elements of twice the size; counts on a lattice are even.
ContactGrid coarsened(const ContactGrid& grid) {
  constexpr int room = 2;
  const ContactGrid coarse{grid.nx / 2,
                           grid.ny / 2,
                           2.0 * grid.dx,
                           2.0 * grid.dy,
                           grid.x_first + 0.5 * grid.dx,
                           grid.y_first + 0.5 * grid.dy};
  return coarse.widened(room, room);
}

/// Whether grids of elements of twice the size resolve this patch.
bool allows_coarsening(const ModelResult& level) {
  constexpr double fewest_across = 7.5;
  return std::all_of(level.points.begin(), level.points.end(), [&](const PointResult& point) {
    return 2.0 * std::min(point.semi_axis_x / level.grid.dx, point.semi_axis_y / level.grid.dy) >=
           fewest_across;
  });
}

/// Half-space solutions on the grids of the levels, from coarse to fine.
class HalfspaceLevels {
 public:
  explicit HalfspaceLevels(Scene scene)
      : scene_(std::move(scene)), geometry_(scene_.geometry, contact::Chart::projected) {}

  /// Null without a solution on this grid.
  const LevelResult* solve(const ContactGrid& grid) {
    contact::RunOptions options;
    options.model = "halfspace";
    options.force_accuracy = halfspace::accuracy_of_force_search;
    options.independent = true;
    if (!levels_.empty()) options.coarser = &levels_.back();
    const contact::Progress silent;
    std::optional<LevelResult> level;
    try {
      level = contact::solve_points(scene_, geometry_, options, silent, nullptr, grid, [&] {
        return halfspace::halfspace_elasticity(scene_, geometry_, grid);
      });
    } catch (const contact::SolveError&) {
      return nullptr;
    } catch (const contact::InputError&) {
      return nullptr;  // patches may extend beyond profiles that contain those of finite elements
    }
    if (!level) return nullptr;
    levels_.push_back(*std::move(level));
    return &levels_.back();
  }

 private:
  Scene scene_;
  contact::ChartedGeometry geometry_;
  std::deque<LevelResult> levels_;
};

/// Half-space solutions on the contact grids of the finite-element levels, and on a coarser and a
/// finer one.
struct Beside {
  HalfspaceLevels levels;
  std::vector<const LevelResult*> at;
  const LevelResult* coarsest = nullptr;  ///< of four times the finest elements; null: none
  const LevelResult* limit = nullptr;

  Beside(const Scene& scene, const std::vector<ModelResult>& finite) : levels(without(scene)) {
    const bool two = finite.size() == 2;
    if (two && allows_coarsening(finite.front()))
      coarsest = levels.solve(coarsened(finite.front().grid));
    for (const ModelResult& level : finite) at.push_back(levels.solve(level.grid));
    if (!two) coarsest = at[finite.size() - 3];
    const ContactGrid finer = refined(finite.back().grid), finest = refined(finer);
    limit = levels.solve(finer);
    if (limit == nullptr || finest.size() > most_elements) return;
    if (const LevelResult* finer_still = levels.solve(finest)) limit = finer_still;
  }
  bool complete() const {
    return limit != nullptr && std::all_of(at.begin(), at.end(), [](auto* of) { return of; });
  }

  /// Adds the error of the length of transient steps, measured with half-spaces on the second
  /// finest level.
  void count_steps(const Scene& scene, ModelResult& finest) const {
    if (scene.problem != contact::Problem::transient) return;
    if (const LevelResult* whole = at[at.size() - 2]) {
      double length = 0.0;
      for (const PointResult& point : whole->points)
        length = std::max(length, point.contact_length);
      const auto steps = halfspace::divided_steps(without(scene), length);
      HalfspaceLevels shorter(steps.scene);
      if (const LevelResult* divided = shorter.solve(whole->grid))
        return halfspace::add_step_errors(whole->points, divided->points, steps.ends, 2.0,
                                          finest.points);
    }
    finest.notes.push_back({"steps", halfspace::steps_left_out});
  }

 private:
  /// Finite-element bodies do not include other contacts of their wheel.
  static Scene without(Scene scene) {
    scene.neighbour_loads.clear();
    return scene;
  }
};

void set_point_bars(const Scene& scene, std::size_t k, const Beside& beside,
                    std::vector<ModelResult>& levels) {
  const std::size_t last = levels.size() - 1;
  PointResult half = beside.at[last]->points[k];
  halfspace::set_error_bars(scene, k, beside.at[last]->grid, beside.at[last - 1]->points[k],
                            beside.coarsest ? &beside.coarsest->points[k] : nullptr, half);
  for (const auto& [name, bar] : half.error_estimate) {
    const auto value = [&name = name](const PointResult& point) {
      return contact::quantity_named(name).value(point).value_or(0.0);
    };
    NumberOnLevels number;
    for (std::size_t level = 0; level <= last; ++level) {
      number.finite.push_back(value(levels[level].points[k]));
      number.half.push_back(value(beside.at[level]->points[k]));
    }
    number.half_bar = bar;
    number.half_fine = value(beside.limit->points[k]);
    levels[last].points[k].error_estimate[name] += bar_beside_half_spaces(number);
  }
  contact::explain_singular_values(scene, levels[last].grid, levels[last].points[k]);
}

}  // namespace

void set_pass_bars(const std::vector<PointResult>& coarse, double cell, bool surface_flows,
                   std::vector<PointResult>& fine) {
  // Counted over random loads with benchmark_fem_pass_bars (docs/plasticity.md).
  constexpr double safety = 1.25, least = 0.25, unresolved = 0.6;
  // What both meshes miss. In plane strain (5 k, friction 0.39) half as large cells change the
  // residual stress of the surface by 1.9 times cell / semi-axis. In 28 scenes in three dimensions
  // 96 % of the bars hold with this part of its square, 93 % with two thirds of it.
  constexpr double missed = 1.5;
  std::map<std::string, double> largest;
  double axis = 0.0;
  for (std::size_t k = 0; k < fine.size(); ++k) {
    axis = std::max(axis, std::min(fine[k].semi_axis_x, fine[k].semi_axis_y));
    const auto value = [k](const char* name, const std::vector<PointResult>& of) {
      return contact::quantity_named(name).value(of[k]).value_or(0.0);
    };
    for (const char* name : pass_quantities) {
      const double here = value(name, fine), change = std::abs(here - value(name, coarse));
      if (change > 0.0) largest[name] = std::max(largest[name], change / std::abs(here));
    }
    for (const std::string name : pass_quantities) {
      if (!contact::quantity_named(name).value(fine[k])) continue;
      // Steel that has flowed more is under more stress, and what lasts of the strain of a pass is
      // not better known than all of it.
      double of_strain = (name == "residual_stress" ? 1.0 : least) * largest["plastic_strain"];
      if (name == "net_plastic_increment")
        of_strain = std::max(of_strain, largest["plastic_increment"]);
      const double across = axis > 0.0 ? cell / axis : 0.0;
      const double of_cells =
          missed * (name == "residual_stress" && surface_flows ? across : across * across);
      const double part = std::max({largest[name], of_strain, of_cells});
      if (part > unresolved)
        fine[k].no_bar[name] = contact::NoBar::not_resolved;
      else
        fine[k].error_estimate[name] = safety * part * std::abs(value(name.c_str(), fine));
    }
  }
}

double bar_beside_half_spaces(const NumberOnLevels& number) {
  std::vector<double> apart;
  for (std::size_t level = 0; level < number.finite.size(); ++level)
    apart.push_back(number.finite[level] - number.half[level]);
  const double of_cells = contact::estimated_error(apart, assumed_order);
  const double known = number.half.back() - number.half_fine;
  // Edges and fronts of finite bodies lie elsewhere in the elements, so half-space errors there
  // must not reduce their bar.
  return std::sqrt(known * known + number.half_bar * number.half_bar + of_cells * of_cells);
}

bool set_error_bars(const Scene& scene, std::vector<ModelResult>& levels) {
  const std::size_t last = levels.size() - 1;
  // Half-spaces do not yield.
  std::optional<Beside> beside;
  if (!scene.yields()) beside.emplace(scene, levels);
  for (std::size_t k = 0; k < levels[last].points.size(); ++k) {
    PointResult& fine = levels[last].points[k];
    const PointResult& coarse = levels[last - 1].points[k];
    const PointResult* coarsest = last > 1 ? &levels[last - 2].points[k] : nullptr;
    if (fine.max_pressure == 0.0) {  // unloaded: only what plastic strain has left
      fine.error_estimate["approach"] += std::abs(fine.approach - coarse.approach);
    } else if (beside && beside->complete()) {
      set_point_bars(scene, k, *beside, levels);
    } else {
      const auto left_out = fine.error_estimate;
      halfspace::set_error_bars(scene, k, levels[last].grid, coarse, coarsest, fine);
      for (const auto& [name, bar] : left_out) fine.error_estimate[name] += bar;
      fine.richardson.clear();
    }
    halfspace::set_stress_bars(levels[last].grid, coarse, coarsest, fine);
  }
  if (scene.yields()) {
    const double cell = levels[last].grid.dy;
    const BodyOptions bodies = run_layout(scene, cell).bodies;
    const auto equal_rows = [&](bool is_wheel) {
      return options_of(scene, is_wheel, bodies).rows.equal_rows();
    };
    set_pass_bars(levels[last - 1].points, cell, !(equal_rows(true) && equal_rows(false)),
                  levels[last].points);
    compare_verdicts(levels[last - 1].points, levels[last].points, options_of(scene).thick_rows);
  }
  if (!beside) return false;
  beside->count_steps(scene, levels[last]);
  return beside->complete();
}

}  // namespace rollfem::fem
