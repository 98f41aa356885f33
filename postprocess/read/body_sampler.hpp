// SPDX-License-Identifier: LGPL-2.1-or-later
// Displacement and stress at any place of a stored finite-element body: the hexahedron that holds
// the place is found in a tree of boxes, its trilinear map is inverted, and the values of its nodes
// are interpolated. Between the nodes this is as accurate as they are dense: the recovered stress
// of the nodes is exact for the element's polynomials, the interpolation of them is of second
// order in their distance.
#pragma once

#include "contact/result/result.hpp"

#include <array>
#include <string>
#include <vector>

namespace rollfem::postprocess {

using Place = std::array<double, 3>;  ///< mm, global frame

struct BodySample {
  Place place{};       ///< mm, where the values are: the surface for a place beyond it
  double moved = 0.0;  ///< mm, from the place that was asked for
  std::array<double, 3> displacement{};  ///< mm
  std::array<double, 6> stress{};        ///< MPa: xx yy zz xy yz xz
};

class BodySampler {
 public:
  /// Keeps a reference to the body. Throws contact::InputError when it has no cells or no stress.
  explicit BodySampler(const contact::BodyField& body);
  explicit BodySampler(contact::BodyField&&) = delete;

  /// A place outside of all cells by up to two of the cells there is moved onto the surface, along
  /// the axes of the nearest cell; further out contact::InputError says how far the body reaches.
  BodySample at(const Place& place) const;

  /// Whether the place is in a cell, to rounding.
  bool inside(const Place& place) const;

  /// z of the surface over (x, y): between a place of the body and one beyond its surface,
  /// z = inner and z = outer. Throws contact::InputError when they are not.
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
  /// Reference coordinates in [0, 1]^3 of the place of a cell nearest to `place`, and how far off.
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

}  // namespace rollfem::postprocess
