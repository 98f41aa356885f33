// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/elasticity/few_elements.hpp"

#include "base/pi.hpp"
#include "contact/iteration/leading_edge.hpp"
#include "halfspace/elasticity/neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace rollfem::halfspace {

using contact::ContactGrid;
using contact::Field;

namespace {

/// contact::upwind_weights behind the leading element.
constexpr double usual_weight = 0.5;

int points_over(int elements) {
  return elements / 2;
}

std::size_t points_of(const ContactGrid& grid) {
  return static_cast<std::size_t>(points_over(grid.nx)) *
         static_cast<std::size_t>(points_over(grid.ny));
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

FewElementsRolling::FewElementsRolling(int nx, int ny, int most_elements)
    : nx_(nx),
      ny_(ny),
      most_(most_elements),
      matrix_(2 * most_elements, 2 * most_elements),
      rows_(static_cast<std::size_t>(ny)) {
  places_.reserve(static_cast<std::size_t>(most_elements));
}

bool FewElementsRolling::set(const InfluenceTable& table, const Field& pressure,
                             const Field& weights, double layer) {
  diagonal_ = table.diagonal + (1.0 + usual_weight) * layer;
  if (!gather(pressure)) return false;
  fill_matrix(table, weights);
  if (layer > 0.0) add_layer(layer, weights);
  return true;
}

bool FewElementsRolling::gather(const Field& pressure) {
  places_.clear();
  rows_in_use_ = 0;
  count_ = 0;
  for (int j = 0; j < ny_; ++j) {
    const Index first = count_;
    for (int i = 0; i < nx_; ++i) {
      if (!(pressure[j * nx_ + i] > 0.0)) continue;
      if (count_++ == most_) return false;
      places_.push_back(j * nx_ + i);
    }
    if (count_ == first) continue;
    if (count_ - first > most_in_row) return false;
    Row& row = rows_[rows_in_use_++];
    row.first = first;
    row.length = count_ - first;
    row.kept_for = 0.0;
  }
  return count_ > 0;
}

/// D u at an element is (1 + w) d - w d', d' the difference of the next element upstream.
void FewElementsRolling::fill_matrix(const InfluenceTable& table, const Field& weights) {
  for (Index a = 0; a < count_; ++a) {
    const Index place = places_[static_cast<std::size_t>(a)], i = place % nx_;
    const double here = 1.0 + weights[place], ahead = -weights[place];
    double* along = &matrix_(a, 0);
    double* across = &matrix_(count_ + a, 0);
    for (std::size_t k = 0; k < rows_in_use_; ++k) {
      const Row& row = rows_[k];
      const auto rows =
          static_cast<int>(place / nx_ - places_[static_cast<std::size_t>(row.first)] / nx_);
      const double sign = rows < 0 ? -1.0 : 1.0;
      const double* xx = table.row(table.xx, std::abs(rows)) + i;
      const double* yy = table.row(table.yy, std::abs(rows)) + i;
      const double* xy = table.row(table.xy, std::abs(rows)) + i;
      for (Index b = row.first; b < row.first + row.length; ++b) {
        const Index at = -(places_[static_cast<std::size_t>(b)] % nx_);
        along[b] = here * xx[at] + ahead * xx[at + 1];
        across[count_ + b] = here * yy[at] + ahead * yy[at + 1];
        along[count_ + b] = across[b] = sign * (here * xy[at] + ahead * xy[at + 1]);
      }
    }
  }
}

/// D of the tractions, because the layer moves an element by its own traction alone.
void FewElementsRolling::add_layer(double layer, const Field& weights) {
  for (Index a = 0; a < count_; ++a) {
    const Index place = places_[static_cast<std::size_t>(a)];
    const double given = weights[place];
    const double w = given == usual_weight ? given : contact::layer_weight(given);
    const double share[] = {1.0 + w, -1.0 - 2.0 * w, w};
    for (Index k = 0; k < 3 && a + k < count_; ++k) {
      const Index upstream = places_[static_cast<std::size_t>(a + k)];
      if (upstream / nx_ != place / nx_ || upstream - place > 2) break;
      for (const Index component : {a, count_ + a})
        matrix_(component, component + k) += layer * share[upstream - place];
    }
  }
}

void FewElementsRolling::apply(const Given& p, Vector result) {
  element_sums().multiply(matrix_.data(), matrix_.cols(), 2 * count_, 2 * count_, p.data(),
                          result.data());
}

void FewElementsRolling::central_slip(const InfluenceTable& table, const Given& p,
                                      Vector result) const {
  for (Index a = 0; a < count_; ++a) {
    const Index at = places_[static_cast<std::size_t>(a)];
    double along = 0.0, across = 0.0;
    for (Index b = 0; b < count_; ++b) {
      const Index from = places_[static_cast<std::size_t>(b)];
      const auto rows = static_cast<int>(at / nx_ - from / nx_);
      const auto mean = [&](const std::vector<double>& list) {
        const double* behind = table.row(list, std::abs(rows)) + at % nx_ - from % nx_;
        return 0.5 * (behind[0] + behind[-1]);
      };
      const double sideways = rows < 0 ? -mean(table.xy) : mean(table.xy);
      along += mean(table.xx) * p[b] + sideways * p[count_ + b];
      across += sideways * p[b] + mean(table.yy) * p[count_ + b];
    }
    result[a] = along;
    result[count_ + a] = across;
  }
}

/// The Jacobian of a single row of elements.
void FewElementsRolling::fill_jacobian(const Row& row, Block& to, const contact::Linearisation& at,
                                       double r, double drag) const {
  const Index length = row.length;
  for (Index k = 0; k < length; ++k) {
    const Index e = row.first + k, f = count_ + e;
    auto x = to.row(k).head(2 * length);
    auto y = to.row(length + k).head(2 * length);
    for (const Index half : {Index(0), Index(1)}) {
      const Index source = half * count_ + row.first;
      x.segment(half * length, length) = r * matrix_.row(e).segment(source, length);
      y.segment(half * length, length) = r * matrix_.row(f).segment(source, length);
    }
    x[k] += drag;
    y[length + k] += drag;
    if (at.adheres[static_cast<std::size_t>(e)]) continue;
    x[k] -= 1.0;
    y[length + k] -= 1.0;
    for (Index c = 0; c < 2 * length; ++c) {
      const double dx = x[c], dy = y[c], along = at.normal[e] * dx + at.normal[f] * dy;
      x[c] = at.factor[e] * (dx - along * at.left[e]);
      y[c] = at.factor[e] * (dy - along * at.left[f]);
    }
    x[k] += 1.0;
    y[length + k] += 1.0;
  }
}

void FewElementsRolling::linearise(const contact::Linearisation& at, double r, double drag) {
  for (std::size_t k = 0; k < rows_in_use_; ++k) {
    Row& row = rows_[k];
    const auto first = at.adheres.begin() + row.first;
    row.adheres = drag == 0.0 && std::count(first, first + row.length, 0) == 0;
    if (row.adheres && std::exchange(row.kept_for, r) == r) continue;
    Block& to = row.adheres ? row.adhering : row.inverse;
    fill_jacobian(row, to, at, r, drag);
    element_sums().invert(to.data(), to.cols(), 2 * row.length);
  }
}

void FewElementsRolling::precondition(const Given& p, Vector result) {
  Eigen::Matrix<double, 2 * most_in_row, 1> right, solution;
  for (std::size_t k = 0; k < rows_in_use_; ++k) {
    const Row& row = rows_[k];
    right.head(row.length) = p.segment(row.first, row.length);
    right.segment(row.length, row.length) = p.segment(count_ + row.first, row.length);
    element_sums().multiply(row.used().data(), Block::ColsAtCompileTime, 2 * row.length,
                            2 * row.length, right.data(), solution.data());
    result.segment(row.first, row.length) = solution.head(row.length);
    result.segment(count_ + row.first, row.length) = solution.segment(row.length, row.length);
  }
}

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
      double* at = loads.data() + (row.before * across + column.before);
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
      const double* at = at_points.data() + (row.before * across + column.before);
      const double before = (1.0 - column.behind) * at[0] + column.behind * at[1];
      const double behind = (1.0 - column.behind) * at[across] + column.behind * at[across + 1];
      displacement[grid.index(i, j)] +=
          ((1.0 - row.behind) * before + row.behind * behind) / block.carried[j];
    }
  }
}

}  // namespace rollfem::halfspace
