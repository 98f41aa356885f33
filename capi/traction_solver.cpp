#include "capi/traction_solver.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace rollfem::capi {

namespace {

constexpr int most_krylov_steps = 40;
constexpr int most_newton_steps = 30;
constexpr int most_halvings = 12;
/// The start only, but what it lacks from row to row puts borders of adhesion wrong.
constexpr double adhesion_tolerance = 1e-3;

}  // namespace

TractionSolver::TractionSolver(int n, int most_elements)
    : n_(n),
      most_(most_elements),
      matrix_(2 * most_elements, 2 * most_elements),
      krylov_(2 * most_elements, most_krylov_steps) {
  const auto most = static_cast<std::size_t>(most_elements);
  column_.reserve(most);
  row_.reserve(most);
  rows_.reserve(static_cast<std::size_t>(n));
  adheres_.reserve(most);
  pivots_.resize(2 * most);
  // A row has n elements at most.
  inverses_.resize(4 * most * static_cast<std::size_t>(n));
  for (Vector* list :
       {&rigid_, &normal_, &left_, &step_, &change_, &point_.traction, &point_.slip, &point_.trial,
        &point_.value, &trial_.traction, &trial_.slip, &trial_.trial, &trial_.value})
    list->setZero(2 * most_elements);
  for (Vector* list : {&bound_, &factor_}) list->setZero(most_elements);
  for (contact::Field* field : {&traction_.x, &traction_.y})
    field->setZero(static_cast<Eigen::Index>(n) * n);
}

bool TractionSolver::gather(const TractionProblem& problem) {
  column_.clear();
  row_.clear();
  rows_.clear();
  count_ = 0;
  for (int j = 0; j < n_; ++j) {
    Row row{count_, count_};
    for (int i = 0; i < n_; ++i) {
      const int k = j * n_ + i;
      if (!(problem.pressure[k] > 0.0)) continue;
      if (count_ == most_) return false;
      column_.push_back(i);
      row_.push_back(j);
      bound_[count_++] = problem.friction * problem.pressure[k];
    }
    row.last = count_;
    if (row.last > row.first) rows_.push_back(row);
  }
  for (int e = 0; e < count_; ++e) {
    const int k = row_[static_cast<std::size_t>(e)] * n_ + column_[static_cast<std::size_t>(e)];
    rigid_[e] = r_ * problem.slip.x[k];
    rigid_[count_ + e] = r_ * problem.slip.y[k];
    point_.traction[e] = traction_.x[k];
    point_.traction[count_ + e] = traction_.y[k];
  }
  adheres_.assign(static_cast<std::size_t>(count_), 0);
  return count_ > 0;
}

/// D u at an element is (1 + w) d - w d', d' that of the next element upstream.
void TractionSolver::fill_matrix(const TractionProblem& problem) {
  const InfluenceTable& table = problem.table;
  for (int a = 0; a < count_; ++a) {
    const int i = column_[static_cast<std::size_t>(a)], j = row_[static_cast<std::size_t>(a)];
    const double weight = problem.weights[j * n_ + i];
    const double here = r_ * (1.0 + weight), ahead = -r_ * weight;
    double* along = &matrix_(a, 0);
    double* across = &matrix_(count_ + a, 0);
    for (const Row& row : rows_) {
      const int rows = j - row_[static_cast<std::size_t>(row.first)];
      const double sign = rows < 0 ? -1.0 : 1.0;
      const double* xx = table.row(table.xx, std::abs(rows)) + i;
      const double* yy = table.row(table.yy, std::abs(rows)) + i;
      const double* xy = table.row(table.xy, std::abs(rows)) + i;
      for (int b = row.first; b < row.last; ++b) {
        const int at = -column_[static_cast<std::size_t>(b)];
        along[b] = here * xx[at] + ahead * xx[at + 1];
        across[count_ + b] = here * yy[at] + ahead * yy[at + 1];
        along[count_ + b] = across[b] = sign * (here * xy[at] + ahead * xy[at + 1]);
      }
    }
  }
}

void TractionSolver::project(Part traction) const {
  for (int e = 0; e < count_; ++e) {
    const double size = std::hypot(traction[e], traction[count_ + e]);
    if (size <= bound_[e]) continue;
    traction[e] *= bound_[e] / size;
    traction[count_ + e] *= bound_[e] / size;
  }
}

/// F = p - Proj(p - r w) of the traction and slip of a point.
void TractionSolver::evaluate(Point& point) const {
  const int size = 2 * count_;
  point.trial.head(size) = point.traction.head(size) - point.slip.head(size);
  point.value.head(size) = point.trial.head(size);
  project(point.value.head(size));
  point.value.head(size) = point.traction.head(size) - point.value.head(size);
  point.norm = point.value.head(size).norm();
}

void TractionSolver::start_from_adhesion(double tolerance) {
  const int size = 2 * count_;
  std::fill(adheres_.begin(), adheres_.end(), 1);
  factorise_rows();
  point_.traction.head(size).setZero();
  change_.head(size) = -rigid_.head(size);
  krylov_.solve(
      [&](const Part& p, Part result) { result.noalias() = matrix_.topLeftCorner(size, size) * p; },
      [&](const Part& p, Part result) { invert_rows(p, result); }, change_.head(size), tolerance,
      point_.traction.head(size));
  project(point_.traction.head(size));
}

void TractionSolver::linearise(const Point& point) {
  for (int e = 0; e < count_; ++e) {
    const int f = count_ + e;
    const double size = std::hypot(point.trial[e], point.trial[f]);
    adheres_[static_cast<std::size_t>(e)] = size <= bound_[e];
    normal_[e] = size > 0.0 ? point.trial[e] / size : 0.0;
    normal_[f] = size > 0.0 ? point.trial[f] / size : 0.0;
    factor_[e] = size > 0.0 ? bound_[e] / size : 1.0;
    const double reached = std::max(bound_[e], std::hypot(point.traction[e], point.traction[f]));
    left_[e] = point.traction[e] / reached;
    left_[f] = point.traction[f] / reached;
  }
}

void TractionSolver::couple(const Part& p, Part result) const {
  for (int e = 0; e < count_; ++e) {
    if (adheres_[static_cast<std::size_t>(e)]) continue;
    const int f = count_ + e;
    const double dx = result[e] - p[e], dy = result[f] - p[f];
    const double along = normal_[e] * dx + normal_[f] * dy;
    result[e] = p[e] + factor_[e] * (dx - along * left_[e]);
    result[f] = p[f] + factor_[e] * (dy - along * left_[f]);
  }
}

double TractionSolver::jacobian_entry(int target, int source) const {
  const int e = target < count_ ? target : target - count_, f = count_ + e;
  if (adheres_[static_cast<std::size_t>(e)]) return matrix_(target, source);
  const double dx = matrix_(e, source) - (source == e ? 1.0 : 0.0);
  const double dy = matrix_(f, source) - (source == f ? 1.0 : 0.0);
  const double along = normal_[e] * dx + normal_[f] * dy;
  const double own = source == target ? 1.0 : 0.0;
  return own + factor_[e] * ((target == e ? dx : dy) - along * left_[target]);
}

/// Triangles of the Jacobian of every row of elements by itself, columns first, with pivots.
void TractionSolver::factorise_rows() {
  double* block = inverses_.data();
  for (const Row& row : rows_) {
    const int length = row.last - row.first, size = 2 * length;
    const auto unknown = [&](int k) { return row.first + (k < length ? k : count_ - length + k); };
    for (int c = 0; c < size; ++c)
      for (int k = 0; k < size; ++k) block[c * size + k] = jacobian_entry(unknown(k), unknown(c));
    int* pivot = pivots_.data() + 2 * row.first;
    for (int c = 0; c < size; ++c) {
      double* column = block + c * size;
      int largest = c;
      for (int k = c + 1; k < size; ++k)
        if (std::abs(column[k]) > std::abs(column[largest])) largest = k;
      pivot[c] = largest;
      if (largest != c)
        for (int k = 0; k < size; ++k) std::swap(block[k * size + c], block[k * size + largest]);
      for (int k = c + 1; k < size; ++k) column[k] /= column[c];
      for (int other = c + 1; other < size; ++other) {
        double* next = block + other * size;
        const double upper = next[c];
        for (int k = c + 1; k < size; ++k) next[k] -= upper * column[k];
      }
    }
    block += size * size;
  }
}

void TractionSolver::invert_rows(const Part& residual, Part result) const {
  const double* block = inverses_.data();
  result = residual;
  double values[2 * 64];
  for (const Row& row : rows_) {
    const int length = row.last - row.first, size = 2 * length;
    for (int k = 0; k < length; ++k) {
      values[k] = result[row.first + k];
      values[length + k] = result[count_ + row.first + k];
    }
    const int* pivot = pivots_.data() + 2 * row.first;
    for (int c = 0; c < size; ++c) {
      std::swap(values[c], values[pivot[c]]);
      for (int k = c + 1; k < size; ++k) values[k] -= values[c] * block[c * size + k];
    }
    for (int c = size - 1; c >= 0; --c) {
      values[c] /= block[c * size + c];
      for (int k = 0; k < c; ++k) values[k] -= values[c] * block[c * size + k];
    }
    for (int k = 0; k < length; ++k) {
      result[row.first + k] = values[k];
      result[count_ + row.first + k] = values[length + k];
    }
    block += size * size;
  }
}

/// One damped step of Newton's method; false when none along its direction reduces |F|.
bool TractionSolver::advance(double tolerance) {
  const int size = 2 * count_;
  linearise(point_);
  factorise_rows();
  step_.head(size).setZero();
  trial_.value.head(size) = -point_.value.head(size);
  krylov_.solve(
      [&](const Part& p, Part result) {
        result.noalias() = matrix_.topLeftCorner(size, size) * p;
        couple(p, result);
      },
      [&](const Part& p, Part result) { invert_rows(p, result); }, trial_.value.head(size),
      tolerance, step_.head(size));
  change_.head(size).noalias() = matrix_.topLeftCorner(size, size) * step_.head(size);
  double length = 1.0;
  for (int halving = 0; halving < most_halvings; ++halving, length *= 0.5) {
    trial_.traction.head(size) = point_.traction.head(size) + length * step_.head(size);
    trial_.slip.head(size) = point_.slip.head(size) + length * change_.head(size);
    evaluate(trial_);
    if (!(trial_.norm <= (1.0 - 1e-4 * length) * point_.norm)) continue;
    std::swap(point_, trial_);
    return true;
  }
  return false;
}

bool TractionSolver::iterate(double scale, double tolerance) {
  double previous = 0.0;
  for (int step = 0; step <= most_newton_steps; ++step) {
    const double residual = point_.norm / scale;
    if (residual <= tolerance) {
      linearise(point_);
      return true;
    }
    // As exact as Newton's method converges (Eisenstat and Walker 1996).
    const double ratio = previous > 0.0 ? residual / previous : 1.0;
    const double wanted = std::max(std::min(0.05, 0.5 * ratio * ratio), 0.1 * tolerance / residual);
    if (!advance(wanted)) return false;
    previous = residual;
  }
  return false;
}

void TractionSolver::scatter() {
  traction_.x.setZero();
  traction_.y.setZero();
  for (int e = 0; e < count_; ++e) {
    const int k = row_[static_cast<std::size_t>(e)] * n_ + column_[static_cast<std::size_t>(e)];
    traction_.x[k] = point_.traction[e];
    traction_.y[k] = point_.traction[count_ + e];
  }
}

bool TractionSolver::solve(const TractionProblem& problem, bool anew) {
  r_ = 1.0 / problem.table.diagonal;
  if (!gather(problem)) return false;
  const int size = 2 * count_;
  const double creepage_load = rigid_.head(size).norm();
  if (creepage_load == 0.0 || !(problem.friction > 0.0)) {
    point_.traction.head(size).setZero();
    std::fill(adheres_.begin(), adheres_.end(), creepage_load == 0.0);
    scatter();
    return true;
  }
  fill_matrix(problem);
  if (anew)
    start_from_adhesion(adhesion_tolerance);
  else
    project(point_.traction.head(size));
  point_.slip.head(size) = rigid_.head(size);
  point_.slip.head(size).noalias() +=
      matrix_.topLeftCorner(size, size) * point_.traction.head(size);
  evaluate(point_);
  if (!iterate(std::min(creepage_load, bound_.head(count_).norm()), problem.tolerance))
    return false;
  scatter();
  return true;
}

int TractionSolver::adhering() const {
  return static_cast<int>(std::count(adheres_.begin(), adheres_.end(), 1));
}

}  // namespace rollfem::capi
