// SPDX-License-Identifier: LGPL-2.1-or-later
#include "models/fem/fem_model.hpp"

#include "contact/base/errors.hpp"
#include "halfspace/patch/patch_search.hpp"
#include "models/fem/fem_library.hpp"

#include <fmt/format.h>

#include <cmath>

namespace rollfem::modelling {

using contact::Demand;
using contact::ModelInput;
using contact::RefinedInput;

namespace {

/// The expected patch, from which the model derives values missing from the case.
halfspace::PatchBox box_for(const ModelInput& input, const char* key) {
  try {
    return halfspace::PatchSearch(input).box();
  } catch (const contact::InputError& error) {
    throw contact::InputError(
        fmt::format("{}: study: the study starts from fem.{}, which this case does not give and "
                    "which cannot be derived from a patch ({}); do: give fem.{}",
                    input.file, key, error.what(), key));
  }
}

/// The case's own cell is the last level.
RefinedInput cell_level(ModelInput input, int k, int n) {
  if (!input.options.fem.cell_size)
    input.options.fem.cell_size = box_for(input, "cell_size").smaller() / 8.0;
  const double size = *input.options.fem.cell_size * std::exp2(n - 1 - k);
  input.options.fem.cell_size = size;
  return {fmt::format("{:.4g} mm", size), size, std::move(input)};
}

RefinedInput degree_level(ModelInput input, int k, int /*n*/) {
  input.options.fem.degree = k + 1;
  return {fmt::format("degree {}", k + 1), k + 1.0, std::move(input)};
}

/// The case's own domain is the last but one.
RefinedInput domain_level(ModelInput input, int k, int n) {
  if (!input.options.fem.extent) input.options.fem.extent = 8.0 * box_for(input, "extent").larger();
  const double factor = std::exp2(k - (n - 2));
  for (auto* length : {&input.options.fem.extent, &input.options.fem.width,
                       &input.options.fem.depth, &input.options.fem.length})
    if (*length) **length *= factor;
  const double size = *input.options.fem.extent;
  return {fmt::format("extent {:.4g} mm", size), size, std::move(input)};
}

}  // namespace

contact::ModelInfo fem_model() {
  contact::ModelInfo fem{"fem", "FEM", "3D finite elements of both bodies"};
  fem.takes = contact::all_demands_but(
      {Demand::line_contact, Demand::stress_of_line, Demand::stress_in_rigid_body});
  fem.run = [](const ModelInput& input, const contact::Progress& progress,
               contact::Checkpoint* checkpoint) {
    return open_fem_library("model fem").run(input, progress, checkpoint);
  };
  // In a study of finite elements the contact element is the cell.
  fem.refinements = {{"cell", "grid", "FE cell", 2.0, 3, false, cell_level},
                     {"degree", "", "degree", 0.0, 2, true, degree_level},
                     {"domain", "", "extent", 2.0, 3, false, domain_level}};
  fem.half_spaces = false;
  fem.choosable = contact::Choosable::finite_bodies;
  fem.measures_others = fem.has_stress = fem.keeps_bodies = fem.parallel = fem.in_compare = true;
  fem.built = ROLLFEM_WITH_FEM;
  fem.no_model_error = "none known: linear elasticity of the bodies as given in the case";
  return fem;
}

}  // namespace rollfem::modelling
