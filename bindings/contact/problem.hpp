// SPDX-License-Identifier: LGPL-2.1-or-later
// A contact problem as a client of CONTACT's library sets it, and its solution.
#pragma once

#include "bindings/contact/solver.hpp"
#include "track/balance/balance.hpp"

#include <Eigen/Core>

#include "convert/contact_case.hpp"
#include <array>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace rollfem::addon {

/// A client's units; inside all are mm, N, MPa, s, rad. Forces are always in N.
struct Units {
  double length = 1.0;  ///< mm
  double body = 1.0;    ///< -1: tangential forces, slip and displacements are of body 2
  int code = 1934;

  /// A value with `power` lengths in its unit: 1 a length or a velocity, -2 a stress.
  double in(double value, int power = 1) const { return value * scale(power); }
  double out(double value, int power = 1) const { return value / scale(power); }
  /// Of many, the last power holds for all further.
  std::vector<double> in(std::vector<double> values, const std::vector<int>& powers) const;
  std::vector<double> out(std::vector<double> values, const std::vector<int>& powers) const;
  double scale(int power) const;
};

/// A block of points below the surface, as given.
struct Block {
  int kind = 9;
  std::array<std::vector<double>, 3> given;
};

/// Of a number that is not known.
inline constexpr double none = std::numeric_limits<double>::quiet_NaN();

struct Problem {
  convert::ContactCase given;  ///< without the numbers that follow
  Units units;
  std::map<int, int> flags;  ///< as set, and not part of `given`
  double penetration = 0.0, normal_force = 0.0;
  std::array<double, 3> creepage{};    ///< CKSI, CETA, CPHI; in a shift mm and rad
  std::array<double, 2> tangential{};  ///< FX, FY over FSTAT FN
  PatchSlips extra_slip;
  double time_step = 0.0;
  std::array<std::string, 2> profile_text;  ///< of rail and wheel where given by values
  std::map<int, Block> blocks;

  Solver solver;
  std::vector<Patch> patches;  ///< empty: not solved
  int cases = 0;
  double cpu = 0.0, wall = 0.0;  ///< s
  Eigen::Matrix4d sensitivities = Eigen::Matrix4d::Zero();

  Problem();
  /// The case with all numbers.
  convert::ContactCase whole() const;
};

/// Number icp of a solved problem of module 1, or all. Throws Refusal.
std::vector<Patch*> patches_of(Problem& problem, int icp);

/// A field by rows of CONTACT's elements, in the client's units and signs. Throws Refusal for an
/// unknown code and for a field that is not known in this case.
std::vector<double> field_values(int code, const Problem& problem, const Patch& patch);

/// Solves; returns how many elements at the border of the potential contact area are in contact.
int calculate(Problem& problem);

}  // namespace rollfem::addon
