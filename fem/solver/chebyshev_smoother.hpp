// The smoother of the multigrid levels: Chebyshev iteration with Jacobi's diagonal.
#pragma once

#include "fem/solver/elasticity_operator.hpp"

namespace rollfem::fem {

/// Damps the part of the error whose eigenvalues of D^-1 K lie in the upper part
/// [largest / (10 degree), largest] of the spectrum. A polynomial in D^-1 K, so that a V-cycle with
/// it before and after is symmetric.
class ChebyshevSmoother {
 public:
  using VectorType = ElasticityOperator<float>::VectorType;

  /// Estimates the largest eigenvalue, collective. The operator outlives the smoother.
  ChebyshevSmoother(const ElasticityOperator<float>& stiffness, int degree);

  /// x = p(D^-1 K) D^-1 b, from zero.
  void start(VectorType& x, const VectorType& b) const;
  /// Improves x.
  void step(VectorType& x, const VectorType& b) const;
  double largest_eigenvalue() const { return largest_; }
  double memory_bytes() const;

 private:
  void iterate(VectorType& x, const VectorType& b, bool from_zero) const;

  const ElasticityOperator<float>* stiffness_;
  int degree_;
  double largest_ = 0;
  VectorType inverse_diagonal_;
  mutable VectorType product_, update_;
};

}  // namespace rollfem::fem
