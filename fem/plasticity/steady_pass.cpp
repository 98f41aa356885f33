// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/plasticity/steady_pass.hpp"

#include "base/errors.hpp"
#include "base/threads.hpp"
#include "contact/iteration/anderson.hpp"

#include <deal.II/base/mpi.h>
#include <fmt/format.h>

#include <algorithm>
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

/// Follows every streamline from its inflow through the total strain.
class Flow {
 public:
  Flow(const Streamlines& streamlines, const PlasticLaw& law, const std::vector<Deviator>& elastic,
       const std::vector<PlasticState>& entering, int steps)
      : streamlines_(streamlines),
        law_(law),
        elastic_(elastic),
        entering_(entering),
        steps_(steps) {
    plastic.resize(streamlines.points());
    accumulated.resize(streamlines.points());
    leaving.resize(streamlines.streams());
    work_.resize(streamlines.streams());
    utilisation_.resize(streamlines.streams());
  }

  /// Through the elastic strain and that of `displacement`; returns the load of plastic strain.
  void follow(const Vector& displacement, Vector& load) {
    const std::vector<Deviator> added = streamlines_.strains(displacement);
    contact::for_each_index(streamlines_.streams(), [&](std::size_t stream) {
      PlasticState state = entering_[stream];
      double& work = work_[stream] = 0.0;
      double& most = utilisation_[stream] = 0.0;
      Deviator before{};
      for (std::size_t i = 0; i < streamlines_.stations(); ++i) {
        const std::size_t k = stream * streamlines_.stations() + i;
        const Deviator total = sum(elastic_[k], 1.0, added[k]);
        const Deviator strain_before = state.strain;
        law_.advance(state, before, total, i == 0 ? 1 : steps_);
        before = total;
        work += streamlines_.volume(k) *
                product(law_.stress(state, total), sum(state.strain, -1.0, strain_before));
        most = std::max(most, law_.utilisation(state, total));
        plastic[k] = state.strain;
        accumulated[k] = state.accumulated;
      }
      leaving[stream] = state;
    });
    streamlines_.load(plastic, entering_, leaving, load);
  }

  /// N mm per mm of track, in what was followed last.
  double plastic_work() const {
    return std::accumulate(work_.begin(), work_.end(), 0.0) /
           (streamlines_.s(0) - streamlines_.s(2)) * 2.0;
  }

  double utilisation() const { return *std::max_element(utilisation_.begin(), utilisation_.end()); }

  std::vector<PlasticState> leaving;
  std::vector<Deviator> plastic;
  std::vector<double> accumulated;

 private:
  const Streamlines& streamlines_;
  const PlasticLaw& law_;
  const std::vector<Deviator>& elastic_;
  const std::vector<PlasticState>& entering_;
  int steps_;
  std::vector<double> work_, utilisation_;
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

PassReport steady_pass(const Streamlines& streamlines, const PlasticLaw& law,
                       const LinearSolver& solver, const std::vector<Deviator>& elastic,
                       const PassAccuracy& accuracy, YieldedBody& yielded) {
  Flow flow(streamlines, law, elastic, yielded.leaving, accuracy.steps);
  const auto energy = [&](const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
    const Eigen::Index n = a.size() / 2;
    return dealii::Utilities::MPI::sum(a.head(n).dot(b.tail(n)),
                                       yielded.load.get_mpi_communicator());
  };
  constexpr int depth = 10;
  contact::Anderson anderson(depth, energy);
  Patience patience;
  PassReport report;
  Vector displacement = yielded.displacement, load = yielded.load;
  displacement.update_ghost_values();
  Eigen::VectorXd tried = stacked(displacement, load);
  for (report.iterations = 1;; ++report.iterations) {
    flow.follow(displacement, load);
    solver.solve(displacement, load);
    const Eigen::VectorXd result = stacked(displacement, load), residual = result - tried;
    // That of rounding may be negative.
    const double all = energy(result, result), change = std::max(0.0, energy(residual, residual));
    report.residual = all == 0.0 ? 0.0 : std::sqrt(change / all);
    if (all == 0.0 || (report.residual <= accuracy.residual && report.iterations > 1)) break;
    if (report.iterations == accuracy.most_iterations || !std::isfinite(report.residual))
      throw contact::SolveError(fmt::format(
          "plastic flow did not settle in {} iterations: out-of-balance forces are {:.2g} of those "
          "of plastic strain, allowed: {:.2g}; steel that does not harden bears no shear traction "
          "above its yield stress in shear ({:.4g} MPa) and no pressure above some six times that; "
          "do: give a smaller load or friction, hardening, or a smaller [fem] cell_size",
          report.iterations, report.residual, accuracy.residual,
          law.parameters().shear_yield_stress()));
    if (patience.ends_with(change)) anderson.restart();
    tried = anderson.next(tried, result);
    unstack(tried, displacement, load);
  }
  yielded.displacement = displacement;
  yielded.displacement.update_ghost_values();
  yielded.load = load;
  report.plastic_work = flow.plastic_work();
  report.utilisation = flow.utilisation();
  yielded.leaving = std::move(flow.leaving);
  yielded.plastic = std::move(flow.plastic);
  yielded.accumulated = std::move(flow.accumulated);
  return report;
}

}  // namespace rollfem::fem
