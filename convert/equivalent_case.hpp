// SPDX-License-Identifier: LGPL-2.1-or-later
// The equivalent of one CONTACT case as a case in memory, without a file between.
#pragma once

#include "case/case.hpp"
#include "case/reading/case_reader.hpp"

#include "convert/equivalent.hpp"
#include <string>
#include <vector>

namespace rollfem::convert {

/// Removes the forces where none is prescribed, and the motion where forces are prescribed in all
/// points.
void remove_unused_values(std::vector<Point>& points);

/// All keys of a case with these load points, with a shape that stands for the distances of points.
contact::NamedValues values_of(const Equivalent& made, std::vector<Point> points);
/// Of its own load point alone.
contact::NamedValues values_of(const Equivalent& made);

/// The case of these values, without a file; `name` represents it in messages. Throws
/// contact::InputError where values are out of bounds.
contact::Case case_of(const Equivalent& made, const contact::NamedValues& values,
                      const std::string& name);

}  // namespace rollfem::convert
