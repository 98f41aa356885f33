// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tables/filling/table_filling.hpp"

#include "contact/base/threads.hpp"
#include "tables/filling/table_parts.hpp"
#include "tables/filling/table_source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace rollfem::tables {

namespace {

constexpr unsigned seed = 20120816;
constexpr std::size_t points_of_a_place = 10;  ///< random points per intermediate place

/// Creepage indices of point `n` of a ratio or shift, in boustrophedon order, so that consecutive
/// points are neighbours.
std::array<std::size_t, 3> to_and_fro(const CreepTable& table, std::size_t n) {
  const std::size_t across = table.creepage[1].size(), spins = table.creepage[2].size();
  const std::size_t row = n / spins, m = n % spins, i = row / across;
  const std::size_t j = i % 2 == 0 ? row % across : across - 1 - row % across;
  return {i, j, row % 2 == 0 ? m : spins - 1 - m};
}

void fill_grid(CreepTable& table, const TableSource& source, const contact::Progress& progress,
               contact::Checkpoint* checkpoint, contact::Share share) {
  const std::size_t of_a_place = table.size() / table.first_axis().size();
  table.forces.resize(table.size());
  table.bars.resize(table.size());
  table.elements_across.resize(table.size());
  if (table.over_shifts()) table.along_normal.resize(table.size());
  TableParts parts{"table", "points", share, parts_of(table.size(), of_a_place), {}, {}};
  parts.solve = [&](const TablePart& part) {
    std::vector<Scaled> creepages;
    for (std::size_t n = part.begin; n < part.end; ++n) {
      const auto [i, j, k] = to_and_fro(table, n % of_a_place);
      creepages.push_back({table.creepage[0][i], table.creepage[1][j], table.creepage[2][k]});
    }
    return source.at_node(part.begin / of_a_place, creepages);
  };
  parts.done = [&](const TablePart& part, const std::vector<TablePoint>& points) {
    for (std::size_t n = part.begin; n < part.end; ++n) {
      const auto [i, j, k] = to_and_fro(table, n % of_a_place);
      const std::size_t at = table.place(n / of_a_place, i, j, k);
      const TablePoint& point = points[n - part.begin];
      table.forces[at] = point.forces;
      table.bars[at] = point.bars;
      table.elements_across[at] = point.elements_across;
      if (table.over_shifts()) table.along_normal[at] = point.along_normal;
    }
  };
  solve_parts(parts, progress, checkpoint);
}

/// Ranges for random places on the first axis: mm, or the logarithm of the ratio. Gaps in which
/// contact jumps are left out, because there is no interpolation.
std::vector<std::array<double, 2>> stretches_of(const CreepTable& table) {
  const auto coordinate = [&](std::size_t k) {
    return table.over_shifts() ? table.lateral_shift[k] : std::log(table.axis_ratio[k]);
  };
  std::vector<std::array<double, 2>> stretches;
  for (std::size_t k = 0; k < table.first_axis().size(); ++k) {
    if (k == 0 || (table.over_shifts() && table.wheels[k - 1].jump_after != 0.0))
      stretches.push_back({coordinate(k), coordinate(k)});
    stretches.back()[1] = coordinate(k);
  }
  return stretches;
}

double place_at(const CreepTable& table, const std::vector<std::array<double, 2>>& stretches,
                double share) {
  double whole = 0.0;
  for (const auto& [low, high] : stretches) whole += high - low;
  double way = share * whole;
  std::size_t s = 0;
  // Stretches of a single place count only if there are no others.
  if (whole == 0.0)
    s = std::min(stretches.size() - 1,
                 static_cast<std::size_t>(share * static_cast<double>(stretches.size())));
  for (; s + 1 < stretches.size() && way > stretches[s][1] - stretches[s][0]; ++s)
    way -= stretches[s][1] - stretches[s][0];
  const double x = std::min(stretches[s][0] + way, stretches[s][1]);
  const std::vector<double>& places = table.first_axis();
  return std::clamp(table.over_shifts() ? x : std::exp(x), places.front(), places.back());
}

/// Random points, uniform over the coordinates of the axes, of both signs.
std::vector<CheckedPoint> points_between(const CreepTable& table, int count) {
  std::mt19937 random(seed);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(random()) + 0.5) / 4294967296.0;
  };
  const auto stretches = stretches_of(table);
  std::vector<CheckedPoint> points(static_cast<std::size_t>(count));
  double place = 1.0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (k % points_of_a_place == 0) place = place_at(table, stretches, uniform(0.0, 1.0));
    points[k].place = place;
    for (std::size_t q = 0; q < 3; ++q) {
      const double end = table_coordinate(table.creepage[q].back());
      points[k].creepage[q] = creepage_at(uniform(-end, end));
    }
  }
  return points;
}

InterpolationError error_of(const std::vector<CheckedPoint>& points) {
  InterpolationError error;
  error.points = static_cast<int>(points.size());
  error.seed = seed;
  if (points.empty()) return error;
  std::vector<double> force, moment;
  for (const auto& [place, creepage, found, solved] : points) {
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

/// A point whose place and creepages are nodes on all axes but one.
struct AxisPoint {
  std::size_t axis = 0;   ///< 0: of the first axis, q + 1: of creepage q
  std::size_t first = 0;  ///< node of the first axis; unused for axis 0
  CheckedPoint point;
};

/// Random points between the nodes of one axis after another, in groups of points_of_a_place.
std::vector<AxisPoint> points_along_axes(const CreepTable& table, int count) {
  std::mt19937 random(seed + 1);
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  const auto share = [&] { return (static_cast<double>(random()) + 0.5) / 4294967296.0; };
  const auto stretches = stretches_of(table);
  std::vector<AxisPoint> points;
  for (std::size_t axis = 0; axis < 4; ++axis) {
    const bool of_first = axis == 0;
    if ((of_first ? table.first_axis() : table.creepage[axis - 1]).size() < 2) continue;
    const std::size_t groups =
        std::max<std::size_t>(1, static_cast<std::size_t>(count) / (4 * points_of_a_place));
    for (std::size_t g = 0; g < groups; ++g) {
      const std::size_t first = below(table.first_axis().size());
      const double place =
          of_first ? place_at(table, stretches, share()) : table.first_axis()[first];
      for (std::size_t n = 0; n < points_of_a_place; ++n) {
        AxisPoint next{axis, first, {}};
        next.point.place = place;
        for (std::size_t q = 0; q < 3; ++q) {
          const std::vector<double>& nodes = table.creepage[q];
          next.point.creepage[q] = nodes[below(nodes.size())];
          if (q + 1 != axis) continue;
          const double low = table_coordinate(nodes.front()), high = table_coordinate(nodes.back());
          next.point.creepage[q] = creepage_at(low + (high - low) * share());
        }
        points.push_back(next);
      }
    }
  }
  return points;
}

/// InterpolationError::by_axis.
std::array<double, 4> axis_errors(const CreepTableReader& reader, const TableSource& source,
                                  int count, const contact::Progress& progress,
                                  contact::Checkpoint* checkpoint) {
  std::vector<AxisPoint> points = points_along_axes(reader.table(), count);
  std::array<double, 4> errors{};
  if (points.empty()) return errors;
  TableParts parts{"axes", "points along axes", {}, parts_of(points.size(), points_of_a_place), {},
                   {}};
  parts.solve = [&](const TablePart& part) {
    std::vector<Scaled> creepages;
    for (std::size_t k = part.begin; k < part.end; ++k)
      creepages.push_back(points[k].point.creepage);
    const AxisPoint& one = points[part.begin];
    return one.axis == 0 ? source.between(reader, one.point.place, creepages)
                         : source.at_node(one.first, creepages);
  };
  parts.done = [&](const TablePart& part, const std::vector<TablePoint>& solved) {
    for (std::size_t k = part.begin; k < part.end; ++k) {
      CheckedPoint& point = points[k].point;
      point.solved = solved[k - part.begin].forces;
      point.interpolated = reader.at(point.place, point.creepage).forces;
    }
  };
  solve_parts(parts, progress, checkpoint);
  for (std::size_t axis = 0; axis < errors.size(); ++axis) {
    std::vector<CheckedPoint> of_axis;
    for (const AxisPoint& point : points)
      if (point.axis == axis) of_axis.push_back(point.point);
    const InterpolationError error = error_of(of_axis);
    errors[axis] = std::max(error.force_95, error.moment_95);
  }
  return errors;
}

void look_between(CreepTable& table, const TableSource& source, int count,
                  const contact::Progress& progress, contact::Checkpoint* checkpoint) {
  std::vector<CheckedPoint> points = points_between(table, count);
  std::array<double, 4> by_axis{};
  if (!points.empty()) {
    CreepTableReader reader(std::move(table));  // avoids a second copy of a large table
    TableParts parts{"check", "points between", {}, parts_of(points.size(), points_of_a_place), {},
                     {}};
    parts.solve = [&](const TablePart& part) {
      std::vector<Scaled> creepages;
      for (std::size_t k = part.begin; k < part.end; ++k) creepages.push_back(points[k].creepage);
      return source.between(reader, points[part.begin].place, creepages);
    };
    parts.done = [&](const TablePart& part, const std::vector<TablePoint>& solved) {
      for (std::size_t k = part.begin; k < part.end; ++k) {
        points[k].solved = solved[k - part.begin].forces;
        points[k].interpolated = reader.at(points[k].place, points[k].creepage).forces;
      }
    };
    solve_parts(parts, progress, checkpoint);
    by_axis = axis_errors(reader, source, count, progress, checkpoint);
    table = std::move(reader).release();
  }
  table.interpolation = error_of(points);
  table.interpolation.by_axis = by_axis;
  table.checked = std::move(points);
}

std::string duration(double seconds) {
  if (seconds < 120.0) return fmt::format("{:.2g} s", std::max(1.0, seconds));
  return seconds < 7200.0 ? fmt::format("{:.0f} min", seconds / 60.0)
                          : fmt::format("{:.1f} h", seconds / 3600.0);
}

/// Reports how long filling will take from a cold start, from some points in the middle of the
/// table.
void forecast(const CreepTable& table, const TableSource& source, int check_points,
              const contact::Progress& progress, contact::Share share) {
  constexpr std::size_t sample = 16, worth_a_forecast = 200;
  if (table.size() < worth_a_forecast) return;
  const std::size_t places = table.first_axis().size(), of_a_place = table.size() / places;
  std::vector<Scaled> creepages;
  for (std::size_t n = of_a_place / 2; n < std::min(of_a_place / 2 + sample, of_a_place); ++n) {
    const auto [i, j, k] = to_and_fro(table, n);
    creepages.push_back({table.creepage[0][i], table.creepage[1][j], table.creepage[2][k]});
  }
  const std::clock_t begin = std::clock();  // CPU time: other programs would spoil a short sample
  {
    const contact::SingleThread single;
    static_cast<void>(source.at_node(places / 2, creepages));
  }
  const double of_a_point = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC /
                            static_cast<double>(creepages.size());
  const double points = static_cast<double>(table.size()) / share.of;
  const double checks = share.whole() ? 2.0 * check_points : 0.0;  // also along the axes
  contact::ProgressEvent event;
  event.model = "table";
  event.stage = "time needed";
  event.finished = true;
  event.note = fmt::format("{:.0f} points: about {} on {} idle cores", points,
                           duration(of_a_point * (points + checks) / contact::threads()),
                           contact::threads());
  contact::report(progress, event);
}

}  // namespace

void fill_table(CreepTable& table, const contact::Case& input, const contact::Progress& progress,
                contact::Checkpoint* checkpoint, contact::Share share) {
  const std::unique_ptr<TableSource> source =
      table.over_shifts() ? wheel_source(input) : ellipse_source(table);
  source->prepare(table, progress);
  if (checkpoint == nullptr || !checkpoint->find("table-00000"))
    forecast(table, *source, input.table.check_points, progress, share);
  fill_grid(table, *source, progress, checkpoint, share);
  if (!share.whole()) return;
  look_between(table, *source, input.table.check_points, progress, checkpoint);
}

}  // namespace rollfem::tables
