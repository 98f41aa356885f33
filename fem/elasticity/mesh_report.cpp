// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/elasticity/mesh_report.hpp"

#include "fem/discretisation/case_bodies.hpp"
#include "fem/linear/solver_choice.hpp"
#include "fem/mesh/coarse_mesh.hpp"
#include "fem/mesh/run_layout.hpp"
#include "meshes/hex_mesh.hpp"
#include "meshes/msh_file.hpp"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <map>

namespace rollfem::fem {

namespace {

using Corners = std::array<std::array<double, 3>, 8>;

/// Corners of the active cells of this process, in VTK's order.
std::vector<Corners> own_cells(const Body& body) {
  constexpr std::array<unsigned int, 8> vtk{0, 1, 3, 2, 4, 5, 7, 6};
  std::vector<Corners> cells;
  for (const auto& cell : body.dofs().active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    Corners corners{};
    for (unsigned int k = 0; k < 8; ++k)
      for (unsigned int d = 0; d < 3; ++d) corners[vtk[k]][d] = cell->vertex(k)[d];
    cells.push_back(corners);
  }
  return cells;
}

double size_in_patch(const Body& body) {
  const BodyOptions& options = body.options();
  double size = 0.0;
  for (const auto& cell : body.dofs().active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    for (const auto& face : cell->face_iterators()) {
      if (!face->at_boundary() || face->boundary_id() != contact_surface) continue;
      const auto box = chart_box(body.shape(), face);
      const double middle[2] = {0.5 * (box.lower[0] + box.upper[0]),
                                0.5 * (box.lower[1] + box.upper[1]) - options.middle};
      if (std::abs(middle[0]) > options.fine_half_length ||
          std::abs(middle[1]) > options.fine_half_width)
        continue;
      for (unsigned int d = 0; d < 2; ++d) size = std::max(size, box.upper[d] - box.lower[d]);
    }
  }
  return dealii::Utilities::MPI::max(size, body.dofs().get_communicator());
}

void judge(const std::vector<Corners>& cells, MeshedBody& result) {
  result.cells = static_cast<long>(cells.size());
  bool first = true;
  for (const Corners& corners : cells) {
    const meshes::CellQuality quality = meshes::cell_quality(corners);
    result.shortest_edge =
        first ? quality.shortest_edge : std::min(result.shortest_edge, quality.shortest_edge);
    first = false;
    result.longest_edge = std::max(result.longest_edge, quality.longest_edge);
    result.smallest_scaled_jacobian =
        std::min(result.smallest_scaled_jacobian, quality.scaled_jacobian);
    result.largest_aspect_ratio = std::max(result.largest_aspect_ratio, quality.aspect_ratio);
  }
}

contact::BodyField field_of(const std::vector<Corners>& cells, const std::string& name) {
  contact::BodyField field;
  field.name = name;
  std::map<std::array<double, 3>, int> number;
  for (const Corners& corners : cells) {
    std::array<int, 8> cell{};
    for (int k = 0; k < 8; ++k) {
      const auto [it, is_new] =
          number.try_emplace(corners[k], static_cast<int>(field.points.size()));
      if (is_new) field.points.push_back(corners[k]);
      cell[k] = it->second;
    }
    field.cells.push_back(cell);
  }
  return field;
}

MeshedBody report(const Body& body, const std::string& name) {
  MeshedBody result;
  result.name = name;
  const meshes::HexMesh coarse = hex_mesh(body.triangulation());
  result.coarse_cells = static_cast<long>(coarse.cells.size());
  result.unknowns = static_cast<long>(body.unknowns());
  result.levels = static_cast<int>(body.triangulation().n_global_levels()) - 1;
  result.size_in_patch = size_in_patch(body);
  const MPI_Comm communicator = body.dofs().get_communicator();
  const auto processes = dealii::Utilities::MPI::gather(communicator, own_cells(body), 0);
  if (dealii::Utilities::MPI::this_mpi_process(communicator) != 0) return result;
  std::vector<Corners> cells;
  for (const auto& part : processes) cells.insert(cells.end(), part.begin(), part.end());
  judge(cells, result);
  result.msh = meshes::msh_text(coarse);
  result.refined = field_of(cells, name);
  return result;
}

}  // namespace

std::vector<MeshedBody> mesh_case(const contact::Scene& scene) {
  const double cell = default_cell_size(scene);
  refuse_beyond_memory(scene, cell);
  const CaseBodies bodies = make_bodies(scene, run_layout(scene, cell).bodies, MPI_COMM_WORLD);
  std::vector<MeshedBody> reports;
  for (std::size_t k = 0; k < 2; ++k)
    if (const Body* body = bodies.both()[k]) reports.push_back(report(*body, body_names[k]));
  return reports;
}

}  // namespace rollfem::fem
