// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/linear/mirrored_halves.hpp"

#include <deal.II/base/quadrature.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace rollfem::fem {

namespace {

using Terms = std::vector<std::pair<dealii::types::global_dof_index, double>>;

/// Nodes closer than this, relative to the size of the body, coincide.
constexpr double same_place = 1e-10;

struct Node {
  dealii::Point<3> place;
  std::array<int, 3> unknown;       ///< by component
  std::array<bool, 3> constrained;  ///< a hanging node may coincide with another one
};

/// The nodes of a body, and the side of the plane of its cells.
struct MirrorImages {
  std::vector<Node> nodes;
  std::vector<bool> positive_cells;  ///< in the order of the active cells
  std::vector<int> image;            ///< image of each unknown; itself in the plane
  std::vector<int> component;        ///< of each unknown
  std::vector<bool> positive;        ///< of each unknown: x > 0, or in the plane
  double tolerance = 0.0;            ///< mm

  explicit MirrorImages(const ElasticProblem& problem) {
    collect(problem);
    for (const Node& node : nodes) tolerance = std::max(tolerance, same_place * node.place.norm());
  }
  bool in_plane(const Node& node) const { return std::abs(node.place[0]) <= tolerance; }
  bool find();
  bool flows_alike(const MaterialMotion& motion) const;

 private:
  void collect(const ElasticProblem& problem);
  bool are_images(const Node& a, const Node& b) const;
  void join(const Node& a, const Node& b);
};

void MirrorImages::collect(const ElasticProblem& problem) {
  const auto& element = problem.dofs.get_fe();
  const dealii::FE_Q<3> scalar(element.degree);
  dealii::FEValues<3> values(problem.mapping, scalar,
                             dealii::Quadrature<3>(scalar.get_unit_support_points()),
                             dealii::update_quadrature_points);
  std::vector<bool> seen(problem.dofs.n_dofs(), false);
  component.resize(seen.size());
  std::vector<dealii::types::global_dof_index> indices(element.dofs_per_cell);
  for (const auto& cell : problem.dofs.active_cell_iterators()) {
    values.reinit(static_cast<const dealii::Triangulation<3>::active_cell_iterator&>(cell));
    cell->get_dof_indices(indices);
    positive_cells.push_back(cell->center()[0] > 0.0);
    for (unsigned int k = 0; k < scalar.dofs_per_cell; ++k) {
      Node node{values.quadrature_point(k), {}, {}};
      for (unsigned int c = 0; c < 3; ++c) {
        node.unknown[c] = static_cast<int>(indices[element.component_to_system_index(c, k)]);
        node.constrained[c] = problem.constraints.is_constrained(node.unknown[c]);
        component[node.unknown[c]] = static_cast<int>(c);
      }
      if (!seen[node.unknown[0]]) nodes.push_back(node);
      seen[node.unknown[0]] = true;
    }
  }
}

bool MirrorImages::are_images(const Node& a, const Node& b) const {
  return a.constrained == b.constrained && std::abs(a.place[0] + b.place[0]) <= tolerance &&
         std::abs(a.place[1] - b.place[1]) <= tolerance &&
         std::abs(a.place[2] - b.place[2]) <= tolerance;
}

void MirrorImages::join(const Node& a, const Node& b) {
  for (int c = 0; c < 3; ++c) {
    image[a.unknown[c]] = b.unknown[c];
    image[b.unknown[c]] = a.unknown[c];
    positive[a.unknown[c]] = in_plane(a) || a.place[0] > 0.0;
    positive[b.unknown[c]] = in_plane(b) || b.place[0] > 0.0;
  }
}

/// False when a node has no image. Nodes are sorted by a number shared by images and otherwise only
/// by chance.
bool MirrorImages::find() {
  const auto number = [](const dealii::Point<3>& p) {
    return 0.754877666 * std::abs(p[0]) + 0.569840291 * p[1] + 0.430159709 * p[2];
  };
  std::sort(nodes.begin(), nodes.end(),
            [&](const Node& a, const Node& b) { return number(a.place) < number(b.place); });
  image.assign(component.size(), -1);
  positive.assign(component.size(), false);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Node& node = nodes[i];
    if (in_plane(node)) join(node, node);
    if (image[node.unknown[0]] >= 0) continue;
    const double last = number(node.place) + 3.0 * tolerance;
    const auto is_image = [&](const Node& other) {
      return image[other.unknown[0]] < 0 && are_images(node, other);
    };
    std::size_t k = i + 1;
    while (k < nodes.size() && number(nodes[k].place) <= last && !is_image(nodes[k])) ++k;
    if (k == nodes.size() || !is_image(nodes[k])) return false;
    join(node, nodes[k]);
  }
  return true;
}

/// Whether the flow at images is time-reversed, which does not affect inertia because it is
/// quadratic in the velocity.
bool MirrorImages::flows_alike(const MaterialMotion& motion) const {
  return std::all_of(nodes.begin(), nodes.end(), [&](const Node& node) {
    const auto here = motion.at(node.place);
    const auto there = motion.at({-node.place[0], node.place[1], node.place[2]});
    const dealii::Tensor<1, 3> change({here[0] - there[0], here[1] + there[1], here[2] + there[2]});
    return change.norm() <= same_place * here.norm();
  });
}

/// Whether the unknown at the image of a constrained one is constrained by the images of its terms.
bool constraints_have_images(const dealii::AffineConstraints<double>& constraints,
                             const MirrorImages& mirror) {
  constexpr double same_weight = 1e-12;
  const auto sorted = [&](int unknown, bool of_images) {
    Terms terms = *constraints.get_constraint_entries(unknown);
    if (of_images)
      for (auto& term : terms) term.first = mirror.image[term.first];
    std::sort(terms.begin(), terms.end());
    return terms;
  };
  for (int i = 0; i < static_cast<int>(mirror.image.size()); ++i) {
    const int image = mirror.image[i];
    if (constraints.is_constrained(i) != constraints.is_constrained(image)) return false;
    if (!constraints.is_constrained(i)) continue;
    const Terms own = sorted(i, true), other = sorted(image, false);
    const bool alike = std::equal(
        own.begin(), own.end(), other.begin(), other.end(), [&](const auto& a, const auto& b) {
          // Components do not mix: signs of images cancel.
          return a.first == b.first && std::abs(a.second - b.second) <= same_weight &&
                 mirror.component[a.first] == mirror.component[i];
        });
    if (!alike) return false;
  }
  return true;
}

/// `parity`: 1 even, -1 odd.
FreeUnknowns half(const dealii::AffineConstraints<double>& constraints, const MirrorImages& mirror,
                  double parity) {
  std::vector<Multiple> multiples;
  for (int i = 0; i < static_cast<int>(mirror.image.size()); ++i) {
    const double sign = mirror.component[i] == 0 ? -parity : parity;
    const bool vanishes = mirror.image[i] == i && sign < 0.0;
    multiples.push_back(mirror.positive[i] ? Multiple{i, vanishes ? 0.0 : 1.0}
                                           : Multiple{mirror.image[i], sign});
  }
  FreeUnknowns unknowns = number_free_unknowns(constraints, multiples);
  unknowns.cells = mirror.positive_cells;
  return unknowns;
}

}  // namespace

std::optional<MirroredHalves> find_mirrored_halves(const ElasticProblem& problem) {
  if (problem.dofs.get_fe().degree < 2) return std::nullopt;
  MirrorImages mirror(problem);
  if (!mirror.find() || !constraints_have_images(problem.constraints, mirror)) return std::nullopt;
  if (has_inertia(problem) && !mirror.flows_alike(problem.motion)) return std::nullopt;
  return MirroredHalves{half(problem.constraints, mirror, 1.0),
                        half(problem.constraints, mirror, -1.0)};
}

}  // namespace rollfem::fem
