// SPDX-License-Identifier: LGPL-2.1-or-later
// A friction law: the coefficient of friction of an element as a function of its slip, with the
// derivative, and how slowly it follows. Each law is a class; the solvers know only this interface.
#pragma once

#include "base/grid.hpp"
#include "case/case.hpp"
#include "scene/surface_heat.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

namespace rollfem::contact {

/// mu follows the slip w with a lag: over a way of h mm rolled (h = 1 in a shift, which has none)
/// it comes nearer to mu(|w|) by the factor exp(-h max(|w|, least_slip) / distance).
struct FrictionMemory {
  double distance = 0.0;    ///< d_c, mm slid until mu has come nearer by the factor e
  double least_slip = 0.0;  ///< s_0 in the unit of the slip
};

/// A layer between the bodies that yields: tractions are at most tau_c = max(0, tau_c0 + k u*), u*
/// the way by which the particle has yielded since it entered the patch. Where tau_c is below mu
/// p_n, relative motion increases u* and is not slip.
struct Plasticity {
  double yield_stress = 0.0;  ///< tau_c0, MPa
  double hardening = 0.0;     ///< k, MPa/mm; below 0 it softens
};

class TemperatureFriction;

class FrictionLaw {
 public:
  struct Coefficient {
    double value = 0.0;    ///< mu
    double by_slip = 0.0;  ///< dmu/d|w|
  };

  virtual ~FrictionLaw() = default;

  /// `slip` = |w| >= 0 as in results: relative to the rolling speed, mm in a shift. Positive and
  /// continuous.
  virtual Coefficient at(double slip) const = 0;

  /// Whether by_slip may be nonzero: bounds are then re-evaluated at every slip.
  virtual bool feels_slip() const { return false; }

  /// Empty: mu follows the slip at once.
  virtual std::optional<FrictionMemory> memory() const { return {}; }

  /// Where friction varies over the rail: the law of the elements at y (mm, patch frame). Null:
  /// this law everywhere.
  virtual std::shared_ptr<const FrictionLaw> of_row(double) const { return nullptr; }
  virtual bool varies() const { return false; }

  /// The law if it follows the temperature, which elements ahead determine as well; else null.
  virtual const TemperatureFriction* by_temperature() const { return nullptr; }
  /// The largest mu that slip can lead to.
  virtual double largest() const { return coefficient(); }

  /// mu without slip, the largest if it varies: the scale of forces, and the only number of the law
  /// that theories limited to Coulomb friction use.
  double coefficient() const { return at(0.0).value; }

  std::optional<Plasticity> plasticity;  ///< of a layer that yields beside the law; empty: none
  FrictionBranch branch = FrictionBranch::sticking;
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
                  std::optional<FrictionMemory> memory = {}, const FallShape::Constants& own = {})
      : shape_(shape), kinetic_(kinetic), parts_(parts), memory_(memory), own_(own) {}

  Coefficient at(double slip) const override;
  bool feels_slip() const override { return true; }
  std::optional<FrictionMemory> memory() const override { return memory_; }

 private:
  FallShape shape_;
  double kinetic_;
  std::array<Part, 2> parts_;
  std::optional<FrictionMemory> memory_;
  FallShape::Constants own_;
};

/// mu follows the temperature of the surfaces in contact, linearly between two temperatures and
/// constant outside: in steady rolling, where heat comes from all elements ahead in the row.
class TemperatureFriction : public FrictionLaw {
 public:
  struct Point {
    double temperature = 0.0, coefficient = 0.0;  ///< degC, mu
  };
  TemperatureFriction(Point cold, Point hot, SurfaceHeat heat, std::optional<FrictionMemory> memory)
      : cold_(cold), hot_(hot), heat_(heat), memory_(memory) {}

  /// Before friction heats the surfaces.
  Coefficient at(double) const override { return {warm(heat_.contact_temperature()).value, 0.0}; }
  bool feels_slip() const override { return true; }
  std::optional<FrictionMemory> memory() const override { return memory_; }
  const TemperatureFriction* by_temperature() const override { return this; }

  /// mu at a temperature, and its derivative by it.
  Coefficient warm(double temperature) const;
  /// The larger of cold and hot surfaces.
  double largest() const override { return std::max(cold_.coefficient, hot_.coefficient); }
  const Point& cold() const { return cold_; }
  const Point& hot() const { return hot_; }
  const SurfaceHeat& heat() const { return heat_; }

 private:
  Point cold_, hot_;
  SurfaceHeat heat_;
  std::optional<FrictionMemory> memory_;
};

/// A law for every row of elements.
class VaryingFriction : public FrictionLaw {
 public:
  using OfRow = std::function<Friction(double y)>;
  /// `most`: that of the largest coefficient.
  VaryingFriction(Friction most, OfRow of_row)
      : most_(std::move(most)), of_row_(std::move(of_row)) {}
  Coefficient at(double slip) const override { return most_->at(slip); }
  bool feels_slip() const override { return most_->feels_slip(); }
  std::optional<FrictionMemory> memory() const override { return most_->memory(); }
  Friction of_row(double y) const override { return of_row_(y); }
  bool varies() const override { return true; }
  const TemperatureFriction* by_temperature() const override { return most_->by_temperature(); }
  double largest() const override { return most_->largest(); }

 private:
  Friction most_;
  OfRow of_row_;
};

/// Coulomb's law; null for coefficient 0.
Friction coulomb(double coefficient);

/// The law of a case at a position of the wheelset; null for the coefficient 0. `inclination`: of
/// the rail over y of the patch frame (rail_inclination), if known.
Friction friction_of(const Case& input, std::size_t position = 0,
                     const std::function<double(double y)>& inclination = {});

/// The coefficient of the law; 0 without friction.
double coefficient_of(const Friction& friction);

/// mu of every element at rest; 0 without friction.
Field coefficients_of(const Friction& friction, const ContactGrid& grid);

/// Mean of mu at rest under a pressure, weighted with it: the largest force over the load.
double mean_coefficient(const Friction& friction, const ContactGrid& grid, const Field& pressure);

/// g = mu p_n of every element at rest, MPa; 0 without friction.
Field traction_bound(const Friction& friction, const ContactGrid& grid, const Field& pressure);

}  // namespace rollfem::contact
