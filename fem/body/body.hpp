// A wheel or rail segment as a finite-element body: mesh on the true surface, refined towards the
// patch, degrees of freedom, boundary conditions.
#pragma once

#include "contact/base/profile_drop.hpp"
#include "fem/solver/linear_solver.hpp"
#include "meshes/gmsh/hex_mesh.hpp"

#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/mapping_q.h>

#include <functional>
#include <memory>
#include <mpi.h>
#include <optional>
#include <vector>

namespace rollfem::fem {

/// Boundary ids of every body.
enum BoundaryId : dealii::types::boundary_id {
  far_boundary = 0,
  contact_surface = 1,
  symmetry_plane = 2,
  free_surface = 3  ///< sides of a given mesh that are in none of its groups
};

/// A chart of another surface than those of wheel and rail, for bodies that are built by hand (a
/// disc in a hole). All three are given; what they mean is what SurfaceShape says.
struct ChartFunctions {
  std::function<dealii::Point<3>(const dealii::Point<3>& chart)> place;
  std::function<dealii::Point<3>(const dealii::Point<3>& place)> coordinates;
  /// Unit vectors along rolling, lateral, normal (into the upper body) at (s, t).
  std::function<std::array<dealii::Tensor<1, 3>, 3>(double s, double t)> frame;
};

class ProfileShape;

/// Surface coordinates (s, t) = (arc length on the surface along rolling, lateral coordinate y) and
/// depth d below the surface (along z on the rail, towards the axle on the wheel) -> place in
/// space. s points along +x, the contact reference point is (0, 0, 0). For the wheel the material
/// is above (z > 0), for the rail below.
struct SurfaceShape {
  bool is_wheel = false;
  double rolling_radius = contact::infinity;     ///< wheel only
  double transverse_radius = contact::infinity;  ///< > 0 convex, < 0 concave
  /// When given, these are the chart; the radii then say nothing of it.
  std::shared_ptr<const ChartFunctions> functions = nullptr;
  /// When given, the chart of a true profile about an axle that may be tilted; the transverse
  /// radius then says nothing, the rolling radius is that of t = 0.
  std::shared_ptr<const ProfileShape> profile = nullptr;
  double round_to = contact::usual_round_to;  ///< part of the transverse radius
  /// How far the circle across has dropped at t.
  contact::ProfileDrop drop_at(double t) const;
  dealii::Point<3> place(double s, double t, double depth) const;
  /// Inverse of place(): (s, t, depth).
  dealii::Point<3> coordinates(const dealii::Point<3>& place) const;
  /// Unit vectors along rolling, lateral, and normal (into the wheel, for both bodies) on the
  /// surface at (s, t).
  void frame(double s, double t, dealii::Tensor<1, 3>& rolling, dealii::Tensor<1, 3>& lateral,
             dealii::Tensor<1, 3>& normal) const;
  /// The same at a surface that climbs across by dz/dy = `climb` instead of the body's own slope
  /// (of chart functions: their own frame).
  void tilted_frame(double s, double t, double climb, dealii::Tensor<1, 3>& rolling,
                    dealii::Tensor<1, 3>& lateral, dealii::Tensor<1, 3>& normal) const;
  /// Radius of the circle on which the wheel's surface runs at lateral coordinate t, mm.
  double streamline_radius(double t) const;
  /// A wheel of finite radius: its streamlines are circles.
  bool is_revolved() const;
  /// Where the surface can be meshed between; infinite but for profiles.
  double lower_t() const;
  double upper_t() const;
};

/// Wheel or rail of a patch with true profiles.
SurfaceShape profile_surface(std::shared_ptr<const contact::PatchGeometry> geometry, bool is_wheel);

using MeshFamily = contact::MeshFamily;

/// What decides the mesh.
struct BodyOptions {
  double cell_size = 0.5;       ///< mm, cells in the fine region (s and t), exactly
  double fine_half_length = 5;  ///< mm, the fine region reaches at least so far in s
  double fine_half_width = 5;   ///< mm, and so far in t to both sides of `middle`
  double middle = 0;            ///< mm, t of the middle of the patch; a whole number of cells
  double extent = 60;           ///< mm, half length, half width and depth of the segment
  bool half = false;            ///< only t >= 0, symmetry plane t = 0
  int degree = 2;
  double fine_depth = 2;  ///< the fine region reaches that many cells below the surface
  double growth = 1;      ///< cells may be cell_size + growth * distance from the fine region
  double speed = 0;       ///< mm/s, rolling speed: inertia in the stiffness (rolling_inertia.hpp)
  MeshFamily family = MeshFamily::structured;
  std::optional<double> half_length = std::nullopt;  ///< mm, in place of extent along s
  std::optional<double> half_width = std::nullopt;   ///< mm, in place of extent along t
  std::optional<double> depth = std::nullopt;        ///< mm, in place of extent inwards
  double reach_s() const { return half_length.value_or(extent); }
  double reach_t() const { return half_width.value_or(extent); }
  double reach_depth() const { return depth.value_or(extent); }
};

/// About as many unknowns as a body of these options will have, found by counting cells without
/// making a mesh (within 15 % in the family `structured`). Counting stops at `enough`.
double predicted_unknowns(const BodyOptions& options, double enough);

/// Of a coarse mesh that is given: which of its cells are bent to the surface. In the others new
/// nodes lie on straight lines, of a wheel on circles about its axle.
struct CoarseBody {
  meshes::HexMesh mesh;
  std::vector<bool> follows_surface;  ///< of each cell; empty: all of them
};

/// In the family `structured` surface cells of the fine region lie on a lattice: lines at s = i h
/// and t = j h with integers i, j and h = cell_size, so that a contact grid of elements h x h can
/// be laid exactly on faces. Otherwise they are at most h long in s and t.
class Body {
 public:
  /// A segment of wheel or rail, meshed by the program.
  Body(const SurfaceShape& shape, const contact::Material& material, const BodyOptions& options,
       MPI_Comm communicator);
  /// On a given coarse mesh, which is refined towards the patch; nodes of its `contact` faces lie
  /// on the surface (depth 0 in the chart). `fixed` faces are clamped, on `symmetry` faces the
  /// lateral displacement vanishes, others are free. Extents of the options are not used. Throws
  /// contact::InputError when cells turn inside out or more than 7 octree levels were wanted.
  Body(const SurfaceShape& shape, const contact::Material& material, const BodyOptions& options,
       const meshes::HexMesh& coarse, MPI_Comm communicator);
  /// The same of a mesh of which only a part follows the surface: a true section of wheel or rail.
  Body(const SurfaceShape& shape, const contact::Material& material, const BodyOptions& options,
       const CoarseBody& coarse, MPI_Comm communicator);
  Body(const Body&) = delete;
  Body& operator=(const Body&) = delete;

  const SurfaceShape& shape() const { return shape_; }
  const BodyOptions& options() const { return options_; }
  const contact::Material& material() const { return material_; }
  const dealii::Triangulation<3>& triangulation() const { return triangulation_; }
  const dealii::DoFHandler<3>& dofs() const { return dofs_; }
  const dealii::Mapping<3>& mapping() const { return mapping_; }
  const dealii::AffineConstraints<double>& constraints() const { return constraints_; }
  ElasticProblem problem() const;
  dealii::types::global_dof_index unknowns() const { return dofs_.n_dofs(); }
  /// The mesh before refinement, the same on every process.
  meshes::HexMesh coarse_mesh() const;

 private:
  void distribute();

  SurfaceShape shape_;
  contact::Material material_;
  BodyOptions options_;
  BoundaryConditions boundary_;
  dealii::parallel::distributed::Triangulation<3> triangulation_;
  dealii::MappingQ<3> mapping_;
  dealii::DoFHandler<3> dofs_;
  dealii::AffineConstraints<double> constraints_;
};

/// Wheel and rail; null: rigid.
using BodyPair = std::array<const Body*, 2>;
inline constexpr std::array<const char*, 2> body_names{"wheel", "rail"};

}  // namespace rollfem::fem
