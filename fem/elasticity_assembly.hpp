// Stiffness of linear isotropic elasticity: one cell's matrix, and the assembled matrix of the free
// unknowns (constraints eliminated) in compressed columns. One process only.
#pragma once

#include "fem/linear_solver.hpp"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>

#include <cstdint>
#include <vector>

namespace rollfem::fem {

/// K_ab,ij = int lambda dN_a/dx_i dN_b/dx_j + mu dN_a/dx_j dN_b/dx_i + mu delta_ij grad N_a.grad
/// N_b for FE_Q(degree)^3, unknowns numbered as in the deal.II cell. Reuses its buffers from cell
/// to cell.
class CellStiffness {
 public:
  CellStiffness(const dealii::FiniteElement<3>& element, const dealii::Mapping<3>& mapping,
                const contact::Material& material);
  /// Row-major, dofs per cell squared, symmetric.
  const std::vector<double>& compute(const dealii::DoFHandler<3>::active_cell_iterator& cell);

 private:
  const unsigned int nodes_;
  dealii::FE_Q<3> scalar_;
  dealii::QGauss<3> quadrature_;
  dealii::FEValues<3> values_;
  double lambda_;
  double mu_;
  std::vector<unsigned int> position_;  ///< dof of (node a, component i) at 3 a + i
  std::vector<double> gradients_;       ///< of one quadrature point, 3 a + i
  std::vector<double> products_;        ///< int dN_a/dx_i dN_b/dx_j, (3 a + i, 3 b + j)
  std::vector<double> stiffness_;
};

/// Every unknown as a combination of free ones: u = C x. Rows of constrained unknowns hold their
/// constraint's entries (none: fixed to zero), rows of free ones a single 1.
struct FreeUnknowns {
  int count = 0;
  std::vector<std::int64_t> row_start;
  std::vector<int> column;
  std::vector<double> weight;

  /// x = C^T b.
  void condense(const Vector& b, std::vector<double>& x) const;
  /// u = C x.
  void expand(const double* x, Vector& u) const;
};
FreeUnknowns number_free_unknowns(const dealii::DoFHandler<3>& dofs,
                                  const dealii::AffineConstraints<double>& constraints);

/// Lower triangle of a symmetric matrix in compressed columns, rows sorted.
struct SymmetricMatrix {
  int size = 0;
  std::vector<std::int64_t> column_start;
  std::vector<int> row;
  std::vector<double> value;

  /// y = K x.
  void multiply(const std::vector<double>& x, std::vector<double>& y) const;
};

/// C^T K C.
SymmetricMatrix assemble(const ElasticProblem& problem, const FreeUnknowns& unknowns);

}  // namespace rollfem::fem
