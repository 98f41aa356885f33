// SPDX-License-Identifier: LGPL-2.1-or-later
// A solved load point with the state from which the next one starts, for checkpoints.
#pragma once

#include "contact/result/record.hpp"
#include "contact/result/result.hpp"
#include "contact/solve/contact_problem.hpp"

#include <string>

namespace rollfem::contact {

inline void exchange(Record& record, ContactState& state) {
  NormalSolution& n = state.normal;
  record.values(n.pressure, n.gap, n.approach, n.normal_force, n.contact_elements, n.iterations,
                n.residual);
  TangentialSolution& t = state.tangential;
  record.values(t.traction, t.slip, t.bound, t.state, t.coefficient, t.plastic, t.newton_steps,
                t.krylov_iterations, t.residual, t.steepness, t.states);
  record.values(state.displacement, state.defect, state.iterations, state.residual);
}

inline std::string point_record(PointResult point, ContactState state) {
  Record record;
  record.value(point);
  exchange(record, state);
  return record.bytes();
}

inline void read_point(const std::string& bytes, PointResult& point, ContactState& state) {
  Record record(bytes);
  record.value(point);
  exchange(record, state);
}

}  // namespace rollfem::contact
