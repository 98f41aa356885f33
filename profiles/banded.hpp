// SPDX-License-Identifier: LGPL-2.1-or-later
// Symmetric positive definite matrices with a few diagonals, for smoothing along a profile.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

namespace rollfem::profiles {

template <class Number, std::size_t diagonals>
struct Banded {
  using Row = std::array<Number, diagonals>;
  /// The lower half: [0] holds the main diagonal, [j] the place j columns to its left; places
  /// outside the matrix are not read.
  std::vector<Row> rows;

  /// Puts the factors L and D of L D L^T in place of the matrix.
  void factorise() {
    for (std::size_t k = 0; k < rows.size(); ++k) {
      Row scaled{};
      for (std::size_t j = std::min(diagonals - 1, k); j > 0; --j) {
        scaled[j] = rows[k][j];
        for (std::size_t i = j + 1; i < diagonals && i <= k; ++i)
          scaled[j] -= scaled[i] * rows[k - j][i - j];
      }
      for (std::size_t j = 1; j < diagonals && j <= k; ++j) {
        rows[k][j] = scaled[j] / rows[k - j][0];
        rows[k][0] -= scaled[j] * rows[k][j];
      }
    }
  }

  /// By the factors.
  void solve(std::vector<Number>& b) const {
    const std::size_t n = rows.size();
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t j = 1; j < diagonals && j <= k; ++j) b[k] -= rows[k][j] * b[k - j];
    for (std::size_t k = 0; k < n; ++k) b[k] /= rows[k][0];
    for (std::size_t k = n; k-- > 0;)
      for (std::size_t j = 1; j < diagonals && k + j < n; ++j) b[k] -= rows[k + j][j] * b[k + j];
  }
};

}  // namespace rollfem::profiles
