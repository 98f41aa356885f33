// SPDX-License-Identifier: LGPL-2.1-or-later
// Creep forces as a table over scaled creepages and, of Hertzian contacts, the ratio of the
// ellipse's axes, as Kalker's (1996) and USETAB's tables have it, or, of a wheel on its rail, the
// lateral shift of the wheelset; and what it says between its points. Python and C read it through
// here (docs/tables.md).
//
// With c = sqrt(a b), the combined shear modulus G, the bound mu F_n and Kalker's coefficients:
//   xi' = xi G c^2 C11 / (3 mu F_n)    eta' = eta G c^2 C22 / (3 mu F_n)
//   phi' = phi G c^3 sqrt(C23^2 + C33^2) / (mu F_n)
// Signs are those of contact::Creepage; forces act on the wheel.
#pragma once

#include "tables/files/axis_weights.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rollfem::tables {

/// xi', eta', phi'; or F_x/(mu F_n), F_y/(mu F_n), M_z/(mu F_n c).
using Scaled = std::array<double, 3>;

/// What is found between grid points less what is solved for there, at points at random: of the
/// force vector in mu F_n, of the moment in mu F_n c.
struct InterpolationError {
  int points = 0;
  unsigned seed = 0;
  double force_rms = 0.0, force_95 = 0.0, force_max = 0.0;
  double moment_rms = 0.0, moment_95 = 0.0, moment_max = 0.0;
};

/// Its errors by the names that files and Python have them under.
inline constexpr std::pair<const char*, double InterpolationError::*> interpolation_errors[] = {
    {"force_rms", &InterpolationError::force_rms}, {"force_95", &InterpolationError::force_95},
    {"force_max", &InterpolationError::force_max}, {"moment_rms", &InterpolationError::moment_rms},
    {"moment_95", &InterpolationError::moment_95}, {"moment_max", &InterpolationError::moment_max}};

/// A point at which it was found.
struct CheckedPoint {
  double place = 1.0;  ///< on the first axis: a/b, or mm
  Scaled creepage{}, interpolated{}, solved{};
};

/// The wheel at one lateral shift, pressed without friction. Its main contact is the most loaded
/// one, in whose frame creepages and forces are.
struct TableWheel {
  double semi_axis_x = 1.0, semi_axis_y = 1.0;  ///< mm, of the ellipse that scales
  double normal_force = 1.0;                    ///< N, of all contacts, each along its normal
  double contact_angle = 0.0;                   ///< rad, of the main contact as all that follows
  double rolling_radius = 0.0;                  ///< mm
  double y_rail = 0.0, y_wheel = 0.0;           ///< mm, of the reference point on the profiles
  double lateral_pressure = 0.0;                ///< N, force of the pressure along y of the contact
  double max_pressure = 0.0;                    ///< MPa, of the wheel
  double contact_area = 0.0;                    ///< mm^2, of the wheel
  double contacts = 1.0;                        ///< in planes of their own
  /// 1: contact jumps between this shift and the next, and nothing is interpolated there.
  double jump_after = 0.0;
};

struct CreepTable {
  std::string title, case_file, case_text, program, command, started;
  double poisson_ratio = 0.0;
  std::vector<double> axis_ratio;  ///< a/b, increasing; empty over lateral shifts
  // Over lateral shifts, else empty and 0.
  std::vector<double> lateral_shift;  ///< mm, increasing
  std::vector<TableWheel> wheels;     ///< of every shift
  double shear_modulus = 0.0;         ///< MPa, combined
  double friction_coefficient = 0.0;
  /// Increasing. Over ratios xi' and eta' from 0 on, phi' with its mirror image. Negative xi' and
  /// eta' follow: the force law is odd, and the mirror image of a contact changes eta, phi, F_y and
  /// M_z. Over lateral shifts of both signs: a wheel's surface slips by itself as it rolls.
  std::array<std::vector<double>, 3> creepage;
  /// Of every ratio or shift: what xi G c^2/(mu F_n), eta G c^2/(mu F_n), phi G c^3/(mu F_n) are
  /// multiplied by.
  std::vector<Scaled> scale;
  // Of every point, the last axis the fastest: ratio or shift, xi', eta', phi'.
  std::vector<Scaled> forces;
  std::vector<double> along_normal;         ///< of friction, over mu F_n; empty: 0
  std::vector<std::array<double, 2>> bars;  ///< of the force vector and of the moment
  std::vector<int> elements_across;         ///< of the finest grid
  InterpolationError interpolation;
  std::vector<CheckedPoint> checked;

  bool over_shifts() const { return !lateral_shift.empty(); }
  const std::vector<double>& first_axis() const {
    return over_shifts() ? lateral_shift : axis_ratio;
  }
  std::size_t size() const;
  std::size_t place(std::size_t first, std::size_t i, std::size_t j, std::size_t k) const;
};

/// In what axes are even and interpolation works: x up to 1, 1 + ln x beyond, odd.
double table_coordinate(double scaled_creepage);
double creepage_at(double coordinate);

/// From 0 to `largest` in even steps of the coordinate; of both signs for a spin.
std::vector<double> creepages_to(double largest, int count);
std::vector<double> spins_to(double largest, int count);

/// What a table says at a point. Bars: of the forces, those of the grid around the point and what
/// 95 of 100 points at random were off by interpolation; where contact jumps between two shifts,
/// also all by which these differ.
struct TableForces {
  Scaled forces{};
  double along_normal = 0.0;  ///< of friction, on the wheel; 0 of an ellipse
  double force_bar = 0.0, moment_bar = 0.0;
};

/// Answers; made once of a table, which it holds. Nothing is allocated, and threads may ask at
/// once.
class CreepTableReader {
 public:
  /// Throws contact::InputError where the table does not fit together.
  explicit CreepTableReader(CreepTable table);

  const CreepTable& table() const { return table_; }

  /// `place`: a ratio of axes, or a lateral shift in mm. Beyond the largest creepages all are
  /// reduced alike to the end of the grid: full sliding knows their direction only. Between two
  /// shifts where contact jumps it is the nearer one. Throws contact::InputError for a place
  /// outside of the table (of a ratio one in a thousand is let pass) and for what is not finite.
  TableForces at(double place, const Scaled& creepage) const;

  /// Factors of the creepages (CreepTable::scale) at any place of the table.
  Scaled scale_at(double place) const;

  /// Forces in the units of the arguments, consistent ones. Semi-axes along rolling and across,
  /// combined shear modulus, mu F_n > 0, creepages xi, eta and phi. Throws contact::InputError for
  /// a table over lateral shifts.
  TableForces physical(double semi_axis_x, double semi_axis_y, double shear_modulus,
                       double friction_bound, const Scaled& creepage) const;

  /// Of the wheel at a lateral shift (mm): forces in N and N mm under creepages xi, eta and phi
  /// (rad/mm) of the main contact, mu F_n in N. Exact for mu F_n of the table; with another the
  /// slip of the rolling radii is scaled along. Throws contact::InputError for a table over ratios.
  TableForces of_wheel(double lateral_shift, double friction_bound, const Scaled& creepage) const;

  /// Between shifts interpolated as forces are; jump_after: whether contact jumps there.
  TableWheel wheel_at(double lateral_shift) const;

  /// The table again; nothing may be asked for afterwards.
  CreepTable release() && { return std::move(table_); }

 private:
  /// Nodes of the first axis, their weights, and those of which bars are taken.
  struct Nodes {
    AxisWeights weights;
    std::array<std::size_t, 2> around{};
  };
  /// In a gap between two stretches the end that is farther, too.
  struct Place {
    Nodes near;
    std::optional<Nodes> beyond;
  };
  /// Nodes that follow each other without a jump, in what interpolation works in.
  struct Stretch {
    std::size_t first = 0;
    std::vector<double> nodes;
  };

  void check_wheels() const;
  void check_creepages() const;
  double coordinate_of(double place) const;
  Place locate(double place) const;
  Scaled scale_of(const Nodes& nodes) const;
  TableWheel wheel_of(const Nodes& nodes) const;
  TableForces forces_of(const Nodes& nodes, const Scaled& creepage) const;
  TableForces unscaled(const Nodes& nodes, double stiffness, double c, double friction_bound,
                       const Scaled& creepage) const;
  void refuse_other_kind(bool wanted_shifts) const;

  CreepTable table_;
  std::vector<Stretch> stretches_;
  std::array<std::vector<double>, 3> coordinate_;
};

/// Numbers of a TableWheel as files and Python have them.
struct WheelColumn {
  const char* name;
  double TableWheel::*member;
  const char* unit;
  const char* says;
};
const std::vector<WheelColumn>& wheel_columns();

}  // namespace rollfem::tables
