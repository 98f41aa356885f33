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
  explicit EllipseSource(const CreepTable& table)
      : ratios_(table.axis_ratio), scales_(table.scale), poisson_ratio_(table.poisson_ratio) {}

  void prepare(CreepTable&, const contact::Progress&) override {}

  std::vector<TablePoint> at_node(std::size_t first,
                                  const std::vector<Scaled>& creepages) const override {
    return solve(ratios_[first], scales_[first], creepages);
  }

  std::vector<TablePoint> between(const CreepTableReader& reader, double place,
                                  const std::vector<Scaled>& creepages) const override {
    return solve(place, reader.scale_at(place), creepages);
  }

 private:
  std::vector<TablePoint> solve(double ratio, const Scaled& scale,
                                const std::vector<Scaled>& creepages) const {
    std::vector<halfspace::ScaledCreepage> points;
    for (const Scaled& creepage : creepages)
      points.push_back({creepage[0] / scale[0], creepage[1] / scale[1], creepage[2] / scale[2]});
    std::vector<TablePoint> found;
    for (const halfspace::EllipseForces& one :
         halfspace::roll_ellipse({ratio, poisson_ratio_}, points, {largest_correction}))
      found.push_back(point_of(one));
    return found;
  }

  std::vector<double> ratios_;
  std::vector<Scaled> scales_;
  double poisson_ratio_;
};

}  // namespace

std::unique_ptr<TableSource> ellipse_source(const CreepTable& table) {
  return std::make_unique<EllipseSource>(table);
}

}  // namespace rollfem::tables
