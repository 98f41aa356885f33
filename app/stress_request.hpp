// The request of a `rollfem stress` call; places on its command line
// become requests like those of a case file.
#pragma once

#include "contact/case/case.hpp"

#include <optional>
#include <string>
#include <vector>

namespace rollfem::app {

struct StressRequest {
  std::string result;               ///< results.h5, or the folder that holds it
  std::vector<std::string> models;  ///< empty: those with stress, whichever are there
  std::string patch;                ///< with profiles: SIDE,POSITION,PATCH; empty: the first
  std::vector<int> points;          ///< load points, from 1; neither: the last one
  std::vector<double> creepages;    ///< load points of these longitudinal creepages
  std::vector<std::string> places;  ///< x,y,z
  std::vector<std::string> lines;   ///< x,y,z:x,y,z[:n]
  std::vector<std::string> planes;  ///< x,y,z:x,y,z:x,y,z[:n,m]
  std::string body;                 ///< wheel, rail; empty: by the sign of z
  bool depth_profile = false;       ///< also without it when no places are asked for
  std::optional<double> depth;      ///< mm, of the depth profile
  std::optional<double> yield_shear_stress;  ///< k, MPa
  std::optional<double> yield_strength;      ///< Y, MPa
  std::string directory;                     ///< empty: <result folder>_stress
  bool quiet = false;
  bool figures = true;
};

/// A request with the name it has in all files: at_1, line_1, plane_1, ...
struct NamedRequest {
  std::string name;
  std::string call;  ///< as the user wrote it, for messages
  contact::SubsurfaceRequest request;
};

/// Of --at, --line and --plane, in this order. Without --body a request at z = 0 alone is one in
/// each body. Throws contact::InputError for what is not understood.
std::vector<NamedRequest> named_requests(const StressRequest& request);

/// k of --yield-shear-stress or --yield-strength, MPa; empty when neither is given.
std::optional<double> yield_shear_stress(const StressRequest& request);

}  // namespace rollfem::app
