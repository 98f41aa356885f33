// SPDX-License-Identifier: LGPL-2.1-or-later
// Profiles from tangent arcs and from polynomials, as given in a case.
#pragma once

#include "case/track.hpp"
#include "profiles/profile_curve.hpp"

#include <string>
#include <vector>

namespace rollfem::profiles {

/// Arcs tangent to each other, through (0, 0); `name`: file and section for messages. Throws
/// contact::InputError for lists of wrong length or an arc that ends beyond its vertical tangent.
ProfileCurve arc_profile_curve(const contact::ProfileSource& source, bool wheel,
                               const std::string& name);

/// Pieces z(y) that meet in value and slope. Throws contact::InputError.
ProfileCurve polynomial_profile_curve(const contact::ProfileSource& source,
                                      const std::string& name);

// Standard profiles from their analytic definitions: wheel S1002 (EN 13715, UIC 510-2), rails of EN
// 13674-1 and the profiles of the Manchester contact benchmark.

struct BuiltInProfile {
  std::string name;
  bool wheel = false;
  std::string sentence;
  ProfileCurve (*make)() = nullptr;
};

const std::vector<BuiltInProfile>& built_in_profiles();

/// nullptr for an unknown name.
const BuiltInProfile* find_built_in_profile(const std::string& name);

/// Height of S1002 by the formulas of its zones, mm, for -70 <= y <= 60, including the steps at the
/// zone limits: reference for checking the curve. Throws std::out_of_range outside.
double s1002_height(double y);

}  // namespace rollfem::profiles
