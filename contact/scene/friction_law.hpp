// SPDX-License-Identifier: LGPL-2.1-or-later
// A friction law: the coefficient of friction of an element as a function of its slip, with the
// derivative, and how slowly it follows. Each law is a class; the solvers know only this interface.
#pragma once

#include "contact/base/grid.hpp"
#include "contact/case/case.hpp"

#include <array>
#include <memory>
#include <optional>

namespace rollfem::contact {

/// mu follows the slip w with a lag: over a way of h mm rolled (h = 1 in a shift, which has none)
/// it comes nearer to mu(|w|) by the factor exp(-h max(|w|, least_slip) / distance).
struct FrictionMemory {
  double distance = 0.0;    ///< d_c, mm slid until mu has come nearer by the factor e
  double least_slip = 0.0;  ///< s_0 in the unit of the slip
};

/// A layer between the bodies that yields: tractions are at most tau_c = max(0, tau_c0 + k u*), u*
/// the way by which the particle has yielded since it entered the patch. What moves where tau_c is
/// below mu p_n is u* and no slip.
struct Plasticity {
  double yield_stress = 0.0;  ///< tau_c0, MPa
  double hardening = 0.0;     ///< k, MPa/mm; below 0 it softens
};

class FrictionLaw {
 public:
  struct Coefficient {
    double value = 0.0;    ///< mu
    double by_slip = 0.0;  ///< dmu/d|w|
  };

  virtual ~FrictionLaw() = default;

  /// `slip` = |w| >= 0 as results give it: relative to the speed of rolling, mm in a shift.
  /// Positive and continuous.
  virtual Coefficient at(double slip) const = 0;

  /// Whether by_slip may be nonzero: bounds are then re-evaluated at every slip.
  virtual bool feels_slip() const { return false; }

  /// Empty: mu follows the slip at once.
  virtual std::optional<FrictionMemory> memory() const { return {}; }

  /// mu without slip: what forces are scaled with, and all that the theories take which know no
  /// other law than Coulomb's.
  double coefficient() const { return at(0.0).value; }

  std::optional<Plasticity> plasticity;  ///< of a layer that yields beside the law; empty: none
};

/// Null: no friction.
using Friction = std::shared_ptr<const FrictionLaw>;

/// The same mu at any slip.
class CoulombFriction : public FrictionLaw {
 public:
  explicit CoulombFriction(double coefficient) : coefficient_(coefficient) {}
  Coefficient at(double) const override { return {coefficient_, 0.0}; }

 private:
  double coefficient_;
};

/// mu falls with the velocity s of the slip from mu(0) to the kinetic one, in two parts
/// (FallShape).
class FallingFriction : public FrictionLaw {
 public:
  struct Part {
    double size = 0.0;       ///< mu_i, of which half is left at half_slip
    double half_slip = 1.0;  ///< in the unit of the slip
  };

  FallingFriction(FallShape shape, double kinetic, const std::array<Part, 2>& parts,
                  std::optional<FrictionMemory> memory = {})
      : shape_(shape), kinetic_(kinetic), parts_(parts), memory_(memory) {}

  Coefficient at(double slip) const override;
  bool feels_slip() const override { return true; }
  std::optional<FrictionMemory> memory() const override { return memory_; }

 private:
  FallShape shape_;
  double kinetic_;
  std::array<Part, 2> parts_;
  std::optional<FrictionMemory> memory_;
};

/// Coulomb's law; null for the coefficient 0.
Friction coulomb(double coefficient);

/// The law of a case; null for the coefficient 0.
Friction friction_of(const Case& input);

/// The coefficient of the law; 0 without friction.
double coefficient_of(const Friction& friction);

/// g = mu p_n of every element at rest, MPa; 0 without friction.
Field traction_bound(const Friction& friction, const Field& pressure);

}  // namespace rollfem::contact
