// SPDX-License-Identifier: LGPL-2.1-or-later
// The semi-smooth Newton method of the friction problem (tangential.hpp) on the elements in
// contact, in memory reused from one problem to the next.
#pragma once

#include "contact/iteration/adhesion_fronts.hpp"
#include "contact/iteration/friction_state.hpp"
#include "contact/iteration/gmres.hpp"
#include "contact/iteration/linearisation.hpp"
#include "contact/iteration/tangential.hpp"

#include <initializer_list>
#include <optional>
#include <vector>

namespace rollfem::contact {

class FrictionNewton {
 public:
  /// `places`: grid indices of the elements in contact. `start`: initial tractions, empty for the
  /// projected full-stick solution. Throws SolveError when it does not converge, NoSteadyFriction
  /// when there is no stable solution.
  FrictionEffort solve(ElementOperator& compliance, const ContactGrid& grid,
                       const TangentialProblem& problem, const std::vector<Eigen::Index>& places,
                       const TangentialOptions& options, const TangentialField& start);

  /// Derivative of the tractions by the rigid slip, both on the elements in contact, times a change
  /// of slip. Call it after solve(), with its arguments still alive. False if the linear system
  /// does not converge.
  bool respond(const Eigen::Ref<const Eigen::VectorXd>& slip_change,
               Eigen::Ref<Eigen::VectorXd> change);

  /// Tractions of the elements in contact, within the bound to the tolerance; not projected,
  /// because that would hide the remaining error.
  const Eigen::Map<Eigen::VectorXd>& traction() const { return point_->traction; }
  const Eigen::Map<Eigen::VectorXd>& bound() const { return point_->bound; }
  const Eigen::Map<Eigen::VectorXd>& slip() const { return point_->slip; }
  const std::vector<char>& adheres() const { return at_.adheres; }
  const FrictionState& state() const { return state_; }

 private:
  using Vector = Eigen::Map<Eigen::VectorXd>;
  using Index = Eigen::Index;

  /// F(p) = p - Proj_{|.|<=g}(p - r w(p)) and the data of its generalised Jacobian.
  struct Point {
    Vector traction{nullptr, 0};
    Vector slip{nullptr, 0};
    Vector value{nullptr, 0};  ///< F, MPa
    Vector trial{nullptr, 0};  ///< q = p - r w
    Vector bound{nullptr, 0};  ///< g; at rest if the law is independent of slip
    double norm = 0.0;         ///< of F
  };

  bool feels_slip() const { return feels_slip_ && bound_relaxation_ > 0.0; }
  void lay_out(Index count);
  void gather(const TangentialField& field, Vector& values) const;
  bool iterate(double scale, double tolerance);
  // Choice of a solution where friction falls so steeply that there are several, and its stability.
  bool falls_steeply();
  bool follow_bounds(double scale);
  bool iterate_briefly(double scale, double tolerance);
  bool finish(double scale, double near);
  bool finish_from_first(double scale);
  void feed_back(const Eigen::VectorXd& change);
  bool stays();
  [[noreturn]] void fail(double scale) const;
  void project(Vector& traction, const Vector& bound) const;
  void set_drag(double drag);
  void evaluate(Point& point);
  void evaluate_from_traction(Point& point);
  void evaluate_at_rest(Point& point);
  void find_first_point(const TangentialField& start);
  void stick_fully(Point& point);
  void linearise(const Point& point);
  /// The linearisation for the preconditioner, in which stiff layers adhere.
  const Linearisation& preconditioned() {
    if (!feels_slip() || !state_.hardens()) return at_;
    nearly_ = at_;
    state_.add_stiff(nearly_.adheres);
    return nearly_;
  }
  void apply_jacobian(const Gmres::Given& p, Gmres::Vector result);
  void change_value(const Gmres::Given& p, Gmres::Vector change);
  /// Solution of J x = right_ after linearise().
  GmresResult invert_jacobian(double tolerance, int most_iterations, Gmres::Vector solution);
  double forcing(double residual, double previous) const;
  void find_direction(double tolerance);
  bool advance(double residual, double previous);
  bool step_along(double residual, double previous);

  /// Length of a GMRES cycle before it restarts; bounds the memory.
  static constexpr int krylov_restart = 80;

  ElementOperator* compliance_ = nullptr;
  const ContactGrid* grid_ = nullptr;
  const TangentialProblem* problem_ = nullptr;
  const std::vector<Index>* places_ = nullptr;
  const TangentialOptions* options_ = nullptr;
  double r_ = 1.0;
  Index count_ = 0;
  FrictionState state_;
  bool feels_slip_ = false;
  /// Fraction by which bounds move from lagged_bound_ to the bounds of the slip; 0: they stay.
  double bound_relaxation_ = 1.0;
  Eigen::VectorXd lagged_bound_;
  Eigen::VectorXd first_;  ///< tractions of the first point
  double drag_ = 0.0;      ///< c in w + c (p - p'), of the unit of T
  Eigen::VectorXd memory_;
  Vector rigid_slip_{nullptr, 0};
  Vector bound_{nullptr, 0};         ///< g at rest
  Vector dragged_from_{nullptr, 0};  ///< p'
  Vector direction_{nullptr, 0}, slip_change_{nullptr, 0}, right_{nullptr, 0};
  Vector trial_change_{nullptr, 0};  ///< r times that of q
  Vector bound_change_{nullptr, 0};  ///< where the law feels slip
  Point points_[2];
  Point *point_ = &points_[0], *trial_ = &points_[1];
  Linearisation at_, nearly_;
  AdhesionFronts fronts_;
  Gmres gmres_;
  FrictionEffort effort_;
  bool preconditioner_failed_ = false;  ///< the full preconditioner has failed once
  bool steep_ = false;                  ///< several solutions are possible
  Index most_changed_element_ = 0;      ///< element whose bound changed most in the last round
};

/// Bounds and states of the elements that a solver has solved, and what their particles carry on.
/// `places`: their indices on the grid of result.traction.
void set_states(const FrictionNewton& newton, const std::vector<Eigen::Index>& places,
                const Friction& law, const ContactGrid& grid, TangentialSolution& result);

}  // namespace rollfem::contact
