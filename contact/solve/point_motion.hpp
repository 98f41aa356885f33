// SPDX-License-Identifier: LGPL-2.1-or-later
// Motion of the surfaces at a load point: the rigid slip of steady rolling, or of a step of a shift
// or of transient rolling including the state inherited from earlier steps; and its description in
// results.
#pragma once

#include "contact/iteration/compliance.hpp"
#include "contact/solve/contact_problem.hpp"
#include "result/heat/temperature.hpp"
#include "result/result.hpp"
#include "scene/scene.hpp"

#include <Eigen/Core>

#include <array>
#include <optional>
#include <utility>

namespace rollfem::contact {

// State that a step of a shift or of transient rolling inherits from earlier steps: the
// displacement difference of the material points now in the patch. Each step is then a separate
// tangential problem, T = A_tt, with slip measured in mm (Kalker 1990, section 4.1).

/// Displacements of the last two steps, in the frame of the contact.
class History {
 public:
  /// `order`: of the difference in time of transient rolling. First: (u - u') over the step.
  /// Second: (3 u - 4 u' + u'')/2, which tends to the steady solution of second-order upwind
  /// differences; from the third of equal steps on, because the displacement may jump in the first
  /// step (a suddenly applied force) and u'' before the jump would make the second step overshoot.
  /// Shifts always use the previous step.
  History(const ContactGrid& grid, UpwindOrder order);

  // A step: |w'| = 0 in adhesion, w' = rigid_slip + A_tt p in mm, without the past of friction.

  /// A shift by `rigid_shift` (mm): w = W + u - u'.
  TangentialMotion shift_step(const TangentialField& rigid_shift) const;

  /// Rolling over `step_length` mm with the rigid slip s: w = step s + u(x) - u'(x + step). Throws
  /// InputError unless the step is positive.
  TangentialMotion rolling_step(const TangentialField& rigid_slip, double step_length) const;

  /// The step is solved: u = A p with all that caused it, and mu and u* of the elements where
  /// friction remembers. `step_length` 0 for a shift.
  void advance(const TangentialField& displacement, double step_length, FrictionPast after = {});

  /// A past in other places: displacements that the two last steps have left in the material now
  /// on the grid, the mm rolled in these steps, and mu and u* of this material.
  void inherit(TangentialField last, TangentialField before_last, std::array<double, 2> lengths,
               FrictionPast after);

  /// mu and u* of the particles that the next step brings to the elements: in a shift they stay.
  FrictionPast past(double step_length) const;

 private:
  ContactGrid grid_;
  UpwindOrder order_;
  TangentialField last_;
  TangentialField before_last_;
  FrictionPast after_;             ///< mu and u* after the last step
  double last_step_ = 0.0;         ///< mm rolled in the last step
  double before_last_step_ = 0.0;  ///< mm rolled in the step before
  bool arrived_ = false;           ///< the material is already where the next step brings it
};

/// mu and u* of the elements after a step under this law; that at rest and 0 where there is no
/// contact, and everywhere after no step.
FrictionPast friction_after(const Friction& friction, const ContactGrid& grid,
                            const ContactState& state = {});

/// Values at `distance` >= 0 upstream (+x) of every element, by cubics between the four nearest
/// elements of the row; beyond the grid the outermost value continues.
Field upstream(const ContactGrid& grid, const Field& values, double distance);

/// The scene's friction over the lateral coordinate of a grid in this geometry, which must outlive
/// it.
Friction friction_on(const Scene& scene, const ChartedGeometry& geometry);

class PointMotion {
 public:
  /// Scene and geometry must outlive this object.
  /// `inherited`: a past in other places (Scene::past).
  PointMotion(const Scene& scene, const ChartedGeometry& geometry, const ContactGrid& grid,
              const std::optional<History>& inherited = {});

  /// Slip in addition to that of the geometry; may be empty.
  void set_extra(TangentialField extra) { extra_ = std::move(extra); }

  /// Creepages xi, eta of load point k, or the shifts of a step, as given in the scene.
  Eigen::Vector2d given_unknowns(std::size_t k) const;

  /// The tangential problem of load point k with the given creepages or shifts instead.
  TangentialMotion at(std::size_t k, const Eigen::Vector2d& unknowns) const;

  /// Records the solved load point k: accumulates the motion, and writes it with step and creepages
  /// into `point`.
  void describe(std::size_t k, const Eigen::Vector2d& unknowns, PointResult& point);

  /// Sets the temperatures of the solved load point k of transient rolling, and keeps its heat for
  /// the next step.
  void warm(std::size_t k, PointResult& point);
  const HeatPast& heat() const { return heat_; }

  /// State that the next step inherits from load point k.
  void advance(std::size_t k, const ContactState& state);

  /// Records load point k as restored from an earlier run, which described it.
  void restore(const PointResult& point);

 private:
  struct Sum {
    double longitudinal = 0.0, lateral = 0.0, spin = 0.0, distance = 0.0;
  };

  /// `step`: length in mm of the corresponding difference.
  TangentialField rigid_slip(const Creepage& creepage, double step) const;

  const Scene& scene_;
  const ChartedGeometry& geometry_;
  ContactGrid grid_;
  TangentialField extra_;
  Friction friction_;  ///< null: no law, or one without memory of earlier steps
  History history_;
  HeatPast heat_;
  Field left_temperature_;  ///< of the next step
  Sum sum_;
  int steps_before_ = 0;  ///< of Scene::past
};

}  // namespace rollfem::contact
