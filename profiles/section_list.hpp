// SPDX-License-Identifier: LGPL-2.1-or-later
// Files that list the sections of a body.
#pragma once

#include "case/track.hpp"
#include "profiles/section_surface.hpp"

#include <memory>
#include <string>
#include <vector>

namespace rollfem::profiles {

struct ListedSections {
  std::vector<PlacedSection> sections;
  SectionSpline spline = SectionSpline::through;
  bool around = false;  ///< a wheel described over a full turn; the last section is the first
  bool found = false;   ///< the features, which the list does not give
  std::string without_features;  ///< why those found are not used; empty: they are
};

/// Finds the features of sections: the middle of every bend from level (up to 30 degrees) to steep
/// (from 60 degrees) or back, where a head, a flank or the floor of a groove ends, and kinks. If
/// sections have different numbers of features, they are matched from neighbour to neighbour by
/// kind, order and place, beginning with the section with most. If the match is ambiguous, no
/// section gets features and the reason is returned; otherwise an empty text.
std::string find_features(std::vector<PlacedSection>& sections);

/// The list that the source names, each section read and repaired as the source says. Throws
/// contact::InputError with file and line.
ListedSections read_sections(const contact::ProfileSource& source, bool wheel,
                             const std::string& case_file);

/// The sections listed by the file that the source names (ProfileSource::lists_sections), each read
/// and repaired as the source says. Nothing where the source names a single profile. Throws
/// contact::InputError with file and line.
std::shared_ptr<const SectionSurface> make_sections(const contact::ProfileSource& source,
                                                    bool wheel, const std::string& case_file);

}  // namespace rollfem::profiles
