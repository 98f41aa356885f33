// SPDX-License-Identifier: LGPL-2.1-or-later
// One contact of like half-spaces on one grid of few elements, in memory that is kept: its part of
// what quick_wheel.hpp solves.
#pragma once

#include "capi/peak_pressure.hpp"
#include "contact/iteration/friction_newton.hpp"
#include "contact/result/patch_size.hpp"
#include "contact/result/result.hpp"
#include "contact/scene/friction_law.hpp"
#include "contact/scene/geometry.hpp"
#include "contact/scene/scene.hpp"
#include "halfspace/elasticity/few_elements.hpp"
#include "halfspace/elasticity/few_elements_normal.hpp"
#include "track/search/contact_search.hpp"

#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace rollfem::capi {

/// A contact, or one that the load may reach, as the search has found it. The surface of its
/// geometry follows the bodies as far as the contact grid does (contact::ContactSurface).
struct QuickContact {
  const track::WheelRailContact* contact = nullptr;
  contact::Geometry geometry;
  contact::Creepage creepage;
};

/// Extents of a grid, mm.
struct GridBox {
  double length = 0.0;        ///< along x
  std::array<double, 2> y{};  ///< lower and upper end
  double middle_along_x = 0.0;
};

class QuickPatch {
 public:
  /// Elements around the patch on the grid: three that the differences and the border need, and one
  /// for what the search for the patch is off.
  static constexpr int margin = 4;

  /// On grids as large as the tables.
  QuickPatch(const halfspace::InfluenceTables& tables, const contact::CombinedMaterial& material);

  /// Takes a contact, which must outlive the work on it.
  void begin(const QuickContact& contact);
  const track::WheelRailContact& contact() const { return *given_->contact; }
  /// Of the load, y and z of the patch frame.
  const std::array<double, 2>& direction() const { return direction_; }
  /// Of the wheel, at which the bodies touch, mm along the load.
  double first_sinking() const;
  /// Where the bodies overlap as the search has it, or at a sinking.
  GridBox overlap() const;
  GridBox overlap_at(double sinking) const;

  /// Lays all elements over a box; false where the box is too narrow for the tables.
  bool lay_over(const GridBox& box);
  /// Lays the elements, but for the margin, over the patch as it was measured last.
  bool lay_on_patch();
  const contact::ContactGrid& grid() const { return grid_; }
  halfspace::NormalBlock block() const;
  /// Per element, between the bodies along the load before the wheel sinks, mm.
  const contact::Field& distance() const { return distance_; }

  /// Takes the forces along the load (N) of the elements.
  void press(const double* forces);
  bool has_pressure() const { return pressure_.maxCoeff() > 0.0; }
  bool touches_border() const { return contact::touches_border(grid_, pressure_); }
  bool is_one_region() const;
  /// Angle between the normals of the first and the last row under pressure, rad.
  double turn() const { return turn_of(*geometry_, grid_, pressure_); }
  /// Of the patch under the pressure.
  const contact::PatchSize& measure() { return size_ = contact::patch_size(grid_, pressure_); }

  /// Sets the tractions under the pressure, from what they are or, with `anew`, from adhesion all
  /// over; `keeps_weights`: at the leading edge. False when there are too many elements.
  bool rub(const contact::Friction& friction, bool anew, bool keeps_weights);
  /// Slip that the tractions of another patch cause on this one.
  void forget_neighbours();
  void add_slip_of(const QuickPatch& neighbour, const contact::CombinedMaterial& material);
  /// What the lateral tractions carry of the load, N.
  double load_of_friction() const;
  void scale(double factor);

  /// As far as that many elements beside those under pressure: both profiles are known, and no
  /// other contact begins.
  bool is_within_profiles(double elements) const;
  bool is_within_limits(double elements) const;

  /// What check_point looks at and the sums. `gap` and `displacement`: along the load, mm.
  void finish(const contact::Friction& friction, const double* gap, const double* displacement,
              double sinking);
  const contact::PointResult& point() const { return point_; }
  double max_pressure_bar() const { return max_pressure_bar_; }  ///< MPa

 private:
  bool reaches_only(const std::function<bool(double)>& good, double elements) const;
  double grid_place(double y) const;
  void lay(double dx, double x_middle, double y_middle);
  void fill_sums();

  const halfspace::InfluenceTables& tables_;
  const QuickContact* given_ = nullptr;
  std::array<double, 2> direction_{0.0, 1.0};
  std::optional<contact::ChartedGeometry> geometry_;
  const halfspace::InfluenceTable* table_ = nullptr;
  contact::ContactGrid grid_;
  /// Per row of the grid: y of the patch frame, climb of the surface and its cosine, the part of a
  /// pressure along the load, and that of a lateral traction.
  std::vector<double> place_, climb_, cosine_, carried_, of_lateral_;
  contact::PatchSize size_;
  contact::Field distance_, pressure_, weights_;
  contact::TangentialField own_slip_, slip_, traction_;
  std::vector<contact::NeighbourLoad> loads_;
  contact::PointResult point_;
  PeakPressure peak_;
  double max_pressure_bar_ = 0.0;
  contact::FrictionNewton newton_;
  halfspace::FewElementsRolling rolling_;
};

}  // namespace rollfem::capi
