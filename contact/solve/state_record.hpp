// SPDX-License-Identifier: LGPL-2.1-or-later
// A solved load point with the state from which the next one starts, for checkpoints.
#pragma once

#include "base/checkpoint.hpp"
#include "contact/solve/contact_problem.hpp"
#include "result/record.hpp"
#include "result/result.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>

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

/// Whether the fields are there that every solved load point has: results show them, and the next
/// load point starts from them.
inline bool is_whole(const PointResult& point, const ContactState& state, const ContactGrid& grid) {
  const auto full = [&](const auto&... fields) {
    return ((static_cast<int>(fields.size()) == grid.size()) && ...);
  };
  const ContactFields& f = point.fields;
  const TangentialSolution& t = state.tangential;
  const SurfaceField& u = state.displacement;
  return full(state.normal.pressure, u.x, u.y, u.n, t.traction.x, t.slip.x, t.bound, t.state) &&
         full(f.traction.x, f.traction.y, f.traction.n, f.slip.x, f.traction_bound, f.state) &&
         full(f.displacement.x, f.displacement.y, f.displacement.n);
}

/// The load points of one grid in a checkpoint, each with the state from which the next one starts.
class PointStore {
 public:
  /// `prefix`: of the names of its records. Not `usable`: earlier ones are not found.
  PointStore(Checkpoint& checkpoint, std::string prefix, bool usable = true)
      : checkpoint_(checkpoint), prefix_(std::move(prefix)), usable_(usable) {}
  /// Load point k, counted from 0, with the memory of its elasticity.
  bool find(std::size_t k, const ContactGrid& grid, PointResult& point, ContactState& state,
            std::string& memory) {
    if (!usable_) return false;
    PointResult stored;
    ContactState its_state;
    const auto read = [&](Record& record) {
      record.values(stored, its_state, memory);
      record.demand(is_whole(stored, its_state, grid));
    };
    if (!found(checkpoint_, name(k), read, grid.size())) return false;
    point = std::move(stored);
    state = std::move(its_state);
    return true;
  }
  void keep(std::size_t k, const PointResult& point, const ContactState& state,
            const std::string& memory) {
    checkpoint_.keep(name(k), record_of(point, state, memory));
  }

 private:
  std::string name(std::size_t k) const { return fmt::format("{}-{:04}", prefix_, k + 1); }

  Checkpoint& checkpoint_;
  std::string prefix_;
  bool usable_;
};

}  // namespace rollfem::contact
