// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/plasticity/steady_pass.hpp"

#include "base/errors.hpp"
#include "base/threads.hpp"

#include <deal.II/base/mpi.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace rollfem::fem {

namespace {

/// A displacement of this process and the load that causes it, so that energies need no stiffness.
Eigen::VectorXd stacked(const Vector& displacement, const Vector& load) {
  const auto n = static_cast<Eigen::Index>(load.locally_owned_size());
  Eigen::VectorXd both(2 * n);
  both << Eigen::Map<const Eigen::VectorXd>(displacement.begin(), n),
      Eigen::Map<const Eigen::VectorXd>(load.begin(), n);
  return both;
}

void unstack(const Eigen::VectorXd& both, Vector& displacement, Vector& load) {
  const Eigen::Index n = both.size() / 2;
  std::copy_n(both.data(), n, displacement.begin());
  std::copy_n(both.data() + n, n, load.begin());
  displacement.update_ghost_values();
}

/// Near the limit of shakedown old steps, from points that yield no longer, hold the iteration up
/// for hundreds of steps: without progress it begins anew.
class Patience {
 public:
  bool ends_with(double residual) {
    constexpr int most = 5;
    ++without_progress_;
    if (residual >= smallest_ && without_progress_ < most) return false;
    const bool in_vain = residual >= smallest_;
    smallest_ = residual;
    without_progress_ = 0;
    return in_vain;
  }

 private:
  double smallest_ = std::numeric_limits<double>::infinity();
  int without_progress_ = 0;
};

/// Follows every path through the total strain: streamlines from their inflow, or the single points
/// of a pressed body from the step before.
class Flow {
 public:
  Flow(const Streamlines& streamlines, const PlasticLaw& law, const std::vector<Deviator>& elastic,
       const std::vector<double>& hot, const YieldedBody& before, int steps)
      : streamlines_(streamlines),
        law_(law),
        elastic_(elastic),
        hot_(hot),
        entering_(before.leaving),
        from_(before.strain),
        steps_(steps),
        stations_(before.pressed() ? 1 : streamlines.stations()) {
    plastic.resize(streamlines.points());
    accumulated.resize(streamlines.points());
    leaving.resize(entering_.size());
    work_.resize(entering_.size());
    utilisation_.resize(entering_.size());
    if (before.pressed()) untouched_.resize(streamlines.streams());
  }

  /// Through the elastic strain and that of `displacement`; returns the load of plastic strain.
  void follow(const Vector& displacement, Vector& load) {
    strain = streamlines_.strains(displacement);
    const bool pressed = !from_.empty();
    contact::for_each_index(entering_.size(), [&](std::size_t path) {
      PlasticState state = entering_[path];
      double& work = work_[path] = 0.0;
      double& most = utilisation_[path] = 0.0;
      Deviator before = pressed ? from_[path] : Deviator{};
      std::array<double, 2> hot{};  // before and at the point
      for (std::size_t i = 0; i < stations_; ++i) {
        const std::size_t k = path * stations_ + i;
        const Deviator& total = strain[k] = sum(elastic_[k], 1.0, strain[k]);
        const Deviator strain_before = state.strain;
        if (!hot_.empty()) hot = {hot[1], hot_[k]};
        law_.advance(state, before, total, i == 0 && !pressed ? 1 : steps_, hot);
        before = total;
        work += streamlines_.volume(k) *
                product(law_.stress(state, total), sum(state.strain, -1.0, strain_before));
        most = std::max(most, law_.utilisation(state, total, hot[1]));
        plastic[k] = state.strain;
        accumulated[k] = state.accumulated;
      }
      leaving[path] = state;
    });
    streamlines_.load(plastic, pressed ? untouched_ : entering_, pressed ? untouched_ : leaving,
                      load);
  }

  /// In what was followed last, see PassReport.
  double plastic_work() const {
    const double sum = std::accumulate(work_.begin(), work_.end(), 0.0);
    return from_.empty() ? sum / (streamlines_.s(0) - streamlines_.s(2)) * 2.0 : sum;
  }

  double utilisation() const { return *std::max_element(utilisation_.begin(), utilisation_.end()); }

  std::vector<PlasticState> leaving;
  std::vector<Deviator> plastic, strain;
  std::vector<double> accumulated;

 private:
  const Streamlines& streamlines_;
  const PlasticLaw& law_;
  const std::vector<Deviator>& elastic_;
  const std::vector<double>& hot_;
  const std::vector<PlasticState>& entering_;
  const std::vector<Deviator>& from_;  ///< empty: the load rolls
  int steps_;
  std::size_t stations_;                 ///< of a path
  std::vector<PlasticState> untouched_;  ///< beyond the points of a pressed body
  std::vector<double> work_, utilisation_;
};

constexpr int depth = 10;  ///< of Anderson's method

/// The displacement by plastic strain: exact, or fast by PassSolver::in_part, which then lacks only
/// the difference from the last exact one.
class PlasticResponse {
 public:
  PlasticResponse(const PassSolver& solver, const YieldedBody& start)
      : solver_(solver), correction_(start.displacement) {
    if (solver.in_part == nullptr) return;
    Vector rough = correction_;
    solver.in_part->solve(rough, start.load);
    correction_ -= rough;
  }
  void solve(const Vector& load, Vector& displacement) const {
    if (solver_.in_part == nullptr) return solver_.exact.solve(displacement, load);
    solver_.in_part->solve(displacement, load);
    displacement += correction_;
  }
  /// Replaces what solve() found for the same load. False: it was exact.
  bool solve_exactly(const Vector& load, Vector& displacement) {
    if (solver_.in_part == nullptr) return false;
    correction_ -= displacement;
    solver_.exact.solve(displacement, load);
    correction_ += displacement;
    return true;
  }

 private:
  const PassSolver& solver_;
  Vector correction_;
};

}  // namespace

YieldedBody before_first_pass(const Streamlines& streamlines, const Body& body) {
  YieldedBody untouched;
  untouched.leaving.resize(streamlines.streams());
  untouched.plastic.resize(streamlines.points());
  untouched.accumulated.resize(streamlines.points());
  untouched.displacement = make_vector(body.dofs());
  untouched.displacement.update_ghost_values();
  untouched.load = make_vector(body.dofs());
  return untouched;
}

YieldedBody before_first_step(const Streamlines& streamlines, const Body& body,
                              std::vector<Deviator> strain) {
  YieldedBody untouched = before_first_pass(streamlines, body);
  untouched.leaving.resize(streamlines.points());
  untouched.strain = std::move(strain);
  return untouched;
}

PassSolver::PassSolver(const Streamlines& streamlines, const LinearSolver& solver)
    : exact(solver),
      in_part(solver.in_part(streamlines.unknowns())),
      energy([communicator = streamlines.communicator()](const Eigen::VectorXd& a,
                                                         const Eigen::VectorXd& b) {
        const Eigen::Index n = a.size() / 2;
        return dealii::Utilities::MPI::sum(a.head(n).dot(b.tail(n)), communicator);
      }),
      steps(depth, energy) {}

PassReport steady_pass(const Streamlines& streamlines, const PlasticLaw& law, PassSolver& solver,
                       const std::vector<Deviator>& elastic, const PassAccuracy& accuracy,
                       YieldedBody& yielded, const std::vector<double>& hot) {
  Flow flow(streamlines, law, elastic, hot, yielded, accuracy.steps);
  PlasticResponse response(solver, yielded);
  Patience patience;
  PassReport report;
  Vector displacement = yielded.displacement, load = yielded.load;
  displacement.update_ghost_values();
  Eigen::VectorXd tried = stacked(displacement, load), result;
  double all = 0.0, change = 0.0;
  const auto compare = [&] {
    result = stacked(displacement, load);
    const Eigen::VectorXd residual = result - tried;
    // That of rounding may be negative.
    all = solver.energy(result, result);
    change = std::max(0.0, solver.energy(residual, residual));
    report.residual = all == 0.0 ? 0.0 : std::sqrt(change / all);
    return all == 0.0 || (report.residual <= accuracy.residual && report.iterations > 1);
  };
  if (!accuracy.once) solver.steps.interrupt();
  for (report.iterations = 1;; ++report.iterations) {
    flow.follow(displacement, load);
    response.solve(load, displacement);
    if (compare()) {
      if (!accuracy.whole_body || !response.solve_exactly(load, displacement) || compare()) break;
      solver.steps.interrupt();
    }
    if (report.iterations == accuracy.most_iterations || !std::isfinite(report.residual))
      throw contact::SolveError(fmt::format(
          "plastic flow did not settle in {} iterations: out-of-balance forces are {:.2g} of those "
          "of plastic strain, allowed: {:.2g}; steel that does not harden bears no shear traction "
          "above its yield stress in shear ({:.4g} MPa) and no pressure above some six times that; "
          "do: give a smaller load or friction, hardening, or a smaller [fem] cell_size",
          report.iterations, report.residual, accuracy.residual,
          law.parameters().shear_yield_stress()));
    if (patience.ends_with(change)) solver.steps.restart();
    tried = solver.steps.next(tried, result);
    unstack(tried, displacement, load);
    if (accuracy.once) break;
  }
  yielded.displacement = displacement;
  yielded.displacement.update_ghost_values();
  yielded.load = load;
  report.plastic_work = flow.plastic_work();
  report.utilisation = flow.utilisation();
  if (yielded.pressed()) yielded.strain = std::move(flow.strain);
  yielded.leaving = std::move(flow.leaving);
  yielded.plastic = std::move(flow.plastic);
  yielded.accumulated = std::move(flow.accumulated);
  return report;
}

}  // namespace rollfem::fem
