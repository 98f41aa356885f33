// Restarted GMRES with right preconditioning for matrix-free linear systems (Saad & Schultz 1986).
#pragma once

#include <Eigen/Core>

#include <functional>

namespace rollfem::contact {

using LinearMap = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

struct GmresOptions {
  double tolerance = 1e-2;  ///< on the true residual, relative to the right-hand side
  int max_iterations = 400;
  int restart = 80;
};

struct GmresResult {
  Eigen::VectorXd solution;
  int iterations = 0;
  double residual = 0.0;  ///< relative
  bool converged = false;
};

/// Solves A x = b from x = 0, minimising the residual over x = M y.
GmresResult gmres(const LinearMap& matrix, const LinearMap& preconditioner,
                  const Eigen::VectorXd& right_hand_side, const GmresOptions& options);

}  // namespace rollfem::contact
