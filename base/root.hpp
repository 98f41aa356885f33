// SPDX-License-Identifier: LGPL-2.1-or-later
// Bracketed roots of functions of one variable.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace rollfem::contact {

/// Zero of `f` between `a` and `b`, where its values differ in sign or vanish: within `tolerance`
/// of the argument, or to machine precision if that is coarser. A jump of `f` across zero counts as
/// a zero. Throws SolveError beginning with `what` ("roll of the wheelset") when the signs are
/// equal or a value is not finite.
double bracketed_root(const std::function<double(double)>& f, double a, double b, double tolerance,
                      const char* what);

/// The same where the values at both ends are known and of opposite signs.
double root_between(const std::function<double(double)>& f, double a, double at_a, double b,
                    double at_b, double tolerance, const char* what);

/// Zero of `f` on the side of `next` from `start`, where its value is known: in steps that grow,
/// the first one to `next`, until the sign changes, then as bracketed_root. Empty when the sign has
/// not changed before the size of the argument exceeds `largest`.
std::optional<double> root_from(const std::function<double(double)>& f, double start,
                                double at_start, double next, double largest, double tolerance,
                                const char* what);

// The largest value of a smooth function of position near a good start, by a pattern search with
// shrinking steps. Positions are evaluated in batches.

/// A value and its position. Points outside the body have the value -infinity.
struct ValueAt {
  double value = 0.0;
  std::array<double, 3> place{};  ///< mm
};

/// Values at the given points, in their order; a point may be moved, for instance onto a surface.
using ValuesAt = std::function<std::vector<ValueAt>(const std::vector<std::array<double, 3>>&)>;

/// Local maximum uphill from `start`: tries the 26 points around the best one at distance `step`
/// (mm) and its diagonals, and halves the step when none is better, down to a hundredth of it.
ValueAt local_maximum(const ValuesAt& values, ValueAt start, double step);

}  // namespace rollfem::contact
