// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/solve/prescribed_force.hpp"

#include "base/errors.hpp"
#include "base/root.hpp"

#include <Eigen/LU>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

namespace rollfem::contact {

namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

/// From this fraction of mu F_z on the contact counts as fully sliding: the creepage is not unique.
constexpr double sliding = 1.0 - 1e-8;

std::string described(const PrescribedForce& wanted) {
  std::string text;
  if (wanted.longitudinal)
    text += fmt::format("longitudinal_force = {:.6g} N", *wanted.longitudinal);
  if (wanted.longitudinal && wanted.lateral) text += ", ";
  if (wanted.lateral) text += fmt::format("lateral_force = {:.6g} N", *wanted.lateral);
  return text;
}

/// Where friction falls with the slip velocity.
constexpr const char* beyond_peak = "prescribe the creepage there";

[[noreturn]] void fail(
    const PrescribedForce& wanted, const std::string& why,
    const char* remedy = "prescribe a smaller force, or the creepage (shift) instead") {
  throw SolveError(
      fmt::format("prescribed force, rolling.{}: {}; do: {}", described(wanted), why, remedy));
}

class Counted {
 public:
  Counted(const ForceLaw& law, const PrescribedForce& wanted, int most)
      : law_(law), wanted_(wanted), most_(most) {}

  const TransmittedForce& operator()(const Vector2d& creepage) {
    if (evaluations_ == most_)
      fail(wanted_,
           fmt::format("the search for its creepage did not converge in {} solutions; "
                       "last F_x = {:.6g} N, F_y = {:.6g} N at creepage {:.6g}, {:.6g}{}",
                       most_, last_.force.x(), last_.force.y(), creepage_.x(), creepage_.y(),
                       most_found()),
           beyond_peak);
    ++evaluations_;
    creepage_ = creepage;
    last_ = law_(creepage);
    refuse_force_beyond_friction(wanted_, last_.bound);
    if (along(last_) > along(largest_.transmitted) || evaluations_ == 1) largest_ = found();
    return last_;
  }
  FoundCreepage found() const { return {creepage_, last_, evaluations_}; }
  /// The largest force in the direction of the prescribed one.
  const FoundCreepage& largest() const { return largest_; }
  std::string most_found() const {
    const auto& [creepage, transmitted, evaluations] = largest_;
    return fmt::format(
        "; the most in its direction was F_x = {:.6g} N, F_y = {:.6g} N at creepage {:.6g}, "
        "{:.6g}; where friction falls with the slip velocity forces have a peak and may jump",
        transmitted.force.x(), transmitted.force.y(), creepage.x(), creepage.y());
  }
  int evaluations() const { return evaluations_; }

 private:
  /// In the direction of the prescribed force.
  double along(const TransmittedForce& got) const {
    return wanted_.longitudinal.value_or(0.0) * got.force.x() +
           wanted_.lateral.value_or(0.0) * got.force.y();
  }

  const ForceLaw& law_;
  const PrescribedForce& wanted_;
  int most_;
  int evaluations_ = 0;
  Vector2d creepage_ = Vector2d::Zero();
  TransmittedForce last_{Vector2d::Zero(), 0.0};
  FoundCreepage largest_{Vector2d::Zero(), {Vector2d::Zero(), 0.0}, 0};
};

/// One unknown component k: g(c) = tau(F_wanted) - tau(F(c)) grows with c.
class BracketedSearch {
 public:
  BracketedSearch(Counted& law, int component, double wanted, const PrescribedForce& all,
                  const ForceSearch& search)
      : law_(law), k_(component), wanted_(wanted), all_(all), search_(search), at_(search.start) {}

  FoundCreepage run() {
    for (double c = at_[k_]; !evaluated(c); c = beyond()) {
      if (low_ && high_) return between();
      if (passed_peak()) return climb();
    }
    return law_.found();
  }

 private:
  struct Sample {
    double c;
    double g;
    double f;  ///< force over the bound
  };

  /// True when the force at c is the prescribed one; otherwise c becomes an end of the bracket.
  bool evaluated(double c) {
    at_[k_] = c;
    const TransmittedForce& got = law_(at_);
    if (std::abs(got.force[k_] - wanted_) <= search_.tolerance * got.bound) return true;
    bound_ = got.bound;
    unit_ = got.bound / search_.stiffness[k_];
    const double g =
        creepage_of_force(wanted_ / got.bound) - creepage_of_force(got.force[k_] / got.bound);
    before_ = last_;
    last_ = Sample{c, g, got.force[k_] / got.bound};
    (g < 0.0 ? low_ : high_) = last_;
    return false;
  }

  /// The force is too small, and more creepage has made it smaller.
  bool passed_peak() const {
    const double least = std::max(search_.tolerance, 1e-6);
    if (!search_.has_peak || !before_ || wanted_ * (last_->c - before_->c) > 0.0) return false;
    return std::abs(last_->c) > std::abs(before_->c) &&
           (before_->f - last_->f) * std::copysign(1.0, wanted_) > least;
  }

  /// Golden sections between no creepage and the last one, to the peak of a force that falls beyond
  /// it, or to the first creepage where it suffices: the rest is the rising branch below.
  FoundCreepage climb() {
    constexpr double golden = 0.6180339887498949, width = 1e-3;
    const double sign = std::copysign(1.0, wanted_);
    double low = 0.0, high = last_->c;
    std::array<double, 2> at{}, force{};
    const auto place = [&](std::size_t i) {
      at[i] = i == 0 ? high - golden * (high - low) : low + golden * (high - low);
    };
    const auto suffices = [&](std::size_t i) {
      const bool found = evaluated(at[i]);
      force[i] = sign * last_->f;
      return found || force[i] * bound_ > std::abs(wanted_);
    };
    for (const std::size_t i : {0U, 1U}) {
      place(i);
      if (suffices(i)) return on_rising_branch();
    }
    while (std::abs(high - low) > width * std::abs(high)) {
      const std::size_t better = force[0] > force[1] ? 0 : 1;
      (better == 0 ? high : low) = at[1 - better];
      at[1 - better] = at[better];
      force[1 - better] = force[better];
      place(better);
      if (suffices(better)) return on_rising_branch();
    }
    const FoundCreepage& most = law_.largest();
    fail(all_,
         fmt::format("friction that falls with the slip velocity transmits at most about {:.6g} N, "
                     "at creepage {:.4g}, and less beyond",
                     most.transmitted.force[k_], most.creepage[k_]),
         "prescribe a smaller force, or the creepage, to go beyond the peak");
  }

  /// From a creepage at which the force suffices.
  FoundCreepage on_rising_branch() {
    if (std::abs(last_->f * bound_ - wanted_) <= search_.tolerance * bound_) return law_.found();
    const Sample enough = *last_;
    low_.reset();
    high_.reset();
    if (evaluated(0.0)) return law_.found();
    (enough.g < 0.0 ? low_ : high_) = enough;
    return between();
  }

  /// Without a bracket: a secant step where it makes progress, growing steps where the force does
  /// not react because of full sliding.
  double beyond() {
    const double direction = last_->g < 0.0 ? 1.0 : -1.0;
    double step = std::abs(last_->g) * unit_;
    if (before_) {
      const double slope = (last_->g - before_->g) / (last_->c - before_->c);
      const double most = 4.0 * std::abs(last_->c - before_->c);
      step = slope > 0.0 ? std::min(1.2 * std::abs(last_->g) / slope, most) : most;
      step = std::max(step, std::min(most, 0.5 * std::abs(last_->c - before_->c)));
    }
    if (std::abs(last_->c) > 1e3 && step > std::abs(last_->c))
      fail(all_, fmt::format("no creepage transmits it; the closest is {:.6g} N at {:.3g}",
                             law_.found().transmitted.force[k_], last_->c));
    return last_->c + direction * step;
  }

  FoundCreepage between() {
    bool met = false;
    const auto g = [&](double c) {
      met = evaluated(c);
      return met ? 0.0 : last_->g;
    };
    const double c = root_between(g, low_->c, low_->g, high_->c, high_->g, 0.0, "prescribed force");
    if (!met) fail(all_, fmt::format("the force jumps past it at creepage {:.6g}", c));
    return law_.found();
  }

  Counted& law_;
  int k_;
  double wanted_;
  const PrescribedForce& all_;
  const ForceSearch& search_;
  Vector2d at_;
  double unit_ = 0.0;
  double bound_ = 0.0;  ///< of the last force, N
  std::optional<Sample> low_, high_, last_, before_;
};

Vector2d stretched(const Vector2d& relative_force) {
  const double size = relative_force.norm();
  return size > 0.0 ? Vector2d(creepage_of_force(size) / size * relative_force)
                    : Vector2d(Vector2d::Zero());
}

/// Both components: Broyden's method with step halving, its matrix renewed by differences when
/// there is no progress.
class BroydenSearch {
 public:
  BroydenSearch(Counted& law, const Vector2d& wanted, const PrescribedForce& all,
                const ForceSearch& search)
      : law_(law), wanted_(wanted), all_(all), search_(search), c_(search.start) {}

  FoundCreepage run() {
    r_ = residual(c_);
    pull_back_from_sliding();
    jacobian_ = -(search_.stiffness / bound_).asDiagonal().toDenseMatrix();
    bool fresh = false;
    while (!converged_) {
      if (step(fresh)) {
        fresh = false;
        continue;
      }
      if (fresh)
        fail(all_,
             fmt::format("the search for its creepage is stuck at {:.6g}, {:.6g}, where "
                         "F_x = {:.6g} N, F_y = {:.6g} N",
                         c_.x(), c_.y(), force_.x(), force_.y()) +
                 law_.most_found(),
             beyond_peak);
      renew_jacobian();
      fresh = true;
    }
    return law_.found();
  }

 private:
  Vector2d residual(const Vector2d& creepage) {
    const TransmittedForce& got = law_(creepage);
    bound_ = got.bound;
    force_ = got.force;
    converged_ = (got.force - wanted_).norm() <= search_.tolerance * got.bound;
    return stretched(got.force / got.bound) - stretched(wanted_ / got.bound);
  }

  /// In full sliding the force does not depend on the size of the creepage.
  void pull_back_from_sliding() {
    while (!converged_ && force_.norm() >= sliding * bound_) {
      c_ *= 0.6;
      r_ = residual(c_);
    }
  }

  /// A possibly outdated matrix is soon discarded, a fresh one only if no step helps. Where
  /// friction falls, the force may jump down on the way and rise again beyond: then the whole step
  /// is taken.
  bool step(bool fresh) {
    Vector2d d = -jacobian_.partialPivLu().solve(r_);
    if (!d.allFinite()) return false;
    const Matrix2d before = jacobian_;
    Vector2d whole = d, last = r_;
    const int most_halvings = fresh ? 30 : 6;
    for (int halving = 0; halving < most_halvings; ++halving, d *= 0.5) {
      const Vector2d trial = residual(c_ + d);
      if (!converged_ && force_.norm() >= sliding * bound_) {
        whole = 0.5 * d;
        continue;
      }
      const Vector2d change = trial - r_;
      jacobian_ += (change - jacobian_ * d) * d.transpose() / d.squaredNorm();
      if (converged_ || trial.norm() < r_.norm()) {
        c_ += d;
        r_ = trial;
        return true;
      }
      const bool jumped = (trial - last).norm() < 0.25 * (trial - r_).norm();
      last = trial;
      if (halving < 5 || !jumped || jumps_ == most_jumps) continue;
      ++jumps_;
      jacobian_ = before;
      r_ = residual(c_ += whole);
      return true;
    }
    return false;
  }

  void renew_jacobian() {
    for (int k = 0; k < 2 && !converged_; ++k) {
      // Towards less creepage, away from sliding.
      const double h = (c_[k] > 0.0 ? -0.02 : 0.02) * bound_ / search_.stiffness[k];
      Vector2d moved = c_;
      moved[k] += h;
      jacobian_.col(k) = (residual(moved) - r_) / h;
    }
  }

  Counted& law_;
  Vector2d wanted_;
  const PrescribedForce& all_;
  const ForceSearch& search_;
  Vector2d c_;
  Vector2d r_ = Vector2d::Zero();
  Vector2d force_ = Vector2d::Zero();
  Matrix2d jacobian_ = Matrix2d::Identity();
  double bound_ = 0.0;
  static constexpr int most_jumps = 5;
  int jumps_ = 0;
  bool converged_ = false;
};

}  // namespace

double creepage_of_force(double relative_force) {
  const double size = std::min(1.0, std::abs(relative_force));
  return std::copysign(3.0 * (1.0 - std::cbrt(1.0 - size)), relative_force);
}

Eigen::Vector2d first_creepage(const PrescribedForce& wanted, const Eigen::Vector2d& given,
                               const Eigen::Vector2d& stiffness, double bound) {
  const Eigen::Vector2d force(wanted.longitudinal.value_or(0.0), wanted.lateral.value_or(0.0));
  const double size = force.norm() / bound;
  const double stretch = size > 0.0 ? creepage_of_force(size) / size : 1.0;
  Eigen::Vector2d creepage = given;
  if (wanted.longitudinal) creepage.x() = -stretch * force.x() / stiffness.x();
  if (wanted.lateral) creepage.y() = -stretch * force.y() / stiffness.y();
  return creepage;
}

void refuse_force_beyond_friction(const PrescribedForce& wanted, double bound) {
  const double size = std::hypot(wanted.longitudinal.value_or(0.0), wanted.lateral.value_or(0.0));
  if (size < sliding * bound) return;
  fail(wanted,
       fmt::format("{:.6g} N is not below mu F_z = {:.6g} N, the most that friction can "
                   "transmit",
                   size, bound),
       "prescribe a smaller force, or the creepage instead");
}

FoundCreepage find_creepage(const ForceLaw& law, const PrescribedForce& wanted,
                            const ForceSearch& search) {
  if (!wanted.any() || !(search.stiffness.minCoeff() > 0.0))
    throw SolveError("prescribed force: no force, or no positive stiffness to search with");
  Counted counted(law, wanted, search.max_evaluations);
  if (wanted.longitudinal && wanted.lateral)
    return BroydenSearch(counted, {*wanted.longitudinal, *wanted.lateral}, wanted, search).run();
  return wanted.longitudinal
             ? BracketedSearch(counted, 0, *wanted.longitudinal, wanted, search).run()
             : BracketedSearch(counted, 1, *wanted.lateral, wanted, search).run();
}

}  // namespace rollfem::contact
