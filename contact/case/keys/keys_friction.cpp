// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/case/keys/key_builder.hpp"

#include <algorithm>

namespace rollfem::contact {

namespace {

/// In the order of FallShape.
const Words& law_words() {
  static const Words words{"constant", "linear", "rational", "exponential"};
  return words;
}

/// A number of which `check` says nothing where it is as without the key.
void into_fall(KeyBuilder<Case>& key, double FrictionFall::*member) {
  key.by(
      [member](const Case& c) -> KeyValue {
        const double value = c.friction_fall.*member;
        return value == FrictionFall().*member ? KeyValue() : KeyValue(value);
      },
      [member](Case& c, const KeyValue& value) {
        c.friction_fall.*member = std::get<double>(value);
      });
}

void add_fall(Keys<Case>& keys) {
  keys.choice("law")
      .says(
          "How friction falls with the slip velocity s, speed times slip: `constant` not at all, "
          "else "
          "mu_kin + mu_1 f(s/s_h1) + mu_2 f(s/s_h2), f = max(0, 1 - r/2) for `linear`, 1/(1 + r) "
          "and 1/(1 + r^2) for `rational`, 2^-r for `exponential`. Needs rolling.speed.")
      .among(law_words())
      .by(
          [](const Case& c) -> KeyValue {
            return law_words().at(static_cast<std::size_t>(c.friction_fall.shape));
          },
          [](Case& c, const KeyValue& value) {
            const auto found =
                std::find(law_words().begin(), law_words().end(), std::get<std::string>(value));
            c.friction_fall.shape = static_cast<FallShape>(found - law_words().begin());
          });
  keys.real("kinetic_coefficient")
      .symbol("mu_kin")
      .between(1e-14, 1000.0)
      .otherwise("required unless the law is `constant`")
      .says(
          "Coefficient to which friction falls, 0.01 to 1 times friction.coefficient; mu_1 is the "
          "rest.")
      .into(&Case::friction_fall, &FrictionFall::kinetic_coefficient);
  keys.real("half_velocity")
      .symbol("s_h1")
      .unit("mm/s")
      .between(smallest, 1e12)
      .otherwise("required unless the law is `constant`")
      .says("Slip velocity at which mu_1 is halved; in a shift, slip in mm over one second.")
      .into(&Case::friction_fall, &FrictionFall::half_velocity);
}

void add_parts(Keys<Case>& keys) {
  into_fall(keys.real("second_part")
                .symbol("mu_2")
                .between(0.0, 1000.0)
                .otherwise("0")
                .says("Part of the fall that has its own second_half_velocity."),
            &FrictionFall::second_part);
  into_fall(keys.real("second_half_velocity")
                .symbol("s_h2")
                .unit("mm/s")
                .between(smallest, 1e12)
                .otherwise("required with second_part")
                .says("Slip velocity at which mu_2 is halved."),
            &FrictionFall::second_half_velocity);
  keys.real("polach_a")
      .symbol("A")
      .between(0.01, 1.0)
      .otherwise("kinetic_coefficient is given")
      .says("Polach's A, mu_kin over mu, for `exponential` instead of kinetic_coefficient.")
      .into(&Case::friction_fall, &FrictionFall::polach_a);
  keys.real("polach_b")
      .symbol("B")
      .unit("s/m")
      .between(1e-9, 1e9)
      .otherwise("half_velocity is given")
      .says("Polach's B in 2^-r = exp(-B s), instead of half_velocity.")
      .into(&Case::friction_fall, &FrictionFall::polach_b);
  into_fall(keys.real("memory_distance")
                .symbol("d_c")
                .unit("mm")
                .between(0.0, largest)
                .otherwise("0")
                .says("Sliding distance over which friction follows the slip velocity, some "
                      "micrometres; 0: at "
                      "once."),
            &FrictionFall::memory_distance);
  into_fall(keys.real("memory_velocity")
                .symbol("s_0")
                .unit("mm/s")
                .between(smallest, 1e12)
                .otherwise("1.0")
                .says("Slip velocity below which friction follows as if it slid at this one."),
            &FrictionFall::memory_velocity);
}

}  // namespace

SectionWithKeys friction_section() {
  Keys<Case> keys("friction", "Friction between wheel and rail", whole_case());
  keys.section().alternatives = true;
  keys.real("coefficient")
      .symbol("mu")
      .between(0.0, 1000.0)
      .required("0.55")
      .says(
          "Coefficient of friction, with a falling law that at rest; 0 is frictionless, otherwise "
          "at least 1e-12.")
      .into(&Case::friction_coefficient);
  add_fall(keys);
  add_parts(keys);
  return keys;
}

SectionWithKeys layer_section() {
  Keys<Layer> keys("layer", "A layer between wheel and rail that gives way to shear alone",
                   &Case::layer);
  keys.section().alternatives = true;
  keys.real("thickness")
      .symbol("h_3")
      .unit("mm")
      .positive()
      .otherwise("no elastic layer")
      .says("Thickness of the layer of dirt, sand or wear particles, or of the roughness.")
      .into(&Layer::thickness);
  keys.real("shear_modulus")
      .symbol("G_3")
      .unit("MPa")
      .positive()
      .otherwise("no elastic layer")
      .says("Its shear modulus; tractions p_t move the surfaces by p_t h_3/G_3 against each other.")
      .into(&Layer::shear_modulus);
  keys.real("yield_stress")
      .symbol("tau_c0")
      .unit("MPa")
      .positive()
      .otherwise("it does not yield")
      .says(
          "Shear stress at which the layer yields; tractions are at most the smaller of it and "
          "mu p_n.")
      .into(&Layer::yield_stress);
  keys.real("hardening")
      .symbol("k_tau")
      .unit("MPa/mm")
      .within(largest)
      .otherwise("0, perfectly plastic")
      .says(
          "Rise of the yield stress per mm by which a particle has yielded since it entered the "
          "patch; below 0 the layer softens.")
      .into(&Layer::hardening);
  return keys;
}

}  // namespace rollfem::contact
