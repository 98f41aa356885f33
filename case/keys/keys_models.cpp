// SPDX-License-Identifier: LGPL-2.1-or-later
// Options of models, one section each.
#include "case/keys/key_builder.hpp"

namespace rollfem::contact {

namespace {

SectionWithKeys halfspace_section() {
  Keys<HalfspaceOptions> keys("halfspace", "Model `halfspace`", &Case::halfspace);
  keys.add(
      "surface", &HalfspaceOptions::surface,
      {{"auto", SurfaceForm::automatic},
       {"planar", SurfaceForm::planar},
       {"curved", SurfaceForm::curved}},
      "`planar`: the tangent plane of the contact point; `curved` follows the common surface of "
      "wheel and rail across rolling, with local normals and rolling radii (steady or frictionless "
      "rolling of like materials, no subsurface stress). `auto`: planar unless the normals of true "
      "profiles spread by more than 0.03 rad, fully curved from 0.06 rad on and where contacts in "
      "planes of their own grow into each other (docs/track.md).");
  keys.add("model_error", &HalfspaceOptions::model_error,
           "Estimate the half-space's model error, per quantity and load point, from the true "
           "curvature of wheel and rail (some 0.1 s per load point); needs radii or profiles.");
  return keys;
}

SectionWithKeys fastsim_section() {
  Keys<FastsimOptions> keys("fastsim",
                            "Model `fastsim`: Kalker's simplified theory on Hertz's ellipse; "
                            "`fastrip` takes strips and elements",
                            &Case::fastsim);
  keys.add("bound", &FastsimOptions::bound,
           {{"parabolic", BoundShape::parabolic}, {"elliptic", BoundShape::elliptic}},
           "Traction bound: `parabolic` 4/3 mu p0 (1 - r^2), the usual choice; `elliptic` mu p0 "
           "sqrt(1 - r^2), Hertz's.");
  keys.add("flexibilities", &FastsimOptions::flexibilities,
           {{"three", Flexibilities::three}, {"one", Flexibilities::one}},
           "Flexibility of the brushes: one for each creepage, or their mean weighted by the "
           "creepages.");
  keys.add("elements", &FastsimOptions::elements,
           {{"chord", FastsimElements::chord}, {"grid", FastsimElements::grid}},
           "`chord` divides every strip equally; `grid` uses elements of a common grid and "
           "evaluates the spin a sixth of a step upstream, as CONTACT does (first order).");
  keys.add("strips", &FastsimOptions::strips, between(8, 2000), "Strips across the patch.");
  keys.add("strip_elements", &FastsimOptions::strip_elements, between(4, 2000),
           "Elements along each strip.");
  keys.add("slope_reduction", &FastsimOptions::slope_reduction, symbol("k_0, alpha_inf, beta"),
           between(1e-6, 100.0),
           "Reduce the brushes' stiffness on surfaces that are not clean (docs/theory.md); all 1: "
           "Kalker's slope. Not for `fastrip`.");
  return keys;
}

SectionWithKeys strip_section() {
  Keys<StripOptions> keys(
      "strip", "Model `strip`: strips along rolling, each with Hertzian pressure and brushes",
      &Case::strip);
  keys.add("strips", &StripOptions::strips, between(16, 2000), "Strips across the patch.");
  keys.add("strip_elements", &StripOptions::strip_elements, between(4, 2000),
           "Elements along each strip.");
  keys.add("virtual_penetration", &StripOptions::virtual_penetration, between(0.3, 1.0),
           otherwise("from the Hertzian ellipse of equal depth and volume"),
           "Fraction of the approach by which the undeformed profiles penetrate to define the "
           "patch; Kik and Piotrowski: 0.55.");
  return keys;
}

SectionWithKeys carter_section() {
  Keys<CarterOptions> keys("carter", "Model `carter`: strips along rolling, each a line contact",
                           &Case::carter);
  keys.add("strips", &CarterOptions::strips, between(8, 2000), "Strips across the patch.");
  return keys;
}

SectionWithKeys polach_section() {
  Keys<PolachOptions> keys("polach", "Model `polach`: Polach's closed form of the creep force",
                           &Case::polach);
  keys.add("adhesion_reduction", &PolachOptions::adhesion_reduction, symbol("k_A"),
           between(1e-6, 1.0),
           "Reduction of the initial slope in the adhesion area; below 1 where rails are wet.");
  keys.add("slip_reduction", &PolachOptions::slip_reduction, symbol("k_S"), between(1e-6, 1.0),
           "Reduction in the slip area; Polach has it at most k_A.");
  return keys;
}

using FemKeys = Keys<FemOptions>;

void add_elements(FemKeys& keys) {
  keys.add("cell_size", &FemOptions::cell_size, symbol("h"), unit("mm"), positive(),
           otherwise("chosen from the size of the patch"),
           "Size of a finite element in the patch, and of a contact element of this model.");
  keys.add("degree", &FemOptions::degree, between(1, 2),
           "Polynomial degree of the displacement; 1 is 15 to 20 times less accurate on the same "
           "cells, with contact elements of two by two cells.");
  keys.add("extent", &FemOptions::extent, symbol("L"), unit("mm"), positive(),
           otherwise("chosen from the size of the patch"),
           "Distance from the middle of the patch to which wheel and rail are meshed.");
  keys.add("fine_extent", &FemOptions::fine_extent, symbol("c"), between(1.0, 10.0),
           otherwise("chosen by the model"),
           "Extent of the finest cells, in semi-axes of the patch; more than 1.1 gains nothing.");
  keys.add("linear_solver", &FemOptions::linear_solver,
           {{"automatic", LinearSolver::automatic},
            {"factorisation", LinearSolver::factorisation},
            {"multigrid", LinearSolver::multigrid},
            {"algebraic", LinearSolver::algebraic}},
           "`automatic` chooses the one expected to be faster; `algebraic` (Trilinos ML) is for "
           "imported meshes too fine to serve as a coarse level.");
  keys.add("inertia", &FemOptions::inertia,
           "Include the inertia of wheel and rail and the wheel's centrifugal load at "
           "rolling.speed, below 0.9 of the slower body's Rayleigh wave speed.");
}

void add_meshes(FemKeys& keys) {
  keys.add(
      "mesh", &FemOptions::mesh,
      {{"structured", MeshFamily::structured}, {"gmsh", MeshFamily::gmsh}},
      otherwise("`structured`"),
      "`structured` lays a graded box on the surface; `gmsh` revolves or extrudes a quadrilateral "
      "mesh of the cross-section, with profiles the true section of rail and wheel rim.");
  keys.add("width", &FemOptions::width, unit("mm"), positive(), otherwise("twice the extent"),
           "Width of the segments across rolling.");
  keys.add("depth", &FemOptions::depth, unit("mm"), positive(),
           otherwise("the extent; for true sections 172 (rail foot)"),
           "Depth of the segments; for the true section of a rail the depth below its top at which "
           "it is cut and fixed.");
  keys.add(
      "rim_thickness", &FemOptions::rim_thickness, unit("mm"), positive(), otherwise("65"),
      "Thickness of the wheel's rim below the contact in a true section; its inner side is fixed.");
  keys.add("length", &FemOptions::length, unit("mm"), positive(), otherwise("twice the extent"),
           "Length of the segments along rolling, on the wheel of the arc.");
  keys.add("far_boundary", &FemOptions::far_boundary,
           {{"clamped", FarBoundary::clamped}, {"point_load", FarBoundary::point_load}},
           otherwise("`point_load`; `clamped` with your own mesh or true sections"),
           "Far boundary of the segments: `clamped`, or displaced like a half-space under the "
           "force (`point_load`).");
}

void add_passes(FemKeys& keys) {
  keys.add("passes", &FemOptions::passes, between(1, 1000), silent_default,
           otherwise("one for each load point"),
           "Passes over bodies that yield ([rail_plasticity], [wheel_plasticity]); the load points "
           "of the case follow one another, again and again. At least one for each of them.");
  keys.add("pass_pressure", &FemOptions::pass_pressure,
           {{"yielding", PassPressure::yielding}, {"elastic", PassPressure::elastic}},
           "Contact of the passes: `yielding`, that of the bodies as they are; `elastic`, as if "
           "they had not changed their shape, for comparison with theory.");
  keys.add(
      "limit_state", &FemOptions::limit_state,
      "Each pass (cycle of load points) starts from a state extrapolated from those before, so "
      "that the state that repeats is reached in about half the passes; plastic strain is then "
      "that of no number of passes, only its increments count.");
  keys.add("plastic_extent", &FemOptions::plastic_extent, between(0.5, 10.0),
           "Extent of the region that may yield, relative to the usual one (as deep as "
           "elastic stress exceeds the yield stress); it grows where steel yields at its border.");
}

SectionWithKeys fem_section() {
  FemKeys keys("fem", "Finite-element model", &Case::fem);
  add_elements(keys);
  add_meshes(keys);
  add_passes(keys);
  return keys;
}

}  // namespace

Sections model_sections() {
  return {halfspace_section(), fastsim_section(), strip_section(),
          carter_section(),    polach_section(),  fem_section()};
}

}  // namespace rollfem::contact
