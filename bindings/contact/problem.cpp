// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/contact/problem.hpp"

#include "base/progress.hpp"
#include "base/threads.hpp"
#include "bindings/contact/library.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <optional>

namespace rollfem::addon {

using convert::ContactCase;

double Units::scale(int power) const {
  double scale = 1.0;
  for (int k = 0; k < std::abs(power); ++k) scale *= length;
  return power < 0 ? 1.0 / scale : scale;
}

std::vector<double> Units::in(std::vector<double> values, const std::vector<int>& powers) const {
  for (std::size_t k = 0; k < values.size(); ++k)
    values[k] *= scale(powers[std::min(k, powers.size() - 1)]);
  return values;
}

std::vector<double> Units::out(std::vector<double> values, const std::vector<int>& powers) const {
  return Units{1.0 / length, body, code}.in(std::move(values), powers);
}

Problem::Problem() {
  given.module = 3;
  given.number = 1;
  given.digits.P = 2;
  given.digits.T = 3;
}

ContactCase Problem::whole() const {
  ContactCase made = given;
  const int F = given.digits.F;
  made.kinematics = {given.digits.N == 1 ? normal_force : penetration,
                     F > 0 ? tangential[0] : creepage[0], F > 1 ? tangential[1] : creepage[1],
                     creepage[2]};
  if (given.module == 1 && given.digits.N == 1) made.wheel_rail.position[2] = normal_force;
  return made;
}

std::vector<Patch*> patches_of(Problem& problem, int icp) {
  if (problem.cases == 0) throw Refusal(err_icp, "it is not solved");
  std::vector<Patch*> patches;
  for (Patch& patch : problem.patches) patches.push_back(&patch);
  const auto number = static_cast<std::size_t>(problem.given.module == 1 ? std::max(icp, 0) : 0);
  if (number > patches.size()) throw Refusal(err_icp, "there is no such patch");
  if (number > 0) patches = {patches[number - 1]};
  return patches;
}

namespace {

/// What a reader of input files would have refused.
void check(const ContactCase& given) {
  const auto demand = [](bool right, int code, const char* what) {
    if (!right) throw Refusal(code, what);
  };
  demand(given.digits.T == 0 || !given.friction.empty(), err_frclaw, "friction is not set");
  demand(given.digits.T >= 0 && given.digits.F >= 0, err_other, "a digit is negative");
  if (given.module == 1) {
    const convert::WheelRail& pair = given.wheel_rail;
    const int side = given.digits.config;
    demand(side == 0 || side == 1 || side == 4 || side == 5, err_other, "C1: allowed: 0, 1, 4, 5");
    demand(!pair.rail.name.empty() && !pair.wheel.name.empty(), err_profil,
           "the profile of wheel or rail is not set");
    demand(pair.cell[0] > 0.0 && pair.cell[1] > 0.0, err_discr, "DX, DS: not set");
    demand(pair.wheelset[2] > 0.0, err_other, "the dimensions of the wheelset are not set");
    return;
  }
  const convert::PotentialContact& area = given.potential;
  const auto rows = static_cast<std::size_t>(area.my);
  demand(area.ipotcn != 0, err_discr, "the potential contact area is not set");
  demand(given.friction.size() <= 1 || given.friction.size() == rows, err_frclaw,
         "varying friction needs a set for each row of elements");
  if (area.ipotcn < 0) return;
  const std::size_t values = given.distance.values.size();
  const int base = given.distance.ibase;
  const std::size_t needed = base == 1   ? 6
                             : base == 3 ? 8
                             : base == 9 ? rows * static_cast<std::size_t>(area.mx)
                             : values > 5 && given.distance.values[0] >= 2.0
                                 ? 5 + static_cast<std::size_t>(given.distance.values[0])
                                 : 7;
  demand(values == needed, err_other, "the undeformed distance has not as many values as it needs");
}

/// Elements at the border of the potential contact area that are in contact.
int at_border(const Patch& patch) {
  int count = 0;
  for (int j = 0; j < patch.ny; ++j)
    for (int i = 0; i < patch.nx; ++i)
      if ((i == 0 || j == 0 || i + 1 == patch.nx || j + 1 == patch.ny) &&
          patch.point.fields.traction.n[patch.index(i, j)] > 0.0)
        ++count;
  return count;
}

/// FN, FX and FY over FSTAT FN, MZ.
Eigen::Vector4d outputs(const Patch& patch, double fstat) {
  const contact::PointResult& point = patch.point;
  const double bound = fstat * point.normal_force;
  return {point.normal_force, patch.along * point.longitudinal_force / bound,
          patch.across * point.lateral_force / bound, point.spin_moment};
}

/// By PEN, CKSI, CETA and CPHI: central differences with the approach and the creepages given.
/// `moved`: before it was solved.
Eigen::Matrix4d sensitivities_of(Problem moved, const Patch& patch, bool of_friction) {
  Eigen::Matrix4d found = Eigen::Matrix4d::Zero();
  const contact::PointResult& at = patch.point;
  const double turned = patch.along;
  convert::ContactCase& given = moved.given;
  if (given.friction.empty()) return found;
  given.digits.N = given.digits.F = 0;
  const double fstat = given.friction.front().fstat;
  const bool shift = given.digits.T == 1;
  const std::array<double, 4> middle{
      at.approach, turned * (shift ? at.longitudinal_shift : at.creepage.longitudinal),
      turned * (shift ? at.lateral_shift : at.creepage.lateral),
      shift ? at.spin_shift : at.creepage.spin};
  // Of the creepages, or shifts, a fraction of those at which the patch slides.
  const double c = std::sqrt(std::max(at.semi_axis_x * at.semi_axis_y, 1e-12));
  const double slide = fstat * at.approach / (shift ? 1.0 : c);
  const std::array<double, 4> step{1e-3 * at.approach, 1e-3 * slide, 1e-3 * slide,
                                   1e-3 * slide / c};
  for (int k = 0; k < (of_friction ? 4 : 1); ++k)
    for (const double side : {1.0, -1.0}) {
      std::array<double, 4> values = middle;
      values[static_cast<std::size_t>(k)] += side * step[static_cast<std::size_t>(k)];
      moved.penetration = values[0];
      moved.creepage = {values[1], values[2], values[3]};
      const auto patches = moved.solver.solve(moved.whole(), moved.profile_text, moved.extra_slip);
      found.col(k) +=
          0.5 * side / step[static_cast<std::size_t>(k)] * outputs(patches.front(), fstat);
    }
  if (!of_friction) found.bottomRows(3).setZero();
  return found;
}

}  // namespace

int calculate(Problem& problem) {
  const contact::Threads threads(std::max(Library::here().threads(), 1));
  const contact::Stopwatch watch;
  const std::clock_t begin = std::clock();
  const ContactCase given = problem.whole();
  check(given);
  if (given.digits.R >= 2) return 0;
  const convert::Digits& digits = given.digits;
  const bool continues = digits.P == 0 && (digits.T == 1 || digits.T == 2);
  const int sens = continues ? 0 : problem.flags[ic_sens];
  std::optional<Problem> before;
  if (sens >= 2 && given.module == 3) before = problem;
  problem.patches = problem.solver.solve(given, problem.profile_text, problem.extra_slip);
  ++problem.cases;
  problem.sensitivities.setZero();
  if (before) problem.sensitivities = sensitivities_of(*before, problem.patches.front(), sens >= 3);
  problem.wall += watch.seconds();
  problem.cpu += static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  int border = 0;
  if (given.module == 3) border = at_border(problem.patches.front());
  return border;
}

}  // namespace rollfem::addon
