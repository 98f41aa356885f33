// SPDX-License-Identifier: LGPL-2.1-or-later
// A list of sections as it was read, before they are joined to a surface.
#pragma once

#include "profiles/section_surface.hpp"

#include <string>
#include <vector>

namespace rollfem::profiles {

/// Parameters at which the parts of a section begin and end.
std::vector<double> ends_of_parts(const PlacedSection& section);

struct ListedSections {
  std::vector<PlacedSection> sections;
  SectionSpline spline = SectionSpline::through;
  bool around = false;  ///< a wheel described over a full turn
};

/// The list that the source names, each section read and repaired as the source says. Throws
/// contact::InputError with file and line.
ListedSections read_sections(const contact::ProfileSource& source, bool wheel,
                             const std::string& case_file);

}  // namespace rollfem::profiles
