// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tables/filling/table_source.hpp"

#include "base/errors.hpp"
#include "base/threads.hpp"
#include "halfspace/model/rolling_ellipse.hpp"
#include "tables/filling/table_grid.hpp"
#include "track/balance/pressed_wheel.hpp"
#include "track/motion/placed_scenes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace rollfem::tables {

namespace {

using track::PressedWheel;

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
          found.elements_across,
          found.rise};
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
    if (made.fall.shape.by_temperature) *made.fall.constants[2] /= mu;
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
    if (const auto& heat = axes_.heat) {
      shape.heat = halfspace::ScaledHeat{heat->temperature, 1.0};
      const double bound = input_.friction_coefficient * place.load;
      if (heat->sets_friction != 0.0)
        shape.heat->unit = bound * bound * std::sqrt(place.speed) /
                           (axes_.shear_modulus * heat->effusivity * std::pow(c, 3.5));
    }
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

TableWheel wheel_of(const track::PressedState& state) {
  TableWheel wheel;
  wheel.semi_axis_x = state.semi_axis_x;
  wheel.semi_axis_y = state.semi_axis_y;
  wheel.normal_force = state.normal_force;
  wheel.contact_angle = state.place.contact_angle;
  wheel.rolling_radius = state.place.rolling_radius;
  wheel.y_rail = state.place.y_rail;
  wheel.y_wheel = state.place.y_wheel;
  wheel.lateral_pressure = state.lateral_pressure;
  wheel.max_pressure = state.max_pressure;
  wheel.contact_area = state.contact_area;
  wheel.contacts = state.contacts;
  return wheel;
}

/// For failures.
contact::FailurePlace shifted_by(double shift) {
  return {fmt::format("at a lateral shift of {:g} mm", shift)};
}

/// Factors of scaled creepages and forces.
struct Units {
  double bound;   ///< mu F_n, N
  double length;  ///< c, mm
  Scaled creepage;
};

class WheelSource : public TableSource {
 public:
  explicit WheelSource(const contact::Case& input)
      : input_(input), search_(track::search_scene_of(input)) {}

  void prepare(CreepTable& table, const contact::Progress& progress) override {
    shear_modulus_ = table.shear_modulus;
    heat_ = table.heat;
    speeds_ = table.speed;
    shifts_ = table.lateral_shift.size();
    contact::ProgressEvent event;
    event.model = "table";
    event.stage = "contacts of the shifts";
    const std::size_t count = table.loads() * shifts_;
    event.points = static_cast<int>(count);
    contact::report(progress, event);
    std::vector<std::optional<PressedWheel>> found(count);
    std::mutex telling;
    contact::for_each_index(count, [&](std::size_t k) {
      found[k] = pressed(
          {table.lateral_shift[k % shifts_], table.load.empty() ? 0.0 : table.load[k / shifts_]});
      const std::lock_guard<std::mutex> one_at_a_time(telling);
      ++event.point;
      contact::report(progress, event);
    });
    for (std::size_t k = 0; k < count; ++k) {
      wheels_.push_back(*std::move(found[k]));
      table.wheels.push_back(wheel_of(wheels_.back().state()));
      const TableWheel& wheel = table.wheels.back();
      table.scale.push_back(
          scale_of_ratio(wheel.semi_axis_x / wheel.semi_axis_y, table.poisson_ratio));
      units_.push_back(units_of(wheel, table.scale.back()));
      if (k % shifts_ > 0 && contact_jumps(table.wheels[k - 1], wheel))
        table.wheels[k - 1].jump_after = 1.0;
    }
    event.finished = true;
    contact::report(progress, event);
  }

  std::vector<TablePoint> at_node(std::size_t node,
                                  const std::vector<Scaled>& creepages) const override {
    const std::size_t speeds = std::max<std::size_t>(speeds_.size(), 1), layer = node / shifts_;
    const std::size_t wheel = layer / speeds * shifts_ + node % shifts_;
    const double speed = speeds_.empty() ? 0.0 : speeds_[layer % speeds];
    return contact::at_place(shifted_by(wheels_[wheel].state().place.lateral_shift), [&] {
      return solve(wheels_[wheel], units_[wheel], speed, creepages);
    });
  }

  std::vector<TablePoint> between(const CreepTableReader& reader, const TablePlace& place,
                                  const std::vector<Scaled>& creepages) const override {
    const Units units = units_of(reader.wheel_at(place), reader.scale_at(place));
    return contact::at_place(shifted_by(place.first),
                             [&] { return solve(pressed(place), units, place.speed, creepages); });
  }

 private:
  PressedWheel pressed(const TablePlace& place) const {
    contact::Case here = input_;
    here.wheelset.lateral_shift.assign(1, place.first);
    if (place.load > 0.0)
      (here.load.vertical_force ? here.load.vertical_force : here.load.normal_force) = place.load;
    return contact::at_place(shifted_by(place.first), [&] { return PressedWheel(here, search_); });
  }

  Units units_of(const TableWheel& wheel, const Scaled& scale) const {
    const double c = std::sqrt(wheel.semi_axis_x * wheel.semi_axis_y);
    const double bound = input_.friction_coefficient * wheel.normal_force;
    const double creepage = bound / (shear_modulus_ * c * c);
    return {bound, c, {creepage / scale[0], creepage / scale[1], creepage / (scale[2] * c)}};
  }

  std::vector<TablePoint> solve(const PressedWheel& wheel, const Units& units, double speed,
                                const std::vector<Scaled>& creepages) const {
    contact::Case moving = input_;
    if (speed > 0.0) moving.rolling.speed = speed;
    std::vector<contact::Creepage> asked;
    for (const Scaled& scaled : creepages)
      asked.push_back({scaled[0] * units.creepage[0], scaled[1] * units.creepage[1],
                       scaled[2] * units.creepage[2]});
    std::vector<TablePoint> found;
    const double force = units.bound, moment = units.bound * units.length;
    const double rise = !heat_ ? 0.0
                               : shear_modulus_ * heat_->effusivity * std::pow(units.length, 3.5) /
                                     (force * force * std::sqrt(moving.rolling.speed));
    for (const track::FrictionForce& one :
         wheel.forces(asked, contact::friction_of(moving), contact::surface_heat(moving)))
      found.push_back({{one.longitudinal / force, one.lateral / force, one.spin_moment / moment},
                       one.normal / force,
                       {one.force_bar / force, one.moment_bar / moment},
                       input_.contact_grid.elements_across,
                       one.rise * rise});
    return found;
  }

  const contact::Case& input_;
  track::SearchScene search_;
  double shear_modulus_ = 0.0;  // MPa, combined
  std::optional<TableHeat> heat_;
  std::vector<double> speeds_;
  std::size_t shifts_ = 1;
  std::vector<PressedWheel> wheels_;  ///< as CreepTable::wheels
  std::vector<Units> units_;
};

}  // namespace

std::unique_ptr<TableSource> ellipse_source(const CreepTable& table, const contact::Case& input) {
  return std::make_unique<EllipseSource>(table, input);
}

std::unique_ptr<TableSource> wheel_source(const contact::Case& input) {
  return std::make_unique<WheelSource>(input);
}

}  // namespace rollfem::tables
