// One patch of like half-spaces on one grid of few elements, in a few milliseconds and in memory
// that is kept: what rollfem.h solves nearly always.
#pragma once

#include "contact/iteration/bound_constrained_cg.hpp"
#include "contact/iteration/friction_newton.hpp"
#include "contact/result/patch_size.hpp"
#include "contact/result/result.hpp"
#include "contact/scene/friction_law.hpp"
#include "contact/scene/geometry.hpp"
#include "halfspace/elasticity/few_elements.hpp"
#include "track/search/contact_search.hpp"

#include <array>
#include <optional>
#include <vector>

namespace rollfem::capi {

/// A contact that carries the vertical load of its wheel alone.
struct QuickProblem {
  const track::WheelRailContact& contact;  ///< its geometry is that of `geometry`
  const contact::Geometry& geometry;
  contact::Creepage creepage;
  std::array<double, 2> direction{0.0, 1.0};  ///< of the load, y and z of the patch frame
  double force = 0.0;                         ///< N along it
  contact::Friction friction;
  double follows = 0.0;  ///< how far the grid follows the surface (contact::Scene::follows_surface)
};

class QuickPatch {
 public:
  /// Elements around the patch on the grid: three that the differences and the border need, and one
  /// for what the search for the patch is off.
  static constexpr int margin = 4;
  /// A grid with more across the patch is better solved by transforms.
  static constexpr int most_across = 20;

  /// Several regions in one plane share their grid, and need more elements than one: a patch of
  /// several is solved only with `most_across`.
  QuickPatch(const halfspace::InfluenceTables& tables, int across);

  /// Checked as every result is, kept until the next call. Null where the contact is one that the
  /// grid or this iteration does not hold: those are for the solvers of the model halfspace, which
  /// say why if they fail as well.
  const contact::PointResult* solve(const QuickProblem& problem);

 private:
  bool solve_or_throw(const QuickProblem& problem);
  std::optional<contact::PatchSize> find_patch(const QuickProblem& problem);
  bool solve_on(const QuickProblem& problem, const contact::ChartedGeometry& geometry);
  bool share_load(const QuickProblem& problem, const contact::Field& distance,
                  const contact::TangentialField& slip);
  void press(const contact::Field& distance, double force, double tolerance, bool anew);
  bool rub(const QuickProblem& problem, const contact::Field& weights,
           const contact::TangentialField& slip, bool anew);
  bool is_held(const QuickProblem& problem) const;
  double load_of_friction() const;
  void fill_fields(const QuickProblem& problem);
  void fill_sums(const QuickProblem& problem);

  const halfspace::InfluenceTables& tables_;
  int across_;
  const halfspace::InfluenceTable* table_ = nullptr;
  contact::ContactGrid grid_;
  /// Per row of the grid: y of the patch frame, climb of the surface and its cosine, and the part
  /// of a lateral traction along the load.
  std::vector<double> place_, climb_, cosine_, of_lateral_;
  contact::Field carried_;  ///< per element: part of a pressure along the load
  contact::Field pressure_;
  contact::TangentialField traction_;
  contact::PointResult point_;
  contact::BoundConstrainedCg normal_;
  contact::FrictionNewton newton_;
  halfspace::FewElementsRolling rolling_;
};

}  // namespace rollfem::capi
