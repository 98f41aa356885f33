// SPDX-License-Identifier: LGPL-2.1-or-later
// The request of a `rollfem stress` call. Places are given by [[subsurface.*]] in a file, as in a
// case.
#pragma once

#include "contact/case/case.hpp"

#include <optional>
#include <string>
#include <vector>

namespace rollfem::modelling {

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

/// A request with its name in all files: point_1, line_1, plane_1, ...
struct NamedRequest {
  std::string name;
  std::string call;  ///< for messages
  contact::SubsurfaceRequest request;
  bool depth_profile = false;  ///< depth is relative to the surface at the first place
};

/// The requests of the file, in its order. Throws contact::InputError for invalid content.
std::vector<NamedRequest> named_requests(const StressRequest& request);

/// k from --yield-shear-stress or --yield-strength, MPa; empty if neither is given.
std::optional<double> yield_shear_stress(const StressRequest& request);

}  // namespace rollfem::modelling
