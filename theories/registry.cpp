// SPDX-License-Identifier: LGPL-2.1-or-later
#include "theories/registry.hpp"

#include "halfspace/closed_forms/hertz.hpp"
#include "halfspace/curvature/curvature_error.hpp"
#include "halfspace/curvature/curved_compliance.hpp"
#include "halfspace/model/model.hpp"
#include "halfspace/patch/patch_search.hpp"
#include "theories/carter.hpp"
#include "theories/elliptic_patch.hpp"
#include "theories/equivalent_ellipse.hpp"
#include "theories/fastsim.hpp"
#include "theories/model_error.hpp"
#include "theories/polach.hpp"
#include "theories/strip.hpp"
#include "theories/vermeulen_johnson.hpp"

#include <fmt/format.h>

#include <algorithm>
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

RefinedInput strips_level(int strips, ModelInput input) {
  return {fmt::format("{} strips", strips), static_cast<double>(strips), std::move(input)};
}

RefinedInput carter_level(ModelInput input, int k, int /*n*/) {
  input.options.carter.strips = scaled(input.options.carter.strips, k);
  return strips_level(input.options.carter.strips, std::move(input));
}

RefinedInput fastsim_level(ModelInput input, int k, int /*n*/) {
  input.options.fastsim.strips = scaled(input.options.fastsim.strips, k);
  input.options.fastsim.strip_elements = scaled(input.options.fastsim.strip_elements, k);
  return strips_level(input.options.fastsim.strips, std::move(input));
}

RefinedInput strip_level(ModelInput input, int k, int /*n*/) {
  input.options.strip.strips = scaled(input.options.strip.strips, k);
  input.options.strip.strip_elements = scaled(input.options.strip.strip_elements, k);
  return strips_level(input.options.strip.strips, std::move(input));
}

/// Refinement levels of a theory in a study: the case's strips and elements are the third of five
/// levels.
Refinement strips_of(RefinedInput (*level)(ModelInput, int, int)) {
  return {"grid", "", "strips", 2.0, 5, false, level};
}

/// Slip below this value changes no force of a theory.
constexpr double smallest_slip_worth_a_note = 1e-7;

ModelResult run_fastsim_of_case(const Scene& scene, const Progress& progress) {
  return run_fastsim(scene, progress, scene.options.fastsim);
}

ModelResult run_fastrip_of_case(const Scene& scene, const Progress& progress) {
  return run_fastrip(scene, progress, scene.options.fastsim);
}

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
contact::Model elliptic(contact::Model theory, Leaves leaves = {}) {
  const contact::Model model = [theory = std::move(theory), leaves](const Scene& c,
                                                                    const Progress& p) {
    return c.has_profiles() ? run_on_ellipse(theory, c, p, leaves.spin) : theory(c, p);
  };
  return [model, leaves](const Scene& c, const Progress& p) {
    if (!leaves.extra_slip || c.geometry.extra_slip != contact::ExtraSlip::automatic)
      return run_each_load(model, c, p);
    const contact::Model without = [model](const Scene& s, const Progress& q) {
      return run_without_extra_slip(model, s, q);
    };
    return run_each_load(without, c, p);
  };
}

ModelResult run_strip_of_case(const Scene& scene, const Progress& progress) {
  return run_strip(scene, progress,
                   {scene.options.strip.strips, scene.options.strip.strip_elements,
                    scene.options.strip.virtual_penetration});
}

/// No checkpoint: a theory takes no time. Its model error (difference from the half-space) is
/// added.
contact::ModelRun theory(contact::Model model, TheoryKind kind = {}) {
  return [model = std::move(model), kind](const Scene& c, const Progress& p, contact::Checkpoint*) {
    ModelResult result = model(c, p);
    estimate_model_error(c, kind, p, result);
    return result;
  };
}

/// A theory on Hertz's ellipse: closed forms throughout, or strips with error estimates.
constexpr contact::BarRules closed_form{true, contact::no_bar::theory};
constexpr contact::BarRules strips_on_ellipse{true, contact::no_bar::not_estimated};

/// Keys that every theory of an elliptic patch supports, and `more`.
Demands of_ellipse(const Demands& more) {
  Demands all{Demand::distance_quadratic, Demand::given_pressure, Demand::rigid_body,
              Demand::stress_in_rigid_body, Demand::beyond_half_space};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

void add_theories(contact::ModelRegistry& models) {
  ModelInfo hertz{"hertz", "Hertz", "elliptic patch and pressure in closed form, without friction"};
  // Frictionless: accepts any problem and gives only the patch.
  hertz.takes = of_ellipse(
      {Demand::line_contact, Demand::history, Demand::tangential_force, Demand::profiles,
       Demand::lateral_creepage, Demand::spin, Demand::extra_slip, Demand::extra_slip_on_profiles,
       Demand::falling_friction, Demand::varying_friction, Demand::layer, Demand::plastic_layer});
  hertz.run = theory(
      [](const Scene& c, const Progress& p) {
        return c.has_profiles() ? run_hertz_of_patch(c, p) : run_hertz(c, p);
      },
      {false, true});
  hertz.bars = closed_form;
  hertz.in_compare = true;
  models.add(hertz);

  ModelInfo linear{"linear", "linear theory",
                   "Kalker's linear theory: creep forces without a friction bound"};
  linear.takes = of_ellipse({Demand::profiles, Demand::lateral_creepage, Demand::spin});
  linear.bounded = false;
  linear.run = theory(elliptic(run_linear, {false, true}));
  linear.bars = closed_form;
  models.add(linear);

  ModelInfo vermeulen{"vermeulen-johnson", "Vermeulen-Johnson",
                      "Vermeulen and Johnson's creep forces on an ellipse, without spin"};
  vermeulen.takes = of_ellipse({Demand::profiles, Demand::lateral_creepage});
  vermeulen.run = theory(elliptic(run_vermeulen_johnson, {true, true}));
  vermeulen.bars = closed_form;
  models.add(vermeulen);

  ModelInfo polach{"polach", "Polach",
                   "Polach's closed form of the creep force, without spin, for comparison"};
  polach.takes = of_ellipse({Demand::profiles, Demand::lateral_creepage, Demand::falling_friction});
  polach.run = theory(elliptic(run_polach, {true, true}));
  polach.bars = closed_form;
  models.add(polach);
}

void add_theories_of_strips(contact::ModelRegistry& models) {
  ModelInfo carter{"carter", "Carter", "strips of an ellipse along rolling, each a line contact"};
  carter.takes = of_ellipse({Demand::line_contact, Demand::extra_slip});
  carter.run = theory(
      [](const Scene& c, const Progress& p) { return run_carter(c, p, c.options.carter.strips); });
  carter.bars = strips_on_ellipse;
  carter.refinements = {strips_of(carter_level)};
  models.add(carter);

  ModelInfo fastsim{"fastsim", "FASTSIM", "Kalker's simplified theory on an ellipse"};
  fastsim.takes = of_ellipse({Demand::profiles, Demand::lateral_creepage, Demand::spin,
                              Demand::extra_slip, Demand::falling_friction, Demand::layer});
  fastsim.run = theory(elliptic(run_fastsim_of_case));
  fastsim.bars = strips_on_ellipse;
  fastsim.refinements = {strips_of(fastsim_level)};
  fastsim.in_compare = true;
  models.add(fastsim);

  ModelInfo fastrip{"fastrip", "FaStrip",
                    "FASTSIM's direction of slip with the adhesion area of strip theory"};
  fastrip.takes =
      of_ellipse({Demand::profiles, Demand::lateral_creepage, Demand::spin, Demand::extra_slip});
  fastrip.run = theory(elliptic(run_fastrip_of_case));
  fastrip.bars = strips_on_ellipse;
  fastrip.refinements = {strips_of(fastsim_level)};
  models.add(fastrip);

  ModelInfo strip{"strip", "strip",
                  "strips along rolling, each with Hertzian pressure and brushes"};
  strip.takes = of_ellipse({Demand::profiles, Demand::lateral_creepage, Demand::spin,
                            Demand::extra_slip, Demand::extra_slip_on_profiles});
  strip.run = theory(
      [](const Scene& c, const Progress& p) { return run_each_load(run_strip_of_case, c, p); },
      {true, false});
  strip.refinements = {strips_of(strip_level)};
  strip.in_compare = true;
  models.add(strip);
}

contact::ModelRegistry make_models() {
  contact::ModelRegistry models;
  add_theories(models);
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
