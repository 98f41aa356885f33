// SPDX-License-Identifier: LGPL-2.1-or-later
// The product of element stiffness matrices of linear elasticity with a vector, without forming
// them: sum factorisation on tensor-product hexahedra, several cells at a time in the lanes of
// SIMD registers. deal.II's own kernels are as wide as the library was compiled for, which in
// Debian is one lane; this one picks AVX-512, AVX2 or SSE2 at run time. It does not depend on
// deal.II.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace rollfem::fem {

/// Cells per batch: as many as fit into 64 bytes, regardless of the register size.
template <typename Number>
constexpr int lanes = 64 / static_cast<int>(sizeof(Number));

/// Entries of a node in the local vectors: the three components and one padding entry, so that a
/// node is read and written in one access.
constexpr int entries_per_node = 4;
template <typename Number>
struct NodeEntries {
  using type [[gnu::vector_size(entries_per_node * sizeof(Number)), gnu::may_alias]] = Number;
};

/// Cells in batches of lanes<Number>, in structure-of-arrays form. Lanes without a cell have zero
/// geometry and index 0. Arrays begin at multiples of 64 bytes.
template <typename Number>
struct CellBatches {
  std::size_t count = 0;
  /// [batch][node][lane]: index of the node's first entry in the local vectors; nodes
  /// lexicographic, x fastest.
  const unsigned int* nodes = nullptr;
  /// [batch][quadrature point][e][d][lane]: sqrt(weight det J) * d xi_e / d x_d at the Gauss
  /// points, degree + 1 in each direction, so that products of two of them contain the full weight
  /// of the integral.
  const Number* geometry = nullptr;
  /// Whether the geometry is one matrix per cell, [batch][e][d][lane], without the weights of the
  /// quadrature: for cells that are (nearly) parallelepipeds, without flow and projected
  /// dilatation.
  bool parallelepipeds = false;
  /// [batch][quadrature point][e][lane]: sqrt(rho weight det J) * v . grad xi_e for material
  /// flowing with velocity v; null: no inertia.
  const Number* flow = nullptr;
  /// [batch][quadrature point][k][lane]: sqrt(weight det J) * phi_k with the projection functions
  /// of the dilatation (one for degree 1, four for degree 2), orthonormal in the cell's quadrature;
  /// null: not projected.
  const Number* dilatation = nullptr;
};

/// Lame's constants, MPa.
template <typename Number>
struct LameConstants {
  Number lambda = 0, mu = 0;
};

template <typename Number>
struct ElasticityKernel {
  /// y += sum over cells of K_cell x; x and y are local vectors, beginning at multiples of 64
  /// bytes.
  void (*add_product)(const CellBatches<Number>& cells, const LameConstants<Number>& material,
                      const Number* x, Number* y);
  /// The element matrices of one batch, [row][column][lane], rows and columns numbered
  /// component * nodes + node.
  void (*element_matrices)(const CellBatches<Number>& cells, const LameConstants<Number>& material,
                           std::size_t batch, Number* matrices);
};

/// Compiled instruction sets supported by this processor, the widest last: "sse2", "avx2",
/// "avx512".
std::vector<std::string> simd_variants();

/// The variant named by $ROLLFEM_SIMD, by default the widest. Throws contact::InputError for one
/// that is not available on this machine.
std::string simd_variant();

/// Degree 1 or 2, Number float or double; `variant`: one of simd_variants().
template <typename Number>
ElasticityKernel<Number> elasticity_kernel(int degree, const std::string& variant = simd_variant());

}  // namespace rollfem::fem
