// SPDX-License-Identifier: LGPL-2.1-or-later
// The request of a `rollfem stress` call. Places are those of [[subsurface.*]] in a file, as in a
// case.
#pragma once

#include "contact/case/case.hpp"

#include <optional>
#include <string>
#include <vector>

namespace rollfem::modelling {

struct StressRequest {
  std::string result;               ///< results.h5, or the folder that holds it
  std::vector<std::string> models;  ///< empty: those with stress, whichever are there
  std::string patch;                ///< with profiles: SIDE,POSITION,PATCH; empty: the first
  std::vector<int> points;          ///< load points, from 1; neither: the last one
  std::vector<double> creepages;    ///< load points of these longitudinal creepages
  std::string places;               ///< file with [[subsurface.*]]; may be empty
  bool depth_profile = false;       ///< also without it when no places are asked for
  std::optional<double> depth;      ///< mm, of the depth profile
  std::optional<double> yield_shear_stress;  ///< k, MPa
  std::optional<double> yield_strength;      ///< Y, MPa
};

/// A request with the name it has in all files: point_1, line_1, plane_1, ...
struct NamedRequest {
  std::string name;
  std::string call;  ///< for messages
  contact::SubsurfaceRequest request;
  bool depth_profile = false;  ///< depth counts from the surface under the first place
};

/// Those of the file, in its order. Throws contact::InputError for what is not understood.
std::vector<NamedRequest> named_requests(const StressRequest& request);

/// k of --yield-shear-stress or --yield-strength, MPa; empty when neither is given.
std::optional<double> yield_shear_stress(const StressRequest& request);

}  // namespace rollfem::modelling
