// SPDX-License-Identifier: LGPL-2.1-or-later
// One contact of half-spaces of like material on one coarse grid, in reused memory: a part of the
// problem of quick_wheel.hpp.
#pragma once

#include "contact/iteration/friction_newton.hpp"
#include "contact/iteration/leading_edge.hpp"
#include "halfspace/elasticity/few_elements.hpp"
#include "halfspace/patch/peak_pressure.hpp"
#include "result/patch_size.hpp"
#include "result/result.hpp"
#include "scene/friction_law.hpp"
#include "scene/geometry.hpp"
#include "scene/scene.hpp"

#include <array>
#include <optional>
#include <vector>

namespace rollfem::halfspace {

/// Entries of PatchSums.
struct PatchSum {
  enum { longitudinal, lateral, normal, lateral_pressure, spin_moment, count };
};
/// Resultants of the tractions of a patch on the wheel, in the patch frame, or their derivatives:
/// N, the moment in N mm.
using PatchSums = Eigen::Matrix<double, PatchSum::count, 1>;
/// Derivatives of these sums by xi, eta and phi.
using SumsByCreepage = Eigen::Matrix<double, PatchSum::count, 3>;

/// A contact of the wheel, or a near one that closes under load. The surface of its geometry
/// follows the bodies over the extent of the contact grid (contact::ContactSurface).
struct QuickContact {
  std::size_t number = 0;  ///< the caller's
  contact::ContactPlace place;
  contact::Geometry geometry;
  contact::Creepage creepage;
  double approach = 0.0;  ///< mm, an estimate along the normal
  /// Range of y in the patch frame over which the bodies overlap at this approach.
  std::array<double, 2> reach{};
  bool reserve = false;  ///< beyond the estimated sinking
};

/// Extents of a grid, mm.
struct GridBox {
  double length = 0.0;        ///< along x
  std::array<double, 2> y{};  ///< lower and upper end
  double middle_along_x = 0.0;

  void grow(double factor) {
    const double more = 0.5 * (factor - 1.0) * (y[1] - y[0]);
    length *= factor;
    y = {y[0] - more, y[1] + more};
  }
};

class QuickPatch {
 public:
  /// Elements around the patch on the grid: three for the differences and the border, one for the
  /// error of the search for the patch.
  static constexpr int margin = 4;

  /// Uses grids as large as the tables.
  QuickPatch(const InfluenceTables& tables, const contact::CombinedMaterial& material);

  /// Starts with a contact, which must outlive the solution, and the box of its overlap according
  /// to the search.
  void begin(const QuickContact& contact);
  const QuickContact& given() const { return *given_; }
  /// Direction of the load, y and z in the patch frame.
  const std::array<double, 2>& direction() const { return direction_; }
  /// Sinking of the wheel at which the bodies touch, mm along the load.
  double first_sinking() const;
  /// Takes the box of the overlap of the bodies at this sinking.
  void reach_to(double sinking);

  GridBox box;  ///< of the grid on which the patch is searched
  /// Covers the box with all elements; false if it is too narrow for the tables.
  bool lay_over_box();
  /// Covers the last measured patch with the elements inside the margin.
  bool lay_on_patch();
  const contact::ContactGrid& grid() const { return grid_; }
  NormalBlock block() const;
  /// Undeformed distance per element along the load before the wheel sinks, mm.
  const contact::Field& distance() const { return distance_; }

  /// Sets the forces of the elements along the load, N.
  void set_forces(const double* forces);
  bool has_pressure() const { return problem_.pressure.maxCoeff() > 0.0; }
  bool touches_border() const { return contact::touches_border(grid_, problem_.pressure); }
  bool is_one_region() const;
  /// Angle between the normals of the first and the last row under pressure, rad.
  double turn() const { return turn_of(*geometry_, grid_, problem_.pressure); }
  /// Measures the patch under the present pressure.
  const contact::PatchSize& measure() {
    return size_ = contact::patch_size(grid_, problem_.pressure);
  }

  /// Solves for the tractions under the present pressure, starting from the present tractions or,
  /// with `anew`, from full adhesion; `keeps_weights`: keeps the weights at the leading edge. False
  /// if there are too many elements.
  bool solve_friction(const contact::Friction& friction, bool anew, bool keeps_weights);
  /// Slip on this patch caused by the tractions of other patches, and its displacement along the
  /// load by their friction.
  void forget_neighbours();
  void add_neighbour(const QuickPatch& neighbour, const contact::CombinedMaterial& material);
  /// Part of the load carried by the lateral tractions, N.
  double load_of_friction() const;
  void scale(double factor);

  /// True if `good` holds within this many elements beside the loaded ones: both profiles are known
  /// (PatchGeometry::known), or no other contact begins (within_limits).
  bool reaches_only(bool (contact::PatchGeometry::*good)(double) const, double elements) const;

  /// Computes the sums, the largest pressure with its bar and the data for check_point. `gap` and
  /// `displacement`: along the load, mm.
  void finish(const contact::Friction& friction, const double* gap, const double* displacement,
              double sinking);
  /// Sets the works and temperatures of the finished point.
  void warm(const contact::SurfaceHeat& heat);
  const contact::PointResult& point() const { return point_; }
  /// Resultants of the present pressure and tractions.
  PatchSums sums() const { return sum(&problem_.pressure, traction_); }
  /// Derivatives of the friction forces by xi, eta and phi at fixed pressure, from the linearised
  /// friction problem. False if its linear systems do not converge.
  bool respond(SumsByCreepage& by_creepage);

 private:
  double grid_place(double y) const;
  bool place_grid(double dx, double dy, double x_middle, double y_middle);
  PatchSums sum(const contact::Field* pressure, const contact::TangentialField& traction) const;
  void spread(const Eigen::Ref<const Eigen::VectorXd>& of_elements,
              contact::TangentialField& field) const;

  const InfluenceTables& tables_;
  const QuickContact* given_ = nullptr;
  std::array<double, 2> direction_{0.0, 1.0};
  std::optional<contact::ChartedGeometry> geometry_;
  double layer_;          ///< its compliance between the bodies, mm/MPa
  InfluenceTable table_;  ///< of the elements of the grid
  contact::ContactGrid grid_;
  /// Per row of the grid: y in the patch frame, inclination of the surface and its cosine, and the
  /// components along the load of unit pressure and unit lateral traction.
  Eigen::ArrayXd place_, climb_, cosine_, carried_, of_lateral_;
  contact::PatchSize size_;
  contact::GridRuns runs_;
  contact::Field own_distance_, moved_, distance_, weights_;
  contact::TangentialField own_slip_, traction_, change_;
  Eigen::VectorXd slip_change_, traction_change_;  ///< on the elements in contact
  std::vector<contact::NeighbourLoad> loads_;
  contact::PointResult point_;
  PeakPressure peak_;
  contact::TangentialProblem problem_;
  contact::FrictionNewton newton_;
  FewElementsRolling rolling_;
};

}  // namespace rollfem::halfspace
