#include "convert/read_case.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <initializer_list>
#include <map>
#include <utility>

namespace rollfem::convert {

namespace {

/// The last digits of a control integer go to the last of `digits`, and so on; what is before them
/// is 0.
void unpack(int packed, std::initializer_list<int*> digits) {
  for (auto digit = std::rbegin(digits); digit != std::rend(digits); ++digit) {
    **digit = packed % 10;
    packed /= 10;
  }
}

constexpr int largest_grid = 100000;  // elements along one direction
constexpr double largest_area = 4e6;  // elements

}  // namespace

void read_digits(InputLines& lines, ContactCase& next) {
  Digits& d = next.digits;
  constexpr int seven = 9999999, eight = 99999999;
  unpack(lines.whole(lines.numbers({"the control integers P-B-T-N-F-S"}).front(), "P-B-T-N-F-S", 0,
                     seven),
         {&d.config, &d.P, &d.B, &d.T, &d.N, &d.F, &d.S});
  const auto second = lines.numbers({"the control integers V-L-D-C-M-Z-E"}, 1);
  unpack(lines.whole(second[0], "V-L-D-C-M-Z-E", 0, seven),
         {&d.V, &d.L, &d.D, &d.C, &d.M, &d.Z, &d.E});
  d.M2 = second.size() > 1 ? lines.whole(second[1], "digit M2", 0, 9) : 0;
  unpack(lines.whole(lines.numbers({"the control integers H-G-I-A-O-W-R"}).front(), "H-G-I-A-O-W-R",
                     0, eight),
         {&d.X, &d.H, &d.G, &d.I, &d.A, &d.O, &d.W, &d.R});
  if (d.X >= 1) lines.numbers({"the control integers P-S-F-L-R-I-N (X >= 1)"}, 1);
  if (next.number == 1) d.P = 2;  // as CONTACT does: there is no case before
}

void read_solver(InputLines& lines, ContactCase& next) {
  const auto limits = lines.numbers({"MAXGS", "MAXIN", "MAXNR", "MAXOUT", "EPS"});
  next.max_outer = lines.whole(limits[3], "MAXOUT", 1, 9999);
  const int G = next.digits.G;
  if (G == 2 || G == 3) lines.numbers({"OMEGAH", "OMEGAS", "INISLP", "OMGSLP"});
  if (G == 4) lines.numbers({"INISLP", "OMGSLP"});
  // Six or eight, by version.
  if (G == 5) lines.numbers({"FDECAY", "BETATH", "KDOWFB", "D_IFC", "D_LIN", "D_CNS"}, 2);
}

void read_kinematics(InputLines& lines, ContactCase& next) {
  const Digits& d = next.digits;
  const auto values = lines.numbers(
      {d.N == 0 ? "PEN" : "FN", d.F == 0 ? "CKSI" : "FX", d.F == 2 ? "FY" : "CETA", "CPHI"});
  for (std::size_t k = 0; k < 4; ++k) next.kinematics[k] = values[k];
}

void read_friction(InputLines& lines, ContactCase& next, int sets) {
  const int L = next.digits.L;
  std::vector<std::string> names;
  if (next.module == 1 && next.digits.V > 0) names = {"ALPHVF"};
  const auto add = [&](std::initializer_list<const char*> more) {
    names.insert(names.end(), more.begin(), more.end());
  };
  if (L == 0)
    add({"FSTAT", "FKIN"});
  else if (L >= 2 && L <= 4)
    add({"FKIN", "F1", "SABSH1", "F2", "SABSH2"});
  else if (L == 6)
    add({"FREF", "TREF", "DFHEAT", "DTHEAT"});
  else
    lines.fail(fmt::format("digit L = {}; allowed: 0 to 4 and 6", L),
               "check for a missing line above it");
  for (int set = 0; set < sets; ++set) {
    const auto values = lines.numbers(names);
    if (L == 0) next.fstat = values[values.size() - 2], next.fkin = values.back();
  }
  if (L >= 2) lines.numbers({"MEMDST", "MEM_S0"});
  next.friction_law = L;
}

void read_rolling_step(InputLines& lines, ContactCase& next) {
  const auto values = lines.numbers({"CHI", "DQ", "VELOC"}, 1);
  next.rolling[3] = 1.0 / 6.0;
  for (std::size_t k = 0; k < values.size(); ++k) next.rolling[k] = values[k];
}

void read_material(InputLines& lines, ContactCase& next) {
  const Digits& d = next.digits;
  BodyConstants& bodies = next.bodies;
  bodies.influence = d.C;
  if (d.C == 4 && next.module == 3) {
    const auto method = lines.numbers({"IF_METH", "VARIANT", "NN"});
    lines.array("the surface inclinations",
                2 * static_cast<std::size_t>(lines.whole(method[2], "NN", 1, largest_grid)));
  }
  if (d.C == 4 && next.module == 1) lines.numbers({"IF_METH", "VARIANT"});
  if (d.C == 9) lines.named("the name of a file of influence coefficients", {}, 0);
  const auto values = lines.numbers({"POISS1", "POISS2", "GG1", "GG2"});
  bodies.poisson = {values[0], values[1]};
  bodies.shear_modulus = {values[2], values[3]};
  if (d.B == 1) lines.numbers({"FLX_Z"});
  if (d.M == 1) lines.numbers({"FG1", "FG2", "TC1", "TC2"});
  if (d.M == 2) lines.numbers({"FLX", "K0_MF", "ALFAMF", "BETAMF"});
  if (d.M == 3 || d.M == 5) {
    const auto reduction = lines.numbers({"K0_MF", "ALFAMF", "BETAMF"});
    bodies.slope_reduction = {reduction[0], reduction[1], reduction[2]};
  }
  if (d.M == 4) lines.numbers({"GG3", "LAYTHK", "TAU_C0", "K_TAU"});
  if (d.M2 == 2) lines.numbers({"CDAMPN", "CDAMPT", "DFNMAX", "DFTMAX"});
  if (d.H != 3) return;
  for (int body = 0; body < 2; ++body) lines.numbers({"BKTEMP", "HEATCP", "LAMBDA", "DENSITY"});
  if (d.M == 4) lines.numbers({"BETAPL"});
}

void read_potential_contact(InputLines& lines, ContactCase& next) {
  // What follows MX, MY.
  static const std::map<int, std::vector<std::string>> sizes{
      {-6, {"AA", "BNEG", "BPOS", "SCALE"}}, {-5, {"AA", "BB", "SCALE"}},
      {-4, {"A1", "BB", "SCALE"}},           {-3, {"AA", "BB", "SCALE"}},
      {-2, {"A1", "AOB", "SCALE"}},          {-1, {"A1", "B1", "SCALE"}},
      {1, {"XL", "YL", "DX", "DY"}},         {2, {"XL", "YL", "XH", "YH"}},
      {3, {"XC1", "YC1", "DX", "DY"}},       {4, {"XC1", "YC1", "XCM", "YCM"}}};
  PotentialContact& area = next.potential;
  area.ipotcn = lines.whole(lines.numbers({"IPOTCN"}).front(), "IPOTCN", -6, 4);
  const auto size = sizes.find(area.ipotcn);
  if (size == sizes.end())
    lines.fail("IPOTCN = 0; allowed: -6 to -1, 1 to 4", "look at the line above");
  std::vector<std::string> names{"MX", "MY"};
  names.insert(names.end(), size->second.begin(), size->second.end());
  const auto values = lines.numbers(names);
  area.mx = lines.whole(values[0], "MX", 1, largest_grid);
  area.my = lines.whole(values[1], "MY", 1, largest_grid);
  if (static_cast<double>(area.mx) * area.my > largest_area)
    lines.fail(fmt::format("MX MY = {} by {} elements; allowed: {:g} in all", area.mx, area.my,
                           largest_area),
               "take fewer elements");
  area.size = {};
  for (std::size_t k = 2; k < values.size(); ++k) area.size[k - 2] = values[k];
}

namespace {

std::size_t count(int n) {
  return static_cast<std::size_t>(n);
}

void read_planform(InputLines& lines, int iplan) {
  if (iplan == 2) lines.array("the planform", 6);
  if (iplan == 3) lines.array("the planform", 8);
  if (iplan != 4) return;
  const int patches = lines.whole(lines.numbers({"NPATCH"}).front(), "NPATCH", 1, 100);
  lines.array("YSEP", count(patches - 1));
  lines.array("FAC", count(patches * (patches - 1) / 2));
}

}  // namespace

void read_undeformed_distance(InputLines& lines, ContactCase& next) {
  UndeformedDistance& distance = next.distance;
  const auto kind = lines.numbers({"IBASE", "IPLAN"});
  distance.ibase = lines.whole(kind[0], "IBASE", 1, 9);
  distance.iplan = lines.whole(kind[1], "IPLAN", 1, 4);
  if (distance.ibase == 1) {
    distance.values = lines.numbers({"B1", "B2", "B3", "B4", "B5", "B6"});
  } else if (distance.ibase == 2) {
    const auto values = lines.numbers({"NN", "XM", "RX1", "Y1", "DY1"});
    lines.array("the heights", count(lines.whole(values[0], "NN", 1, largest_grid)));
  } else if (distance.ibase == 3) {
    lines.array("the geometry", 8);
  } else if (distance.ibase == 9) {
    distance.values =
        lines.array("H of every element", count(next.potential.mx) * count(next.potential.my));
  } else {
    lines.fail(fmt::format("IBASE = {}; allowed: 1, 2, 3, 9", distance.ibase),
               "check for a missing line above it");
  }
  read_planform(lines, distance.iplan);
}

}  // namespace rollfem::convert
