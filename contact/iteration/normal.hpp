// SPDX-License-Identifier: LGPL-2.1-or-later
// Frictionless normal contact: p >= 0, gap = h + A_nn p - approach >= 0, p gap = 0, by
// bound-constrained conjugate gradients with a preconditioner (Polonsky & Keer 1999; Vollebregt
// 2014, "The bound-constrained conjugate gradient method for non-negative matrices").
#pragma once

#include "contact/iteration/compliance.hpp"

#include <optional>

namespace rollfem::contact {

struct NormalProblem {
  Field undeformed_distance;           ///< h, mm, with any defect of the compliance added
  std::optional<double> normal_force;  ///< N, 0: they just touch; exactly one of the two
  std::optional<double> approach;      ///< mm
};

struct NormalOptions {
  double tolerance = 1e-8;  ///< on the largest violation of gap = 0, relative to the approach
  int max_iterations = 500;
};

struct NormalSolution {
  Field pressure;  ///< MPa
  Field gap;       ///< remaining h + A p - approach, mm: 0 in contact to the tolerance
  double approach = 0.0;
  double normal_force = 0.0;
  int contact_elements = 0;
  int iterations = 0;
  double residual = 0.0;
};

/// Throws SolveError without contact or when the iteration does not converge. `start`: initial
/// pressure, may be empty.
NormalSolution solve_normal(const NormalOperator& compliance, const NormalProblem& problem,
                            const NormalOptions& options = {}, const Field& start = {});

}  // namespace rollfem::contact
