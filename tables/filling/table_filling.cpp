// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tables/filling/table_filling.hpp"

#include "base/threads.hpp"
#include "result/record.hpp"
#include "tables/filling/table_source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <functional>
#include <memory>
#include <mutex>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace rollfem::tables {

namespace {

constexpr unsigned seed = 20120816;
constexpr std::size_t points_of_a_place = 10;  ///< random points per intermediate place, at most

/// Few points of a table over loads or speeds are of many places all the same, because one load and
/// speed says little of the others.
std::size_t points_of_each_place(const CreepTable& table, int count) {
  constexpr std::size_t places = 20;
  if (table.load.size() < 2 && table.speed.size() < 2) return points_of_a_place;
  return std::clamp<std::size_t>(static_cast<std::size_t>(count) / places, 1, points_of_a_place);
}

/// Creepage indices of point `n` of a node of the other axes, in boustrophedon order, so that
/// consecutive points are neighbours.
std::array<std::size_t, 3> to_and_fro(const CreepTable& table, std::size_t n) {
  const std::size_t across = table.creepage[1].size(), spins = table.creepage[2].size();
  const std::size_t row = n / spins, m = n % spins, i = row / across;
  const std::size_t j = i % 2 == 0 ? row % across : across - 1 - row % across;
  return {i, j, row % 2 == 0 ? m : spins - 1 - m};
}

/// Points `begin` to `end` - 1 of a list.
struct TablePart {
  std::size_t begin = 0, end = 0;
};

/// Creepages of consecutive points of a node of the other axes.
std::vector<Scaled> creepages_of(const CreepTable& table, const TablePart& part) {
  std::vector<Scaled> creepages;
  for (std::size_t n = part.begin; n < part.end; ++n) {
    const auto [i, j, k] = to_and_fro(table, n % (table.size() / table.nodes()));
    creepages.push_back({table.creepage[0][i], table.creepage[1][j], table.creepage[2][k]});
  }
  return creepages;
}

/// A list of points, cut into parts of at most 64. No part crosses the border
/// between consecutive groups of `of_a_group` points. The division does not depend on resumed
/// parts, so that results are identical to the last bit.
struct TableParts {
  std::string name;        ///< of the records
  std::string stage;       ///< in progress events
  contact::RunPart own;    ///< parts to solve; others are only read if stored
  std::size_t points = 0;  ///< in the list
  std::size_t of_a_group = 1;
  /// Called by several threads at once.
  std::function<std::vector<TablePoint>(const TablePart&)> solve;
  /// Called for every solved or resumed part, by one thread at a time.
  std::function<void(const TablePart&, const std::vector<TablePoint>&)> done;
};

/// Solves the parts on all cores. `checkpoint` may be null. An exception from solve, done or
/// progress ends the work and is passed on.
void solve_parts(const TableParts& table, const contact::Progress& progress,
                 contact::Checkpoint* checkpoint) {
  contact::CheckpointPart kept(checkpoint, table.name + "-");
  constexpr std::size_t longest_part = 64;  // of what a thread solves and stores as one record
  std::vector<TablePart> parts;
  for (std::size_t begin = 0; begin < table.points; begin = parts.back().end) {
    const std::size_t end_of_group = (begin / table.of_a_group + 1) * table.of_a_group;
    parts.push_back({begin, std::min({begin + longest_part, end_of_group, table.points})});
  }
  const auto name_of = [](std::size_t part) { return fmt::format("{:05}", part); };
  contact::ProgressEvent event;
  event.model = "table";
  event.stage = table.stage;
  event.points = static_cast<int>(table.points);
  const auto add = [&](std::size_t p, const std::vector<TablePoint>& points) {
    table.done(parts[p], points);
    event.point += static_cast<int>(points.size());
  };
  std::vector<std::size_t> missing;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    std::vector<TablePoint> points;
    if (contact::found(kept, name_of(p), [&](contact::Record& record) {
          record.value(points);
          record.demand(points.size() == parts[p].end - parts[p].begin);
        })) {
      add(p, points);
    } else if (table.own.holds(p)) {
      missing.push_back(p);
    }
  }
  contact::report(progress, event);
  std::mutex telling;
  contact::for_each_index(missing.size(), [&](std::size_t n) {
    std::vector<TablePoint> points = table.solve(parts[missing[n]]);
    const std::lock_guard<std::mutex> one_at_a_time(telling);
    add(missing[n], points);
    kept.keep(name_of(missing[n]), contact::record_of(points));
    contact::report(progress, event);
  });
  event.finished = true;
  contact::report(progress, event);
}

void fill_grid(CreepTable& table, const TableSource& source, const contact::Progress& progress,
               contact::Checkpoint* checkpoint, contact::RunPart own) {
  const std::size_t of_a_place = table.size() / table.nodes();
  table.forces.resize(table.size());
  table.bars.resize(table.size());
  table.elements_across.resize(table.size());
  if (table.over_shifts()) table.along_normal.resize(table.size());
  if (table.heat) table.rise.resize(table.size());
  TableParts parts{"table", "points", own, table.size(), of_a_place, {}, {}};
  parts.solve = [&](const TablePart& part) {
    return source.at_node(part.begin / of_a_place, creepages_of(table, part));
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
      if (table.heat) table.rise[at] = point.rise;
    }
  };
  solve_parts(parts, progress, checkpoint);
}

/// Random numbers of a standard library's generator, which are the same everywhere.
class Draw {
 public:
  explicit Draw(unsigned from) : random_(from) {}
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(random_() % n); }
  double share() { return (static_cast<double>(random_()) + 0.5) / 4294967296.0; }

 private:
  std::mt19937 random_;
};

/// A place on an axis, even over its coordinate.
double on(const std::vector<double>& axis, bool logarithmic, double share) {
  const auto coordinate = [&](double x) { return logarithmic ? std::log(x) : x; };
  const double low = coordinate(axis.front()), high = coordinate(axis.back());
  const double x = std::min(low + share * (high - low), high);
  return std::clamp(logarithmic ? std::exp(x) : x, axis.front(), axis.back());
}

constexpr std::size_t of_load = 4, of_speed = 5;  ///< InterpolationError::by_axis

const std::vector<double>& axis_of(const CreepTable& table, std::size_t axis) {
  if (axis == of_load) return table.load;
  if (axis == of_speed) return table.speed;
  return axis == 0 ? table.first_axis() : table.creepage[axis - 1];
}

/// A random place between the nodes of some axes, with the others of `from`; `from` itself where
/// contact jumps at all those drawn, because there is no interpolation.
TablePlace between(const CreepTableReader& reader, const TablePlace& from,
                   const std::vector<std::size_t>& axes, Draw& draw) {
  const CreepTable& table = reader.table();
  for (int tries = 0; tries < 100; ++tries) {
    TablePlace place = from;
    for (const std::size_t axis : axes) {
      double& value = axis == 0 ? place.first : axis == of_load ? place.load : place.speed;
      value = on(axis_of(table, axis), axis > 0 || !table.over_shifts(), draw.share());
    }
    if (!reader.jumps_at(place)) return place;
  }
  return from;
}

/// A point at which interpolation is checked.
struct Check {
  /// The only axis between whose nodes the point is (InterpolationError::by_axis); 0: any.
  std::size_t axis = 0;
  std::size_t node = 0;  ///< of the axes other than the creepages; unused where `axis` is of them
  InterpolatedPoint point;
  bool of_creepage() const { return axis > 0 && axis < of_load; }
};

/// Random points, uniform over the coordinates of the axes, of both signs.
std::vector<Check> points_between(const CreepTableReader& reader, int count) {
  const CreepTable& table = reader.table();
  Draw draw(seed);
  std::vector<std::size_t> axes{0};
  for (const std::size_t axis : {of_load, of_speed})
    if (axis_of(table, axis).size() > 1) axes.push_back(axis);
  std::vector<Check> checks(static_cast<std::size_t>(count));
  TablePlace place;
  const std::size_t of_each = points_of_each_place(table, count);
  for (std::size_t k = 0; k < checks.size(); ++k) {
    if (k % of_each == 0)
      place = between(reader, table.node(k / of_each % table.nodes()), axes, draw);
    checks[k].point.place = place;
    for (std::size_t q = 0; q < 3; ++q) {
      const double end = table_coordinate(table.creepage[q].back());
      checks[k].point.creepage[q] = creepage_at(-end + 2.0 * end * draw.share());
    }
  }
  return checks;
}

/// Of the points of one axis.
InterpolationError error_of(const std::vector<Check>& checks, std::size_t axis = 0) {
  InterpolationError error;
  error.seed = seed;
  std::vector<double> force, moment;
  for (const Check& check : checks) {
    if (check.axis != axis) continue;
    const auto& [place, creepage, found, solved] = check.point;
    force.push_back(std::hypot(found[0] - solved[0], found[1] - solved[1]));
    moment.push_back(std::abs(found[2] - solved[2]));
  }
  error.points = static_cast<int>(force.size());
  if (force.empty()) return error;
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

/// Random points between the nodes of one axis after another, in groups of points_of_a_place: place
/// and creepages are nodes on all axes but one.
std::vector<Check> points_along_axes(const CreepTableReader& reader, int count) {
  const CreepTable& table = reader.table();
  Draw draw(seed + 1);
  std::vector<Check> checks;
  for (std::size_t axis = 0; axis <= of_speed; ++axis) {
    if (axis_of(table, axis).size() < 2) continue;
    const std::size_t groups =
        std::max<std::size_t>(1, static_cast<std::size_t>(count) / (4 * points_of_a_place));
    for (std::size_t g = 0; g < groups; ++g) {
      Check next{axis, draw.below(table.nodes()), {}};
      next.point.place = table.node(next.node);
      if (!next.of_creepage()) next.point.place = between(reader, next.point.place, {axis}, draw);
      for (std::size_t n = 0; n < points_of_a_place; ++n) {
        for (std::size_t q = 0; q < 3; ++q) {
          const std::vector<double>& nodes = table.creepage[q];
          next.point.creepage[q] = nodes[draw.below(nodes.size())];
          if (q + 1 != axis) continue;
          const double low = table_coordinate(nodes.front()), high = table_coordinate(nodes.back());
          next.point.creepage[q] = creepage_at(low + (high - low) * draw.share());
        }
        checks.push_back(next);
      }
    }
  }
  return checks;
}

/// Solves the points and interpolates there; `of_each` consecutive ones are of one place.
void solve_checks(const CreepTableReader& reader, const TableSource& source, const char* name,
                  const char* stage, std::size_t of_each, std::vector<Check>& checks,
                  const contact::Progress& progress, contact::Checkpoint* checkpoint) {
  TableParts parts{name, stage, {}, checks.size(), of_each, {}, {}};
  parts.solve = [&](const TablePart& part) {
    std::vector<Scaled> creepages;
    for (std::size_t k = part.begin; k < part.end; ++k)
      creepages.push_back(checks[k].point.creepage);
    const Check& one = checks[part.begin];
    return one.of_creepage() ? source.at_node(one.node, creepages)
                             : source.between(reader, one.point.place, creepages);
  };
  parts.done = [&](const TablePart& part, const std::vector<TablePoint>& solved) {
    for (std::size_t k = part.begin; k < part.end; ++k) {
      InterpolatedPoint& point = checks[k].point;
      point.solved = solved[k - part.begin].forces;
      point.interpolated = reader.at(point.place, point.creepage).forces;
    }
  };
  solve_parts(parts, progress, checkpoint);
}

void check_interpolation(CreepTable& table, const TableSource& source, int count,
                         const contact::Progress& progress, contact::Checkpoint* checkpoint) {
  CreepTableReader reader(std::move(table));  // avoids a second copy of a large table
  std::vector<Check> checks = points_between(reader, count);
  std::array<double, 6> by_axis{};
  if (!checks.empty()) {
    solve_checks(reader, source, "check", "points between",
                 points_of_each_place(reader.table(), count), checks, progress, checkpoint);
    std::vector<Check> along = points_along_axes(reader, count);
    if (!along.empty())
      solve_checks(reader, source, "axes", "points along axes", points_of_a_place, along, progress,
                   checkpoint);
    for (std::size_t axis = 0; axis < by_axis.size(); ++axis) {
      const InterpolationError error = error_of(along, axis);
      by_axis[axis] = std::max(error.force_95, error.moment_95);
    }
  }
  table = std::move(reader).release();
  table.interpolation = error_of(checks);
  table.interpolation.by_axis = by_axis;
  for (const Check& check : checks) table.checked.push_back(check.point);
}

std::string duration(double seconds) {
  if (seconds < 120.0) return fmt::format("{:.2g} s", std::max(1.0, seconds));
  return seconds < 7200.0 ? fmt::format("{:.0f} min", seconds / 60.0)
                          : fmt::format("{:.1f} h", seconds / 3600.0);
}

/// Reports how long filling will take from a cold start, from some points in the middle of the
/// table.
void forecast(const CreepTable& table, const TableSource& source, int check_points,
              const contact::Progress& progress, contact::RunPart own) {
  constexpr std::size_t sample = 16, worth_a_forecast = 200;
  if (table.size() < worth_a_forecast) return;
  const std::size_t places = table.nodes(), of_a_place = table.size() / places;
  const std::vector<Scaled> creepages =
      creepages_of(table, {of_a_place / 2, std::min(of_a_place / 2 + sample, of_a_place)});
  // CPU time of all threads: other programs would spoil a short sample.
  const std::clock_t begin = std::clock();
  static_cast<void>(source.at_node(places / 2, creepages));
  const double of_a_point = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC /
                            static_cast<double>(creepages.size());
  const double points = static_cast<double>(table.size()) / own.of;
  const double checks = own.whole() ? 2.0 * check_points : 0.0;  // also along the axes
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
                contact::Checkpoint* checkpoint, contact::RunPart own) {
  const std::unique_ptr<TableSource> source =
      table.over_shifts() ? wheel_source(input) : ellipse_source(table, input);
  source->prepare(table, progress);
  if (checkpoint == nullptr || !checkpoint->find("table-00000"))
    forecast(table, *source, input.table.check_points, progress, own);
  fill_grid(table, *source, progress, checkpoint, own);
  if (!own.whole()) return;
  check_interpolation(table, *source, input.table.check_points, progress, checkpoint);
}

}  // namespace rollfem::tables
