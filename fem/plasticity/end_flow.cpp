// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/plasticity/end_flow.hpp"

#include "fem/trace/prescribed.hpp"

#include <deal.II/base/mpi.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace rollfem::fem {

namespace {

/// Part of the way from the load to an end at which the section moves as the end should.
constexpr double section_at = 0.5;

/// s over the radius of the streamline, an angle on a wheel.
double along(const SurfaceShape& shape, const dealii::Point<3>& chart) {
  return shape.is_revolved() ? chart[0] / shape.streamline_radius(chart[1]) : chart[0];
}

using FarNodes = std::map<std::array<dealii::types::global_dof_index, 3>, dealii::Point<3>>;

/// Nodes of this process on the far boundary, in chart coordinates.
FarNodes far_nodes(const Body& body) {
  const auto& element = body.dofs().get_fe();
  const auto& units = element.base_element(0).get_unit_support_points();
  dealii::FEValues<3> values(body.mapping(), element, dealii::Quadrature<3>(units),
                             dealii::update_quadrature_points);
  std::vector<dealii::types::global_dof_index> dofs(element.dofs_per_cell);
  FarNodes nodes;
  for (const auto& cell : body.dofs().active_cell_iterators()) {
    if (!cell->is_locally_owned() || !cell->at_boundary()) continue;
    for (const unsigned int face : cell->face_indices()) {
      if (!cell->at_boundary(face) || cell->face(face)->boundary_id() != far_boundary) continue;
      values.reinit(cell);
      cell->get_dof_indices(dofs);
      for (unsigned int a = 0; a < units.size(); ++a) {
        if (!element.base_element(0).has_support_on_face(a, face)) continue;
        const auto dof = [&](unsigned int c) {
          return dofs[element.component_to_system_index(c, a)];
        };
        nodes[{dof(0), dof(1), dof(2)}] = body.shape().coordinates(values.quadrature_point(a));
      }
    }
  }
  return nodes;
}

}  // namespace

EndFlow::EndFlow(const Body& body, const LinearSolver& solver) : body_(body), solver_(solver) {
  const SurfaceShape& shape = body.shape();
  const MPI_Comm communicator = body.dofs().get_communicator();
  FarNodes all;
  for (const FarNodes& nodes : dealii::Utilities::MPI::all_gather(communicator, far_nodes(body)))
    all.insert(nodes.begin(), nodes.end());
  double furthest = 0.0;
  for (const auto& [dofs, chart] : all) furthest = std::max(furthest, along(shape, chart));
  constexpr double rounding = 1e-6;
  std::vector<Place> places;
  for (const auto& [dofs, chart] : all) {
    if (std::abs(along(shape, chart)) < (1.0 - rounding) * furthest) continue;
    const double s = section_at * chart[0];
    const auto place = shape.place(s, chart[1], chart[2]);
    places.push_back({place[0], place[1], place[2]});
    nodes_.push_back({dofs, shape.frame(chart[0], chart[1]), shape.frame(s, chart[1])});
  }
  sections_ = BodyLocator(body).find(places, body.options().reach_depth());
}

Vector EndFlow::released(const Vector& plastic) const {
  const auto moved = sections_.values(plastic, {1, -1, 1});
  Vector ends = make_vector(body_.dofs());
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    const dealii::Tensor<1, 3> u({moved[k][0], moved[k][1], moved[k][2]});
    dealii::Tensor<1, 3> here;
    for (std::size_t c = 0; c < 3; ++c) here += (u * nodes_[k].there[c]) * nodes_[k].here[c];
    for (unsigned int c = 0; c < 3; ++c)
      if (ends.in_local_range(nodes_[k].dofs[c])) ends(nodes_[k].dofs[c]) = here[c];
  }
  return std::move(solve_with_prescribed(body_.problem(), solver_, {ends}).front());
}

}  // namespace rollfem::fem
