// SPDX-License-Identifier: LGPL-2.1-or-later
// The driver of every model that solves the contact problem: one resolution of a scene, all its
// load points, on any elasticity. Load points and histories, prescribed forces, the leading edge,
// the sharing of the load with friction, progress and checkpoints are implemented here only.
#pragma once

#include "base/progress.hpp"
#include "contact/solve/contact_problem.hpp"
#include "contact/solve/point_motion.hpp"
#include "contact/solve/prescribed_force.hpp"
#include "result/patch_size.hpp"
#include "result/result.hpp"

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rollfem::contact {

/// The elasticity at one resolution, and a model's additions to the contact problem.
class Elasticity {
 public:
  virtual ~Elasticity() = default;
  /// Half-spaces, like or unlike, are cheap: the pressure without friction is found before every
  /// load point and locates the leading edge.
  virtual bool is_halfspace() const { return false; }
  /// Expensive preparation (meshes and solvers) before the members below are called. Skipped by a
  /// run that restores all its load points.
  virtual void prepare() {}
  virtual const Compliance& compliance() const = 0;
  /// The half-space without coupling on the same grid, which preconditions it; the same object for
  /// half-spaces of like materials.
  virtual const SolvableCompliance& halfspace() const = 0;
  /// The half-space with the coupling of unlike materials; null: like materials.
  virtual const Compliance* coupled_halfspace() const { return nullptr; }
  /// Distance (mm) and slip caused by this elasticity without contact loads, as by the spinning of
  /// a wheel; may be empty.
  virtual Field extra_distance() const { return {}; }
  virtual TangentialField extra_slip() const { return {}; }
  /// Approximate -dF/d(creepage) of steady rolling (N) and -dF/d(shift) (N/mm) without slip.
  virtual Eigen::Vector2d rolling_stiffness(const PatchSize& patch) const = 0;
  virtual Eigen::Vector2d shift_stiffness(const PatchSize& patch) const = 0;
  /// Throws when the bodies are not known at the patch.
  virtual void check_patch(const PatchSize&) const {}
  /// Adds model-specific results to a solved load point: stresses, errors.
  virtual void complete(std::size_t, PointResult&) {}
  /// Data of the completed load point, besides its state, that the next one needs: for checkpoints.
  virtual std::string memory() const { return {}; }
  /// Continues from the memory stored by an earlier run; may be called before prepare().
  virtual void restore(const std::string& /*memory*/) {}
};

/// State that a finer level takes over from a coarser one besides its results: p_t over g at rest,
/// between -1 and 1.
struct LevelResult {
  ContactGrid grid;
  Field pressure;            ///< without friction, MPa; of the last load point
  int contact_elements = 0;  ///< of the last load point
  std::vector<TangentialField> relative_traction;  ///< per load point; empty in a history
  std::vector<PointResult> points;
  FrictionPast after;  ///< the last step of a history, where friction remembers
  HeatStep heat;       ///< the same, where bodies have heat
  double setup_seconds = 0.0;
  double normal_seconds = 0.0;
  double tangential_seconds = 0.0;
  double steepness = 0.0;  ///< gain of the friction law, the largest of all load points
  /// Maxima over all solutions, including those of force searches and outer iterations.
  int newton_steps = 0, krylov_iterations = 0, iterations = 0;
  int several = 0;  ///< load points with more than one state (ContactProblem::count_states)
  /// Why load points are empty (result/quantities.hpp), by their number from 0.
  std::map<std::size_t, std::string> unsolved;
};

/// Warns of a law that falls, or a layer that softens, so steeply that several states are possible.
void warn_of_steep_friction(const LevelResult& level, const Friction& friction,
                            std::vector<Note>& notes);

struct RunOptions {
  std::string model;         ///< in progress events
  std::string stage_prefix;  ///< before the stage names of progress events
  ContactAccuracy accuracy;
  ContactAccuracy force_accuracy;  ///< for a prescribed force
  double force_tolerance = 1e-6;   ///< on that force, relative to mu F_z
  const LevelResult* coarser = nullptr;
  /// Steady load points do not start from each other: they may be solved in any order, and in
  /// parallel (contact/solve/side_by_side.hpp).
  bool independent = false;
  /// Most load points solved in parallel; on half-spaces memory is the limit instead.
  std::size_t most_beside = 1;
  /// Skips load points without a stable state, unless the next one starts from them.
  bool leaves_unsolved = false;
  Response first_defect;  ///< from an earlier run without friction; empty: to be computed
  std::optional<History> inherited;  ///< on this grid, for Scene::past
};

using MakeElasticity = std::function<std::unique_ptr<Elasticity>()>;

class PointStore;  // contact/solve/state_record.hpp

class ContactRun {
 public:
  /// All arguments must outlive this object; `store` (may be null): storage of load points.
  ContactRun(const Scene& scene, const ChartedGeometry& geometry, RunOptions options,
             const Progress& progress, PointStore* store);

  /// Solves every load point on the grid. Returns false when a patch reaches the border of the
  /// grid. Throws SolveError, InputError.
  bool solve(const ContactGrid& grid, const MakeElasticity& make);

  // The same in two steps.

  /// Prepares what independent load points share: the elasticity, on half-spaces also the pressure
  /// of the first load point.
  bool begin(const ContactGrid& grid, const MakeElasticity& make);
  /// On half-spaces, copies of a run that has begun solve load points in parallel.
  bool copies_can_solve() const { return elasticity_->is_halfspace(); }
  /// Solves the load points that `next` hands out in order until there is none.
  bool solve_each(const std::function<std::optional<std::size_t>()>& next);

  /// The frictionless solution alone, for on_first_defect.
  void solve_without_friction(const ContactGrid& grid, const MakeElasticity& make);

  /// The defect of the frictionless solution, once known: for first_defect of a later run.
  std::function<void(const Response&, int contact_elements)> on_first_defect;

  LevelResult take_result() { return std::move(result_); }

 private:
  void tell(ProgressEvent event, const char* stage, bool finished) const;
  void prepare();
  bool restore(std::size_t k);
  void find_first_defect();
  bool press(std::size_t k);
  bool solve_or_restore(std::size_t k, bool& restoring);
  void warn_if_steep() const;
  void solve_point(std::size_t k);
  bool leave_unsolved(std::size_t k, const NoSteadyFriction& error);
  ContactState start_for(std::size_t k);
  OuterCallback each_iteration(std::size_t k);
  void solve_given(std::size_t k, const Eigen::Vector2d& unknowns);
  ForceSearch search_for(std::size_t k);
  Eigen::Vector2d find_force(std::size_t k);
  PointResult point_result(std::size_t k, const Eigen::Vector2d& unknowns);
  void add_energies(TangentialField rigid_slip, PointResult& point) const;
  void remember(std::size_t k);
  ProgressEvent event_of(std::size_t k) const;

  const Scene& scene_;
  const ChartedGeometry& geometry_;
  RunOptions options_;
  const Progress& progress_;
  PointStore* store_;
  Friction friction_;  ///< null: none
  PatchShape shape_;
  std::shared_ptr<Elasticity> elasticity_;
  std::optional<ContactProblem> problem_;
  std::optional<PointMotion> motion_;
  ContactState state_;  ///< of the last load point
  LevelResult result_;
};

}  // namespace rollfem::contact
