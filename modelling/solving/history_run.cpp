// SPDX-License-Identifier: LGPL-2.1-or-later
#include "modelling/solving/history_run.hpp"

#include "base/errors.hpp"
#include "base/threads.hpp"
#include "halfspace/patch/load_sharing.hpp"
#include "halfspace/patch/patch_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <memory>
#include <utility>

namespace rollfem::modelling {

namespace {

using contact::Case;
using contact::ContactGrid;
using contact::Field;
using contact::ModelResult;
using contact::PastLevel;
using contact::PastPatch;
using contact::PastPatches;
using contact::Problem;
using contact::Scene;
using contact::StepPast;

using Interval = std::array<double, 2>;

/// Cells of the finest grid, of twice and of four times the size: the error bars of each step come
/// from three histories.
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
      parts.push_back(std::move(part));
    }
    first = end + 1;
  }
}

double apart(const Interval& interval, double y) {
  return std::max({0.0, interval[0] - y, y - interval[1]});
}

/// One wheel on its rail.
class WheelHistory {
 public:
  WheelHistory(const Case& input, const track::SearchScene& search, const std::string& model,
               const Scenes& scenes, const Solving& how)
      : input_(input), search_(search), model_(model), notes_(scenes.notes), how_(how) {
    notes_.push_back(
        {"steps",
         "the positions of this wheel follow each other; elements lie on one lattice in "
         "the material of the rail; error bars leave out the length of the steps"});
  }

  void add(const Scene& scene) { scenes_.push_back(scene); }

  /// Results in the order of the scenes.
  std::vector<ModelResult> solve() {
    std::vector<ModelResult> all;
    if (scenes_.empty()) return all;
    choose_cells();
    for (auto first = scenes_.begin(); first != scenes_.end();) {
      const auto end = std::find_if(first, scenes_.end(), [&](const Scene& scene) {
        return scene.place->position != first->place->position;
      });
      std::vector<ModelResult> results = step({first, end});
      std::move(results.begin(), results.end(), std::back_inserter(all));
      first = end;
    }
    return all;
  }

 private:
  /// What lies on the elements of one size, in the material of the rail.
  struct Level {
    std::array<double, 2> cell{};
    PastPatches last, before_last;
    std::array<double, 2> lengths{};
  };

  /// As many elements across as asked for in the middle one of some patches.
  void choose_cells() {
    std::vector<double> lengths, widths;
    for (std::size_t k = 0; k < std::min(measured_patches, scenes_.size()); ++k) {
      const std::size_t parts =
          std::max<std::size_t>(1, std::min(measured_patches, scenes_.size()) - 1);
      const Scene& scene = scenes_[k * (scenes_.size() - 1) / parts];
      if (scene.place->patch > 1 && k > 0) continue;
      const halfspace::PatchExtent extent = halfspace::PatchSearch(scene).extent();
      lengths.push_back(extent.length);
      widths.push_back(extent.width);
    }
    for (std::vector<double>* sizes : {&lengths, &widths}) std::sort(sizes->begin(), sizes->end());
    const double length = lengths[lengths.size() / 2], width = widths[widths.size() / 2];
    const double across = input_.contact_grid.elements_across;
    std::array<double, 2> cell{length / across, width / across};
    if (input_.contact_grid.cell_size) cell = *input_.contact_grid.cell_size;
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
            place.outward() * search_.profiles.rail.parameter_at(place.y_rail)};
  }

  std::vector<ModelResult> step(std::vector<Scene> contacts) {
    const std::size_t k = static_cast<std::size_t>(contacts.front().place->position) - 1;
    skip_to(k);
    const bool steady = contacts.front().problem_of(0) == Problem::steady;
    const bool rolls = contacts.front().problem == Problem::transient;
    const double length = rolls ? contacts.front().points.front().step_length : 0.0;
    if (!steady) way_ += length;
    if (first_.empty()) first_ = {origin_of(contacts.front())};
    for (Scene& scene : contacts) scene.contact_grid.cell_size = levels_.back().cell;
    std::vector<ModelResult> results = solve_contacts(contacts, k);
    hand_on(contacts, steady, steady ? next_length(k) : length);
    past_.steps = static_cast<int>(k) + 1;
    const contact::PointResult& point = results.front().points.front();
    past_.distance = point.distance;
    past_.shift = {point.longitudinal_shift, point.lateral_shift, point.spin_shift};
    return results;
  }

  /// Steps in which the wheel has not touched its rail leave nothing.
  void skip_to(std::size_t k) {
    for (std::size_t missed = static_cast<std::size_t>(past_.steps); missed < k; ++missed) {
      const double length = input_.history.at(missed).step_length;
      way_ += length;
      past_.distance += length;
      for (Level& level : levels_) level = {level.cell, {}, {}, {}};
    }
  }

  double next_length(std::size_t k) const {
    return k + 1 < input_.history.size() ? input_.history[k + 1].step_length : 0.0;
  }

  std::shared_ptr<const StepPast> past_of(const std::vector<Scene>& contacts,
                                          std::size_t own) const {
    std::vector<Interval> ranges;
    for (const Scene& scene : contacts) {
      const halfspace::PatchSearch search(scene, halfspace::SearchDetail::box);
      const double y = origin_of(scene).y;
      ranges.push_back({y + search.patch().y_lower, y + search.patch().y_upper});
    }
    const Origin origin = origin_of(contacts[own]);
    auto past = std::make_shared<StepPast>(past_);
    past->left = std::make_shared<PastPatches>();
    for (const Level& level : levels_) {
      PastLevel here;
      here.cell = level.cell;
      here.middle = {-std::remainder(origin.x - first_.front().x, level.cell[0]),
                     -std::remainder(origin.y - first_.front().y, level.cell[1])};
      here.lengths = level.lengths;
      here.last = inherited(level.last, ranges, own, origin);
      here.before_last = inherited(level.before_last, ranges, own, origin);
      past->levels.push_back(std::move(here));
    }
    return past;
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

  /// A level on which a contact had no solution has lost its past, for error bars alone.
  void drop_unsolved(const std::vector<Scene>& contacts) {
    std::size_t lost = 0;
    for (const Scene& scene : contacts)
      for (std::size_t n = 0; n + 1 < levels_.size(); ++n)
        if (scene.past->left->at(n).grid.size() == 0) lost = std::max(lost, n + 1);
    levels_.erase(levels_.begin(), levels_.begin() + static_cast<std::ptrdiff_t>(lost));
  }

  /// Steady rolling leaves what it would have left one step before too, if the lattice has that
  /// place.
  void hand_on(const std::vector<Scene>& contacts, bool steady, double length) {
    drop_unsolved(contacts);
    for (std::size_t n = 0; n < levels_.size(); ++n) {
      Level& level = levels_[n];
      level.before_last = std::move(level.last);
      level.last.clear();
      for (const Scene& scene : contacts) {
        const PastPatches& all = *scene.past->left;
        PastPatch left = all.at(all.size() - levels_.size() + n);
        const Origin origin = origin_of(scene);
        move(left.grid, origin.x, origin.y);
        level.last.push_back(std::move(left));
      }
      level.lengths = {length, level.lengths[0]};
      if (!steady) continue;
      const double elements = length / level.cell[0];
      const bool whole = std::abs(elements - std::round(elements)) < 1e-9 * elements;
      level.before_last = whole ? level.last : PastPatches();
      level.lengths[1] = whole ? length : 0.0;
      for (PastPatch& patch : level.before_last) move(patch.grid, -length, 0.0);
    }
  }

  std::vector<ModelResult> solve_contacts(std::vector<Scene>& contacts, std::size_t k) {
    const contact::HistoryStep& given = input_.history.at(k);
    const auto load = given.vertical_force ? given.vertical_force : input_.load.vertical_force;
    for (int turn = 0;; ++turn) {
      for (std::size_t c = 0; c < contacts.size(); ++c) contacts[c].past = past_of(contacts, c);
      contact::CheckpointPart kept(how_.checkpoint, turn > 0 ? fmt::format("turn{}-", turn) : "");
      Solving how = how_;
      if (how_.checkpoint != nullptr) how.checkpoint = &kept;
      std::vector<ModelResult> results;
      for (const Scene& scene : contacts)
        results.push_back(solve_scene(model_, scene, notes_, how));
      if (contacts.size() < 2 || !load || !share(*load, results, contacts)) return results;
      if (turn == most_turns)
        throw contact::SolveError(
            contacts.front().where(),
            "the shares of {} contacts in {:g} N do not settle with the friction of this step in "
            "{} turns",
            contacts.size(), *load, most_turns);
    }
  }

  /// Shares the load with the friction of the results; whether shares have changed.
  static bool share(double load, const std::vector<ModelResult>& results,
                    std::vector<Scene>& contacts) {
    std::vector<halfspace::ForceRatio> ratios;
    for (const ModelResult& result : results) {
      const contact::PointResult& point = result.points.front();
      ratios.push_back(std::array{point.longitudinal_force / point.normal_force,
                                  point.lateral_force / point.normal_force});
    }
    const halfspace::SharedLoad shared = halfspace::share_load(contacts, load, ratios);
    double change = 0.0, sum = 0.0;
    for (const halfspace::PatchLoad& one : shared.shares) sum += one.vertical_force;
    std::vector<Scene> loaded;
    for (std::size_t c = 0; c < contacts.size(); ++c) {
      const halfspace::PatchLoad& one = shared.shares[c];
      contact::NormalLoad& own = contacts[c].points.front().load;
      const double force = one.vertical_force * load / sum;
      change = std::max(change, std::abs(force - own.force.value_or(0.0)) / load);
      own.force = force;
      contacts[c].neighbour_loads = one.neighbour_loads;
      if (one.normal_force > shared_to * load) loaded.push_back(std::move(contacts[c]));
    }
    contacts = std::move(loaded);
    return change > shared_to;
  }

  const Case& input_;
  const track::SearchScene& search_;
  const std::string& model_;
  std::vector<contact::Note> notes_;
  const Solving& how_;
  std::vector<Scene> scenes_;
  std::vector<Level> levels_;  ///< the coarsest first
  std::vector<Origin> first_;  ///< a corner of the lattice, once a contact is known
  double way_ = 0.0;           ///< mm rolled
  StepPast past_;              ///< sums of the steps so far; without levels
};

}  // namespace

std::vector<ModelResult> solve_history(const Case& input, const track::SearchScene& search,
                                       const std::string& model, const Scenes& scenes,
                                       const Solving& how) {
  if (model != "halfspace")
    throw contact::InputError(
        {input.file},
        "model {}: the positions of this wheel are the steps of a history, in which the contact "
        "moves; allowed: halfspace; do: run with --model halfspace, or give one position",
        model);
  std::array<WheelHistory, 2> wheels{WheelHistory(input, search, model, scenes, how),
                                     WheelHistory(input, search, model, scenes, how)};
  for (const Scene& scene : scenes.list) wheels[scene.place->left ? 0 : 1].add(scene);
  std::array<std::vector<ModelResult>, 2> found;
  contact::for_each_index(wheels.size(), [&](std::size_t w) { found[w] = wheels[w].solve(); });
  std::vector<ModelResult> all = std::move(found[0]);
  std::move(found[1].begin(), found[1].end(), std::back_inserter(all));
  std::stable_sort(all.begin(), all.end(), [](const ModelResult& a, const ModelResult& b) {
    return a.place->position < b.place->position;
  });
  return all;
}

}  // namespace rollfem::modelling
