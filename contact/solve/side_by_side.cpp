// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/solve/side_by_side.hpp"

#include "base/available_memory.hpp"
#include "base/errors.hpp"
#include "base/threads.hpp"

#include <algorithm>
#include <exception>
#include <mutex>
#include <utility>
#include <vector>

namespace rollfem::contact {

namespace {

/// The load point that ends the level, by an error or (without one) by a patch at the border.
struct End {
  std::size_t point;
  std::exception_ptr error;
};

/// Hands out load points in order, none behind the first that ended the level.
class Points {
 public:
  explicit Points(std::size_t count) : end_{count, {}} {}
  std::optional<std::size_t> next() {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (next_ >= end_.point) return {};
    return next_++;
  }
  void ended_by(const End& end) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (end.point < end_.point) end_ = end;
  }
  const End& end() const { return end_; }

 private:
  std::mutex mutex_;
  std::size_t next_ = 0;
  End end_;
};

/// The load points solved by one thread.
struct Part {
  std::vector<std::size_t> points;
  LevelResult result;
};

void add_effort(const LevelResult& part, LevelResult& whole) {
  for (double LevelResult::*seconds : {&LevelResult::setup_seconds, &LevelResult::normal_seconds,
                                       &LevelResult::tangential_seconds, &LevelResult::steepness})
    whole.*seconds = std::max(whole.*seconds, part.*seconds);
  for (int LevelResult::*count :
       {&LevelResult::newton_steps, &LevelResult::krylov_iterations, &LevelResult::iterations})
    whole.*count = std::max(whole.*count, part.*count);
  whole.several += part.several;
  whole.unsolved.insert(part.unsolved.begin(), part.unsolved.end());
}

LevelResult put_together(std::vector<Part>& parts, std::size_t count) {
  LevelResult whole;
  whole.points.resize(count);
  whole.relative_traction.resize(count);
  for (Part& part : parts) {
    if (part.points.empty()) continue;
    add_effort(part.result, whole);
    for (std::size_t i = 0; i < part.points.size(); ++i) {
      whole.points[part.points[i]] = std::move(part.result.points[i]);
      whole.relative_traction[part.points[i]] = std::move(part.result.relative_traction[i]);
    }
    if (part.points.back() + 1 < count) continue;
    whole.grid = part.result.grid;
    whole.pressure = std::move(part.result.pressure);
    whole.contact_elements = part.result.contact_elements;
  }
  if (whole.unsolved.size() == count) throw NoSteadyFriction(whole.unsolved.rbegin()->second);
  return whole;
}

/// Threads for a grid besides the first: each has its own fields, and all together must fit into
/// memory.
std::size_t further_threads(const ContactGrid& grid) {
  constexpr double worth_a_look = 50e6;
  const double of_a_thread = bytes_per_element * grid.size();
  const auto all = static_cast<std::size_t>(threads() - 1);
  if (of_a_thread < worth_a_look) return all;
  const double fit = available_bytes() / of_a_thread;
  return fit < static_cast<double>(all) ? static_cast<std::size_t>(fit) : all;
}

}  // namespace

std::optional<LevelResult> solve_points(const Scene& scene, const ChartedGeometry& geometry,
                                        const RunOptions& options, const Progress& progress,
                                        PointStore* store, const ContactGrid& grid,
                                        const MakeElasticity& make) {
  ContactRun begun(scene, geometry, options, progress, store);
  if (!begun.begin(grid, make)) return {};
  const std::size_t count = scene.points.size();
  const bool alone = !options.independent || scene.is_history() || scene.load_changes();
  const std::size_t beside = begun.copies_can_solve()
                                 ? 1 + further_threads(grid)
                                 : std::min<std::size_t>(options.most_beside, threads());
  std::vector<Part> parts(alone ? 1 : std::clamp<std::size_t>(beside, 1, count));
  Points points(count);
  const auto solve = [&](ContactRun& run, std::size_t first, Part& part) {
    std::vector<std::size_t>& taken = part.points;
    const auto next = [&] {
      const auto k = taken.empty() ? std::optional(first) : points.next();
      if (k) taken.push_back(*k);
      return k;
    };
    try {
      if (!run.solve_each(next)) points.ended_by({taken.back(), {}});
    } catch (...) {
      points.ended_by({taken.back(), std::current_exception()});
    }
    part.result = run.take_result();
  };
  if (parts.size() == 1) {
    solve(begun, *points.next(), parts.front());
  } else {
    for_each_index(parts.size(), [&](std::size_t p) {
      const std::optional<std::size_t> first = points.next();
      if (!first) return;
      ContactRun run = begun;
      if (!begun.copies_can_solve()) run.begin(grid, make);
      solve(run, *first, parts[p]);
    });
  }
  if (points.end().error) std::rethrow_exception(points.end().error);
  if (points.end().point < count) return {};
  return parts.size() == 1 ? std::move(parts.front().result) : put_together(parts, count);
}

}  // namespace rollfem::contact
