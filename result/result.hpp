// SPDX-License-Identifier: LGPL-2.1-or-later
// The result record that every model fills and every output reads. Signs: tractions and forces act
// on the wheel; traction_coefficient = -F_x / F_z so that creep curves rise with xi.
#pragma once

#include "base/grid.hpp"
#include "base/members.hpp"
#include "result/note.hpp"
#include "result/yielded_section.hpp"
#include "scene/scene.hpp"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace rollfem::contact {

/// State of a contact element; plastic: the layer between the bodies yields.
enum class ElementState : unsigned char { exterior = 0, adhesion = 1, slip = 2, plastic = 3 };

/// Everything known per contact element at one load point.
struct ContactFields {
  SurfaceField traction;      ///< MPa, on the wheel
  TangentialField slip;       ///< w = s + D u, relative to the rolling speed; also while yielding
  Field traction_bound;       ///< g = mu p_n, or the yield stress below it, MPa
  Field gap;                  ///< computed h + u_n - approach, mm: >= 0 to the tolerance; or empty
  SurfaceField displacement;  ///< u_wheel - u_rail, mm; empty for theories without it
  Field work;  ///< of friction, N/mm^2 (N mm per mm^2 and mm rolled); empty unless steadily rolling
  Field temperature_wheel, temperature_rail;  ///< degC; empty unless the case gives [rail_heat]
  std::vector<ElementState> state;
};

/// Displacement and stress at the points of one request of the case, in its order: first side
/// fastest.
struct SubsurfaceField {
  SubsurfaceRequest request;
  std::vector<std::array<double, 3>> points, displacement;
  std::vector<std::array<double, 6>> stress;
  std::string kind() const { return word_of(request.kind); }
  std::string body() const { return request.wheel ? "wheel" : "rail"; }
  int points_along() const { return request.points[0]; }
  int points_across() const { return request.points[1]; }
  std::vector<double> von_mises() const;

  static constexpr Listed listed = Listed::numbered;
  static constexpr auto members() {
    using S = SubsurfaceField;
    return std::tuple(
        member_within("request", &S::request), member("kind", &S::kind), member("body", &S::body),
        member("points_along", &S::points_along, "-"),
        member("points_across", &S::points_across, "-"),
        member("points", &S::points, "mm", "x, y, z in the global frame, z into the wheel"),
        member("displacement", &S::displacement, "mm", "displacement of the material, x, y, z"),
        member("stress", &S::stress, "MPa", "stress: xx, yy, zz, xy, yz, xz; tension positive"),
        member("von_mises", &S::von_mises, "MPa", "von Mises stress"));
  }
};

/// Largest value of a scalar stress measure in a body (stress_measures.hpp), with its position.
struct StressMaximum {
  std::string body;
  std::string measure;
  double value = 0.0;
  std::array<double, 3> place{};

  /// "max_von_mises_wheel": of its error bar.
  std::string bar_name() const;

  static constexpr Listed listed = Listed::as_table;
  static constexpr auto members() {
    using S = StressMaximum;
    return std::tuple(
        member("body", &S::body, "", "wheel or rail"),
        member("measure", &S::measure, "", "stress measure"),
        member("value", &S::value, "MPa", "largest value"),
        member("place", &S::place, "mm", "x, y, z in the global frame, z into the wheel"));
  }
};

/// Displacement and stress at the nodes of a body under one load point. Single precision: relative
/// error 6e-8, far below the accuracy of the elements, at half the memory and file size.
struct BodyValues {
  std::vector<std::array<float, 3>> displacement;
  std::vector<std::array<float, 6>> stress;
  // Of a body that yields, else empty: in the order of stress, by plastic strain alone (MPa), and
  // the accumulated strain.
  std::vector<std::array<float, 6>> plastic_strain{}, residual_stress{};
  std::vector<float> accumulated{};

  static constexpr auto members() {
    using S = BodyValues;
    return std::tuple(
        member("displacement", &S::displacement, "mm", "displacement of the nodes, x, y, z"),
        member("stress", &S::stress, "MPa", "stress: xx, yy, zz, xy, yz, xz; tension positive"),
        member_within("plastic_strain", &S::plastic_strain),
        member_within("residual_stress", &S::residual_stress),
        member_within("accumulated", &S::accumulated));
  }
};

/// One load point of one model: the entries of summary.json and the fields behind them. What its
/// scalars are, with unit and sign, stands in quantities.cpp.
struct PointResult {
  Creepage creepage;
  int step = 0;
  double longitudinal_shift = 0.0, lateral_shift = 0.0, spin_shift = 0.0, distance = 0.0;
  double normal_force = 0.0, longitudinal_force = 0.0, lateral_force = 0.0;
  double lateral_pressure = 0.0;
  double spin_moment = 0.0;
  double traction_coefficient = 0.0;
  double max_pressure = 0.0, max_traction = 0.0, max_traction_x = 0.0;
  double approach = 0.0;
  double semi_axis_x = 0.0, semi_axis_y = 0.0;
  double contact_length = 0.0, contact_width = 0.0, contact_area = 0.0, adhesion_area = 0.0;
  int patch_count = 1;
  int iterations = 0;
  double residual = 0.0;
  double seconds = 0.0;
  bool converged = false;
  /// Error bars: quantity -> estimated absolute error of its value from grid and solver, in its
  /// unit (docs/results.md).
  std::map<std::string, double> error_estimate;
  std::map<std::string, NoBar> no_bar;  ///< quantity -> why it has no bar
  /// The error bar of a quantity; none without one.
  std::optional<double> bar_of(const std::string& quantity) const;
  bool has_bar(const std::string& quantity) const { return error_estimate.count(quantity) != 0; }
  /// Model error: quantity -> absolute error of the model itself, independent of the grid.
  std::map<std::string, double> model_error;
  std::map<std::string, double> richardson;  ///< quantity -> value extrapolated to cells of 0
  // Quantities that not every model gives.
  std::optional<double> elastic_energy, frictional_work, creepage_work;
  std::optional<double> max_pass_work, pass_work_y_wheel, pass_work_y_rail, revolution_work;
  std::optional<double> patch_x_middle, patch_y_middle;
  std::optional<double> vertical_force, lateral_force_track, loaded_height;
  // Where the case gives the heat of the bodies.
  std::optional<double> max_temperature, max_temperature_x, max_temperature_y;
  std::optional<double> heat_wheel, heat_rail;
  // After a pass over bodies that yield, of the body with the largest.
  std::optional<double> plastic_strain, plastic_increment, net_plastic_increment;
  std::optional<double> residual_stress, groove_depth, forward_flow, plastic_work;
  ContactFields fields;
  std::vector<SubsurfaceField> subsurface;   ///< as requested by the case
  std::vector<StressMaximum> stress_maxima;  ///< of both bodies
  std::vector<YieldedSection> yielded;       ///< of bodies that yield
  /// In the order of ModelResult::bodies; empty if not stored, and for models other than fem.
  std::vector<BodyValues> bodies;

  /// Beside the scalars and the fields (quantities.hpp).
  static constexpr auto members() {
    using S = PointResult;
    return std::tuple(
        member("error_estimate", &S::error_estimate, "",
               "Attributes: estimated error by quantity, in its unit"),
        member("no_bar", &S::no_bar, "",
               "Attributes: why a quantity has no error estimate, docs/results.md"),
        member_if_given("model_error", &S::model_error, "",
                        "Attributes: model error by quantity, in its unit"),
        member_if_given("richardson", &S::richardson, "",
                        "Attributes: values extrapolated to cells of size 0"),
        member_if_given("subsurface", &S::subsurface, "",
                        "Points below the surface, as requested, first side fastest"),
        member_if_given("stress_maxima", &S::stress_maxima, "",
                        "Largest stresses of wheel and rail, with their places"),
        member_if_given("yielded", &S::yielded, "",
                        "Bodies that yield after this pass: the section behind the load, "
                        "streamlines [down, across] with y fastest"),
        member_within("bodies", &S::bodies));
  }
};

/// A body as hexahedra with eight corners each, with or without values at its nodes.
struct BodyField {
  std::string name;  ///< "wheel", "rail"
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<int, 8>> cells;  ///< VTK_HEXAHEDRON order
  std::vector<std::array<double, 3>> displacement;
  std::vector<std::array<double, 6>> stress;

  static constexpr auto members() {
    using S = BodyField;
    return std::tuple(
        member_within("name", &S::name),
        member("points", &S::points, "mm",
               "x, y, z of the undeformed nodes in the global frame, z into the "
               "wheel"),
        member("cells", &S::cells, "-", "nodes of every hexahedron, from 0, in VTK's order"),
        member_within("displacement", &S::displacement), member_within("stress", &S::stress));
  }
};

/// The rows of a contact grid on the profiles: y in the coordinates of their files (without
/// profiles y of the patch frame), and width.
struct ProfileRows {
  Field y_wheel, y_rail, width;

  static constexpr auto members() {
    using S = ProfileRows;
    return std::tuple(
        member_if_given("y_wheel", &S::y_wheel, "mm", "of the rows, on the wheel's profile"),
        member_if_given("y_rail", &S::y_rail, "mm", "of the rows, on the rail's profile"),
        member_if_given("width", &S::width, "mm", "of the rows, along the surface"));
  }
};

struct ModelResult {
  std::string name;                       ///< "hertz", "linear", ... "halfspace", "fem"
  std::string label;                      ///< name in figures; empty: the name
  std::optional<ContactPlace> place;      ///< with profiles: the patch, one ModelResult for each
  std::map<std::string, double> seconds;  ///< total, setup, normal, tangential, ...
  long unknowns = 0;
  int contact_elements = 0;
  /// Why `auto` chose this model and grid; empty if it did not.
  std::string choice;
  /// A request that was not met although the results are valid; otherwise empty. The run then ends
  /// with status 1 after writing them.
  std::string shortfall;
  std::vector<Note> notes;          ///< domain, symmetry, limits, sources of errors
  std::vector<std::string> traits;  ///< what holds of the model, as registered; for figures
  ContactGrid grid;
  ProfileRows rows;  ///< empty for theories without slip
  std::vector<PointResult> points;
  std::vector<BodyField> bodies;  ///< undeformed, without values (PointResult::bodies); fem only
  /// Whether a load point has the model error of a quantity.
  bool has_model_error() const;
  /// Appends a note, or replaces the one about the same subject.
  void set_note(Note note);
  const Note* note_about(const std::string& subject) const;  ///< null if there is none
  /// False for Hertz and other theories of the normal problem.
  bool has_friction() const;
  double total_seconds() const;  ///< 0: not measured
  /// Unique key of a result in a run: "halfspace", or "halfspace_left_3_1" for the first patch of
  /// the left wheel at position 3.
  std::string key() const;
  /// Entry `body` of `bodies` with its values at a load point that stores them.
  BodyField body_at(std::size_t point, std::size_t body) const;
  /// Load points that store the values of all bodies, from 0.
  std::vector<std::size_t> points_with_bodies() const;

  static constexpr auto members() {
    using S = ModelResult;
    return std::tuple(
        member_within("name", &S::name), member_if_given("label", &S::label),
        member_if_given("place", &S::place, "",
                        "Attributes: place of the patch on the track and on the profiles"),
        member("seconds", &S::seconds, "", "Attributes: seconds by stage"),
        member("unknowns", &S::unknowns, "-"),
        member("contact_elements", &S::contact_elements, "-"),
        member_if_given("choice", &S::choice), member_if_given("shortfall", &S::shortfall),
        member("notes", &S::notes, "", "Notes: domain, symmetry, limits"),
        member_within("traits", &S::traits), member_within("grid", &S::grid),
        member_within("rows", &S::rows), member_within("points", &S::points),
        member_within("bodies", &S::bodies));
  }
};

/// Force of tractions on the wheel along x, y, z of the patch frame, N. On a curved patch (`shape`)
/// tractions are along the local tangents and normal. Empty tangential components count as 0.
std::array<double, 3> transmitted_force(const ContactGrid& grid, const SurfaceField& traction,
                                        const PatchShape& shape = {});

/// Fills forces, maxima, patch size and areas of `point` from its fields. On a curved patch
/// (`shape`) tractions are along the local tangents and normal, forces along x, y, z: extents are
/// those of the projection, areas those of the surface.
void integrate_tractions(const ContactGrid& grid, PointResult& point, const PatchShape& shape = {});

}  // namespace rollfem::contact
