// SPDX-License-Identifier: LGPL-2.1-or-later
// The traction bounds of the contact elements under slip, and how they change with it. Where
// friction remembers (FrictionMemory), mu is a state that the material carries: in steady rolling
// from element to element of a row, from that at rest at the leading edge; in a step of a history
// from what the particle had before. Both are implicit in the slip, so that Newton's method sees
// how slip upstream changes the bounds downstream: the derivative is a bidiagonal system per row.
#pragma once

#include "contact/base/grid.hpp"
#include "contact/scene/friction_law.hpp"

#include <optional>
#include <vector>

namespace rollfem::contact {

/// mu of the particles before a step of a history.
struct FrictionPast {
  Field coefficient;    ///< of the particle that comes to each element; empty: steady rolling
  double length = 0.0;  ///< mm rolled in the step, 1 in a shift
};

/// The problem of friction on a known pressure (tangential.hpp).
struct FrictionProblem {
  const ContactGrid& grid;
  const Field& pressure;
  const TangentialField& rigid_slip;
  const FrictionLaw& law;
  double slip_factor = 1.0;            ///< slip as the law takes it over that of the problem
  const FrictionPast* past = nullptr;  ///< null: steady rolling
};

/// How much slip an element of this compliance (slip per own traction, 1/MPa) and pressure gains at
/// most by the friction that it loses with slip, as a part of it; `way`: as FrictionMemory takes
/// it. Above 1 the element may have several states.
double steepness(const FrictionLaw& law, double pressure, double compliance, double way);

class FrictionState {
 public:
  using Given = Eigen::Ref<const Eigen::VectorXd>;
  using Vector = Eigen::Ref<Eigen::VectorXd>;

  /// `places`: grid indices of the elements in contact, ascending. The problem and they must
  /// outlive the state.
  void begin(const FrictionProblem& problem, const std::vector<Eigen::Index>& places);

  bool feels_slip() const { return problem_->law.feels_slip(); }

  /// That of the elements; `compliance`: slip of the problem per own traction.
  double steepness(double compliance) const;

  /// g at rest.
  void set_rest(Vector bound) const;
  /// g under a slip of the problem, its x components before its y components.
  void set_bound(const Given& slip, Vector bound);
  /// Prepares `change` at a slip.
  void linearise(const Given& slip);
  /// Change of g with that of the slip.
  void change(const Given& slip_change, Vector bound_change) const;

 private:
  using Index = Eigen::Index;

  double slip_at(const Given& slip, Index e) const;
  /// The law of the element.
  const FrictionLaw& law(Index e) const {
    if (rows_.empty()) return problem_->law;
    return *rows_[static_cast<std::size_t>((*places_)[static_cast<std::size_t>(e)] /
                                           problem_->grid.nx)];
  }
  void find_ways();
  /// Of all elements with derivatives.
  void follow(const Given& slip);

  const FrictionProblem* problem_ = nullptr;
  const std::vector<Index>* places_ = nullptr;
  Index count_ = 0;
  std::vector<Friction> rows_;  ///< the law of each row of the grid; empty: one law
  std::optional<FrictionMemory> memory_;
  Eigen::VectorXd ways_;     ///< mm from the element ahead or the leading edge, or of the step
  std::vector<char> leads_;  ///< nothing of the row is ahead, or the particle brings its own mu
  Eigen::VectorXd coefficient_;
  Eigen::VectorXd by_own_, by_ahead_, carried_;  ///< dmu/d|w|, dmu/d|w ahead|, dmu/dmu ahead
  Eigen::VectorXd direction_;                    ///< w/|w| times slip_factor
};

}  // namespace rollfem::contact
