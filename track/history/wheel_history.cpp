// SPDX-License-Identifier: LGPL-2.1-or-later
#include "track/history/wheel_history.hpp"

#include "base/errors.hpp"
#include "base/root.hpp"
#include "halfspace/patch/load_sharing.hpp"
#include "halfspace/patch/patch_search.hpp"
#include "track/motion/placed_scenes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

namespace rollfem::track {

using contact::Case;
using contact::ContactGrid;
using contact::Field;
using contact::FreeRolling;
using contact::ModelResult;
using contact::PastLevel;
using contact::PastPatch;
using contact::PastPatches;
using contact::Problem;
using contact::Scene;
using contact::StepPast;

namespace {

/// Cells of the finest grid, of twice and of four times the size: the error bars of each step come
/// from three histories, and from one in steps twice as long on cells of twice the size.
constexpr std::size_t most_levels = 3;
constexpr int fewest_on_coarsest = 4;
/// Patches by which the size of the elements is chosen.
constexpr std::size_t measured_patches = 9;
/// The sharing of the load among contacts ends when no share changes by more than this part of it.
constexpr double shared_to = 1e-4;
constexpr int most_turns = 20;

void move(ContactGrid& grid, double x, double y) {
  grid.x_first += x;
  grid.y_first += y;
}

/// The rows j with `keeps(y)` of a patch, as patches of successive rows.
template <class Keeps>
void add_rows(const PastPatch& patch, const Keeps& keeps, PastPatches& parts) {
  const ContactGrid& grid = patch.grid;
  for (int first = 0; first < grid.ny;) {
    int end = first;
    while (end < grid.ny && keeps(grid.y(end))) ++end;
    if (end > first) {
      PastPatch part;
      part.grid = {grid.nx, end - first, grid.dx, grid.dy, grid.x_first, grid.y(first)};
      const auto cut = [&](const Field& values, Field& rows) {
        if (values.size() > 0) rows = values.segment(grid.index(0, first), part.grid.size());
      };
      cut(patch.traction.x, part.traction.x);
      cut(patch.traction.y, part.traction.y);
      cut(patch.traction.n, part.traction.n);
      cut(patch.coefficient, part.coefficient);
      cut(patch.plastic, part.plastic);
      cut(patch.heat_wheel, part.heat_wheel);
      cut(patch.heat_rail, part.heat_rail);
      parts.push_back(std::move(part));
    }
    first = end + 1;
  }
}

double apart(const std::array<double, 2>& interval, double y) {
  return std::max({0.0, interval[0] - y, y - interval[1]});
}

/// Keeps the heat of twice the length of the patches.
void remember(contact::PastHeat heat, std::vector<contact::PastHeat>& all) {
  double kept = 0.0;
  for (const PastPatch& patch : heat.patches)
    kept = std::max(kept, 2.0 * patch.grid.nx * patch.grid.dx);
  all.insert(all.begin(), std::move(heat));
  contact::keep_within(kept, all);
}

}  // namespace

std::vector<CellSize> cells_of_levels(const Case& input, const std::vector<Scene>& scenes) {
  std::vector<double> lengths, widths;
  const std::size_t count = std::min(measured_patches, scenes.size());
  for (std::size_t k = 0; k < count; ++k) {
    const Scene& scene = scenes[k * (scenes.size() - 1) / std::max<std::size_t>(1, count - 1)];
    if (scene.place->patch > 1 && k > 0) continue;
    const halfspace::PatchExtent extent = halfspace::PatchSearch(scene).extent();
    lengths.push_back(extent.length);
    widths.push_back(extent.width);
  }
  for (std::vector<double>* sizes : {&lengths, &widths}) std::sort(sizes->begin(), sizes->end());
  const double length = lengths[lengths.size() / 2], width = widths[widths.size() / 2];
  const double across = input.contact_grid.elements_across;
  CellSize cell = input.contact_grid.cell_size.value_or(CellSize{length / across, width / across});
  std::vector<CellSize> cells;
  for (double fewest = std::min(length / cell[0], width / cell[1]);
       cells.size() < 2 || (cells.size() < most_levels && fewest >= fewest_on_coarsest);
       fewest *= 0.5) {
    cells.insert(cells.begin(), cell);
    for (double& side : cell) side *= 2.0;
  }
  return cells;
}

WheelHistory::WheelHistory(const std::vector<CellSize>& levels, std::vector<contact::Note> notes,
                           Solve solve, contact::Checkpoint* checkpoint)
    : notes_(std::move(notes)), solve_(std::move(solve)), checkpoint_(checkpoint) {
  for (const CellSize& cell : levels) levels_.push_back({cell});
}

void WheelHistory::begin(Case here, std::vector<Scene> contacts, const PlacedWheels& placed) {
  here_ = std::move(here);
  placed_ = &placed;
  settled_.clear();
  take(std::move(contacts));
  length_ = here_.history.front().step_length;
  if (std::exchange(steady_, contacts_.front().problem_of(0) == Problem::steady)) {
    for (Level& level : levels_) extend_steady(length_, level);
    for (Level& level : doubled_) extend_steady(length_, level);
  }
  if (!steady_) way_ += length_;
  if (!first_) first_ = origin_of(contacts_.front());
  if (past_.steps == began_) from_steady_ = steady_;
  // From rest two steps are one as long as both.
  if (past_.steps == began_ && !steady_ && levels_.size() > 1)
    doubled_[static_cast<std::size_t>(past_.steps + 1) % 2] = {
        coarse().cell, {}, {}, {}, way_ - length_};
}

void WheelHistory::settle() {
  const int position = contacts_.front().place->position;
  const auto place = [&](const RailVector& at) {
    WheelOnRail wheel = on_moved_rail(here_, placed_->search, position, at);
    settled_ = std::move(wheel.placed);
    take(std::move(wheel.balanced));
  };
  rail_ = settled_rail(here_, rail_, [&](const RailVector& at) {
    place(at);
    RailVector force{};
    const std::vector<ModelResult> results = solve(true);
    for (std::size_t c = 0; c < results.size(); ++c)
      add_force_on_rail(*contacts_[c].place, results[c].points.front().normal_force,
                        results[c].points.front().lateral_force, force);
    return force;
  });
  place(rail_);
}

void WheelHistory::turn(double rotation) {
  for (Scene& scene : contacts_) {
    PlacedScene turned{scene, contact_of(scene, placed())};
    set_rotation_changes(turned, here_, {rotation});
    scene = std::move(turned.scene);
  }
}

std::array<double, 2> WheelHistory::torque() {
  const bool by_force = here_.wheelset.free_rolling == FreeRolling::force;
  double sum = 0.0, load = 0.0;
  const std::vector<ModelResult> results = solve(true);
  for (std::size_t c = 0; c < results.size(); ++c) {
    const contact::PointResult& point = results[c].points.front();
    load += point.normal_force;
    sum += by_force ? -point.longitudinal_force * here_.wheel.rolling_radius
                    : driving_moment(contact_of(contacts_[c], placed()),
                                     {point.longitudinal_force, point.lateral_force,
                                      point.normal_force, point.spin_moment});
  }
  return {sum, load};
}

std::vector<ModelResult> WheelHistory::solve(bool finest_alone) {
  const auto given = here_.history.front().vertical_force;
  const auto load = given ? given : here_.load.vertical_force;
  for (int turn = 0;; ++turn) {
    for (std::size_t c = 0; c < contacts_.size(); ++c) contacts_[c].past = past_of(c, finest_alone);
    contact::CheckpointPart kept(checkpoint_, turn > 0 ? fmt::format("turn{}-", turn) : "");
    std::vector<ModelResult> results;
    auto notes = notes_;
    if (here_.track.rail_stiffness) notes.push_back({"rail_springs", springs_text(rail_)});
    for (const Scene& scene : contacts_)
      results.push_back(
          solve_(scene, notes, checkpoint_ != nullptr && !finest_alone ? &kept : nullptr));
    if (contacts_.size() < 2 || !load || !share(*load, results)) return results;
    if (turn == most_turns)
      throw contact::SolveError(
          contacts_.front().where(),
          "the shares of {} contacts in {:g} N do not settle with the friction of this step in {} "
          "turns",
          contacts_.size(), *load, most_turns);
  }
}

void WheelHistory::end(const std::vector<ModelResult>& results) {
  if (results.empty()) {  // a rail that has given way
    way_ -= steady_ ? 0.0 : length_;
    return miss(length_);
  }
  const std::size_t more = doubles() ? 1 : 0;
  for (std::size_t n = 0; n < levels_.size(); ++n) hand_on(levels_[n], levels_.size() - n + more);
  Level& doubled = doubled_[static_cast<std::size_t>(past_.steps) % 2];
  if (more > 0) hand_on(doubled, 1);
  // Such a history begins with single steps, and anew where it had no solution.
  if (levels_.size() > 1 && (more == 0 || doubled.last.empty())) doubled = coarse();
  creepages_.clear();
  for (const Scene& scene : contacts_)
    creepages_.emplace_back(origin_of(scene).y, scene.points.front().creepage);
  ++past_.steps;
  const contact::PointResult& point = results.front().points.front();
  past_.distance = point.distance;
  past_.shift = {point.longitudinal_shift, point.lateral_shift, point.spin_shift};
}

void WheelHistory::miss(double length) {
  way_ += length;
  past_.distance += length;
  for (Level& level : levels_) level = {level.cell, {}, {}, {}, way_};
  steady_ = false;
  began_ = ++past_.steps;
}

void WheelHistory::take(std::vector<Scene> contacts) {
  contacts_ = std::move(contacts);
  for (Scene& scene : contacts_) scene.contact_grid.cell_size = levels_.back().cell;
}

WheelHistory::Origin WheelHistory::origin_of(const Scene& scene) const {
  const contact::ContactPlace& place = *scene.place;
  return {way_ + place.x_track,
          place.outward() * placed_->search.profiles.rail.parameter_at(place.y_rail)};
}

/// Whether this step and the one before are solved as one step, too.
bool WheelHistory::doubles() const {
  return levels_.size() > 1 && !steady_ && length_ > 0.0 &&
         past_.steps > began_ + (from_steady_ ? 1 : 0);
}

std::shared_ptr<const StepPast> WheelHistory::past_of(std::size_t own, bool finest_alone) const {
  std::vector<Interval> ranges;
  for (const Scene& scene : contacts_) {
    const halfspace::PatchSearch search(scene, halfspace::SearchDetail::box);
    const double y = origin_of(scene).y;
    ranges.push_back({y + search.patch().y_lower, y + search.patch().y_upper});
  }
  const Origin origin = origin_of(contacts_[own]);
  const auto seen = [&](const Level& level) {
    PastLevel here;
    here.cell = level.cell;
    here.middle = {-std::remainder(origin.x - first_->x, level.cell[0]),
                   -std::remainder(origin.y - first_->y, level.cell[1])};
    here.lengths = level.lengths;
    here.last = inherited(level.last, ranges, own, origin);
    here.before_last = inherited(level.before_last, ranges, own, origin);
    for (const contact::PastHeat& step : level.heat)
      here.heat.push_back({step.length, inherited(step.patches, ranges, own, {0.0, origin.y})});
    return here;
  };
  auto past = std::make_shared<StepPast>(past_);
  past->left = std::make_shared<PastPatches>();
  for (const Level& level : levels_)
    if (!finest_alone || &level == &levels_.back()) past->levels.push_back(seen(level));
  if (!doubles() || finest_alone) return past;
  const Level& before = doubled_[static_cast<std::size_t>(past_.steps) % 2];
  const double length = way_ - before.way;
  past->doubled = {seen(before), length, mean_creepage(own, length_ / length)};
  return past;
}

/// Of this step, with its part of the way, and the one before.
contact::Creepage WheelHistory::mean_creepage(std::size_t own, double part) const {
  const contact::Creepage& now = contacts_[own].points.front().creepage;
  const double y = origin_of(contacts_[own]).y;
  const auto nearest = std::min_element(
      creepages_.begin(), creepages_.end(),
      [y](const auto& a, const auto& b) { return std::abs(a.first - y) < std::abs(b.first - y); });
  if (nearest == creepages_.end() || creepages_.size() != contacts_.size()) return now;
  const contact::Creepage& before = nearest->second;
  const auto mean = [part](double a, double b) { return part * a + (1.0 - part) * b; };
  return {mean(now.longitudinal, before.longitudinal), mean(now.lateral, before.lateral),
          mean(now.spin, before.spin)};
}

/// The rows of earlier patches that a contact covers, which are nearer to it than to the others.
PastPatches WheelHistory::inherited(const PastPatches& earlier, const std::vector<Interval>& ranges,
                                    std::size_t own, const Origin& origin) {
  PastPatches found;
  for (const PastPatch& patch : earlier) {
    const ContactGrid& grid = patch.grid;
    constexpr double near = 3.0;  // elements
    if (grid.y(grid.ny - 1) < ranges[own][0] - near * grid.dy ||
        grid.y_first > ranges[own][1] + near * grid.dy)
      continue;
    add_rows(
        patch,
        [&](double y) {
          for (std::size_t c = 0; c < ranges.size(); ++c)
            if (c != own && (apart(ranges[c], y) < apart(ranges[own], y) ||
                             (c < own && apart(ranges[c], y) == apart(ranges[own], y))))
              return false;
          return true;
        },
        found);
  }
  for (PastPatch& patch : found) move(patch.grid, -origin.x, -origin.y);
  return found;
}

/// `from_end`: which of what each contact has left. Elements on which a contact had no solution
/// keep nothing of it.
void WheelHistory::hand_on(Level& level, std::size_t from_end) const {
  const double length = steady_ ? 0.0 : way_ - level.way;
  level.before_last = std::move(level.last);
  level.last.clear();
  contact::PastHeat heat{steady_ ? contact::infinity : length, {}};
  for (const Scene& scene : contacts_) {
    const PastPatches& all = *scene.past->left;
    PastPatch left = all.at(all.size() - from_end);
    if (left.grid.size() == 0) continue;
    const Origin origin = origin_of(scene);
    if (left.heat_wheel.size() > 0) {
      heat.patches.push_back({left.grid, {}, {}, {}, left.heat_wheel, left.heat_rail});
      move(heat.patches.back().grid, 0.0, origin.y);
    }
    move(left.grid, origin.x, origin.y);
    level.last.push_back(std::move(left));
  }
  if (contacts_.front().heat) remember(std::move(heat), level.heat);
  level.lengths = {length, level.lengths[0]};
  level.way = way_;
}

/// Steady rolling leaves what it would have left one step before too, if the lattice has that
/// place.
void WheelHistory::extend_steady(double length, Level& level) {
  if (level.last.empty()) return;
  const double elements = length / level.cell[0];
  const bool whole = std::abs(elements - std::round(elements)) < 1e-9 * elements;
  level.before_last = whole ? level.last : PastPatches();
  level.lengths = {length, whole ? length : 0.0};
  for (PastPatch& patch : level.before_last) move(patch.grid, -length, 0.0);
}

/// Shares the load with the friction of the results; whether shares have changed.
bool WheelHistory::share(double load, const std::vector<ModelResult>& results) {
  std::vector<halfspace::ForceRatio> ratios;
  for (const ModelResult& result : results) {
    const contact::PointResult& point = result.points.front();
    ratios.push_back(std::array{point.longitudinal_force / point.normal_force,
                                point.lateral_force / point.normal_force});
  }
  const halfspace::SharedLoad shared = halfspace::share_load(contacts_, load, ratios);
  double change = 0.0, sum = 0.0;
  for (const halfspace::PatchLoad& one : shared.shares) sum += one.vertical_force;
  const auto force_of = [&](std::size_t c) { return shared.shares[c].vertical_force * load / sum; };
  for (std::size_t c = 0; c < contacts_.size(); ++c) {
    const double before = contacts_[c].points.front().load.force.value_or(0.0);
    change = std::max(change, std::abs(force_of(c) - before) / load);
  }
  if (change <= shared_to) return false;
  std::vector<Scene> loaded;
  for (std::size_t c = 0; c < contacts_.size(); ++c) {
    contacts_[c].points.front().load.force = force_of(c);
    contacts_[c].neighbour_loads = shared.shares[c].neighbour_loads;
    if (shared.shares[c].normal_force > shared_to * load) loaded.push_back(std::move(contacts_[c]));
  }
  contacts_ = std::move(loaded);
  return true;
}

double find_rotation(const std::vector<WheelHistory*>& wheels, double start) {
  constexpr double step = 2e-4, largest = 1.0, tolerance = 1e-10, small = 1e-5;
  const Case& here = wheels.front()->here();
  const contact::Wheelset& given = here.wheelset;
  const bool by_force = given.free_rolling == FreeRolling::force;
  const std::vector<double>& asked = by_force ? given.longitudinal_force : given.axle_torque;
  const double radius = here.wheel.rolling_radius;
  const double wanted = asked.empty() ? 0.0 : by_force ? -asked.front() * radius : asked.front();
  double left = 0.0, reach = 0.0;
  const auto left_at = [&](double rotation) {
    left = -wanted;
    reach = 0.0;
    for (WheelHistory* wheel : wheels) {
      wheel->turn(rotation);
      const auto [torque, load] = wheel->torque();
      left += torque;
      reach += here.friction_coefficient * load * radius;
    }
    return std::abs(left) <= small * reach ? 0.0 : left;
  };
  // A wheel that turns faster is held back more by the rail.
  const double at_start = left_at(start);
  const auto found =
      contact::root_from(left_at, start, at_start, at_start > 0.0 ? start + step : start - step,
                         largest, tolerance, "rotation in a step");
  if (!found)
    throw contact::SolveError(fmt::format(
        "step {}: no rotation transmits the given {} of {:.6g}; {:.4g} N mm are left, and friction "
        "carries at most {:.4g} N mm; allowed: less than that",
        wheels.front()->steps() + 1, by_force ? "longitudinal_force" : "axle_torque",
        asked.empty() ? 0.0 : asked.front(), std::abs(left), reach));
  for (WheelHistory* wheel : wheels) wheel->turn(*found);
  return *found;
}

}  // namespace rollfem::track
