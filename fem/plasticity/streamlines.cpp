// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/plasticity/streamlines.hpp"

#include "base/errors.hpp"
#include "base/threads.hpp"
#include "fem/discretisation/elastic_problem.hpp"
#include "fem/mesh/surface_shape.hpp"
#include "fem/plasticity/cell_shape.hpp"

#include <Eigen/QR>
#include <deal.II/base/mpi.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rollfem::fem {

namespace {

/// Of Gauss' rule with two points on [0, 1].
const std::array<double, 2> gauss_places{0.5 - 0.5 / std::sqrt(3.0), 0.5 + 0.5 / std::sqrt(3.0)};

using SpaceTensor = dealii::Tensor<2, 3>;

Deviator deviator_of(const SpaceTensor& gradient) {
  const double mean = dealii::trace(gradient) / 3.0;
  return {gradient[0][0] - mean,
          gradient[1][1] - mean,
          gradient[2][2] - mean,
          0.5 * (gradient[0][1] + gradient[1][0]),
          0.5 * (gradient[1][2] + gradient[2][1]),
          0.5 * (gradient[0][2] + gradient[2][0])};
}

/// Where the plastic strain of a slot comes from.
enum class Source : unsigned char { point, inflow, outflow };

/// A point of a streamline in a cell.
struct Slot {
  std::size_t from;  ///< number of the point or of the stream
  Source source;
  double weight;  ///< mm^3
  double sine;    ///< of the angle about the axle
  dealii::Point<3> unit;
  double depth;  ///< mm

  /// A quantity there, of its points or of the states at the ends.
  template <class Quantity>
  const Quantity& of(const std::vector<Quantity>& points, const std::vector<PlasticState>& inflow,
                     const std::vector<PlasticState>& outflow,
                     Quantity PlasticState::*of_ends) const {
    return source == Source::point ? points[from]
                                   : (source == Source::inflow ? inflow : outflow)[from].*of_ends;
  }
};

struct PlasticCell {
  std::vector<dealii::types::global_dof_index> dofs;
  std::size_t first_slot, end_slot;
};

}  // namespace

struct Streamlines::Implementation {
  Implementation(const Body& the_body, const StreamLattice& the_lattice)
      : body(the_body),
        lattice(the_lattice),
        shape(the_body),
        manifold(surface_manifold(the_body.shape())),
        hanging(make_constraints(the_body.dofs(), the_body.mapping(), {})) {
    volumes.assign(lattice.points(), 0.0);
    for (const auto& cell : body.dofs().active_cell_iterators())
      if (cell->is_locally_owned()) add(cell);
    check_coverage();
  }

  /// Numbers of the lattice's points between two places, first and end.
  std::array<std::size_t, 2> between(double lower, double upper, int first,
                                     std::size_t count) const {
    const auto number = [&](double place) {
      const double about = std::floor(2.0 * (place / lattice.cell - first)) - 1.0;
      auto k = static_cast<std::size_t>(std::clamp(about, 0.0, static_cast<double>(count)));
      while (k < count && lattice.place(first, k) < place) ++k;
      return k;
    };
    const double tiny = 1e-6 * lattice.cell;
    return {number(lower - tiny), number(upper + tiny)};
  }

  void add(const dealii::DoFHandler<3>::active_cell_iterator& cell) {
    const ChartBox box = chart_box(body.shape(), cell);
    const auto across = between(box.lower[1], box.upper[1], lattice.across[0], lattice.width());
    const auto down = between(lattice.rows.even(box.lower[2]), lattice.rows.even(box.upper[2]), 0,
                              2 * static_cast<std::size_t>(lattice.down));
    if (across[0] >= across[1] || down[0] >= down[1]) return;
    shape.reinit(cell);
    const double rear = lattice.along[0] * lattice.cell, front = lattice.along[1] * lattice.cell;
    const auto along = between(box.lower[0], box.upper[0], lattice.along[0], lattice.stations());
    const std::size_t first = slots.size();
    for (std::size_t k = down[0]; k < down[1]; ++k)
      for (std::size_t j = across[0]; j < across[1]; ++j) {
        const std::size_t stream = k * lattice.width() + j;
        for (std::size_t i = along[0]; i < along[1]; ++i) {
          const std::size_t station = lattice.stations() - 1 - i;
          add_slot(lattice.s(station), 0.5 * lattice.cell, stream, Source::point,
                   stream * lattice.stations() + station);
        }
        add_piece(std::max(front, box.lower[0]), box.upper[0], stream, Source::inflow);
        add_piece(box.lower[0], std::min(rear, box.upper[0]), stream, Source::outflow);
      }
    if (slots.size() == first) return;
    PlasticCell added{{}, first, slots.size()};
    added.dofs.resize(body.dofs().get_fe().dofs_per_cell);
    cell->get_dof_indices(added.dofs);
    cells.push_back(std::move(added));
  }

  /// A piece of a streamline outside the box.
  void add_piece(double lower, double upper, std::size_t stream, Source source) {
    const double length = upper - lower;
    if (!(length > 1e-6 * lattice.cell)) return;
    for (const double place : gauss_places)
      add_slot(lower + place * length, 0.5 * length, stream, source, stream);
  }

  void add_slot(double s, double length, std::size_t stream, Source source, std::size_t from) {
    const SurfaceShape& surface = body.shape();
    const auto [t, depth] = lattice.section(stream);
    const dealii::Point<3> chart(s, t, depth);
    const auto unit = shape.inside(surface.place(chart[0], chart[1], chart[2]));
    if (!unit || (source == Source::point && volumes[from] != 0.0)) return;
    const auto map = manifold.push_forward_gradient(chart);
    const double stretch = std::abs(dealii::determinant(dealii::Tensor<2, 3>(map)));
    const double height = lattice.cell * lattice.rows.stretch(lattice.rows.even(depth));
    const double volume = 0.25 * height * lattice.cell * length * stretch;
    if (source == Source::point) volumes[from] = volume;
    const double sine = sine_at(s, chart[1]);
    slots.push_back({from, source, volume, sine, *unit, chart[2]});
    gradients.resize(slots.size() * shape.nodes());
    shape.gradients(*unit, &gradients[(slots.size() - 1) * shape.nodes()]);
  }

  double sine_at(double s, double t) const {
    const SurfaceShape& surface = body.shape();
    return surface.is_revolved() ? std::sin(s / surface.streamline_radius(t)) : 0.0;
  }

  void check_coverage() {
    dealii::Utilities::MPI::sum(volumes, body.dofs().get_communicator(), volumes);
    const auto missing = std::find(volumes.begin(), volumes.end(), 0.0);
    if (missing == volumes.end()) return;
    const auto k = static_cast<std::size_t>(missing - volumes.begin());
    const auto [t, depth] = lattice.section(k / lattice.stations());
    throw contact::InputError(fmt::format(
        "the {} yields on streamlines that leave its mesh: no cell contains s = {:.4g}, y = {:.4g} "
        "mm, {:.4g} mm below the surface; do: give a larger [fem] extent",
        body.shape().is_wheel ? "wheel" : "rail", lattice.s(k % lattice.stations()), t, depth));
  }

  /// Turns components of the section into space at this sine of the angle about
  /// the axle: columns are its x, y, z.
  SpaceTensor turn(double sine) const {
    SpaceTensor t = dealii::unit_symmetric_tensor<3>();
    if (sine == 0.0) return t;
    const meshes::AxleTrace axle = body.shape().axle();
    const double cosine = std::sqrt(1.0 - sine * sine);
    const double less = 1.0 - cosine, c = axle.cosine, d = axle.sine;
    // About (0, c, d), which turns x towards the axle (0, -d, c).
    t[0][0] = cosine;
    t[1][0] = -d * sine;
    t[2][0] = c * sine;
    t[0][1] = d * sine;
    t[0][2] = -c * sine;
    t[1][1] = 1.0 - less * d * d;
    t[2][2] = 1.0 - less * c * c;
    t[1][2] = t[2][1] = less * c * d;
    return t;
  }

  const Body& body;
  const StreamLattice& lattice;  ///< of the streamlines
  CellShape shape;
  MeansInChart manifold;
  dealii::AffineConstraints<double> hanging;
  std::vector<double> volumes;
  std::vector<PlasticCell> cells;
  std::vector<Slot> slots;
  std::vector<dealii::Tensor<1, 3>> gradients;  ///< of the nodes, for every slot
};

double StreamLattice::place(int first, std::size_t point) const {
  const std::size_t further = point / 2;
  return (first + static_cast<double>(further) + gauss_places[point % 2]) * cell;
}

Streamlines::Streamlines(const Body& body, const StreamLattice& lattice)
    : StreamLattice(lattice), implementation_(std::make_unique<Implementation>(body, *this)) {}

Streamlines::~Streamlines() = default;

std::vector<dealii::types::global_dof_index> Streamlines::unknowns() const {
  std::vector<dealii::types::global_dof_index> all;
  for (const PlasticCell& cell : implementation_->cells)
    all.insert(all.end(), cell.dofs.begin(), cell.dofs.end());
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

MPI_Comm Streamlines::communicator() const {
  return implementation_->body.dofs().get_communicator();
}

double Streamlines::volume(std::size_t k) const {
  return implementation_->volumes[k];
}

std::vector<Deviator> Streamlines::strains(const Vector& displacement) const {
  const Implementation& of = *implementation_;
  const unsigned int nodes = of.shape.nodes();
  const auto& element = of.body.dofs().get_fe();
  std::vector<Deviator> result(points(), Deviator{});
  contact::for_each_piece(
      static_cast<std::ptrdiff_t>(of.cells.size()), 64,
      [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
        std::vector<dealii::Tensor<1, 3>> u(nodes);
        for (std::ptrdiff_t c = begin; c < end; ++c) {
          const PlasticCell& cell = of.cells[c];
          for (unsigned int a = 0; a < nodes; ++a)
            for (unsigned int d = 0; d < 3; ++d)
              u[a][d] = displacement(cell.dofs[element.component_to_system_index(d, a)]);
          for (std::size_t k = cell.first_slot; k < cell.end_slot; ++k) {
            const Slot& slot = of.slots[k];
            if (slot.source != Source::point) continue;
            const auto* gradient = &of.gradients[k * nodes];
            SpaceTensor sum;
            for (unsigned int a = 0; a < nodes; ++a)
              for (unsigned int d = 0; d < 3; ++d) sum[d] += u[a][d] * gradient[a];
            if (slot.sine != 0.0) {
              const SpaceTensor turn = of.turn(slot.sine);
              sum = dealii::transpose(turn) * sum * turn;
            }
            result[slot.from] = deviator_of(sum);
          }
        }
      });
  const MPI_Comm communicator = of.body.dofs().get_communicator();
  if (dealii::Utilities::MPI::n_mpi_processes(communicator) > 1) {
    const dealii::ArrayView<double> flat(result.data()->data(), 6 * result.size());
    dealii::Utilities::MPI::sum(dealii::ArrayView<const double>(flat), communicator, flat);
  }
  return result;
}

void Streamlines::load(const std::vector<Deviator>& plastic,
                       const std::vector<PlasticState>& inflow,
                       const std::vector<PlasticState>& outflow, Vector& b) const {
  const Implementation& of = *implementation_;
  const unsigned int nodes = of.shape.nodes();
  const auto& element = of.body.dofs().get_fe();
  const double twice_g = 2.0 * lame_mu(of.body.material());
  std::vector<double> forces(3 * nodes * of.cells.size(), 0.0);
  contact::for_each_piece(
      static_cast<std::ptrdiff_t>(of.cells.size()), 64,
      [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
        for (std::ptrdiff_t c = begin; c < end; ++c) {
          double* const force = &forces[3 * nodes * c];
          for (std::size_t k = of.cells[c].first_slot; k < of.cells[c].end_slot; ++k) {
            const Slot& slot = of.slots[k];
            SpaceTensor stress =
                tensor_of(slot.of(plastic, inflow, outflow, &PlasticState::strain));
            stress *= twice_g * slot.weight;
            if (slot.sine != 0.0) {
              const SpaceTensor turn = of.turn(slot.sine);
              stress = turn * stress * dealii::transpose(turn);
            }
            const auto* gradient = &of.gradients[k * nodes];
            for (unsigned int a = 0; a < nodes; ++a)
              for (unsigned int d = 0; d < 3; ++d) force[3 * a + d] += stress[d] * gradient[a];
          }
        }
      });
  b = 0.0;
  b.zero_out_ghost_values();
  for (std::size_t c = 0; c < of.cells.size(); ++c)
    for (unsigned int a = 0; a < nodes; ++a)
      for (unsigned int d = 0; d < 3; ++d)
        b(of.cells[c].dofs[element.component_to_system_index(d, a)]) +=
            forces[3 * (nodes * c + a) + d];
  b.compress(dealii::VectorOperation::add);
}

contact::SymmetricTensor Streamlines::in_section(const contact::SymmetricTensor& stress,
                                                 std::size_t station, std::size_t stream) const {
  const Implementation& of = *implementation_;
  const SpaceTensor turn = of.turn(of.sine_at(s(station), section(stream)[0]));
  return components_of(dealii::transpose(turn) * tensor_of(stress) * turn);
}

namespace {

/// Of a linear function of unit coordinates.
Eigen::Matrix<double, 1, 4> linear_terms(const dealii::Point<3>& unit) {
  return {1.0, unit[0] - 0.5, unit[1] - 0.5, unit[2] - 0.5};
}

}  // namespace

YieldedFields Streamlines::at_nodes(
    const std::vector<Deviator>& plastic, const std::vector<double>& accumulated,
    const std::vector<PlasticState>& inflow, const std::vector<PlasticState>& outflow,
    const std::function<std::array<double, 2>(double)>& before) const {
  const Implementation& of = *implementation_;
  const auto& dofs = of.body.dofs();
  const auto& element = dofs.get_fe();
  const auto& nodes = element.base_element(0).get_unit_support_points();
  const double twice_g = 2.0 * lame_mu(of.body.material());
  YieldedFields sum;
  Vector count = make_vector(dofs);
  const std::array<Vector*, 5> fields{&sum.excess.direct, &sum.excess.shear, &sum.strain.direct,
                                      &sum.strain.shear, &sum.accumulated};
  for (Vector* vector : fields) *vector = make_vector(dofs);
  for (const PlasticCell& cell : of.cells) {
    const auto size = static_cast<Eigen::Index>(cell.end_slot - cell.first_slot);
    Eigen::MatrixXd terms(size, 4), values = Eigen::MatrixXd::Zero(size, 3 * fields.size());
    for (Eigen::Index k = 0; k < size; ++k) {
      const Slot& slot = of.slots[cell.first_slot + k];
      const Deviator& strain = slot.of(plastic, inflow, outflow, &PlasticState::strain);
      const auto residual = before(slot.depth);
      const SpaceTensor turn = of.turn(slot.sine);
      const auto in_space = [&](const Deviator& tensor) {
        const auto turned = components_of(turn * tensor_of(tensor) * dealii::transpose(turn));
        return Eigen::Map<const Eigen::Matrix<double, 1, 6>>(turned.data()).eval();
      };
      terms.row(k) = linear_terms(slot.unit);
      values.row(k).segment<6>(6) = in_space(strain);
      values.row(k).head<6>() =
          twice_g * values.row(k).segment<6>(6) - in_space({residual[0], residual[1]});
      values(k, 12) = slot.of(accumulated, inflow, outflow, &PlasticState::accumulated);
    }
    const Eigen::MatrixXd fit = terms.completeOrthogonalDecomposition().solve(values);
    for (unsigned int a = 0; a < nodes.size(); ++a) {
      const Eigen::RowVectorXd at_node = linear_terms(nodes[a]) * fit;
      for (unsigned int c = 0; c < 3; ++c) {
        const auto dof = cell.dofs[element.component_to_system_index(c, a)];
        for (std::size_t f = 0; f < fields.size(); ++f) (*fields[f])(dof) += at_node[3 * f + c];
        count(dof) += 1.0;
      }
    }
  }
  count.compress(dealii::VectorOperation::add);
  for (Vector* vector : fields) {
    vector->compress(dealii::VectorOperation::add);
    for (unsigned int k = 0; k < count.locally_owned_size(); ++k)
      if (count.local_element(k) > 0.0) vector->local_element(k) /= count.local_element(k);
    of.hanging.distribute(*vector);
    vector->update_ghost_values();
  }
  return sum;
}

}  // namespace rollfem::fem
