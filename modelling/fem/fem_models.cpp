// SPDX-License-Identifier: LGPL-2.1-or-later
#include "modelling/fem/fem_models.hpp"

#include "base/errors.hpp"
#include "base/progress.hpp"
#include "halfspace/model/halfspace_model.hpp"
#include "halfspace/patch/patch_search.hpp"
#include "hybrid/correction_scene.hpp"
#include "modelling/caches/correction_cache.hpp"
#include "modelling/fem/fem_library.hpp"
#include "modelling/program/provenance.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace rollfem::modelling {

using contact::Demand;
using contact::ModelInput;
using contact::RefinedInput;

namespace {

using hybrid::SmoothParts;

/// Takes the correction from the cache, otherwise computes it by finite elements and stores it
/// there.
SmoothParts found_here(const contact::Scene& scene, const contact::Progress& progress) {
  const contact::Scene correction = hybrid::correction_scene(scene);
  const CorrectionCache cache;
  const auto stored = cache.find(correction, scene.asks_for_stress());
  if (stored.parts) return *stored.parts;
  const FemLock alone = lock_fem();
  const fem::Entry& library = parallel_session("model hybrid");
  const contact::Stopwatch watch;
  SmoothParts parts = library.find_smooth_parts(scene, progress);
  const std::string why = cache.keep(correction, parts, watch.seconds());
  if (!stored.note.empty()) parts.notes.push_back({"cache", stored.note});
  if (!why.empty()) parts.notes.push_back({"cache_full", why});
  return parts;
}

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

SmoothParts find_smooth_parts(const contact::Scene& scene, const contact::Progress& progress) {
  const Processes here = processes();  // the first looks for all of them
  if (here.count == 1) return found_here(scene, progress);
  const std::string bytes = here.first() ? packed(found_here(scene, progress)) : "";
  return unpacked(open_fem_library("model hybrid").from_first(bytes));
}

bool correction_is_kept(const contact::Scene& scene) {
  contact::Scene curved = scene;
  curved.follows_surface = 1.0;
  const auto correction = contact::attempt([&] { return hybrid::correction_scene(curved); });
  return correction &&
         CorrectionCache().find(*correction, scene.asks_for_stress()).parts.has_value();
}

contact::ModelInfo hybrid_model() {
  contact::ModelInfo hybrid{"hybrid", "hybrid",
                            "half-space on a fine grid with a correction for curved, finite bodies "
                            "from coarse finite elements"};
  hybrid.takes = contact::all_demands_but({Demand::sections, Demand::line_contact, Demand::inertia,
                                           Demand::distance_points, Demand::distance_quadratic,
                                           Demand::given_pressure, Demand::yielding_body});
  hybrid.run = [](const ModelInput& input, const contact::Progress& progress,
                  contact::Checkpoint* checkpoint) {
    return hybrid::run_hybrid(input, progress, checkpoint, find_smooth_parts);
  };
  hybrid.refinements = {halfspace::contact_grid()};
  hybrid.half_spaces = false;
  hybrid.choosable = contact::Choosable::corrected_half_spaces;
  hybrid.has_stress = hybrid.corrects_stress = hybrid.parallel = true;
  hybrid.built = ROLLFEM_WITH_FEM;
  hybrid.no_model_error =
      "not estimated: the error estimates include a tenth of the correction's effect";
  return hybrid;
}

contact::ModelInfo fem_model() {
  contact::ModelInfo fem{"fem", "FEM", "3D finite elements of both bodies"};
  fem.takes = contact::all_demands_but(
      {Demand::sections, Demand::line_contact, Demand::stress_in_rigid_body});
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
