// SPDX-License-Identifier: LGPL-2.1-or-later
// A case as the user describes it: bodies, load, friction, rolling, grids. Values in, no behaviour;
// read from TOML by case_reader.hpp. Units: mm, N, MPa, rad.
#pragma once

#include "base/choices.hpp"
#include "base/material.hpp"
#include "base/profile_drop.hpp"
#include "case/body_heat.hpp"
#include "case/body_plasticity.hpp"
#include "case/fall_shape.hpp"
#include "case/irregularities.hpp"
#include "case/model_options.hpp"
#include "case/track.hpp"

#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rollfem::contact {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// What wheel and rail have in common.
struct Body {
  double transverse_radius = infinity;  ///< mm, > 0 convex, < 0 concave, inf flat
  double round_to = usual_round_to;     ///< fraction of that radius, see base/profile_drop.hpp
  Material material;
  std::string mesh;       ///< gmsh file as given in the case file; empty: meshed by rollfem
  ProfileSource profile;  ///< instead of the transverse radius
  std::optional<BodyPlasticity> plasticity;  ///< unset: elastic
  std::optional<BodyHeat> heat;  ///< unset: that of steel if the other body has it, else none
};

/// Upper body (1): a surface of revolution about the axle.
struct Wheel : Body {
  double rolling_radius = 0.0;  ///< mm, radius at the running circle
  std::optional<WheelFlat> flat;
  std::optional<WheelPolygon> polygon;
};

/// Lower body (2): a straight extruded rail, or a roller.
struct Rail : Body {
  /// mm, radius of its surface at z = 0: inf straight, > 0 a roller below the wheel, < 0 a ring
  /// around it.
  double rolling_radius = infinity;
  std::optional<RailCorrugation> corrugation;
  std::optional<RailDip> dip;
};

enum class ContactShape {
  point,  ///< bodies of finite width: radii, profiles, points
  line,   ///< endless rollers
};

/// State to find where a steeply falling friction law allows several.
enum class FrictionBranch {
  sticking,  ///< the one with the most friction, as creepage grows from 0
  sliding,   ///< the one with the least friction, as fast sliding slows down
};

/// How the coefficient of friction falls with the slip velocity.
struct FrictionFall {
  FallShape shape = FallShape::none;
  std::optional<double> kinetic_coefficient;  ///< mu_kin
  std::optional<double> half_velocity;        ///< s_h1, mm/s
  double second_part = 0.0;                   ///< mu_2; mu_1 is the rest of the fall
  double second_half_velocity = 1.0;          ///< s_h2, mm/s
  std::optional<double> polach_a;             ///< mu_kin/mu, instead of mu_kin
  std::optional<double> polach_b;             ///< s/m, instead of s_h1
  /// Values of FallShape::constants; unset: their defaults.
  std::array<std::optional<double>, FallShape::most_constants> constants{};
  double memory_distance = 0.0;  ///< d_c, mm; 0: mu follows the slip without delay
  double memory_velocity = 1.0;  ///< s_0, mm/s
  FrictionBranch branch = FrictionBranch::sticking;
};

/// Friction that varies over the rail: its numbers at some points, interpolated linearly between
/// them and constant outside. The points lie along one of the three coordinates.
struct FrictionVariation {
  /// The kind of law and the memory are the same at all points.
  struct Point {
    double coefficient = 0.0;
    FrictionFall fall;
  };
  std::vector<Point> points;             ///< empty: the same everywhere
  std::vector<double> inclination;       ///< rad, ascending
  std::vector<double> track_position;    ///< mm, ascending
  std::vector<double> lateral_position;  ///< y in mm, ascending; without profiles
};

/// A layer between the bodies that is compliant in shear only.
struct Layer {
  std::optional<double> thickness{};      ///< mm; unset: rigid until it yields
  std::optional<double> shear_modulus{};  ///< MPa
  std::optional<double> yield_stress{};   ///< MPa; unset: elastic
  std::optional<double> hardening{};      ///< MPa per mm of plastic displacement; unset: 0
  /// Shear displacement by traction, mm/MPa.
  double compliance() const { return thickness.value_or(0.0) / shear_modulus.value_or(1.0); }
};

/// The shape of the contact; the other members are for line contact.
struct ContactShapeCase {
  ContactShape shape = ContactShape::point;
  double width = 1.0;                        ///< mm, width to which all forces refer
  std::optional<double> relative_radius;     ///< mm; unset: the wheel's rolling radius
  std::optional<double> reference_distance;  ///< mm; unset: the relative radius
};

/// Exactly one of the first three is given; vertical_force only with profiles. Where the load comes
/// from elsewhere (a history, a given pressure), the reader stores its largest normal force or
/// approach here, which determines the size of grids.
struct Load {
  std::optional<double> normal_force;    ///< N
  std::optional<double> approach;        ///< mm
  std::optional<double> vertical_force;  ///< N, on each wheel, friction included
  std::optional<double> max_pressure;    ///< MPa, of Hertz's contact
};

/// Rigid slip caused by the shape of the contact surface rather than by the creepages.
enum class ExtraSlip {
  automatic,  ///< that of the true rolling radii of the wheel's surface
  none,       ///< only creepages, as if the surface were flat
  file,       ///< s_x, s_y on a lattice of points, Rolling::extra_slip_values
};

/// Values on a regular lattice of points, as read from a file of lines `x, y, value ...`; evaluated
/// by case/lattice.hpp.
struct Lattice {
  std::string file;  ///< as given in the case file
  int nx = 0;
  int ny = 0;
  double x_first = 0.0;                     ///< mm
  double y_first = 0.0;                     ///< mm
  double dx = 0.0;                          ///< mm
  double dy = 0.0;                          ///< mm
  std::vector<std::vector<double>> values;  ///< per column of the file; index j * nx + i
};

/// One load point of a creep curve.
struct Creepage {
  double longitudinal = 0.0;  ///< xi
  double lateral = 0.0;       ///< eta
  double spin = 0.0;          ///< phi, rad/mm
};

/// Tangential force on the wheel (N) given instead of the creepage (shift) in that direction, which
/// is then unknown and 0 in `Creepage` (`HistoryStep`).
struct PrescribedForce {
  std::optional<double> longitudinal;  ///< F_x, negative when braking (xi > 0)
  std::optional<double> lateral;       ///< F_y
  bool any() const { return longitudinal.has_value() || lateral.has_value(); }
};

/// Creepages given in the case file; with profiles the others follow from the motion.
struct GivenCreepages {
  bool longitudinal = false;
  bool lateral = false;
  bool spin = false;
};

struct Rolling {
  Problem problem = Problem::steady;
  double speed = 0.0;  ///< mm/s
  /// Lists in the file are broadcast to one length: that of the load points (steps of a history).
  std::vector<Creepage> creepages{Creepage{}};
  GivenCreepages given;
  std::vector<PrescribedForce> forces;  ///< as long as `creepages`, or empty: none prescribed
  UpwindOrder upwind_order = UpwindOrder::second;
  LeadingEdge leading_edge = LeadingEdge::fitted;
  ExtraSlip extra_slip = ExtraSlip::automatic;
  std::optional<Lattice> extra_slip_values;  ///< columns s_x, s_y; for ExtraSlip::file
  /// Slip velocity over slip as results give it, mm/s: the rolling speed. A shift has none: its
  /// slip in mm is taken as that of one second.
  double slip_speed() const { return problem == Problem::shift ? 1.0 : speed; }
};

/// Motion of one step of the problems `shift` and `transient`. Shifts are rigid displacements of
/// the wheel relative to the rail during this step, not since the beginning.
struct StepMotion {
  double longitudinal_shift = 0.0;  ///< mm, problem shift
  double lateral_shift = 0.0;       ///< mm, problem shift
  double spin_shift = 0.0;          ///< rad, rotation about the normal, problem shift
  double step_length = 0.0;         ///< mm rolled in this step, problem transient
};

/// A step with its load.
struct HistoryStep : StepMotion {
  std::optional<double> normal_force;    ///< N; without any of the three, the load of the case
  std::optional<double> approach;        ///< mm
  std::optional<double> vertical_force;  ///< N, on each wheel
  std::optional<double> time;            ///< s, at the end of the step
  /// mm, way of the wheel itself where it is not that of its contact, step_length.
  std::optional<double> wheel_way;
};

/// Undeformed distance instead of the radii; at most one of the two.
struct DistanceOptions {
  std::optional<std::array<double, 2>> quadratic;  ///< A, B in 1/mm: h = A x^2 + B y^2
  std::optional<Lattice> values;                   ///< h in mm on a lattice of points
};

/// Hertzian pressure p0 sqrt(1 - (x/a)^2 - (y/b)^2) prescribed instead of solving the normal
/// problem.
struct GivenPressure {
  double semi_axis_x = 0.0;   ///< a, mm
  double semi_axis_y = 0.0;   ///< b, mm
  double max_pressure = 0.0;  ///< p0, MPa; if not given, computed from Load::normal_force
};

struct GridOptions {
  int elements_across = 40;                        ///< along the smaller extent of the patch
  std::optional<std::array<double, 2>> cell_size;  ///< dx, dy in mm; overrides elements_across
  std::optional<std::array<double, 2>> extent;     ///< mm, of the whole potential contact area
  std::array<double, 2> middle{0.0, 0.0};          ///< mm, of the potential contact area
};

/// Position of the contact elements: in the tangent plane, along the common surface across, or
/// chosen by the spread of the contact's normals.
enum class SurfaceForm { automatic, planar, curved };

/// Points at which stress and displacement are requested: a point (1 by 1), a line (n by 1) or a
/// plane (n by m), the parallelogram `from`, `to`, `across`; or a line (n by 1) that follows the
/// contact surface of the body at one depth, for which `from` and `to` hold only x and y.
struct SubsurfaceRequest {
  enum class Kind { point, line, plane, surface };
  Kind kind = Kind::point;
  bool wheel = true;  ///< otherwise the rail
  std::array<double, 3>
      from{};  ///< mm, global frame: z >= 0 in the wheel, <= 0 in the rail unless that is concave
  std::array<double, 3> to{};       ///< other end of the line, or of the first side
  std::array<double, 3> across{};   ///< end of the second side, which begins at `from`
  double depth = 0.0;               ///< mm below the surface of the body, kind surface
  std::array<int, 2> points{1, 1};  ///< along the first and the second side
};

constexpr const char* word_of(SubsurfaceRequest::Kind kind) {
  using Kind = SubsurfaceRequest::Kind;
  switch (kind) {
    case Kind::point:
      return "point";
    case Kind::line:
      return "line";
    case Kind::plane:
      return "plane";
    case Kind::surface:
      return "surface";
  }
  return nullptr;
}

/// Load points for which displacement and stress of the whole bodies are stored.
enum class BodyFields { all, last, none };

/// Load points for which the fields on the contact grid are stored; `automatic`: all of up to
/// OutputOptions::most_whole, otherwise some.
enum class GridFields { automatic, all, some, none };

struct OutputOptions {
  static constexpr std::size_t most_whole = 100;  ///< load points
  static constexpr std::size_t some_points = 25;
  std::vector<std::string> paths{"x", "y"};  ///< middle lines written as path_x.csv, path_y.csv
  bool fields = true;  ///< ParaView files, with bodies according to body_fields
  BodyFields body_fields = BodyFields::none;  ///< only with `fields`
  GridFields grid_fields = GridFields::automatic;
  bool stress_maxima = false;
  /// Whether the fields of load point k of `count` are stored; `some`: the first, the last and
  /// evenly spaced ones between them.
  bool keeps_grid(std::size_t k, std::size_t count) const {
    if (grid_fields == GridFields::none) return false;
    const bool whole = grid_fields == GridFields::all ||
                       (grid_fields == GridFields::automatic && count <= most_whole);
    if (whole || count <= some_points) return true;
    // Whether k is one of the indices j (count - 1)/(some - 1), rounded down.
    const std::size_t parts = some_points - 1, last = count - 1;
    const std::size_t j = (k * parts + last - 1) / last;
    return j * last / parts == k;
  }
  /// Whether displacement and stress of wheel and rail are stored for load point k of `count`.
  bool keeps_bodies(std::size_t k, std::size_t count) const {
    return fields &&
           (body_fields == BodyFields::all || (body_fields == BodyFields::last && k + 1 == count));
  }
};

/// Grid of `rollfem table`: the creep force law of Hertzian contacts over scaled creepages and the
/// ratio of the semi-axes, or of a wheel on its rail over the lateral shift.
struct TableOptions {
  std::vector<double> axis_ratio;     ///< a/b; empty: the case's ellipse
  std::vector<double> lateral_shift;  ///< mm, with profiles; empty: over ratios
  /// mm; if given, lateral_shift holds only the first and the last shift.
  std::optional<double> lateral_shift_step;
  std::vector<double> load, speed;  ///< N, mm/s, further axes; empty: the values of the case
  std::optional<std::array<int, 3>> points;         ///< of xi', eta', phi'
  std::array<double, 3> largest{3.0, 3.0, 5.0};     ///< xi', eta', phi'
  std::vector<double> longitudinal, lateral, spin;  ///< instead of points and largest; >= 0
  int check_points = 200;                           ///< between grid points, at random
};

struct Case {
  std::string title;
  std::string file;  ///< as given by the user
  std::string text;  ///< the whole case file, kept for provenance
  std::vector<std::string> models;
  std::optional<double> accuracy;  ///< relative; cells are refined until it is reached
  std::vector<std::string> accuracy_of{"max_pressure", "semi_axis_x", "semi_axis_y",
                                       "traction_coefficient"};
  Load load;
  double friction_coefficient = 0.0;  ///< at rest; if friction varies, the largest
  FrictionFall friction_fall;         ///< if friction varies, that of the first point
  FrictionVariation friction_variation;
  std::optional<Layer> layer;
  Wheel wheel;
  Rail rail;
  ContactShapeCase geometry;
  Track track;        ///< with profiles
  Wheelset wheelset;  ///< with profiles
  Displacement wheel_displacement, rail_displacement;
  Rolling rolling;
  std::vector<HistoryStep>
      history;  ///< as long as rolling.creepages for shift and transient, else empty
  /// Whether the first step of a transient is steady rolling, which the others continue; otherwise
  /// the bodies are at rest before it.
  bool starts_steady = false;
  /// The wheels' velocities across the track and their turning are the differences of their
  /// positions from step to step, not those of Wheelset.
  bool moves_by_positions = false;
  DistanceOptions undeformed_distance;
  std::optional<GivenPressure> given_pressure;
  GridOptions contact_grid;
  SurfaceForm surface = SurfaceForm::automatic;
  bool inertia = false;               ///< of wheel and rail at Rolling::speed
  std::optional<double> body_extent;  ///< mm, of elastic bodies from the patch; unset: chosen
  std::vector<SubsurfaceRequest> subsurface;
  OutputOptions output;
  TableOptions table;
  ModelOptions options;
  /// Whether wheel and rail are given by profiles: the case is not solved directly but converted
  /// into scenes.
  bool has_profiles() const { return !wheel.profile.name.empty() || !rail.profile.name.empty(); }
  /// The positions of the wheels are the steps of a history, which follow each other; otherwise
  /// each position has all load points.
  bool is_wheel_history() const {
    return has_profiles() && !history.empty() && wheelset.positions() > 1;
  }
  /// Whether wheel or rail yields: each entry of rolling.creepages is then a pass, or a step of a
  /// shift.
  bool yields() const { return wheel.plasticity || rail.plasticity; }
  /// Whether the position of the wheel is given instead of its load.
  bool sinks() const { return load.approach || !wheelset.height.empty(); }
};

}  // namespace rollfem::contact
