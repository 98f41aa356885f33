// SPDX-License-Identifier: LGPL-2.1-or-later
#include "theories/registry.hpp"

#include "halfspace/closed_forms/hertz.hpp"
#include "halfspace/curvature/curvature_error.hpp"
#include "halfspace/curvature/curved_compliance.hpp"
#include "halfspace/model/model.hpp"
#include "halfspace/model/refinements.hpp"
#include "halfspace/patch/patch_search.hpp"
#include "theories/carter.hpp"
#include "theories/closed_forms.hpp"
#include "theories/elliptic_patch.hpp"
#include "theories/equivalent_ellipse.hpp"
#include "theories/fastsim.hpp"
#include "theories/model_error.hpp"
#include "theories/strip.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <type_traits>
#include <utility>

namespace rollfem::theories {

using contact::Demand;
using contact::Demands;
using contact::ModelInfo;
using contact::ModelInput;
using contact::ModelResult;
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

ModelResult run_halfspace_with_model_error(const Scene& scene, const Progress& progress,
                                           contact::Checkpoint* checkpoint) {
  if (scene.options.halfspace.model_error) halfspace::check_bodies_known(scene);
  ModelResult result = halfspace::run_halfspace(scene, progress, checkpoint);
  if (scene.options.halfspace.model_error) halfspace::add_model_error(scene, progress, result);
  return result;
}

/// Effects that a theory neglects.
struct Leaves {
  bool spin = false;
  bool extra_slip = false;
};

/// A theory without extra rigid slip neglects the slip of the surface, with a note.
ModelResult run_without_extra_slip(const contact::Model& theory, const Scene& scene,
                                   const Progress& progress) {
  Scene flat = scene;
  flat.geometry.extra_slip = contact::ExtraSlip::none;
  ModelResult result = theory(flat, progress);
  const halfspace::ExpectedPatch patch = halfspace::PatchSearch(scene).patch();
  const double largest = contact::largest_extra_slip(scene.geometry, patch.y_lower, patch.y_upper);
  if (largest > smallest_slip_worth_a_note)
    result.notes.push_back(fmt::format(
        "the slip from the different rolling radii of the wheel's surface, up to "
        "{:.3g}, is neglected by this theory; fastsim, fastrip, strip and halfspace include it",
        largest));
  return result;
}

/// A theory of an elliptic patch, on the equivalent ellipse where the case has true profiles.
contact::Model elliptic(const contact::Model& theory, Leaves leaves = {}) {
  const contact::Model on_patch = [=](const Scene& c, const Progress& p) {
    return c.has_profiles() ? run_on_ellipse(theory, c, p, leaves.spin) : theory(c, p);
  };
  const contact::Model model = [=](const Scene& c, const Progress& p) {
    const bool neglects =
        leaves.extra_slip && c.geometry.extra_slip == contact::ExtraSlip::automatic;
    return neglects ? run_without_extra_slip(on_patch, c, p) : on_patch(c, p);
  };
  return [=](const Scene& c, const Progress& p) { return run_each_load(model, c, p); };
}

/// A theory on Hertz's ellipse: closed forms throughout, or strips with error estimates.
constexpr contact::BarRules closed_form{true, contact::no_bar::theory};
constexpr contact::BarRules strips_on_ellipse{true, contact::no_bar::not_estimated};

/// A theory of an elliptic patch: `more` than the keys that all of them support. No checkpoint, for
/// a theory takes no time; its model error (difference from the half-space) is added.
ModelInfo theory(const char* name, const char* label, const char* sentence, const Demands& more,
                 const contact::Model& model, TheoryKind kind = {}) {
  ModelInfo info{name, label, sentence};
  info.takes = {Demand::distance_quadratic, Demand::given_pressure, Demand::rigid_body,
                Demand::stress_in_rigid_body, Demand::beyond_half_space};
  info.takes.insert(info.takes.end(), more.begin(), more.end());
  info.run = [=](const Scene& c, const Progress& p, contact::Checkpoint*) {
    ModelResult result = model(c, p);
    estimate_model_error(c, kind, p, result);
    return result;
  };
  return info;
}

void add_closed_forms(contact::ModelRegistry& models) {
  // Frictionless: accepts any problem and gives only the patch.
  ModelInfo hertz = theory(
      "hertz", "Hertz", "elliptic patch and pressure in closed form, without friction",
      {Demand::line_contact, Demand::history, Demand::tangential_force, Demand::profiles,
       Demand::lateral_creepage, Demand::spin, Demand::extra_slip, Demand::extra_slip_on_profiles,
       Demand::falling_friction, Demand::varying_friction, Demand::layer, Demand::plastic_layer},
      [](const Scene& c, const Progress& p) {
        return c.has_profiles() ? run_hertz_of_patch(c, p) : run_hertz(c, p);
      },
      {false, true});
  hertz.in_compare = true;
  ModelInfo linear = theory("linear", "linear theory",
                            "Kalker's linear theory: creep forces without a friction bound",
                            {Demand::profiles, Demand::lateral_creepage, Demand::spin},
                            elliptic(run_linear, {false, true}));
  linear.bounded = false;
  ModelInfo vermeulen = theory("vermeulen-johnson", "Vermeulen-Johnson",
                               "Vermeulen and Johnson's creep forces on an ellipse, without spin",
                               {Demand::profiles, Demand::lateral_creepage},
                               elliptic(run_vermeulen_johnson, {true, true}));
  ModelInfo polach = theory("polach", "Polach",
                            "Polach's closed form of the creep force, without spin, for comparison",
                            {Demand::profiles, Demand::lateral_creepage, Demand::falling_friction},
                            elliptic(run_polach, {true, true}));
  for (ModelInfo* model : {&hertz, &linear, &vermeulen, &polach}) {
    model->bars = closed_form;
    models.add(*model);
  }
}

void add_theories_of_strips(contact::ModelRegistry& models) {
  using contact::ModelOptions;
  ModelInfo carter =
      theory("carter", "Carter", "strips of an ellipse along rolling, each a line contact",
             {Demand::line_contact, Demand::extra_slip}, run_carter);
  carter.refinements = {refined_strips<contact::CarterOptions, &ModelOptions::carter>()};
  ModelInfo fastsim = theory("fastsim", "FASTSIM", "Kalker's simplified theory on an ellipse",
                             {Demand::profiles, Demand::lateral_creepage, Demand::spin,
                              Demand::extra_slip, Demand::falling_friction, Demand::layer},
                             elliptic(run_fastsim));
  fastsim.refinements = {refined_strips<FastsimOptions, &ModelOptions::fastsim>()};
  fastsim.in_compare = true;
  ModelInfo fastrip = theory(
      "fastrip", "FaStrip", "FASTSIM's direction of slip with the adhesion area of strip theory",
      {Demand::profiles, Demand::lateral_creepage, Demand::spin, Demand::extra_slip},
      elliptic(run_fastrip));
  fastrip.refinements = fastsim.refinements;
  for (ModelInfo* model : {&carter, &fastsim, &fastrip}) {
    model->bars = strips_on_ellipse;
    models.add(*model);
  }
  ModelInfo strip =
      theory("strip", "strip", "strips along rolling, each with Hertzian pressure and brushes",
             {Demand::profiles, Demand::lateral_creepage, Demand::spin, Demand::extra_slip,
              Demand::extra_slip_on_profiles},
             [](const Scene& c, const Progress& p) { return run_each_load(run_strip, c, p); },
             {true, false});
  strip.refinements = {refined_strips<contact::StripOptions, &ModelOptions::strip>()};
  strip.in_compare = true;
  models.add(strip);
}

contact::ModelRegistry make_models() {
  contact::ModelRegistry models;
  add_closed_forms(models);
  add_theories_of_strips(models);
  ModelInfo halfspace{"halfspace", "half-space",
                      "Kalker's problem for elastic half-spaces, solved on a grid"};
  halfspace.takes = contact::all_demands_but(
      {Demand::inertia, Demand::beyond_half_space, Demand::stress_of_line});
  halfspace.run = run_halfspace_with_model_error;
  halfspace.refinements = {halfspace::contact_grid()};
  halfspace.no_model_error =
      "not requested: halfspace.model_error = true estimates the error of the half-space "
      "assumption";
  halfspace.choosable = contact::Choosable::half_spaces;
  halfspace.measures_others = halfspace.has_stress = halfspace.in_compare = halfspace.joins_planes =
      true;
  models.add(halfspace);
  return models;
}

}  // namespace

const contact::ModelRegistry& models() {
  static const contact::ModelRegistry all = make_models();
  return all;
}

}  // namespace rollfem::theories
