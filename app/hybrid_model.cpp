#include "app/hybrid_model.hpp"

#include "app/fem_library.hpp"
#include "halfspace/model/refinements.hpp"

namespace rollfem::app {

using contact::Demand;

hybrid::FindParts smooth_parts_finder() {
  return [](const contact::Scene& scene, const contact::Progress& progress) {
    return open_fem_library("model hybrid").find_smooth_parts(scene, progress);
  };
}

contact::ModelInfo hybrid_model() {
  contact::ModelInfo hybrid{"hybrid", "hybrid",
                            "half-space on a fine grid, corrected for curved and finite bodies by "
                            "coarse finite elements"};
  hybrid.takes = contact::all_demands_but({Demand::inertia, Demand::distance_points,
                                           Demand::distance_quadratic, Demand::given_pressure,
                                           Demand::beyond_half_space});
  hybrid.run = [](const contact::ModelInput& input, const contact::Progress& progress,
                  contact::Checkpoint* checkpoint) {
    return hybrid::run_hybrid(input, progress, checkpoint, smooth_parts_finder());
  };
  hybrid.refinements = {halfspace::contact_grid()};
  hybrid.half_spaces = false;
  hybrid.parallel = true;
  hybrid.built = ROLLFEM_WITH_FEM;
  hybrid.no_model_error =
      "not estimated: a tenth of what the correction changes is in the error estimates";
  return hybrid;
}

}  // namespace rollfem::app
