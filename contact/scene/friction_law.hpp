// SPDX-License-Identifier: LGPL-2.1-or-later
// A friction law: the largest tangential traction of an element as a function of pressure
// and slip, with both derivatives. Each law is a class; the solvers know only this
// interface.
#pragma once

#include "contact/base/grid.hpp"

#include <memory>

namespace rollfem::contact {

class FrictionLaw {
 public:
  struct Bound {
    double value = 0.0;        ///< g, MPa
    double by_pressure = 0.0;  ///< dg/dp_n
    double by_slip = 0.0;      ///< dg/d|w|, MPa over the unit of the slip
  };

  virtual ~FrictionLaw() = default;

  /// `pressure` >= 0, MPa; `slip` = |w| >= 0 as in results: relative to the rolling speed, mm in a
  /// shift. The value is 0 at pressure 0 and positive above.
  virtual Bound bound(double pressure, double slip) const = 0;

  /// Whether by_slip may be nonzero: bounds are then re-evaluated at every slip.
  virtual bool feels_slip() const { return false; }

  /// mu without slip: the scale of forces, and the only parameter of theories restricted to
  /// Coulomb's law.
  virtual double coefficient() const = 0;
};

/// Null: no friction.
using Friction = std::shared_ptr<const FrictionLaw>;

/// g = mu p_n.
class CoulombFriction : public FrictionLaw {
 public:
  explicit CoulombFriction(double coefficient) : coefficient_(coefficient) {}
  Bound bound(double pressure, double) const override {
    return {coefficient_ * pressure, coefficient_, 0.0};
  }
  double coefficient() const override { return coefficient_; }

 private:
  double coefficient_;
};

/// Coulomb's law; null for coefficient 0.
Friction coulomb(double coefficient);

/// The coefficient of the law; 0 without friction.
double coefficient_of(const Friction& friction);

/// g of every element, MPa; 0 without friction. `slip` may be empty: none.
Field traction_bound(const Friction& friction, const Field& pressure,
                     const TangentialField& slip = {});

}  // namespace rollfem::contact
