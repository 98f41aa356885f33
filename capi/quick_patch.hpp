// One patch of like half-spaces on one grid of few elements, in a few milliseconds and in memory
// that is kept: what rollfem.h solves nearly always.
#pragma once

#include "capi/influence_tables.hpp"
#include "capi/pressure_solver.hpp"
#include "capi/traction_solver.hpp"
#include "contact/result/patch_size.hpp"
#include "contact/scene/geometry.hpp"
#include "track/search/contact_search.hpp"

#include <array>
#include <optional>
#include <vector>

namespace rollfem::capi {

/// What is told of a patch: signs and frame as contact::PointResult has them.
struct PatchForces {
  contact::Creepage creepage;
  double normal_force = 0.0, longitudinal_force = 0.0, lateral_force = 0.0;  ///< N
  double spin_moment = 0.0;                                                  ///< N mm
  double length = 0.0, width = 0.0;                                          ///< mm
  double area = 0.0, adhesion_area = 0.0;                                    ///< mm^2
  double max_pressure = 0.0;                                                 ///< MPa
};

/// A contact that carries the vertical load of its wheel alone.
struct QuickProblem {
  const track::WheelRailContact& contact;  ///< its geometry is that of `geometry`
  const contact::Geometry& geometry;
  contact::Creepage creepage;
  std::array<double, 2> direction{0.0, 1.0};  ///< of the load, y and z of the patch frame
  double force = 0.0;                         ///< N along it
  double friction = 0.0;
  double follows = 0.0;  ///< how far the grid follows the surface (contact::Scene::follows_surface)
};

class QuickPatch {
 public:
  /// Elements around the patch on the grid: three that the differences and the border need, and one
  /// for what the search for the patch is off.
  static constexpr int margin = 4;
  /// A grid with more across the patch is better solved by transforms.
  static constexpr int most_across = 20;

  QuickPatch(const InfluenceTables& tables, int across);

  /// Nothing where the contact has several regions, or one that the grid or this iteration does not
  /// hold: those are for the solvers of the model halfspace, which say why if they fail as well.
  std::optional<PatchForces> solve(const QuickProblem& problem);

 private:
  std::optional<contact::PatchSize> find_patch(const QuickProblem& problem);
  bool solve_on(const QuickProblem& problem, const contact::ChartedGeometry& geometry);
  bool share_load(const QuickProblem& problem, const contact::Field& distance,
                  const contact::TangentialField& slip);
  bool is_held(const QuickProblem& problem) const;
  double load_of_friction() const;
  PatchForces forces(const QuickProblem& problem) const;

  const InfluenceTables& tables_;
  int across_;
  const InfluenceTable* table_ = nullptr;
  contact::ContactGrid grid_;
  /// Per row of the grid: y of the patch frame, climb of the surface and its cosine, and the parts
  /// of a pressure and of a lateral traction along the load.
  std::vector<double> place_, climb_, cosine_, carried_, of_lateral_;
  PressureSolver pressure_;
  TractionSolver tractions_;
};

}  // namespace rollfem::capi
