// SPDX-License-Identifier: LGPL-2.1-or-later
// Conjugate gradients on the contact set C = {p > 0}, releasing elements whose pressure would turn
// negative and adding those that penetrate, in memory reused from one problem to the next.
#pragma once

#include "base/errors.hpp"
#include "contact/iteration/normal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace rollfem::contact {

class BoundConstrainedCg {
 public:
  struct Effort {
    int iterations = 0;
    double residual = 0.0;
  };

  /// With a prescribed sum of all pressures. `start` may be empty. Throws SolveError.
  Effort solve_sum(const NormalMap& compliance, const Field& distance, double sum,
                   const NormalOptions& options, const Field& start) {
    given_approach_.reset();
    pressure_sum_ = sum;
    return solve(compliance, distance, options, start);
  }

  Effort solve_approach(const NormalMap& compliance, const Field& distance, double approach,
                        const NormalOptions& options, const Field& start) {
    given_approach_ = approach;
    return solve(compliance, distance, options, start);
  }

  const Field& pressure() const { return p_; }
  const Field& gap() const { return gap_; }
  const Field& displacement() const { return displacement_; }
  double approach() const { return approach_; }
  int contact_elements() const { return static_cast<int>(contact_.count()); }

 private:
  using Mask = Eigen::Array<bool, Eigen::Dynamic, 1>;

  Effort solve(const NormalMap& compliance, const Field& distance, const NormalOptions& options,
               const Field& start) {
    initialise(compliance, distance, start);
    for (int iteration = 0; iteration <= options.max_iterations; ++iteration) {
      find_gap(distance);
      const double residual = violation();
      if (residual <= options.tolerance) return {iteration, residual};
      if (iteration < options.max_iterations) step(compliance);
    }
    throw SolveError(
        fmt::format("the normal contact iteration did not converge: largest violation of the "
                    "contact condition {:.3g} of the approach after {} iterations, required {:.3g}",
                    violation(), options.max_iterations, options.tolerance));
  }

  void initialise(const NormalMap& compliance, const Field& distance, const Field& start) {
    smallest_distance_ = distance.minCoeff();
    old_product_ = 0.0;
    changed_ = true;
    direction_.setZero(distance.size());
    if (start.size() == distance.size() && start.maxCoeff() > 0.0)
      p_ = start.cwiseMax(0.0);
    else
      guess(compliance, distance);
    rescale();
    compliance.apply(p_, displacement_);
    contact_ = p_.array() > 0.0;
  }

  /// A pressure proportional to the overlap of the bodies, estimated from the scale of the
  /// operator: only an active set of the right size is needed.
  void guess(const NormalMap& compliance, const Field& distance) {
    const double overlap = given_approach_ ? *given_approach_ - smallest_distance_
                                           : overlap_of_sum(compliance, distance);
    // Half the overlap, because a rounded body touches over half the area of its overlap.
    p_ = (smallest_distance_ + 0.5 * overlap - distance.array()).cwiseMax(0.0);
    if (!given_approach_) return;
    compliance.apply(p_, displacement_);
    const double peak = displacement_.maxCoeff();
    if (peak > 0.0) p_ *= overlap / peak;
  }

  /// Smallest overlap whose elements carry the force with the stiffness of as many elements loaded
  /// together, found by doubling.
  double overlap_of_sum(const NormalMap& compliance, const Field& distance) {
    Eigen::Index lowest = 0;
    distance.minCoeff(&lowest);
    p_.setZero(distance.size());
    p_[lowest] = 1.0;
    compliance.apply(p_, displacement_);
    const double self = displacement_[lowest];
    double overlap = self * pressure_sum_;
    const double largest = distance.maxCoeff() - smallest_distance_;
    for (int halving = 0; halving < 200; ++halving) {
      const auto count =
          static_cast<double>((smallest_distance_ + overlap - distance.array() > 0.0).count());
      // n elements loaded together are about sqrt(n) times as compliant as one.
      if (overlap <= self * std::sqrt(count) * pressure_sum_ / count || count <= 4.0) break;
      overlap *= 0.8;
      if (overlap < 1e-14 * std::max(largest, overlap)) break;
    }
    return overlap;
  }

  bool force_given() const { return !given_approach_; }

  void rescale() {
    if (!force_given()) return;
    const double sum = p_.sum();
    if (!(sum > 0.0))
      throw SolveError("the normal contact iteration failed: no element carries pressure");
    p_ *= pressure_sum_ / sum;
  }

  /// gap_ = h + A p - approach; the approach of a given force makes the mean gap in C vanish.
  void find_gap(const Field& distance) {
    gap_ = distance + displacement_;
    in_contact_ = contact_.cast<double>();
    approach_ = given_approach_.value_or(gap_.dot(in_contact_) / in_contact_.sum());
    gap_.array() -= approach_;
  }

  /// Largest |gap| in contact and largest penetration outside, relative to the approach (counted
  /// from the smallest undeformed distance).
  double violation() const {
    const double inside = contact_.select(gap_.array().abs(), 0.0).maxCoeff();
    const double outside = std::max(0.0, -gap_.minCoeff());
    return std::max(inside, outside) / std::max(approach_ - smallest_distance_, 1e-300);
  }

  void restrict_to_contact(Field& field) const {
    for (Eigen::Index k = 0; k < field.size(); ++k)
      if (!contact_[k]) field[k] = 0.0;
  }

  /// Preconditioned residual on C. At given force it must keep the sum of pressures: the multiplier
  /// is that of M 1, kept as long as C stays the same.
  void precondition(const NormalMap& compliance) {
    compliance.precondition(residual_, z_);
    restrict_to_contact(z_);
    if (!force_given()) return;
    if (changed_) {
      in_contact_ = contact_.cast<double>();
      compliance.precondition(in_contact_, response_of_one_);
      restrict_to_contact(response_of_one_);
      changed_ = false;
    }
    z_ -= (z_.sum() / response_of_one_.sum()) * response_of_one_;
  }

  void step(const NormalMap& compliance) {
    take_in_penetrating_elements();
    residual_ = -gap_;
    restrict_to_contact(residual_);
    precondition(compliance);
    const double product = residual_.dot(z_);
    // The Polak-Ribiere beta discards a direction invalidated by a change of C.
    const double beta =
        old_product_ > 0.0 ? std::max(0.0, (product - old_residual_.dot(z_)) / old_product_) : 0.0;
    restrict_to_contact(direction_);
    direction_ = z_ + beta * direction_;
    if (force_given() && beta > 0.0)
      direction_ -= (direction_.sum() / response_of_one_.sum()) * response_of_one_;
    if (!(direction_.dot(residual_) > 0.0)) direction_ = z_;
    compliance.apply(direction_, response_);
    const double curvature = direction_.dot(response_);
    if (!(curvature > 0.0))
      throw SolveError("the normal contact iteration failed: the compliance is not positive");
    advance(compliance, direction_.dot(residual_) / curvature);
    old_residual_ = residual_;
    old_product_ = product;
  }

  void take_in_penetrating_elements() {
    for (Eigen::Index k = 0; k < gap_.size(); ++k)
      if (!contact_[k] && gap_[k] < 0.0) {
        contact_[k] = true;
        changed_ = true;
      }
  }

  void advance(const NormalMap& compliance, double length) {
    p_ += length * direction_;
    if (!(contact_ && p_.array() <= 0.0).any()) {
      displacement_ += length * response_;
      return;
    }
    p_ = p_.cwiseMax(0.0);
    contact_ = contact_ && p_.array() > 0.0;
    changed_ = true;
    rescale();
    compliance.apply(p_, displacement_);
  }

  std::optional<double> given_approach_;
  double pressure_sum_ = 0.0;
  double smallest_distance_ = 0.0;
  double approach_ = 0.0;
  Field p_, displacement_, gap_, direction_, residual_, old_residual_, z_, response_,
      response_of_one_, in_contact_;
  Mask contact_;
  bool changed_ = true;
  double old_product_ = 0.0;
};

}  // namespace rollfem::contact
