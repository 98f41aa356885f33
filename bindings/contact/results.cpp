// SPDX-License-Identifier: LGPL-2.1-or-later
// The functions that calculate, and return results of patches.
#include "bindings/contact/rows.hpp"

#include "convert/equivalent.hpp"
#include <algorithm>
#include <array>
#include <cmath>

namespace rollfem::addon {

namespace {

double largest(const Values& values) {
  return *std::max_element(values.begin(), values.end());
}

/// Speed, CKSI, CETA, CPHI in the client's units, relative to the mean of forward and
/// circumferential speed.
Values motion_of(const Problem& problem, const Patch& patch) {
  const contact::PointResult& p = patch.point;
  const double forward =
      patch.placed ? std::abs(convert::forward_speed(problem.given)) : problem.given.rolling[2];
  if (patch.scene->problem == contact::Problem::shift)
    return problem.units.out(
        {forward, patch.along * p.longitudinal_shift, patch.across * p.lateral_shift, p.spin_shift},
        {1, 1, 1, 0});
  const double mean = patch.placed ? 0.5 * (1.0 + patch.placed->circumferential) : 1.0;
  return problem.units.out({mean * forward, patch.along * p.creepage.longitudinal / mean,
                            patch.across * p.creepage.lateral / mean, p.creepage.spin / mean},
                           {1, 0, 0, -1});
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
  const auto elements = [&](int state) {
    return static_cast<double>(std::count(states.begin(), states.end(), state));
  };
  const double area = problem.units.out(patch.grid.element_area(), 2);
  return {area * (patch.size() - elements(0)), area * elements(1), area * elements(2)};
}

/// MX, MY, XC1, YC1, DX, DY
Values area_of(Problem& problem, const Patch& patch) {
  return problem.units.out({double(patch.nx), double(patch.ny), patch.x(0.0), patch.y(0.0),
                            patch.grid.dx, patch.grid.dy},
                           {0, 0, 1});
}

Values ellipse_of(Problem& problem, const Patch&) {
  const auto ellipse = convert::ellipse_of_case(problem.whole());
  if (!ellipse) throw Refusal(err_other, "this is no contact by IPOTCN = -1 to -3");
  const auto& [A, B, a, b] = *ellipse;
  return problem.units.out(
      {A, B, a, b, 2.0 / (A + B), std::sqrt(a * b), problem.given.potential.size[2], b, b, a / b},
      {-1, -1, 1, 1, 1, 1, 0, 1, 1, 0});
}

double largest_traction(const Problem& problem, const Patch& patch) {
  const Values px = field_values(fld_px, problem, patch), py = field_values(fld_py, problem, patch);
  double most = 0.0;
  for (std::size_t k = 0; k < px.size(); ++k) most = std::max(most, std::hypot(px[k], py[k]));
  return most;
}

/// In the client's units.
double sensitivity(const Problem& problem, int output, int input) {
  const int shift = problem.given.digits.T == 1 ? 1 : 0;
  const int power = (output == 3 ? 1 : 0) - (input == 0 ? 1 : input == 3 ? shift - 1 : shift);
  return (output > 0 ? problem.units.body : 1.0) *
         problem.units.out(problem.sensitivities(output, input), power);
}

Values forces_of(Problem& problem, const Patch& patch) {
  const contact::PointResult& p = patch.point;
  const double body = problem.units.body;
  return problem.units.out({p.normal_force, body * patch.along * p.longitudinal_force,
                            body * patch.across * p.lateral_force, body * p.spin_moment},
                           {0, 0, 0, 1});
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

void cntc_getfielddata(Int ire, Int icp, Int ifld, Int lenarr, double* fld) {
  get_fields("cntc_getfielddata", ire, icp, ifld ? lenarr : nullptr, {ifld ? *ifld : 0}, {fld});
}

void cntc_getcontactforces(Int ire, Int icp, double* fn, double* tx, double* ty, double* mz) {
  get_numbers("cntc_getcontactforces", ire, icp, {fn, tx, ty, mz}, forces_of);
}

void cntc_calculate(Int ire, Int icp, int* ierror) {
  guarded("cntc_calculate", {ire, icp, ierror}, ierror, [&] {
    int code = 0;
    for_problem(*ire, *icp, [&](Problem& problem) { code = calculate(problem); });
    return code;
  });
}

void cntc_getnumcontactpatches(Int ire, int* npatch) {
  guarded("cntc_getnumcontactpatches", {ire, npatch}, [&] {
    *npatch = 0;
    const std::shared_ptr<Element> element = Library::here().at(*ire);
    *npatch = static_cast<int>(element->problems.size());
    if (element->module == 1)
      for_problem(*ire, -1, [&](Problem& p) { *npatch = static_cast<int>(p.patches.size()); });
  });
}

/// In module 3 also before the solution.
void cntc_getnumelements(Int ire, Int icp, int* mx, int* my) {
  guarded("cntc_getnumelements", {ire, icp, mx, my}, [&] {
    *mx = *my = 0;
    for_problem(*ire, *icp, [&](Problem& problem) {
      *mx = problem.given.potential.mx, *my = problem.given.potential.my;
      if (problem.given.module == 3) return;
      const std::vector<Patch*> patches = patches_of(problem, *icp);
      if (!patches.empty()) *mx = patches.front()->nx, *my = patches.front()->ny;
    });
  });
}

void cntc_getelementdivision(Int ire, Int icp, Int lenarr, int* eldiv) {
  guarded("cntc_getelementdivision", {ire, icp, lenarr, eldiv}, [&] {
    std::fill_n(eldiv, std::max(*lenarr, 0), 0);
    for_patch(*ire, *icp, [&](Problem&, const Patch& patch) {
      if (*lenarr < patch.size()) throw Refusal(err_other, "the array is too short");
      const std::vector<int> states = division_of(patch);
      std::copy(states.begin(), states.end(), eldiv);
    });
  });
}

void cntc_getsensitivities(Int ire, Int icp, Int lenout, Int lenin, double* sens) {
  guarded("cntc_getsensitivities", {ire, icp, lenout, lenin, sens}, [&] {
    if (*lenout < 0 || *lenin < 0 || *lenout > 4 || *lenin > 4)
      throw Refusal(err_other, "LENOUT, LENIN: allowed: 0 to 4");
    for_patch(*ire, *icp, [&](Problem& problem, const Patch&) {
      for (int k = 0; k < *lenin; ++k)
        for (int j = 0; j < *lenout; ++j) sens[k * *lenout + j] = sensitivity(problem, j, k);
    });
  });
}

void cntc_getcalculationtime(Int ire, Int icp, double* tcpu, double* twall) {
  guarded("cntc_getcalculationtime", {ire, icp, tcpu, twall}, [&] {
    *tcpu = *twall = none;
    for_problem(*ire, *icp, [&](Problem& p) { *tcpu = p.cpu, *twall = p.wall; });
  });
}

void cntc_resetcalculationtime(Int ire, Int icp) {
  guarded("cntc_resetcalculationtime", {ire, icp},
          [&] { for_problem(*ire, *icp, [](Problem& p) { p.cpu = p.wall = 0.0; }); });
}

}  // extern "C"

}  // namespace rollfem::addon
