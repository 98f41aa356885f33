// SPDX-License-Identifier: LGPL-2.1-or-later
// Enumerations shared by the case file and by the solvers and theories below
// it, so that neither needs to include the other.
#pragma once

namespace rollfem::contact {

/// The friction problem to solve.
enum class Problem {
  steady,        ///< steady rolling, every load point separately
  shift,         ///< bodies pressed and shifted without rolling (Cattaneo); load points are steps
  transient,     ///< rolling in steps from the state before; load points are steps
  frictionless,  ///< only the normal problem, tangential tractions 0
};

/// Words of the members in case files and results. Without one for a new member the program does
/// not compile.
constexpr const char* word_of(Problem problem) {
  switch (problem) {
    case Problem::steady:
      return "steady";
    case Problem::shift:
      return "shift";
    case Problem::transient:
      return "transient";
    case Problem::frictionless:
      return "frictionless";
  }
  return nullptr;
}

/// Order of the one-sided difference along the streamline.
enum class UpwindOrder {
  first,   ///< (u_i - u_i+1) / dx, the spin taken dx/6 upstream, as in CONTACT
  second,  ///< (3 u_i - 4 u_i+1 + u_i+2) / (2 dx)
};

/// Assumed position of the leading edge in the second-order difference (docs/theory.md).
enum class LeadingEdge {
  fitted,  ///< from the pressure, finer than the element size
  plain,   ///< at the border of the elements
};

}  // namespace rollfem::contact
