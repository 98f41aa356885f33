// SPDX-License-Identifier: LGPL-2.1-or-later
// A wheel or rail segment as a finite-element body: mesh on the true surface, refined towards the
// patch, degrees of freedom, boundary conditions.
#pragma once

#include "fem/discretisation/elastic_problem.hpp"
#include "fem/mesh/body_options.hpp"
#include "fem/mesh/surface_shape.hpp"

#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/mapping_q.h>

#include <array>
#include <functional>
#include <mpi.h>

namespace rollfem::fem {

/// In the family `structured` surface cells of the fine region lie on a lattice: lines at s = i h
/// and t = j h with integers i, j and h = cell_size, so that a contact grid of elements h x h can
/// be laid exactly on faces. Otherwise they are at most h long in s and t.
class Body {
 public:
  /// A segment of wheel or rail, meshed by rollfem.
  Body(const SurfaceShape& shape, const contact::Material& material, const BodyOptions& options,
       MPI_Comm communicator);
  /// On a given coarse mesh, which is refined towards the patch; nodes of its `contact` faces lie
  /// on the surface (depth 0 in the chart). `fixed` faces are clamped, on `symmetry` faces the
  /// lateral displacement vanishes, others are free. Extents in the options are ignored. Throws
  /// contact::InputError when cells become inverted or more than 7 octree levels would be needed.
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

 private:
  Body(const SurfaceShape& shape, const contact::Material& material, const BodyOptions& options,
       MPI_Comm communicator, const std::function<void(Body&)>& make_mesh);

  SurfaceShape shape_;
  contact::Material material_;
  BodyOptions options_;
  dealii::parallel::distributed::Triangulation<3> triangulation_;
  dealii::MappingQ<3> mapping_;
  dealii::DoFHandler<3> dofs_;
  dealii::AffineConstraints<double> constraints_;
};

/// Wheel and rail; null: rigid.
using BodyPair = std::array<const Body*, 2>;
inline constexpr std::array<const char*, 2> body_names{"wheel", "rail"};

}  // namespace rollfem::fem
