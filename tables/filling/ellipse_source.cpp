// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/model/rolling_ellipse.hpp"
#include "tables/filling/table_source.hpp"

#include <algorithm>
#include <cmath>

namespace rollfem::tables {

namespace {

// Smallest bar. The difference of two grids estimates the error but does not bound it; with this
// minimum the bars hold at 269 of 270 random points (docs/tables.md).
constexpr double least_force_bar = 0.002;
constexpr double least_moment_bar = 0.002;

/// Half the tolerance of a list of points: forces within 0.2 % of mu F_n everywhere.
constexpr double largest_correction = 0.0015;

TablePoint point_of(const halfspace::EllipseForces& found) {
  const auto& [along, across, moment] = found.correction;
  return {{found.limit.longitudinal, found.limit.lateral, found.limit.spin_moment},
          0.0,
          {std::max(least_force_bar, std::hypot(along, across)),
           std::max(least_moment_bar, std::abs(moment))},
          found.elements_across};
}

class EllipseSource : public TableSource {
 public:
  EllipseSource(const CreepTable& table, const contact::Case& input)
      : input_(input), axes_(table) {}

  void prepare(CreepTable&, const contact::Progress&) override {}

  std::vector<TablePoint> at_node(std::size_t node,
                                  const std::vector<Scaled>& creepages) const override {
    const std::size_t ratio = node % axes_.axis_ratio.size();
    const TablePlace place = axes_.node(node);
    const double c = axes_.mean_axis.empty()
                         ? 0.0
                         : axes_.mean_axis[ratio] * std::cbrt(place.load / axes_.load.front());
    return solve(place, axes_.scale[ratio], c, creepages);
  }

  std::vector<TablePoint> between(const CreepTableReader& reader, const TablePlace& place,
                                  const std::vector<Scaled>& creepages) const override {
    const double c = axes_.mean_axis.empty() ? 0.0 : reader.mean_axis_at(place);
    return solve(place, reader.scale_at(place), c, creepages);
  }

 private:
  /// Friction that depends on the load, of an ellipse of this c.
  halfspace::ScaledFriction friction_at(const TablePlace& place, double c) const {
    halfspace::ScaledFriction made{input_.friction_fall, 0.0, input_.layer};
    const double mu = input_.friction_coefficient, modulus = axes_.shear_modulus,
                 slip = mu * place.load / (modulus * c * c);
    if (made.fall.kinetic_coefficient) *made.fall.kinetic_coefficient /= mu;
    made.fall.second_part /= mu;
    made.fall.memory_distance /= slip * c;
    made.speed = place.speed * slip;
    if (!made.layer) return made;
    if (made.layer->thickness) *made.layer->thickness /= c;
    if (made.layer->shear_modulus) *made.layer->shear_modulus /= modulus;
    if (made.layer->yield_stress) *made.layer->yield_stress /= slip * modulus;
    if (made.layer->hardening) *made.layer->hardening *= c / modulus;
    return made;
  }

  std::vector<TablePoint> solve(const TablePlace& place, const Scaled& scale, double c,
                                const std::vector<Scaled>& creepages) const {
    halfspace::EllipseShape shape{place.first, axes_.poisson_ratio};
    if (c > 0.0) shape.friction = friction_at(place, c);
    std::vector<halfspace::ScaledCreepage> points;
    for (const Scaled& creepage : creepages)
      points.push_back({creepage[0] / scale[0], creepage[1] / scale[1], creepage[2] / scale[2]});
    std::vector<TablePoint> found;
    for (const halfspace::EllipseForces& one :
         halfspace::roll_ellipse(shape, points, {largest_correction}))
      found.push_back(point_of(one));
    return found;
  }

  const contact::Case& input_;
  CreepTable axes_;  ///< without points
};

}  // namespace

std::unique_ptr<TableSource> ellipse_source(const CreepTable& table, const contact::Case& input) {
  return std::make_unique<EllipseSource>(table, input);
}

}  // namespace rollfem::tables
