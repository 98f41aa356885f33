// SPDX-License-Identifier: LGPL-2.1-or-later
// Points of a profile from a file: reading the formats, repairs as the case requests, checks.
#pragma once

#include "contact/case/track.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace rollfem::profiles {

struct ListedPoint {
  double y = 0.0, z = 0.0;  ///< mm once read
  unsigned line = 0;        ///< of the file
};

struct ProfilePoints {
  std::string file;  ///< as named in messages
  std::vector<ListedPoint> list;
  /// The format itself leaves the direction of the list open (SIMPACK, MiniProf).
  bool any_direction = false;
};

/// Two columns (text, CSV), SIMPACK .prw and .prr, MiniProf .whl, .ban and .mpt, told apart by the
/// ending. Lengths are turned into mm: by the file's own unit, else by `unit`. `path`: where it is;
/// `name`: how messages call it. Throws contact::InputError with line and value.
ProfilePoints read_profile_points(const std::string& path, const std::string& name, bool wheel,
                                  contact::LengthUnit unit);

/// The same of the text of such a file; the ending of `name` tells the format.
ProfilePoints parse_profile_points(std::string_view text, const std::string& name, bool wheel,
                                   contact::LengthUnit unit);

/// Mends the points as `source` says and refuses what is still wrong. Throws contact::InputError,
/// which names the key that mends it.
void mend_and_check(ProfilePoints& points, const contact::ProfileSource& source, bool wheel);

// Parts of mend_and_check.

double median(std::vector<double> values);

/// The section of the case file that mends: "[wheel_profile]".
std::string section_of_profile(bool wheel);

/// Kinks and steps: bridged over `rounding`, or refused. Throws contact::InputError.
void treat_corners(ProfilePoints& points, const contact::ProfileSource& source, bool wheel);

}  // namespace rollfem::profiles
