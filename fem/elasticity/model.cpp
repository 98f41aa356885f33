#include "fem/elasticity/model.hpp"

#include "contact/base/errors.hpp"
#include "contact/result/refinement.hpp"
#include "fem/elasticity/error_bars.hpp"
#include "fem/elasticity/run_level.hpp"
#include "fem/linear/solver_choice.hpp"
#include "fem/mesh/run_layout.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace rollfem::fem {

namespace {

using contact::ModelResult;
using contact::Scene;

/// Cells of the start when the case gives accuracy and no cell size: parts of the smaller
/// semi-axis.
constexpr double parts_at_start = 8.0;

/// Cells larger than this part of the smaller semi-axis say nothing.
constexpr double coarsest_part = 0.55;

std::string note_on_bars(double coarse_cell, double cell, bool beside_half_spaces) {
  if (!beside_half_spaces)
    return fmt::format(
        "error bars: from the change between cells of {:.4g} and {:.4g} mm, and from the solution "
        "near edges and peaks; half-spaces, which would improve them, have no solution on these "
        "contact elements",
        coarse_cell, cell);
  return fmt::format(
      "error bars: from the error of half-spaces on the same contact elements, and from how finite "
      "elements and half-spaces diverge between cells of {:.4g} and {:.4g} mm (docs/accuracy.md)",
      coarse_cell, cell);
}

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
  const double smaller_semi_axis = PatchSearch(scene).box().smaller();
  double cell = scene.fem.cell_size.value_or(smaller_semi_axis / parts_at_start);
  refuse_beyond_memory(scene, cell);
  const auto solve = [&](double size, bool fields) {
    return run_level(scene, {size, fmt::format("{:.3g} mm: ", size), fields, checkpoint}, progress);
  };
  std::vector<ModelResult> levels;
  if (4.0 * cell <= coarsest_part * smaller_semi_axis) levels.push_back(solve(4.0 * cell, false));
  levels.push_back(solve(2.0 * cell, false));
  levels.push_back(solve(cell, scene.output.fields));
  bool beside = set_error_bars(scene, levels);
  const auto worst_of = [&] {
    return contact::worst_error(scene.accuracy, scene.friction_coefficient(), levels.back().points);
  };
  contact::WorstError worst = worst_of();
  std::string reason = fmt::format(
      "cells of {:.3g} mm are the finest allowed; do: start from a smaller [fem] cell_size, or "
      "request less accuracy",
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
    beside = set_error_bars(scene, levels);
    worst = worst_of();
  }
  ModelResult result = std::move(levels.back());
  result.notes.push_back(fmt::format(
      "accuracy {:g} requested: cells were halved to {:.4g} mm; largest estimated error {}",
      *scene.accuracy.relative, cell, worst.text()));
  result.notes.push_back(note_on_bars(2.0 * cell, cell, beside));
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
  double estimate_seconds = elapsed();
  levels.push_back(run_level(scene, {cell, "", scene.output.fields, checkpoint}, progress));
  const double before_bars = elapsed();
  const bool beside = set_error_bars(scene, levels);
  ModelResult result = std::move(levels.back());
  result.notes.push_back(note_on_bars(2.0 * cell, cell, beside));
  estimate_seconds += elapsed() - before_bars;
  result.seconds["estimate"] = estimate_seconds;
  result.seconds["total"] = elapsed();
  return result;
}

}  // namespace rollfem::fem
