// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/halfspace_models.hpp"

#include "halfspace/curvature/curvature_error.hpp"
#include "halfspace/curvature/curved_compliance.hpp"
#include "halfspace/model/halfspace_model.hpp"

namespace rollfem::halfspace {

namespace {

contact::ModelResult run_with_model_error(const contact::Scene& scene,
                                          const contact::Progress& progress,
                                          contact::Checkpoint* checkpoint) {
  if (scene.options.halfspace.model_error) check_bodies_known(scene);
  contact::ModelResult result = run_halfspace(scene, progress, checkpoint);
  if (scene.options.halfspace.model_error) add_model_error(scene, progress, result);
  return result;
}

contact::ModelRegistry make_models() {
  using contact::Demand;
  contact::ModelInfo model{"halfspace", "half-space",
                           "Kalker's problem for elastic half-spaces, solved on a grid"};
  model.takes = contact::all_demands_but({Demand::inertia, Demand::beyond_half_space});
  model.run = run_with_model_error;
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
