// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/elasticity/fem_model.hpp"

#include "base/checkpoint.hpp"
#include "base/errors.hpp"
#include "base/progress.hpp"
#include "base/threads.hpp"
#include "fem/elasticity/fem_error_bars.hpp"
#include "fem/elasticity/run_level.hpp"
#include "fem/linear/root_process.hpp"
#include "fem/linear/solver_choice.hpp"
#include "fem/mesh/run_layout.hpp"
#include "fem/plasticity/pass_results.hpp"
#include "fem/plasticity/yielding_bodies.hpp"
#include "result/record.hpp"
#include "result/refinement.hpp"
#include "result/validity.hpp"

#include <deal.II/base/mpi.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace rollfem::fem {

namespace {

using contact::ModelResult;
using contact::Scene;

/// Largest meaningful cell as a fraction of the smaller semi-axis.
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

void exchange(contact::Record& record, ModelResult& result) {
  record.values(result.unknowns, result.contact_elements, result.shortfall, result.notes,
                result.points);
}

/// Sends the result of the root process to all, except the bodies, because studies and choices of
/// models depend on it. Collective.
void broadcast_points(ModelResult& result) {
  if (dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1) return;
  std::vector<std::vector<contact::BodyValues>> bodies;
  for (contact::PointResult& point : result.points)
    bodies.push_back(std::exchange(point.bodies, {}));
  contact::Record record;
  exchange(record, result);
  contact::Record received(dealii::Utilities::MPI::broadcast(MPI_COMM_WORLD, record.bytes()));
  exchange(received, result);
  for (std::size_t k = 0; k < bodies.size(); ++k) result.points[k].bodies = std::move(bodies[k]);
}

/// Two levels may agree by chance and show no order.
constexpr std::size_t fewest_levels = 3;

/// Smallest cells relative to those of the start.
constexpr int most_halvings = 5;

/// Levels with successively halved cells, each with the error bars of its load points.
class Levels {
 public:
  Levels(const Scene& scene, const contact::Progress& progress, contact::Checkpoint* checkpoint)
      : scene_(scene), progress_(progress), checkpoint_(checkpoint) {}

  /// The first levels, all but the last only for the error bars; side by side in a single process
  /// where memory allows.
  void start(const std::vector<double>& cells) {
    levels_.resize(cells.size());
    std::vector<double> seconds(cells.size());
    const auto solve_level = [&](std::size_t k) {
      const contact::Stopwatch watch;
      const bool last = k + 1 == cells.size();
      levels_[k] = solve(cells[k], last ? "" : "estimate: ", last && scene_.output.fields);
      if (!last) seconds[k] = watch.seconds();
    };
    if (dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1 && fit_together(scene_, cells))
      contact::for_each_index(cells.size(), solve_level);
    else
      for (std::size_t k = 0; k < cells.size(); ++k) solve_level(k);
    estimate_seconds_ = std::accumulate(seconds.begin(), seconds.end(), 0.0);
    set_bars(cells.back());
  }
  void add(double cell) {
    // Only the bodies of the finest level are needed.
    levels_.back().bodies.clear();
    for (contact::PointResult& point : levels_.back().points) point.bodies.clear();
    levels_.push_back(solve(cell, "", scene_.output.fields));
    set_bars(cell);
  }
  /// The finest level must exist. `first`: cells of the start.
  bool refine_further(double first) {
    contact::Rung rung{fmt::format("cells were halved to {:.4g} mm", cell_), "",
                       levels_.size() >= fewest_levels};
    if (cell_ < 1.5 * first / std::exp2(most_halvings))
      rung.no_finer = fmt::format(
          "cells of {:.3g} mm are the finest allowed; do: start from a smaller [fem] cell_size, or "
          "request less accuracy",
          cell_);
    try {
      if (rung.no_finer.empty() && scene_.accuracy.relative)
        refuse_beyond_memory(scene_, 0.5 * cell_);
    } catch (const contact::SolveError& error) {
      rung.no_finer = error.what();
    }
    bool further = false;
    root_.run([&] {
      further = contact::refine_further(scene_.accuracy, scene_.friction_coefficient(), rung,
                                        levels_.back().points, levels_.back());
    });
    return dealii::Utilities::MPI::broadcast(MPI_COMM_WORLD, further);
  }
  double estimate_seconds() const { return estimate_seconds_; }
  ModelResult take_finest() {
    ModelResult result = std::move(levels_.back());
    broadcast_points(result);
    for (const contact::YieldedSection& section : result.points.back().yielded)
      result.notes.push_back({fmt::format("{} of the {}", word_of(section.verdict), section.body),
                              verdict_note(section, static_cast<int>(result.points.size()))});
    result.notes.push_back({"bars", note_on_bars(2.0 * cell_, cell_, beside_half_spaces_)});
    return result;
  }

 private:
  ModelResult solve(double cell, const std::string& stage, bool fields) const {
    const std::string prefix = scene_.accuracy.relative ? fmt::format("{:.3g} mm: ", cell) : stage;
    return run_level(scene_, {cell, prefix, fields, checkpoint_}, progress_);
  }
  /// `cell`: of the finest level.
  void set_bars(double cell) {
    cell_ = cell;
    const contact::Stopwatch watch;
    root_.run([&] { beside_half_spaces_ = set_error_bars(scene_, levels_); });
    estimate_seconds_ += watch.seconds();
  }

  const Scene& scene_;
  const contact::Progress& progress_;
  contact::Checkpoint* checkpoint_;
  RootProcess root_{MPI_COMM_WORLD};
  std::vector<ModelResult> levels_;
  double cell_ = 0.0, estimate_seconds_ = 0.0;
  bool beside_half_spaces_ = false;
};

/// Before the bodies are computed: cells with which the patch cannot have enough elements.
void refuse_coarse_cells(const Scene& scene, double cell) {
  constexpr double margin = 1.3;  // of the expected patch
  const contact::ContactGrid grid = run_layout(scene, cell).grid;
  const PatchBox box = PatchSearch(scene).box();
  const auto elements = [](double half, double size) { return std::lround(2.0 * half / size); };
  const double most =
      1.0 + 2.0 * margin * std::min(box.half_length / grid.dx, box.half_width / grid.dy);
  if (most < contact::fewest_elements_across && !contact::gives_grid(scene))
    throw contact::UnfitGrid(scene.where(),
                             contact::few_elements_text(elements(box.half_length, grid.dx),
                                                        elements(box.half_width, grid.dy), grid));
}

ModelResult run_with_streamlines(const Scene& scene, const contact::Progress& progress,
                                 contact::Checkpoint* checkpoint) {
  const contact::Stopwatch watch;
  const bool to_accuracy = scene.accuracy.relative.has_value();
  const double cell = default_cell_size(scene);
  const bool two_coarser =
      to_accuracy && 4.0 * cell <= coarsest_part * PatchSearch(scene).box().smaller();
  refuse_coarse_cells(scene, cell);
  refuse_beyond_memory(scene, cell);
  Levels levels(scene, progress, checkpoint);
  levels.start(two_coarser ? std::vector{4.0 * cell, 2.0 * cell, cell}
                           : std::vector{2.0 * cell, cell});
  for (double finer = 0.5 * cell; levels.refine_further(cell); finer *= 0.5) levels.add(finer);
  ModelResult result = levels.take_finest();
  if (!to_accuracy) result.seconds["estimate"] = levels.estimate_seconds();
  result.seconds["total"] = watch.seconds();
  return result;
}

}  // namespace

ModelResult run_fem(const Scene& scene, const contact::Progress& progress,
                    contact::Checkpoint* checkpoint) {
  constexpr double growth = 1.3;
  constexpr int most_times = 8;
  Scene grown = scene;
  std::vector<contact::Note> notes;
  for (int times = 0;; ++times) try {
      contact::CheckpointPart part(checkpoint, std::string(static_cast<std::size_t>(times), 'x'));
      Scene fitting = grown;
      const auto thicker_rows = fit_surface_rows(fitting, default_cell_size(fitting));
      ModelResult result = run_with_streamlines(fitting, progress, &part);
      result.notes.insert(result.notes.end(), notes.begin(), notes.end());
      if (thicker_rows) result.notes.push_back(*thicker_rows);
      return result;
    } catch (const YieldsBeyondStreamlines& beyond) {
      if (times == most_times)
        throw contact::SolveError(
            fmt::format("{}; do: give a larger fem.plastic_extent than {:.3g}", beyond.what(),
                        options_of(grown).plastic_extent));
      auto& extent = grown.options.set<FemOptions>().plastic_growth;
      extent[beyond.direction] *= growth;
      notes = {{"plastic_extent",
                fmt::format("the region that may yield grew to {:.3g} times along, {:.3g} times "
                            "across and {:.3g} times down, because {}",
                            extent[0], extent[1], extent[2], beyond.what())}};
      contact::ProgressEvent event;
      event.model = "fem";
      event.stage = "plastic flow";
      event.note = notes.front().text;
      event.finished = true;
      contact::report(progress, event);
    }
}

}  // namespace rollfem::fem
