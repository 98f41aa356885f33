#include "fem/model/model.hpp"

#include "contact/base/errors.hpp"
#include "contact/result/patch_size.hpp"
#include "contact/result/quantities.hpp"
#include "contact/result/refinement.hpp"
#include "fem/model/contact_run.hpp"
#include "fem/model/force_error.hpp"
#include "fem/model/run_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace rollfem::fem {

namespace {

using contact::ModelResult;
using contact::Scene;

/// The order in h that the two-level estimate assumes, measured on case a (docs/accuracy.md).
constexpr double assumed_order = 1.5;
/// Of the orders that three levels show.
constexpr double least_order = 1.0;

/// Where both ends of a patch are found is not surer than this, in elements: case a, whose axes are
/// known, is off by 0.005 on cells of an eighth of the semi-axis.
constexpr double least_edge_error = 0.01;

/// What a semi-axis may be off when its ends are counted by whole elements; else 0.
double counting_error(double semi_axis, double element) {
  const double elements = 2.0 * semi_axis / element;
  return elements < contact::elements_for_edge + 0.5 ? element : 0.0;
}

/// Of the largest stresses, and of the stresses at the points that the case asks for: the largest
/// change of a component.
void estimate_stress_errors(contact::PointResult& fine, const contact::PointResult& coarse) {
  const auto change = [](double of_fine, double of_coarse) {
    return contact::estimated_error({of_coarse, of_fine}, assumed_order, least_order);
  };
  for (std::size_t m = 0; m < fine.stress_maxima.size(); ++m) {
    const contact::StressMaximum& maximum = fine.stress_maxima[m];
    fine.error_estimate[fmt::format("max_{}_{}", maximum.measure, maximum.body)] =
        change(maximum.value, coarse.stress_maxima[m].value);
  }
  double largest = 0.0;
  for (std::size_t r = 0; r < fine.subsurface.size(); ++r)
    for (std::size_t k = 0; k < fine.subsurface[r].stress.size(); ++k)
      for (int c = 0; c < 6; ++c)
        largest = std::max(
            largest, change(fine.subsurface[r].stress[k][c], coarse.subsurface[r].stress[k][c]));
  if (!fine.subsurface.empty()) fine.error_estimate["subsurface_stress"] = largest;
}

/// From all levels, the finest last: two at least. Adds to what a point's estimate holds already
/// (the finite segments' part of the approach).
void estimate_errors(const Scene& scene, std::vector<ModelResult>& levels) {
  ModelResult& fine = levels.back();
  const ModelResult& coarse = levels[levels.size() - 2];
  for (std::size_t k = 0; k < fine.points.size(); ++k) {
    contact::PointResult& point = fine.points[k];
    for (const char* name : {"max_pressure", "normal_force", "approach", "semi_axis_x",
                             "semi_axis_y", "contact_area"}) {
      std::vector<double> values;
      for (const ModelResult& level : levels)
        values.push_back(contact::quantity(level.points[k], name));
      point.error_estimate[name] += contact::estimated_error(values, assumed_order, least_order);
    }
    // Two levels may agree by chance on what the shape of the pressure at the edges leaves open.
    const contact::PatchSize patch = contact::patch_size(fine.grid, point.fields.traction.n);
    auto& error = point.error_estimate;
    for (const auto& [name, size, element, unsure] :
         {std::tuple{"semi_axis_x", point.semi_axis_x, fine.grid.dx, patch.length_unsure},
          std::tuple{"semi_axis_y", point.semi_axis_y, fine.grid.dy, patch.width_unsure}})
      error[name] = std::max(
          {error[name], counting_error(size, element), 0.5 * unsure, least_edge_error * element});
    estimate_force_errors(scene, levels, k, assumed_order);
    estimate_stress_errors(point, coarse.points[k]);
  }
}

/// Cells of the start when the case gives accuracy and no cell size: parts of the smaller
/// semi-axis.
constexpr double parts_at_start = 8.0;

/// Cells larger than this part of the smaller semi-axis say nothing.
constexpr double coarsest_part = 0.55;

/// Those of the finest level alone are asked for.
void drop_bodies(ModelResult& level) {
  level.bodies.clear();
  for (contact::PointResult& point : level.points) point.bodies.clear();
}

/// Two levels alone can agree by chance, and cannot show an order.
constexpr std::size_t fewest_levels = 3;

/// Finest cells relative to those of the start.
constexpr int most_halvings = 5;

/// Halves the cells until the estimated error is what the case asks for, or memory ends.
ModelResult run_to_accuracy(const Scene& scene, const contact::Progress& progress,
                            contact::Checkpoint* checkpoint) {
  const double smaller_semi_axis = patch_box(scene).smaller();
  double cell = scene.fem.cell_size.value_or(smaller_semi_axis / parts_at_start);
  refuse_beyond_memory(scene, cell);
  const auto solve = [&](double size, bool fields) {
    return run_level(scene, {size, fmt::format("{:.3g} mm: ", size), fields, checkpoint}, progress);
  };
  std::vector<ModelResult> levels;
  if (4.0 * cell <= coarsest_part * smaller_semi_axis) levels.push_back(solve(4.0 * cell, false));
  levels.push_back(solve(2.0 * cell, false));
  levels.push_back(solve(cell, scene.output.fields));
  estimate_errors(scene, levels);
  const auto worst_of = [&] {
    return contact::worst_error(scene.accuracy, scene.friction_coefficient(), levels.back().points);
  };
  contact::WorstError worst = worst_of();
  std::string reason = fmt::format(
      "cells of {:.3g} mm are the finest tried; do: begin with a "
      "smaller [fem] cell_size, or ask for less",
      cell / std::exp2(most_halvings));
  for (int halving = 0; halving < most_halvings &&
                        (levels.size() < fewest_levels || worst.error > *scene.accuracy.relative);
       ++halving) {
    try {
      refuse_beyond_memory(scene, 0.5 * cell);
    } catch (const contact::SolveError& error) {
      reason = error.what();
      break;
    }
    cell *= 0.5;
    drop_bodies(levels.back());
    levels.push_back(solve(cell, scene.output.fields));
    estimate_errors(scene, levels);
    worst = worst_of();
  }
  ModelResult result = std::move(levels.back());
  result.notes.push_back(
      fmt::format("accuracy {:g} asked for: cells were halved to {:.4g} mm; largest estimated "
                  "error {}, from the changes between the last three levels and the order that "
                  "they show",
                  *scene.accuracy.relative, cell, worst.text()));
  if (worst.error > *scene.accuracy.relative || levels.size() < fewest_levels)
    result.shortfall = contact::shortfall_text(scene.accuracy, worst, reason);
  return result;
}

}  // namespace

ModelResult run_fem(const Scene& scene, const contact::Progress& progress,
                    contact::Checkpoint* checkpoint) {
  const auto begin = std::chrono::steady_clock::now();
  const auto elapsed = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  if (scene.accuracy.relative) {
    ModelResult result = run_to_accuracy(scene, progress, checkpoint);
    result.seconds["total"] = elapsed();
    return result;
  }
  const double cell = default_cell_size(scene);
  refuse_beyond_memory(scene, cell);
  std::vector<ModelResult> levels;
  levels.push_back(run_level(scene, {2.0 * cell, "estimate: ", false, checkpoint}, progress));
  const double estimate_seconds = elapsed();
  levels.push_back(run_level(scene, {cell, "", scene.output.fields, checkpoint}, progress));
  estimate_errors(scene, levels);
  ModelResult result = std::move(levels.back());
  result.seconds["estimate"] = estimate_seconds;
  result.seconds["total"] = elapsed();
  result.notes.push_back(fmt::format(
      "error estimates: change between cells of {:.4g} and {:.4g} mm divided by 2^{:.1f} - 1; of "
      "the forces of partial slip at least {:g} over the number of contact elements across; of the "
      "largest traction and the spin moment {:g} times the change",
      2.0 * cell, cell, assumed_order, contact::least_rolling_error, contact::uneven_safety));
  return result;
}

}  // namespace rollfem::fem
