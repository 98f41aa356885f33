// SPDX-License-Identifier: LGPL-2.1-or-later
#include "convert/equivalent.hpp"

#include "base/errors.hpp"
#include "case/case.hpp"
#include "case/keys/case_text.hpp"

#include <fmt/format.h>

#include "convert/single_contact.hpp"
#include "convert/wheel_rail.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace rollfem::convert {

namespace {

constexpr std::size_t most_entries = 100;  // per case file

bool equally_spaced(const std::vector<double>& values) {
  const double step = (values.back() - values.front()) / static_cast<double>(values.size() - 1);
  for (std::size_t k = 1; k < values.size(); ++k)
    if (std::abs(values[k] - values[k - 1] - step) > 1e-6 * std::abs(step)) return false;
  return true;
}

std::string place(const std::array<double, 3>& p) {
  return fmt::format("[{:.12g}, {:.12g}, {:.12g}]", p[0], p[1], p[2]);
}

using Axes = std::array<std::vector<double>, 3>;

/// The points of one block in mm, in our axes.
Axes axes_of(const StressBlock& given, const ElementPlaces& elements, double sign) {
  Axes along{given.x, given.y, given.z};
  if (given.by_element) {
    for (double& x : along[0]) x = elements.x + (x - 0.5) * elements.dx;
    for (double& y : along[1]) y = elements.y + (y - 0.5) * elements.dy;
  }
  for (std::size_t c = 0; c < 2; ++c)
    for (double& value : along[c]) value = in_mm(sign * value);
  for (auto& values : along) std::sort(values.begin(), values.end());
  return along;
}

/// The direction of the lines: the longest axis with equally spaced points in one body; 3 if there
/// is none.
std::size_t line_of(const Axes& along) {
  std::size_t line = 3;
  for (std::size_t c = 0; c < 3; ++c) {
    const bool one_body = c < 2 || along[2].front() * along[2].back() >= 0.0;
    if (along[c].size() > 1 && one_body && equally_spaced(along[c]) &&
        (line == 3 || along[c].size() > along[line].size()))
      line = c;
  }
  return line;
}

/// An entry for a line between two places, or for a point if both coincide.
std::string entry(const std::array<double, 3>& from, const std::array<double, 3>& to,
                  std::size_t points) {
  const char* const body = std::min(from[2], to[2]) < 0.0 ? "rail" : "wheel";
  if (points == 1)
    return fmt::format("[[subsurface.point]]\nbody = \"{}\"\nat = {}\n", body, place(from));
  return fmt::format("[[subsurface.line]]\nbody = \"{}\"\nfrom = {}\nto = {}\npoints = {}\n", body,
                     place(from), place(to), points);
}

/// All entries; empty if there are too many.
std::vector<std::string> entries_of(Axes along) {
  const std::size_t line = line_of(along);
  std::vector<double> whole{0.0};
  if (line < 3) std::swap(whole, along[line]);
  if (line < 3) along[line] = {0.0};
  std::vector<std::string> all;
  if (along[0].size() * along[1].size() * along[2].size() > most_entries) return all;
  for (const double x : along[0])
    for (const double y : along[1])
      for (const double z : along[2]) {
        std::array<double, 3> from{x, y, z}, to = from;
        if (line < 3) from[line] = whole.front(), to[line] = whole.back();
        all.push_back(entry(from, to, whole.size()));
      }
  return all;
}

/// Features requested by the values of a digit; other values count as the last entry.
using Words = std::map<int, const char*>;
const Words material_words{{1, "viscoelastic bodies"},
                           {2, "the simplified theory with a user-defined flexibility"}};
const Words bound_words{{1, "a thin sheet instead of the half-space"},
                        {3, "a parabolic traction bound with the full theory"},
                        {4, "normal contact by SDEC"},
                        {5, "normal contact by KPEC"},
                        {6, "normal contact by ANALYN"}};
const char* word_of(int value, const Words& words) {
  const auto found = words.find(value);
  return (found == words.end() ? *words.rbegin() : *found).second;
}

bool falls(const ContactCase& given) {
  return given.friction_law >= 2 && given.friction_law <= 4;
}

bool follows_temperature(const ContactCase& given) {
  return given.friction_law == 6;
}

/// Temperatures are those of steady rolling.
bool is_heated(const ContactCase& given) {
  return given.digits.H > 0 && given.digits.T == 3 && !is_simplified(given.digits);
}

/// Friction in every row of elements of module 3, whose places fill_single_contact knows.
bool by_rows(const ContactCase& given) {
  return given.module == 3 && given.friction.size() > 1;
}

void fill_coefficients(const ContactCase& given, Equivalent& made) {
  std::vector<FrictionSet> sets = given.friction;
  if (by_rows(given) && rolls_backwards(given)) std::reverse(sets.begin(), sets.end());
  const auto set = [&](const char* key, const char* unit, auto number) {
    std::vector<double> values;
    for (const FrictionSet& one : sets) values.push_back(number(one));
    if (values.size() == 1) return made.set("friction", key, values.front(), unit);
    made.set("friction", key, values, unit);
  };
  set("coefficient", "", [](const FrictionSet& one) { return one.fstat; });
  if (given.module == 1 && sets.size() > 1) {
    const bool along = given.friction_over == 2;
    set(along ? "track_position" : "inclination", "",
        [](const FrictionSet& one) { return one.place; });
    if (along) made.varied["wheelset.track_position"] = given.wheel_rail.position[0];
    made.note(!along,
              "digit V = 1: every row of elements has the friction of its own inclination; CONTACT "
              "takes one for a planar contact");
  }
  if (follows_temperature(given) && given.digits.T != 0) {
    made.set("friction", "law", contact::FallShape::temperature.word);
    set("cold_temperature", "degC, TREF", [](const FrictionSet& one) { return one.fall[0]; });
    set("hot_temperature", "TREF + DTHEAT",
        [](const FrictionSet& one) { return one.fall[0] + one.fall[2]; });
    set("hot_coefficient", "FREF + DFHEAT",
        [](const FrictionSet& one) { return one.fstat + one.fall[1]; });
    return;
  }
  if (!falls(given) || given.digits.T == 0) return;
  const auto number = static_cast<std::size_t>(given.friction_law - 1);
  made.set("friction", "law", contact::fall_shapes().at(number).word);
  set("kinetic_coefficient", "", [](const FrictionSet& one) { return one.fkin; });
  set("half_velocity", "mm/s", [](const FrictionSet& one) { return one.fall[1]; });
  const bool second = std::any_of(sets.begin(), sets.end(),
                                  [](const FrictionSet& one) { return one.fall[2] != 0.0; });
  if (!second) return;
  set("second_part", "", [](const FrictionSet& one) { return one.fall[2]; });
  set("second_half_velocity", "mm/s", [](const FrictionSet& one) { return one.fall[3]; });
}

/// The law, and the layer of M = 4; the speed is that of both.
void fill_friction(const ContactCase& given, Equivalent& made) {
  fill_coefficients(given, made);
  const auto& layer = given.bodies.layer;
  if (given.digits.M == 4 && layer[1] > 0.0) {
    made.set("layer", "thickness", layer[1], "mm");
    made.set("layer", "shear_modulus", layer[0], "MPa");
  }
  if (given.digits.M == 4 && layer[2] > 0.0) {
    made.set("layer", "yield_stress", layer[2], "MPa");
    if (layer[3] != 0.0) made.set("layer", "hardening", layer[3], "MPa/mm");
  }
  if ((!falls(given) && !follows_temperature(given) && !is_heated(given)) || given.digits.T == 0)
    return;
  if (given.memory[0] > 0.0 && given.friction_law >= 2) {
    constexpr double least_velocity = 1e-6;  // stands for 0
    made.set("friction", "memory_distance", given.memory[0], "mm");
    made.set("friction", "memory_velocity", std::max(given.memory[1], least_velocity), "mm/s");
  }
  const bool simplified = is_simplified(given.digits);
  made.from_sliding = given.friction_law >= 2 && given.initial_slip < 0 && !simplified;
  made.note(falls(given) && given.initial_slip == 0 && given.memory[0] == 0.0 && !simplified,
            "INISLP = 0: where friction falls so steeply that a case has several states, CONTACT "
            "takes one near the case before, rollfem the one with the most friction");
  if (given.module == 1)
    made.set("rolling", "speed", std::abs(forward_speed(given)), "mm/s, VS");
  else if (given.digits.T >= 2)
    made.set("rolling", "speed", given.rolling[2], "mm/s");
}

void judge_friction(const ContactCase& given, Equivalent& made) {
  const Digits& digits = given.digits;
  if (digits.T == 0) return;
  const int law = given.friction_law, over = given.friction_over;
  made.refuse(over > 2 && given.module == 1, "V", over, "friction in rows of elements in module 1");
  made.refuse(over == 1 && given.module == 3, "V", over,
              "friction over the inclination in module 3");
  made.refuse(by_rows(given) && digits.F > 0,
              "digits V, F: forces relative to friction that varies");
  made.refuse(by_rows(given) && is_simplified(digits), "V", over, "FASTSIM with friction in rows");
  made.refuse(follows_temperature(given) && !is_heated(given), "L", law,
              "friction by temperature without digit H in steady rolling");
  for (const FrictionSet& one : given.friction) {
    made.refuse(law == 0 && std::abs(one.fstat - one.fkin) > 1e-3 * one.fstat,
                fmt::format("FSTAT = {:g} and FKIN = {:g} differ: rollfem has one coefficient "
                            "for adhesion and slip",
                            one.fstat, one.fkin));
    made.refuse(falls(given) && one.fkin < 0.01 * one.fstat,
                fmt::format("FKIN = {:g} is below a hundredth of the friction at rest, {:g}",
                            one.fkin, one.fstat));
  }
}

/// FASTSIM and FaStrip.
void judge_fastsim(const ContactCase& given, Equivalent& made) {
  const int B = given.digits.B, M = given.digits.M;
  if (given.module == 1) return made.refuse(true, "M", M, "FASTSIM on the patches of profiles");
  made.refuse(given.digits.T != 3, "M", M, "FASTSIM for anything but steady rolling");
  made.refuse(
      B != 2 && (B != 3 || M == 5),
      fmt::format("digits M = {}, B = {}: FASTSIM with a pressure other than Hertz's, or FaStrip "
                  "with a parabolic bound",
                  M, B));
  made.refuse(M == 5 && (falls(given) || given.bodies.slope_reduction[0] != 1.0), "M", M,
              "FaStrip with falling friction or a reduced slope");
}

void judge_bodies(const ContactCase& given, Equivalent& made) {
  const int M = given.digits.M, B = given.digits.B, C = given.bodies.influence;
  const bool full = M == 0 || M == 4;
  made.refuse(!full && !is_simplified(given.digits), "M", M, word_of(M, material_words));
  if (is_simplified(given.digits)) judge_fastsim(given, made);
  made.refuse(full && B != 0 && B != 2, "B", B, word_of(B, bound_words));
  made.refuse(full && B == 2 && (given.module == 1 || given.potential.ipotcn >= 0),
              "digit B = 2: Hertz's pressure of a contact that is not given by IPOTCN = -1 to -3");
  made.refuse(full && B == 2 && given.digits.N == 0,
              "digits B = 2 and N = 0: Hertz's pressure needs the normal force");
  made.refuse(given.digits.M2 != 0, "M2", given.digits.M2, "material damping");
  made.refuse(C == 4, "C", C,
              "influence coefficients for conformal contact (for profiles see halfspace.surface)");
  made.refuse(C == 9, "C", C, "influence coefficients read from a file");
}

void judge_problem(const ContactCase& given, Equivalent& made) {
  const int T = given.digits.T, E = given.digits.E;
  made.refuse(T > 3, "T", T, "an unknown kind of problem");
  made.refuse(given.digits.F > (given.module == 1 ? 3 : 2), "F", given.digits.F,
              "an unknown kind of force");
  made.refuse(given.module == 3 && E != 0, "E", E,
              "extra rigid slip given per element (write a file for rolling.extra_slip_file)");
  made.refuse(given.module == 1 && T == 1 && forward_speed(given) == 0.0,
              "digit T = 1: a shift of wheel and rail profiles without rolling");
}

void note_settings(const ContactCase& given, Equivalent& made) {
  const Digits& d = given.digits;
  const auto& nu = given.bodies.poisson;
  const auto& g = given.bodies.shear_modulus;
  made.note(true,
            "digits G, I, A, O, W, MAXGS to EPS and relaxation factors are ignored: the solvers "
            "need no settings, and all fields are in results.h5");
  made.note(d.S > 0 && (given.module == 1 || d.M != 0),
            "stresses below the surface (digit S) are not converted: rollfem stress computes them "
            "after the run");
  made.note(d.H > 0 && !is_heated(given),
            "temperatures (digit H) are calculated in steady rolling of half-spaces alone");
  made.note(d.R >= 2, fmt::format("digit R = {}: CONTACT would not run this case", d.R));
  made.note(d.V != 0 && d.T == 0, "digit V has no effect without friction");
  made.note(given.bodies.influence == 3,
            "digit C = 3: tractions are constant in each element here, not linear");
  made.note(d.M == 3,
            "FASTSIM uses Kalker's three flexibilities at all creepages; CONTACT blends them into "
            "one as creepages grow");
  made.note(d.M == 5,
            "CONTACT modifies FaStrip: its lateral force under spin is larger, by 4 % of mu F_n in "
            "case 4 of its fastsim.inp");
  made.note(!is_simplified(d) && (d.T == 2 || d.T == 3),
            "upwind_order = \"first\" is CONTACT's scheme and gives its numbers on its elements; "
            "delete the line for the more accurate second-order scheme");
  made.note(
      given.module == 3 && given.rolling[3] != 1.0 / 6.0 && d.T >= 2 && given.kinematics[3] != 0.0,
      fmt::format("FACPHI = {:g}: the spin is taken at x + dq/6 here", given.rolling[3]));
  made.note(given.max_outer == 1 && (nu[0] != nu[1] || g[0] != g[1]) && d.T != 0,
            "MAXOUT = 1: CONTACT stops after one pass over pressure and friction, which are "
            "coupled for unlike materials; here both are solved together");
}

}  // namespace

void fill_stresses(const ContactCase& given, const ElementPlaces& elements, double sign,
                   Equivalent& made) {
  if (given.digits.S == 0 || given.digits.M != 0) return;
  std::size_t entries = 0;
  for (const StressBlock& block : given.stress_blocks) {
    if (block.x.empty() || block.y.empty() || block.z.empty()) continue;
    const auto texts = entries_of(axes_of(block, elements, sign));
    entries += texts.size();
    if (texts.empty() || entries > most_entries)
      made.notes.push_back(
          fmt::format("a block of {} by {} by {} points below the surface is not converted: "
                      "rollfem stress evaluates planes and lines after the run",
                      block.x.size(), block.y.size(), block.z.size()));
    else
      for (const std::string& text : texts) made.stresses += "\n" + text;
  }
}

bool is_simplified(const Digits& digits) {
  return digits.M == 3 || digits.M == 5;
}

bool rolls_backwards(const ContactCase& given) {
  return given.digits.T >= 2 && std::cos(given.rolling[0]) < 0.0;
}

double in_mm(double place) {
  return std::round(place * 1e10) / 1e10;
}

std::string Setting::line() const {
  std::string text = key + " = ";
  if (const auto* number = std::get_if<double>(&value))
    text += fmt::format("{:.12g}", *number);
  else if (const auto* list = std::get_if<std::vector<double>>(&value))
    text += fmt::format("[{:.12g}]", fmt::join(*list, ", "));
  else
    text += contact::toml_text(value);
  return comment.empty() ? text : fmt::format("{:<30} # {}", text, comment);
}

void fill_bodies(const ContactCase& given, const std::array<const char*, 2>& sections,
                 Equivalent& made) {
  for (std::size_t body = 0; body < 2; ++body) {
    const BodyConstants& bodies = given.bodies;
    const double nu = bodies.poisson[body], G = bodies.shear_modulus[body];
    made.set(sections[body], "young_modulus", 2.0 * G * (1.0 + nu),
             fmt::format("MPa, G = {:g}", G));
    made.set(sections[body], "poisson_ratio", nu);
    if (!is_heated(given)) continue;
    const auto& [temperature, capacity, conductivity, density] = bodies.heat[body];
    const std::string heat = std::string(sections[body]) + "_heat";
    made.set(sections[body], "density", 1e-3 * density, "t/mm^3");
    made.set(heat, "temperature", temperature, "degC");
    made.set(heat, "heat_capacity", capacity, "J/(kg K)");
    made.set(heat, "conductivity", 1e3 * conductivity, "W/(m K)");
  }
}

Equivalent equivalent_of(const ContactCase& given, const std::string& profile_folder) {
  Equivalent made;
  using contact::Problem;
  constexpr std::array problems{Problem::frictionless, Problem::shift, Problem::transient};
  const auto T = static_cast<std::size_t>(given.digits.T);
  made.problem = word_of(T < problems.size() ? problems[T] : Problem::steady);
  // P = 1 uses the previous pressure only as a start; friction starts from zero, as with P = 2.
  made.continues = made.history() && given.digits.P == 0;
  judge_friction(given, made);
  judge_bodies(given, made);
  judge_problem(given, made);
  note_settings(given, made);
  if (!made.impossible.empty()) return made;
  fill_friction(given, made);
  try {
    if (given.module == 3)
      fill_single_contact(given, made);
    else
      fill_wheel_rail(given, profile_folder, made);
  } catch (const contact::InputError& error) {  // from Hertz, for values without contact
    made.impossible.push_back(error.what());
  }
  return made;
}

}  // namespace rollfem::convert
