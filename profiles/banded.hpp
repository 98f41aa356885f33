// SPDX-License-Identifier: LGPL-2.1-or-later
// Symmetric positive definite matrices with a few diagonals, for smoothing along a profile.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

namespace rollfem::profiles {

/// Rows of the lower half, `diagonals` wide: [0] holds the main diagonal, [j] the place j columns
/// to its left; places outside the matrix are not read. The factors L and D of L D L^T replace it.
template <class Number, std::size_t diagonals>
class Banded {
 public:
  using Row = std::array<Number, diagonals>;
  explicit Banded(std::vector<Row> rows) : rows_(std::move(rows)) { factorise(); }

  const std::vector<Row>& rows() const { return rows_; }

  void solve(std::vector<Number>& b) const {
    const std::size_t n = rows_.size();
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t j = 1; j < diagonals && j <= k; ++j) b[k] -= rows_[k][j] * b[k - j];
    for (std::size_t k = 0; k < n; ++k) b[k] /= rows_[k][0];
    for (std::size_t k = n; k-- > 0;)
      for (std::size_t j = 1; j < diagonals && k + j < n; ++j) b[k] -= rows_[k + j][j] * b[k + j];
  }

 private:
  void factorise() {
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      Row scaled{};
      for (std::size_t j = std::min(diagonals - 1, k); j > 0; --j) {
        scaled[j] = rows_[k][j];
        for (std::size_t i = j + 1; i < diagonals && i <= k; ++i)
          scaled[j] -= scaled[i] * rows_[k - j][i - j];
      }
      for (std::size_t j = 1; j < diagonals && j <= k; ++j) {
        rows_[k][j] = scaled[j] / rows_[k - j][0];
        rows_[k][0] -= scaled[j] * rows_[k][j];
      }
    }
  }

  std::vector<Row> rows_;
};

}  // namespace rollfem::profiles
