// SPDX-License-Identifier: LGPL-2.1-or-later
// The functions that set a contact problem: flags, bodies, friction, load and motion of both
// modules, and the shape of the contact in module 3.
#include "bindings/contact/rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace rollfem::addon {

namespace {

using convert::Digits;
using Powers = std::vector<int>;  ///< of length, in the units of values

/// The powers for a method, or a refusal that calls it `what`.
const Powers& powers_for(const std::map<int, Powers>& all, int method, int code, const char* what) {
  const auto found = all.find(method);
  if (found == all.end()) throw Refusal(code, fmt::format("there is no {} {}", what, method));
  return found->second;
}

/// Numbers of elements, from reals.
int elements(double value) {
  if (!(value >= 1.0 && value <= 1e5)) throw Refusal(err_discr, "MX, MY: allowed: 1 to 100000");
  return static_cast<int>(value);
}

/// Flags that are digits of the case.
const std::map<int, int Digits::*> digit_flags{
    {ic_config, &Digits::config}, {ic_pvtime, &Digits::P}, {ic_bound, &Digits::B},
    {ic_tang, &Digits::T},        {ic_norm, &Digits::N},   {ic_force, &Digits::F},
    {ic_exrhs, &Digits::E},       {ic_iestim, &Digits::I}, {ic_output, &Digits::O},
    {ic_flow, &Digits::W},        {ic_return, &Digits::R}, {ic_matfil, &Digits::A}};

void set_flag(int code, int value, Problem& problem) {
  if (const auto digit = digit_flags.find(code); digit != digit_flags.end()) {
    problem.given.digits.*digit->second = value;
  } else if (code == if_units) {
    if (value != un_cntc && value != un_spck && value != un_si)
      throw Refusal(err_other, fmt::format("if_units = {}: no such units here", value));
    problem.units = {value == un_cntc ? 1.0 : 1000.0, value == un_spck ? -1.0 : 1.0, value};
  } else if (code == ic_discns) {
    if (value >= 2) problem.given.wheel_rail.search = value;
  } else if (code == ic_inflcf) {
    if (value >= 2) problem.given.bodies.influence = value;
  } else if (code >= ic_config && code <= ic_npomax) {
    problem.flags[code] = value;
  } else if (code >= if_idebug && code <= if_ncase) {
    Library::here().set_flag(code, value);
    problem.flags[code] = value;
  } else if (code != 0) {
    throw Refusal(err_other, fmt::format("there is no flag {}", code));
  }
}

int flag_of(int code, const Problem& problem) {
  const convert::ContactCase& given = problem.given;
  if (const auto digit = digit_flags.find(code); digit != digit_flags.end())
    return given.digits.*digit->second;
  switch (code) {
    case if_units:
      return problem.units.code;
    case if_ncase:
      return problem.cases;
    case ic_discns:
      return given.wheel_rail.search;
    case ic_inflcf:
      return given.bodies.influence;
    case ic_frclaw:
      return given.friction_law;
    case ic_mater:
      return given.digits.M;
    case ic_heat:
      return given.digits.H;
    default:
      const auto found = problem.flags.find(code);
      return found == problem.flags.end() ? 0 : found->second;
  }
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

void set_heat(int method, const Values& given, Problem& problem) {
  if (method != 0 && method != 1 && method != 3)
    throw Refusal(err_other, fmt::format("there is no method H = {}", method));
  problem.given.digits.H = method;
  if (method != 3) return;
  const Values v = taken(problem.units, given, {0, 0, -1, -3, 0, 0, -1, -3});
  for (std::size_t k = 0; k < 8; ++k) problem.given.bodies.heat[k / 4][k % 4] = v[k];
}

/// Numbers of a law by digit L: FSTAT, FKIN; FKIN, F1, SABSH1, F2, SABSH2, MEMDST, MEM_S0; FSTAT,
/// POLACH_A, POLACH_B; FREF, TREF, DFHEAT, DTHEAT, MEMDST, MEM_S0.
const std::map<int, Powers> friction_powers{{0, {0, 0}},
                                            {2, {0, 0, 1, 0, 1, 1, 1}},
                                            {3, {0, 0, 1, 0, 1, 1, 1}},
                                            {4, {0, 0, 1, 0, 1, 1, 1}},
                                            {5, {0, 0, -1}},
                                            {6, {0, 0, 0, 0, 1, 1}}};

convert::FrictionSet friction_set(int law, const Values& v) {
  if (law == 0) return {0.0, v[0], v[1], {}};
  if (law == 6) return {0.0, v[0], 0.0, {v[1], v[2], v[3], 0.0}};
  if (law != 5) return {0.0, v[0] + v[1] + v[3], v[0], {v[1], v[2], v[3], v[4]}};
  // Polach's law is the exponential one in other numbers.
  if (!(v[2] > 0.0)) throw Refusal(err_frclaw, "POLACH_B must be positive");
  return {0.0, v[0], v[0] * v[1], {v[0] * (1.0 - v[1]), std::log(2.0) / v[2], 0.0, 0.0}};
}

/// Digits V and L; with V > 0 the number of sets comes first and a place before each.
void set_friction(int method, const Values& given, Problem& problem) {
  const int varies = method / 10, law = method % 10;
  if (method < 0 || varies > 2) throw Refusal(err_frclaw, "unknown friction law");
  if (law == 1) return;  // as before
  Powers powers = powers_for(friction_powers, law, err_frclaw, "friction law L =");
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

/// Numbers behind MX, MY, by IPOTCN.
void set_area(int kind, const Values& given, Problem& problem) {
  static const std::map<int, Powers> powers{{-6, {0, 0, 1, 1, 1, 0}}, {-5, {0, 0, 1, 1, 0}},
                                            {-4, {0, 0, -1, 1, 0}},   {-3, {0, 0, 1, 1, 0}},
                                            {-2, {0, 0, -1, 0, 0}},   {-1, {0, 0, -1, -1, 0}},
                                            {1, {0, 0, 1, 1, 1, 1}},  {2, {0, 0, 1, 1, 1, 1}},
                                            {3, {0, 0, 1, 1, 1, 1}},  {4, {0, 0, 1, 1, 1, 1}}};
  const Values v =
      taken(problem.units, given, powers_for(powers, kind, err_discr, "potential contact area"));
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
  problem.given.distance = {base, 1, in_mm(problem.units, given, of)};
}

void set_creepages(const Values& v, Problem& problem) {
  const bool shift = problem.given.digits.T == 1;
  const Values made = in_mm(problem.units, v, shift ? Powers{1, 1, 0} : Powers{0, 0, -1});
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

void cntc_setcreepages(const int* ire, const int* icp, const double* vx, const double* vy,
                       const double* phi) {
  set_numbers("cntc_setcreepages", ire, icp, {vx, vy, phi}, set_creepages);
}

void cntc_setextrarigidslip(const int* ire, const int* icp, const int* lenarr, const double* wx,
                            const double* wy) {
  guarded("cntc_setextrarigidslip", {ire, icp, lenarr, wx, wy}, nullptr, []() -> int {
    throw Refusal(err_other, "extra rigid slip of each element has no equivalent");
  });
}

void cntc_setglobalflags(const int* lenflg, const int* params, const int* values) {
  guarded("cntc_setglobalflags", {lenflg, params, values}, nullptr, [&] {
    for (int k = 0; k < std::min(*lenflg, 1000); ++k)
      Library::here().set_flag(params[k], values[k]);
    return 0;
  });
}

void cntc_setflags(const int* ire, const int* icp, const int* lenflg, const int* params,
                   const int* values) {
  guarded("cntc_setflags", {ire, icp, lenflg, params, values}, nullptr, [&] {
    for_problems(*ire, *icp, [&](Problem& problem) {
      for (int k = 0; k < std::min(*lenflg, 1000); ++k) set_flag(params[k], values[k], problem);
    });
    return 0;
  });
}

void cntc_getflags(const int* ire, const int* icp, const int* lenflg, const int* params,
                   int* values) {
  guarded("cntc_getflags", {ire, icp, lenflg, params, values}, nullptr, [&] {
    for_problem(*ire, *icp, [&](Problem& problem) {
      for (int k = 0; k < std::min(*lenflg, 1000); ++k) values[k] = flag_of(params[k], problem);
    });
    return 0;
  });
}

/// For CONTACT's mat-files, which rollfem does not write.
void cntc_setmetadata(const int* ire, const int* icp, const int* lenmta, const int* params,
                      const double* values) {
  guarded("cntc_setmetadata", {ire, icp, lenmta, params, values}, nullptr, [] { return 0; });
}

/// Solvers need no settings; INISLP chooses among several states of falling friction.
void cntc_setsolverflags(const int* ire, const int* icp, const int* gdigit, const int* nints,
                         const int* iparam, const int* nreals, const double* rparam) {
  static_cast<void>(rparam);
  guarded("cntc_setsolverflags", {ire, icp, gdigit, nints, nreals}, nullptr, [&] {
    if (*nints > 0 && iparam == nullptr) throw Refusal(err_other, "an argument is null");
    for_problems(*ire, *icp, [&](Problem& problem) {
      if (*gdigit >= 2 && *gdigit <= 4 && *nints >= 5) problem.given.initial_slip = iparam[4];
      if (*gdigit == 0) problem.given.initial_slip = 0;
      if (*gdigit != 1 && *gdigit <= 5 && *nints >= 4)
        problem.given.max_outer = std::max(iparam[3], 1);
    });
    return 0;
  });
}

}  // extern "C"

}  // namespace rollfem::addon
