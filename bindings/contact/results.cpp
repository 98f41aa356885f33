// SPDX-License-Identifier: LGPL-2.1-or-later
// The functions that calculate and return results of patches.
#include "bindings/contact/library.hpp"
#include "bindings/contact/rollfem/contact_addon.h"
#include "halfspace/patch/patch_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace rollfem::addon {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Numbers of the client, which are nan (0 for counts) unless the function fills them.
constexpr int one = 1;
struct Outputs {
  std::initializer_list<double*> reals = {};
  std::initializer_list<int*> integers = {};
  const int* count = &one;  ///< of each
};

/// A result of a patch.
void get(const char* function, const int* ire, const int* icp, const Outputs& outputs,
         const std::function<void(Problem&, const Patch&)>& work) {
  guarded(function, {ire, icp, outputs.count}, nullptr, [&] {
    for (double* real : outputs.reals) {
      if (real == nullptr) throw Refusal(err_other, "an argument is null");
      std::fill_n(real, std::max(*outputs.count, 0), none);
    }
    for (int* integer : outputs.integers) {
      if (integer == nullptr) throw Refusal(err_other, "an argument is null");
      std::fill_n(integer, std::max(*outputs.count, 0), 0);
    }
    for_patch(*ire, *icp, work);
    return 0;
  });
}

/// Of the bodies in CONTACT's words: 1 is the wheel in module 3, the rail in module 1.
bool first_is_wheel(const Problem& problem) {
  return problem.given.module == 3;
}

contact::Field undeformed_distance(const contact::PointResult& point) {
  const auto& fields = point.fields;
  if (fields.gap.size() == 0 || fields.displacement.n.size() != fields.gap.size()) return {};
  return (fields.gap - fields.displacement.n).array() + point.approach;
}

contact::Field friction_of(const Patch& patch) {
  const auto& fields = patch.point.fields;
  contact::Field mu = contact::coefficients_of(patch.scene->friction(), patch.grid);
  for (Eigen::Index k = 0; k < fields.traction_bound.size(); ++k)
    if (fields.traction.n[k] > 0.0) mu[k] = fields.traction_bound[k] / fields.traction.n[k];
  return mu;
}

contact::TangentialField rigid_slip(const Patch& patch) {
  return halfspace::halfspace_geometry(*patch.scene).rigid_slip(patch.point.creepage, patch.grid);
}

/// Zero where there is no pressure, and everywhere if the field is empty.
contact::Field in_contact(const contact::Field& field, const contact::Field& pressure) {
  if (field.size() == 0) return contact::Field::Zero(pressure.size());
  return (pressure.array() > 0.0).select(field, 0.0);
}

/// A field in mm and MPa with its factor and its power of length in the client's units; empty: not
/// known.
struct Known {
  contact::Field values;
  double sign = 1.0;
  int power = 0;
};

Known field_of(int code, const Problem& problem, const Patch& patch) {
  const auto& f = patch.point.fields;
  const double x = patch.along * problem.units.body, y = patch.across * problem.units.body;
  const bool yields = problem.given.digits.M == 4 && problem.given.bodies.layer[2] > 0.0;
  const contact::Field zero = contact::Field::Zero(patch.grid.size());
  switch (code) {
    case fld_h:
      return {undeformed_distance(patch.point), 1.0, 1};
    case fld_mu:
      return {friction_of(patch)};
    case fld_px:
      return {f.traction.x.size() > 0 ? f.traction.x : zero, x, -2};
    case fld_py:
      return {f.traction.y.size() > 0 ? f.traction.y : zero, y, -2};
    case fld_pn:
      return {f.traction.n, 1.0, -2};
    case fld_ux:
      return {f.displacement.x, x, 1};
    case fld_uy:
      return {f.displacement.y, y, 1};
    case fld_un:
      return {f.displacement.n, 1.0, 1};
    case fld_taucrt:
      return {yields ? contact::Field() : zero, 1.0, -2};
    case fld_uplsx:
    case fld_uplsy:
      return {yields ? contact::Field() : zero, 1.0, 1};
    case fld_sx:
      return {in_contact(f.slip.x, f.traction.n), x};
    case fld_sy:
      return {in_contact(f.slip.y, f.traction.n), y};
    case fld_temp1:
      return {first_is_wheel(problem) ? f.temperature_wheel : f.temperature_rail};
    case fld_temp2:
      return {first_is_wheel(problem) ? f.temperature_rail : f.temperature_wheel};
    case fld_wx:
      return {rigid_slip(patch).x, x};
    case fld_wy:
      return {rigid_slip(patch).y, y};
    default:
      throw Refusal(err_other, fmt::format("there is no field {}", code));
  }
}

/// Writes a field by rows of CONTACT's elements.
void copy_field(int code, const Problem& problem, const Patch& patch, int count, double* out) {
  const Known known = field_of(code, problem, patch);
  if (known.values.size() == 0)
    throw Refusal(err_other, fmt::format("field {} is not known for this case", code));
  if (count < patch.size())
    throw Refusal(err_other, fmt::format("the array has {} values, the patch {} elements", count,
                                         patch.size()));
  const double factor = known.sign * problem.units.out(1.0, known.power);
  for (int j = 0; j < patch.ny; ++j)
    for (int i = 0; i < patch.nx; ++i)
      out[j * patch.nx + i] = factor * known.values[patch.index(i, j)];
}

double largest(const contact::Field& values) {
  return values.size() > 0 ? values.maxCoeff() : none;
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

}  // namespace

extern "C" {

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
    const int icp = -1;
    if (Library::here().at(*ire)->module == 3)
      *npatch = static_cast<int>(Library::here().at(*ire)->problems.size());
    else
      for_problem(*ire, icp,
                  [&](Problem& problem) { *npatch = static_cast<int>(problem.patches.size()); });
    return 0;
  });
}

void cntc_getreferencevelocity(const int* ire, const int* icp, double* veloc) {
  get("cntc_getreferencevelocity", ire, icp, {{veloc}}, [&](Problem& problem, const Patch& patch) {
    *veloc = problem.units.out(kinematics_of(problem, patch).speed);
  });
}

void cntc_getnumelements(const int* ire, const int* icp, int* mx, int* my) {
  guarded("cntc_getnumelements", {ire, icp, mx, my}, nullptr, [&] {
    *mx = *my = 0;
    bool given = false;  // before the first solution
    for_problem(*ire, *icp, [&](Problem& problem) {
      given = problem.given.module == 3;
      *mx = problem.given.potential.mx;
      *my = problem.given.potential.my;
    });
    if (given) return 0;
    *mx = *my = 0;
    for_patch(*ire, *icp, [&](Problem&, const Patch& patch) {
      *mx = patch.nx;
      *my = patch.ny;
    });
    return 0;
  });
}

void cntc_getgriddiscretization(const int* ire, const int* icp, double* dx, double* dy) {
  get("cntc_getgriddiscretization", ire, icp, {{dx, dy}},
      [&](Problem& problem, const Patch& patch) {
        *dx = problem.units.out(patch.grid.dx);
        *dy = problem.units.out(patch.grid.dy);
      });
}

/// MX, MY, XC1, YC1, DX, DY
void cntc_getpotcontact(const int* ire, const int* icp, const int* lenarr, double* rvalues) {
  get("cntc_getpotcontact", ire, icp, {{rvalues}, {}, lenarr},
      [&](Problem& problem, const Patch& patch) {
        const auto centre = [](double first, double step, int place, bool turned, int count) {
          return turned ? -(first + (place + count - 1) * step) : first + place * step;
        };
        const contact::ContactGrid& grid = patch.grid;
        const Units& units = problem.units;
        const double values[] = {
            double(patch.nx),
            double(patch.ny),
            units.out(
                centre(grid.x_first, grid.dx, patch.first_column, patch.turns_columns, patch.nx)),
            units.out(centre(grid.y_first, grid.dy, patch.first_row, patch.turns_rows, patch.ny)),
            units.out(grid.dx),
            units.out(grid.dy)};
        std::copy_n(values, std::clamp(*lenarr, 0, 6), rvalues);
      });
}

void cntc_gethertzcontact(const int* ire, const int* icp, const int* lenarr, double* rvalues) {
  get("cntc_gethertzcontact", ire, icp, {{rvalues}, {}, lenarr},
      [&](Problem& problem, const Patch& patch) {
        const auto ellipse = convert::ellipse_of_case(problem.whole());
        if (!ellipse) throw Refusal(err_other, "this is no contact by IPOTCN = -1 to -3");
        static_cast<void>(patch);
        const auto& [A, B, a, b] = *ellipse;
        const Units& u = problem.units;
        const double scale = problem.given.potential.size[2];
        const double values[] = {u.out(A, -1),
                                 u.out(B, -1),
                                 u.out(a),
                                 u.out(b),
                                 u.out(2.0 / (A + B)),
                                 u.out(std::sqrt(a * b)),
                                 scale,
                                 u.out(b),
                                 u.out(b),
                                 a / b};
        std::copy_n(values, std::clamp(*lenarr, 0, 10), rvalues);
      });
}

void cntc_getpenetration(const int* ire, const int* icp, double* pen) {
  get("cntc_getpenetration", ire, icp, {{pen}}, [&](Problem& problem, const Patch& patch) {
    *pen = problem.units.out(patch.point.approach);
  });
}

void cntc_getcreepages(const int* ire, const int* icp, double* vx, double* vy, double* phi) {
  get("cntc_getcreepages", ire, icp, {{vx, vy, phi}}, [&](Problem& problem, const Patch& patch) {
    const bool shift = patch.scene->problem == contact::Problem::shift;
    const Kinematics k = kinematics_of(problem, patch);
    *vx = problem.units.out(k.longitudinal, shift ? 1 : 0);
    *vy = problem.units.out(k.lateral, shift ? 1 : 0);
    *phi = problem.units.out(k.spin, shift ? 0 : -1);
  });
}

void cntc_getcontactforces(const int* ire, const int* icp, double* fn, double* tx, double* ty,
                           double* mz) {
  get("cntc_getcontactforces", ire, icp, {{fn, tx, ty, mz}},
      [&](Problem& problem, const Patch& patch) {
        const contact::PointResult& point = patch.point;
        *fn = point.normal_force;
        *tx = problem.units.body * patch.along * point.longitudinal_force;
        *ty = problem.units.body * patch.across * point.lateral_force;
        *mz = problem.units.body * problem.units.out(point.spin_moment);
      });
}

void cntc_getcontactpatchareas(const int* ire, const int* icp, double* carea, double* harea,
                               double* sarea) {
  get("cntc_getcontactpatchareas", ire, icp, {{carea, harea, sarea}},
      [&](Problem& problem, const Patch& patch) {
        std::array<int, 4> count{};
        const auto& f = patch.point.fields;
        for (Eigen::Index k = 0; k < f.traction.n.size(); ++k)
          if (f.traction.n[k] > 0.0)
            ++count[f.state.empty() ? 1 : static_cast<std::size_t>(f.state[k])];
        const double area = problem.units.out(patch.grid.element_area(), 2);
        *carea = area * (count[0] + count[1] + count[2] + count[3]);
        *harea = area * (count[0] + count[1]);
        *sarea = area * count[2];
      });
}

void cntc_getelementdivision(const int* ire, const int* icp, const int* lenarr, int* eldiv) {
  get("cntc_getelementdivision", ire, icp, {{}, {eldiv}, lenarr},
      [&](Problem&, const Patch& patch) {
        if (*lenarr < patch.size()) throw Refusal(err_other, "the array is too short");
        const auto& f = patch.point.fields;
        for (int j = 0; j < patch.ny; ++j)
          for (int i = 0; i < patch.nx; ++i) {
            const auto k = patch.index(i, j);
            const bool loaded = f.traction.n[k] > 0.0;
            eldiv[j * patch.nx + i] = !loaded           ? 0
                                      : f.state.empty() ? 1
                                                        : static_cast<int>(f.state[k]);
          }
      });
}

void cntc_getmaximumpressure(const int* ire, const int* icp, double* pnmax) {
  get("cntc_getmaximumpressure", ire, icp, {{pnmax}}, [&](Problem& problem, const Patch& patch) {
    *pnmax = problem.units.out(largest(patch.point.fields.traction.n), -2);
  });
}

void cntc_getmaximumtraction(const int* ire, const int* icp, double* ptmax) {
  get("cntc_getmaximumtraction", ire, icp, {{ptmax}}, [&](Problem& problem, const Patch& patch) {
    const auto& p = patch.point.fields.traction;
    *ptmax = p.x.size() == 0
                 ? 0.0
                 : problem.units.out(
                       (p.x.array().square() + p.y.array().square()).sqrt().maxCoeff(), -2);
  });
}

void cntc_getmaximumtemperature(const int* ire, const int* icp, double* t1max, double* t2max) {
  get("cntc_getmaximumtemperature", ire, icp, {{t1max, t2max}},
      [&](Problem& problem, const Patch& patch) {
        *t1max = largest(field_of(fld_temp1, problem, patch).values);
        *t2max = largest(field_of(fld_temp2, problem, patch).values);
        if (std::isnan(*t1max)) throw Refusal(err_other, "temperatures are not known here");
      });
}

void cntc_getfielddata(const int* ire, const int* icp, const int* ifld, const int* lenarr,
                       double* fld) {
  get("cntc_getfielddata", ire, icp, {{fld}, {}, ifld ? lenarr : nullptr},
      [&](Problem& problem, const Patch& patch) {
        copy_field(*ifld, problem, patch, *lenarr, fld);
      });
}

void cntc_gettractions(const int* ire, const int* icp, const int* lenarr, double* pn, double* px,
                       double* py) {
  get("cntc_gettractions", ire, icp, {{pn, px, py}, {}, lenarr},
      [&](Problem& problem, const Patch& patch) {
        copy_field(fld_pn, problem, patch, *lenarr, pn);
        copy_field(fld_px, problem, patch, *lenarr, px);
        copy_field(fld_py, problem, patch, *lenarr, py);
      });
}

void cntc_getmicroslip(const int* ire, const int* icp, const int* lenarr, double* sx, double* sy) {
  get("cntc_getmicroslip", ire, icp, {{sx, sy}, {}, lenarr},
      [&](Problem& problem, const Patch& patch) {
        copy_field(fld_sx, problem, patch, *lenarr, sx);
        copy_field(fld_sy, problem, patch, *lenarr, sy);
      });
}

void cntc_getdisplacements(const int* ire, const int* icp, const int* lenarr, double* un,
                           double* ux, double* uy) {
  get("cntc_getdisplacements", ire, icp, {{un, ux, uy}, {}, lenarr},
      [&](Problem& problem, const Patch& patch) {
        copy_field(fld_un, problem, patch, *lenarr, un);
        copy_field(fld_ux, problem, patch, *lenarr, ux);
        copy_field(fld_uy, problem, patch, *lenarr, uy);
      });
}

void cntc_getsensitivities(const int* ire, const int* icp, const int* lenout, const int* lenin,
                           double* sens) {
  guarded("cntc_getsensitivities", {ire, icp, lenout, lenin, sens}, nullptr, [&] {
    if (*lenout < 0 || *lenin < 0 || *lenout > 4 || *lenin > 4)
      throw Refusal(err_other, "LENOUT, LENIN: allowed: 0 to 4");
    for_patch(*ire, *icp, [&](Problem& problem, const Patch&) {
      const std::array<int, 4> outputs{0, 0, 0, 1}, inputs{1, 0, 0, -1};
      const double body = problem.units.body;
      for (int k = 0; k < *lenin; ++k)
        for (int j = 0; j < *lenout; ++j)
          sens[k * *lenout + j] =
              (j > 0 ? body : 1.0) * problem.units.out(problem.sensitivities(j, k),
                                                       outputs[static_cast<std::size_t>(j)] -
                                                           inputs[static_cast<std::size_t>(k)]);
    });
    return 0;
  });
}

void cntc_getcalculationtime(const int* ire, const int* icp, double* tcpu, double* twall) {
  guarded("cntc_getcalculationtime", {ire, icp, tcpu, twall}, nullptr, [&] {
    *tcpu = *twall = none;
    for_problem(*ire, *icp, [&](Problem& problem) {
      *tcpu = problem.cpu;
      *twall = problem.wall;
    });
    return 0;
  });
}

void cntc_resetcalculationtime(const int* ire, const int* icp) {
  guarded("cntc_resetcalculationtime", {ire, icp}, nullptr, [&] {
    for_problem(*ire, *icp, [](Problem& problem) { problem.cpu = problem.wall = 0.0; });
    return 0;
  });
}

}  // extern "C"

}  // namespace rollfem::addon
