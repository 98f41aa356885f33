// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/elasticity/few_elements.hpp"

#include "contact/iteration/leading_edge.hpp"

#include <cstdlib>

namespace rollfem::halfspace {

using contact::Field;

namespace {

/// contact::upwind_weights behind the leading element.
constexpr double usual_weight = 0.5;

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

/// The Jacobian of a single row of elements.
void FewElementsRolling::fill_block(const Row& row, const contact::Linearisation& at, double r,
                                    double drag) {
  const Index length = row.length;
  block_.resize(2 * length, 2 * length);
  for (Index k = 0; k < length; ++k) {
    const Index e = row.first + k, f = count_ + e;
    auto x = block_.row(k);
    auto y = block_.row(length + k);
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
    fill_block(rows_[k], at, r, drag);
    rows_[k].factors.compute(block_);
  }
}

void FewElementsRolling::precondition(const Given& p, Vector result) {
  BlockVector right, solution;
  for (std::size_t k = 0; k < rows_in_use_; ++k) {
    const Row& row = rows_[k];
    right.resize(2 * row.length);
    right.head(row.length) = p.segment(row.first, row.length);
    right.tail(row.length) = p.segment(count_ + row.first, row.length);
    solution = row.factors.solve(right);
    result.segment(row.first, row.length) = solution.head(row.length);
    result.segment(count_ + row.first, row.length) = solution.tail(row.length);
  }
}

}  // namespace rollfem::halfspace
