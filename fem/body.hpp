// A wheel or rail segment as a finite-element body: mesh on the true surface, refined towards the
// patch, degrees of freedom, boundary conditions.
#pragma once

#include "fem/linear_solver.hpp"

#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/mapping_q.h>

#include <memory>
#include <mpi.h>

namespace rollfem::fem {

/// Boundary ids of every body.
enum BoundaryId : dealii::types::boundary_id {
  far_boundary = 0,
  contact_surface = 1,
  symmetry_plane = 2
};

/// Surface coordinates (s, t) = (arc length on the surface along rolling, lateral coordinate y) and
/// depth d below the surface (along z on the rail, towards the axle on the wheel) -> place in
/// space. s points along +x, the contact reference point is (0, 0, 0). For the wheel the material
/// is above (z > 0), for the rail below.
struct SurfaceShape {
  bool is_wheel = false;
  double rolling_radius = contact::infinity;     ///< wheel only
  double transverse_radius = contact::infinity;  ///< > 0 convex, < 0 concave
  dealii::Point<3> place(double s, double t, double depth) const;
  /// Inverse of place(): (s, t, depth).
  dealii::Point<3> coordinates(const dealii::Point<3>& place) const;
  /// Unit vectors along rolling, lateral, and normal (into the wheel, for both bodies) on the
  /// surface at (s, t).
  void frame(double s, double t, dealii::Tensor<1, 3>& rolling, dealii::Tensor<1, 3>& lateral,
             dealii::Tensor<1, 3>& normal) const;
  /// The same at a surface that climbs across by dz/dy = `climb` instead of the body's own slope.
  void tilted_frame(double s, double t, double climb, dealii::Tensor<1, 3>& rolling,
                    dealii::Tensor<1, 3>& lateral, dealii::Tensor<1, 3>& normal) const;
  /// Radius of the circle on which the wheel's surface runs at lateral coordinate t, mm.
  double streamline_radius(double t) const;
};

/// What decides the mesh.
struct BodyOptions {
  double cell_size = 0.5;       ///< mm, cells in the fine region (s and t), exactly
  double fine_half_length = 5;  ///< mm, the fine region reaches at least so far in s
  double fine_half_width = 5;   ///< mm, and so far in t
  double extent = 60;           ///< mm, half length, half width and depth of the segment
  bool half = false;            ///< only t >= 0, symmetry plane t = 0
  int degree = 2;
  double fine_depth = 2;  ///< the fine region reaches that many cells below the surface
  double growth = 1;      ///< cells may be cell_size + growth * distance from the fine region
  double speed = 0;       ///< mm/s, rolling speed: inertia in the stiffness (rolling_inertia.hpp)
};

/// About as many unknowns as a body of these options will have, found by counting cells without
/// making a mesh (within 15 %). Counting stops at `enough`.
double predicted_unknowns(const BodyOptions& options, double enough);

/// Surface cells of the fine region lie on a lattice: lines at s = i h and t = j h with integers
/// i, j and h = cell_size, so that a contact grid of elements h x h can be laid exactly on faces.
class Body {
 public:
  Body(const SurfaceShape& shape, const contact::Material& material, const BodyOptions& options,
       MPI_Comm communicator);
  Body(const Body&) = delete;
  Body& operator=(const Body&) = delete;

  const SurfaceShape& shape() const { return shape_; }
  const BodyOptions& options() const { return options_; }
  const contact::Material& material() const { return material_; }
  const dealii::DoFHandler<3>& dofs() const { return dofs_; }
  const dealii::Mapping<3>& mapping() const { return mapping_; }
  const dealii::AffineConstraints<double>& constraints() const { return constraints_; }
  ElasticProblem problem() const;
  dealii::types::global_dof_index unknowns() const { return dofs_.n_dofs(); }

 private:
  SurfaceShape shape_;
  contact::Material material_;
  BodyOptions options_;
  BoundaryConditions boundary_;
  dealii::parallel::distributed::Triangulation<3> triangulation_;
  dealii::MappingQ<3> mapping_;
  dealii::DoFHandler<3> dofs_;
  dealii::AffineConstraints<double> constraints_;
};

}  // namespace rollfem::fem
