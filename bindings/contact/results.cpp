// SPDX-License-Identifier: LGPL-2.1-or-later
// The functions that calculate, and return results of patches.
#include "bindings/contact/fields.hpp"
#include "bindings/contact/rows.hpp"

#include "convert/equivalent.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace rollfem::addon {

namespace {

double largest(const Values& values) {
  return *std::max_element(values.begin(), values.end());
}

/// Speed and creepages relative to the mean of forward and circumferential speed.
struct Kinematics {
  double speed = 0.0, longitudinal = 0.0, lateral = 0.0, spin = 0.0;
};

Kinematics kinematics_of(const Problem& problem, const Patch& patch) {
  const contact::PointResult& point = patch.point;
  const double mean = patch.placed ? 0.5 * (1.0 + patch.placed->circumferential) : 1.0;
  const double forward =
      patch.placed ? std::abs(convert::forward_speed(problem.given)) : problem.given.rolling[2];
  if (patch.scene->problem == contact::Problem::shift)
    return {forward, patch.along * point.longitudinal_shift, patch.across * point.lateral_shift,
            point.spin_shift};
  return {mean * forward, patch.along * point.creepage.longitudinal / mean,
          patch.across * point.creepage.lateral / mean, point.creepage.spin / mean};
}

/// Speed, CKSI, CETA, CPHI in the client's units.
Values motion_of(const Problem& problem, const Patch& patch) {
  const bool shift = patch.scene->problem == contact::Problem::shift;
  const Kinematics k = kinematics_of(problem, patch);
  const Units& u = problem.units;
  return {u.out(k.speed), u.out(k.longitudinal, shift ? 1 : 0), u.out(k.lateral, shift ? 1 : 0),
          u.out(k.spin, shift ? 0 : -1)};
}

Values creepages_of(Problem& problem, const Patch& patch) {
  const Values motion = motion_of(problem, patch);
  return {motion[1], motion[2], motion[3]};
}

/// 0 exterior, 1 adhesion, 2 slip, 3 plastic.
std::vector<int> division_of(const Patch& patch) {
  const auto& f = patch.point.fields;
  std::vector<int> states;
  for (int j = 0; j < patch.ny; ++j)
    for (int i = 0; i < patch.nx; ++i) {
      const int k = patch.index(i, j);
      const int state =
          f.state.empty() ? 1 : static_cast<int>(f.state[static_cast<std::size_t>(k)]);
      states.push_back(f.traction.n[k] > 0.0 ? std::max(state, 1) : 0);
    }
  return states;
}

/// Of contact, adhesion and slip.
Values areas_of(Problem& problem, const Patch& patch) {
  const std::vector<int> states = division_of(patch);
  const double area = problem.units.out(patch.grid.element_area(), 2);
  const auto elements = [&](int state) {
    return static_cast<double>(std::count(states.begin(), states.end(), state));
  };
  return {area * (static_cast<double>(states.size()) - elements(0)), area * elements(1),
          area * elements(2)};
}

/// MX, MY, XC1, YC1, DX, DY
Values area_of(Problem& problem, const Patch& patch) {
  const contact::ContactGrid& g = patch.grid;
  const Units& u = problem.units;
  return {double(patch.nx),    double(patch.ny), u.out(patch.x(0.0)),
          u.out(patch.y(0.0)), u.out(g.dx),      u.out(g.dy)};
}

Values ellipse_of(Problem& problem, const Patch&) {
  const auto ellipse = convert::ellipse_of_case(problem.whole());
  if (!ellipse) throw Refusal(err_other, "this is no contact by IPOTCN = -1 to -3");
  const auto& [A, B, a, b] = *ellipse;
  const Units& u = problem.units;
  return {u.out(A, -1),
          u.out(B, -1),
          u.out(a),
          u.out(b),
          u.out(2.0 / (A + B)),
          u.out(std::sqrt(a * b)),
          problem.given.potential.size[2],
          u.out(b),
          u.out(b),
          a / b};
}

double largest_traction(const Problem& problem, const Patch& patch) {
  const Values px = field_values(fld_px, problem, patch), py = field_values(fld_py, problem, patch);
  double most = 0.0;
  for (std::size_t k = 0; k < px.size(); ++k) most = std::max(most, std::hypot(px[k], py[k]));
  return most;
}

/// In the client's units: by element (output, input).
double sensitivity(const Problem& problem, int output, int input) {
  constexpr std::array<int, 4> outputs{0, 0, 0, 1}, inputs{1, 0, 0, -1};
  const int power =
      outputs[static_cast<std::size_t>(output)] - inputs[static_cast<std::size_t>(input)];
  return (output > 0 ? problem.units.body : 1.0) *
         problem.units.out(problem.sensitivities(output, input), power);
}

}  // namespace

extern "C" {

ADDON_RESULT(cntc_getreferencevelocity, motion_of(problem, patch)[0])
ADDON_RESULT(cntc_getpenetration, u.out(point.approach))
ADDON_RESULT(cntc_getmaximumpressure, largest(field_values(fld_pn, problem, patch)))
ADDON_RESULT(cntc_getmaximumtraction, largest_traction(problem, patch))
ADDON_RESULTS_2(cntc_getmaximumtemperature, largest(field_values(fld_temp1, problem, patch)),
                largest(field_values(fld_temp2, problem, patch)))
ADDON_RESULTS_2(cntc_getgriddiscretization, u.out(patch.grid.dx), u.out(patch.grid.dy))
ADDON_RESULTS_3(cntc_getcreepages, creepages_of)
ADDON_RESULTS_3(cntc_getcontactpatchareas, areas_of)
ADDON_ARRAY(cntc_getpotcontact, area_of)
ADDON_ARRAY(cntc_gethertzcontact, ellipse_of)
ADDON_FIELDS_3(cntc_gettractions, fld_pn, fld_px, fld_py)
ADDON_FIELDS_3(cntc_getdisplacements, fld_un, fld_ux, fld_uy)
ADDON_FIELDS_2(cntc_getmicroslip, fld_sx, fld_sy)

void cntc_getfielddata(const int* ire, const int* icp, const int* ifld, const int* lenarr,
                       double* fld) {
  get_fields("cntc_getfielddata", ire, icp, ifld ? lenarr : nullptr, {ifld ? *ifld : 0}, {fld});
}

void cntc_getcontactforces(const int* ire, const int* icp, double* fn, double* tx, double* ty,
                           double* mz) {
  get_numbers(
      "cntc_getcontactforces", ire, icp, {fn, tx, ty, mz}, ADDON_WORK {
        const contact::PointResult& point = patch.point;
        const Units& u = problem.units;
        return Values{point.normal_force, u.body * patch.along * point.longitudinal_force,
                      u.body * patch.across * point.lateral_force,
                      u.body * u.out(point.spin_moment)};
      });
}

void cntc_calculate(const int* ire, const int* icp, int* ierror) {
  guarded("cntc_calculate", {ire, icp, ierror}, ierror, [&] {
    int code = 0;
    for_problem(*ire, *icp, [&](Problem& problem) { code = calculate(problem); });
    return code;
  });
}

void cntc_getnumcontactpatches(const int* ire, int* npatch) {
  guarded("cntc_getnumcontactpatches", {ire, npatch}, nullptr, [&] {
    *npatch = 0;
    const std::shared_ptr<Element> element = Library::here().at(*ire);
    if (element->module == 3) *npatch = static_cast<int>(element->problems.size());
    if (element->module == 3) return 0;
    for_problem(*ire, -1, [&](Problem& p) { *npatch = static_cast<int>(p.patches.size()); });
    return 0;
  });
}

/// In module 3 also before the solution.
void cntc_getnumelements(const int* ire, const int* icp, int* mx, int* my) {
  guarded("cntc_getnumelements", {ire, icp, mx, my}, nullptr, [&] {
    *mx = *my = 0;
    bool given = false;
    for_problem(*ire, *icp, [&](Problem& problem) {
      given = problem.given.module == 3;
      if (given) *mx = problem.given.potential.mx, *my = problem.given.potential.my;
    });
    if (given) return 0;
    for_patch(*ire, *icp, [&](Problem&, const Patch& patch) { *mx = patch.nx, *my = patch.ny; });
    return 0;
  });
}

void cntc_getelementdivision(const int* ire, const int* icp, const int* lenarr, int* eldiv) {
  guarded("cntc_getelementdivision", {ire, icp, lenarr, eldiv}, nullptr, [&] {
    std::fill_n(eldiv, std::max(*lenarr, 0), 0);
    for_patch(*ire, *icp, [&](Problem&, const Patch& patch) {
      if (*lenarr < patch.size()) throw Refusal(err_other, "the array is too short");
      const std::vector<int> states = division_of(patch);
      std::copy(states.begin(), states.end(), eldiv);
    });
    return 0;
  });
}

void cntc_getsensitivities(const int* ire, const int* icp, const int* lenout, const int* lenin,
                           double* sens) {
  guarded("cntc_getsensitivities", {ire, icp, lenout, lenin, sens}, nullptr, [&] {
    if (*lenout < 0 || *lenin < 0 || *lenout > 4 || *lenin > 4)
      throw Refusal(err_other, "LENOUT, LENIN: allowed: 0 to 4");
    for_patch(*ire, *icp, [&](Problem& problem, const Patch&) {
      for (int k = 0; k < *lenin; ++k)
        for (int j = 0; j < *lenout; ++j) sens[k * *lenout + j] = sensitivity(problem, j, k);
    });
    return 0;
  });
}

void cntc_getcalculationtime(const int* ire, const int* icp, double* tcpu, double* twall) {
  guarded("cntc_getcalculationtime", {ire, icp, tcpu, twall}, nullptr, [&] {
    *tcpu = *twall = std::numeric_limits<double>::quiet_NaN();
    for_problem(*ire, *icp, [&](Problem& p) { *tcpu = p.cpu, *twall = p.wall; });
    return 0;
  });
}

void cntc_resetcalculationtime(const int* ire, const int* icp) {
  guarded("cntc_resetcalculationtime", {ire, icp}, nullptr, [&] {
    for_problem(*ire, *icp, [](Problem& p) { p.cpu = p.wall = 0.0; });
    return 0;
  });
}

}  // extern "C"

}  // namespace rollfem::addon
