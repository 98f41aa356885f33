#include "contact/case/key_builder.hpp"

namespace rollfem::contact {

namespace {

using FemKeys = Keys<FemOptions>;

void add_elements(FemKeys& keys) {
  keys.real("cell_size")
      .symbol("h")
      .unit("mm")
      .positive()
      .otherwise("chosen from the size of the patch")
      .says("Size of a finite element, and of a contact element of this model, in the patch.")
      .into(&FemOptions::cell_size);
  keys.whole("degree")
      .between(1, 2)
      .says(
          "Polynomial degree of the displacement; 1 is 15 to 20 times less accurate on the same "
          "cells, and a contact element is then two cells by two.")
      .into(&FemOptions::degree);
  keys.real("extent")
      .symbol("L")
      .unit("mm")
      .positive()
      .otherwise("chosen from the size of the patch")
      .says("How far the segments of wheel and rail reach from the middle of the patch.")
      .into(&FemOptions::extent);
  keys.real("fine_extent")
      .symbol("c")
      .between(1.0, 10.0)
      .otherwise("chosen by the model")
      .says(
          "How far the finest cells reach from the middle, in semi-axes of the patch; beyond 1.1 "
          "nothing is gained.")
      .into(&FemOptions::fine_extent);
  keys.choice("linear_solver")
      .says(
          "`automatic` takes what should be quicker for the size and the number of load points; "
          "`algebraic` (Trilinos ML) is for imported meshes too fine to be a coarse level.")
      .into(&FemOptions::linear_solver, {{"automatic", LinearSolver::automatic},
                                         {"factorisation", LinearSolver::factorisation},
                                         {"multigrid", LinearSolver::multigrid},
                                         {"algebraic", LinearSolver::algebraic}});
  keys.toggle("inertia")
      .says(
          "Inertia of wheel and rail and the wheel's centrifugal load at rolling.speed, which is "
          "then below 0.9 of the slower body's Rayleigh wave speed.")
      .into(&FemOptions::inertia);
}

void add_meshes(FemKeys& keys) {
  keys.choice("mesh")
      .otherwise("`structured`; `gmsh` where profiles are too steep for a box")
      .says(
          "How wheel and rail are meshed: `structured` lays a graded box on the surface; `gmsh` "
          "meshes the cross-section in quadrilaterals and revolves or extrudes it, with profiles "
          "the true section of rail and wheel rim.")
      .into(&FemOptions::mesh,
            {{"structured", MeshFamily::structured}, {"gmsh", MeshFamily::gmsh}});
  keys.real("width")
      .unit("mm")
      .positive()
      .otherwise("twice the extent")
      .says("Width of the segments of wheel and rail across rolling.")
      .into(&FemOptions::width);
  keys.real("depth")
      .unit("mm")
      .positive()
      .otherwise("as far as extent; 172, the foot, of true sections")
      .says(
          "Depth of the segments below the surface; of a rail with a true section the depth below "
          "its top at which it is cut and held.")
      .into(&FemOptions::depth);
  keys.real("rim_thickness")
      .unit("mm")
      .positive()
      .otherwise("65")
      .says(
          "Thickness of the wheel's rim below the contact, held at its inner side, in a true "
          "section (profiles).")
      .into(&FemOptions::rim_thickness);
  keys.real("length")
      .unit("mm")
      .positive()
      .otherwise("twice the extent")
      .says("Length of the segments along rolling, on the wheel the arc of its sector.")
      .into(&FemOptions::length);
  keys.choice("far_boundary")
      .otherwise("`point_load`; `clamped` with a mesh of your own or true sections")
      .says(
          "How the far boundary of the segments is held: `clamped`, or displaced as a half-space "
          "under the force on the patch (`point_load`), which leaves less of their size in the "
          "approach.")
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
