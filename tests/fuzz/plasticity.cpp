// SPDX-License-Identifier: LGPL-2.1-or-later
// Bytes that draw bodies and layers that yield, and how they are rolled or shifted: solved by
// half-spaces, or refused.
#include "fuzz/scene.hpp"
#include "fuzz/target.hpp"

using namespace rollfem::testing;

namespace {

std::string steel(Draws& draw, const char* section) {
  std::string text = fmt::format("[{}]\n", section) + key("yield_stress", draw.size(1e-2, 1e5));
  const int moduli = draw.count(0, 3);
  const auto list = [&](const char* name, int count, double least, double most) {
    std::string values;
    for (int k = 0; k < count; ++k)
      values += fmt::format("{}{}", k > 0 ? ", " : "", draw.size(least, most));
    text += fmt::format("{} = [{}]\n", name, values);
  };
  if (moduli > 0) list("hardening", moduli, 1.0, 1e6);
  if (moduli > 0 && draw.chance(0.5)) list("recovery", draw.count(1, moduli), 1e-3, 1e4);
  if (draw.chance(0.3))
    text += key("isotropic_rise", draw.between(-500.0, 500.0)) +
            key("isotropic_rate", draw.size(1e-3, 1e3));
  if (draw.chance(0.3))
    text += fmt::format("residual_depth = [0.0, {}]\nresidual_along = [{}, {}]\n",
                        draw.size(1e-3, 50.0), draw.between(-500.0, 500.0),
                        draw.between(-500.0, 500.0));
  return text;
}

std::string layer(Draws& draw) {
  std::string text = "[layer]\n" + key("yield_stress", draw.size(1e-6, 1e6));
  if (draw.chance(0.8))
    text += key("thickness", draw.size(1e-6, 10.0)) + key("shear_modulus", draw.size(1e-3, 1e6));
  const double hardening = draw.sign() * draw.size(1e-6, 1e9);
  if (draw.chance(0.7)) text += key("hardening", hardening);
  return text;
}

std::string motion(Draws& draw, double force) {
  const double kind = draw.part();
  if (kind < 0.2)
    return "[rolling]\nproblem = \"shift\"\n[history]\n" +
           fmt::format("steps = {}\n", draw.count(1, 3)) +
           key("longitudinal_shift", draw.between(-0.1, 0.1)) +
           key("lateral_shift", draw.between(-0.1, 0.1));
  std::string text = "[rolling]\n";
  for (const char* name : {"lateral_creepage", "spin"})
    if (draw.chance(0.5)) text += key(name, draw.sign() * draw.size(1e-6, 1.0));
  if (kind > 0.85) return text + key("longitudinal_force", 0.3 * force * draw.between(-1.0, 1.0));
  text += key("longitudinal_creepage", draw.sign() * draw.size(1e-6, 1.0));
  if (kind < 0.4)
    text += "problem = \"transient\"\n[history]\n" + fmt::format("steps = {}\n", draw.count(1, 3)) +
            key("step_length", draw.size(0.1, 10.0));
  return text;
}

}  // namespace

std::string outcome_of(const std::string& input) {
  Draws draw(input);
  const double force = draw.size(1.0, 1e7);
  const bool line = draw.chance(0.2);
  std::string text = "models = [\"halfspace\"]\n[load]\n" + key("normal_force", force);
  text += "[friction]\n" + key("coefficient", draw.chance(0.5) ? 0.3 : draw.size(1e-3, 2.0));
  text += fmt::format("[contact_grid]\nelements_across = {}\n", draw.count(4, 8));
  text += "[wheel]\n" + key("rolling_radius", draw.size(50.0, 2000.0));
  if (!line) text += key("transverse_radius", draw.size(50.0, 1e4));
  text += "[rail]\n";
  if (!line) text += key("transverse_radius", draw.size(20.0, 1000.0));
  if (line) text += "[geometry]\nshape = \"line\"\n";
  if (draw.chance(0.8)) text += layer(draw);
  for (const char* section : {"wheel_plasticity", "rail_plasticity"})
    if (draw.chance(0.2)) text += steel(draw, section);
  return said_of(text + motion(draw, force));
}
