#include "fem/model.hpp"

#include "contact/errors.hpp"
#include "contact/refinement.hpp"
#include "fem/contact_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <vector>

namespace rollfem::fem {

namespace {

using contact::Case;
using contact::ModelResult;

/// The order in h that the two-level estimate assumes, measured on case a (docs/verification.md).
constexpr double assumed_order = 1.5;
/// Of the orders that three levels show.
constexpr double least_order = 1.0;

/// Error of the fine value from the change between the two levels, relative to the fine value or to
/// `scale` where that is larger (a quantity that vanishes has no relative error).
double two_level_error(double fine, double coarse, double scale) {
  const double reference = std::max(std::abs(fine), scale);
  const double change = std::abs(fine - coarse) / (std::pow(2.0, assumed_order) - 1.0);
  return reference > 0.0 ? change / reference : 0.0;
}

/// Adds to what a point's estimate holds already (the finite segments' part of the approach).
void estimate_errors(ModelResult& fine, const ModelResult& coarse, double friction) {
  for (std::size_t k = 0; k < fine.points.size(); ++k) {
    contact::PointResult& f = fine.points[k];
    const contact::PointResult& c = coarse.points[k];
    const auto set = [&](const char* name, double contact::PointResult::*quantity, double scale) {
      f.error_estimate[name] += two_level_error(f.*quantity, c.*quantity, scale);
    };
    using Point = contact::PointResult;
    set("max_pressure", &Point::max_pressure, 0.0);
    set("normal_force", &Point::normal_force, 0.0);
    set("approach", &Point::approach, 0.0);
    set("semi_axis_x", &Point::semi_axis_x, 0.0);
    set("semi_axis_y", &Point::semi_axis_y, 0.0);
    set("max_traction_x", &Point::max_traction_x, 0.01 * friction * f.max_pressure);
    set("traction_coefficient", &Point::traction_coefficient, 0.01 * friction);
  }
}

/// The same from all levels so far, the finest last (the first two at least).
void estimate_errors(const Case& input, std::vector<ModelResult>& levels) {
  std::vector<contact::PointResult>& fine = levels.back().points;
  for (std::size_t k = 0; k < fine.size(); ++k)
    for (const char* name : {"max_pressure", "normal_force", "approach", "semi_axis_x",
                             "semi_axis_y", "max_traction_x", "traction_coefficient"}) {
      std::vector<double> values;
      for (const ModelResult& level : levels)
        values.push_back(contact::quantity(level.points[k], name));
      const double scale = contact::estimate_scale(input, fine[k], name);
      if (scale > 0.0)
        fine[k].error_estimate[name] +=
            contact::estimated_error(values, assumed_order, least_order) / scale;
    }
}

/// Cells of the start when the case gives accuracy and no cell size: parts of the smaller
/// semi-axis.
constexpr double parts_at_start = 8.0;

/// Cells larger than this part of the smaller semi-axis say nothing.
constexpr double coarsest_part = 0.55;

/// Two levels alone can agree by chance, and cannot show an order.
constexpr std::size_t fewest_levels = 3;

/// Finest cells relative to those of the start.
constexpr int most_halvings = 5;

/// Halves the cells until the estimated error is what the case asks for, or memory ends.
ModelResult run_to_accuracy(const Case& input, const contact::Progress& progress,
                            contact::Checkpoint* checkpoint) {
  const double default_cell = default_cell_size([&] {
    Case plain = input;
    plain.fem.cell_size.reset();
    return plain;
  }());
  const double smaller_semi_axis = 8.0 * default_cell;
  double cell = input.fem.cell_size.value_or(smaller_semi_axis / parts_at_start);
  refuse_beyond_memory(input, cell);
  const auto solve = [&](double size, bool fields) {
    return run_level(input, {size, fmt::format("{:.3g} mm: ", size), fields, checkpoint}, progress);
  };
  std::vector<ModelResult> levels;
  if (4.0 * cell <= coarsest_part * smaller_semi_axis) levels.push_back(solve(4.0 * cell, false));
  levels.push_back(solve(2.0 * cell, false));
  levels.push_back(solve(cell, input.output.fields));
  estimate_errors(input, levels);
  contact::WorstError worst = contact::worst_error(input, levels.back().points);
  std::string reason = fmt::format(
      "cells of {:.3g} mm are the finest tried; do: begin with a "
      "smaller [fem] cell_size, or ask for less",
      cell / std::exp2(most_halvings));
  for (int halving = 0;
       halving < most_halvings && (levels.size() < fewest_levels || worst.error > *input.accuracy);
       ++halving) {
    try {
      refuse_beyond_memory(input, 0.5 * cell);
    } catch (const contact::SolveError& error) {
      reason = error.what();
      break;
    }
    cell *= 0.5;
    levels.back().bodies.clear();
    levels.push_back(solve(cell, input.output.fields));
    estimate_errors(input, levels);
    worst = contact::worst_error(input, levels.back().points);
  }
  ModelResult result = std::move(levels.back());
  result.notes.push_back(
      fmt::format("accuracy {:g} asked for: cells were halved to {:.4g} mm; largest estimated "
                  "error {:.2g} ({} at load point {}), from the changes between the last three "
                  "levels and the order that they show",
                  *input.accuracy, cell, worst.error, worst.quantity, worst.point));
  if (worst.error > *input.accuracy || levels.size() < fewest_levels)
    result.shortfall = contact::shortfall_text(input, worst, reason);
  return result;
}

}  // namespace

ModelResult run_fem(const Case& input, const contact::Progress& progress,
                    contact::Checkpoint* checkpoint) {
  const auto begin = std::chrono::steady_clock::now();
  const auto elapsed = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  if (input.accuracy) {
    ModelResult result = run_to_accuracy(input, progress, checkpoint);
    result.seconds["total"] = elapsed();
    return result;
  }
  const double cell = default_cell_size(input);
  refuse_beyond_memory(input, cell);
  const ModelResult coarse =
      run_level(input, {2.0 * cell, "estimate: ", false, checkpoint}, progress);
  const double estimate_seconds = elapsed();
  ModelResult result = run_level(input, {cell, "", input.output.fields, checkpoint}, progress);
  estimate_errors(result, coarse, input.friction_coefficient);
  result.seconds["estimate"] = estimate_seconds;
  result.seconds["total"] = elapsed();
  result.notes.push_back(fmt::format(
      "error estimates: change between cells of {:.4g} and {:.4g} mm divided by 2^{:.1f} - 1",
      2.0 * cell, cell, assumed_order));
  return result;
}

}  // namespace rollfem::fem
