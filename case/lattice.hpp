// SPDX-License-Identifier: LGPL-2.1-or-later
// Fields read from a file of values on a regular lattice of points and interpolated by cubics
// through the four nearest points in each direction (exact for polynomials of degree 3); residual
// stress from a file of the same kind.
#pragma once

#include "base/grid.hpp"
#include "case/case.hpp"

#include <string>
#include <string_view>

namespace rollfem::contact {

/// Reads lines `x, y, value ...` (numbers separated by commas, semicolons or blanks; # begins a
/// comment; one line of names is allowed before the numbers), in any order, one for every point of
/// a regular lattice of at least 4 by 4 points. `columns`: number of values after x and y.
/// `shown_name` is used in messages and in Lattice::file. Throws InputError with file and line.
Lattice read_lattice(const std::string& path, const std::string& shown_name, int columns);

/// Residual stress of such lines `depth, along, across` (mm, MPa), depths ascending.
BodyPlasticity::ResidualStress read_residual_stress(const std::string& path,
                                                    const std::string& shown_name);

/// The same as read_lattice from the text of such a file.
Lattice parse_lattice(std::string_view text, const std::string& shown_name, int columns);

/// Value of a column at a point within the lattice; outside, the outermost cubic is extrapolated.
double lattice_value(const Lattice& lattice, int column, double x, double y);

/// Whether all element centres lie within the lattice.
bool covers(const Lattice& lattice, const ContactGrid& grid);

/// Column at the element centres. Throws InputError when the grid extends beyond the lattice;
/// `what` names the key in the message.
Field sample_lattice(const Lattice& lattice, int column, const ContactGrid& grid,
                     const std::string& what);

}  // namespace rollfem::contact
