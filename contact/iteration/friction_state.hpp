// SPDX-License-Identifier: LGPL-2.1-or-later
// The traction bounds of the contact elements under slip, and how they change with it. Where
// friction remembers (FrictionMemory), mu is a state that the material carries: in steady rolling
// from element to element of a row, from that at rest at the leading edge; in a step of a history
// from what the particle had before. Both are implicit in the slip, so that Newton's method sees
// how slip upstream changes the bounds downstream: the derivative is a bidiagonal system per row.
// The plastic displacement of a layer that hardens or softens (Plasticity) is carried likewise.
// Where mu follows the temperature, heat from all elements ahead in the row warms an element, so
// that the derivative is a triangular system per row.
#pragma once

#include "base/grid.hpp"
#include "scene/friction_law.hpp"

#include <optional>
#include <string>
#include <vector>

namespace rollfem::contact {

/// mu and u* of the particles before a step of a history.
struct FrictionPast {
  Field coefficient;    ///< of the particle that comes to each element; empty: steady rolling
  double length = 0.0;  ///< mm rolled in the step, 1 in a shift
  Field plastic{};      ///< u*, mm; may be empty where no yield stress changes
  Field temperature{};  ///< degC by the heat of earlier steps, where mu follows it; else empty
};

/// Result of the tangential operator: slip of steady rolling or relative displacement.
enum class Motion {
  rolling,  ///< slip w = s + D u, without a unit
  shift,    ///< slip w = s + u in mm: a step of a shift or of transient rolling
};

/// Motion of the surfaces in steady rolling or in one step of a history: from the load point
/// (PointMotion) down to Newton's method.
struct TangentialMotion {
  TangentialField rigid_slip;  ///< s, no unit in steady rolling, mm for Motion::shift
  Motion motion = Motion::rolling;
  /// Slip of the results and of the friction law divided by w: 1 in steady rolling and for a shift
  /// (mm slipped in the step), 1/mm for a step of rolling (slip relative to the rolling speed).
  double slip_factor = 1.0;
  double curvature_weight = 1.0;  ///< factor of Response::curvature_slip in the slip of the problem
  std::optional<FrictionPast> past{};  ///< of a step, where friction remembers; else empty
};

/// The problem of friction on a known pressure (tangential.hpp).
struct TangentialProblem {
  Field pressure;           ///< p_n >= 0, MPa; 0 outside the contact area
  TangentialMotion motion;  ///< with any defect of the compliance added to the rigid slip
  Friction friction;        ///< null: frictionless; no default, so that it is never forgotten
};

/// Largest fall of mu with |w| in an element that the material crosses in `way`, mm: friction with
/// memory follows only a part of the slip.
double steepest_fall(const FrictionLaw& law, double way,
                     const std::optional<FrictionMemory>& memory);

/// Largest ratio of the slip that an element of this compliance (slip per own traction, 1/MPa) and
/// pressure gains through falling friction to the slip that makes friction fall; `way`: as in
/// FrictionMemory. Above 1 the element may have several states.
double steepness(const FrictionLaw& law, double pressure, double compliance, double way);

/// From this steepness on there may be several solutions.
inline constexpr double steep = 0.5;

/// Why a law may have several or no steady states, and the remedy: for messages.
struct SteepCause {
  std::string cause;  ///< without "that ..."
  std::string cure;
};
/// `way`, mm: from element to element, or of a step, in which the law has this steepness; 0:
/// unknown.
SteepCause steep_cause(const FrictionLaw& law, double steepness, double way);

// How a layer between the bodies yields (Plasticity) while a particle moves from one contact
// element to the next, or in a step of a history: the plastic displacement u* that it has gathered.

/// State of a particle, slip and friction at both ends of its way to an element.
struct YieldStep {
  double before = 0.0;          ///< u* at the beginning, mm
  double way = 0.0;             ///< mm rolled, 1 in a shift
  double slip = 0.0;            ///< |w| at the end, as results give it
  double slip_ahead = 0.0;      ///< the same at the beginning
  double friction = 0.0;        ///< mu p_n at rest at the end, MPa
  double friction_ahead = 0.0;  ///< the same at the beginning; as at the end: only the end counts
};

/// u* at the end if the layer yields there, with derivatives.
struct PlasticDisplacement {
  double value = 0.0;  ///< mm
  double by_slip = 0.0;
  double by_slip_ahead = 0.0;
  double by_before = 1.0;
};

/// u* grows by the integral of |w| (trapezoidal rule: second order) over the part of the way in
/// which the yield stress is below the friction. The square of the friction is taken as linear over
/// the way, which pressures are at the edge of the patch.
PlasticDisplacement yielding(const Plasticity& layer, const YieldStep& step);

class FrictionState {
 public:
  using Index = Eigen::Index;
  using Given = Eigen::Ref<const Eigen::VectorXd>;
  using Vector = Eigen::Ref<Eigen::VectorXd>;

  /// `places`: grid indices of the elements in contact, ascending. All arguments must outlive the
  /// state. `r`: of q = p - r w below; 0: bounds follow the slip alone.
  void begin(const ContactGrid& grid, const TangentialProblem& problem,
             const std::vector<Eigen::Index>& places, double r = 0.0);

  bool feels_slip() const { return law_->feels_slip() || hardens(); }

  /// Largest steepness over the elements; `compliance`: slip of the problem per own traction.
  double steepness(double compliance) const;

  /// g at rest.
  void set_rest(Vector bound) const;

  /// Whether yielding bounds the element, rather than friction; at the slip of the last call.
  bool yields(Index e) const;
  /// mu and u* that the particles have there: what the next step begins with.
  double coefficient(Index e) const { return coefficient_[e]; }
  double plastic(Index e) const { return yield_[static_cast<std::size_t>(e)].plastic; }
  bool has_memory() const { return feels_slip() && memory_.has_value(); }
  /// Whether the yield stress depends on u*.
  bool hardens() const { return plasticity_ && plasticity_->hardening != 0.0; }
  bool softens() const { return plasticity_ && plasticity_->hardening < 0.0; }

  /// g under a slip of the problem, its x components before its y components, and q likewise: where
  /// a layer hardens, g + k h |w|, the element's own slip follows from |q| = g + r |w|, which is
  /// well scaled however large k is, and the same in a solution.
  void set_bound(const Given& slip, const Given& trial, Vector bound);
  /// Prepares `change` at a slip.
  void linearise(const Given& slip, const Given& trial);
  /// Marks elements whose layer hardens so fast that they nearly adhere.
  void add_stiff(std::vector<char>& adheres) const;
  /// Change of g with that of the slip and of q.
  void change(const Given& slip_change, const Given& trial_change, Vector bound_change) const;

 private:
  /// Law (mu_s) and rate of an element, on which the element behind it depends.
  struct Ahead {
    FrictionLaw::Coefficient law;
    double rate = 0.0, rate_by_slip = 0.0;
  };
  /// An element under the yield stress, with derivatives of u*.
  struct Yield {
    bool yields = false;
    double plastic = 0.0, by_own = 0.0, by_ahead = 0.0, carried = 0.0, by_coefficient = 0.0;
    double by_trial = 0.0;
    double stress = 0.0, stress_by_plastic = 0.0;
  };

  double pressure(Index e) const {
    return problem_->pressure[(*places_)[static_cast<std::size_t>(e)]];
  }
  double slip_at(const Given& slip, Index e) const;
  /// The law of the element.
  const FrictionLaw& law(Index e) const {
    if (rows_.empty()) return *law_;
    return *rows_[static_cast<std::size_t>((*places_)[static_cast<std::size_t>(e)] / grid_->nx)];
  }
  double friction_at_rest(Index e) const { return rest_[e] * pressure(e); }
  void find_ways();
  /// u* with which the particle comes.
  double plastic_before(Index e) const;
  /// tau_c, MPa; at least a tiny fraction of `friction`, so that the traction keeps a direction.
  double yield_stress(double plastic, double friction) const;
  /// Computes mu and u* of all elements, with their derivatives.
  void follow(const Given& slip, const Given& trial);
  Ahead follow_friction(Index e, double size, const Ahead& ahead,
                        const FrictionLaw::Coefficient& own);
  Ahead follow_temperature(Index e, double size, const Ahead& ahead);
  /// Temperature before the slip of the steady state or of the step warms the element, degC.
  double cold(Index e) const;
  /// Sum over the elements ahead in the row of their warming times `flows`, K.
  double warmed(Index e, const Eigen::VectorXd& flows) const;
  void follow_yield(Index e, double size, double size_ahead, double trial);

  const ContactGrid* grid_ = nullptr;
  const TangentialProblem* problem_ = nullptr;
  const FrictionLaw* law_ = nullptr;
  const std::vector<Index>* places_ = nullptr;
  Index count_ = 0;
  double r_ = 0.0;
  std::vector<Friction> rows_;  ///< the law of each row of the grid; empty: one law
  Eigen::VectorXd rest_;        ///< mu of the elements at rest
  std::optional<FrictionMemory> memory_;
  std::optional<Plasticity> plasticity_;
  Eigen::VectorXd ways_;     ///< mm from the element ahead or the leading edge, or of the step
  std::vector<char> leads_;  ///< nothing of the row is ahead, or the particle brings its own mu
  Eigen::VectorXd coefficient_;
  Eigen::VectorXd by_own_, by_ahead_, carried_;  ///< dmu/d|w|, dmu/d|w ahead|, dmu/dmu ahead
  std::vector<Yield> yield_;                     ///< empty: no plasticity
  // Where mu follows the temperature; otherwise empty.
  /// K by g |w|, MPa, over the distance in elements that material passes in the step.
  Eigen::VectorXd warming_;
  Eigen::VectorXd sizes_, flow_;       ///< |w|, g |w|
  Eigen::VectorXd by_temperature_;     ///< dmu_s/dT of the law, 1/K
  Eigen::VectorXd part_, part_ahead_;  ///< of mu_s of the element and of that ahead in mu
  mutable Eigen::VectorXd flow_change_;
  Eigen::VectorXd direction_;        ///< w/|w| times slip_factor
  Eigen::VectorXd trial_direction_;  ///< q/|q|; empty: no plasticity
};

}  // namespace rollfem::contact
