// Displacement and recovered stress of a body as plain arrays for output.
#include "fem/cell_terms.hpp"
#include "fem/compliance.hpp"

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_tools.h>
#include <deal.II/fe/fe_values.h>

#include <cmath>
#include <unordered_map>

namespace rollfem::fem {

namespace {

/// What one process knows: per cell (degree + 1)^3 nodes in lexicographic order, each with the
/// number of its x unknown (which names the node), place, displacement, stress extrapolated in that
/// cell.
struct CellNodes {
  std::vector<dealii::types::global_dof_index> node;
  std::vector<std::array<double, 12>> values;

  template <class Archive>
  void serialize(Archive& archive, unsigned int /*version*/) {
    archive& node& values;
  }
};

/// Lagrange polynomials through the Gauss points, at the element's nodes: nodes x Gauss points. The
/// stress of a Q_p element is most accurate at p^3 Gauss points (Barlow 1976).
std::vector<std::vector<double>> extrapolation(const dealii::Quadrature<1>& gauss,
                                               const std::vector<dealii::Point<3>>& nodes) {
  const unsigned int n = gauss.size();
  const auto lagrange = [&](unsigned int k, double x) {
    double value = 1.0;
    for (unsigned int m = 0; m < n; ++m)
      if (m != k) value *= (x - gauss.point(m)[0]) / (gauss.point(k)[0] - gauss.point(m)[0]);
    return value;
  };
  std::vector<std::vector<double>> weights(nodes.size(), std::vector<double>(n * n * n));
  for (std::size_t a = 0; a < nodes.size(); ++a)
    for (unsigned int q = 0; q < n * n * n; ++q)
      weights[a][q] = lagrange(q % n, nodes[a][0]) * lagrange(q / n % n, nodes[a][1]) *
                      lagrange(q / (n * n), nodes[a][2]);
  return weights;
}

CellNodes collect(const Body& body, const Vector& displacement) {
  const auto& element = body.dofs().get_fe();
  const unsigned int degree = element.degree;
  const unsigned int nodes = element.dofs_per_cell / 3;
  // Hierarchic place of every lexicographic node.
  const auto order = dealii::FETools::lexicographic_to_hierarchic_numbering<3>(degree);
  std::vector<std::array<unsigned int, 3>> dof_of(nodes);
  for (unsigned int i = 0; i < element.dofs_per_cell; ++i) {
    const auto [component, node] = element.system_to_component_index(i);
    dof_of[node][component] = i;
  }
  std::vector<dealii::Point<3>> places(nodes);
  for (unsigned int a = 0; a < nodes; ++a)
    places[a] = element.get_unit_support_points()[dof_of[order[a]][0]];
  const auto weights = extrapolation(dealii::QGauss<1>(degree), places);

  dealii::FEValues<3> at_nodes(body.mapping(), element, dealii::Quadrature<3>(places),
                               dealii::update_quadrature_points);
  dealii::FEValues<3> at_gauss(body.mapping(), element, dealii::QGauss<3>(degree),
                               dealii::update_gradients | dealii::update_quadrature_points);
  CellStress cell_stress(body.problem());
  const dealii::FEValuesExtractors::Vector vector(0);
  std::vector<dealii::Tensor<2, 3>> gradients(at_gauss.n_quadrature_points);
  std::vector<dealii::types::global_dof_index> indices(element.dofs_per_cell);
  CellNodes result;
  for (const auto& cell : body.dofs().active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    at_nodes.reinit(cell);
    at_gauss.reinit(cell);
    cell_stress.reinit(cell, displacement);
    at_gauss[vector].get_function_gradients(displacement, gradients);
    cell->get_dof_indices(indices);
    for (unsigned int a = 0; a < nodes; ++a) {
      std::array<double, 12> values{};
      for (unsigned int c = 0; c < 3; ++c) {
        values[c] = at_nodes.quadrature_point(a)[c];
        values[3 + c] = displacement(indices[dof_of[order[a]][c]]);
      }
      for (unsigned int q = 0; q < gradients.size(); ++q) {
        const auto stress = cell_stress.at(gradients[q], at_gauss.quadrature_point(q));
        for (unsigned int k = 0; k < 6; ++k) values[6 + k] += weights[a][q] * stress[k];
      }
      result.node.push_back(indices[dof_of[order[a]][0]]);
      result.values.push_back(values);
    }
  }
  return result;
}

/// Joins the cells of all processes: nodes that cells share become one point, with the mean stress.
void join(const std::vector<CellNodes>& processes, unsigned int degree, contact::BodyField& field) {
  const int n = static_cast<int>(degree) + 1;
  std::unordered_map<dealii::types::global_dof_index, int> point_of;
  std::vector<int> contributions;
  for (const auto& cells : processes)
    for (std::size_t first = 0; first < cells.node.size(); first += n * n * n) {
      std::vector<int> points(n * n * n);
      for (int a = 0; a < n * n * n; ++a) {
        const auto& v = cells.values[first + a];
        const auto [it, is_new] =
            point_of.try_emplace(cells.node[first + a], static_cast<int>(field.points.size()));
        points[a] = it->second;
        if (is_new) {
          field.points.push_back({v[0], v[1], v[2]});
          field.displacement.push_back({v[3], v[4], v[5]});
          field.stress.push_back({});
          contributions.push_back(0);
        }
        for (int k = 0; k < 6; ++k) field.stress[points[a]][k] += v[6 + k];
        ++contributions[points[a]];
      }
      const auto at = [&](int i, int j, int k) { return points[(k * n + j) * n + i]; };
      for (int k = 0; k + 1 < n; ++k)
        for (int j = 0; j + 1 < n; ++j)
          for (int i = 0; i + 1 < n; ++i)
            field.cells.push_back({at(i, j, k), at(i + 1, j, k), at(i + 1, j + 1, k),
                                   at(i, j + 1, k), at(i, j, k + 1), at(i + 1, j, k + 1),
                                   at(i + 1, j + 1, k + 1), at(i, j + 1, k + 1)});
    }
  for (std::size_t p = 0; p < field.points.size(); ++p)
    for (double& stress : field.stress[p]) stress /= contributions[p];
}

/// The other half, y -> -y: u_y, xy and yz change sign. Points on the plane are shared, where the
/// mean with the mirror image makes these vanish.
void mirror(contact::BodyField& field) {
  const std::size_t count = field.points.size();
  std::vector<int> image(count);
  for (std::size_t p = 0; p < count; ++p) {
    const auto x = field.points[p];
    if (std::abs(x[1]) < 1e-9) {
      image[p] = static_cast<int>(p);
      field.stress[p][3] = field.stress[p][4] = 0.0;
      continue;
    }
    image[p] = static_cast<int>(field.points.size());
    const auto u = field.displacement[p];
    const auto s = field.stress[p];
    field.points.push_back({x[0], -x[1], x[2]});
    field.displacement.push_back({u[0], -u[1], u[2]});
    field.stress.push_back({s[0], s[1], s[2], -s[3], -s[4], s[5]});
  }
  // Exchanging the corners along the second axis keeps the mirrored cells right-handed.
  constexpr std::array<int, 8> corner{3, 2, 1, 0, 7, 6, 5, 4};
  const std::size_t cells = field.cells.size();
  for (std::size_t c = 0; c < cells; ++c) {
    std::array<int, 8> mirrored_cell{};
    for (int k = 0; k < 8; ++k) mirrored_cell[k] = image[field.cells[c][corner[k]]];
    field.cells.push_back(mirrored_cell);
  }
}

}  // namespace

contact::BodyField body_field(const Body& body, const Vector& displacement,
                              const std::string& name) {
  const MPI_Comm communicator = body.dofs().get_communicator();
  Vector ghosted(displacement);  // copies come without ghost values: whoever copied it, fetch them
  ghosted.update_ghost_values();
  const auto processes = dealii::Utilities::MPI::gather(communicator, collect(body, ghosted), 0);
  contact::BodyField field;
  field.name = name;
  if (dealii::Utilities::MPI::this_mpi_process(communicator) != 0) return field;
  join(processes, body.dofs().get_fe().degree, field);
  if (body.options().half) mirror(field);
  return field;
}

}  // namespace rollfem::fem
