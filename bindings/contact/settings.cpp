// SPDX-License-Identifier: LGPL-2.1-or-later
// The functions that set a contact problem: flags, bodies, friction, load and motion of both
// modules, and the shape of the contact in module 3.
#include "bindings/contact/rows.hpp"

#include <fmt/format.h>

#include "convert/parameters.hpp"
#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace rollfem::addon {

namespace {

using Powers = std::vector<int>;  ///< of length, in the units of values
constexpr int most_flags = 1000;

/// The powers for a method, or a refusal that calls it `what`.
const Powers& powers_for(const std::map<int, Powers>& all, int method, int code, const char* what) {
  const auto found = all.find(method);
  if (found == all.end()) throw Refusal(code, fmt::format("there is no {} {}", what, method));
  return found->second;
}

const convert::Names& names_or_refusal(const convert::Names* names, int code, const char* what,
                                       int digit) {
  if (names == nullptr) throw Refusal(code, fmt::format("there is no {} {}", what, digit));
  return *names;
}

/// Of numbers by their names; those that are not here have none.
Powers powers_of(const convert::Names& names) {
  static const std::map<std::string, int> known{
      {"SABSH1", 1}, {"SABSH2", 1}, {"MEMDST", 1}, {"MEM_S0", 1}, {"POLACH_B", -1}, {"A1", -1},
      {"B1", -1},    {"AA", 1},     {"BB", 1},     {"BNEG", 1},   {"BPOS", 1},      {"XL", 1},
      {"YL", 1},     {"DX", 1},     {"DY", 1},     {"XH", 1},     {"YH", 1},        {"XC1", 1},
      {"YC1", 1},    {"XCM", 1},    {"YCM", 1}};
  Powers powers;
  for (const std::string& name : names)
    powers.push_back(known.count(name) > 0 ? known.at(name) : 0);
  return powers;
}

/// Numbers of elements, from reals.
int elements(double value) {
  if (!(value >= 1.0 && value <= 1e5)) throw Refusal(err_discr, "MX, MY: allowed: 1 to 100000");
  return static_cast<int>(value);
}

/// Where the value of a flag is kept.
int& place_of(int code, Problem& problem) {
  convert::ContactCase& given = problem.given;
  convert::Digits& d = given.digits;
  std::map<int, int*> places{{ic_config, &d.config}, {ic_pvtime, &d.P}, {ic_bound, &d.B},
                             {ic_tang, &d.T},        {ic_norm, &d.N},   {ic_force, &d.F},
                             {ic_exrhs, &d.E},       {ic_iestim, &d.I}, {ic_output, &d.O},
                             {ic_flow, &d.W},        {ic_return, &d.R}, {ic_matfil, &d.A},
                             {ic_mater, &d.M},       {ic_heat, &d.H}};
  places[ic_frclaw] = &given.friction_law;
  places[ic_discns] = &given.wheel_rail.search;
  places[ic_inflcf] = &given.bodies.influence;
  places[if_ncase] = &problem.cases;
  places[if_units] = &problem.units.code;
  const auto found = places.find(code);
  return found == places.end() ? problem.flags[code] : *found->second;
}

void set_flag(int code, int value, Problem& problem) {
  if (code == if_units) {
    if (value != un_cntc && value != un_spck && value != un_si)
      throw Refusal(err_other, fmt::format("if_units = {}: no such units here", value));
    problem.units = {value == un_cntc ? 1.0 : 1000.0, value == un_spck ? -1.0 : 1.0, value};
    return;
  }
  const bool global = code >= if_idebug && code <= if_ncase;
  if (code != 0 && !global && (code < ic_config || code > ic_npomax))
    throw Refusal(err_other, fmt::format("there is no flag {}", code));
  if (global) Library::here().set_flag(code, value);
  const bool as_before = (code == ic_discns || code == ic_inflcf) && value < 2;
  const bool of_others = code == ic_mater || code == ic_heat || code == ic_frclaw ||
                         code == if_ncase || code == 0;  // functions set these
  if (!as_before && !of_others) place_of(code, problem) = value;
}

/// NU1, NU2, G1, G2 and what follows, by digit M.
void set_material(int method, const Values& given, Problem& problem) {
  static const std::map<int, Powers> powers{{0, {0, 0, -2, -2}},
                                            {1, {0, 0, -2, -2, 0, 0, 0, 0}},
                                            {2, {0, 0, -2, -2, 3, 0, 0, 0}},
                                            {3, {0, 0, -2, -2, 0, 0, 0}},
                                            {4, {0, 0, -2, -2, -2, 1, -2, -3}},
                                            {5, {0, 0, -2, -2, 0, 0, 0}}};
  convert::ContactCase& made = problem.given;
  if (method >= 10) {
    made.digits.M2 = method - 10;
    return;
  }
  const Values v =
      taken(problem.units, given, powers_for(powers, method, err_other, "material M ="));
  convert::BodyConstants& bodies = made.bodies;
  made.digits.M = method;
  bodies.poisson = {v[0], v[1]};
  bodies.shear_modulus = {v[2], v[3]};
  if (method == 3 || method == 5) std::copy_n(v.begin() + 4, 3, bodies.slope_reduction.begin());
  if (method == 4) std::copy_n(v.begin() + 4, 4, bodies.layer.begin());
}

/// Of each body: temperature, heat capacity, conductivity, density.
void set_heat(int method, const Values& given, Problem& problem) {
  if (method != 0 && method != 1 && method != 3)
    throw Refusal(err_other, fmt::format("there is no method H = {}", method));
  problem.given.digits.H = method;
  if (method != 3) return;
  const Values v = taken(problem.units, given, {0, 0, -1, -3, 0, 0, -1, -3});
  for (std::size_t k = 0; k < 8; ++k) problem.given.bodies.heat[k / 4][k % 4] = v[k];
}

/// Numbers of a law by digit L: as in an input file, MEMDST and MEM_S0 with each set, and FSTAT,
/// POLACH_A, POLACH_B of L = 5.
convert::Names names_of_law(int law) {
  if (law == 5) return {"FSTAT", "POLACH_A", "POLACH_B"};
  convert::Names names = names_or_refusal(convert::friction_names(law), err_frclaw, "law L =", law);
  if (law > 0) names.insert(names.end(), {"MEMDST", "MEM_S0"});
  return names;
}

convert::FrictionSet friction_set(int law, const Values& v) {
  if (law != 5) return convert::friction_set(law, v.data());
  // Polach's law is the exponential one in other numbers.
  if (!(v[2] > 0.0)) throw Refusal(err_frclaw, "POLACH_B must be positive");
  return {0.0, v[0], v[0] * v[1], {v[0] * (1.0 - v[1]), std::log(2.0) / v[2], 0.0, 0.0}};
}

/// Digits V and L; with V > 0 the number of sets comes first and a place before each.
void set_friction(int method, const Values& given, Problem& problem) {
  const int varies = method / 10, law = method % 10;
  if (method < 0 || varies > 2) throw Refusal(err_frclaw, "unknown friction law");
  if (law == 1) return;  // as before
  Powers powers = powers_of(names_of_law(law));
  const std::size_t first = varies > 0 ? 1 : 0, sets = varies > 0 && !given.empty() ? given[0] : 1;
  if (varies > 0) powers.insert(powers.begin(), varies == 2 ? 1 : 0);
  if (sets < 1 || sets > 10000 || given.size() < first + sets * powers.size())
    throw Refusal(err_frclaw, fmt::format("{} values are given, {} are needed", given.size(),
                                          first + sets * powers.size()));
  convert::ContactCase& made = problem.given;
  made.friction.clear();
  made.memory = {};
  for (std::size_t k = 0; k < sets; ++k) {
    const auto begin = given.begin() + static_cast<std::ptrdiff_t>(first + k * powers.size());
    Values v = taken(problem.units, Values(begin, given.end()), powers);
    if (law >= 2 && law != 5) made.memory = {v[v.size() - 2], v.back()};
    const double place = varies > 0 ? v.front() : 0.0;
    if (varies > 0) v.erase(v.begin());
    made.friction.push_back(friction_set(law, v));
    made.friction.back().place = place;
  }
  made.friction_law = made.digits.L = law == 5 ? 4 : law;
  made.friction_over = made.digits.V = varies;
}

void set_area(int kind, const Values& given, Problem& problem) {
  const Values v =
      taken(problem.units, given,
            powers_of(names_or_refusal(convert::area_names(kind), err_discr, "IPOTCN =", kind)));
  convert::PotentialContact area{kind, elements(v[0]), elements(v[1]), {}};
  if (static_cast<double>(area.mx) * area.my > 4e6) throw Refusal(err_discr, "MX MY: too many");
  std::copy(v.begin() + 2, v.end(), area.size.begin());
  problem.given.potential = area;
}

void set_hertz(int kind, const Values& given, Problem& problem) {
  if (kind >= 0) throw Refusal(err_discr, "IPOTCN: allowed: -6 to -1");
  set_area(kind, given, problem);
}

/// In module 1 DX and DS; A_SEP and what follows are not used.
void set_cells(int kind, const Values& given, Problem& problem) {
  if (problem.given.module == 3 && kind <= 0) throw Refusal(err_discr, "IPOTCN: allowed: 1 to 4");
  if (problem.given.module == 3) return set_area(kind, given, problem);
  const Values v = taken(problem.units, given, {1, 1});
  problem.given.wheel_rail.cell = {v[0], v[1]};
}

void set_distance(int base, const Values& given, Problem& problem) {
  static const std::map<int, Powers> powers{{1, {-1, -1, -1, 0, 0, 1}},
                                            {2, {0, 1, 1, 1, 1, 1}},
                                            {3, {1, -1, 1, 1, -1, 1, 1, 1}},
                                            {9, {1}}};
  const Powers& of = powers_for(powers, base, err_other, "undeformed distance IBASE =");
  problem.given.distance = {base, 1, problem.units.in(given, of)};
}

void set_creepages(const Values& v, Problem& problem) {
  const bool shift = problem.given.digits.T == 1;
  const Values made = problem.units.in(v, shift ? Powers{1, 1, 0} : Powers{0, 0, -1});
  std::copy(made.begin(), made.end(), problem.creepage.begin());
}

}  // namespace

extern "C" {

ADDON_VALUES(cntc_setmaterialparameters, set_material)
ADDON_VALUES(cntc_settemperaturedata, set_heat)
ADDON_VALUES(cntc_setfrictionmethod, set_friction)
ADDON_VALUES(cntc_sethertzcontact, set_hertz)
ADDON_VALUES(cntc_setpotcontact, set_cells)
ADDON_VALUES(cntc_setundeformeddistc, set_distance)
ADDON_NUMBER(cntc_settimestep, p.time_step = v[0])
ADDON_NUMBER(cntc_setreferencevelocity, p.given.rolling[2] = p.units.in(v[0]))
ADDON_NUMBER(cntc_setpenetration, p.penetration = p.units.in(v[0]), p.given.digits.N = 0)
ADDON_NUMBER(cntc_setnormalforce, p.normal_force = v[0], p.given.digits.N = 1)
ADDON_NUMBERS_2(cntc_settangentialforces, p.tangential = {p.units.body * v[0], p.units.body* v[1]})
ADDON_NUMBERS_2(cntc_setrollingstepsize, p.given.rolling[0] = v[0],
                p.given.rolling[1] = p.units.in(v[1]), p.given.wheel_rail.step = v[1])

void cntc_setcreepages(Int ire, Int icp, Real vx, Real vy, Real phi) {
  set_numbers("cntc_setcreepages", ire, icp, {vx, vy, phi}, set_creepages);
}

void cntc_setextrarigidslip(Int ire, Int icp, Int lenarr, Real wx, Real wy) {
  guarded("cntc_setextrarigidslip", {ire, icp, lenarr, wx, wy}, [&] {
    const ElementSlip extra{finite_values(wx, *lenarr), finite_values(wy, *lenarr)};
    for_problems(*ire, *icp, [&](Problem& problem) {
      problem.extra_slip[problem.given.module == 1 ? *icp : 1] = extra;
    });
  });
}

void cntc_setglobalflags(Int lenflg, Int params, Int values) {
  guarded("cntc_setglobalflags", {lenflg, params, values}, [&] {
    for (int k = 0; k < std::min(*lenflg, most_flags); ++k)
      Library::here().set_flag(params[k], values[k]);
  });
}

void cntc_setflags(Int ire, Int icp, Int lenflg, Int params, Int values) {
  guarded("cntc_setflags", {ire, icp, lenflg, params, values}, [&] {
    for_problems(*ire, *icp, [&](Problem& problem) {
      for (int k = 0; k < std::min(*lenflg, most_flags); ++k)
        set_flag(params[k], values[k], problem);
    });
  });
}

void cntc_getflags(Int ire, Int icp, Int lenflg, Int params, int* values) {
  guarded("cntc_getflags", {ire, icp, lenflg, params, values}, [&] {
    for_problem(*ire, *icp, [&](Problem& problem) {
      for (int k = 0; k < std::min(*lenflg, most_flags); ++k)
        values[k] = place_of(params[k], problem);
    });
  });
}

/// For CONTACT's mat-files, which rollfem does not write.
void cntc_setmetadata(Int ire, Int icp, Int lenmta, Int params, Real values) {
  guarded("cntc_setmetadata", {ire, icp, lenmta, params, values}, [] { return 0; });
}

/// Solvers need no settings; INISLP chooses among several states of falling friction.
void cntc_setsolverflags(Int ire, Int icp, Int gdigit, Int nints, Int iparam, Int nreals,
                         Real rparam) {
  guarded("cntc_setsolverflags", {ire, icp, gdigit, nints, nreals}, [&] {
    demand_arrays(nints, iparam, nreals, rparam);
    for_problems(*ire, *icp, [&](Problem& problem) {
      if (*gdigit >= 2 && *gdigit <= 4 && *nints >= 5) problem.given.initial_slip = iparam[4];
      if (*gdigit == 0) problem.given.initial_slip = 0;
      if (*gdigit != 1 && *gdigit <= 5 && *nints >= 4)
        problem.given.max_outer = std::max(iparam[3], 1);
    });
  });
}

}  // extern "C"

}  // namespace rollfem::addon
