// SPDX-License-Identifier: LGPL-2.1-or-later
// Stiffness of linear isotropic elasticity: one cell's matrix, and the assembled matrix of the free
// unknowns (constraints eliminated) in compressed columns. One process only.
#pragma once

#include "fem/discretisation/elastic_problem.hpp"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>

#include <cstdint>
#include <vector>

namespace rollfem::fem {

/// K_ab,ij = int lambda P(dN_a/dx_i) P(dN_b/dx_j) + mu dN_a/dx_j dN_b/dx_i + delta_ij (mu grad
/// N_a.grad N_b - rho (v.grad N_a)(v.grad N_b)) for FE_Q(degree)^3, with the projection P (or the
/// identity) and the flow v of elastic_problem.hpp; unknowns numbered as in the deal.II cell.
/// Reuses its buffers from cell to cell.
class CellStiffness {
 public:
  explicit CellStiffness(const ElasticProblem& problem);
  /// Row-major, dofs per cell squared, symmetric.
  const std::vector<double>& compute(const dealii::DoFHandler<3>::active_cell_iterator& cell);

 private:
  void integrate();
  void project_dilatation();
  void integrate_inertia();

  const unsigned int nodes_;
  dealii::FE_Q<3> scalar_;
  dealii::QGauss<3> quadrature_;
  dealii::FEValues<3> values_;
  double lambda_;
  double mu_;
  std::vector<unsigned int> position_;  ///< dof of (node a, component i) at 3 a + i
  std::vector<double> gradients_;       ///< of one quadrature point, 3 a + i
  std::vector<double> products_;        ///< int dN_a/dx_i dN_b/dx_j, (3 a + i, 3 b + j)
  const bool projected_;
  DilatationSpace space_;
  std::vector<double> projected_gradients_;  ///< coefficients of P(dN_a/dx_i), function by function
  const double density_;                     ///< t/mm^3, 0: no inertia
  const MaterialMotion motion_;
  std::vector<double> inertia_;  ///< rho int (v.grad N_a)(v.grad N_b), (a, b)
  std::vector<double> stiffness_;
};

/// Every unknown as a combination of free ones: u = C x. Rows of constrained unknowns hold their
/// constraint's entries (none: fixed to zero), rows of free ones a single 1.
struct FreeUnknowns {
  int count = 0;
  std::vector<std::int64_t> row_start;
  std::vector<int> column;
  std::vector<double> weight;
  /// Cells included in the matrix, in the order of the active cells; empty: all.
  std::vector<bool> cells;

  bool takes(std::size_t cell) const { return cells.empty() || cells[cell]; }
  /// x = C^T b.
  void condense(const Vector& b, std::vector<double>& x) const;
  /// u += C x.
  void expand_and_add(const double* x, Vector& u) const;
};
/// An unknown as a multiple of another one: of its mirror image, say. Free ones are their own,
/// with the factor 1; the factor 0 fixes it to zero.
struct Multiple {
  int of;
  double factor;
};
FreeUnknowns number_free_unknowns(const dealii::AffineConstraints<double>& constraints,
                                  const std::vector<Multiple>& multiples);
FreeUnknowns number_free_unknowns(const dealii::DoFHandler<3>& dofs,
                                  const dealii::AffineConstraints<double>& constraints);

/// Renumbers the unknowns in elimination order for a factorisation. Throws contact::SolveError when
/// memory runs out.
void order_for_elimination(const dealii::DoFHandler<3>& dofs, FreeUnknowns& unknowns);

/// Lower triangle of a symmetric matrix in compressed columns, rows sorted.
struct SymmetricMatrix {
  int size = 0;
  std::vector<std::int64_t> column_start;
  std::vector<int> row;
  std::vector<double> value;

  /// y = K x.
  void multiply(const std::vector<double>& x, std::vector<double>& y) const;
};

/// C^T K C, with K of the selected cells, for each set of unknowns: the stiffness of a cell is
/// computed once for all.
std::vector<SymmetricMatrix> assemble(const ElasticProblem& problem,
                                      const std::vector<const FreeUnknowns*>& unknowns);

}  // namespace rollfem::fem
