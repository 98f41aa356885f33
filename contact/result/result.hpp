// SPDX-License-Identifier: LGPL-2.1-or-later
// The result record that every model fills and every output reads. Signs: tractions and forces act
// on the wheel; traction_coefficient = -F_x / F_z so that creep curves rise with xi.
#pragma once

#include "contact/base/grid.hpp"
#include "contact/result/yielded_section.hpp"
#include "contact/scene/scene.hpp"

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
  std::vector<ElementState> state;
};

/// Displacement and stress at the points of one request of the case, in its order: first side
/// fastest.
struct SubsurfaceField {
  SubsurfaceRequest request;
  std::vector<std::array<double, 3>> points;        ///< mm, global frame
  std::vector<std::array<double, 3>> displacement;  ///< mm, of the body's own material point
  std::vector<std::array<double, 6>> stress;        ///< MPa: xx yy zz xy yz xz
};

/// Largest value of a scalar stress measure in a body (stress_measures.hpp), with its position.
struct StressMaximum {
  std::string body;               ///< "wheel", "rail"
  std::string measure;            ///< "von_mises", "tresca", "orthogonal_shear", "principal_1"
  double value = 0.0;             ///< MPa
  std::array<double, 3> place{};  ///< mm, global frame
};

/// Displacement and stress at the nodes of a body under one load point. Single precision: relative
/// error 6e-8, far below the accuracy of the elements, at half the memory and file size.
struct BodyValues {
  std::vector<std::array<float, 3>> displacement;  ///< mm
  std::vector<std::array<float, 6>> stress;        ///< MPa: xx yy zz xy yz xz
  // Of a body that yields, else empty.
  std::vector<std::array<float, 6>> plastic_strain{};   ///< in the order of stress
  std::vector<std::array<float, 6>> residual_stress{};  ///< MPa, by plastic strain alone
  std::vector<float> accumulated{};                     ///< plastic strain
};

/// One load point of one model: the entries of summary.json and the fields behind them. Its scalars
/// are declared in quantities.hpp.
struct PointResult {
  Creepage creepage;  ///< as prescribed, or as found for a prescribed force
  int step = 0;       ///< 1, 2, ... in a history (problems shift and transient), else 0
  double longitudinal_shift = 0.0;  ///< mm, of the wheel over the rail since the beginning
  double lateral_shift = 0.0;       ///< mm, since the beginning
  double spin_shift = 0.0;          ///< rad, since the beginning
  double distance = 0.0;            ///< mm rolled since the beginning
  double normal_force = 0.0;        ///< N
  double longitudinal_force = 0.0;  ///< F_x, N, on the wheel
  double lateral_force = 0.0;       ///< F_y, N, on the wheel
  double lateral_pressure = 0.0;    ///< N, part of it carried by the pressure of a curved patch
  double spin_moment = 0.0;         ///< M_z, N mm, about the origin
  double traction_coefficient = 0.0;
  double max_pressure = 0.0;    ///< MPa
  double max_traction = 0.0;    ///< largest |p_t|, MPa
  double max_traction_x = 0.0;  ///< largest |p_x|, MPa
  double approach = 0.0;        ///< mm
  double semi_axis_x = 0.0;     ///< mm, found below the element size
  double semi_axis_y = 0.0;
  double contact_length = 0.0;  ///< mm, extent of the patch in x
  double contact_width = 0.0;   ///< mm, extent across, along the surface
  double contact_area = 0.0;    ///< mm^2
  double adhesion_area = 0.0;   ///< mm^2
  int patch_count = 1;          ///< regions that do not touch each other
  int iterations = 0;           ///< outer iterations (FE solves) or Newton steps
  double residual = 0.0;        ///< relative residual at which the iteration stopped
  double seconds = 0.0;
  bool converged = false;
  /// Error bars: quantity -> estimated absolute error of its value from grid and solver, in its
  /// unit (docs/results.md).
  std::map<std::string, double> error_estimate;
  std::map<std::string, std::string> no_bar;  ///< quantity -> why it has no bar (bars.hpp)
  /// Model error: quantity -> absolute error of the model itself, independent of the grid.
  std::map<std::string, double> model_error;
  std::map<std::string, double> richardson;  ///< quantity -> value extrapolated to cells of 0
  // Quantities that not every model gives.
  std::optional<double> elastic_energy;   ///< N mm
  std::optional<double> frictional_work;  ///< N mm per mm rolled; steady rolling only
  std::optional<double> creepage_work;    ///< equal for half-spaces
  /// N/mm, largest of pass_work (contact/result/derived.hpp), and where, y in the coordinates of
  /// the profiles, mm.
  std::optional<double> max_pass_work, pass_work_y_wheel, pass_work_y_rail;
  std::optional<double> revolution_work;  ///< J, frictional work per revolution of the wheel
  /// mm, middle of the extents of the patch, with profiles, where it differs from the origin.
  std::optional<double> patch_x_middle;
  std::optional<double> patch_y_middle;
  // With profiles, in the track frame.
  std::optional<double> vertical_force;       ///< N, on the wheel, up, friction included
  std::optional<double> lateral_force_track;  ///< N, on the wheel, to the right
  std::optional<double> loaded_height;        ///< mm, of the axle's middle, as ContactPlace::height
  // After a pass over bodies that yield, of the body with the largest.
  std::optional<double> plastic_strain, plastic_increment, net_plastic_increment;
  std::optional<double> residual_stress;  ///< MPa, largest compression along rolling
  std::optional<double> groove_depth;     ///< mm
  std::optional<double> forward_flow;     ///< mm, of the surface, along +x where it is largest
  std::optional<double> plastic_work;     ///< N mm per mm of track, of both bodies
  ContactFields fields;
  std::vector<SubsurfaceField> subsurface;   ///< as requested by the case
  std::vector<StressMaximum> stress_maxima;  ///< of both bodies
  std::vector<YieldedSection> yielded;       ///< of bodies that yield
  /// In the order of ModelResult::bodies; empty if not stored, and for models other than fem.
  std::vector<BodyValues> bodies;
};

/// A body as hexahedra with eight corners each, with or without values at its nodes.
struct BodyField {
  std::string name;                                 ///< "wheel", "rail"
  std::vector<std::array<double, 3>> points;        ///< mm
  std::vector<std::array<int, 8>> cells;            ///< VTK_HEXAHEDRON order
  std::vector<std::array<double, 3>> displacement;  ///< mm, per point
  std::vector<std::array<double, 6>> stress;        ///< MPa: xx yy zz xy yz xz, per point
};

/// The rows of a contact grid on the profiles, mm: y in the coordinates of their files (without
/// profiles y of the patch frame), and width along the surface.
struct ProfileRows {
  Field y_wheel, y_rail, width;
};

struct ModelResult {
  std::string name;                       ///< "hertz", "linear", ... "halfspace", "fem"
  std::string label;                      ///< name in figures; empty: the name
  std::map<std::string, double> seconds;  ///< total, setup, normal, tangential, ...
  long unknowns = 0;
  int contact_elements = 0;
  ContactGrid grid;
  ProfileRows rows;  ///< empty for theories without slip
  std::vector<PointResult> points;
  std::vector<BodyField> bodies;   ///< undeformed, without values (PointResult::bodies); fem only
  std::vector<std::string> notes;  ///< notes for the reader: domain, symmetry, limits
  /// Source of PointResult::model_error, or why there is none.
  std::string model_error_source;
  /// Whether a load point has the model error of a quantity.
  bool has_model_error() const;
  /// False for Hertz and other theories of the normal problem.
  bool has_friction() const;
  double total_seconds() const;  ///< 0: not measured
  /// Why `auto` chose this model and grid; empty if it did not.
  std::string choice;
  /// A request that was not met although the results are valid; otherwise empty. The run then ends
  /// with status 1 after writing them.
  std::string shortfall;
  std::optional<ContactPlace> place;  ///< with profiles: the patch, one ModelResult for each
  /// Unique key of a result in a run: "halfspace", or "halfspace_left_3_1" for the first patch of
  /// the left wheel at position 3.
  std::string key() const;
  /// Entry `body` of `bodies` with its values at a load point that stores them.
  BodyField body_at(std::size_t point, std::size_t body) const;
  /// Load points that store the values of all bodies, from 0.
  std::vector<std::size_t> points_with_bodies() const;
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
