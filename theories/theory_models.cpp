// SPDX-License-Identifier: LGPL-2.1-or-later
// The theories as models: names, capabilities, options, and the error of each against the
// half-space.
#include "theories/theory_models.hpp"

#include "halfspace/model/halfspace_model.hpp"
#include "halfspace/patch/patch_search.hpp"
#include "result/bars.hpp"
#include "result/derived.hpp"
#include "result/quantities.hpp"
#include "theories/carter.hpp"
#include "theories/closed_forms.hpp"
#include "theories/elliptic_patch.hpp"
#include "theories/equivalent_ellipse.hpp"
#include "theories/fastsim.hpp"
#include "theories/strip.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

namespace rollfem::theories {

using contact::Demand;
using contact::Demands;
using contact::ModelInfo;
using contact::ModelInput;
using contact::ModelResult;
using contact::PointResult;
using contact::Progress;
using contact::RefinedInput;
using contact::Refinement;
using contact::Scene;

namespace {

/// A count of the case at level k.
int scaled(int count, int k) {
  return std::max(1, count / 4) * (1 << k);
}

/// Refinement levels of a theory in a study: the case's strips and elements are the third of five
/// levels.
template <class Options, Options contact::ModelOptions::*options>
Refinement refined_strips() {
  const auto level = [](ModelInput input, int k, int /*n*/) -> RefinedInput {
    Options& of = input.options.*options;
    of.strips = scaled(of.strips, k);
    if constexpr (!std::is_same_v<Options, contact::CarterOptions>)
      of.strip_elements = scaled(of.strip_elements, k);
    const int strips = of.strips;
    return {fmt::format("{} strips", strips), static_cast<double>(strips), std::move(input)};
  };
  return {"grid", "", "strips", 2.0, 5, false, level};
}

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

/// A theory of an elliptic patch, on the equivalent ellipse where the case has true profiles.
contact::Model elliptic(const contact::Model& theory, bool leaves_extra_slip = false) {
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

/// Numbers from the fields on the contact grid, which no finer one confirms.
bool is_pass_work(const std::string& quantity) {
  for (const char* name : {"max_pass_work", "pass_work_y_wheel", "pass_work_y_rail"})
    if (quantity == name) return true;
  return false;
}

/// A theory that finds fields of traction and slip, and from them the work of friction and where it
/// is done.
contact::Model with_pass_work(const contact::Model& theory) {
  return [=](const Scene& scene, const Progress& progress) {
    ModelResult result = theory(scene, progress);
    contact::place_pass_work({scene.geometry, contact::Chart::plane}, scene.place, result);
    for (PointResult& point : result.points)
      for (const contact::Quantity& quantity : contact::quantities())
        if (is_pass_work(quantity.name) && quantity.value(point))
          point.no_bar.insert_or_assign(quantity.name, contact::NoBar::one_grid);
    return result;
  };
}

/// What a theory takes from closed forms, or leaves out.
struct TheoryKind {
  bool with_friction = true;  ///< it has forces, too
  bool hertzian = true;       ///< its patch and pressure without true profiles are Hertz's
};

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

/// A theory on Hertz's ellipse: closed forms throughout, or strips with error estimates.
constexpr contact::BarRules closed_form{true, contact::NoBar::theory};
constexpr contact::BarRules strips_on_ellipse{true, contact::NoBar::not_estimated};

/// A theory of an elliptic patch: `more` than the keys that all of them support. No checkpoint, for
/// a theory takes no time; its model error (difference from the half-space) is added.
ModelInfo theory(const char* name, const char* label, const char* sentence, const Demands& more,
                 const contact::Model& model, TheoryKind kind = {}) {
  ModelInfo info{name, label, sentence};
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

void add_closed_forms(contact::ModelRegistry& models) {
  // Frictionless: accepts any problem and gives only the patch.
  ModelInfo hertz =
      theory("hertz", "Hertz", "elliptic patch and pressure in closed form, without friction",
             {Demand::line_contact, Demand::history, Demand::tangential_force, Demand::profiles,
              Demand::sections, Demand::lateral_creepage, Demand::spin, Demand::extra_slip,
              Demand::extra_slip_on_profiles, Demand::falling_friction, Demand::varying_friction,
              Demand::layer, Demand::plastic_layer},
             [](const Scene& c, const Progress& p) {
               return c.has_profiles() ? run_hertz_of_patch(c, p) : run_hertz(c, p);
             },
             {false, true});
  hertz.frictionless = hertz.in_compare = true;
  ModelInfo linear = theory(
      "linear", "linear theory", "Kalker's linear theory: creep forces without a friction bound",
      {Demand::profiles, Demand::sections, Demand::lateral_creepage, Demand::spin},
      elliptic(run_linear, true));
  linear.bounded = false;
  ModelInfo vermeulen =
      theory("vermeulen-johnson", "Vermeulen-Johnson",
             "Vermeulen and Johnson's creep forces on an ellipse; spin by Shen, Hedrick "
             "and Elkins",
             {Demand::profiles, Demand::sections, Demand::lateral_creepage, Demand::spin},
             elliptic(run_vermeulen_johnson, true));
  ModelInfo polach = theory("polach", "Polach",
                            "Polach's closed form of the creep force with spin, for comparison",
                            {Demand::profiles, Demand::sections, Demand::lateral_creepage,
                             Demand::spin, Demand::falling_friction},
                            elliptic(run_polach, true));
  for (ModelInfo* model : {&hertz, &linear, &vermeulen, &polach}) {
    model->bars = closed_form;
    models.add(*model);
  }
}

void add_theories_of_strips(contact::ModelRegistry& models) {
  using contact::ModelOptions;
  ModelInfo carter =
      theory("carter", "Carter", "strips of an ellipse along rolling, each a line contact",
             {Demand::line_contact, Demand::extra_slip}, with_pass_work(run_carter));
  carter.refinements = {refined_strips<contact::CarterOptions, &ModelOptions::carter>()};
  ModelInfo fastsim = theory(
      "fastsim", "FASTSIM", "Kalker's simplified theory on an ellipse",
      {Demand::tangential_force, Demand::profiles, Demand::sections, Demand::lateral_creepage,
       Demand::spin, Demand::extra_slip, Demand::falling_friction, Demand::layer},
      with_pass_work(elliptic(run_fastsim)));
  fastsim.refinements = {refined_strips<FastsimOptions, &ModelOptions::fastsim>()};
  fastsim.own_bound = fastsim.in_compare = true;
  ModelInfo fastrip = theory("fastrip", "FaStrip",
                             "FASTSIM's direction of slip with the adhesion area of strip theory",
                             {Demand::tangential_force, Demand::profiles, Demand::sections,
                              Demand::lateral_creepage, Demand::spin, Demand::extra_slip},
                             with_pass_work(elliptic(run_fastrip)));
  fastrip.refinements = fastsim.refinements;
  for (ModelInfo* model : {&carter, &fastsim, &fastrip}) {
    model->bars = strips_on_ellipse;
    models.add(*model);
  }
  ModelInfo strip = theory(
      "strip", "strip", "strips along rolling, each with Hertzian pressure and brushes",
      {Demand::tangential_force, Demand::profiles, Demand::sections, Demand::lateral_creepage,
       Demand::spin, Demand::extra_slip, Demand::extra_slip_on_profiles},
      with_pass_work(
          [](const Scene& c, const Progress& p) { return run_each_load(run_strip, c, p); }),
      {true, false});
  strip.refinements = {refined_strips<contact::StripOptions, &ModelOptions::strip>()};
  strip.own_bound = strip.in_compare = true;
  models.add(strip);
}

contact::ModelRegistry make_models() {
  contact::ModelRegistry models;
  add_closed_forms(models);
  add_theories_of_strips(models);
  return models;
}

}  // namespace

const contact::ModelRegistry& models() {
  static const contact::ModelRegistry all = make_models();
  return all;
}

}  // namespace rollfem::theories
