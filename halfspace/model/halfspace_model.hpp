// SPDX-License-Identifier: LGPL-2.1-or-later
// The model "halfspace": Kalker's problem on the case's contact grid for every load point.
#pragma once

#include "base/checkpoint.hpp"
#include "contact/solve/contact_run.hpp"
#include "contact/solve/model.hpp"
#include "halfspace/elasticity/preconditioned_elasticity.hpp"
#include "halfspace/patch/patch_search.hpp"

#include <functional>
#include <memory>
#include <string>

namespace rollfem::halfspace {

/// The half-space on a grid, for unlike materials with the uncoupled one.
std::unique_ptr<contact::Elasticity> halfspace_elasticity(const contact::Scene& scene,
                                                          const contact::ChartedGeometry& geometry,
                                                          const contact::ContactGrid& grid);
/// The same on half-spaces that are already known.
std::unique_ptr<contact::Elasticity> halfspace_elasticity_of(
    const contact::Scene& scene, const contact::ChartedGeometry& geometry, Halfspaces halfspaces);

/// Elasticity on the grids of a model: the half-space, or one preconditioned by a half-space.
struct GridElasticity {
  std::string model = "halfspace";  ///< in progress events and names of records
  std::function<std::unique_ptr<contact::Elasticity>(
      const contact::Scene&, const contact::ChartedGeometry&, const contact::ContactGrid&)>
      make = halfspace_elasticity;
  /// Adds subsurface stresses to a load point solved on the grid; empty: the stresses requested by
  /// the scene, for half-spaces.
  std::function<void(const contact::ContactGrid&, contact::PointResult&)> add_stresses = {};
  /// Load points do not start from each other, and may be left without a solution
  /// (contact::PartlySolved).
  bool independent_points = true;
};

/// Solves every load point; enlarges the grid when the patch touches its border; runs at a half and
/// a quarter of the resolution give the error bars, the former also the first guess. Includes the
/// subsurface stresses requested by the case. Load points of the finest grid are stored in the
/// `checkpoint` and restored from there (null: none). Throws contact::PartlySolved where friction
/// has no steady state at some load points.
contact::ModelResult run_halfspace(const contact::Scene& scene, const contact::Progress& progress,
                                   contact::Checkpoint* checkpoint = nullptr,
                                   const GridElasticity& elasticity = {});

/// The scene on a given number of elements across, without stresses and requested accuracy: for the
/// difference between two models. The grid of points from a file is kept.
contact::Scene on_few_elements(contact::Scene scene, int elements_across);

/// Refinement by contact elements: the grid of the case is the third of five levels.
contact::Refinement contact_grid();

// One resolution of the model "halfspace": the contact run on the half-space's elasticity. Every
// level starts from the next coarser one, which provides the first guess and the error estimate.

/// Solutions for a prescribed force must be more accurate than the search.
inline constexpr contact::ContactAccuracy accuracy_of_force_search{1e-8, {1e-7, 600, 5, true}};

/// Solves all load points with cells of dx by dy, on a larger grid when the patch reaches its
/// border. `area`: of this scene. `coarser` may be null. `stage_prefix` precedes the stage names of
/// the progress events. Load points are restored from the `checkpoint` (may be null) and stored
/// there.
contact::LevelResult solve_level(const contact::Scene& scene, const PatchSearch& area, double dx,
                                 double dy, const contact::LevelResult* coarser,
                                 const std::string& stage_prefix, const contact::Progress& progress,
                                 contact::Checkpoint* checkpoint = nullptr,
                                 const GridElasticity& elasticity = {});

}  // namespace rollfem::halfspace
