// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/stress/body_nodes.hpp"

#include <deal.II/base/mpi.h>
#include <deal.II/fe/fe_tools.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/cell_id.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace rollfem::fem {

namespace {

using Place = std::array<double, 3>;

/// Unknown of a cell by node in lexicographic order and component.
std::vector<std::array<unsigned int, 3>> unknowns_of_nodes(
    const dealii::FiniteElement<3>& element) {
  const auto hierarchic = dealii::FETools::lexicographic_to_hierarchic_numbering<3>(element.degree);
  std::vector<std::array<unsigned int, 3>> found(hierarchic.size());
  for (std::size_t a = 0; a < found.size(); ++a)
    for (unsigned int c = 0; c < 3; ++c)
      found[a][c] = element.component_to_system_index(c, hierarchic[a]);
  return found;
}

/// The n^3 nodes of a cell, lexicographic, as (n - 1)^3 hexahedra in VTK's order of corners.
void add_hexahedra(const std::vector<int>& points, int n,
                   std::vector<std::array<int, 8>>& hexahedra) {
  const auto at = [&](int i, int j, int k) { return points[(k * n + j) * n + i]; };
  for (int k = 0; k + 1 < n; ++k)
    for (int j = 0; j + 1 < n; ++j)
      for (int i = 0; i + 1 < n; ++i)
        hexahedra.push_back({at(i, j, k), at(i + 1, j, k), at(i + 1, j + 1, k), at(i, j + 1, k),
                             at(i, j, k + 1), at(i + 1, j, k + 1), at(i + 1, j + 1, k + 1),
                             at(i, j + 1, k + 1)});
}

}  // namespace

/// The cells of one process: (degree + 1)^3 nodes each, named by their first unknown.
struct BodyNodes::Cells {
  std::vector<dealii::CellId> id;
  std::vector<dealii::types::global_dof_index> node;
  std::vector<Place> place;
  std::vector<dealii::types::global_dof_index> distinct;  ///< nodes, in the order of nodes_

  template <class Archive>
  void serialize(Archive& archive, unsigned int /*version*/) {
    archive& id& node& place& distinct;
  }
};

BodyNodes::Cells BodyNodes::collect_cells() {
  const auto& element = body_.dofs().get_fe();
  const auto unknowns = unknowns_of_nodes(element);
  std::vector<dealii::Point<3>> places;
  for (const auto& node : unknowns) places.push_back(element.get_unit_support_points()[node[0]]);
  dealii::FEValues<3> at_nodes(body_.mapping(), element, dealii::Quadrature<3>(places),
                               dealii::update_quadrature_points);
  std::vector<dealii::types::global_dof_index> indices(element.dofs_per_cell);
  std::unordered_map<dealii::types::global_dof_index, bool> seen;
  Cells cells;
  for (const auto& cell : body_.dofs().active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    at_nodes.reinit(cell);
    cell->get_dof_indices(indices);
    cells.id.push_back(cell->id());
    for (std::size_t a = 0; a < unknowns.size(); ++a) {
      const auto& u = unknowns[a];
      const auto& p = at_nodes.quadrature_point(static_cast<unsigned int>(a));
      cells.node.push_back(indices[u[0]]);
      cells.place.push_back({p[0], p[1], p[2]});
      if (!seen.try_emplace(indices[u[0]], true).second) continue;
      nodes_.push_back({indices[u[0]], indices[u[1]], indices[u[2]]});
      cells.distinct.push_back(indices[u[0]]);
    }
  }
  return cells;
}

/// Cells in the order of their ids, independent of their owners; points in order of occurrence.
void BodyNodes::number(const std::vector<Cells>& processes) {
  struct Entry {
    const Cells* cells;
    std::size_t number;
  };
  std::vector<Entry> order;
  for (const Cells& cells : processes)
    for (std::size_t c = 0; c < cells.id.size(); ++c) order.push_back({&cells, c});
  std::sort(order.begin(), order.end(), [](const Entry& a, const Entry& b) {
    return a.cells->id[a.number] < b.cells->id[b.number];
  });
  const int n = static_cast<int>(body_.dofs().get_fe().degree) + 1;
  const auto per_cell = static_cast<std::size_t>(n) * n * n;
  std::unordered_map<dealii::types::global_dof_index, int> point_of;
  std::vector<int> points(per_cell);
  for (const Entry& entry : order) {
    for (std::size_t a = 0; a < per_cell; ++a) {
      const std::size_t at = entry.number * per_cell + a;
      const auto [it, is_new] =
          point_of.try_emplace(entry.cells->node[at], static_cast<int>(mesh_.points.size()));
      if (is_new) mesh_.points.push_back(entry.cells->place[at]);
      points[a] = it->second;
    }
    add_hexahedra(points, n, mesh_.cells);
  }
  for (const Cells& cells : processes) {
    point_of_.emplace_back();
    for (const auto node : cells.distinct) point_of_.back().push_back(point_of.at(node));
  }
}

/// The other half, y -> -y. Points on the plane are shared.
void BodyNodes::mirror() {
  const std::size_t count = mesh_.points.size();
  std::vector<int> image(count);
  for (std::size_t p = 0; p < count; ++p) {
    const Place x = mesh_.points[p];
    image[p] = static_cast<int>(p);
    if (std::abs(x[1]) < 1e-9) continue;
    image[p] = static_cast<int>(mesh_.points.size());
    mirrored_.push_back(static_cast<int>(p));
    mesh_.points.push_back({x[0], -x[1], x[2]});
  }
  // Exchanging the corners along the second axis keeps the mirrored cells right-handed.
  constexpr std::array<int, 8> corner{3, 2, 1, 0, 7, 6, 5, 4};
  const std::size_t cells = mesh_.cells.size();
  for (std::size_t c = 0; c < cells; ++c) {
    std::array<int, 8> mirrored_cell{};
    for (int k = 0; k < 8; ++k) mirrored_cell[k] = image[mesh_.cells[c][corner[k]]];
    mesh_.cells.push_back(mirrored_cell);
  }
}

BodyNodes::BodyNodes(const Body& body, const std::string& name) : body_(body) {
  mesh_.name = name;
  const MPI_Comm communicator = body.dofs().get_communicator();
  const auto processes = dealii::Utilities::MPI::gather(communicator, collect_cells(), 0);
  if (dealii::Utilities::MPI::this_mpi_process(communicator) != 0) return;
  number(processes);
  if (body.options().half) mirror();
}

template <std::size_t N>
std::vector<std::array<float, N>> BodyNodes::gathered(
    const std::array<const Vector*, N / 3>& fields) const {
  std::vector<std::array<float, N>> own(nodes_.size()), all(mesh_.points.size());
  for (std::size_t k = 0; k < own.size(); ++k)
    for (std::size_t c = 0; c < N; ++c)
      own[k][c] = static_cast<float>((*fields[c / 3])(nodes_[k][c % 3]));
  const auto processes = dealii::Utilities::MPI::gather(body_.dofs().get_communicator(), own, 0);
  for (std::size_t process = 0; process < point_of_.size(); ++process)
    for (std::size_t k = 0; k < point_of_[process].size(); ++k)
      all[point_of_[process][k]] = processes[process][k];
  // u_y, xy and yz change sign; on the plane they vanish.
  std::size_t image = mesh_.points.size() - mirrored_.size();
  for (const int p : mirrored_) {
    all[image] = all[p];
    for (const std::size_t c : N == 3 ? std::array{1, 1} : std::array{3, 4})
      all[image][c] = -all[p][c];
    ++image;
  }
  return all;
}

contact::BodyValues BodyNodes::values(const Vector& displacement, const NodalStress& stress,
                                      const YieldedFields* yielded) const {
  contact::BodyValues result;
  result.displacement = gathered<3>({&displacement});
  result.stress = gathered<6>({&stress.direct, &stress.shear});
  if (yielded == nullptr) return result;
  result.plastic_strain = gathered<6>({&yielded->strain.direct, &yielded->strain.shear});
  result.residual_stress = gathered<6>({&yielded->residual.direct, &yielded->residual.shear});
  for (const auto& v : gathered<3>({&yielded->accumulated})) result.accumulated.push_back(v[0]);
  return result;
}

}  // namespace rollfem::fem
