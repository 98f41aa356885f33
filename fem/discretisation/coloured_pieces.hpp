// SPDX-License-Identifier: LGPL-2.1-or-later
// Cells on several threads that add to shared nodes: pieces of one colour have no node in common,
// and colours follow each other in a fixed order, so that every node sums its cells in an order
// that depends on the mesh alone.
#pragma once

#include "base/threads.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace rollfem::fem {

class ColouredPieces {
 public:
  ColouredPieces() = default;
  /// `items` (cells or batches of cells) of `of_item` indices each, all below `indices`; few of
  /// them are one piece.
  ColouredPieces(const unsigned int* index, std::size_t of_item, std::size_t items,
                 std::size_t indices) {
    // Enough pieces for sixteen threads and eight colours; smaller ones take as long to hand out as
    // to compute (some 2000 indices, 0.01 ms).
    constexpr std::size_t pieces = 256, fewest_indices = 2000;
    const std::size_t piece = std::max(
        {std::size_t{1}, items / pieces, fewest_indices / std::max<std::size_t>(of_item, 1)});
    constexpr std::size_t most_colours = 64;
    std::vector<std::uint64_t> colours_at(indices, 0);
    for (std::size_t first = 0; first < items; first += piece) {
      const std::size_t end = std::min(first + piece, items);
      std::uint64_t taken = 0;
      for (const auto* i = index + first * of_item; i != index + end * of_item; ++i)
        if (*i < indices) taken |= colours_at[*i];
      std::size_t colour = 0;
      while (colour < most_colours && (taken >> colour & 1U) != 0) ++colour;
      if (colour == most_colours) colour = colours_.size();  // a colour of its own
      if (colours_.size() <= colour) colours_.resize(colour + 1);
      colours_[colour].push_back({first, end});
      if (colour >= most_colours) continue;
      for (const auto* i = index + first * of_item; i != index + end * of_item; ++i)
        if (*i < indices) colours_at[*i] |= std::uint64_t{1} << colour;
    }
  }
  /// Calls work(first, end) for all items, pieces of one colour side by side.
  void for_each(const std::function<void(std::size_t, std::size_t)>& work) const {
    for (const auto& pieces : colours_)
      contact::for_each_index(pieces.size(),
                              [&](std::size_t k) { work(pieces[k][0], pieces[k][1]); });
  }

 private:
  std::vector<std::vector<std::array<std::size_t, 2>>> colours_;
};

}  // namespace rollfem::fem
