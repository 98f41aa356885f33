// SPDX-License-Identifier: LGPL-2.1-or-later
// The contacts of a wheel that share its load, of like half-spaces on grids of few elements, in a
// few milliseconds and in memory that is kept: what rollfem.h solves nearly always.
#pragma once

#include "capi/quick_patch.hpp"
#include "contact/iteration/bound_constrained_cg.hpp"

#include <array>
#include <memory>
#include <vector>

namespace rollfem::capi {

/// What presses the wheel on the rail.
struct QuickLoad {
  double force = 0.0;  ///< N, vertical, friction included
  contact::Friction friction;
};

enum class QuickOutcome {
  solved,
  unfit,      ///< for the solvers of the model halfspace, which say why if they fail as well
  conformal,  ///< a patch reaches where another contact begins
};

class QuickWheel {
 public:
  static constexpr std::size_t most_patches = 4;
  /// A grid with more across the patch is better solved by transforms.
  static constexpr int most_across = 20;
  /// Of a grid for any patch. Several regions in one plane share their grid, and like conformal
  /// patches they need more elements across than one region in a plane.
  static constexpr int across_any_patch = 36;

  /// `any`: not only for patches of one region in a plane.
  QuickWheel(const halfspace::InfluenceTables& tables, bool any,
             const contact::CombinedMaterial& material);

  /// Checked as every result is, kept until the next call.
  QuickOutcome solve(const std::vector<QuickContact>& contacts, const QuickLoad& load);
  /// Those under pressure, in the order of the contacts.
  const std::vector<QuickPatch*>& patches() const { return loaded_; }

 private:
  /// The problem of a number of patches: fields of the same size each time.
  struct Joint {
    contact::BoundConstrainedCg solver;
    contact::Field distance;
  };

  enum class Sharing { done, outgrows, fails };

  QuickOutcome solve_or_throw(const std::vector<QuickContact>& contacts, const QuickLoad& load);
  bool find_patches(double force);
  bool adjust_boxes();
  bool take_reached();
  void drop_unloaded();
  void set_problem();
  void press(double force, double tolerance, bool anew);
  Sharing share_load(const QuickLoad& load, double& share);
  void grow_boxes(double factor);
  template <class Good>
  bool every(Good&& good) const;
  bool rub(const QuickLoad& load, int turn);
  void check(const QuickLoad& load);

  bool any_;
  contact::CombinedMaterial material_;
  std::vector<std::unique_ptr<QuickPatch>> all_;
  std::vector<QuickPatch*> loaded_, reserve_;
  std::vector<GridBox> boxes_;  ///< of the loaded ones
  std::vector<halfspace::NormalBlock> blocks_;
  halfspace::FewElementsNormal normal_;
  std::array<Joint, most_patches> joints_;
  Joint* joint_ = nullptr;
};

}  // namespace rollfem::capi
