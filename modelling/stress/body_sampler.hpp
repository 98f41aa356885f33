// SPDX-License-Identifier: LGPL-2.1-or-later
// Displacement and stress at any place of a stored finite-element body: a tree of boxes finds the
// hexahedron around the place, its trilinear map is inverted, and its nodal values are
// interpolated. The recovered nodal stress is exact for the element's polynomials; interpolation
// between nodes is of second order in their distance.
#pragma once

#include "result/result.hpp"
#include "result/stress_measures.hpp"

#include <array>
#include <string>
#include <vector>

namespace rollfem::modelling {

using Place = std::array<double, 3>;  ///< mm, global frame

struct BodySample {
  Place place{};       ///< mm, where the values apply: on the surface for a place beyond it
  double moved = 0.0;  ///< mm, distance from the requested place
  std::array<double, 3> displacement{};  ///< mm
  contact::SymmetricTensor stress{};     ///< MPa
};

class BodySampler {
 public:
  /// Keeps a reference to the body. Throws contact::InputError if it has no cells or no stress.
  explicit BodySampler(const contact::BodyField& body);
  explicit BodySampler(contact::BodyField&&) = delete;

  /// A place outside all cells by at most two local cell sizes is moved onto the surface along the
  /// axes of the nearest cell. Farther places throw contact::InputError with the extent of the
  /// body.
  BodySample at(const Place& place) const;

  /// Whether the place is in a cell, to rounding.
  bool inside(const Place& place) const;

  /// z of the surface at (x, y), between z = inner inside the body and z = outer outside. Throws
  /// contact::InputError if they are not.
  double surface(double x, double y, double inner, double outer) const;

  /// Corners of the smallest box that holds the body, mm.
  const Place& lower() const { return tree_.front().lower; }
  const Place& upper() const { return tree_.front().upper; }

 private:
  struct Node {
    Place lower{}, upper{};
    int first = 0, last = 0;  ///< cells order_[first, last) of a leaf
    int left = -1, right = -1;
  };
  /// Reference coordinates in [0, 1]^3 of the point of a cell nearest to `place`, and its distance.
  struct Hit {
    int cell = -1;
    Place reference{};
    Place place{};
    double distance = 0.0;
  };

  int build(int first, int last);
  void nearest(int node, const Place& place, Hit& best) const;
  Hit invert(int cell, const Place& place) const;
  Hit find(const Place& place) const;
  Place map(int cell, const Place& reference) const;
  double longest_edge(int cell) const;

  const contact::BodyField& body_;
  std::vector<int> order_;
  std::vector<Node> tree_;
};

}  // namespace rollfem::modelling
