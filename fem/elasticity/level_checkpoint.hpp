// SPDX-License-Identifier: LGPL-2.1-or-later
// Data stored by a level of the finite-element model for a later run: the frictionless solution,
// and every load point with the state from which the next one starts, so that numbers are bitwise
// the same.
#pragma once

#include "contact/base/checkpoint.hpp"
#include "contact/result/result.hpp"
#include "contact/solve/contact_problem.hpp"

#include <string>
#include <vector>

namespace rollfem::fem {

/// The frictionless solution and the result's data of the level as a whole.
struct LevelStart {
  contact::Response defect;
  int contact_elements = 0;
  long unknowns = 0;
  std::string solver;  ///< LinearSolver::description
  double reach = 0.0;  ///< mm, from the patch to the nearer clamped boundary
  bool half = false;   ///< half of each body is modelled
  std::string notes;   ///< on the meshes
  /// For ModelResult::bodies.
  std::vector<contact::BodyField> bodies;
};

/// Used by the first process, which solves the contact problem.
class LevelCheckpoint {
 public:
  /// `store` may be null: no checkpoint.
  LevelCheckpoint(contact::Checkpoint* store, double cell_size);

  /// False when nothing is stored; the argument is then unchanged.
  bool find(LevelStart& start) const;
  void keep(const LevelStart& start) const;
  /// Load point k, counted from 0, and the state from which the next one starts.
  bool find(std::size_t k, contact::PointResult& point, contact::ContactState& state) const;
  void keep(std::size_t k, const contact::PointResult& point,
            const contact::ContactState& state) const;

 private:
  /// Empty if not stored.
  std::string kept(const std::string& part) const;
  std::string name_of(const std::string& part) const;

  contact::Checkpoint* store_;
  double cell_size_;
};

}  // namespace rollfem::fem
