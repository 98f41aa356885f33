// SPDX-License-Identifier: LGPL-2.1-or-later
// What a level of the finite-element model stores for a later run: the
// frictionless solution, and every load point with the state from which the next
// one starts, so that numbers are bitwise the same.
#pragma once

#include "contact/base/checkpoint.hpp"
#include "contact/result/result.hpp"
#include "contact/solve/contact_problem.hpp"

#include <string>
#include <vector>

namespace rollfem::fem {

/// The frictionless solution and what the result says about the level as a whole.
struct LevelStart {
  contact::Response defect;
  int contact_elements = 0;
  long unknowns = 0;
  std::string solver;  ///< LinearSolver::description
  double reach = 0.0;  ///< mm, from the patch to where the nearer body is held
  bool half = false;   ///< half of each body is modelled
  std::string notes;   ///< on the meshes
  /// For ModelResult::bodies.
  std::vector<contact::BodyField> bodies;
};

/// Of the first process, which solves the contact problem.
class LevelCheckpoint {
 public:
  /// `store` may be null: no checkpoint.
  LevelCheckpoint(contact::Checkpoint* store, double cell_size);

  /// False when nothing is kept; then the argument is as it was.
  bool find(LevelStart& start) const;
  void keep(const LevelStart& start) const;
  /// Load point k, counted from 0, and the state from which the next one begins.
  bool find(std::size_t k, contact::PointResult& point, contact::ContactState& state) const;
  void keep(std::size_t k, const contact::PointResult& point,
            const contact::ContactState& state) const;

 private:
  /// Empty when there is none.
  std::string kept(const std::string& part) const;
  std::string name_of(const std::string& part) const;

  contact::Checkpoint* store_;
  double cell_size_;
};

}  // namespace rollfem::fem
