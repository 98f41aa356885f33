// SPDX-License-Identifier: LGPL-2.1-or-later
// Work on all elements of a grid, and sums over them, in pieces for several threads. The pieces
// depend on the number of elements alone, and so do the sums.
#pragma once

#include "base/threads.hpp"

#include <Eigen/Core>

#include <array>
#include <cstddef>

namespace rollfem::contact {

/// 0.05 ms of additions: fewer are one piece.
constexpr Eigen::Index elements_for_threads = 32768;
constexpr Eigen::Index most_pieces = 16;

inline Eigen::Index piece_of(Eigen::Index size) {
  return size < elements_for_threads ? size : (size + most_pieces - 1) / most_pieces;
}

/// Calls work(first, count) for every piece of `size` elements.
template <class Work>
void in_pieces(Eigen::Index size, const Work& work) {
  if (size < elements_for_threads) return work(Eigen::Index{0}, size);
  for_each_piece(size, piece_of(size),
                 [&](std::ptrdiff_t first, std::ptrdiff_t last) { work(first, last - first); });
}

/// Calls work(e) for every element.
template <class Work>
void for_each_element(Eigen::Index size, const Work& work) {
  in_pieces(size, [&](Eigen::Index first, Eigen::Index count) {
    for (Eigen::Index e = first; e < first + count; ++e) work(e);
  });
}

/// The sum of what term(first, count) returns for the pieces, in their order.
template <class Term>
double sum_in_pieces(Eigen::Index size, const Term& term) {
  if (size < elements_for_threads) return term(Eigen::Index{0}, size);
  std::array<double, most_pieces> terms{};
  in_pieces(size, [&](Eigen::Index first, Eigen::Index count) {
    terms[static_cast<std::size_t>(first / piece_of(size))] = term(first, count);
  });
  double sum = 0.0;
  for (const double one : terms) sum += one;
  return sum;
}

}  // namespace rollfem::contact
