// SPDX-License-Identifier: LGPL-2.1-or-later
// Moves the nodes of a batch of cells between memory (four entries per node) and rows of lanes (one
// component per row).
#pragma once

#include "fem/discretisation/elasticity_kernel.hpp"

#include <cstddef>

// Vectors of 64 bytes never cross the boundary of a non-inlined function.
#pragma GCC diagnostic ignored "-Wpsabi"

#define ROLLFEM_INLINE inline __attribute__((always_inline))

namespace rollfem::fem {

/// A register of this many bytes. GCC 12 implements vectors wider than the registers of the
/// instruction set through memory, six times slower.
template <typename Number, int bytes>
struct Simd {
  using type [[gnu::vector_size(bytes)]] = Number;
};

/// Four lanes of each component from four nodes: the transpose, without its last row.
template <typename Node>
ROLLFEM_INLINE void to_lanes(const Node& a, const Node& b, const Node& c, const Node& d, Node& x,
                             Node& y, Node& z) {
  const Node ab = __builtin_shufflevector(a, b, 0, 4, 1, 5);
  const Node cd = __builtin_shufflevector(c, d, 0, 4, 1, 5);
  x = __builtin_shufflevector(ab, cd, 0, 1, 4, 5);
  y = __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
  z = __builtin_shufflevector(__builtin_shufflevector(a, b, 2, 6, 3, 7),
                              __builtin_shufflevector(c, d, 2, 6, 3, 7), 0, 1, 4, 5);
}

/// u[component][node][lane] of the cells of a batch. Always four lanes at a time: wider ones are
/// not faster, and narrower ones would process wide shuffles lane by lane.
template <int nodes, typename Number>
ROLLFEM_INLINE void gather_nodes(const unsigned int* offsets, const Number* x, Number* u) {
  using Node = typename NodeEntries<Number>::type;
  constexpr int groups = lanes<Number> / entries_per_node;
  Node* const to = reinterpret_cast<Node*>(u);
  const auto node = [=](unsigned int k) { return *reinterpret_cast<const Node*>(x + k); };
  for (int i = 0; i < nodes * groups; ++i) {
    const unsigned int* const at = offsets + entries_per_node * i;
    to_lanes(node(at[0]), node(at[1]), node(at[2]), node(at[3]), to[i], to[nodes * groups + i],
             to[2 * nodes * groups + i]);
  }
}

/// The reverse, added to y. One node after the other, because lanes may share nodes.
template <int nodes, typename Number>
ROLLFEM_INLINE void scatter_nodes(const Number* u, const unsigned int* offsets, Number* y) {
  using Node = typename NodeEntries<Number>::type;
  constexpr int groups = lanes<Number> / entries_per_node;
  const Node* const from = reinterpret_cast<const Node*>(u);
  const auto node = [=](unsigned int k) -> Node& { return *reinterpret_cast<Node*>(y + k); };
  for (int i = 0; i < nodes * groups; ++i) {
    const unsigned int* const at = offsets + entries_per_node * i;
    const Node a = from[i], b = from[nodes * groups + i], c = from[2 * nodes * groups + i];
    const Node zero{};
    const Node ab = __builtin_shufflevector(a, b, 0, 4, 1, 5);
    const Node cz = __builtin_shufflevector(c, zero, 0, 4, 1, 5);
    node(at[0]) += __builtin_shufflevector(ab, cz, 0, 1, 4, 5);
    node(at[1]) += __builtin_shufflevector(ab, cz, 2, 3, 6, 7);
    const Node ab_high = __builtin_shufflevector(a, b, 2, 6, 3, 7);
    const Node cz_high = __builtin_shufflevector(c, zero, 2, 6, 3, 7);
    node(at[2]) += __builtin_shufflevector(ab_high, cz_high, 0, 1, 4, 5);
    node(at[3]) += __builtin_shufflevector(ab_high, cz_high, 2, 3, 6, 7);
  }
}

/// Prefetches the nodes of the next batch while this one is computed. Neighbours in single
/// precision share cache lines, so that prefetching some of them is sufficient (measured).
template <typename Number>
ROLLFEM_INLINE void fetch_nodes(const unsigned int* offsets, int nodes, const Number* x,
                                const Number* y) {
  constexpr int step = lanes<Number> == 16 ? 4 : 1;
  for (int i = 0; i < nodes * lanes<Number>; i += step) {
    __builtin_prefetch(x + offsets[i]);
    __builtin_prefetch(y + offsets[i], 1);
  }
}

}  // namespace rollfem::fem
