// The state from which the next load point starts, for checkpoints.
#pragma once

#include "contact/result/record.hpp"
#include "contact/solve/contact_problem.hpp"

namespace rollfem::contact {

inline void exchange(Record& record, ContactState& state) {
  NormalSolution& n = state.normal;
  record.values(n.pressure, n.gap, n.approach, n.normal_force, n.contact_elements, n.iterations,
                n.residual);
  TangentialSolution& t = state.tangential;
  record.values(t.traction, t.slip, t.state, t.newton_steps, t.krylov_iterations, t.residual);
  record.values(state.displacement, state.defect, state.iterations, state.residual);
}

}  // namespace rollfem::contact
