#include "capi/pressure_solver.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace rollfem::capi {

using contact::Field;

namespace {

constexpr int most_iterations = 200;

}  // namespace

PressureSolver::PressureSolver(int n) {
  for (Field* field : {&pressure_, &displacement_, &gap_, &direction_, &residual_, &last_residual_,
                       &response_, &carried_})
    field->setZero(static_cast<Eigen::Index>(n) * n);
  touches_.assign(static_cast<std::size_t>(n) * static_cast<std::size_t>(n), 0);
}

void PressureSolver::displace(const PressureProblem& problem, const Field& pressure,
                              Field& displacement) const {
  const int n = problem.table.n;
  displacement.setZero();
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const double p = pressure[j * n + i];
      if (p == 0.0) continue;
      for (int l = 0; l < n; ++l) {
        const double* influence = problem.table.row(problem.table.nn, std::abs(l - j)) - i;
        double* at = displacement.data() + static_cast<std::ptrdiff_t>(l) * n;
        for (int m = 0; m < n; ++m) at[m] += p * influence[m];
      }
    }
  displacement *= problem.grid.dx;
}

/// Semi-ellipses over where the bodies would overlap at the approach of a rounded body whose
/// overlap has about the elements of the load: only a contact set of the right size is wanted.
void PressureSolver::guess(const PressureProblem& problem) {
  const Field& h = problem.distance;
  const double lowest = h.minCoeff();
  // A body of parabolic gap h carries this on its overlap of depth d at half the approach d.
  double depth = 0.25 * (h.maxCoeff() - lowest);
  for (int round = 0; round < 3; ++round) {
    pressure_ = (lowest + depth - h.array()).max(0.0).sqrt();
    const double sum = pressure_.dot(carried_) * problem.grid.element_area();
    if (!(sum > 0.0)) break;
    displace(problem, pressure_, displacement_);
    // Displacement and overlap grow alike with the load.
    Eigen::Index middle = 0;
    h.minCoeff(&middle);
    const double found = 0.5 * displacement_[middle] * problem.force / sum;
    depth = std::clamp(found, 0.3 * depth, 3.0 * depth);
  }
}

bool PressureSolver::rescale(const PressureProblem& problem) {
  const double sum = pressure_.dot(carried_) * problem.grid.element_area();
  if (!(sum > 0.0)) return false;
  pressure_ *= problem.force / sum;
  return true;
}

void PressureSolver::drop_from(Field& field) const {
  for (Eigen::Index k = 0; k < field.size(); ++k)
    if (!touches_[static_cast<std::size_t>(k)]) field[k] = 0.0;
}

/// The approach of the load makes the gap vanish in the mean that the load takes. Returns the
/// largest violation over the approach.
double PressureSolver::find_gap(const PressureProblem& problem) {
  gap_ = problem.distance + displacement_;
  double sum = 0.0, squares = 0.0;
  for (Eigen::Index k = 0; k < gap_.size(); ++k) {
    if (!touches_[static_cast<std::size_t>(k)]) continue;
    sum += carried_[k] * gap_[k];
    squares += carried_[k] * carried_[k];
  }
  const double approach = sum / squares;
  gap_ -= approach * carried_;
  double worst = std::max(0.0, -gap_.minCoeff());
  for (Eigen::Index k = 0; k < gap_.size(); ++k)
    if (touches_[static_cast<std::size_t>(k)]) worst = std::max(worst, std::abs(gap_[k]));
  const double scale = approach - problem.distance.minCoeff();
  return worst / std::max(scale, 1e-300);
}

void PressureSolver::take_in_overlap() {
  for (Eigen::Index k = 0; k < gap_.size(); ++k)
    if (gap_[k] < 0.0) touches_[static_cast<std::size_t>(k)] = 1;
}

bool PressureSolver::step(const PressureProblem& problem) {
  take_in_overlap();
  const auto keep_force = [this](Field& field) {
    double sum = 0.0, squares = 0.0;
    for (Eigen::Index k = 0; k < field.size(); ++k) {
      if (!touches_[static_cast<std::size_t>(k)]) continue;
      sum += carried_[k] * field[k];
      squares += carried_[k] * carried_[k];
    }
    for (Eigen::Index k = 0; k < field.size(); ++k)
      if (touches_[static_cast<std::size_t>(k)]) field[k] -= sum / squares * carried_[k];
  };
  residual_ = -gap_;
  drop_from(residual_);
  keep_force(residual_);
  const double product = residual_.squaredNorm();
  // Polak and Ribiere's beta forgets a direction that a change of the contact set has spoilt.
  const double beta = last_product_ > 0.0
                          ? std::max(0.0, (product - last_residual_.dot(residual_)) / last_product_)
                          : 0.0;
  direction_ = residual_ + beta * direction_;
  drop_from(direction_);
  keep_force(direction_);
  if (!(direction_.dot(residual_) > 0.0)) direction_ = residual_;
  displace(problem, direction_, response_);
  const double curvature = direction_.dot(response_);
  if (!(curvature > 0.0)) return product == 0.0;
  const double length = direction_.dot(residual_) / curvature;
  pressure_ += length * direction_;
  last_residual_ = residual_;
  last_product_ = product;
  bool negative = false;
  for (Eigen::Index k = 0; k < pressure_.size(); ++k)
    if (touches_[static_cast<std::size_t>(k)] && pressure_[k] <= 0.0) {
      pressure_[k] = 0.0;
      touches_[static_cast<std::size_t>(k)] = 0;
      negative = true;
    }
  if (!negative) {
    displacement_ += length * response_;
    return true;
  }
  if (!rescale(problem)) return false;
  displace(problem, pressure_, displacement_);
  return true;
}

bool PressureSolver::solve(const PressureProblem& problem, bool anew) {
  const int n = problem.table.n;
  for (int j = 0; j < n; ++j)
    carried_.segment(j * n, n).setConstant(problem.carried[static_cast<std::size_t>(j)]);
  if (anew) guess(problem);
  if (!rescale(problem)) return false;
  for (Eigen::Index k = 0; k < pressure_.size(); ++k)
    touches_[static_cast<std::size_t>(k)] = pressure_[k] > 0.0;
  displace(problem, pressure_, displacement_);
  direction_.setZero();
  last_product_ = 0.0;
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    if (find_gap(problem) <= problem.tolerance) return true;
    if (!step(problem)) return false;
  }
  return false;
}

}  // namespace rollfem::capi
