#include "contact/solve/normal.hpp"

#include "contact/base/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rollfem::contact {

namespace {

using Mask = Eigen::Array<bool, Eigen::Dynamic, 1>;

void check_problem(const NormalOperator& compliance, const NormalProblem& problem,
                   const Field& start) {
  const int n = compliance.grid().size();
  if (problem.undeformed_distance.size() != n)
    throw SolveError(
        fmt::format("normal problem: {} values of the undeformed distance for {} "
                    "contact elements",
                    problem.undeformed_distance.size(), n));
  if (!problem.undeformed_distance.allFinite())
    throw SolveError("normal problem: the undeformed distance is not finite everywhere");
  if (problem.normal_force.has_value() == problem.approach.has_value())
    throw SolveError("normal problem: exactly one of normal force and approach must be given");
  if (start.size() != 0 && start.size() != n)
    throw SolveError("normal problem: the pressure to start from is on another grid");
  if (problem.normal_force &&
      !(*problem.normal_force > 0.0 && std::isfinite(*problem.normal_force)))
    throw SolveError(fmt::format("no contact: the normal force is {} N; allowed: above 0",
                                 *problem.normal_force));
  const double smallest = problem.undeformed_distance.minCoeff();
  if (problem.approach && !(*problem.approach > smallest && std::isfinite(*problem.approach)))
    throw SolveError(
        fmt::format("no contact: the approach {} mm does not exceed the smallest undeformed "
                    "distance {} mm",
                    *problem.approach, smallest));
}

/// Conjugate gradients on the contact set C = {p > 0}, which gives up elements whose pressure would
/// turn negative and takes in those that penetrate.
class BoundConstrainedCg {
 public:
  BoundConstrainedCg(const NormalOperator& compliance, const NormalProblem& problem,
                     const NormalOptions& options)
      : compliance_(compliance),
        h_(problem.undeformed_distance),
        given_approach_(problem.approach),
        options_(options),
        smallest_distance_(h_.minCoeff()) {
    if (problem.normal_force)
      pressure_sum_ = *problem.normal_force / compliance.grid().element_area();
  }

  NormalSolution run(const Field& start) {
    initialise(start);
    for (int iteration = 0; iteration <= options_.max_iterations; ++iteration) {
      find_gap();
      const double residual = violation();
      if (residual <= options_.tolerance) return solution(iteration, residual);
      if (iteration < options_.max_iterations) step();
    }
    throw SolveError(
        fmt::format("the normal contact iteration did not converge: largest violation of the "
                    "contact condition {:.3g} of the approach after {} iterations, required {:.3g}",
                    violation(), options_.max_iterations, options_.tolerance));
  }

 private:
  void initialise(const Field& start) {
    if (start.size() == h_.size() && start.maxCoeff() > 0.0)
      p_ = start.cwiseMax(0.0);
    else
      p_ = first_guess();
    rescale();
    displacement_ = compliance_.apply(p_);
    contact_ = p_.array() > 0.0;
  }

  /// A pressure that is proportional to how far the bodies would overlap, with the overlap found
  /// from the scale of the operator: only an active set of the right size is wanted.
  Field first_guess() const {
    Field unit = Field::Zero(h_.size());
    Eigen::Index lowest = 0;
    h_.minCoeff(&lowest);
    double approach = given_approach_.value_or(0.0);
    if (!given_approach_) {
      // Smallest overlap whose elements carry the force at the stiffness of that many elements
      // loaded together, found by doubling.
      unit[lowest] = 1.0;
      const double self = compliance_.apply(unit)[lowest];
      double overlap = self * pressure_sum_;
      const double largest = h_.maxCoeff() - smallest_distance_;
      for (int halving = 0; halving < 200; ++halving) {
        const Field trial = (smallest_distance_ + overlap - h_.array()).cwiseMax(0.0);
        const double count = (trial.array() > 0.0).cast<double>().sum();
        // n elements loaded together are about sqrt(n) times as compliant as one.
        if (overlap <= self * std::sqrt(count) * pressure_sum_ / count || count <= 4.0) break;
        overlap *= 0.8;
        if (overlap < 1e-14 * std::max(largest, overlap)) break;
      }
      approach = smallest_distance_ + overlap;
    }
    // Half the overlap: a rounded body touches over half the area of its overlap.
    const double overlap = approach - smallest_distance_;
    Field guess = (smallest_distance_ + 0.5 * overlap - h_.array()).cwiseMax(0.0);
    if (!given_approach_) return guess;
    const Field response = compliance_.apply(guess);
    const double peak = response.maxCoeff();
    return peak > 0.0 ? Field(guess * (overlap / peak)) : guess;
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
  void find_gap() {
    gap_ = h_ + displacement_;
    const Field in_contact = contact_.cast<double>();
    approach_ = given_approach_.value_or(gap_.dot(in_contact) / in_contact.sum());
    gap_.array() -= approach_;
  }

  /// Largest |gap| in contact and largest penetration outside, relative to the approach (counted
  /// from the smallest undeformed distance).
  double violation() const {
    const double inside = contact_.select(gap_.array().abs(), 0.0).maxCoeff();
    const double outside = std::max(0.0, -gap_.minCoeff());
    return std::max(inside, outside) / std::max(approach_ - smallest_distance_, 1e-300);
  }

  Field restricted(const Field& field) const {
    return contact_.select(field.array(), 0.0).matrix();
  }

  /// Preconditioned residual on C. At given force it must keep the sum of pressures: the multiplier
  /// is that of M 1, kept as long as C stays the same.
  Field preconditioned(const Field& residual) {
    Field z = restricted(compliance_.precondition(residual));
    if (!force_given()) return z;
    if (changed_ || response_of_one_.size() == 0) {
      response_of_one_ = restricted(compliance_.precondition(contact_.cast<double>().matrix()));
      changed_ = false;
    }
    z -= (z.sum() / response_of_one_.sum()) * response_of_one_;
    return z;
  }

  void step() {
    take_in_penetrating_elements();
    const Field residual = restricted(-gap_);
    const Field z = preconditioned(residual);
    const double product = residual.dot(z);
    // Polak and Ribiere's beta forgets a direction that a change of C has spoilt.
    const double beta =
        old_product_ > 0.0 ? std::max(0.0, (product - old_residual_.dot(z)) / old_product_) : 0.0;
    direction_ = direction_.size() == 0 ? z : Field(z + beta * restricted(direction_));
    if (force_given() && beta > 0.0) {
      const double excess = direction_.sum() / response_of_one_.sum();
      direction_ -= excess * response_of_one_;
    }
    if (!(direction_.dot(residual) > 0.0)) direction_ = z;
    const Field response = compliance_.apply(direction_);
    const double curvature = direction_.dot(response);
    if (!(curvature > 0.0))
      throw SolveError("the normal contact iteration failed: the compliance is not positive");
    advance(direction_.dot(residual) / curvature, response);
    old_residual_ = residual;
    old_product_ = product;
  }

  void take_in_penetrating_elements() {
    for (Eigen::Index k = 0; k < gap_.size(); ++k)
      if (!contact_[k] && gap_[k] < 0.0) {
        contact_[k] = true;
        changed_ = true;
      }
  }

  void advance(double length, const Field& response) {
    p_ += length * direction_;
    const Mask negative = contact_ && p_.array() <= 0.0;
    if (!negative.any()) {
      displacement_ += length * response;
      return;
    }
    p_ = p_.cwiseMax(0.0);
    contact_ = contact_ && !negative;
    changed_ = true;
    rescale();
    displacement_ = compliance_.apply(p_);
  }

  NormalSolution solution(int iterations, double residual) const {
    NormalSolution result;
    result.pressure = p_;
    result.gap = gap_;
    result.approach = approach_;
    result.normal_force = p_.sum() * compliance_.grid().element_area();
    result.contact_elements = static_cast<int>(contact_.count());
    result.iterations = iterations;
    result.residual = residual;
    return result;
  }

  const NormalOperator& compliance_;
  const Field& h_;
  std::optional<double> given_approach_;
  NormalOptions options_;
  double smallest_distance_;
  double pressure_sum_ = 0.0;
  double approach_ = 0.0;
  Field p_, displacement_, gap_, direction_, old_residual_, response_of_one_;
  Mask contact_;
  bool changed_ = true;
  double old_product_ = 0.0;
};

}  // namespace

NormalSolution solve_normal(const NormalOperator& compliance, const NormalProblem& problem,
                            const NormalOptions& options, const Field& start) {
  check_problem(compliance, problem, start);
  return BoundConstrainedCg(compliance, problem, options).run(start);
}

}  // namespace rollfem::contact
