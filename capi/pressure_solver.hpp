// Pressure of a contact on few elements, in memory that is kept: conjugate gradients on the contact
// set as in contact/solve/normal.hpp, by sums over the elements in place of transforms.
#pragma once

#include "capi/influence_tables.hpp"
#include "contact/base/grid.hpp"

#include <vector>

namespace rollfem::capi {

struct PressureProblem {
  const InfluenceTable& table;
  const contact::ContactGrid& grid;
  const contact::Field& distance;      ///< undeformed, mm
  const std::vector<double>& carried;  ///< per row: part of the pressure along the load
  double force = 0.0;                  ///< N along the load
  double tolerance = 0.0;              ///< largest gap or overlap over the approach
};

class PressureSolver {
 public:
  /// For grids of n by n elements.
  explicit PressureSolver(int n);

  /// Sets pressure(), from what it is (scaled to the load) or, with `anew`, from the distance.
  /// False when the iteration fails.
  bool solve(const PressureProblem& problem, bool anew);

  const contact::Field& pressure() const { return pressure_; }
  void scale(double factor) { pressure_ *= factor; }

 private:
  void guess(const PressureProblem& problem);
  bool rescale(const PressureProblem& problem);
  /// Normal displacement under `pressure`.
  void displace(const PressureProblem& problem, const contact::Field& pressure,
                contact::Field& displacement) const;
  double find_gap(const PressureProblem& problem);
  void take_in_overlap();
  void drop_from(contact::Field& field) const;
  bool step(const PressureProblem& problem);

  contact::Field pressure_, displacement_, gap_, direction_, residual_, last_residual_, response_,
      carried_;
  std::vector<char> touches_;
  double last_product_ = 0.0;
};

}  // namespace rollfem::capi
