// SPDX-License-Identifier: LGPL-2.1-or-later
// The profile named by a case: built in, from arcs, polynomials or a file,
// checked, and repaired only as the case requests.
#pragma once

#include "base/errors.hpp"
#include "case/case.hpp"
#include "profiles/profile_curve.hpp"
#include "profiles/smoothing_spline.hpp"

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rollfem::profiles {

/// Defects of a file of which every one can be repaired by a key.
class RepairableProfile : public contact::InputError {
 public:
  RepairableProfile(const std::string& text, bool wheel, std::vector<std::string> keys)
      : InputError(text), of_wheel(wheel), repairs(std::move(keys)) {}
  bool of_wheel;
  std::vector<std::string> repairs;  ///< "flip = true", under [wheel_profile] or [rail_profile]
};

/// Origin of a profile.
struct ProfileReport {
  std::string kind;                          ///< "built in", "arcs", "polynomial", "file", "radius"
  std::size_t points = 0;                    ///< of a file, after repairs
  std::optional<SmoothingReport> smoothing;  ///< of a file
  /// Warning of what a file asks for and is not done, or of coarsely rounded points.
  std::string neglected;
};

/// These warnings of the profile files of a case.
std::vector<std::string> neglected_in_files(const contact::Case& input);

/// What to do where measured points scatter and are not smoothed; otherwise empty.
std::string scatter_advice(const ProfileReport& report, bool wheel);

/// `wheel`: else rail. Files are relative to the folder of `case_file`. Throws contact::InputError
/// with file, line and value.
ProfileCurve make_profile(const contact::ProfileSource& source, bool wheel,
                          const std::string& case_file, ProfileReport* report = nullptr);

/// The same from the text of a file named by `source`, without rotation or shift.
ProfileCurve profile_of_text(const std::string& text, const contact::ProfileSource& source,
                             bool wheel);

/// The ends of a profile with ProfileSource::free_ends, where its side faces begin.
std::array<ProfilePoint, 2> free_ends_of(const ProfileCurve& curve);

/// y of the tip of the flange, mm; nothing where the profile has none.
std::optional<double> flange_tip(const ProfileCurve& curve);

/// The profile of a body of the case; of an arc of its transverse radius through (0, 0) when it has
/// no profile. Also throws when the flange contradicts the flange back of the wheelset.
ProfileCurve profile_of_case(const contact::Case& input, bool wheel,
                             ProfileReport* report = nullptr);

}  // namespace rollfem::profiles
