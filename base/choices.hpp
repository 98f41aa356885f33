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

/// Shape of the traction bound of brushes along a strip, t from -1 to 1 over its length.
enum class BoundShape {
  parabolic,  ///< 1 - t^2
  elliptic,   ///< sqrt(1 - t^2)
};

/// Flexibilities of the brushes of FASTSIM.
enum class Flexibilities {
  three,  ///< L1, L2, L3: one for each creepage
  one,    ///< Kalker's weighted mean, as in the paper of 1982
};

/// Position of the elements in FASTSIM's strips.
enum class FastsimElements {
  chord,  ///< every strip divided into equal elements: forces of order 2 for the parabolic bound
          ///< without spin, 1.5 for the elliptic one, 1 with spin, which turns the slip
  grid,   ///< elements of the bounding box whose centres lie in the ellipse, the first reached by a
          ///< whole step, the spin a sixth of a step upstream, as in CONTACT: order one
};

}  // namespace rollfem::contact
