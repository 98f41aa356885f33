// Profiles from tangent arcs and from polynomials, as given in a case.
#pragma once

#include "contact/case/track.hpp"
#include "profiles/profile_curve.hpp"

#include <string>

namespace rollfem::profiles {

/// Arcs tangent to each other, through (0, 0); `name`: file and section for messages. Throws
/// contact::InputError for lists that do not fit or an arc that ends beyond its vertical tangent.
ProfileCurve arc_profile_curve(const contact::ProfileSource& source, bool wheel,
                               const std::string& name);

/// Pieces z(y) that meet in value and slope. Throws contact::InputError.
ProfileCurve polynomial_profile_curve(const contact::ProfileSource& source,
                                      const std::string& name);

}  // namespace rollfem::profiles
