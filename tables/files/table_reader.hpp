// SPDX-License-Identifier: LGPL-2.1-or-later
// Evaluation of a table of creep forces between its points. Python and C read tables through this
// header (docs/tables.md).
#pragma once

#include "tables/files/axis_weights.hpp"
#include "tables/files/creep_table.hpp"

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace rollfem::tables {

/// Values of a table at a point. The bars add the error bars at the surrounding grid points and the
/// interpolation error not exceeded at 95 of 100 random points; at a jump of contact they also
/// include the full difference between the two shifts.
struct TableForces {
  Scaled forces{};
  double along_normal = 0.0;  ///< force of friction on the wheel along the normal; 0 for an ellipse
  double force_bar = 0.0, moment_bar = 0.0;
  /// Largest rise of the temperature in contact, K where the forces are in N, else scaled
  /// (CreepTable::rise); NaN without heat or for another shear modulus.
  double rise = std::numeric_limits<double>::quiet_NaN();
};

/// Evaluates a table, which it owns. Evaluation allocates nothing and is thread-safe.
class CreepTableReader {
 public:
  /// Throws contact::InputError if the table is inconsistent.
  explicit CreepTableReader(CreepTable table);

  const CreepTable& table() const { return table_; }

  /// Creepages beyond the grid are all reduced by one factor to its end, because full sliding
  /// depends only on their direction; under friction that may fall further (CreepTable::only_for)
  /// they are refused. Between two shifts or loads where contact jumps, the nearer one applies.
  /// Throws contact::InputError for a place outside the table (with a tolerance of one in a
  /// thousand for ratio, load and speed) and for values that are not finite.
  TableForces at(const TablePlace& place, const Scaled& creepage) const;

  /// Factors of the creepages (CreepTable::scale) at any place of the table; the speed is ignored,
  /// as in wheel_at.
  Scaled scale_at(const TablePlace& place) const;

  /// CreepTable::mean_axis at any ratio and load.
  double mean_axis_at(const TablePlace& place) const;

  /// Forces of an ellipse, in the consistent units of the arguments: semi-axes along and across
  /// rolling, combined shear modulus, mu F_n > 0, creepages xi, eta and phi. A table of only_for
  /// needs mm, N and MPa, and the speed if it has several; so do temperatures, at the speed of the
  /// case without one. Throws contact::InputError for a table
  /// over lateral shifts, and for an ellipse at whose size, pressure or speed its friction is
  /// another one (LoadSets).
  TableForces physical(double semi_axis_x, double semi_axis_y, double shear_modulus,
                       double friction_bound, const Scaled& creepage, double speed = 0.0) const;

  /// Forces of the wheel at a lateral shift (mm), in N and N mm, for creepages xi, eta and phi
  /// (rad/mm) of the main contact and mu F_n in N. Exact for the table's mu F_n; any other value
  /// also scales the slip from the rolling radii, and is refused by a table of only_for. Throws
  /// contact::InputError for a table over ratios.
  TableForces of_wheel(const TablePlace& place, double friction_bound,
                       const Scaled& creepage) const;

  /// The wheel at a lateral shift and load, interpolated like the forces; jump_after: whether
  /// contact jumps there.
  TableWheel wheel_at(const TablePlace& place) const;

  /// Whether contact jumps there, so that nothing is interpolated.
  bool jumps_at(const TablePlace& place) const { return locate(place).beyond.has_value(); }

  /// Returns the table; the reader is unusable afterwards.
  CreepTable release() && { return std::move(table_); }

 private:
  /// Nodes of an axis, their weights, and the nodes that provide bars.
  struct Nodes {
    AxisWeights weights;
    std::array<std::size_t, 2> around{};
  };
  /// A place on an axis; in a gap between two stretches also the farther end.
  struct OnAxis {
    Nodes near;
    std::optional<Nodes> beyond;
  };
  /// Nodes of all axes but the creepages; of the first axis for every node of the load.
  struct Side {
    AxisWeights load, speed;
    std::array<Nodes, 4> first;
  };
  struct Place {
    Side near;
    std::optional<Side> beyond;
  };
  /// Consecutive nodes without a jump, in the coordinate of interpolation.
  struct Stretch {
    std::size_t first = 0;
    std::vector<double> nodes;
  };
  using Stretches = std::vector<Stretch>;

  void check_wheels() const;
  void check_creepages() const;
  void check_conditions() const;
  void find_stretches();
  double first_coordinate(double place) const;
  double condition(const char* name, const char* unit, const std::vector<double>& axis,
                   double given) const;
  static OnAxis on_axis(const Stretches& stretches, double x);
  Place locate(const TablePlace& place) const;
  TablePlace at_any_speed(TablePlace place) const;
  Scaled scale_of(const Side& side) const;
  TableWheel wheel_of(const Side& side) const;
  TableForces forces_of(const Side& side, const Scaled& creepage) const;
  TableForces unscaled(const Side& side, double shear_modulus, double c, double friction_bound,
                       const Scaled& creepage, double speed) const;
  TablePlace place_of(double ratio, double c, double shear_modulus, double friction_bound,
                      double speed) const;
  void refuse_other_kind(bool wanted_shifts) const;
  void refuse_other_bound(double given, double own) const;

  CreepTable table_;
  std::vector<Stretches> first_;  ///< for every load, or one
  std::vector<Stretches> load_;   ///< for every shift, or one
  Stretches speed_;
  std::array<std::vector<double>, 3> coordinate_;
};

}  // namespace rollfem::tables
