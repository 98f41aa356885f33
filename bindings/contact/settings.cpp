// SPDX-License-Identifier: LGPL-2.1-or-later
// The functions that set a contact problem: flags, bodies, friction, load and motion of both
// modules, and the shape of the contact in module 3.
#include "bindings/contact/library.hpp"
#include "bindings/contact/rollfem/contact_addon.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace rollfem::addon {

namespace {

using convert::Digits;
using Values = std::vector<double>;

/// A setting of the problems of (ire, icp).
void set(const char* function, const int* ire, const int* icp,
         std::initializer_list<const void*> others, const std::function<void(Problem&)>& work) {
  guarded(function, {ire, icp}, nullptr, [&] {
    if (std::find(others.begin(), others.end(), nullptr) != others.end())
      throw Refusal(err_other, "an argument is null");
    for_problems(*ire, *icp, work);
    return 0;
  });
}

/// The client's values, of which `needed` must be there. May be null where there are none.
Values values_of(const double* values, int count, int needed) {
  constexpr int most = 4'000'000;
  demand_values(count, needed);
  if (count > most) throw Refusal(err_other, "an array of impossible length");
  if (count > 0 && values == nullptr) throw Refusal(err_other, "an argument is null");
  Values given(values, values + std::max(count, 0));
  for (const double value : given)
    if (!std::isfinite(value)) throw Refusal(err_other, "a value is not finite");
  return given;
}

/// Numbers of elements, from reals.
int elements(double value) {
  if (!(value >= 1.0 && value <= 1e5)) throw Refusal(err_discr, "MX, MY: allowed: 1 to 100000");
  return static_cast<int>(value);
}

/// The same in mm: powers of length in each unit; the last one holds for all further values.
Values in_mm(const Units& units, Values values, const std::vector<int>& powers) {
  for (std::size_t k = 0; k < values.size(); ++k)
    values[k] = units.in(values[k], powers[std::min(k, powers.size() - 1)]);
  return values;
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

/// NU1, NU2, G1, G2 and what follows, by digit M: powers of length.
const std::map<int, std::vector<int>> material_powers{{0, {0, 0, -2, -2}},
                                                      {1, {0, 0, -2, -2, 0, 0, 0, 0}},
                                                      {2, {0, 0, -2, -2, 3, 0, 0, 0}},
                                                      {3, {0, 0, -2, -2, 0, 0, 0}},
                                                      {4, {0, 0, -2, -2, -2, 1, -2, -3}},
                                                      {5, {0, 0, -2, -2, 0, 0, 0}}};

void set_layer(int method, const Values& values, convert::BodyConstants& bodies) {
  if (method == 3 || method == 5) std::copy_n(values.begin(), 3, bodies.slope_reduction.begin());
  if (method == 4) std::copy_n(values.begin(), 4, bodies.layer.begin());
}

void set_material(int method, const double* given, int count, Problem& problem) {
  convert::ContactCase& made = problem.given;
  if (method >= 10) {
    made.digits.M2 = method - 10;
    return;
  }
  const auto powers = material_powers.find(method);
  if (powers == material_powers.end())
    throw Refusal(err_other, fmt::format("there is no material M = {}", method));
  const Values values =
      in_mm(problem.units, values_of(given, count, static_cast<int>(powers->second.size())),
            powers->second);
  made.digits.M = method;
  made.bodies.poisson = {values[0], values[1]};
  made.bodies.shear_modulus = {values[2], values[3]};
  set_layer(method, Values(values.begin() + 4, values.end()), made.bodies);
}

/// Numbers of a friction law by digit L, without the place of varying friction.
const std::map<int, std::vector<int>> friction_powers{
    {0, {0, 0}},                 // FSTAT, FKIN
    {2, {0, 0, 1, 0, 1, 1, 1}},  // FKIN, F1, SABSH1, F2, SABSH2, MEMDST, MEM_S0
    {3, {0, 0, 1, 0, 1, 1, 1}},  //
    {4, {0, 0, 1, 0, 1, 1, 1}},  //
    {5, {0, 0, -1}},             // FSTAT, POLACH_A, POLACH_B
    {6, {0, 0, 0, 0, 1, 1}}};    // FREF, TREF, DFHEAT, DTHEAT, MEMDST, MEM_S0

convert::FrictionSet friction_set(int law, const Values& v) {
  convert::FrictionSet set;
  if (law == 0) {
    set.fstat = v[0];
    set.fkin = v[1];
  } else if (law == 5) {  // Polach's law is the exponential one in other numbers
    if (!(v[2] > 0.0)) throw Refusal(err_frclaw, "POLACH_B must be positive");
    set.fstat = v[0];
    set.fkin = v[0] * v[1];
    set.fall = {set.fstat - set.fkin, std::log(2.0) / v[2], 0.0, 0.0};
  } else if (law == 6) {
    set.fstat = v[0];
    set.fall = {v[1], v[2], v[3], 0.0};
  } else {
    set.fkin = v[0];
    set.fall = {v[1], v[2], v[3], v[4]};
    set.fstat = v[0] + v[1] + v[3];
  }
  return set;
}

void set_friction(int method, const double* given, int count, Problem& problem) {
  const int varies = method / 10, law = method % 10;
  if (method < 0 || varies > 2 || (law > 6)) throw Refusal(err_frclaw, "unknown friction law");
  if (law == 1) return;  // as before
  const std::vector<int>& powers = friction_powers.at(law);
  const std::size_t numbers = powers.size(), stride = numbers + (varies > 0 ? 1 : 0);
  const Values all = values_of(given, count, static_cast<int>(stride));
  const double sets = varies > 0 ? all[0] : 1.0;
  if (!(sets >= 1.0 && sets <= 10000.0)) throw Refusal(err_frclaw, "NVF: allowed: 1 to 10000");
  const std::size_t begin = varies > 0 ? 1 : 0;
  demand_values(count, static_cast<int>(begin + static_cast<std::size_t>(sets) * stride));
  convert::ContactCase& made = problem.given;
  made.friction.clear();
  for (std::size_t k = 0; k < static_cast<std::size_t>(sets); ++k) {
    const auto first = all.begin() + static_cast<std::ptrdiff_t>(begin + k * stride);
    const Values v = in_mm(
        problem.units,
        Values(first + (varies > 0 ? 1 : 0), first + static_cast<std::ptrdiff_t>(stride)), powers);
    made.friction.push_back(friction_set(law, v));
    if (varies > 0) made.friction.back().place = problem.units.in(*first, varies == 2 ? 1 : 0);
    if (law == 6 || (law >= 2 && law <= 4)) made.memory = {v[numbers - 2], v[numbers - 1]};
    if (law == 5 || law == 0) made.memory = {};
  }
  made.friction_law = made.digits.L = law == 5 ? 4 : law;
  made.friction_over = made.digits.V = varies;
}

/// Numbers of the shapes of a potential contact area behind MX, MY.
const std::map<int, std::vector<int>> area_powers{
    {-6, {1, 1, 1, 0}}, {-5, {1, 1, 0}},   {-4, {-1, 1, 0}},  {-3, {1, 1, 0}},   {-2, {-1, 0, 0}},
    {-1, {-1, -1, 0}},  {1, {1, 1, 1, 1}}, {2, {1, 1, 1, 1}}, {3, {1, 1, 1, 1}}, {4, {1, 1, 1, 1}}};

void set_area(int kind, const double* given, int count, Problem& problem) {
  const auto powers = area_powers.find(kind);
  if (powers == area_powers.end())
    throw Refusal(err_discr, fmt::format("there is no potential contact area of kind {}", kind));
  const Values values = values_of(given, count, 2 + static_cast<int>(powers->second.size()));
  convert::PotentialContact& area = problem.given.potential;
  area = {kind, elements(values[0]), elements(values[1]), {}};
  if (static_cast<double>(area.mx) * area.my > 4e6) throw Refusal(err_discr, "MX MY: too many");
  const Values sizes =
      in_mm(problem.units,
            Values(values.begin() + 2,
                   values.begin() + 2 + static_cast<std::ptrdiff_t>(powers->second.size())),
            powers->second);
  std::copy(sizes.begin(), sizes.end(), area.size.begin());
}

/// DX and DS of module 1; A_SEP and what follows are not used.
void set_cells(const double* given, int count, Problem& problem) {
  const Values values = in_mm(problem.units, values_of(given, count, 2), {1});
  problem.given.wheel_rail.cell = {values[0], values[1]};
}

void set_distance(int base, const double* given, int count, Problem& problem) {
  static const std::map<int, std::vector<int>> powers{{1, {-1, -1, -1, 0, 0, 1}},
                                                      {2, {0, 1, 1, 1, 1, 1}},
                                                      {3, {1, -1, 1, 1, -1, 1, 1, 1}},
                                                      {9, {1}}};
  const auto found = powers.find(base);
  if (found == powers.end())
    throw Refusal(err_other, fmt::format("there is no undeformed distance IBASE = {}", base));
  problem.given.distance = {
      base, 1,
      in_mm(problem.units, values_of(given, count, static_cast<int>(found->second.size())),
            found->second)};
}

}  // namespace

extern "C" {

void cntc_setglobalflags(const int* lenflg, const int* params, const int* values) {
  guarded("cntc_setglobalflags", {lenflg, params, values}, nullptr, [&] {
    for (int k = 0; k < std::min(*lenflg, 1000); ++k)
      Library::here().set_flag(params[k], values[k]);
    return 0;
  });
}

void cntc_setflags(const int* ire, const int* icp, const int* lenflg, const int* params,
                   const int* values) {
  set("cntc_setflags", ire, icp, {lenflg, params, values}, [&](Problem& problem) {
    for (int k = 0; k < std::min(*lenflg, 1000); ++k) set_flag(params[k], values[k], problem);
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
  set("cntc_setmetadata", ire, icp, {lenmta, params, values}, [](Problem&) {});
}

/// Solvers need no settings; INISLP chooses among several states of falling friction.
void cntc_setsolverflags(const int* ire, const int* icp, const int* gdigit, const int* nints,
                         const int* iparam, const int* nreals, const double* rparam) {
  static_cast<void>(rparam);
  set("cntc_setsolverflags", ire, icp, {gdigit, nints, nreals}, [&](Problem& problem) {
    if (*nints > 0 && iparam == nullptr) throw Refusal(err_other, "an argument is null");
    if (*gdigit >= 2 && *gdigit <= 4 && *nints >= 5) problem.given.initial_slip = iparam[4];
    if (*gdigit == 0) problem.given.initial_slip = 0;
    if (*gdigit != 1 && *gdigit <= 5 && *nints >= 4)
      problem.given.max_outer = std::max(iparam[3], 1);
  });
}

void cntc_setmaterialparameters(const int* ire, const int* icp, const int* imeth, const int* nparam,
                                const double* rparam) {
  set("cntc_setmaterialparameters", ire, icp, {imeth, nparam},
      [&](Problem& problem) { set_material(*imeth, rparam, *nparam, problem); });
}

void cntc_settemperaturedata(const int* ire, const int* icp, const int* imeth, const int* nparam,
                             const double* params) {
  set("cntc_settemperaturedata", ire, icp, {imeth, nparam}, [&](Problem& problem) {
    if (*imeth != 0 && *imeth != 1 && *imeth != 3)
      throw Refusal(err_other, fmt::format("there is no method H = {}", *imeth));
    if (*imeth == 3) {
      const Values values =
          in_mm(problem.units, values_of(params, *nparam, 8), {0, 0, -1, -3, 0, 0, -1, -3, 0});
      for (std::size_t k = 0; k < 8; ++k) problem.given.bodies.heat[k / 4][k % 4] = values[k];
    }
    problem.given.digits.H = *imeth;
  });
}

void cntc_settimestep(const int* ire, const int* icp, const double* dt) {
  set("cntc_settimestep", ire, icp, {dt},
      [&](Problem& problem) { problem.time_step = values_of(dt, 1, 1).front(); });
}

void cntc_setreferencevelocity(const int* ire, const int* icp, const double* veloc) {
  set("cntc_setreferencevelocity", ire, icp, {veloc}, [&](Problem& problem) {
    problem.given.rolling[2] = problem.units.in(values_of(veloc, 1, 1).front());
  });
}

void cntc_setrollingstepsize(const int* ire, const int* icp, const double* chi, const double* dq) {
  set("cntc_setrollingstepsize", ire, icp, {chi, dq}, [&](Problem& problem) {
    const double step = values_of(dq, 1, 1).front();
    problem.given.wheel_rail.step = step;
    problem.given.rolling[0] = values_of(chi, 1, 1).front();
    problem.given.rolling[1] = problem.units.in(step);
  });
}

void cntc_setfrictionmethod(const int* ire, const int* icp, const int* imeth, const int* nparam,
                            const double* params) {
  set("cntc_setfrictionmethod", ire, icp, {imeth, nparam},
      [&](Problem& problem) { set_friction(*imeth, params, *nparam, problem); });
}

void cntc_sethertzcontact(const int* ire, const int* icp, const int* ipotcn, const int* nparam,
                          const double* params) {
  set("cntc_sethertzcontact", ire, icp, {ipotcn, nparam, params}, [&](Problem& problem) {
    if (*ipotcn >= 0) throw Refusal(err_discr, "IPOTCN: allowed: -6 to -1");
    set_area(*ipotcn, params, *nparam, problem);
  });
}

void cntc_setpotcontact(const int* ire, const int* icp, const int* ipotcn, const int* nparam,
                        const double* params) {
  set("cntc_setpotcontact", ire, icp, {ipotcn, nparam, params}, [&](Problem& problem) {
    if (problem.given.module == 1) return set_cells(params, *nparam, problem);
    if (*ipotcn <= 0) throw Refusal(err_discr, "IPOTCN: allowed: 1 to 4");
    set_area(*ipotcn, params, *nparam, problem);
  });
}

void cntc_setpenetration(const int* ire, const int* icp, const double* pen) {
  set("cntc_setpenetration", ire, icp, {pen}, [&](Problem& problem) {
    problem.penetration = problem.units.in(values_of(pen, 1, 1).front());
    problem.given.digits.N = 0;
  });
}

void cntc_setnormalforce(const int* ire, const int* icp, const double* fn) {
  set("cntc_setnormalforce", ire, icp, {fn}, [&](Problem& problem) {
    problem.normal_force = values_of(fn, 1, 1).front();
    problem.given.digits.N = 1;
  });
}

void cntc_setundeformeddistc(const int* ire, const int* icp, const int* ibase, const int* nparam,
                             const double* prmudf) {
  set("cntc_setundeformeddistc", ire, icp, {ibase, nparam, prmudf},
      [&](Problem& problem) { set_distance(*ibase, prmudf, *nparam, problem); });
}

void cntc_setcreepages(const int* ire, const int* icp, const double* vx, const double* vy,
                       const double* phi) {
  set("cntc_setcreepages", ire, icp, {vx, vy, phi}, [&](Problem& problem) {
    const bool shift = problem.given.digits.T == 1;
    const auto value = [&](const double* given, int power) {
      return problem.units.in(values_of(given, 1, 1).front(), power);
    };
    problem.creepage = {value(vx, shift ? 1 : 0), value(vy, shift ? 1 : 0),
                        value(phi, shift ? 0 : -1)};
  });
}

void cntc_setextrarigidslip(const int* ire, const int* icp, const int* lenarr, const double* wx,
                            const double* wy) {
  set("cntc_setextrarigidslip", ire, icp, {lenarr, wx, wy}, [](Problem&) {
    throw Refusal(err_other, "extra rigid slip of each element has no equivalent");
  });
}

void cntc_settangentialforces(const int* ire, const int* icp, const double* fx, const double* fy) {
  set("cntc_settangentialforces", ire, icp, {fx, fy}, [&](Problem& problem) {
    problem.tangential = {problem.units.body * values_of(fx, 1, 1).front(),
                          problem.units.body * values_of(fy, 1, 1).front()};
  });
}

}  // extern "C"

}  // namespace rollfem::addon
