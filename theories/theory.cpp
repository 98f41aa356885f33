// SPDX-License-Identifier: LGPL-2.1-or-later
#include "theories/theory.hpp"

#include "halfspace/model/halfspace_model.hpp"
#include "halfspace/patch/patch_search.hpp"
#include "result/bars.hpp"
#include "result/derived.hpp"
#include "result/heat/temperature.hpp"
#include "result/quantities.hpp"
#include "theories/equivalent_ellipse.hpp"

#include <cmath>
#include <string>

namespace rollfem::theories {

using contact::Demand;
using contact::Demands;
using contact::ModelInfo;
using contact::ModelResult;
using contact::PointResult;
using contact::Progress;
using contact::Scene;

namespace {

/// Slip below this value changes no force of a theory.
constexpr double smallest_slip_worth_a_note = 1e-7;

/// A theory without extra rigid slip neglects the slip of the surface, with a note.
ModelResult run_without_extra_slip(const contact::Model& theory, const Scene& scene,
                                   const Progress& progress) {
  Scene flat = scene;
  flat.geometry.extra_slip = contact::ExtraSlip::none;
  ModelResult result = theory(flat, progress);
  const halfspace::ExpectedPatch patch = halfspace::PatchSearch(scene).patch();
  const double largest = contact::largest_extra_slip(scene.geometry, patch.y_lower, patch.y_upper);
  if (largest > smallest_slip_worth_a_note)
    contact::add_note(result.notes, "extra_slip",
                      "the slip from the different rolling radii of the wheel's surface, up to "
                      "{:.3g}, is neglected by this theory; fastsim, fastrip, strip and halfspace "
                      "include it",
                      largest);
  return result;
}

/// Numbers from the fields on the contact grid, which no finer one confirms.
bool is_pass_work(const std::string& quantity) {
  for (const char* name : {"max_pass_work", "pass_work_y_wheel", "pass_work_y_rail",
                           "max_temperature", "heat_wheel", "heat_rail"})
    if (quantity == name) return true;
  return false;
}

/// Some ten milliseconds a load point. With 20, the discretisation error is often larger than the
/// error of a theory.
constexpr int elements_of_theories = 32;

/// The load point of a model that uses one solution for all load points.
Scene at_largest_load(const Scene& scene) {
  const contact::NormalLoad largest = contact::largest_load(scene);
  for (std::size_t k = 0; k < scene.points.size(); ++k)
    if (scene.points[k].load.force == largest.force &&
        scene.points[k].load.approach == largest.approach)
      return contact::at_point(scene, k);
  return contact::at_point(scene, 0);
}

/// Friction changes the pressure of unlike materials, and on a tilted plane it carries a part of
/// the load.
bool friction_moves_pressure(const Scene& scene) {
  return scene.material.couples() || scene.shares_load();
}

Scene rough_scene(const Scene& scene, bool with_friction, std::size_t points) {
  Scene rough = points == scene.points.size() ? scene : at_largest_load(scene);
  if (!with_friction && !friction_moves_pressure(scene)) {
    rough.problem = contact::Problem::frictionless;
    for (contact::LoadPoint& point : rough.points) point.force = {};
  }
  return halfspace::on_few_elements(std::move(rough), elements_of_theories);
}

bool has_error_estimate(const contact::Quantity& quantity, bool with_friction) {
  if (quantity.of_friction() || std::string(quantity.name) == "adhesion_area") return with_friction;
  return quantity.scale == contact::ErrorScale::value;
}

/// Which values of a theory are those of half-spaces.
struct Exact {
  bool patch = false;   ///< and pressure and approach: Hertz's solution of this problem
  bool forces = false;  ///< Carter's of a line contact

  Exact(const Scene& scene, const TheoryKind& kind)
      : patch(kind.hertzian && !scene.has_profiles() && !scene.geometry.distance_values &&
              scene.follows_surface == 0.0 && !friction_moves_pressure(scene)),
        forces(patch && scene.geometry.line.has_value()) {}
  bool all(const TheoryKind& kind) const { return patch && (forces || !kind.with_friction); }
  bool has(const contact::Quantity& quantity) const {
    return forces || (patch && !quantity.of_friction() && !quantity.member.may_be_absent &&
                      quantity.name != std::string("adhesion_area"));
  }
};

void add_errors(const PointResult& half, const Exact& exact, bool with_friction,
                PointResult& theory) {
  for (const contact::Quantity& quantity : contact::quantities()) {
    const auto value = quantity.value(theory);
    const auto other = quantity.value(half);
    const auto bar = half.error_estimate.find(quantity.name);
    const auto word = half.no_bar.find(quantity.name);
    const bool given = word != half.no_bar.end() && word->second == contact::NoBar::given;
    if (!value || !other || given || !has_error_estimate(quantity, with_friction)) continue;
    if (exact.has(quantity)) {
      theory.model_error[quantity.name] = 0.0;
      continue;
    }
    // Without its error bar a half-space solution on so few elements is no reference.
    if (bar == half.error_estimate.end()) continue;
    // An error bar holds nearly always, half of it usually (docs/accuracy.md).
    theory.model_error[quantity.name] = std::abs(*value - *other) + 0.5 * bar->second;
  }
}

/// Sets PointResult::model_error of a theory's values: 0 where it is exact for half-spaces,
/// otherwise from a half-space solution of the same scene with 32 elements across, the difference
/// and half of that solution's own bar. Where the half-space has no result, a warning
/// states the reason.
void estimate_model_error(const Scene& scene, const TheoryKind& kind,
                          const contact::Progress& progress, ModelResult& theory) {
  const contact::Stopwatch watch;
  const contact::Progress told = [&](contact::ProgressEvent event) {
    event.stage = "model error: " + event.stage;
    contact::report(progress, event);
  };
  const Exact exact(scene, kind);
  try {
    const Scene rough = rough_scene(scene, kind.with_friction, theory.points.size());
    ModelResult half = exact.all(kind) ? theory : halfspace::run_halfspace(rough, told, nullptr);
    contact::explain_bars(rough, {}, half);
    for (std::size_t k = 0; k < theory.points.size() && k < half.points.size(); ++k)
      add_errors(half.points[k], exact, kind.with_friction, theory.points[k]);
    theory.notes.push_back(
        {contact::about_model_error,
         exact.all(kind)
             ? std::string("none: exact for half-spaces")
             : fmt::format(
                   "difference from the half-space with {} elements across, plus half its error "
                   "bar{}",
                   elements_of_theories, exact.patch ? "; patch and pressure are exact" : "")});
  } catch (const contact::Failure& error) {
    contact::add_warning(theory.notes, contact::about_model_error,
                         "not estimated: no result of the half-space with {} elements across ({})",
                         elements_of_theories, error.what());
  }
  // Not part of the total, which is the cost of the theory.
  theory.seconds["model error"] = watch.seconds();
}

}  // namespace

contact::Model elliptic(const contact::Model& theory, bool leaves_extra_slip) {
  const contact::Model on_patch = [=](const Scene& c, const Progress& p) {
    return c.has_profiles() ? run_on_ellipse(theory, c, p) : theory(c, p);
  };
  const contact::Model model = [=](const Scene& c, const Progress& p) {
    const bool neglects =
        leaves_extra_slip && c.geometry.extra_slip == contact::ExtraSlip::automatic;
    return neglects ? run_without_extra_slip(on_patch, c, p) : on_patch(c, p);
  };
  return [=](const Scene& c, const Progress& p) { return run_each_load(model, c, p); };
}

contact::Model with_pass_work(const contact::Model& theory) {
  return [=](const Scene& scene, const Progress& progress) {
    ModelResult result = theory(scene, progress);
    contact::place_pass_work({scene.geometry, contact::Chart::plane}, scene.place, result);
    for (PointResult& point : result.points)
      if (scene.heat) contact::set_temperatures(result.grid, *scene.heat, point);
    contact::tell_of_heat(scene, result);
    for (PointResult& point : result.points)
      for (const contact::Quantity& quantity : contact::quantities())
        if (is_pass_work(quantity.name) && quantity.value(point))
          point.no_bar.insert_or_assign(quantity.name, contact::NoBar::one_grid);
    return result;
  };
}

ModelInfo theory(const char* name, const char* label, const char* sentence, const Demands& more,
                 const contact::Model& model, TheoryKind kind) {
  ModelInfo info{name, label, sentence};
  info.bars = kind.bars;
  info.takes = {Demand::distance_quadratic, Demand::given_pressure, Demand::rigid_body,
                Demand::stress_in_rigid_body, Demand::beyond_half_space};
  info.takes.insert(info.takes.end(), more.begin(), more.end());
  info.run = [=](const Scene& c, const Progress& p, contact::Checkpoint*) {
    Scene active = c;
    active.friction_law = c.friction();
    ModelResult result = model(active, p);
    estimate_model_error(c, kind, p, result);
    return result;
  };
  return info;
}

}  // namespace rollfem::theories
