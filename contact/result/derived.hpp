// SPDX-License-Identifier: LGPL-2.1-or-later
// Quantities derived from a solution without solving again: elastic energy, frictional power. Signs
// as everywhere: tractions and forces on the wheel, slip of the wheel relative to the rail.
#pragma once

#include "contact/result/result.hpp"

#include <string>

namespace rollfem::contact {

/// Elastic energy of both bodies, 1/2 sum (p_x u_x + p_y u_y + p_n u_n) dx dy in N mm, u the
/// displacement difference caused by these tractions. Throws InputError when the fields do not
/// match the grid (a theory without displacement has no energy).
double elastic_energy(const ContactGrid& grid, const SurfaceField& traction,
                      const SurfaceField& displacement);

/// Frictional heat per time, -V sum (p_t . w) dx dy in N mm/s (mW), from tractions and slip at the
/// same points; not negative for a solution of Coulomb's law. `speed`: V in mm/s.
double frictional_power(const ContactGrid& grid, const SurfaceField& traction,
                        const TangentialField& slip, double speed);

/// Power dissipated by the creep forces in rolling, -V (xi F_x + eta F_y + phi M_z) in N mm/s, M_z
/// about the origin; by `extra_slip` (empty: none) also -V sum (p_t . s_extra) dx dy. Equals
/// frictional_power in steady rolling of like half-spaces.
double creepage_power(const ContactGrid& grid, const SurfaceField& traction,
                      const Creepage& creepage, double speed,
                      const TangentialField& extra_slip = {});

/// The two powers of a solved load point, and their relative difference.
struct PowerBalance {
  double friction = 0.0;    ///< N mm/s, frictional_power
  double creepage = 0.0;    ///< N mm/s, creepage_power
  double difference = 0.0;  ///< |friction - creepage| / max of the two; 0 when both vanish
};
PowerBalance power_balance(const ContactGrid& grid, const SurfaceField& traction,
                           const TangentialField& slip, const Creepage& creepage, double speed,
                           const TangentialField& extra_slip = {});
PowerBalance power_balance(const ContactGrid& grid, const PointResult& point, double speed,
                           const TangentialField& extra_slip = {});

/// Whether a creepage or shift, by name, is a result: found for a prescribed force. Its statement
/// of the error tells.
bool found_for_force(const PointResult& point, const std::string& name);

}  // namespace rollfem::contact
