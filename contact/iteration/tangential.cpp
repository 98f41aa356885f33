// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/iteration/tangential.hpp"

#include "base/pieces.hpp"
#include "contact/iteration/friction_newton.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace rollfem::contact {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

void check_problem(const TangentialOperator& compliance, const TangentialProblem& problem) {
  const int n = compliance.grid().size();
  const TangentialField& slip = problem.motion.rigid_slip;
  if (problem.pressure.size() != n || slip.x.size() != n || slip.y.size() != n)
    throw SolveError(
        "tangential problem: pressure and rigid slip must be given for every contact element");
  if (!problem.pressure.allFinite() || problem.pressure.minCoeff() < 0.0)
    throw SolveError("tangential problem: the pressure must be finite and not negative");
  if (!slip.x.allFinite() || !slip.y.allFinite())
    throw SolveError("tangential problem: the rigid slip is not finite everywhere");
}

/// Shift in adhesion that keeps the inverse bounded where the symbol of T almost vanishes, as for
/// tractions that alternate from row to row.
constexpr double least_shift = 1e-3;

/// A tangential operator of the whole grid, with an approximate inverse of the Jacobian J that
/// remains effective as the grid is refined, block by block: r T + drag where elements adhere, then
/// r T + drag + (|q| / g - 1) across the slip where they slip, with the tractions of the first
/// inserted, the identity along the slip. Both blocks are inverted as if they covered the whole
/// grid.
class GridElements : public ElementOperator {
 public:
  /// Elements with positive `bound`.
  GridElements(const TangentialOperator& compliance, const Field& bound)
      : compliance_(compliance), grid_size_(bound.size()) {
    for (Index k = 0; k < bound.size(); ++k)
      if (bound[k] > 0.0) places_.push_back(k);
  }

  Index count() const { return static_cast<Index>(places_.size()); }
  /// Grid indices, in order.
  const std::vector<Index>& places() const { return places_; }
  /// Zero on all other elements.
  TangentialField scattered(const Given& values) const;

  double diagonal() const override { return compliance_.diagonal(); }
  void apply(const Given& p, Vector result) override {
    gather(compliance_.apply(scattered(p)), result);
  }
  void linearise(const Linearisation& at, double r, double drag) override;
  void precondition(const Given& p, Vector result) override;
  /// With the identity in all directions where elements slip.
  void precondition_robustly(const Given& p, Vector result) override;

 private:
  bool slips(Index e) const { return !at_->adheres[static_cast<std::size_t>(e)]; }
  void gather(const TangentialField& field, Vector values) const;
  /// Replaces values by the inverse of r T + shift times them.
  void invert(Vector values, double shift) const {
    gather(compliance_.precondition(scattered(values), r_, shift), values);
  }
  void adhering(const Given& p, Vector result) const;
  void add_across(const Given& p, Vector result) const;

  const TangentialOperator& compliance_;
  Index grid_size_;
  std::vector<Index> places_;
  const Linearisation* at_ = nullptr;
  double r_ = 0.0;
  double drag_ = 0.0;
  Index slipping_ = 0;
  double damping_ = 0.0;  ///< geometric mean of |q| / g - 1 over the slipping elements
  VectorXd scale_;        ///< symmetric scaling to the common damping of slipping elements
};

void GridElements::gather(const TangentialField& field, Vector values) const {
  for_each_element(count(), [&](Index e) {
    const Index k = places_[static_cast<std::size_t>(e)];
    values[e] = field.x[k];
    values[count() + e] = field.y[k];
  });
}

TangentialField GridElements::scattered(const Given& values) const {
  TangentialField field{Field(grid_size_), Field(grid_size_)};
  in_pieces(grid_size_, [&](Index first, Index size) {
    field.x.segment(first, size).setZero();
    field.y.segment(first, size).setZero();
  });
  for_each_element(count(), [&](Index e) {
    const Index k = places_[static_cast<std::size_t>(e)];
    field.x[k] = values[e];
    field.y[k] = values[count() + e];
  });
  return field;
}

void GridElements::linearise(const Linearisation& at, double r, double drag) {
  at_ = &at;
  r_ = r;
  drag_ = drag;
  slipping_ = std::count(at.adheres.begin(), at.adheres.end(), 0);
  if (slipping_ == 0) return;
  scale_ = VectorXd::Ones(count());
  double logarithms = 0.0;
  for (Index e = 0; e < count(); ++e) {
    if (!slips(e)) continue;
    scale_[e] = std::max(1.0 / at.factor[e] - 1.0, least_shift);
    logarithms += std::log2(scale_[e]);
  }
  // A power of two, so that the next step may reuse the shift and its inverse.
  damping_ = std::exp2(std::round(logarithms / static_cast<double>(slipping_)));
  scale_ = ((1.0 + damping_) / (1.0 + scale_.array())).sqrt();
}

void GridElements::precondition(const Given& p, Vector result) {
  adhering(p, result);
  if (slipping_ > 0) add_across(p, result);
}

void GridElements::precondition_robustly(const Given& p, Vector result) {
  adhering(p, result);
  for (Index e = 0; e < count(); ++e) {
    if (!slips(e)) continue;
    result[e] = p[e];
    result[count() + e] = p[count() + e];
  }
}

/// The circulant where elements adhere, the part along the slip where they slip.
void GridElements::adhering(const Given& p, Vector result) const {
  result = p;
  if (slipping_ < count()) {
    for_each_element(count(), [&](Index e) {
      if (slips(e)) result[e] = result[count() + e] = 0.0;
    });
    invert(result, least_shift + drag_);
  }
  for_each_element(count(), [&](Index e) {
    if (!slips(e)) return;
    const Index f = count() + e;
    const double along = at_->normal[e] * p[e] + at_->normal[f] * p[f];
    result[e] = at_->normal[e] * along;
    result[f] = at_->normal[f] * along;
  });
}

void GridElements::add_across(const Given& p, Vector result) const {
  VectorXd known(2 * count());
  gather(compliance_.apply(scattered(result)), known);
  known *= r_;
  VectorXd rest = VectorXd::Zero(2 * count());
  for_each_element(count(), [&](Index e) {
    if (!slips(e)) return;
    const Index f = count() + e;
    const double x = p[e] / at_->factor[e] - known[e];
    const double y = p[f] / at_->factor[e] - known[f];
    const double across = scale_[e] * (at_->normal[e] * y - at_->normal[f] * x);
    rest[e] = -at_->normal[f] * across;
    rest[f] = at_->normal[e] * across;
  });
  invert(rest, damping_ + drag_);
  for_each_element(count(), [&](Index e) {
    if (!slips(e)) return;
    const Index f = count() + e;
    const double across = scale_[e] * (at_->normal[e] * rest[f] - at_->normal[f] * rest[e]);
    result[e] -= at_->normal[f] * across;
    result[f] += at_->normal[e] * across;
  });
}

}  // namespace

void set_states(const FrictionNewton& newton, const std::vector<Index>& places, const Friction& law,
                const ContactGrid& grid, TangentialSolution& result) {
  const Index size = result.traction.x.size();
  const FrictionState& friction = newton.state();
  result.bound = Field::Zero(size);
  result.state.assign(static_cast<std::size_t>(size), ElementState::exterior);
  if (friction.has_memory()) result.coefficient = coefficients_of(law, grid);
  if (friction.hardens()) result.plastic = Field::Zero(size);
  for (Index e = 0; e < static_cast<Index>(places.size()); ++e) {
    const Index k = places[static_cast<std::size_t>(e)];
    const bool adheres = newton.adheres()[static_cast<std::size_t>(e)];
    result.bound[k] = newton.bound()[e];
    result.state[static_cast<std::size_t>(k)] = adheres              ? ElementState::adhesion
                                                : friction.yields(e) ? ElementState::plastic
                                                                     : ElementState::slip;
    if (friction.has_memory()) result.coefficient[k] = friction.coefficient(e);
    if (friction.hardens()) result.plastic[k] = friction.plastic(e);
  }
}

TangentialSolution solve_tangential(const TangentialOperator& compliance,
                                    const TangentialProblem& problem,
                                    const TangentialOptions& options,
                                    const TangentialField& start) {
  check_problem(compliance, problem);
  GridElements elements(compliance,
                        traction_bound(problem.friction, compliance.grid(), problem.pressure));
  FrictionNewton newton;
  TangentialSolution result;
  static_cast<FrictionEffort&>(result) =
      newton.solve(elements, compliance.grid(), problem, elements.places(), options, start);
  result.traction = elements.scattered(newton.traction());
  const TangentialField displacement = compliance.apply(result.traction);
  const TangentialField& rigid_slip = problem.motion.rigid_slip;
  result.slip = {rigid_slip.x + displacement.x, rigid_slip.y + displacement.y};
  set_states(newton, elements.places(), problem.friction, compliance.grid(), result);
  return result;
}

}  // namespace rollfem::contact
