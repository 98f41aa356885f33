// SPDX-License-Identifier: LGPL-2.1-or-later
// Cells on several threads that add to shared nodes: pieces of one colour have no node in common,
// and colours follow each other in a fixed order, so that every node sums its cells in an order
// that depends on the mesh alone.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace rollfem::fem {

class ColouredPieces {
 public:
  ColouredPieces() = default;
  /// `items` (cells or batches of cells) of `of_item` indices each, all below `indices`; few of
  /// them are one piece.
  ColouredPieces(const unsigned int* index, std::size_t of_item, std::size_t items,
                 std::size_t indices);
  /// Calls work(first, end) for all items, pieces of one colour side by side.
  void for_each(const std::function<void(std::size_t, std::size_t)>& work) const;

 private:
  std::vector<std::vector<std::array<std::size_t, 2>>> colours_;
};

}  // namespace rollfem::fem
