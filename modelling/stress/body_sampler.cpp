// SPDX-License-Identifier: LGPL-2.1-or-later
#include "modelling/stress/body_sampler.hpp"

#include "base/errors.hpp"

#include <Eigen/Dense>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rollfem::modelling {
namespace {

constexpr int leaf_size = 8;

/// Corners of VTK's hexahedron in the unit cube.
constexpr int corner[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                              {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
constexpr int edge[12][2] = {{0, 1}, {1, 2}, {3, 2}, {0, 3}, {4, 5}, {5, 6},
                             {7, 6}, {4, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};

double weight(int k, const Place& r) {
  double product = 1.0;
  for (int c = 0; c < 3; ++c) product *= corner[k][c] == 1 ? r[c] : 1.0 - r[c];
  return product;
}

/// Derivative of the weight of a corner along reference axis d.
double slope(int k, const Place& r, int d) {
  double product = corner[k][d] == 1 ? 1.0 : -1.0;
  for (int c = 0; c < 3; ++c)
    if (c != d) product *= corner[k][c] == 1 ? r[c] : 1.0 - r[c];
  return product;
}

double distance(const Place& a, const Place& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

double distance_to_box(const Place& place, const Place& lower, const Place& upper) {
  Place off{};
  for (int c = 0; c < 3; ++c) off[c] = std::max({lower[c] - place[c], 0.0, place[c] - upper[c]});
  return std::hypot(off[0], off[1], off[2]);
}

}  // namespace

BodySampler::BodySampler(const contact::BodyField& body) : body_(body) {
  if (body.cells.empty() || body.stress.size() != body.points.size() ||
      body.displacement.size() != body.points.size())
    throw contact::InputError(fmt::format(
        "the {} is stored without displacement and stress; do: run the case again", body.name));
  for (const auto& cell : body.cells)
    for (const int node : cell)
      if (node < 0 || node >= static_cast<int>(body.points.size()))
        throw contact::InputError(
            fmt::format("a cell of the {} names node {} of {}; do: run the case again", body.name,
                        node, body.points.size()));
  order_.resize(body.cells.size());
  std::iota(order_.begin(), order_.end(), 0);
  tree_.reserve(body.cells.size());
  build(0, static_cast<int>(order_.size()));
}

/// Splits the cells at the median along the longest side of their box.
int BodySampler::build(int first, int last) {
  const int index = static_cast<int>(tree_.size());
  tree_.emplace_back();
  Node node;
  node.first = first;
  node.last = last;
  node.lower.fill(contact::infinity);
  node.upper.fill(-contact::infinity);
  for (int k = first; k < last; ++k)
    for (const int p : body_.cells[order_[k]])
      for (int c = 0; c < 3; ++c) {
        node.lower[c] = std::min(node.lower[c], body_.points[p][c]);
        node.upper[c] = std::max(node.upper[c], body_.points[p][c]);
      }
  if (last - first > leaf_size) {
    int axis = 0;
    for (int c = 1; c < 3; ++c)
      if (node.upper[c] - node.lower[c] > node.upper[axis] - node.lower[axis]) axis = c;
    const int middle = first + (last - first) / 2;
    const auto centre = [&](int cell) {
      double sum = 0.0;
      for (const int p : body_.cells[cell]) sum += body_.points[p][axis];
      return sum;
    };
    std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
                     [&](int a, int b) { return centre(a) < centre(b); });
    node.left = build(first, middle);
    node.right = build(middle, last);
  }
  tree_[index] = node;
  return index;
}

Place BodySampler::map(int cell, const Place& reference) const {
  Place place{};
  for (int k = 0; k < 8; ++k)
    for (int c = 0; c < 3; ++c)
      place[c] += weight(k, reference) * body_.points[body_.cells[cell][k]][c];
  return place;
}

double BodySampler::longest_edge(int cell) const {
  double longest = 0.0;
  for (const auto& e : edge)
    longest = std::max(longest, distance(body_.points[body_.cells[cell][e[0]]],
                                         body_.points[body_.cells[cell][e[1]]]));
  return longest;
}

/// Newton's method restricted to the unit cube. For a place in the cell it converges there; for one
/// outside it ends on the side of the cell, reached along the cell's axes.
BodySampler::Hit BodySampler::invert(int cell, const Place& place) const {
  Hit hit;
  hit.cell = cell;
  hit.reference = {0.5, 0.5, 0.5};
  const double small = 1e-14 * longest_edge(cell);
  for (int step = 0; step < 30; ++step) {
    hit.place = map(cell, hit.reference);
    Eigen::Vector3d residual;
    Eigen::Matrix3d jacobian = Eigen::Matrix3d::Zero();
    for (int c = 0; c < 3; ++c) residual[c] = place[c] - hit.place[c];
    for (int k = 0; k < 8; ++k)
      for (int d = 0; d < 3; ++d)
        for (int c = 0; c < 3; ++c)
          jacobian(c, d) += slope(k, hit.reference, d) * body_.points[body_.cells[cell][k]][c];
    if (residual.norm() <= small) break;
    const Eigen::Vector3d change = jacobian.partialPivLu().solve(residual);
    Place next{};
    for (int d = 0; d < 3; ++d) next[d] = std::clamp(hit.reference[d] + change[d], 0.0, 1.0);
    const bool stays = distance(next, hit.reference) < 1e-15;
    hit.reference = next;
    if (stays) break;
  }
  hit.place = map(cell, hit.reference);
  hit.distance = distance(hit.place, place);
  return hit;
}

void BodySampler::nearest(int index, const Place& place, Hit& best) const {
  const Node& node = tree_[index];
  if (best.cell >= 0 &&
      (best.distance == 0.0 || distance_to_box(place, node.lower, node.upper) >= best.distance))
    return;
  if (node.left < 0) {
    for (int k = node.first; k < node.last; ++k) {
      const Hit hit = invert(order_[k], place);
      if (std::isfinite(hit.distance) && (best.cell < 0 || hit.distance < best.distance))
        best = hit;
    }
    return;
  }
  const Node& left = tree_[node.left];
  const Node& right = tree_[node.right];
  const bool left_first = distance_to_box(place, left.lower, left.upper) <=
                          distance_to_box(place, right.lower, right.upper);
  nearest(left_first ? node.left : node.right, place, best);
  nearest(left_first ? node.right : node.left, place, best);
}

BodySampler::Hit BodySampler::find(const Place& place) const {
  Hit best;
  nearest(0, place, best);
  return best;
}

bool BodySampler::inside(const Place& place) const {
  const Hit hit = find(place);
  return hit.distance <= 1e-9 * longest_edge(hit.cell);
}

double BodySampler::surface(double x, double y, double inner, double outer) const {
  if (!inside({x, y, inner}) || inside({x, y, outer}))
    throw contact::InputError(fmt::format(
        "the surface of the {} is not between z = {:g} and {:g} mm at x = {:g}, y = {:g} mm",
        body_.name, inner, outer, x, y));
  // Bisection, because a place is only known to be in the body or not.
  for (int step = 0; step < 40; ++step) {
    const double middle = 0.5 * (inner + outer);
    (inside({x, y, middle}) ? inner : outer) = middle;
  }
  return inner;
}

BodySample BodySampler::at(const Place& place) const {
  const Hit hit = find(place);
  if (hit.distance > 2.0 * longest_edge(hit.cell))
    throw contact::InputError(
        fmt::format("the point ({:g}, {:g}, {:g}) mm is {:.3g} mm outside the computed {}, which "
                    "reaches from ({:.4g}, {:.4g}, {:.4g}) to ({:.4g}, {:.4g}, {:.4g}) mm; do: "
                    "request points inside it, or run the case with a larger [fem] extent",
                    place[0], place[1], place[2], hit.distance, body_.name, lower()[0], lower()[1],
                    lower()[2], upper()[0], upper()[1], upper()[2]));
  BodySample sample;
  sample.place = hit.place;
  sample.moved = hit.distance;
  for (int k = 0; k < 8; ++k) {
    const int p = body_.cells[hit.cell][k];
    const double w = weight(k, hit.reference);
    for (int c = 0; c < 3; ++c) sample.displacement[c] += w * body_.displacement[p][c];
    for (int c = 0; c < 6; ++c) sample.stress[c] += w * body_.stress[p][c];
  }
  return sample;
}

}  // namespace rollfem::modelling
