// What follows from a solution without solving again: elastic energy, frictional power, spin moment
// about a point, slip velocity; and, by solving again, the sensitivities of forces to creepages.
// Signs as everywhere: tractions and forces on the wheel, slip of the wheel relative to the rail.
#pragma once

#include "contact/case/case.hpp"
#include "contact/result/result.hpp"

#include <Eigen/Core>

#include <functional>

namespace rollfem::halfspace {

/// Elastic energy of both bodies, 1/2 sum (p_x u_x + p_y u_y + p_n u_n) dx dy in N mm, u the
/// displacement difference that these tractions cause. Throws contact::InputError when the fields
/// do not fit the grid (a theory that gives no displacement has no energy).
double elastic_energy(const contact::ContactGrid& grid, const contact::SurfaceField& traction,
                      const contact::SurfaceField& displacement);

/// Heat made by friction per time, -V sum (p_t . w) dx dy in N mm/s (mW), from tractions and slip
/// at the same points; not negative for a solution of Coulomb's law. `speed`: V in mm/s.
double frictional_power(const contact::ContactGrid& grid, const contact::SurfaceField& traction,
                        const contact::TangentialField& slip, double speed);

/// Power that the creep forces take from the rolling motion, -V (xi F_x + eta F_y + phi M_z) in
/// N mm/s, M_z about the origin; by `extra_slip` (empty: none) also -V sum (p_t . s_extra) dx dy.
/// Equals frictional_power in steady rolling of like half-spaces.
double creepage_power(const contact::ContactGrid& grid, const contact::SurfaceField& traction,
                      const contact::Creepage& creepage, double speed,
                      const contact::TangentialField& extra_slip = {});

/// The two powers of a solved load point, and how far they are apart.
struct PowerBalance {
  double friction = 0.0;    ///< N mm/s, frictional_power
  double creepage = 0.0;    ///< N mm/s, creepage_power
  double difference = 0.0;  ///< |friction - creepage| / max of the two; 0 when both vanish
};
PowerBalance power_balance(const contact::ContactGrid& grid, const contact::PointResult& point,
                           double speed, const contact::TangentialField& extra_slip = {});

/// Moment of the tangential tractions about the vertical through (x, y), N mm, on the wheel:
/// sum ((x_i - x) p_y - (y_i - y) p_x) dx dy.
double spin_moment_about(const contact::ContactGrid& grid, const contact::SurfaceField& traction,
                         double x, double y);

/// Slip velocity V w of the wheel surface relative to the rail, mm/s.
contact::TangentialField slip_velocity(const contact::TangentialField& slip, double speed);

/// F_x, F_y (N) and M_z (N mm) on the wheel.
using ForcesAndMoment = Eigen::Vector3d;

/// A model that solves one creepage.
using CreepForceLaw = std::function<ForcesAndMoment(const contact::Creepage&)>;

struct SensitivitySteps {
  double creepage = 2e-5;  ///< step in xi and eta
  double spin = 2e-6;      ///< step in phi, rad/mm
};

/// Derivatives with respect to (xi, eta, phi): column k belongs to the k-th creepage, row i to the
/// i-th of F_x, F_y, M_z.
struct Sensitivities {
  Eigen::Matrix3d derivative;  ///< N, N mm, per unit or per rad/mm
  Eigen::Matrix3d error;       ///< estimate of its absolute error, from two step lengths
};

/// Central differences at steps h and h/2, extrapolated (12 solutions). `forces` must be solved
/// tightly: an error e in a force makes about 2 e/h in a derivative, which `error` shows. Steps
/// near a kink (creepage 0 with friction at its bound) are the caller's. Throws contact::InputError
/// for steps not positive.
Sensitivities creep_sensitivities(const CreepForceLaw& forces, const contact::Creepage& at,
                                  const SensitivitySteps& steps = {});

}  // namespace rollfem::halfspace
