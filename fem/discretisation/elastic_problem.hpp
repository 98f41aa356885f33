// SPDX-License-Identifier: LGPL-2.1-or-later
// Linear elasticity of one discretised body: unknowns, constraints, material, vectors of its
// unknowns, and the terms of its stiffness.
#pragma once

#include "result/stress_measures.hpp"
#include "scene/scene.hpp"

#include <deal.II/base/index_set.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <deal.II/base/types.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

namespace rollfem::fem {

// The rigid flow of material through a mesh that is fixed in the frame of the contact.

struct SurfaceShape;

/// v(x) = velocity + rotation x (x - centre): divergence-free, so that steady inertia has the
/// symmetric form in docs/theory.md. All zero: material at rest.
struct MaterialMotion {
  dealii::Tensor<1, 3> velocity;  ///< mm/s
  dealii::Tensor<1, 3> rotation;  ///< rad/s
  dealii::Point<3> centre;        ///< mm, on the axle

  bool at_rest() const { return velocity.norm_square() == 0 && rotation.norm_square() == 0; }
  dealii::Tensor<1, 3> at(const dealii::Point<3>& place) const {
    return velocity + dealii::cross_product_3d(rotation, place - centre);
  }
};

/// Material comes from +x at the contact: the rail moves rigidly with -speed along x, the wheel
/// turns about its axle with speed / rolling_radius (a flat "wheel" moves like the rail). mm/s.
MaterialMotion material_motion(const SurfaceShape& shape, double speed);

using Vector = dealii::LinearAlgebra::distributed::Vector<double>;

/// Homogeneous displacement conditions by boundary id.
struct BoundaryConditions {
  std::set<dealii::types::boundary_id> clamped;
  /// Symmetry planes: the displacement component that vanishes there (1 for the plane y = 0).
  std::map<dealii::types::boundary_id, unsigned int> vanishing_component;
};

/// A discretised body: FE_Q(degree)^3 dofs on a parallel::distributed triangulation. All referenced
/// objects must outlive the solver. `constraints` holds hanging nodes and boundary conditions.
struct ElasticProblem {
  const dealii::DoFHandler<3>& dofs;
  const dealii::Mapping<3>& mapping;
  const dealii::AffineConstraints<double>& constraints;
  BoundaryConditions boundary;
  contact::Material material;
  MaterialMotion motion = {};  ///< for material with a density: adds inertia to K
  /// Whether the dilatation is projected (projects_dilatation()); unset: according to Poisson's
  /// ratio.
  std::optional<bool> project_dilatation = {};
};

/// Unknowns of the cells of this process and of adjacent cells.
dealii::IndexSet relevant_dofs(const dealii::DoFHandler<3>& dofs);

/// Hanging nodes and boundary conditions for any level of a body.
dealii::AffineConstraints<double> make_constraints(const dealii::DoFHandler<3>& dofs,
                                                   const dealii::Mapping<3>& mapping,
                                                   const BoundaryConditions& boundary);

/// Ghosted vector laid out for `dofs` (locally relevant).
Vector make_vector(const dealii::DoFHandler<3>& dofs);

// Terms of a cell's stiffness beyond pointwise Hooke's law: projected dilatation of nearly
// incompressible materials, inertia of material flowing through the mesh. Shared by the assembly,
// the matrix-free operator and everything that computes stresses.

/// Poisson's ratio above which the dilatation is projected.
inline constexpr double largest_plain_poisson_ratio = 0.45;

/// Lame's constants in MPa.
double lame_lambda(const contact::Material& material);
double lame_mu(const contact::Material& material);

/// Whether the problem's dilatation is projected: its own setting if any, otherwise for Poisson's
/// ratios above the limit. Degrees above 2 do not lock and are never projected.
bool projects_dilatation(const ElasticProblem& problem);

/// Whether inertia is part of the problem's stiffness.
bool has_inertia(const ElasticProblem& problem);

/// The functions onto which a cell's dilatation is projected: constants for degree 1 (Q1-P0),
/// linear functions of position for degree 2 (Q2-P1, discontinuous, which passes the inf-sup
/// condition: Boffi, Brezzi and Fortin, Mixed finite element methods and applications, 2013).
/// Orthonormal in the cell's own quadrature.
class DilatationSpace {
 public:
  static constexpr int largest_size = 4;
  static constexpr int size_of_degree(int degree) { return degree == 1 ? 1 : largest_size; }

  explicit DilatationSpace(int degree) : size_(size_of_degree(degree)) {}
  int size() const { return size_; }
  /// Points and weights of the cell's quadrature.
  void reinit(const std::vector<dealii::Point<3>>& places, const std::vector<double>& weights);
  /// The functions at a point; entries beyond size() are 0.
  std::array<double, largest_size> values(const dealii::Point<3>& place) const;

 private:
  std::array<double, largest_size> monomials(const dealii::Point<3>& place) const;

  int size_;
  dealii::Point<3> centre_;
  double length_ = 1;
  std::array<std::array<double, largest_size>, largest_size> factor_{};  ///< Gram matrix = L L^T
};

/// A symmetric tensor and its components xx yy zz xy yz xz.
dealii::Tensor<2, 3> tensor_of(const contact::SymmetricTensor& components);
contact::SymmetricTensor components_of(const dealii::Tensor<2, 3>& tensor);

/// Stress by Hooke's law, cell by cell, sigma = lambda P(div u) I + 2 mu eps(u), with the same
/// projection P (or none) as in the stiffness: with the unprojected dilatation the pressure of a
/// nearly incompressible body would be noise.
class CellStress {
 public:
  explicit CellStress(const ElasticProblem& problem);
  /// `displacement` must have updated ghost values.
  void reinit(const dealii::DoFHandler<3>::active_cell_iterator& cell, const Vector& displacement);
  /// xx yy zz xy yz xz in MPa at a point of the cell where the displacement has this gradient,
  /// gradient[i][j] = du_i/dx_j.
  contact::SymmetricTensor at(const dealii::Tensor<2, 3>& gradient,
                              const dealii::Point<3>& place) const;

 private:
  double lambda_, mu_;
  std::unique_ptr<dealii::FEValues<3>> values_;  ///< null: not projected
  DilatationSpace space_;
  std::vector<double> divergences_;
  std::array<double, DilatationSpace::largest_size> coefficients_{};
};

}  // namespace rollfem::fem
