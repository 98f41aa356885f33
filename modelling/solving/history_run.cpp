// SPDX-License-Identifier: LGPL-2.1-or-later
#include "modelling/solving/history_run.hpp"

#include "base/errors.hpp"
#include "base/root.hpp"
#include "base/threads.hpp"
#include "halfspace/patch/load_sharing.hpp"
#include "halfspace/patch/patch_search.hpp"
#include "scene/step_past.hpp"
#include "track/balance/springs.hpp"
#include "track/motion/placed_scenes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <memory>
#include <optional>
#include <utility>

namespace rollfem::modelling {

namespace {

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

using Interval = std::array<double, 2>;

/// Cells of the finest grid, of twice and of four times the size: the error bars of each step come
/// from three histories, and from one in steps twice as long on cells of twice the size.
constexpr std::size_t most_levels = 3;
constexpr int fewest_on_coarsest = 4;
/// Patches by which the size of the elements is chosen.
constexpr std::size_t measured_patches = 9;
/// The sharing of the load among contacts ends when no share changes by more than this part of it.
constexpr double shared_to = 1e-4;
constexpr int most_turns = 20;

/// The origin of a contact in the material of the rail: mm along the way and along the profile, in
/// the direction of the contact's y.
struct Origin {
  double x = 0.0, y = 0.0;
};

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

double apart(const Interval& interval, double y) {
  return std::max({0.0, interval[0] - y, y - interval[1]});
}

/// What all wheels of a history share.
struct Run {
  const Case& input;
  const track::PlacedWheels& placed;
  const std::string& model;
  std::vector<contact::Note> notes;
  const Solving& how;
};

/// What lies on elements of one size, in the material of the rail.
struct Level {
  std::array<double, 2> cell{};
  PastPatches last, before_last;
  std::array<double, 2> lengths{};
  double way = 0.0;  ///< mm rolled up to the last step
  std::vector<contact::PastHeat> heat{};
};

/// One wheel on its rail. Each step: begin, solve (as often as its loads and rotation ask), end.
class WheelHistory {
 public:
  WheelHistory(const Run& run, std::vector<Scene> scenes) : run_(run), scenes_(std::move(scenes)) {
    if (!scenes_.empty()) choose_cells();
  }

  bool touches(std::size_t k) const {
    return next_ < scenes_.size() && scenes_[next_].place->position == static_cast<int>(k) + 1;
  }

  void begin(std::size_t k) {
    skip_to(k);
    std::vector<Scene> contacts;
    for (; touches(k); ++next_) contacts.push_back(scenes_[next_]);
    take(std::move(contacts));
    steady_ = contacts_.front().problem_of(0) == Problem::steady;
    length_ = run_.input.history.at(k).step_length;
    if (!steady_) way_ += length_;
    if (!first_) first_ = origin_of(contacts_.front());
    step_ = k;
    // From rest two steps are one as long as both.
    if (k == began_ && !steady_)
      doubled_[(k + 1) % 2] = {coarse().cell, {}, {}, {}, way_ - length_};
  }

  /// Puts the wheel where the springs under its rail hold it.
  void settle() {
    const Case here = track::case_at(run_.input, step_);
    const auto place = [&](const track::RailVector& at) {
      take(
          track::on_moved_rail(here, run_.placed.search, static_cast<int>(step_) + 1, at).balanced);
    };
    rail_ = track::settled_rail(here, rail_, [&](const track::RailVector& at) {
      place(at);
      track::RailVector force{};
      for (const ModelResult& result : solve(true))
        track::add_force_on_rail(*result.place, result.points.front().normal_force,
                                 result.points.front().lateral_force, force);
      return force;
    });
    place(rail_);
  }

  /// Gives the contacts the creepages of a rotation of the wheel.
  void turn(double rotation) {
    const Case here = track::case_at(run_.input, step_);
    for (Scene& scene : contacts_) {
      track::PlacedScene placed{scene, track::contact_of(scene, run_.placed.scenes)};
      track::set_rotation_changes(placed, here, {rotation});
      scene = std::move(placed.scene);
    }
  }

  /// F_x of the wheel times minus its radius, or the moment about its axle, N mm, on the finest
  /// elements; the load of the wheel, N.
  std::array<double, 2> torque() {
    const bool by_force = run_.input.wheelset.free_rolling == FreeRolling::force;
    double sum = 0.0, load = 0.0;
    const std::vector<ModelResult> results = solve(true);
    for (std::size_t c = 0; c < results.size(); ++c) {
      const contact::PointResult& point = results[c].points.front();
      load += point.normal_force;
      sum += by_force ? -point.longitudinal_force * run_.input.wheel.rolling_radius
                      : track::driving_moment(track::contact_of(contacts_[c], run_.placed.scenes),
                                              {point.longitudinal_force, point.lateral_force,
                                               point.normal_force, point.spin_moment});
    }
    return {sum, load};
  }

  std::vector<ModelResult> solve(bool finest_alone = false) {
    const contact::HistoryStep& given = run_.input.history.at(step_);
    const auto load = given.vertical_force ? given.vertical_force : run_.input.load.vertical_force;
    for (int turn = 0;; ++turn) {
      for (std::size_t c = 0; c < contacts_.size(); ++c)
        contacts_[c].past = past_of(c, finest_alone);
      contact::CheckpointPart kept(run_.how.checkpoint,
                                   turn > 0 ? fmt::format("turn{}-", turn) : "");
      Solving how = run_.how;
      how.checkpoint = run_.how.checkpoint != nullptr && !finest_alone ? &kept : nullptr;
      std::vector<ModelResult> results;
      auto notes = run_.notes;
      if (run_.input.track.rail_stiffness)
        notes.push_back({"rail_springs", track::springs_text(rail_)});
      for (const Scene& scene : contacts_)
        results.push_back(solve_scene(run_.model, scene, notes, how));
      if (contacts_.size() < 2 || !load || !share(*load, results)) return results;
      if (turn == most_turns)
        throw contact::SolveError(
            contacts_.front().where(),
            "the shares of {} contacts in {:g} N do not settle with the friction of this step in "
            "{} turns",
            contacts_.size(), *load, most_turns);
    }
  }

  /// Hands on what the step has left.
  void end(const std::vector<ModelResult>& results) {
    if (results.empty()) {  // a rail that has given way
      way_ -= steady_ ? 0.0 : length_;
      return;
    }
    const std::size_t more = doubles() ? 1 : 0;
    for (std::size_t n = 0; n < levels_.size(); ++n) hand_on(levels_[n], levels_.size() - n + more);
    Level& doubled = doubled_[step_ % 2];
    if (more > 0) hand_on(doubled, 1);
    // Such a history begins with single steps, and anew where it had no solution.
    if (more == 0 || doubled.last.empty()) doubled = coarse();
    creepages_.clear();
    for (const Scene& scene : contacts_)
      creepages_.emplace_back(origin_of(scene).y, scene.points.front().creepage);
    past_.steps = static_cast<int>(step_) + 1;
    const contact::PointResult& point = results.front().points.front();
    past_.distance = point.distance;
    past_.shift = {point.longitudinal_shift, point.lateral_shift, point.spin_shift};
  }

 private:
  void take(std::vector<Scene> contacts) {
    contacts_ = std::move(contacts);
    for (Scene& scene : contacts_) scene.contact_grid.cell_size = levels_.back().cell;
  }

  /// As many elements across as asked for in the middle one of some patches.
  void choose_cells() {
    std::vector<double> lengths, widths;
    const std::size_t count = std::min(measured_patches, scenes_.size());
    for (std::size_t k = 0; k < count; ++k) {
      const Scene& scene = scenes_[k * (scenes_.size() - 1) / std::max<std::size_t>(1, count - 1)];
      if (scene.place->patch > 1 && k > 0) continue;
      const halfspace::PatchExtent extent = halfspace::PatchSearch(scene).extent();
      lengths.push_back(extent.length);
      widths.push_back(extent.width);
    }
    for (std::vector<double>* sizes : {&lengths, &widths}) std::sort(sizes->begin(), sizes->end());
    const double length = lengths[lengths.size() / 2], width = widths[widths.size() / 2];
    const double across = run_.input.contact_grid.elements_across;
    auto cell = run_.input.contact_grid.cell_size.value_or(
        std::array<double, 2>{length / across, width / across});
    double fewest = std::min(length / cell[0], width / cell[1]);
    for (; levels_.size() < 2 || (levels_.size() < most_levels && fewest >= fewest_on_coarsest);
         fewest *= 0.5) {
      levels_.insert(levels_.begin(), Level{cell, {}, {}, {}});
      for (double& side : cell) side *= 2.0;
    }
  }

  Origin origin_of(const Scene& scene) const {
    const contact::ContactPlace& place = *scene.place;
    return {way_ + place.x_track,
            place.outward() * run_.placed.search.profiles.rail.parameter_at(place.y_rail)};
  }

  /// Steps in which the wheel has not touched its rail leave nothing.
  void skip_to(std::size_t k) {
    for (auto missed = static_cast<std::size_t>(past_.steps); missed < k; ++missed) {
      const double length = run_.input.history.at(missed).step_length;
      way_ += length;
      past_.distance += length;
      for (Level& level : levels_) level = {level.cell, {}, {}, {}, way_};
      began_ = k;
    }
  }

  /// Whether this step and the one before are solved as one step, too.
  bool doubles() const {
    const bool after_steady = run_.input.starts_steady && began_ == 0;
    return !steady_ && length_ > 0.0 && step_ > began_ + (after_steady ? 1 : 0);
  }

  const Level& coarse() const { return levels_[levels_.size() - 2]; }

  std::shared_ptr<const StepPast> past_of(std::size_t own, bool finest_alone) const {
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
    const Level& before = doubled_[step_ % 2];
    const double length = way_ - before.way;
    past->doubled = {seen(before), length, mean_creepage(own, length_ / length)};
    return past;
  }

  /// Of this step, with its part of the way, and the one before.
  contact::Creepage mean_creepage(std::size_t own, double part) const {
    const contact::Creepage& now = contacts_[own].points.front().creepage;
    const double y = origin_of(contacts_[own]).y;
    const auto nearest =
        std::min_element(creepages_.begin(), creepages_.end(), [y](const auto& a, const auto& b) {
          return std::abs(a.first - y) < std::abs(b.first - y);
        });
    if (nearest == creepages_.end() || creepages_.size() != contacts_.size()) return now;
    const contact::Creepage& before = nearest->second;
    const auto mean = [part](double a, double b) { return part * a + (1.0 - part) * b; };
    return {mean(now.longitudinal, before.longitudinal), mean(now.lateral, before.lateral),
            mean(now.spin, before.spin)};
  }

  /// The rows of earlier patches that a contact covers, which are nearer to it than to the others.
  static PastPatches inherited(const PastPatches& earlier, const std::vector<Interval>& ranges,
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
  /// keep nothing of it. Steady rolling leaves what it would have left one step before too, if the
  /// lattice has that place.
  void hand_on(Level& level, std::size_t from_end) const {
    const double length = steady_ ? next_length() : way_ - level.way;
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
    if (!steady_) return;
    const double elements = length / level.cell[0];
    const bool whole = std::abs(elements - std::round(elements)) < 1e-9 * elements;
    level.before_last = whole ? level.last : PastPatches();
    level.lengths[1] = whole ? length : 0.0;
    for (PastPatch& patch : level.before_last) move(patch.grid, -length, 0.0);
  }

  /// Keeps the heat of twice the length of the patches.
  static void remember(contact::PastHeat heat, std::vector<contact::PastHeat>& all) {
    double kept = 0.0;
    for (const PastPatch& patch : heat.patches)
      kept = std::max(kept, 2.0 * patch.grid.nx * patch.grid.dx);
    all.insert(all.begin(), std::move(heat));
    contact::keep_within(kept, all);
  }

  double next_length() const {
    const auto& steps = run_.input.history;
    return step_ + 1 < steps.size() ? steps[step_ + 1].step_length : 0.0;
  }

  /// Shares the load with the friction of the results; whether shares have changed.
  bool share(double load, const std::vector<ModelResult>& results) {
    std::vector<halfspace::ForceRatio> ratios;
    for (const ModelResult& result : results) {
      const contact::PointResult& point = result.points.front();
      ratios.push_back(std::array{point.longitudinal_force / point.normal_force,
                                  point.lateral_force / point.normal_force});
    }
    const halfspace::SharedLoad shared = halfspace::share_load(contacts_, load, ratios);
    double change = 0.0, sum = 0.0;
    for (const halfspace::PatchLoad& one : shared.shares) sum += one.vertical_force;
    const auto force_of = [&](std::size_t c) {
      return shared.shares[c].vertical_force * load / sum;
    };
    for (std::size_t c = 0; c < contacts_.size(); ++c) {
      const double before = contacts_[c].points.front().load.force.value_or(0.0);
      change = std::max(change, std::abs(force_of(c) - before) / load);
    }
    if (change <= shared_to) return false;
    std::vector<Scene> loaded;
    for (std::size_t c = 0; c < contacts_.size(); ++c) {
      contacts_[c].points.front().load.force = force_of(c);
      contacts_[c].neighbour_loads = shared.shares[c].neighbour_loads;
      if (shared.shares[c].normal_force > shared_to * load)
        loaded.push_back(std::move(contacts_[c]));
    }
    contacts_ = std::move(loaded);
    return true;
  }

  const Run& run_;
  std::vector<Scene> scenes_;     ///< of all steps
  std::size_t next_ = 0;          ///< the first one of the steps to come
  std::vector<Level> levels_;     ///< the coarsest first
  std::array<Level, 2> doubled_;  ///< in double steps, which end at even and odd ones
  std::optional<Origin> first_;   ///< a corner of the lattice, once a contact is known
  double way_ = 0.0;              ///< mm rolled
  track::RailVector rail_{};      ///< where its springs hold the rail
  StepPast past_;                 ///< sums of the steps so far; without levels
  std::size_t began_ = 0;         ///< the step in which the wheel has touched its rail
  /// Of the step before, with the place of the contacts across.
  std::vector<std::pair<double, contact::Creepage>> creepages_;

  // The step that is being solved.
  std::size_t step_ = 0;
  std::vector<Scene> contacts_;
  bool steady_ = false;
  double length_ = 0.0;
};

/// Turns wheels together so that they transmit what the case asks of them; returns the rotation
/// (Wheelset::rotation_change).
double find_rotation(const Run& run, const std::vector<WheelHistory*>& wheels, std::size_t k,
                     double start) {
  constexpr double step = 2e-4, largest = 1.0, tolerance = 1e-10, small = 1e-5;
  const contact::Wheelset& given = run.input.wheelset;
  const bool by_force = given.free_rolling == FreeRolling::force;
  const std::vector<double>& asked = by_force ? given.longitudinal_force : given.axle_torque;
  const double radius = run.input.wheel.rolling_radius;
  const double wanted = asked.empty() ? 0.0 : by_force ? -asked.at(k) * radius : asked.at(k);
  double left = 0.0, reach = 0.0;
  const auto left_at = [&](double rotation) {
    left = -wanted;
    reach = 0.0;
    for (WheelHistory* wheel : wheels) {
      wheel->turn(rotation);
      const auto [torque, load] = wheel->torque();
      left += torque;
      reach += run.input.friction_coefficient * load * radius;
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
        k + 1, by_force ? "longitudinal_force" : "axle_torque", asked.empty() ? 0.0 : asked.at(k),
        std::abs(left), reach));
  for (WheelHistory* wheel : wheels) wheel->turn(*found);
  return *found;
}

}  // namespace

std::vector<ModelResult> solve_history(const Case& input, const track::PlacedWheels& placed,
                                       const std::string& model, const Scenes& scenes,
                                       const Solving& how) {
  if (!how.models->at(model).joins_planes)
    throw contact::InputError(
        {input.file},
        "model {}: the positions of this wheel are the steps of a history, in which the contact "
        "moves; allowed: halfspace; do: run with --model halfspace, or give one position",
        model);
  Run run{input, placed, model, scenes.notes, how};
  run.notes.push_back({"steps",
                       "the positions of this wheel follow each other; elements lie on one lattice "
                       "in the material of the rail"});
  std::array<std::vector<Scene>, 2> of;
  for (const Scene& scene : scenes.list) of[scene.place->left ? 0 : 1].push_back(scene);
  std::array wheels{WheelHistory(run, of[0]), WheelHistory(run, of[1])};
  std::array<double, 2> rotations{};
  std::vector<ModelResult> all;
  for (std::size_t k = 0; k < input.history.size(); ++k) {
    std::vector<std::size_t> touching;
    for (std::size_t w = 0; w < wheels.size(); ++w)
      if (wheels[w].touches(k)) touching.push_back(w);
    std::array<std::vector<ModelResult>, 2> results;
    if (input.wheelset.free_rolling == FreeRolling::torque && !touching.empty()) {
      std::vector<WheelHistory*> together;
      for (const std::size_t w : touching) {
        wheels[w].begin(k);
        together.push_back(&wheels[w]);
      }
      rotations[0] = find_rotation(run, together, k, rotations[0]);
    }
    contact::for_each_index(touching.size(), [&](std::size_t t) {
      const std::size_t w = touching[t];
      if (input.wheelset.free_rolling != FreeRolling::torque) wheels[w].begin(k);
      if (input.wheelset.free_rolling == FreeRolling::force)
        rotations[w] = find_rotation(run, {&wheels[w]}, k, rotations[w]);
      if (input.track.rail_stiffness) wheels[w].settle();
      results[w] = wheels[w].solve();
      wheels[w].end(results[w]);
    });
    for (std::vector<ModelResult>& found : results)
      std::move(found.begin(), found.end(), std::back_inserter(all));
  }
  return all;
}

}  // namespace rollfem::modelling
