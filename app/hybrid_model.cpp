#include "app/hybrid_model.hpp"

#include "app/fem_library.hpp"
#include "halfspace/model/refinements.hpp"
#include "hybrid/model.hpp"

namespace rollfem::app {

using contact::Demand;

contact::ModelInfo hybrid_model() {
  contact::ModelInfo hybrid{"hybrid", "hybrid",
                            "half-space on a fine grid, corrected for curved and finite bodies by "
                            "coarse finite elements"};
  hybrid.takes = contact::all_demands_but({Demand::inertia, Demand::distance_points,
                                           Demand::distance_quadratic, Demand::given_pressure,
                                           Demand::beyond_half_space});
  hybrid.run = [](const contact::ModelInput& input, const contact::Progress& progress,
                  contact::Checkpoint* checkpoint) {
    const fem::Entry& library = open_fem_library("model hybrid");
    return hybrid::run_hybrid(input, progress, checkpoint, library.find_smooth_parts);
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
