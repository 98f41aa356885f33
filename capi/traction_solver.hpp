// Tangential tractions of steady rolling on few elements, in memory that is kept: the semi-smooth
// Newton iteration of contact/solve/tangential.cpp with Coulomb's law, on the matrix of the
// elements in contact, preconditioned by the exact inverse of each row of elements along rolling.
#pragma once

#include "capi/influence_tables.hpp"
#include "capi/krylov.hpp"
#include "contact/base/grid.hpp"

#include <vector>

namespace rollfem::capi {

struct TractionProblem {
  const InfluenceTable& table;
  const contact::ContactGrid& grid;
  const contact::Field& pressure;
  const contact::Field& weights;  ///< contact::upwind_weights
  const contact::TangentialField& slip;
  double friction = 0.0;
  double tolerance = 0.0;  ///< of the residual over that of the creepage load
};

class TractionSolver {
 public:
  TractionSolver(int n, int most_elements);

  /// From the tractions there are, or, with `anew`, from adhesion all over. False when the contact
  /// has more elements than `most_elements` or the iteration fails.
  bool solve(const TractionProblem& problem, bool anew);

  const contact::TangentialField& traction() const { return traction_; }
  void scale(double factor) {
    traction_.x *= factor;
    traction_.y *= factor;
  }
  int elements() const { return count_; }
  int adhering() const;

 private:
  using Vector = Eigen::VectorXd;
  using Part = Eigen::Ref<Vector>;
  /// Elements of one row of the grid: first to last, less one.
  struct Row {
    int first = 0;
    int last = 0;
  };
  struct Point {
    Vector traction, slip, trial, value;  ///< slip and trial times r, MPa
    double norm = 0.0;
  };

  bool gather(const TractionProblem& problem);
  void fill_matrix(const TractionProblem& problem);
  void evaluate(Point& point) const;
  void project(Part traction) const;
  void start_from_adhesion(double tolerance);
  void linearise(const Point& point);
  /// result = J p from r T p in `result`.
  void couple(const Part& p, Part result) const;
  void factorise_rows();
  double jacobian_entry(int target, int source) const;
  void invert_rows(const Part& residual, Part result) const;
  bool advance(double tolerance);
  bool iterate(double scale, double tolerance);
  void scatter();

  int n_;
  int most_;
  int count_ = 0;
  double r_ = 0.0;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> matrix_;  ///< r T
  std::vector<int> column_, row_;
  std::vector<Row> rows_;
  Vector rigid_, bound_, normal_, left_, factor_, step_, change_;
  std::vector<char> adheres_;
  Point point_, trial_;
  std::vector<double> inverses_;  ///< triangles of the rows, one after another
  std::vector<int> pivots_;
  contact::TangentialField traction_;
  Krylov krylov_;
};

}  // namespace rollfem::capi
