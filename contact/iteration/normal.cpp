// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/iteration/normal.hpp"

#include "base/errors.hpp"
#include "contact/iteration/bound_constrained_cg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rollfem::contact {

namespace {

void check_problem(const NormalOperator& compliance, const NormalProblem& problem,
                   const Field& start) {
  const int n = compliance.grid().size();
  if (problem.undeformed_distance.size() != n)
    throw SolveError(
        fmt::format("normal problem: {} values of the undeformed distance for {} "
                    "contact elements",
                    problem.undeformed_distance.size(), n));
  if (!problem.undeformed_distance.allFinite())
    throw SolveError("normal problem: the undeformed distance is not finite everywhere");
  if (problem.normal_force.has_value() == problem.approach.has_value())
    throw SolveError("normal problem: exactly one of normal force and approach must be given");
  if (start.size() != 0 && start.size() != n)
    throw SolveError("normal problem: the pressure to start from is on another grid");
  if (problem.normal_force &&
      !(*problem.normal_force >= 0.0 && std::isfinite(*problem.normal_force)))
    throw SolveError(fmt::format("no contact: the normal force is {} N; allowed: 0 and above",
                                 *problem.normal_force));
  const double smallest = problem.undeformed_distance.minCoeff();
  if (problem.approach && !(*problem.approach > smallest && std::isfinite(*problem.approach)))
    throw SolveError(
        fmt::format("no contact: the approach {} mm does not exceed the smallest undeformed "
                    "distance {} mm",
                    *problem.approach, smallest));
}

/// Bodies without load that just touch.
NormalSolution touching(const Field& distance) {
  NormalSolution result;
  result.pressure = Field::Zero(distance.size());
  result.approach = distance.minCoeff();
  result.gap = distance.array() - result.approach;
  return result;
}

}  // namespace

NormalSolution solve_normal(const NormalOperator& compliance, const NormalProblem& problem,
                            const NormalOptions& options, const Field& start) {
  check_problem(compliance, problem, start);
  if (problem.normal_force == 0.0) return touching(problem.undeformed_distance);
  const double area = compliance.grid().element_area();
  BoundConstrainedCg iteration;
  NormalSolution result;
  const auto [iterations, residual] =
      problem.approach ? iteration.solve_approach(compliance, problem.undeformed_distance,
                                                  *problem.approach, options, start)
                       : iteration.solve_sum(compliance, problem.undeformed_distance,
                                             *problem.normal_force / area, options, start);
  result.pressure = iteration.pressure();
  result.gap = iteration.gap();
  result.approach = iteration.approach();
  result.normal_force = result.pressure.sum() * area;
  result.contact_elements = iteration.contact_elements();
  result.iterations = iterations;
  result.residual = residual;
  return result;
}

}  // namespace rollfem::contact
