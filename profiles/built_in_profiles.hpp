// Standard profiles from their analytic definitions: wheel S1002 (EN 13715, UIC 510-2), rail 60E1
// (EN 13674-1) and the profiles of the Manchester contact benchmark.
#pragma once

#include "profiles/profile_curve.hpp"

#include <string>
#include <vector>

namespace rollfem::profiles {

struct BuiltInProfile {
  std::string name;
  bool wheel = false;
  std::string sentence;
  ProfileCurve (*make)() = nullptr;
};

const std::vector<BuiltInProfile>& built_in_profiles();

/// nullptr when there is none of that name.
const BuiltInProfile* find_built_in_profile(const std::string& name);

/// Height of S1002 by the formulas of its zones, mm, for -70 <= y <= 60, steps at the zone limits
/// included: what the curve is checked against. Throws std::out_of_range elsewhere.
double s1002_height(double y);

}  // namespace rollfem::profiles
