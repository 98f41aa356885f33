// SPDX-License-Identifier: LGPL-2.1-or-later
// Stress and displacement below the surface from stored results, without solving again. For the
// half-space and every theory with tractions on the contact grid by exact integrals over its
// elements, for finite elements by interpolation in the stored bodies.
#pragma once

#include "contact/solve/model.hpp"
#include "postprocess/stress/stress_report.hpp"

#include <optional>
#include <string>
#include <vector>

namespace rollfem::modelling {

/// The request of a `rollfem stress` call.
struct StressRequest {
  std::string result;               ///< results.h5, or the folder that holds it
  std::vector<std::string> models;  ///< empty: those with stress
  std::string patch;                ///< with profiles: SIDE,POSITION,PATCH; empty: the first
  std::vector<int> points;          ///< load points, from 1; the last if `creepages` is empty too
  std::vector<double> creepages;    ///< load points with these longitudinal creepages
  std::string places;               ///< file with [[subsurface.*]]; may be empty
  bool depth_profile = false;       ///< also the default if no places are requested
  std::optional<double> depth;      ///< mm, of the depth profile
  std::optional<double> yield_shear_stress;  ///< k, MPa
  std::optional<double> yield_strength;      ///< Y, MPa
};

/// `warnings` receives notes for the user, and what was left out and why. Throws
/// contact::InputError if nothing is left.
postprocess::StressReport stored_stress(const StressRequest& request,
                                        const contact::ModelRegistry& models,
                                        std::vector<std::string>& warnings);

}  // namespace rollfem::modelling
