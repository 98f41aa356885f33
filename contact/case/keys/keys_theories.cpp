// SPDX-License-Identifier: LGPL-2.1-or-later
// Theories with options, one section each: [fastsim], [strip], [carter], [polach].
#include "contact/case/keys/key_builder.hpp"

namespace rollfem::contact {

namespace {

template <class Options>
void add_strips(Keys<Options>& keys, int fewest) {
  keys.integer("strips")
      .between(fewest, 2000)
      .says("Strips across the patch.")
      .into(&Options::strips);
}

template <class Options>
void add_strip_elements(Keys<Options>& keys) {
  keys.integer("strip_elements")
      .between(4, 2000)
      .says("Elements along each strip.")
      .into(&Options::strip_elements);
}

}  // namespace

SectionWithKeys fastsim_section() {
  Keys<FastsimOptions> keys(
      "fastsim",
      "Model `fastsim`: Kalker's simplified theory on Hertz's ellipse; `fastrip` takes strips and "
      "elements",
      &Case::fastsim);
  keys.choice("bound")
      .says(
          "Traction bound: `parabolic` 4/3 mu p0 (1 - r^2), the usual choice; `elliptic` mu p0 "
          "sqrt(1 - r^2), Hertz's.")
      .into(&FastsimOptions::bound,
            {{"parabolic", BoundShape::parabolic}, {"elliptic", BoundShape::elliptic}});
  keys.choice("flexibilities")
      .says(
          "Flexibility of the brushes: one for each creepage, or their mean weighted by the "
          "creepages.")
      .into(&FastsimOptions::flexibilities,
            {{"three", Flexibilities::three}, {"one", Flexibilities::one}});
  keys.choice("elements")
      .says(
          "`chord` divides every strip equally; `grid` uses elements of a common grid and "
          "evaluates the spin a sixth of a step upstream, as CONTACT does (first order).")
      .into(&FastsimOptions::elements,
            {{"chord", FastsimElements::chord}, {"grid", FastsimElements::grid}});
  add_strips(keys, 8);
  add_strip_elements(keys);
  keys.triple("slope_reduction")
      .symbol("k_0, alpha_inf, beta")
      .between(1e-6, 100.0)
      .says(
          "Reduce the brushes' stiffness on surfaces that are not clean (docs/theory.md); all "
          "1: Kalker's slope. Not for `fastrip`.")
      .into(&FastsimOptions::slope_reduction);
  return keys;
}

SectionWithKeys strip_section() {
  Keys<StripOptions> keys(
      "strip", "Model `strip`: strips along rolling, each with Hertzian pressure and brushes",
      &Case::strip);
  add_strips(keys, 16);
  add_strip_elements(keys);
  keys.real("virtual_penetration")
      .between(0.3, 1.0)
      .otherwise("from the Hertzian ellipse of equal depth and volume")
      .says(
          "Fraction of the approach by which the undeformed profiles penetrate to define the "
          "patch; Kik and Piotrowski: 0.55.")
      .into(&StripOptions::virtual_penetration);
  return keys;
}

SectionWithKeys carter_section() {
  Keys<CarterOptions> keys("carter", "Model `carter`: strips along rolling, each a line contact",
                           &Case::carter);
  add_strips(keys, 8);
  return keys;
}

SectionWithKeys polach_section() {
  Keys<PolachOptions> keys("polach", "Model `polach`: Polach's closed form of the creep force",
                           &Case::polach);
  keys.real("adhesion_reduction")
      .symbol("k_A")
      .between(1e-6, 1.0)
      .says("Reduction of the initial slope in the adhesion area; below 1 where rails are wet.")
      .into(&PolachOptions::adhesion_reduction);
  keys.real("slip_reduction")
      .symbol("k_S")
      .between(1e-6, 1.0)
      .says("Reduction in the slip area; Polach has it at most k_A.")
      .into(&PolachOptions::slip_reduction);
  return keys;
}

}  // namespace rollfem::contact
