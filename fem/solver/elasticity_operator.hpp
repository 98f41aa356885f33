// The stiffness of one level of a body as an operator: K u without a matrix, hanging nodes and
// boundary conditions included, on the locally owned part of the unknowns of every process.
#pragma once

#include "fem/solver/elasticity_kernel.hpp"
#include "fem/solver/linear_solver.hpp"

#include <deal.II/base/aligned_vector.h>
#include <deal.II/base/partitioner.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace rollfem::fem {

/// A dof that constraints fix: u_row = sum of weight * u_master, an empty sum for a boundary
/// condition. Numbers are local ones.
struct ConstrainedRow {
  struct Term {
    unsigned int master;
    double weight;
  };
  unsigned int row;
  std::vector<Term> terms;
};

/// The unknowns of this process: owned ones first, then the ghosts that its cells and the
/// constraints on them refer to.
struct LocalDofs {
  std::shared_ptr<const dealii::Utilities::MPI::Partitioner> with_ghosts;
  std::shared_ptr<const dealii::Utilities::MPI::Partitioner> owned_only;
  std::vector<ConstrainedRow> constrained;  ///< ascending rows, so the owned ones come first
  std::size_t owned_constrained = 0;
};

/// Indices and geometry cell by cell, what operators of either precision are packed from.
struct LocalCells {
  int degree = 0;
  std::size_t count = 0;
  std::shared_ptr<const LocalDofs> dofs;
  std::vector<unsigned int> indices;  ///< [cell][component][node], nodes lexicographic
  std::vector<double> geometry;       ///< [cell][point][e][d], as in CellBatches
  std::vector<double> flow;           ///< [cell][point][e], empty without inertia
  std::vector<double> dilatation;     ///< [cell][point][function], empty: not projected
  contact::Material material;
};

/// Collective. Throws contact::InputError for degrees other than 1 and 2 and for cells that the
/// mapping turns inside out.
LocalCells make_local_cells(const ElasticProblem& problem);

/// Lower triangle of a sparse symmetric matrix in global numbers, row after row.
struct MatrixEntry {
  unsigned int row, column;
  double value;
};

/// Vectors hold the owned unknowns only (owned_only); constrained entries are mapped by the
/// identity. One product at a time: the operator owns its working vectors.
template <typename Number>
class ElasticityOperator {
 public:
  using VectorType = dealii::LinearAlgebra::distributed::Vector<Number>;

  explicit ElasticityOperator(const LocalCells& cells);

  VectorType make_vector() const;
  /// K x, collective.
  void vmult(VectorType& product, const VectorType& x) const;
  /// The inverse diagonal of the constrained matrix, 1 at constrained dofs.
  VectorType inverse_diagonal() const;
  /// What this process adds to the constrained matrix; entries of one place occur once.
  std::vector<MatrixEntry> assemble() const;
  /// b <- C^T b: what stands at constrained dofs is moved to their masters, 0 remains.
  void condense(VectorType& b) const;
  /// u <- C u: constrained dofs from their masters.
  void distribute(VectorType& u) const;
  double memory_bytes() const;

 private:
  struct CellMaster {
    unsigned int master;  ///< local number of an unconstrained dof
    int dof;              ///< of the cell, that depends on it
    double weight;
  };
  template <typename F>
  void for_each_cell(const F& f) const;
  void load(const VectorType& x) const;
  void unload(VectorType& y, std::size_t rows) const;

  std::shared_ptr<const LocalDofs> dofs_;
  ElasticityKernel<Number> kernel_;
  LameConstants<Number> material_;
  int cell_dofs_;
  std::size_t cells_;
  dealii::AlignedVector<unsigned int> indices_;
  dealii::AlignedVector<Number> geometry_, flow_, dilatation_;
  CellBatches<Number> batches_;
  mutable VectorType source_, result_;  ///< with ghosts
};

extern template class ElasticityOperator<float>;
extern template class ElasticityOperator<double>;

}  // namespace rollfem::fem
