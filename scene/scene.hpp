// SPDX-License-Identifier: LGPL-2.1-or-later
// The problem to be solved: the geometry of one contact, its materials and its load points. A case
// is the document; a scene is the fully resolved problem. Models never change scenes.
#pragma once

#include "base/accuracy.hpp"
#include "base/errors.hpp"
#include "case/case.hpp"
#include "scene/friction_law.hpp"
#include "scene/geometry.hpp"
#include "scene/surface_heat.hpp"

#include <string>

namespace rollfem::contact {

struct StepPast;  // scene/step_past.hpp

/// Load that presses the bodies together: exactly one of the two; both ignored with a given
/// pressure.
struct NormalLoad {
  std::optional<double> force;     ///< N, the component of the force on the wheel along `direction`
  std::optional<double> approach;  ///< mm, along z
  /// y and z of a unit vector in the patch frame. The z axis, or the vertical of a wheelset:
  /// friction then carries a part of the force.
  std::array<double, 2> direction{0.0, 1.0};

  bool is_tilted() const { return direction[0] != 0.0; }
  bool operator==(const NormalLoad& other) const {
    return force == other.force && approach == other.approach && direction == other.direction;
  }
};

/// One point of a creep curve, or one step of a history.
struct LoadPoint : StepMotion {
  NormalLoad load;
  Creepage creepage;      ///< 0 in a direction whose force is prescribed
  PrescribedForce force;  ///< instead of creepages (shifts)
  /// Absolute errors of creepages found by a wheelset's balance.
  std::optional<Creepage> creepage_error;
};

/// A point load of another contact of the same wheel, acting on the wheel along the axes of that
/// contact, at its position on the grid of this contact: the surface of both is rolled out flat.
struct NeighbourLoad {
  double x = 0.0, y = 0.0;                                 ///< mm
  double longitudinal = 0.0, lateral = 0.0, normal = 0.0;  ///< N
  double turn = 0.0;  ///< rad between the contacts' planes (turn_between)
};

/// Properties of a body besides its surface.
struct SceneBody {
  Material material;
  std::string mesh;  ///< gmsh file as given in the case file; empty: meshed by rollfem
  std::optional<BodyPlasticity> plasticity;
};

struct Scene {
  Scene() = default;
  /// For a case with radii or a given geometry; with true profiles track/motion places the patches.
  Scene(const Case& input);  // NOLINT(google-explicit-constructor): the source of every scene

  std::string file;  ///< case file, for messages
  Geometry geometry;
  std::optional<ContactPlace> place;  ///< on the track; with true profiles
  /// Loads on the half-space beside this contact, the same at every load point.
  std::vector<NeighbourLoad> neighbour_loads;
  double rail_inclination = 0.0;  ///< as a tangent; with true profiles
  SceneBody wheel;
  SceneBody rail;
  CombinedMaterial material;  ///< with the layer between the bodies
  Friction friction_law;      ///< as given in the case; null if mu is 0
  Problem problem = Problem::steady;
  bool starts_steady = false;  ///< the first point of Problem::transient is steady rolling
  std::vector<LoadPoint> points;
  /// Of a wheel that stood elsewhere in the step before: what this one step inherits; null: the
  /// load points follow each other at one place.
  std::shared_ptr<const StepPast> past;
  bool turns_freely = false;  ///< a wheelset's balance has found the rotation, and the creepages
  std::optional<GivenPressure> given_pressure;
  std::optional<SurfaceHeat> heat;  ///< unset: temperatures are not asked for
  double speed = 0.0;               ///< mm/s
  UpwindOrder upwind_order = UpwindOrder::second;
  LeadingEdge leading_edge = LeadingEdge::fitted;
  GridOptions contact_grid;
  AccuracyRequest accuracy;
  /// Degree to which the half-space's surface follows wheel and rail (ContactSurface::follows):
  /// from the case, or from the normals of a placed contact.
  double follows_surface = 0.0;
  bool inertia = false;               ///< of wheel and rail at this speed
  std::optional<double> body_extent;  ///< mm, of elastic bodies from the patch; unset: chosen
  ModelOptions options;
  std::vector<SubsurfaceRequest> subsurface;
  OutputOptions output;

  bool is_history() const { return problem == Problem::shift || problem == Problem::transient; }
  Problem problem_of(std::size_t k) const {
    return starts_steady && k == 0 ? Problem::steady : problem;
  }
  /// The active friction law; null without friction.
  Friction friction() const { return problem == Problem::frictionless ? nullptr : friction_law; }
  /// mu of the law, also for frictionless problems.
  double friction_coefficient() const { return coefficient_of(friction_law); }
  bool has_profiles() const { return geometry.has_profiles(); }
  /// Whether a body yields: the load points are then passes, or steps of a shift, each over the
  /// state that the one before has left.
  bool yields() const { return wheel.plasticity || rail.plasticity; }
  /// Whether inertia of wheel and rail is included.
  bool feels_inertia() const { return inertia && speed > 0.0; }
  /// Whether the load points differ in their loads.
  bool load_changes() const;
  /// Friction on a tilted plane carries a part of the load.
  bool shares_load() const;
  /// Subsurface points.
  bool asks_for_stress() const { return !subsurface.empty() || output.stress_maxima; }
  /// Whether y = 0 is a symmetry plane: bodies with radii, and no lateral driving of the material.
  bool is_symmetric() const;
  /// The file, and the patch of a wheelset: "left wheel, position 3".
  FailurePlace where() const { return {file, place ? place->label() : std::string()}; }
};

/// The load with the largest patch: the largest normal force, or the largest approach. A force not
/// along z counts as the normal force without friction.
NormalLoad largest_load(const Scene& scene);

/// At the element centres, MPa.
Field pressure_field(const GivenPressure& pressure, const ContactGrid& grid);

/// The scene with only one of its load points.
Scene at_point(const Scene& scene, std::size_t k);

// Additional output of `check`: relative curvatures and combined constants.

/// Multi-line text, laid out like describe() of case/reading/case_reader.hpp.
std::string derived_values(const Case& input);

}  // namespace rollfem::contact
