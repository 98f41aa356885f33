// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/plasticity/steady_pass.hpp"

#include "contact/base/errors.hpp"
#include "contact/base/threads.hpp"

#include <Eigen/QR>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

namespace rollfem::fem {

namespace {

/// A displacement with the load that causes it, so that energies need no stiffness.
struct Loaded {
  Vector displacement, load;
};

double energy(const Loaded& a, const Loaded& b) {
  return a.displacement * b.load;
}

Loaded difference(const Loaded& a, const Loaded& b) {
  Loaded d = a;
  d.displacement -= b.displacement;
  d.load -= b.load;
  return d;
}

/// Anderson's acceleration of a fixed point (D. G. Anderson 1965, J. ACM 12) in the energy norm:
/// the combination of the last results whose residuals cancel best.
class Anderson {
 public:
  /// The next displacement to try, from the last one and the result that followed from it.
  Loaded next(const Loaded& tried, const Loaded& result) {
    const Loaded residual = difference(result, tried);
    if (last_result_) {
      residual_steps_.push_back(difference(residual, *last_residual_));
      result_steps_.push_back(difference(result, *last_result_));
      if (residual_steps_.size() > depth) {
        residual_steps_.pop_front();
        result_steps_.pop_front();
        products_ = products_.bottomRightCorner(depth - 1, depth - 1).eval();
      }
      add_products_of_last();
    }
    last_residual_ = residual;
    last_result_ = result;
    forget_what_no_longer_helps(energy(residual, residual));
    const auto n = static_cast<Eigen::Index>(residual_steps_.size());
    Loaded combined = result;
    if (n == 0) return combined;
    Eigen::VectorXd right(n);
    for (Eigen::Index i = 0; i < n; ++i) right[i] = energy(residual, residual_steps_[i]);
    const Eigen::VectorXd scale = products_.diagonal().cwiseSqrt().cwiseInverse();
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors(scale.asDiagonal() * products_ *
                                                        scale.asDiagonal());
    factors.setThreshold(1e-10);
    const Eigen::VectorXd share =
        scale.cwiseProduct(factors.solve(scale.cwiseProduct(right)).eval());
    for (Eigen::Index i = 0; i < n; ++i) {
      combined.displacement.add(-share[i], result_steps_[i].displacement);
      combined.load.add(-share[i], result_steps_[i].load);
    }
    return combined;
  }

 private:
  static constexpr std::size_t depth = 10;

  void add_products_of_last() {
    const auto n = static_cast<Eigen::Index>(residual_steps_.size());
    products_.conservativeResize(n, n);
    for (Eigen::Index j = 0; j < n; ++j)
      products_(n - 1, j) = products_(j, n - 1) =
          energy(residual_steps_.back(), residual_steps_[j]);
  }

  /// Near the limit of shakedown old steps, from points that yield no longer, hold the iteration up
  /// for hundreds of steps: without progress it begins anew.
  void forget_what_no_longer_helps(double size) {
    constexpr int patience = 5;
    ++without_progress_;
    if (size >= smallest_ && without_progress_ < patience) return;
    if (size >= smallest_) {
      residual_steps_.clear();
      result_steps_.clear();
      products_.resize(0, 0);
    }
    smallest_ = size;
    without_progress_ = 0;
  }

  std::deque<Loaded> residual_steps_, result_steps_;
  Eigen::MatrixXd products_;  ///< energies of residual_steps_ with each other
  std::optional<Loaded> last_residual_, last_result_;
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
  Anderson anderson;
  PassReport report;
  Loaded tried;
  tried.displacement = yielded.displacement;
  tried.displacement.update_ghost_values();
  tried.load = yielded.load;
  for (report.iterations = 1;; ++report.iterations) {
    Loaded result = tried;
    flow.follow(tried.displacement, result.load);
    solver.solve(result.displacement, result.load);
    const Loaded residual = difference(result, tried);
    const double all = energy(result, result);
    // That of rounding may be negative.
    report.residual = all == 0.0 ? 0.0 : std::sqrt(std::max(0.0, energy(residual, residual)) / all);
    if (report.residual <= accuracy.residual && report.iterations > 1) {
      yielded.displacement = result.displacement;
      yielded.displacement.update_ghost_values();
      yielded.load = result.load;
      break;
    }
    if (all == 0.0) break;
    if (report.iterations == accuracy.most_iterations || !std::isfinite(report.residual))
      throw contact::SolveError(fmt::format(
          "plastic flow did not settle in {} iterations: out-of-balance forces are {:.2g} of those "
          "of plastic strain, allowed: {:.2g}; steel that does not harden bears no shear traction "
          "above its yield stress in shear ({:.4g} MPa) and no pressure above some six times that; "
          "do: give a smaller load or friction, hardening, or a smaller [fem] cell_size",
          report.iterations, report.residual, accuracy.residual,
          law.parameters().shear_yield_stress()));
    tried = anderson.next(tried, result);
    tried.displacement.update_ghost_values();
  }
  report.plastic_work = flow.plastic_work();
  report.utilisation = flow.utilisation();
  yielded.leaving = std::move(flow.leaving);
  yielded.plastic = std::move(flow.plastic);
  yielded.accumulated = std::move(flow.accumulated);
  return report;
}

}  // namespace rollfem::fem
