// SPDX-License-Identifier: LGPL-2.1-or-later
// The stiffness of one level of a body as an operator: K u without a matrix, hanging nodes and
// boundary conditions included, on the locally owned part of the unknowns of every process.
#pragma once

#include "fem/discretisation/elastic_problem.hpp"
#include "fem/discretisation/elasticity_kernel.hpp"
#include "fem/discretisation/local_dofs.hpp"

#include <deal.II/base/aligned_vector.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace rollfem::fem {

/// Position in deal.II's numbering of a cell of (component, node), nodes lexicographic, x quickest.
/// Throws contact::InputError for elements other than FE_Q(1)^3 and FE_Q(2)^3.
std::vector<unsigned int> lexicographic_positions(const dealii::FiniteElement<3>& element);

/// Indices and geometry cell by cell, what operators of either precision are packed from.
struct LocalCells {
  int degree = 0;
  std::size_t count = 0;
  std::shared_ptr<const LocalDofs> dofs;
  std::vector<unsigned int> nodes;           ///< [cell][node], local numbers, lexicographic
  dealii::AlignedVector<double> geometry;    ///< [cell][point][e][d], as in CellBatches
  dealii::AlignedVector<double> flow;        ///< [cell][point][e], empty without inertia
  dealii::AlignedVector<double> dilatation;  ///< [cell][point][function], empty: not projected
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

/// Products of a cell with a vector that this process has computed so far, on all levels: what it
/// has done of the work, on however busy a machine.
std::uint64_t cell_products();

/// Vectors hold the owned unknowns only (owned_only); constrained entries are mapped by the
/// identity. One product at a time: the operator owns its working vectors.
template <typename Number>
class ElasticityOperator {
 public:
  using VectorType = dealii::LinearAlgebra::distributed::Vector<Number>;

  /// Cells at rest and without projection whose geometry varies by less than `straightened`,
  /// relative to itself, are taken for parallelepipeds: a fortieth of the memory of the geometry
  /// and more speed, for operators that precondition.
  explicit ElasticityOperator(const LocalCells& cells, double straightened = 0.0);
  /// Takes the geometry over: in double precision it is never there twice.
  explicit ElasticityOperator(LocalCells&& cells);

  VectorType make_vector() const;
  /// K x, collective.
  void vmult(VectorType& product, const VectorType& x) const;
  /// The same with work on one part of the owned unknowns [begin, end) after the other: `before`
  /// may still change x there, `after` finds the product there and may change both.
  using Work = std::function<void(unsigned int begin, unsigned int end)>;
  void vmult(VectorType& product, const VectorType& x, const Work& before, const Work& after) const;
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
  /// Cells that one call of the kernel takes.
  struct Group {
    std::size_t cells = 0;
    dealii::AlignedVector<unsigned int> nodes;
    dealii::AlignedVector<Number> geometry, flow, dilatation;
    CellBatches<Number> batches;
  };
  explicit ElasticityOperator(const LocalCells* cells);
  static Group make_group(const LocalCells& cells, const std::vector<std::size_t>& chosen,
                          const dealii::AlignedVector<double>& one_matrix);
  static Group make_group(LocalCells&& cells);
  static void refer(Group& group, std::size_t cells);
  template <typename F>
  void for_each_cell(const F& f) const;
  void load(const VectorType& x, const Work& before) const;
  void add_of_ghosts() const;

  std::shared_ptr<const LocalDofs> dofs_;
  ElasticityKernel<Number> kernel_;
  LameConstants<Number> material_;
  int cell_nodes_;
  std::vector<Group> groups_;
  mutable dealii::AlignedVector<Number> source_, result_;  ///< as the kernel takes them
  mutable VectorType exchange_;                            ///< with ghosts, of several processes
};

extern template class ElasticityOperator<float>;
extern template class ElasticityOperator<double>;

}  // namespace rollfem::fem
