// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/discretisation/body_points.hpp"

#include "scene/scene.hpp"

#include <deal.II/base/mpi.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace rollfem::fem {

namespace {

using dealii::Point;
using CellIterator = dealii::DoFHandler<3>::active_cell_iterator;

/// Points closer to a cell than this, in cell lengths, count as inside: rounding of the inverse
/// mapping.
constexpr double rounding = 1e-9;

/// A curved cell bulges beyond its nodes by less than this, in its diameters.
constexpr double bulge = 0.05;

/// Bounding box of a cell, with its number.
using Box = std::pair<dealii::BoundingBox<3>, std::size_t>;

/// A point in reference coordinates of a cell of this process.
struct Found {
  std::size_t cell;
  Point<3> unit;
  Point<3> place;
  double moved;  ///< mm
};

}  // namespace

struct BodyLocator::Implementation {
  explicit Implementation(const Body& the_body) : body(the_body) {
    const auto& element = body.dofs().get_fe();
    const dealii::Quadrature<3> at_nodes(element.base_element(0).get_unit_support_points());
    dealii::FEValues<3> values(body.mapping(), element, at_nodes, dealii::update_quadrature_points);
    for (const auto& cell : body.dofs().active_cell_iterators()) {
      if (!cell->is_locally_owned()) continue;
      values.reinit(cell);
      cells.push_back(cell);
      dealii::BoundingBox<3> box(values.get_quadrature_points());
      box.extend(bulge * cell->diameter());
      boxes.emplace_back(box, boxes.size());
    }
    tree = dealii::pack_rtree(boxes);
  }

  std::optional<Found> in_cell(std::size_t c, const Point<3>& place) const {
    Point<3> unit;
    try {
      unit = body.mapping().transform_real_to_unit_cell(cells[c], place);
    } catch (const dealii::Mapping<3>::ExcTransformationFailed&) {
      return {};  // far outside of a curved cell
    }
    const Point<3> inside = dealii::GeometryInfo<3>::project_to_unit_cell(unit);
    if (inside.distance(unit) < rounding) return Found{c, inside, place, 0.0};
    const Point<3> nearest = body.mapping().transform_unit_to_real_cell(cells[c], inside);
    return Found{c, inside, nearest, nearest.distance(place)};
  }

  /// The nearest cell of this process.
  std::optional<Found> nearest(const Point<3>& place, double reach) const {
    dealii::BoundingBox<3> around({place, place});
    around.extend(reach);
    std::vector<Box> candidates;
    tree.query(boost::geometry::index::intersects(around), std::back_inserter(candidates));
    std::sort(candidates.begin(), candidates.end(),
              [](const Box& one, const Box& other) { return one.second < other.second; });
    std::optional<Found> best;
    for (const auto& [box, c] : candidates) {
      const auto found = in_cell(c, place);
      if (found && found->moved <= reach && (!best || found->moved < best->moved)) best = found;
      if (best && best->moved == 0.0) break;
    }
    return best;
  }

  const Body& body;
  std::vector<CellIterator> cells;
  std::vector<Box> boxes;
  dealii::RTree<Box> tree;
};

BodyLocator::BodyLocator(const Body& body)
    : implementation_(std::make_unique<Implementation>(body)) {}

BodyLocator::~BodyLocator() = default;

BodyPoints BodyLocator::find(const std::vector<Place>& places, double reach) const {
  const Body& body = implementation_->body;
  const MPI_Comm communicator = body.dofs().get_communicator();
  const auto& element = body.dofs().get_fe();
  const auto& base = element.base_element(0);
  const bool half = body.options().half;
  std::vector<std::optional<Found>> found;
  std::vector<double> moved;
  for (const Place& p : places) {
    found.push_back(
        implementation_->nearest(Point<3>(p[0], half ? std::abs(p[1]) : p[1], p[2]), reach));
    moved.push_back(found.back() ? found.back()->moved : contact::infinity);
  }
  BodyPoints points;
  points.body_ = &body;
  points.moved_.resize(places.size());
  dealii::Utilities::MPI::min(moved, communicator, points.moved_);
  // If several processes are equally near, the first one has the point.
  const int here = static_cast<int>(dealii::Utilities::MPI::this_mpi_process(communicator));
  const int nobody = static_cast<int>(dealii::Utilities::MPI::n_mpi_processes(communicator));
  std::vector<int> owner(places.size(), nobody);
  for (std::size_t k = 0; k < places.size(); ++k)
    if (found[k] && moved[k] == points.moved_[k]) owner[k] = here;
  dealii::Utilities::MPI::min(owner, communicator, owner);

  points.cells_.resize(places.size());
  std::vector<double> flat(3 * places.size(), 0.0);
  for (std::size_t k = 0; k < places.size(); ++k) {
    auto& cell = points.cells_[k];
    cell.mirrored = half && places[k][1] < 0.0;
    if (owner[k] != here) continue;
    cell.dofs.resize(element.dofs_per_cell);
    implementation_->cells[found[k]->cell]->get_dof_indices(cell.dofs);
    for (unsigned int a = 0; a < base.dofs_per_cell; ++a)
      cell.shape.push_back(base.shape_value(a, found[k]->unit));
    for (unsigned int d = 0; d < 3; ++d) flat[3 * k + d] = found[k]->place[d];
    if (cell.mirrored) flat[3 * k + 1] = -flat[3 * k + 1];
  }
  dealii::Utilities::MPI::sum(flat, communicator, flat);
  for (std::size_t k = 0; k < places.size(); ++k)
    points.place_.push_back(
        owner[k] == nobody ? places[k] : Place{flat[3 * k], flat[3 * k + 1], flat[3 * k + 2]});
  return points;
}

std::vector<std::array<double, 3>> BodyPoints::values(const Vector& field,
                                                      const std::array<int, 3>& mirror) const {
  const auto& element = body_->dofs().get_fe();
  std::vector<double> flat(3 * size(), 0.0);
  for (std::size_t k = 0; k < size(); ++k) {
    const Cell& cell = cells_[k];
    for (unsigned int a = 0; a < cell.shape.size(); ++a)
      for (unsigned int c = 0; c < 3; ++c)
        flat[3 * k + c] +=
            cell.shape[a] * field(cell.dofs[element.component_to_system_index(c, a)]);
  }
  dealii::Utilities::MPI::sum(flat, body_->dofs().get_communicator(), flat);
  std::vector<std::array<double, 3>> result(size());
  for (std::size_t k = 0; k < size(); ++k)
    for (unsigned int c = 0; c < 3; ++c)
      result[k][c] = (cells_[k].mirrored ? mirror[c] : 1) * flat[3 * k + c];
  return result;
}

}  // namespace rollfem::fem
