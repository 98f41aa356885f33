// SPDX-License-Identifier: LGPL-2.1-or-later
#include "convert/contact_reader.hpp"

#include "base/errors.hpp"
#include "base/text_fields.hpp"

#include <fmt/format.h>

#include "convert/input_lines.hpp"
#include "convert/parameters.hpp"
#include "convert/stress_block.hpp"
#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <map>

namespace rollfem::convert {

namespace {

/// Assigns the digits of a control integer from the last one backwards; missing leading digits are
/// 0.
void unpack(int packed, std::initializer_list<int*> digits) {
  for (auto digit = std::rbegin(digits); digit != std::rend(digits); ++digit) {
    **digit = packed % 10;
    packed /= 10;
  }
}

void read_digits(InputLines& lines, ContactCase& next) {
  Digits& d = next.digits;
  constexpr int seven = 9999999, eight = 99999999;
  const auto control = [&](const char* name, int most, std::initializer_list<int*> digits) {
    const auto values = lines.numbers({std::string("the control integers ") + name}, 1);
    unpack(lines.integer(values[0], name, 0, most), digits);
    return values.size() > 1 ? values[1] : 0.0;
  };
  control("P-B-T-N-F-S", seven, {&d.config, &d.P, &d.B, &d.T, &d.N, &d.F, &d.S});
  const double damping =
      control("V-L-D-C-M-Z-E", seven, {&d.V, &d.L, &d.D, &d.C, &d.M, &d.Z, &d.E});
  d.M2 = lines.integer(damping, "digit M2", 0, 9);
  control("H-G-I-A-O-W-R", eight, {&d.X, &d.H, &d.G, &d.I, &d.A, &d.O, &d.W, &d.R});
  if (d.X >= 1) lines.numbers({"the control integers P-S-F-L-R-I-N (X >= 1)"}, 1);
  if (next.number == 1) d.P = 2;  // as in CONTACT: there is no previous case
}

constexpr int largest_grid = 100000;   // elements along one direction
constexpr double largest_area = 4e6;   // elements
constexpr int largest_block = 100000;  // points along one direction

std::size_t count(int n) {
  return static_cast<std::size_t>(n);
}

void read_solver(InputLines& lines, ContactCase& next) {
  const auto limits = lines.numbers({"MAXGS", "MAXIN", "MAXNR", "MAXOUT", "EPS"});
  next.max_outer = lines.integer(limits[3], "MAXOUT", 1, 9999);
  const int G = next.digits.G;
  const auto slip = [&](double value) { return lines.integer(value, "INISLP", -9999, 9999); };
  if (G == 2 || G == 3)
    next.initial_slip = slip(lines.numbers({"OMEGAH", "OMEGAS", "INISLP", "OMGSLP"})[2]);
  if (G == 4) next.initial_slip = slip(lines.numbers({"INISLP", "OMGSLP"})[0]);
  // Six or eight numbers, depending on the version.
  if (G == 5) lines.numbers({"FDECAY", "BETATH", "KDOWFB", "D_IFC", "D_LIN", "D_CNS"}, 2);
}

void read_friction(InputLines& lines, ContactCase& next, int sets) {
  const int L = next.digits.L;
  const Names* const law = friction_names(L);
  if (law == nullptr)
    lines.fail(fmt::format("digit L = {}; allowed: 0 to 4 and 6", L),
               "check for a missing line above it");
  Names names = *law;
  next.friction_over = next.digits.V;
  next.friction.clear();
  const bool placed = next.module == 1 && next.digits.V > 0;
  if (placed) names.insert(names.begin(), next.digits.V == 1 ? "ALPHVF" : "SVF");
  for (int set = 0; set < sets; ++set) {
    const auto values = lines.numbers(names);
    FrictionSet& read = next.friction.emplace_back(friction_set(L, &values[placed ? 1 : 0]));
    if (placed) read.place = values.front();
  }
  if (L >= 2) lines.read(next.memory, {"MEMDST", "MEM_S0"});
  next.friction_law = L;
}

void read_material(InputLines& lines, ContactCase& next) {
  const Digits& d = next.digits;
  BodyConstants& bodies = next.bodies;
  bodies.influence = d.C;
  if (d.C == 4 && next.module == 3) {
    const auto method = lines.numbers({"IF_METH", "VARIANT", "NN"});
    lines.array("the surface inclinations",
                2 * count(lines.integer(method[2], "NN", 1, largest_grid)));
  }
  if (d.C == 4 && next.module == 1) lines.numbers({"IF_METH", "VARIANT"});
  if (d.C == 9) lines.named("the name of a file of influence coefficients", {}, 0);
  const auto values = lines.numbers({"POISS1", "POISS2", "GG1", "GG2"});
  bodies.poisson = {values[0], values[1]};
  bodies.shear_modulus = {values[2], values[3]};
  if (d.B == 1) lines.numbers({"FLX_Z"});
  if (d.M == 1) lines.numbers({"FG1", "FG2", "TC1", "TC2"});
  if (d.M == 2) lines.numbers({"FLX", "K0_MF", "ALFAMF", "BETAMF"});
  if (d.M == 3 || d.M == 5) lines.read(bodies.slope_reduction, {"K0_MF", "ALFAMF", "BETAMF"});
  if (d.M == 4) lines.read(bodies.layer, {"GG3", "LAYTHK", "TAU_C0", "K_TAU"});
  if (d.M2 == 2) lines.numbers({"CDAMPN", "CDAMPT", "DFNMAX", "DFTMAX"});
}

/// Also without new materials.
void read_heat(InputLines& lines, ContactCase& next) {
  if (next.digits.H != 3) return;
  for (auto& heat : next.bodies.heat) lines.read(heat, {"BKTEMP", "HEATCP", "LAMBDA", "DENSITY"});
  if (next.digits.M == 4) lines.numbers({"BETAPL"});
}

void read_potential_contact(InputLines& lines, ContactCase& next) {
  PotentialContact& area = next.potential;
  area.ipotcn = lines.integer("IPOTCN", -6, 4);
  const Names* const names = area_names(area.ipotcn);
  if (names == nullptr)
    lines.fail("IPOTCN = 0; allowed: -6 to -1, 1 to 4", "look at the line above");
  const auto values = lines.numbers(*names);
  area.mx = lines.integer(values[0], "MX", 1, largest_grid);
  area.my = lines.integer(values[1], "MY", 1, largest_grid);
  if (static_cast<double>(area.mx) * area.my > largest_area)
    lines.fail(fmt::format("MX MY = {} by {} elements; allowed: {:g} in all", area.mx, area.my,
                           largest_area),
               "take fewer elements");
  area.size = {};
  for (std::size_t k = 2; k < values.size(); ++k) area.size[k - 2] = values[k];
}

void read_planform(InputLines& lines, int iplan) {
  if (iplan == 2) lines.array("the planform", 6);
  if (iplan == 3) lines.array("the planform", 8);
  if (iplan != 4) return;
  const int patches = lines.integer("NPATCH", 1, 100);
  lines.array("YSEP", count(patches - 1));
  lines.array("FAC", count(patches * (patches - 1) / 2));
}

void read_undeformed_distance(InputLines& lines, ContactCase& next) {
  UndeformedDistance& distance = next.distance;
  const auto kind = lines.numbers({"IBASE", "IPLAN"});
  distance.ibase = lines.integer(kind[0], "IBASE", 1, 9);
  distance.iplan = lines.integer(kind[1], "IPLAN", 1, 4);
  if (distance.ibase == 1) {
    distance.values = lines.numbers({"B1", "B2", "B3", "B4", "B5", "B6"});
  } else if (distance.ibase == 2) {
    distance.values = lines.numbers({"NN", "XM", "RX1", "Y1", "DY1"});
    const int n = lines.integer(distance.values[0], "NN", 2, largest_grid);
    const auto heights = lines.array("the heights", count(n));
    distance.values.insert(distance.values.end(), heights.begin(), heights.end());
  } else if (distance.ibase == 3) {
    distance.values = lines.array("B1 to B8", 8);
  } else if (distance.ibase == 9) {
    distance.values =
        lines.array("H of every element", count(next.potential.mx) * count(next.potential.my));
  } else {
    lines.fail(fmt::format("IBASE = {}; allowed: 1, 2, 3, 9", distance.ibase),
               "check for a missing line above it");
  }
  read_planform(lines, distance.iplan);
}

std::size_t points(const InputLines& lines, double value, const char* name) {
  return count(lines.integer(value, name, 1, largest_block));
}

/// Reads coordinates of each name, as many as the preceding counts state.
void read_places(InputLines& lines, const std::string& prefix,
                 std::initializer_list<std::pair<const char*, std::vector<double>*>> axes) {
  std::vector<std::string> names;
  for (const auto& [axis, into] : axes) names.push_back(std::string("N") + axis);
  const auto n = lines.numbers(names);
  std::size_t k = 0;
  for (const auto& [axis, into] : axes) {
    *into = lines.array(prefix + axis, points(lines, n[k], names[k].c_str()));
    ++k;
  }
}

/// A block of kind 1 to 7.
StressBlock read_elements(InputLines& lines, int kind, const PotentialContact& area) {
  std::array<std::vector<double>, 3> given;
  if (kind == 2 || kind == 6) {
    given[0] = lines.numbers({"IXL", "IXINC", "IXH"});
    given[1] = lines.numbers({"IYL", "IYINC", "IYH"});
  } else if (kind == 3 || kind == 7) {
    read_places(lines, "I", {{"X", &given[0]}, {"Y", &given[1]}});
  }
  if (kind >= 5)
    read_places(lines, "", {{"Z", &given[2]}});
  else
    points(lines, (given[2] = lines.numbers({"NZ", "ZL", "DZ"})).front(), "NZ");
  return stress_block(kind, given, {area.mx, area.my});
}

void read_subsurface(InputLines& lines, ContactCase& next) {
  if (next.digits.S < 2) return;
  lines.numbers({"MATFIL", "OUTPUT"});
  if (next.digits.S < 3) return;
  next.stress_blocks.clear();
  while (const int kind = lines.integer("ISUBS", 0, 9)) {
    if (kind == 4 || kind == 8)
      lines.fail(fmt::format("ISUBS = {}; allowed: 0 to 3, 5 to 7, 9", kind),
                 "look at the line above");
    StressBlock block;
    if (kind == 9)
      read_places(lines, "", {{"X", &block.x}, {"Y", &block.y}, {"Z", &block.z}});
    else
      block = read_elements(lines, kind, next.potential);
    next.stress_blocks.push_back(block);
  }
}

ProfileFile read_profile(InputLines& lines, const char* what) {
  const auto given = lines.named(what, {"MIRRORY", "SCALE", "SMOOTH"}, 2);
  ProfileFile profile;
  profile.name = given.text;
  std::replace(profile.name.begin(), profile.name.end(), '\\', '/');  // of Windows
  profile.mirror_y = lines.integer(given.numbers[0], "MIRRORY", -1, 1);
  profile.scale = given.numbers[1];
  profile.smooth = given.numbers[2];
  if (given.numbers.size() > 3)
    profile.mirror_z = lines.integer(given.numbers[3], "MIRRORZ", -1, 1);
  const double option = given.numbers.size() > 4 ? given.numbers[4] : 0.0;
  profile.has_options = option >= 1.0;
  if (option >= 1.0) lines.numbers({"ISMOOTH", "ZIGTHRS", "KINKHIGH", "KINKLOW", "KINKWID"});
  if (option >= 2.0) lines.numbers({"ERRHND", "MAXOMIT"});
  return profile;
}

void read_wheel_rail(InputLines& lines, ContactCase& next) {
  WheelRail& pair = next.wheel_rail;
  const Digits& digits = next.digits;
  const int Z = digits.Z, E = digits.E;
  if (digits.D >= 2) {
    // Newer versions have D_SEP, D_COMB and more.
    const auto grid = lines.numbers({"DX", "DS", "DQREL", "A_SEP"}, 4);
    pair.cell = {grid[0], grid[1]};
    pair.step = grid[2];
    pair.search = digits.D;
  }
  if (Z == 1 || Z == 3) {
    const auto track = lines.numbers({"GAUGHT", "GAUGSQ", "GAUGWD"}, 1);
    const bool old = track.size() == 3;  // GAUGWD, GAUGHT, CANT
    pair.track = old ? std::array{track[1], 0.0, track[1] > 0.0 ? track[0] : 0.0, track[2]}
                     : std::array{track[0], track[1], track[2], track[3]};
  }
  if (Z == 3) pair.rail = read_profile(lines, "the file of the rail's profile");
  if (Z == 2 || Z == 3)
    pair.rail_deviations = lines.numbers({"DY", "DZ", "ROLL", "VY", "VZ", "VROLL"});
  if ((Z == 2 || Z == 3) && digits.F == 3)
    pair.springs = lines.numbers({"KYRAIL", "FYRAIL", "KZRAIL", "FZRAIL"}, 4);
  if (E == 3 || E == 5) {
    lines.read(pair.wheelset, {"FBDIST", "FBPOS", "NOMRAD"});
    pair.wheel = read_profile(lines, "the file of the wheel's profile");
  }
  if (E >= 1)
    lines.read(pair.position, {"S", "Y", digits.N == 0 ? "Z" : "FZ", "ROLL", "YAW", "PITCH"});
  const char* const last = digits.F == 1 ? "FX" : digits.F == 2 ? "MY" : "VPITCH";
  if (E >= 2) lines.read(pair.velocity, {"VS", "VY", "VZ", "VROLL", "VYAW", last});
  if (E == 4 || E == 5) {
    pair.wheel_deviations = lines.numbers({"DX", "DY", "DZ", "DROLL", "DYAW", "DPITCH"});
    const auto rates = lines.numbers({"VX", "VY", "VZ", "VROLL", "VYAW", "VPITCH"});
    pair.wheel_deviations.insert(pair.wheel_deviations.end(), rates.begin(), rates.end());
  }
}

void read_single_contact(InputLines& lines, ContactCase& next) {
  const Digits& digits = next.digits;
  // V = 2 in older files and 3 in newer ones: a set of friction parameters for each row.
  const bool by_row = digits.V >= 2;
  if (digits.G != 1) read_solver(lines, next);
  lines.read(next.kinematics, {digits.N == 0 ? "PEN" : "FN", digits.F == 0 ? "CKSI" : "FX",
                               digits.F == 2 ? "FY" : "CETA", "CPHI"});
  if (digits.L != 1 && !by_row) read_friction(lines, next, 1);
  if ((digits.C >= 2 && digits.C <= 4) || digits.C == 9) {
    next.rolling[3] = digits.T == 2 || digits.T == 3 ? 1.0 / 6.0 : next.rolling[3];
    if (digits.T == 2 || digits.T == 3) lines.read(next.rolling, {"CHI", "DQ", "VELOC"}, 1);
    read_material(lines, next);
  }
  read_heat(lines, next);
  if (digits.D == 2) read_potential_contact(lines, next);
  if (digits.Z == 2 && next.potential.ipotcn > 0) read_undeformed_distance(lines, next);
  if (digits.L != 1 && by_row) read_friction(lines, next, next.potential.my);
  if (digits.E == 9)
    lines.array("EXRHS", 2 * static_cast<std::size_t>(next.potential.mx) *
                             static_cast<std::size_t>(next.potential.my));
}

void read_wheel_on_rail(InputLines& lines, ContactCase& next) {
  const Digits& digits = next.digits;
  if (digits.G != 1) read_solver(lines, next);
  if (digits.L != 1) read_friction(lines, next, digits.V == 0 ? 1 : lines.integer("NVF", 1, 10000));
  if (digits.C >= 2 && digits.C <= 4) read_material(lines, next);
  read_heat(lines, next);
  read_wheel_rail(lines, next);
}

/// Throws if the first case refers to data of a previous case.
void check_first(const InputLines& lines, const ContactCase& first) {
  const Digits& digits = first.digits;
  const auto refuse = [&](bool kept, const char* digit, const char* what) {
    if (kept)
      lines.fail(
          fmt::format("digit {} of the first case keeps {} of a previous case, and there is none",
                      digit, what),
          "begin with a case that gives all its data");
  };
  refuse(digits.L == 1, "L", "the friction");
  refuse(digits.D == 0, "D", "the grid");
  refuse(digits.C == 0, "C", "the materials");
  refuse(digits.Z == 0, "Z", first.module == 1 ? "the track" : "the undeformed distance");
}

}  // namespace

std::vector<ContactCase> read_contact_file(std::string_view text, const std::string& name) {
  InputLines lines(text, name);
  // Never quote the contents of other files.
  if (!lines.at_end() && !contact::looks_like_table(text, "%"))
    throw contact::InputError(
        name +
        ": is not an input file of CONTACT: most of its lines do not begin with a number; "
        "do: name an input file of modules 1 or 3 (.inp)");
  std::vector<ContactCase> cases;
  std::map<std::pair<double, double>, ContactCase> kept;  // by module and result element
  std::vector<double> which{0.0};
  while (!lines.at_end()) {
    // Digit R of the previous case may state that this one has the same module.
    if (cases.empty() || cases.back().digits.R % 2 != 0)
      which = lines.numbers({"the module number"}, 1);  // and the result element
    const double module = which.front();
    if (module == 0.0) break;
    if (module != 1.0 && module != 3.0)
      lines.fail(fmt::format("module {:g}; allowed: 1 (wheel and rail), 3 (single contacts), "
                             "0 (the end)",
                             module),
                 "check for a missing line above it");
    ContactCase& next = kept[{module, which.size() > 1 ? which[1] : 0.0}];
    const bool first = next.module == 0;
    next.module = static_cast<int>(module);
    next.number = static_cast<int>(cases.size()) + 1;
    next.line = lines.line();
    read_digits(lines, next);
    if (first) check_first(lines, next);
    if (next.module == 3)
      read_single_contact(lines, next);
    else
      read_wheel_on_rail(lines, next);
    read_subsurface(lines, next);
    cases.push_back(next);
  }
  if (cases.empty()) lines.fail("the file contains no case", "give an input file of CONTACT");
  return cases;
}

}  // namespace rollfem::convert
