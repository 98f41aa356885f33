// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/base/pi.hpp"
#include "halfspace/elasticity/few_elements.hpp"
#include "halfspace/elasticity/neighbours.hpp"

#include <algorithm>
#include <cmath>

namespace rollfem::halfspace {

using contact::ContactGrid;
using contact::Field;

namespace {

int points_over(int elements) {
  return elements / 2;
}

std::size_t points_of(const ContactGrid& grid) {
  return static_cast<std::size_t>(points_over(grid.nx) * points_over(grid.ny));
}

/// The points before and behind an element, between which its values are distributed.
struct Between {
  int before;
  double behind;  ///< fraction of the point behind

  Between(int element, int elements) {
    const int intervals = points_over(elements) - 1;
    const double place = static_cast<double>(element) * intervals / (elements - 1);
    before = std::min(static_cast<int>(place), intervals - 1);
    behind = place - before;
  }
};

struct Place {
  double x, y;
};

/// Position on the rolled-out common surface, outward.
Place place_of(const NormalBlock& block, int a, int b) {
  const ContactGrid& grid = block.grid;
  const auto elements_to = [](int point, int elements) {
    return static_cast<double>(point) * (elements - 1) / (points_over(elements) - 1);
  };
  const contact::ContactPlace& place = *block.place;
  return {place.x_track + grid.x_first + elements_to(a, grid.nx) * grid.dx,
          place.way_across + place.outward() * (grid.y_first + elements_to(b, grid.ny) * grid.dy)};
}

}  // namespace

void FewElementsNormal::set(const std::vector<NormalBlock>& blocks) {
  blocks_ = blocks;
  const std::size_t count = blocks.size();
  if (loads_.size() < count) loads_.resize(count);
  if (influences_.size() < count * count) influences_.resize(count * count);
  for (std::size_t to = 0; to < count; ++to)
    for (std::size_t from = 0; from < count; ++from)
      if (to != from) set_influence(to, from);
}

void FewElementsNormal::set_influence(std::size_t to, std::size_t from) {
  const NormalBlock &here = blocks_[to], &there = blocks_[from];
  std::vector<double>& between = influences_[pair_of(to, from)];
  between.clear();
  const double factor = 1.0 / (contact::pi * material_.shear_modulus);
  const CornerChange::Term corner =
      corner_change(contact::turn_between(*here.place, *there.place), material_).nn;
  const double at_edge = material_.shear_modulus / material_.contact_modulus + corner.a;
  for (int b = 0; b < points_over(here.grid.ny); ++b)
    for (int a = 0; a < points_over(here.grid.nx); ++a) {
      const Place at = place_of(here, a, b);
      for (int d = 0; d < points_over(there.grid.ny); ++d)
        for (int c = 0; c < points_over(there.grid.nx); ++c) {
          const Place load = place_of(there, c, d);
          // Grids may overlap where neither has pressure.
          const double least = 0.25 * (there.grid.dx + there.grid.dy);
          const double x = at.x - load.x, y = at.y - load.y;
          const double rho = std::max(least, std::sqrt(x * x + y * y));
          between.push_back(factor * (at_edge + corner.b * x * x / (rho * rho)) / rho);
        }
    }
}

void FewElementsNormal::apply(const Field& forces, Field& displacement) const {
  displacement.setZero(forces.size());
  Eigen::Index first = 0;
  for (std::size_t k = 0; k < blocks_.size(); first += blocks_[k++].grid.size()) {
    add_own(blocks_[k], forces.data() + first, displacement.data() + first);
    if (blocks_.size() > 1) gather(blocks_[k], forces.data() + first, loads_[k]);
  }
  if (blocks_.size() < 2) return;
  first = 0;
  for (std::size_t to = 0; to < blocks_.size(); first += blocks_[to++].grid.size()) {
    const std::size_t points = points_of(blocks_[to].grid);
    at_points_.assign(points, 0.0);
    added_.resize(points);
    for (std::size_t from = 0; from < blocks_.size(); ++from) {
      if (from == to) continue;
      const auto columns = static_cast<std::ptrdiff_t>(loads_[from].size());
      element_sums().multiply(influences_[pair_of(to, from)].data(), columns,
                              static_cast<std::ptrdiff_t>(points), columns, loads_[from].data(),
                              added_.data());
      for (std::size_t k = 0; k < points; ++k) at_points_[k] += added_[k];
    }
    spread(blocks_[to], at_points_, displacement.data() + first);
  }
}

void FewElementsNormal::precondition(const Field& residual, Field& result) const {
  result = residual;
  if (blocks_.size() < 2) return;
  Eigen::Index first = 0;
  for (const NormalBlock& block : blocks_) {
    const ContactGrid& grid = block.grid;
    const double self = *block.table->row(block.table->nn, 0) * grid.dx / grid.element_area();
    for (int j = 0; j < grid.ny; ++j)
      result.segment(first + grid.index(0, j), grid.nx) *=
          block.carried[j] * block.carried[j] / self;
    first += grid.size();
  }
}

void FewElementsNormal::add_own(const NormalBlock& block, const double* forces,
                                double* displacement) const {
  const ContactGrid& grid = block.grid;
  sources_.clear();
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      if (const double force = forces[grid.index(i, j)]; force != 0.0)
        sources_.push_back({i, j, force / block.carried[j]});
  element_sums().convolve(block.table->rows(block.table->nn), sources_.data(),
                          sources_.data() + sources_.size(), grid.nx, grid.ny, displacement);
  for (int j = 0; j < grid.ny; ++j) {
    const double factor = grid.dx / (grid.element_area() * block.carried[j]);
    for (int i = 0; i < grid.nx; ++i) displacement[grid.index(i, j)] *= factor;
  }
}

void FewElementsNormal::gather(const NormalBlock& block, const double* forces,
                               std::vector<double>& loads) {
  const ContactGrid& grid = block.grid;
  const int across = points_over(grid.nx);
  loads.assign(points_of(grid), 0.0);
  for (int j = 0; j < grid.ny; ++j) {
    const Between row(j, grid.ny);
    for (int i = 0; i < grid.nx; ++i) {
      const double force = forces[grid.index(i, j)] / block.carried[j];
      if (force == 0.0) continue;
      const Between column(i, grid.nx);
      double* at = &loads[static_cast<std::size_t>(row.before * across + column.before)];
      at[0] += (1.0 - row.behind) * (1.0 - column.behind) * force;
      at[1] += (1.0 - row.behind) * column.behind * force;
      at[across] += row.behind * (1.0 - column.behind) * force;
      at[across + 1] += row.behind * column.behind * force;
    }
  }
}

void FewElementsNormal::spread(const NormalBlock& block, const std::vector<double>& at_points,
                               double* displacement) {
  const ContactGrid& grid = block.grid;
  const int across = points_over(grid.nx);
  for (int j = 0; j < grid.ny; ++j) {
    const Between row(j, grid.ny);
    for (int i = 0; i < grid.nx; ++i) {
      const Between column(i, grid.nx);
      const double* at = &at_points[static_cast<std::size_t>(row.before * across + column.before)];
      const double before = (1.0 - column.behind) * at[0] + column.behind * at[1];
      const double behind = (1.0 - column.behind) * at[across] + column.behind * at[across + 1];
      displacement[grid.index(i, j)] +=
          ((1.0 - row.behind) * before + row.behind * behind) / block.carried[j];
    }
  }
}

}  // namespace rollfem::halfspace
