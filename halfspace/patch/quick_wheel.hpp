// SPDX-License-Identifier: LGPL-2.1-or-later
// The contacts of a wheel that share its load, by half-spaces of like material on coarse grids, in
// a few milliseconds and reused memory: one normal problem, as in load_sharing.hpp, and friction in
// turn.
#pragma once

#include "contact/iteration/bound_constrained_cg.hpp"
#include "halfspace/patch/quick_patch.hpp"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace rollfem::halfspace {

/// Load and friction of the wheel.
struct QuickLoad {
  double force = 0.0;  ///< N, vertical, friction included; ignored if a sinking is given
  /// Vertical, below first touch, mm; positive.
  std::optional<double> sinking;
  contact::Friction friction;
  std::optional<contact::SurfaceHeat> heat{};  ///< empty: no temperatures
};

enum class QuickOutcome {
  solved,
  unfit,  ///< left to the solvers of the model halfspace, which report the reason if they fail too
  conformal,  ///< a patch reaches into another contact
};

/// Derivatives of the resultants of a patch.
struct PatchResponse {
  SumsByCreepage by_creepage = SumsByCreepage::Zero();  ///< at the same pressure
  PatchSums by_sinking = PatchSums::Zero();             ///< per mm, at the same place and creepages
};

class QuickWheel {
 public:
  static constexpr std::size_t most_patches = 4;
  /// With more elements across the patch, Fourier transforms are faster.
  static constexpr int most_across = 20;
  /// Elements across of a grid for any patch. Several regions in one plane share a grid; they and
  /// conformal patches need more elements across than a single plane region.
  static constexpr int across_any_patch = 36;

  /// `any`: accepts patches other than a single plane region.
  QuickWheel(const InfluenceTables& tables, bool any, const contact::CombinedMaterial& material);

  /// Solves for the load. The result passes the checks of all results and is valid until the next
  /// call.
  QuickOutcome solve(const std::vector<QuickContact>& contacts, const QuickLoad& load);
  /// The loaded patches, in the order of the contacts.
  const std::vector<QuickPatch*>& patches() const { return loaded_; }
  /// Vertical, below first touch, mm.
  double sinking() const { return joint_->solver.approach(); }
  /// Derivatives for each patch, in the order of patches(), at the solution, which is then lost.
  /// False if that fails.
  bool respond(const QuickLoad& load, std::vector<PatchResponse>& responses);

 private:
  /// The joint problem of several patches, with fields of constant size.
  struct Joint {
    contact::BoundConstrainedCg solver;
    contact::Field distance;
  };

  bool find_patches(double force);
  bool adjust_boxes();
  bool take_reached();
  /// Offset of the k-th patch in the fields of the joint problem: all grids have one size.
  Eigen::Index place_of(std::size_t k) const {
    return static_cast<Eigen::Index>(k) * loaded_.front()->grid().size();
  }
  void set_problem();
  void set_distances();
  void solve_normal(double force, double tolerance, bool anew);
  bool sums_at(double sinking, const QuickLoad& load, std::vector<PatchSums>& sums);
  bool lay_on_patches();
  void solve_in_turn(const QuickLoad& load, double share, int turn);
  void share_load(const QuickLoad& load, double& share);
  bool reach_only(bool (contact::PatchGeometry::*good)(double) const, double elements) const;
  bool stays_on_grids() const;
  void feel_neighbours(const QuickLoad& load);
  bool solve_friction(const QuickLoad& load, int turn);
  void check(const QuickLoad& load);

  bool any_;
  contact::CombinedMaterial material_;
  std::vector<std::unique_ptr<QuickPatch>> all_;
  std::vector<QuickPatch*> loaded_, reserve_;
  std::optional<double> given_sinking_;
  std::vector<PatchSums> below_, above_;
  std::vector<NormalBlock> blocks_;
  FewElementsNormal normal_;
  std::array<Joint, most_patches> joints_;
  Joint* joint_ = nullptr;
};

}  // namespace rollfem::halfspace
