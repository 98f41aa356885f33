// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/contact/solver.hpp"

#include "base/errors.hpp"
#include "case/keys/case_keys.hpp"
#include "halfspace/halfspace_models.hpp"
#include "halfspace/model/halfspace_model.hpp"
#include "halfspace/patch/patch_search.hpp"
#include "profiles/profiles.hpp"
#include "result/validity.hpp"
#include "scene/step_past.hpp"
#include "theories/theory_models.hpp"
#include "track/motion/placed_scenes.hpp"

#include <fmt/format.h>

#include "convert/equivalent_case.hpp"
#include "convert/steps.hpp"
#include <algorithm>
#include <cmath>
#include <utility>

namespace rollfem::addon {

using contact::ContactGrid;
using contact::Scene;
using convert::Equivalent;

namespace {

/// Settings of the given sections as text, to see whether they change.
std::string keys_of(const Equivalent& made, std::initializer_list<const char*> sections) {
  std::string keys;
  for (const char* section : sections)
    if (const auto found = made.fixed.find(section); found != made.fixed.end())
      for (const convert::Setting& setting : found->second)
        keys += fmt::format("{}.{}\n", section, setting.line());
  return keys;
}

/// Whether the values differ in nothing but numbers.
bool same_but_numbers(const contact::NamedValues& a, const contact::NamedValues& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
    const auto *list = std::get_if<std::vector<double>>(&x.second),
               *other = std::get_if<std::vector<double>>(&y.second);
    const bool number = std::holds_alternative<double>(x.second);
    return x.first == y.first && x.second.index() == y.second.index() &&
           (number || (list && list->size() == other->size()) || x.second == y.second);
  });
}

/// Sets numbers; their key checks them as in a case file.
void set_value(const std::string& path, contact::KeyValue value, contact::Case& input) {
  const contact::Key& key = *contact::find_key(path);
  if (const double* number = std::get_if<double>(&value);
      number != nullptr && key.kind == contact::KeyKind::numbers)
    value = std::vector<double>{*number};
  const auto check = [&](double number) {
    if (!key.bounds.contains(number))
      throw contact::InputError(fmt::format("{} = {:g} is out of bounds", path, number));
  };
  if (const auto* list = std::get_if<std::vector<double>>(&value))
    std::for_each(list->begin(), list->end(), check);
  else
    check(std::get<double>(value));
  key.set(input, value);
}

bool same_grid(const ContactGrid& a, const ContactGrid& b) {
  const double small = 1e-12 * (b.dx + b.dy);
  return a.nx == b.nx && a.ny == b.ny && std::abs(a.dx - b.dx) <= small &&
         std::abs(a.dy - b.dy) <= small && a.line_reference == b.line_reference;
}

bool feels_slip(const Scene& scene) {
  const contact::Friction law = scene.friction();
  return law && law->feels_slip();
}

/// The profiles of a case, of which those with a text are in no file.
track::ProfilePair profiles_of(contact::Case input, const ProfileTexts& texts) {
  contact::ProfileSource& rail = input.rail.profile;
  contact::ProfileSource& wheel = input.wheel.profile;
  const contact::ProfileSource rail_given = rail, wheel_given = wheel;
  if (!texts[0].empty()) rail = {};
  if (!texts[1].empty()) wheel = {};
  track::ProfilePair pair = track::profiles_of(input);
  if (!texts[0].empty()) pair.rail = profiles::profile_of_text(texts[0], rail_given, false);
  if (!texts[1].empty()) pair.wheel = profiles::profile_of_text(texts[1], wheel_given, true);
  return pair;
}

/// The profiles with the repairs that their points need, which CONTACT makes by itself.
track::ProfilePair repaired_profiles(contact::Case& input, const ProfileTexts& texts) {
  constexpr int most_repairs = 4;  // of both profiles
  for (int repairs = 0;; ++repairs) try {
      return profiles_of(input, texts);
    } catch (const profiles::RepairableProfile& fault) {
      if (repairs == most_repairs) throw;
      for (const std::string& line : fault.repairs) {
        const std::size_t equals = line.find(" = ");
        const std::string section = fault.of_wheel ? "wheel_profile" : "rail_profile";
        const std::string value = line.substr(equals + 3);
        contact::find_key(section, line.substr(0, equals))
            ->set(input,
                  value == "true" ? contact::KeyValue(true) : contact::KeyValue(std::stod(value)));
      }
    }
}

/// CONTACT's axes on the track point forward, to the right and down, its body 1 is the rail.
Patch on_rail(const ContactGrid& grid) {
  Patch patch;
  patch.grid = grid;
  patch.nx = grid.nx;
  patch.ny = grid.ny;
  patch.along = -1.0;
  patch.turns_rows = true;
  return patch;
}

void add_slip(const PatchSlips& slips, int number, const Patch& patch, Scene& scene) {
  const auto given = slips.find(number);
  if (given == slips.end() || given->second[0].empty()) return;
  const ElementSlip& extra = given->second;
  if (scene.place && scene.geometry.extra_slip != contact::ExtraSlip::none)
    throw Refusal(err_other, "extra rigid slip in module 1 but in steady rolling with D = 2");
  if (scene.problem != contact::Problem::steady && scene.problem != contact::Problem::transient)
    throw Refusal(err_other, "extra rigid slip of a contact that does not roll");
  if (extra[0].size() != static_cast<std::size_t>(patch.size()))
    throw Refusal(err_discr, fmt::format("extra rigid slip of {} elements, but there are {}",
                                         extra[0].size(), patch.size()));
  const ContactGrid& grid = patch.grid;
  contact::Lattice all{"",        grid.nx, grid.ny, grid.x(0),
                       grid.y(0), grid.dx, grid.dy, {extra[0], extra[1]}};
  for (std::size_t k = 0; k < 2; ++k)
    for (int j = 0; j < patch.ny; ++j)
      for (int i = 0; i < patch.nx; ++i)
        all.values[k][static_cast<std::size_t>(patch.index(i, j))] =
            (k == 0 ? patch.along : patch.across) *
            extra[k][static_cast<std::size_t>(j) * static_cast<std::size_t>(patch.nx) +
                     static_cast<std::size_t>(i)];
  scene.geometry.extra_slip = contact::ExtraSlip::file;
  scene.geometry.extra_slip_values = std::move(all);
}

/// One row of the case of a wheel's history as a case of one position.
contact::Case step_of(const contact::Case& rows, std::size_t k) {
  contact::Case here = track::case_at(rows, k);
  contact::Wheelset& wheelset = here.wheelset;
  for (auto* list : {&wheelset.lateral_shift, &wheelset.yaw, &wheelset.roll, &wheelset.height,
                     &wheelset.track_position, &wheelset.wheel_angle})
    if (list->size() > 1) *list = {list->at(k)};
  return here;
}

void refuse_impossible(const Equivalent& made) {
  if (!made.impossible.empty())
    throw Refusal(err_other, fmt::format("{}", fmt::join(made.impossible, "; ")));
}

}  // namespace

/// What a step continues, as the first step of its history if it is not a step itself; nothing for
/// a case that begins, as one without a case before it does. Load and motion, and in module 3 all
/// but the grid, may differ.
std::optional<Equivalent> Solver::start_of(const convert::ContactCase& given, Equivalent& made) {
  if (!made.continues || !before_) return {};
  if (given.module == 1 && given.digits.T == 1) convert::set_way(before_->place, made);
  refuse_impossible(made);
  std::optional<Equivalent> start =
      before_->history() ? before_ : convert::steady_start(*before_, made);
  if (start && (given.module == 3 || start->fixed == made.fixed)) return start;
  throw Refusal(err_other,
                "digit P = 0: the case continues another one but differs from it in more than "
                "load, creepages and forces");
}

std::vector<Patch> Solver::solve(const convert::ContactCase& given, const ProfileTexts& texts,
                                 const PatchSlips& extra) {
  Equivalent made = convert::equivalent_of(given, "");
  refuse_impossible(made);
  const std::optional<Equivalent> start = start_of(given, made);
  if (!start) {
    before_.reset();
    history_.reset();
    wheel_.reset();
  }
  std::vector<Patch> patches;
  if (given.module == 3) {
    set_case(made, texts, start && !history_ ? &*start : nullptr);
    patches = {solve_single(given, made, extra)};
  } else {
    if (start && !wheel_) {
      set_case(*start, texts);
      solve_pair({});
    }
    set_case(made, texts, start ? &*start : nullptr);
    patches = solve_pair(extra);
  }
  before_ = std::move(made);
  return patches;
}

void Solver::set_case(Equivalent made, const ProfileTexts& texts, const Equivalent* start) {
  theories::models();  // declare their keys
  halfspace::models();
  const bool pair = made.fixed.count("wheelset") > 0, history = made.history();
  const contact::NamedValues before = std::exchange(values_, {});  // none if one is refused
  contact::NamedValues values;
  if (history && (pair || start != nullptr)) {
    const Equivalent& first = pair ? made : *start;
    const contact::Case rows =
        convert::case_of(first, convert::values_of(first, {first.varied, made.varied}), "contact");
    input_ = pair ? step_of(rows, made.starts_steady ? 0 : 1) : rows;
  } else {
    values = convert::values_of(made);
    if (!history && !pair && !before.empty() && made_->distance == made.distance &&
        same_but_numbers(before, values)) {
      for (std::size_t k = 0; k < values.size(); ++k)
        if (values[k] != before[k]) set_value(values[k].first, values[k].second, input_);
    } else {
      input_ = convert::case_of(made, values, "contact");
    }
  }
  values_ = std::move(values);
  made_ = std::move(made);
  if (input_.has_profiles()) read_profiles(texts, start != nullptr);
}

/// `goes_on`: the case is a step of a history, for which the track stays as it was placed.
void Solver::read_profiles(const ProfileTexts& texts, bool goes_on) {
  const std::string profile_keys =
      keys_of(*made_, {"wheel", "rail", "wheel_profile", "rail_profile"}) + texts[0] + texts[1];
  std::string search_keys = keys_of(*made_, {"track", "rail_displacement"});
  for (const convert::Setting& setting : made_->fixed.at("wheelset"))
    if (setting.key == "side" || setting.key.rfind("flange", 0) == 0) search_keys += setting.line();
  const bool varies = !goes_on && (profiles_.wheel_sections || profiles_.rail_sections);
  if (!varies && profile_keys == profile_keys_ && search_keys == search_keys_) return;
  if (goes_on) throw Refusal(err_profil, "digit P = 0: the profiles have changed");
  try {
    if (profile_keys != profile_keys_) profiles_ = repaired_profiles(input_, texts);
    profile_keys_ = search_keys_ = "";
    track::take_first_sections(input_, profiles_);
    placed_.search = track::make_search_scene(input_, profiles_);
  } catch (const contact::InputError& error) {
    throw Refusal(err_profil, error.what());
  }
  profile_keys_ = profile_keys;
  search_keys_ = search_keys;
}

const track::ProfilePair& Solver::profiles(const convert::ContactCase& given,
                                           const ProfileTexts& texts) {
  Equivalent made = convert::equivalent_of(given, "");
  refuse_impossible(made);
  set_case(std::move(made), texts);
  return profiles_;
}

std::unique_ptr<contact::Elasticity> Solver::elasticity(const Scene& scene,
                                                        const contact::ChartedGeometry& geometry,
                                                        const ContactGrid& grid) {
  if (!halfspaces_ || !halfspaces_->fit(scene.material, grid))
    halfspaces_.emplace(scene.material, grid);
  return halfspace::halfspace_elasticity_of(scene, geometry, *halfspaces_);
}

/// On the grid, or on a larger one where the patch reaches its border.
contact::LevelResult Solver::solve_on(const Scene& scene, ContactGrid& grid) {
  static const contact::Progress untold;
  const contact::ChartedGeometry geometry = halfspace::halfspace_geometry(scene);
  contact::RunOptions options;
  options.model = "halfspace";
  options.force_accuracy = halfspace::accuracy_of_force_search;
  options.independent = true;
  options.inherited = history_;
  if (last_ && !scene.place && !scene.is_history() && !feels_slip(scene) &&
      same_grid(last_->grid, grid) && !last_->points.empty())
    options.coarser = &*last_;
  constexpr int most_enlargements = 4;
  for (int attempt = 0; attempt <= most_enlargements; ++attempt) {
    contact::ContactRun run(scene, geometry, options, untold, nullptr);
    if (run.solve(grid, [&] { return elasticity(scene, geometry, grid); }))
      return run.take_result();
    options.coarser = nullptr;
    grid = grid.widened(grid.nx / 4 + 3, grid.ny / 4 + 3);
  }
  throw Refusal(err_discr, "the contact reaches far beyond the potential contact area");
}

/// What the next call starts from.
void Solver::remember(const Scene& scene, const contact::LevelResult& level) {
  const contact::PointResult& point = level.points.back();
  last_.emplace();
  last_->grid = level.grid;
  last_->pressure = level.pressure;
  last_->relative_traction = level.relative_traction;
  last_->points.resize(1);
  last_->points.front().creepage = point.creepage;
  if (!scene.is_history()) return;
  if (!history_) history_.emplace(level.grid, scene.upwind_order);
  const double length =
      scene.problem == contact::Problem::transient ? scene.points.back().step_length : 0.0;
  for (const contact::PointResult& step : level.points) {
    const auto& u = step.fields.displacement;
    history_->advance({u.x, u.y}, length, level.after);
    // Steady rolling is as if the next step had been made before, too.
    if (scene.starts_steady && &step == &level.points.front())
      history_->advance({u.x, u.y}, length, level.after);
  }
}

Patch Solver::solve_single(const convert::ContactCase& given, const Equivalent& made,
                           const PatchSlips& extra) {
  const auto scene = std::make_shared<Scene>(input_);
  Patch patch;
  patch.scene = scene;
  if (convert::rolls_backwards(given)) patch.along = patch.across = -1.0;
  patch.turns_columns = patch.turns_rows = patch.along < 0.0;
  const auto& [dx, dy] = *scene->contact_grid.cell_size;
  patch.grid = halfspace::PatchSearch(*scene, halfspace::SearchDetail::box).grid(dx, dy, 3);
  patch.nx = patch.grid.nx;
  patch.ny = patch.grid.ny;
  add_slip(extra, 1, patch, *scene);
  contact::ModelResult result;
  if (convert::is_simplified(given.digits)) {
    result = theories::models().at(made.model).run(*scene, {}, nullptr);
    patch.grid = result.grid;
    patch.nx = patch.grid.nx;
    patch.ny = patch.grid.ny;
  } else {
    if (scene->is_history()) scene->past = std::make_shared<contact::StepPast>();
    if (!few_) few_ = std::make_shared<halfspace::FewContact>();
    if (auto point = few_->solve(*scene, patch.grid)) {
      patch.point = std::move(*point);
      return patch;
    }
    if (history_ && !same_grid(last_->grid, patch.grid))
      throw Refusal(err_discr, "digit P = 0: the grid differs from that of the step before");
    contact::LevelResult level = solve_on(*scene, patch.grid);
    remember(*scene, level);
    patch.first_column = (patch.grid.nx - patch.nx) / 2;
    patch.first_row = (patch.grid.ny - patch.ny) / 2;
    result.points = std::move(level.points);
    result.grid = patch.grid;
    result.name = "halfspace";
  }
  contact::check_validity(*scene, result);
  patch.point = std::move(result.points.back());
  return patch;
}

Patch Solver::placed_patch(const Scene& scene, contact::PointResult point, const ContactGrid& grid,
                           const std::vector<track::PlacedScene>& placed,
                           const track::RailVector& rail_moved) const {
  Patch patch = on_rail(grid);
  patch.scene = std::make_shared<const Scene>(scene);
  patch.point = std::move(point);
  const track::WheelRailContact& contact = track::contact_of(scene, placed);
  patch.placed = {
      contact,
      (patch.point.approach + contact.place.separation) / std::cos(contact.place.contact_angle),
      (1.0 + rotation_) * contact.place.rolling_radius / input_.wheel.rolling_radius, rail_moved};
  return patch;
}

std::vector<Patch> Solver::solve_pair(const PatchSlips& extra) {
  const std::vector<double>& turning = input_.wheelset.rotation_change;
  if (!wheel_ || !turning.empty()) rotation_ = turning.empty() ? 0.0 : turning.front();
  track::SearchOptions options;
  options.with_reserve = input_.load.vertical_force.has_value();
  placed_.scenes.clear();
  if (!input_.track.rail_stiffness)
    placed_.scenes = track::make_scenes(input_, placed_.search, options);
  const track::BalancedCase balanced = track::balance(input_, placed_);
  if (!input_.history.empty()) return take_step(balanced.scenes, extra);
  std::vector<Patch> patches;
  for (Scene scene : balanced.scenes) {
    const auto& [dx, dy] = *scene.contact_grid.cell_size;
    ContactGrid grid = halfspace::PatchSearch(scene, halfspace::SearchDetail::box).grid(dx, dy, 3);
    add_slip(extra, static_cast<int>(patches.size()) + 1, on_rail(grid), scene);
    contact::LevelResult level = solve_on(scene, grid);
    patches.push_back(placed_patch(scene, std::move(level.points.front()), grid, balanced.placed,
                                   balanced.rail_moved));
  }
  return patches;
}

/// A step that fails leaves those before it as they were.
std::vector<Patch> Solver::take_step(std::vector<Scene> contacts, const PatchSlips& extra) {
  if (std::any_of(extra.begin(), extra.end(),
                  [](const auto& one) { return !one.second[0].empty(); }))
    throw Refusal(err_other, "extra rigid slip of wheels in time");
  const auto solve = [](const Scene& scene, const auto&, contact::Checkpoint*) {
    return halfspace::models().at("halfspace").run(scene, {}, nullptr);
  };
  auto wheel =
      wheel_ ? std::make_shared<track::WheelHistory>(*wheel_)
             : std::make_shared<track::WheelHistory>(std::vector{*input_.contact_grid.cell_size},
                                                     std::vector<contact::Note>(), solve);
  std::vector<Patch> patches;
  if (contacts.empty()) {
    wheel->miss(input_.history.front().step_length);
  } else {
    wheel->begin(input_, std::move(contacts), placed_);
    if (input_.wheelset.free_rolling != contact::FreeRolling::none)
      rotation_ = track::find_rotation({wheel.get()}, rotation_);
    if (input_.track.rail_stiffness) wheel->settle();
    std::vector<contact::ModelResult> results = wheel->solve();
    wheel->end(results);
    for (std::size_t c = 0; c < results.size(); ++c)
      patches.push_back(placed_patch(wheel->contacts()[c], std::move(results[c].points.front()),
                                     results[c].grid, wheel->placed(), wheel->rail_moved()));
  }
  wheel_ = std::move(wheel);
  return patches;
}

}  // namespace rollfem::addon
