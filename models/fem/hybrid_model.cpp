// SPDX-License-Identifier: LGPL-2.1-or-later
#include "models/fem/hybrid_model.hpp"

#include "contact/base/progress.hpp"
#include "halfspace/model/model.hpp"
#include "halfspace/patch/correction_scene.hpp"
#include "models/caches/correction_cache.hpp"
#include "models/caches/correction_file.hpp"
#include "models/fem/fem_library.hpp"
#include "models/program/provenance.hpp"

#include <fmt/format.h>

#include <string>

namespace rollfem::modelling {

using contact::Demand;

namespace {

using halfspace::SmoothParts;

/// Takes the correction from the cache, otherwise computes it by finite elements and stores it
/// there.
SmoothParts found_here(const contact::Scene& scene, const contact::Progress& progress) {
  const contact::Scene correction = halfspace::correction_scene(scene);
  const CorrectionCache cache;
  const auto stored = cache.find(correction, scene.asks_for_stress());
  if (stored.parts) return *stored.parts;
  const FemLock alone = lock_fem();
  need_session("model hybrid");
  const contact::Stopwatch watch;
  SmoothParts parts = open_fem_library("model hybrid").find_smooth_parts(scene, progress);
  const std::string why = cache.keep(correction, parts, watch.seconds());
  for (const std::string& note : {stored.note, why})
    if (!note.empty()) parts.notes.push_back(note);
  return parts;
}

/// The first process looks for all of them.
SmoothParts find_smooth_parts(const contact::Scene& scene, const contact::Progress& progress) {
  const Processes here = processes();
  if (here.count == 1) return found_here(scene, progress);
  const std::string bytes = here.first() ? packed(values_of(found_here(scene, progress))) : "";
  return parts_of(unpacked(open_fem_library("model hybrid").from_first(bytes)));
}

}  // namespace

hybrid::FindParts smooth_parts_finder() {
  return find_smooth_parts;
}

bool correction_is_kept(const contact::Scene& scene) {
  contact::Scene curved = scene;
  curved.follows_surface = 1.0;
  try {
    const contact::Scene correction = halfspace::correction_scene(curved);
    return CorrectionCache().find(correction, scene.asks_for_stress()).parts.has_value();
  } catch (const std::runtime_error&) {
    return false;  // no patch, no correction
  }
}

contact::ModelInfo hybrid_model() {
  contact::ModelInfo hybrid{"hybrid", "hybrid",
                            "half-space on a fine grid with a correction for curved, finite bodies "
                            "from coarse finite elements"};
  hybrid.takes = contact::all_demands_but({Demand::line_contact, Demand::stress_of_line,
                                           Demand::inertia, Demand::distance_points,
                                           Demand::distance_quadratic, Demand::given_pressure});
  hybrid.run = [](const contact::ModelInput& input, const contact::Progress& progress,
                  contact::Checkpoint* checkpoint) {
    return hybrid::run_hybrid(input, progress, checkpoint, smooth_parts_finder());
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

}  // namespace rollfem::modelling
