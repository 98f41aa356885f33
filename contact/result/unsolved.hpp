// SPDX-License-Identifier: LGPL-2.1-or-later
// Load points that have no solution beside others that do. They keep their place among the results,
// so that load points are numbered as in the case: empty in all files, without fields.
#pragma once

#include "contact/base/errors.hpp"
#include "contact/result/result.hpp"

#include <string>
#include <utility>

namespace rollfem::contact {

/// The load point with its motion alone; all other numbers become NaN, which Quantity::value takes
/// for absent.
void leave_empty(PointResult& point);

bool is_solved(const PointResult& point);

/// The load points of a run that have a solution, and why the others have none. Whoever needs all
/// takes it for any other failure.
class PartlySolved : public SolveError {
 public:
  PartlySolved(const std::string& why, ModelResult solved)
      : SolveError(why), result(std::move(solved)) {}
  ModelResult result;
};

}  // namespace rollfem::contact
