// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/case/keys/key_builder.hpp"

namespace rollfem::contact {

namespace {

using FemKeys = Keys<FemOptions>;

void add_elements(FemKeys& keys) {
  keys.real("cell_size")
      .symbol("h")
      .unit("mm")
      .positive()
      .otherwise("chosen from the size of the patch")
      .says("Size of a finite element in the patch, and of a contact element of this model.")
      .into(&FemOptions::cell_size);
  keys.integer("degree")
      .between(1, 2)
      .says(
          "Polynomial degree of the displacement; 1 is 15 to 20 times less accurate on the same "
          "cells, with contact elements of two by two cells.")
      .into(&FemOptions::degree);
  keys.real("extent")
      .symbol("L")
      .unit("mm")
      .positive()
      .otherwise("chosen from the size of the patch")
      .says("Distance from the middle of the patch to which wheel and rail are meshed.")
      .into(&FemOptions::extent);
  keys.real("fine_extent")
      .symbol("c")
      .between(1.0, 10.0)
      .otherwise("chosen by the model")
      .says("Extent of the finest cells, in semi-axes of the patch; more than 1.1 gains nothing.")
      .into(&FemOptions::fine_extent);
  keys.choice("linear_solver")
      .says(
          "`automatic` chooses the one expected to be faster; `algebraic` (Trilinos ML) is for "
          "imported meshes too fine to serve as a coarse level.")
      .into(&FemOptions::linear_solver, {{"automatic", LinearSolver::automatic},
                                         {"factorisation", LinearSolver::factorisation},
                                         {"multigrid", LinearSolver::multigrid},
                                         {"algebraic", LinearSolver::algebraic}});
  keys.toggle("inertia")
      .says(
          "Include the inertia of wheel and rail and the wheel's centrifugal load at "
          "rolling.speed, below 0.9 of the slower body's Rayleigh wave speed.")
      .into(&FemOptions::inertia);
}

void add_meshes(FemKeys& keys) {
  keys.choice("mesh")
      .otherwise("`structured`")
      .says(
          "`structured` lays a graded box on the surface; `gmsh` revolves or extrudes a "
          "quadrilateral mesh of the cross-section, with profiles the true section of rail and "
          "wheel rim.")
      .into(&FemOptions::mesh,
            {{"structured", MeshFamily::structured}, {"gmsh", MeshFamily::gmsh}});
  keys.real("width")
      .unit("mm")
      .positive()
      .otherwise("twice the extent")
      .says("Width of the segments across rolling.")
      .into(&FemOptions::width);
  keys.real("depth")
      .unit("mm")
      .positive()
      .otherwise("the extent; for true sections 172 (rail foot)")
      .says(
          "Depth of the segments; for the true section of a rail the depth below its top at which "
          "it is cut and fixed.")
      .into(&FemOptions::depth);
  keys.real("rim_thickness")
      .unit("mm")
      .positive()
      .otherwise("65")
      .says(
          "Thickness of the wheel's rim below the contact in a true section; its inner side is "
          "fixed.")
      .into(&FemOptions::rim_thickness);
  keys.real("length")
      .unit("mm")
      .positive()
      .otherwise("twice the extent")
      .says("Length of the segments along rolling, on the wheel of the arc.")
      .into(&FemOptions::length);
  keys.choice("far_boundary")
      .otherwise("`point_load`; `clamped` with your own mesh or true sections")
      .says(
          "Far boundary of the segments: `clamped`, or displaced like a half-space under the "
          "force (`point_load`).")
      .into(&FemOptions::far_boundary,
            {{"clamped", FarBoundary::clamped}, {"point_load", FarBoundary::point_load}});
}

}  // namespace

SectionWithKeys fem_section() {
  FemKeys keys("fem", "Finite-element model", &Case::fem);
  add_elements(keys);
  add_meshes(keys);
  return keys;
}

}  // namespace rollfem::contact
