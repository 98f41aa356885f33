// SPDX-License-Identifier: LGPL-2.1-or-later
// The stiffness of one level of a body as an operator: K u without a matrix, hanging nodes and
// boundary conditions included, on the locally owned part of the unknowns of every process.
#pragma once

#include "base/spares.hpp"
#include "fem/discretisation/coloured_pieces.hpp"
#include "fem/discretisation/elasticity_kernel.hpp"
#include "fem/discretisation/local_cells.hpp"

#include <deal.II/base/aligned_vector.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace rollfem::fem {

/// Lower triangle of a sparse symmetric matrix in global numbers, row after row.
struct MatrixEntry {
  unsigned int row, column;
  double value;

  template <class Archive>
  void serialize(Archive& archive, unsigned int /*version*/) {
    archive& row& column& value;
  }
};

/// Number of cell-vector products computed by this process so far, on all levels: a measure of work
/// independent of the load of the machine.
std::uint64_t cell_products();

/// Vectors hold the owned unknowns only (owned_only); constrained entries are mapped by the
/// identity. Products may run beside each other on several threads.
template <typename Number>
class ElasticityOperator {
 public:
  using VectorType = dealii::LinearAlgebra::distributed::Vector<Number>;

  /// Cells at rest and without projection whose geometry varies by a relative amount below
  /// `straightened` are treated as parallelepipeds: a fortieth of the geometry's memory and faster,
  /// for operators used as preconditioners.
  explicit ElasticityOperator(const LocalCells& cells, double straightened = 0.0);
  /// Takes ownership of the geometry, so that in double precision there is never a copy.
  explicit ElasticityOperator(LocalCells&& cells);

  VectorType make_vector() const;
  /// K x, collective.
  void vmult(VectorType& product, const VectorType& x) const;
  /// The same with work on consecutive ranges of the owned unknowns [begin, end): `before` may
  /// still change x there, `after` is called with the product there and may change both; either may
  /// be empty. Ranges are worked on side by side.
  using Work = std::function<void(unsigned int begin, unsigned int end)>;
  void vmult(VectorType& product, const VectorType& x, const Work& before, const Work& after) const;
  /// b - K x, collective.
  void residual(VectorType& residual, const VectorType& b, const VectorType& x) const;
  /// The inverse diagonal of the constrained matrix, 1 at constrained dofs.
  VectorType inverse_diagonal() const;
  /// Contributions of this process to the constrained matrix; every entry occurs once.
  std::vector<MatrixEntry> assemble() const;
  /// b <- C^T b: values at constrained dofs are moved to their masters and set to 0.
  void condense(VectorType& b) const;
  /// u <- C u: constrained dofs from their masters.
  void distribute(VectorType& u) const;
  double memory_bytes() const;

 private:
  struct CellMaster {
    unsigned int master;  ///< local number of an unconstrained dof
    int dof;              ///< dof of the cell that depends on it
    double weight;
  };
  /// Cells of one kind.
  struct Group {
    std::size_t cells = 0;
    dealii::AlignedVector<unsigned int> nodes;
    dealii::AlignedVector<Number> geometry, flow, dilatation;
    CellBatches<Number> batches;
    ColouredPieces pieces;  ///< of batches

    /// The batches [first, end).
    CellBatches<Number> part(std::size_t first, std::size_t end) const;
  };
  explicit ElasticityOperator(const LocalCells* cells);
  Group make_group(const LocalCells& cells, const std::vector<std::size_t>& chosen,
                   const dealii::AlignedVector<double>& one_matrix) const;
  Group make_group(LocalCells&& cells) const;
  void refer(Group& group, std::size_t cells) const;
  template <typename F>
  void for_each_cell(const F& f) const;
  /// Vectors of one product.
  struct Scratch {
    dealii::AlignedVector<Number> source, result;  ///< in the format of the kernel
    VectorType exchange;                           ///< with ghosts, of several processes
  };
  auto scratch() const {
    return scratch_.borrow([&] { return new_scratch(); });
  }
  std::unique_ptr<Scratch> new_scratch() const;
  void load(const VectorType& x, const Work& before, Scratch& scratch) const;
  void add_of_ghosts(Scratch& scratch) const;

  std::shared_ptr<const LocalDofs> dofs_;
  ElasticityKernel<Number> kernel_;
  LameConstants<Number> material_;
  int cell_nodes_;
  std::vector<Group> groups_;
  contact::Spares<Scratch> scratch_;
};

extern template class ElasticityOperator<float>;
extern template class ElasticityOperator<double>;

}  // namespace rollfem::fem
