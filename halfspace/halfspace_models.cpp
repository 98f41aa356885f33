// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/halfspace_models.hpp"

#include "case/checks/case_rules.hpp"
#include "case/keys/key_builder.hpp"
#include "halfspace/curvature/curvature_error.hpp"
#include "halfspace/curvature/curved_compliance.hpp"
#include "halfspace/model/halfspace_model.hpp"

namespace rollfem::halfspace {

namespace {

contact::ModelResult run_with_model_error(const contact::Scene& scene,
                                          const contact::Progress& progress,
                                          contact::Checkpoint* checkpoint) {
  if (scene.options.of<HalfspaceOptions>().model_error) check_bodies_known(scene);
  contact::ModelResult result = run_halfspace(scene, progress, checkpoint);
  if (scene.options.of<HalfspaceOptions>().model_error) add_model_error(scene, progress, result);
  return result;
}

void check_line(const contact::GivenCase& given, contact::Case&) {
  contact::check_exclusion(given,
                           {contact::when::line,
                            {"halfspace.*"},
                            "applies to contacts of finite width, but geometry.shape is line",
                            "line contact of rollers, rolling straight ahead",
                            "remove it, or geometry.shape"});
}

void add_halfspace_keys() {
  using contact::SurfaceForm;
  contact::Keys<HalfspaceOptions> keys("halfspace", "Model `halfspace`");
  keys.add("surface", &contact::Case::surface,
           {{"auto", SurfaceForm::automatic},
            {"planar", SurfaceForm::planar},
            {"curved", SurfaceForm::curved}},
           "`planar`: tangent plane; `curved`: common surface across rolling (steady or "
           "frictionless, like materials, no subsurface stress); `auto`: curved if the normals of "
           "true profiles spread by 0.03 to 0.06 rad or more (docs/track.md).");
  keys.add("model_error", &HalfspaceOptions::model_error,
           "Estimate the half-space's model error from the true curvature of wheel and rail (0.1 s "
           "per load point).");
  keys.section().position = 0;
  keys.section().complete = check_line;
  contact::add_section(keys);
}

contact::ModelRegistry make_models() {
  using contact::Demand;
  contact::ModelInfo model{"halfspace", "half-space",
                           "Kalker's problem for elastic half-spaces, solved on a grid"};
  model.takes = contact::all_demands_but({Demand::inertia, Demand::beyond_half_space});
  model.run = run_with_model_error;
  model.add_keys = add_halfspace_keys;
  model.refinements = {contact_grid()};
  model.no_model_error =
      "not requested: halfspace.model_error = true estimates the error of the half-space "
      "assumption";
  model.choosable = contact::Choosable::half_spaces;
  model.measures_others = model.has_stress = model.in_compare = model.joins_planes = true;
  return contact::ModelRegistry().add(model);
}

}  // namespace

const contact::ModelRegistry& models() {
  static const contact::ModelRegistry all = make_models();
  return all;
}

}  // namespace rollfem::halfspace
