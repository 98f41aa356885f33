// SPDX-License-Identifier: LGPL-2.1-or-later
// Degrees of freedom, constraints and boundary conditions on the mesh of a body.
#include "fem/discretisation/body.hpp"

#include "fem/discretisation/elastic_problem.hpp"
#include "fem/mesh/body_mesh.hpp"

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>

#include <algorithm>

namespace rollfem::fem {

namespace {

/// On bodies without a symmetry plane its condition concerns no face.
const BoundaryConditions conditions{{far_boundary}, {{symmetry_plane, 1}}};

}  // namespace

Body::Body(const SurfaceShape& shape, const contact::Material& material, const BodyOptions& options,
           MPI_Comm communicator, const std::function<void(Body&)>& make)
    : shape_(shape),
      material_(material),
      options_(options),
      triangulation_(communicator),
      mapping_(std::max(2, options.degree)),
      dofs_(triangulation_) {
  make(*this);
  dofs_.distribute_dofs(dealii::FESystem<3>(dealii::FE_Q<3>(options.degree), 3));
  constraints_ = make_constraints(dofs_, mapping_, conditions);
}

Body::Body(const SurfaceShape& shape, const contact::Material& material, const BodyOptions& options,
           MPI_Comm communicator)
    : Body(shape, material, options, communicator,
           [&](Body& body) { make_mesh(shape, options, body.triangulation_); }) {}

Body::Body(const SurfaceShape& shape, const contact::Material& material, const BodyOptions& options,
           const CoarseBody& coarse, MPI_Comm communicator)
    : Body(shape, material, options, communicator, [&](Body& body) {
        refine_coarse_mesh(shape, options, coarse, body.mapping_, body.triangulation_);
      }) {}

ElasticProblem Body::problem() const {
  ElasticProblem problem{dofs_,      mapping_,  constraints_,
                         conditions, material_, material_motion(shape_, options_.speed)};
  if (options_.yields) problem.project_dilatation = true;
  return problem;
}

}  // namespace rollfem::fem
