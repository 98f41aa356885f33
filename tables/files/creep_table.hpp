// SPDX-License-Identifier: LGPL-2.1-or-later
// A table of creep forces over scaled creepages and, for Hertzian contacts, the axis ratio of the
// ellipse, as in Kalker's (1996) and USETAB's tables, or, for a wheel on its rail, the lateral
// shift of the wheelset; with interpolation between its points. Where forces over mu F_n depend on
// load and speed beside the creepages, both may be axes. Python and C read tables through this
// header (docs/tables.md).
//
// With c = sqrt(a b), the combined shear modulus G, the bound mu F_n and Kalker's coefficients:
//   xi' = xi G c^2 C11 / (3 mu F_n)    eta' = eta G c^2 C22 / (3 mu F_n)
//   phi' = phi G c^3 sqrt(C23^2 + C33^2) / (mu F_n)
// Signs are those of contact::Creepage; forces act on the wheel.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rollfem::tables {

/// xi', eta', phi'; or F_x/(mu F_n), F_y/(mu F_n), M_z/(mu F_n c).
using Scaled = std::array<double, 3>;

/// Interpolated minus computed values at random points between the grid points: of the force vector
/// over mu F_n, of the moment over mu F_n c.
struct InterpolationError {
  int points = 0;
  unsigned seed = 0;
  double force_rms = 0.0, force_95 = 0.0, force_max = 0.0;
  double moment_rms = 0.0, moment_95 = 0.0, moment_max = 0.0;
  /// The larger of force_95 and moment_95 at points between nodes of one axis alone: ratio or
  /// shift, xi', eta', phi', load, speed. 0: an axis of one value, or not measured. Not stored in
  /// files.
  std::array<double, 6> by_axis{};
};

/// The errors by their names in files and Python.
inline constexpr std::pair<const char*, double InterpolationError::*> interpolation_errors[] = {
    {"force_rms", &InterpolationError::force_rms}, {"force_95", &InterpolationError::force_95},
    {"force_max", &InterpolationError::force_max}, {"moment_rms", &InterpolationError::moment_rms},
    {"moment_95", &InterpolationError::moment_95}, {"moment_max", &InterpolationError::moment_max}};

/// A place on the axes other than the creepages.
struct TablePlace {
  TablePlace(double on_first = 1.0, double at_load = 0.0, double at_speed = 0.0)
      : first(on_first), load(at_load), speed(at_speed) {}
  double first;  ///< a/b, or the lateral shift in mm
  double load;   ///< N; 0: the only one of the table
  double speed;  ///< mm/s; 0: the only one of the table
};

/// A point at which the interpolation error was computed.
struct InterpolatedPoint {
  TablePlace place;
  Scaled creepage{}, interpolated{}, solved{};
};

/// The wheel at one lateral shift, loaded without friction. Creepages and forces refer to the frame
/// of its main contact, the most loaded one.
struct TableWheel {
  double semi_axis_x = 1.0, semi_axis_y = 1.0;  ///< mm, of the ellipse used for scaling
  double normal_force = 1.0;                    ///< N, of all contacts, each along its normal
  double contact_angle = 0.0;          ///< rad, of the main contact, as are the members below
  double rolling_radius = 0.0;         ///< mm
  double y_rail = 0.0, y_wheel = 0.0;  ///< mm, reference point on the profiles
  double lateral_pressure = 0.0;       ///< N, force of the pressure along y of the contact frame
  double max_pressure = 0.0;           ///< MPa, of the wheel
  double contact_area = 0.0;           ///< mm^2, of the wheel
  double contacts = 1.0;               ///< number of contacts in different planes
  /// 1: contact jumps between this shift and the next, without interpolation there.
  double jump_after = 0.0;
};

/// Whether a contact appears or disappears between neighbouring shifts or loads, or moves too far
/// aside.
bool contact_jumps(const TableWheel& a, const TableWheel& b);

/// How friction on an ellipse depends on the load. Scaled forces depend on c by a layer, on the
/// pressure F_n/c^2 by its yield stress, and on the sliding distance F_n/c by a memory; and on the
/// speed times the pressure. Between the bodies of the case c grows as the cube root of the load.
/// One of the three alone may thus stand for the load, for bodies of any curvature.
enum class LoadSets { nothing, size, pressure, sliding_distance, all };

/// Heat of the bodies of the case.
struct TableHeat {
  double effusivity = 0.0;     ///< of both together, N/(mm K s^0.5)
  double temperature = 0.0;    ///< degC, of surfaces in contact before friction heats them
  double speed = 0.0;          ///< mm/s, of the case
  double shear_modulus = 0.0;  ///< MPa, combined
  /// 1: friction follows the temperature, which is of the speed times the fourth power of the
  /// pressure times c.
  double sets_friction = 0.0;
};
/// Its members by their names in files and Python.
inline constexpr std::pair<const char*, double TableHeat::*> heat_numbers[] = {
    {"effusivity", &TableHeat::effusivity},
    {"temperature", &TableHeat::temperature},
    {"speed", &TableHeat::speed},
    {"shear_modulus", &TableHeat::shear_modulus},
    {"sets_friction", &TableHeat::sets_friction}};

struct CreepTable {
  std::string title, case_file, case_text, program, command, started;
  double poisson_ratio = 0.0;
  std::vector<double> axis_ratio;  ///< a/b, increasing; empty over lateral shifts
  // Members of tables over lateral shifts; otherwise empty.
  std::vector<double> lateral_shift;  ///< mm, increasing
  std::vector<TableWheel> wheels;     ///< the last axis fastest: load, shift
  // Members of both, 0 and empty for ellipses under constant friction.
  double shear_modulus = 0.0;  ///< MPa, combined
  double friction_coefficient = 0.0;
  /// Friction whose forces are not proportional to mu F_n at equal scaled creepages: falling
  /// friction at its speed, a layer; empty: any constant friction.
  std::string only_for;
  std::vector<double> load;   ///< N, increasing; empty: not to be given
  std::vector<double> speed;  ///< mm/s, increasing; empty: not to be given
  // Members of tables of ellipses with only_for.
  LoadSets load_sets = LoadSets::nothing;
  std::vector<double> mean_axis;  ///< c in mm of every ratio at the first load
  /// Increasing values. Over ratios: xi' and eta' from 0 on, phi' of both signs. Negative xi' and
  /// eta' follow from symmetry: the force law is odd, and mirroring a contact changes the signs of
  /// eta, phi, F_y and M_z. Over lateral shifts all have both signs, because the rolling radii of a
  /// profile cause slip without creepage.
  std::array<std::vector<double>, 3> creepage;
  /// One entry per ratio, or per load and shift: the factors of xi G c^2/(mu F_n), eta G c^2/(mu
  /// F_n), phi G c^3/(mu F_n).
  std::vector<Scaled> scale;
  // One entry per point, the last axis fastest: load, speed, ratio or shift, xi', eta', phi'.
  std::vector<Scaled> forces;
  std::vector<double> along_normal;  ///< force of friction along the normal over mu F_n; empty: 0
  std::vector<std::array<double, 2>> bars;  ///< error bars of the force vector and the moment
  std::vector<int> elements_across;         ///< on the finest grid
  std::optional<TableHeat> heat;            ///< empty: the case has none
  /// Largest rise of the temperature in contact by friction over (mu F_n)^2 sqrt(V) / (G beta
  /// c^3.5); empty without heat.
  std::vector<double> rise;
  InterpolationError interpolation;
  std::vector<InterpolatedPoint> checked;

  bool over_shifts() const { return !lateral_shift.empty(); }
  const std::vector<double>& first_axis() const {
    return over_shifts() ? lateral_shift : axis_ratio;
  }
  std::size_t loads() const { return load.empty() ? 1 : load.size(); }
  std::size_t speeds() const { return speed.empty() ? 1 : speed.size(); }
  /// Nodes of the axes other than the creepages.
  std::size_t nodes() const { return loads() * speeds() * first_axis().size(); }
  TablePlace node(std::size_t number) const;
  /// Number of values of the axes of the arrays: load and speed if they have several, and the rest.
  std::vector<std::size_t> shape() const;
  /// Of wheels and scale.
  std::size_t pressed(std::size_t at_load, std::size_t first) const {
    return (over_shifts() ? at_load * lateral_shift.size() : 0) + first;
  }
  std::size_t size() const;
  /// `first`: a node.
  std::size_t place(std::size_t first, std::size_t i, std::size_t j, std::size_t k) const;
};

/// Above 0 and finite.
bool is_positive(double value);

/// The coordinate of even axes and of interpolation: x up to 1, 1 + ln x beyond, odd.
double table_coordinate(double scaled_creepage);
double creepage_at(double coordinate);

/// Creepages from 0 to `largest` in even steps of the coordinate; for a spin with both signs.
std::vector<double> creepages_to(double largest, int count);
std::vector<double> spins_to(double largest, int count);

/// Values of a TableWheel under their names in files and Python.
struct WheelColumn {
  const char* name;
  double TableWheel::*member;
  const char* unit;
  const char* says;
  bool power = false;  ///< follows the load like a power of it, above 0
};
const std::vector<WheelColumn>& wheel_columns();

}  // namespace rollfem::tables
