// SPDX-License-Identifier: LGPL-2.1-or-later
// Points of a profile from a file: reading the formats, repairs as the case requests, checks.
#pragma once

#include "contact/case/track.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace rollfem::profiles {

struct ListedPoint {
  double y = 0.0, z = 0.0;  ///< mm after reading
  unsigned line = 0;        ///< of the file
};

struct ProfilePoints {
  std::string file;  ///< as named in messages
  std::vector<ListedPoint> list;
  /// The format does not prescribe the direction of the list (SIMPACK, MiniProf).
  bool any_direction = false;
};

/// Two columns (text, CSV), SIMPACK .prw and .prr, MiniProf .whl, .ban and .mpt, distinguished by
/// the file extension. Lengths are converted to mm by the file's own unit, otherwise by `unit`.
/// `path`: location; `name`: name used in messages. Throws contact::InputError with line and value.
ProfilePoints read_profile_points(const std::string& path, const std::string& name, bool wheel,
                                  contact::LengthUnit unit);

/// The same from the text of such a file; the extension of `name` selects the format.
ProfilePoints parse_profile_points(std::string_view text, const std::string& name, bool wheel,
                                   contact::LengthUnit unit);

/// Repairs the points as requested by `source` and rejects remaining defects. Throws
/// contact::InputError naming the key that repairs them.
void mend_and_check(ProfilePoints& points, const contact::ProfileSource& source, bool wheel);

// Parts of mend_and_check.

double median(std::vector<double> values);

/// The section of the case file with the repair keys: "[wheel_profile]".
std::string section_of_profile(bool wheel);

/// Bridges kinks and steps over `rounding`, or rejects them. Throws contact::InputError.
void treat_corners(ProfilePoints& points, const contact::ProfileSource& source, bool wheel);

}  // namespace rollfem::profiles
