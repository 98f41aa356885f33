#include "app/table_filling.hpp"

#include "contact/result/record.hpp"
#include "halfspace/model/many.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace rollfem::app {

namespace {

using halfspace::CreepPoint;
using halfspace::EllipseShape;
using halfspace::ManyForces;
using postprocess::CreepTable;
using postprocess::Scaled;

// What two grids leave is the size of the error, no bound: no bar is smaller than this, with which
// 150 of 150 points at random hold (docs/tables.md).
constexpr double least_force_bar = 0.002;
constexpr double least_moment_bar = 0.002;

/// Half of what a list of points is solved to: forces within 0.2 % of mu F_n everywhere.
constexpr double largest_correction = 0.0015;

constexpr unsigned seed = 20120816;
constexpr std::size_t points_of_a_ratio = 10;  ///< at random, of one ratio that lies between

CreepPoint unscaled(std::size_t shape, const Scaled& creepage, const Scaled& scale) {
  return {shape, creepage[0] / scale[0], creepage[1] / scale[1], creepage[2] / scale[2]};
}

/// Points that are solved together: shapes, creepages, and the forces that were found.
struct Task {
  std::string name;  ///< of its records
  std::vector<EllipseShape> shapes;
  std::vector<CreepPoint> points;
  std::vector<ManyForces> forces;
};

/// Written or read.
void record_forces(contact::Record& record, std::vector<ManyForces>& forces) {
  for (ManyForces& entry : forces) {
    record.values(entry.limit.longitudinal, entry.limit.lateral, entry.limit.spin_moment);
    record.values(entry.correction.longitudinal, entry.correction.lateral,
                  entry.correction.spin_moment, entry.elements_across);
  }
}

std::string bytes_of(std::vector<ManyForces> forces) {
  contact::Record record;
  record_forces(record, forces);
  return record.bytes();
}

std::vector<ManyForces> forces_of(const std::string& bytes, std::size_t count) {
  contact::Record record(bytes);
  std::vector<ManyForces> forces(count);
  record_forces(record, forces);
  return forces;
}

Scaled limit_of(const ManyForces& forces) {
  return {forces.limit.longitudinal, forces.limit.lateral, forces.limit.spin_moment};
}

void solve(Task& task, const std::string& stage, const contact::Progress& progress,
           contact::Checkpoint* checkpoint) {
  // Cut the same way whatever is taken up, so that the numbers are the same to the last bit.
  const std::vector<halfspace::Chain> parts = halfspace::chains_of(task.shapes.size(), task.points);
  std::vector<std::size_t> part_of(task.points.size());
  task.forces.resize(task.points.size());
  const auto name_of = [&](std::size_t part) { return fmt::format("{}-{:05}", task.name, part); };
  std::vector<std::size_t> missing;  // places in the list
  std::size_t done = 0;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const auto kept = checkpoint == nullptr ? std::nullopt : checkpoint->find(name_of(p));
    if (kept) {
      const auto forces = forces_of(*kept, parts[p].points.size());
      for (std::size_t n = 0; n < forces.size(); ++n) task.forces[parts[p].points[n]] = forces[n];
      done += forces.size();
      continue;
    }
    for (const std::size_t k : parts[p].points) {
      part_of[k] = p;
      missing.push_back(k);
    }
  }
  std::vector<CreepPoint> asked;
  for (const std::size_t k : missing) asked.push_back(task.points[k]);
  const auto tell = [&](bool finished) {
    contact::ProgressEvent event;
    event.model = "table";
    event.stage = stage;
    event.point = static_cast<int>(done);
    event.points = static_cast<int>(task.points.size());
    event.finished = finished;
    contact::report(progress, event);
  };
  halfspace::ManyOptions options;
  options.largest_correction = largest_correction;
  options.finished = [&](const std::vector<std::size_t>& places,
                         const std::vector<ManyForces>& forces) {
    for (std::size_t n = 0; n < places.size(); ++n) task.forces[missing[places[n]]] = forces[n];
    if (checkpoint != nullptr)
      checkpoint->keep(name_of(part_of[missing[places.front()]]), bytes_of(forces));
    done += places.size();
    tell(false);
  };
  tell(false);
  halfspace::solve_many(task.shapes, asked, options);
  tell(true);
}

/// To and fro, so that points that follow each other are neighbours. Ends with the places in the
/// table.
Task grid_task(const CreepTable& table, std::vector<std::size_t>& places) {
  Task task;
  task.name = "table";
  const auto& [xi, eta, phi] = table.creepage;
  for (std::size_t r = 0; r < table.axis_ratio.size(); ++r) {
    task.shapes.push_back({table.axis_ratio[r], table.poisson_ratio});
    for (std::size_t i = 0; i < xi.size(); ++i)
      for (std::size_t n = 0; n < eta.size(); ++n) {
        const std::size_t j = i % 2 == 0 ? n : eta.size() - 1 - n;
        for (std::size_t m = 0; m < phi.size(); ++m) {
          const std::size_t k = (i * eta.size() + n) % 2 == 0 ? m : phi.size() - 1 - m;
          task.points.push_back(unscaled(r, {xi[i], eta[j], phi[k]}, table.scale[r]));
          places.push_back(table.place(r, i, j, k));
        }
      }
  }
  return task;
}

void fill_grid(CreepTable& table, const contact::Progress& progress,
               contact::Checkpoint* checkpoint) {
  std::vector<std::size_t> places;
  Task task = grid_task(table, places);
  solve(task, "points", progress, checkpoint);
  table.forces.resize(table.size());
  table.bars.resize(table.size());
  table.elements_across.resize(table.size());
  for (std::size_t k = 0; k < places.size(); ++k) {
    const ManyForces& found = task.forces[k];
    table.forces[places[k]] = limit_of(found);
    table.bars[places[k]] = {std::max(least_force_bar, std::hypot(found.correction.longitudinal,
                                                                  found.correction.lateral)),
                             std::max(least_moment_bar, std::abs(found.correction.spin_moment))};
    table.elements_across[places[k]] = found.elements_across;
  }
}

/// Even over the coordinates of the axes, of both signs, and over the logarithm of the ratio.
std::vector<postprocess::CheckedPoint> points_between(const CreepTable& table, int count) {
  std::mt19937 random(seed);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(random()) + 0.5) / 4294967296.0;
  };
  std::vector<postprocess::CheckedPoint> points(static_cast<std::size_t>(count));
  double ratio = 1.0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (k % points_of_a_ratio == 0)
      ratio =
          std::exp(uniform(std::log(table.axis_ratio.front()), std::log(table.axis_ratio.back())));
    points[k].axis_ratio = std::clamp(ratio, table.axis_ratio.front(), table.axis_ratio.back());
    for (std::size_t q = 0; q < 3; ++q) {
      const double end = postprocess::table_coordinate(table.creepage[q].back());
      points[k].creepage[q] = postprocess::creepage_at(uniform(-end, end));
    }
  }
  return points;
}

postprocess::InterpolationError error_of(const std::vector<postprocess::CheckedPoint>& points) {
  postprocess::InterpolationError error;
  error.points = static_cast<int>(points.size());
  error.seed = seed;
  if (points.empty()) return error;
  std::vector<double> force, moment;
  for (const auto& [ratio, creepage, found, solved] : points) {
    force.push_back(std::hypot(found[0] - solved[0], found[1] - solved[1]));
    moment.push_back(std::abs(found[2] - solved[2]));
  }
  const auto judge = [](std::vector<double>& errors, double& rms, double& most, double& largest) {
    std::sort(errors.begin(), errors.end());
    double sum = 0.0;
    for (const double e : errors) sum += e * e;
    rms = std::sqrt(sum / static_cast<double>(errors.size()));
    const double share = std::ceil(0.95 * static_cast<double>(errors.size()));
    most = errors[static_cast<std::size_t>(share) - 1];
    largest = errors.back();
  };
  judge(force, error.force_rms, error.force_95, error.force_max);
  judge(moment, error.moment_rms, error.moment_95, error.moment_max);
  return error;
}

void look_between(CreepTable& table, int count, const contact::Progress& progress,
                  contact::Checkpoint* checkpoint) {
  std::vector<postprocess::CheckedPoint> points = points_between(table, count);
  const postprocess::CreepTableReader reader(table);
  Task task;
  task.name = "check";
  for (const postprocess::CheckedPoint& point : points) {
    if (task.shapes.empty() || task.shapes.back().axis_ratio != point.axis_ratio)
      task.shapes.push_back({point.axis_ratio, table.poisson_ratio});
    task.points.push_back(
        unscaled(task.shapes.size() - 1, point.creepage, reader.scale_at(point.axis_ratio)));
  }
  if (!points.empty()) solve(task, "points between", progress, checkpoint);
  for (std::size_t k = 0; k < points.size(); ++k) {
    points[k].solved = limit_of(task.forces[k]);
    points[k].interpolated = reader.at(points[k].axis_ratio, points[k].creepage).forces;
  }
  table.interpolation = error_of(points);
  table.checked = std::move(points);
}

}  // namespace

void fill_table(CreepTable& table, int check_points, const contact::Progress& progress,
                contact::Checkpoint* checkpoint) {
  fill_grid(table, progress, checkpoint);
  look_between(table, check_points, progress, checkpoint);
}

}  // namespace rollfem::app
