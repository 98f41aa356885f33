#include "halfspace/model/many.hpp"

#include "contact/base/errors.hpp"
#include "contact/base/pi.hpp"
#include "contact/base/threads.hpp"
#include "contact/solve/interpolation.hpp"
#include "contact/solve/leading_edge.hpp"
#include "contact/solve/tangential.hpp"
#include "halfspace/elasticity/compliance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <future>
#include <memory>
#include <string>
#include <utility>

namespace rollfem::halfspace {

using contact::ContactGrid;
using contact::Field;
using contact::TangentialField;
using contact::UpwindOrder;

namespace {

/// Elements kept free around the patch; the second-order difference looks two columns upstream.
constexpr int free_around = 2;

constexpr int coarsest = 10;  ///< elements across

/// Starts leave traces of this size in the forces.
constexpr double tolerance = 1e-11;

ContactGrid grid_of(const EllipseShape& shape, int across) {
  const double a = std::sqrt(shape.axis_ratio);
  return ContactGrid::centred(across + 2 * free_around, across + 2 * free_around, 2.0 * a / across,
                              2.0 / (a * across));
}

/// Hertz's pressure with a b = 1 under F_n = 1.
Field hertz_pressure(const EllipseShape& shape, const ContactGrid& grid) {
  const double b2 = 1.0 / shape.axis_ratio;
  return grid.sample([&](double x, double y) {
    const double rest = 1.0 - x * x * b2 - y * y * shape.axis_ratio;
    return rest > 0.0 ? 1.5 / contact::pi * std::sqrt(rest) : 0.0;
  });
}

contact::CombinedMaterial scaled_material(double poisson_ratio) {
  contact::CombinedMaterial material;
  material.shear_modulus = 1.0;
  material.poisson_ratio = poisson_ratio;
  material.contact_modulus = 1.0 / (1.0 - poisson_ratio);
  return material;
}

/// Creepages on one ellipse at one resolution, one after another.
class EllipseRolling {
 public:
  EllipseRolling(const EllipseShape& shape, int across)
      : grid_(grid_of(shape, across)),
        pressure_(hertz_pressure(shape, grid_)),
        compliance_(grid_, scaled_material(shape.poisson_ratio)),
        rolling_(compliance_.rolling(UpwindOrder::first), compliance_.rolling(UpwindOrder::second),
                 contact::upwind_weights(grid_, pressure_)) {}

  /// From tractions nearby or, where that does not converge, from nothing.
  ScaledForces solve(const CreepPoint& point, const TangentialField& start) {
    try {
      return solve_from(point, start);
    } catch (const contact::SolveError&) {
      return solve_from(point, {});
    }
  }

  const TangentialField& traction() const { return traction_; }
  void forget() { traction_ = {}; }

  /// The last tractions on a finer grid.
  TangentialField carried_to(const EllipseRolling& finer) const {
    return contact::finer_tractions(grid_, pressure_,
                                    contact::relative_to_bound(traction_, pressure_), finer.grid_,
                                    finer.pressure_);
  }

 private:
  ScaledForces solve_from(const CreepPoint& point, const TangentialField& start) {
    contact::TangentialProblem problem;
    problem.pressure = pressure_;
    problem.friction = contact::coulomb(1.0);
    problem.rigid_slip.x =
        grid_.sample([&](double, double y) { return point.longitudinal - point.spin * y; });
    problem.rigid_slip.y =
        grid_.sample([&](double x, double) { return point.lateral + point.spin * x; });
    contact::TangentialOptions options;
    options.tolerance = tolerance;
    traction_ = contact::solve_tangential(rolling_, problem, options, start).traction;
    return forces();
  }

  /// The pressure of elements that the ellipse cuts is not their mean: what the elements carry
  /// together is set to the load.
  ScaledForces forces() const {
    const double area = 1.0 / pressure_.sum();
    ScaledForces sum;
    for (int j = 0; j < grid_.ny; ++j)
      for (int i = 0; i < grid_.nx; ++i) {
        const int k = grid_.index(i, j);
        sum.longitudinal += area * traction_.x[k];
        sum.lateral += area * traction_.y[k];
        sum.spin_moment += area * (grid_.x(i) * traction_.y[k] - grid_.y(j) * traction_.x[k]);
      }
    return sum;
  }

  ContactGrid grid_;
  Field pressure_;
  HalfspaceCompliance compliance_;
  contact::EdgeFittedRolling rolling_;
  TangentialField traction_;
};

/// What is left from `coarse` to `fine` over what is left from `fine` to the limit: order 3/2.
ScaledForces correction_of(const ScaledForces& fine, const ScaledForces& coarse) {
  const double weight = 1.0 / (std::pow(2.0, 1.5) - 1.0);
  return {weight * (fine.longitudinal - coarse.longitudinal),
          weight * (fine.lateral - coarse.lateral),
          weight * (fine.spin_moment - coarse.spin_moment)};
}

bool small(const ScaledForces& correction, double largest) {
  return std::hypot(correction.longitudinal, correction.lateral) <= largest &&
         std::abs(correction.spin_moment) <= 4.0 * largest;
}

/// The grids of one shape, made when they are first needed.
class EllipseLevels {
 public:
  explicit EllipseLevels(const EllipseShape& shape) : shape_(shape) {}

  /// The next point starts from nothing.
  void forget() { level(0).forget(); }

  /// The coarsest grid starts from the point before, every other from the one before it.
  ManyForces solve(const CreepPoint& point, const ManyOptions& options) {
    ScaledForces coarse = level(0).solve(point, level(0).traction());
    int across = coarsest;
    for (std::size_t k = 1;; ++k) {
      across *= 2;
      const TangentialField start = level(k - 1).carried_to(level(k));
      const ScaledForces fine = level(k).solve(point, start);
      const ScaledForces rest = correction_of(fine, coarse);
      if (small(rest, options.largest_correction) || 2 * across > options.most_across)
        return {{fine.longitudinal + rest.longitudinal, fine.lateral + rest.lateral,
                 fine.spin_moment + rest.spin_moment},
                rest,
                across};
      coarse = fine;
    }
  }

 private:
  EllipseRolling& level(std::size_t k) {
    while (levels_.size() <= k)
      levels_.push_back(
          std::make_unique<EllipseRolling>(shape_, coarsest << static_cast<int>(levels_.size())));
    return *levels_[k];
  }

  EllipseShape shape_;
  std::vector<std::unique_ptr<EllipseRolling>> levels_;
};

void check(const std::vector<EllipseShape>& shapes, const std::vector<CreepPoint>& points,
           const ManyOptions& options) {
  const auto refuse = [](const std::string& what, std::size_t place, const char* allowed) {
    throw contact::InputError(fmt::format("{} {} of a table: allowed: {}", what, place, allowed));
  };
  for (std::size_t s = 0; s < shapes.size(); ++s) {
    const auto& [ratio, poisson] = shapes[s];
    if (!(ratio >= 1e-3 && ratio <= 1e3))
      refuse(fmt::format("axis ratio {:g} of shape", ratio), s, "0.001 to 1000");
    if (!(poisson >= 0.0 && poisson <= 0.5))
      refuse(fmt::format("Poisson's ratio {:g} of shape", poisson), s, "0 to 0.5");
  }
  for (std::size_t k = 0; k < points.size(); ++k) {
    const CreepPoint& point = points[k];
    if (point.shape >= shapes.size())
      refuse(fmt::format("shape {} of point", point.shape), k, "a place in the list of shapes");
    if (!std::isfinite(point.longitudinal + point.lateral + point.spin))
      refuse("creepages of point", k, "finite numbers");
  }
  if (options.most_across < 2 * coarsest)
    throw contact::InputError(fmt::format("table: most_across = {}: allowed: {} and more",
                                          options.most_across, 2 * coarsest));
}

/// Points of one shape that follow each other: none of them knows of another chain.
struct Chain {
  std::size_t shape;
  std::vector<std::size_t> points;
};

std::vector<Chain> chains_of(std::size_t shapes, const std::vector<CreepPoint>& points) {
  std::vector<Chain> chains;
  for (std::size_t s = 0; s < shapes; ++s) {
    std::vector<std::size_t> rest;
    for (std::size_t k = 0; k < points.size(); ++k) {
      if (points[k].shape != s) continue;
      rest.push_back(k);
      if (rest.size() == longest_chain) chains.push_back({s, std::exchange(rest, {})});
    }
    if (!rest.empty()) chains.push_back({s, std::move(rest)});
  }
  return chains;
}

/// Takes one chain after another until there is none. Grids are kept while the shape is the same.
class Worker {
 public:
  Worker(const std::vector<EllipseShape>& shapes, const std::vector<CreepPoint>& points,
         const ManyOptions& options, const std::vector<Chain>& chains,
         std::atomic<std::size_t>& next, std::vector<ManyForces>& results)
      : shapes_(shapes),
        points_(points),
        options_(options),
        chains_(chains),
        next_(next),
        results_(results) {}

  void operator()() const {
    try {
      work();
    } catch (...) {
      next_ = chains_.size();  // nobody begins another
      throw;
    }
  }

 private:
  void work() const {
    const contact::SingleThread single;
    std::unique_ptr<EllipseLevels> levels;
    std::size_t shape = shapes_.size();
    for (std::size_t c = next_++; c < chains_.size(); c = next_++) {
      if (chains_[c].shape != shape || !levels)
        levels = std::make_unique<EllipseLevels>(shapes_[shape = chains_[c].shape]);
      levels->forget();
      for (const std::size_t k : chains_[c].points) solve(*levels, k);
    }
  }

  void solve(EllipseLevels& levels, std::size_t k) const {
    const CreepPoint& point = points_[k];
    try {
      results_[k] = levels.solve(point, options_);
    } catch (const contact::SolveError& error) {
      throw contact::SolveError(
          fmt::format("point {} of a table (axis ratio {:g}, creepages {:g}, {:g}, spin {:g}): {}",
                      k, shapes_[point.shape].axis_ratio, point.longitudinal, point.lateral,
                      point.spin, error.what()));
    }
  }

  const std::vector<EllipseShape>& shapes_;
  const std::vector<CreepPoint>& points_;
  const ManyOptions& options_;
  const std::vector<Chain>& chains_;
  std::atomic<std::size_t>& next_;  // chain; the threads share it
  std::vector<ManyForces>& results_;
};

}  // namespace

std::vector<ManyForces> solve_many(const std::vector<EllipseShape>& shapes,
                                   const std::vector<CreepPoint>& points,
                                   const ManyOptions& options) {
  check(shapes, points, options);
  const std::vector<Chain> chains = chains_of(shapes.size(), points);
  std::vector<ManyForces> results(points.size());
  std::atomic<std::size_t> next{0};
  const Worker worker(shapes, points, options, chains, next, results);
  const int wanted = options.threads > 0 ? options.threads : contact::threads();
  const std::size_t others =
      std::min(static_cast<std::size_t>(wanted), std::max<std::size_t>(chains.size(), 1)) - 1;
  std::vector<std::future<void>> running;
  for (std::size_t t = 0; t < others; ++t)
    running.push_back(std::async(std::launch::async, worker));
  worker();
  for (std::future<void>& other : running) other.get();
  return results;
}

}  // namespace rollfem::halfspace
