// SPDX-License-Identifier: LGPL-2.1-or-later
// The elasticity of one level of the finite-element model: bodies, linear solvers and compliance on
// the contact grid, with the half-space that preconditions them, and the stresses of load points.
#pragma once

#include "contact/base/progress.hpp"
#include "contact/solve/contact_run.hpp"
#include "fem/elasticity/run_level.hpp"
#include "fem/linear/first_process.hpp"
#include "fem/mesh/run_layout.hpp"

#include <memory>

namespace rollfem::fem {

/// Solved by the first process for the contact problem; all processes take part in prepare(),
/// compliance() and complete().
class FemElasticity : public contact::Elasticity {
 public:
  /// On other processes: executes an order of the first one (FirstProcess::run).
  virtual void obey(const FirstProcess::Order& order) = 0;
  /// The same level, for a load point that is solved beside others.
  virtual std::unique_ptr<FemElasticity> beside() const = 0;
  /// Load points that solvers and memory allow beside each other.
  virtual std::size_t most_beside() const = 0;
};

/// Meshes and factorises when it is prepared; fills unknowns, bodies, seconds and notes of
/// `result`. All arguments must outlive the returned object. Throws contact::InputError,
/// contact::SolveError.
std::unique_ptr<FemElasticity> make_fem_elasticity(
    const contact::Scene& scene, const contact::ChartedGeometry& geometry, const RunLayout& layout,
    const LevelOptions& options, const contact::Progress& progress, FirstProcess& first,
    contact::ModelResult& result);

}  // namespace rollfem::fem
