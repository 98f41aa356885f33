// One resolution of the model "halfspace": every load point of steady rolling, or every step of a
// history. Levels start from each other: the next coarser one gives the first guess and the error
// estimate.
#pragma once

#include "contact/base/checkpoint.hpp"
#include "contact/solve/defect_correction.hpp"
#include "contact/solve/model.hpp"
#include "halfspace/elasticity/compliance.hpp"

#include <memory>
#include <string>
#include <vector>

namespace rollfem::halfspace {

/// What a finer level needs of a coarser one besides its results: p_t / g, between -1 and 1.
struct LevelResult {
  contact::ContactGrid grid;
  contact::Field pressure;   ///< without friction, MPa; of the last step in a history
  int contact_elements = 0;  ///< of the last load point
  std::vector<contact::TangentialField> relative_traction;  ///< per load point; empty in a history
  std::vector<contact::PointResult> points;
  double setup_seconds = 0.0;
  double normal_seconds = 0.0;
  double tangential_seconds = 0.0;
};

/// Solves all load points with cells of dx by dy. `coarser` may be null. `stage_prefix` stands
/// before the stage names of the progress events. With a `checkpoint` (may be null) load points
/// that it holds are taken up and others are kept there.
LevelResult solve_level(const contact::Case& input, double dx, double dy,
                        const LevelResult* coarser, const std::string& stage_prefix,
                        const contact::Progress& progress,
                        contact::Checkpoint* checkpoint = nullptr);

}  // namespace rollfem::halfspace
