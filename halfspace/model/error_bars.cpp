// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/model/error_bars.hpp"

#include "halfspace/model/grid_signs.hpp"
#include "result/bars.hpp"
#include "result/derived.hpp"
#include "result/free_ends.hpp"
#include "result/patch_size.hpp"
#include "result/quantities.hpp"
#include "result/stress_extremes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <optional>

namespace rollfem::halfspace {

using contact::ContactGrid;
using contact::Field;
using contact::PointResult;
using contact::Scene;

namespace {

/// An error bar is a factor times the root of the sum of squares of the change from 2h to h, of
/// `before` times the change from 4h to 2h (because two changes rarely vanish together by chance),
/// and of other known contributions. Factors and weights: the smallest median bar that holds in 96
/// % of about 1400 random load points (benchmarks/bar_coverage.cpp, seeds 21 and 22 and the first
/// 400 contacts of seed 23; docs/accuracy.md).
struct Rule {
  double before;
  double with_three;  ///< factor with a grid of 4h
  double with_two;    ///< without one
  /// Where friction falls with the slip, which is less accurate than the traction: fitted to seeds
  /// 13 and 41 of `benchmark_bar_coverage falling`.
  double falling = 1.0;
  /// Where a layer yields or friction varies: fitted to seeds 61 of `yielding`, 62 of `varying`.
  double uneven = 1.0;
};

/// Quantities as smooth as the pressure; besides the changes, `size` of the value over n^1.5, n
/// elements across.
struct SmoothQuantity {
  const char* name;
  double size;
  Rule rule;
  double power = 1.0;  ///< of the normal force, as in Hertz's theory
};
constexpr SmoothQuantity smooth_quantities[] = {
    {"max_pressure", 0.30, {0.2, 0.40, 0.62}, 1.0 / 3.0},
    {"approach", 0.15, {0.2, 0.30, 0.48}, 2.0 / 3.0},
    {"elastic_energy", 0.30, {0.2, 0.38, 0.60}, 5.0 / 3.0},
    {"contact_area", 0.60, {0.0, 1.06, 1.25}, 2.0 / 3.0},
};
constexpr SmoothQuantity normal_force{"normal_force", 0.30, {0.0, 0.30, 0.45}};

/// A force or moment has an error from every row of elements, whose leading edge lies anywhere in
/// an element, which makes the forces of the rows rough. It also inherits a fraction of the errors
/// of the other two forces, and of the disagreement between the works of friction and creepages,
/// that grows with its own share.
constexpr const char* forces[] = {"longitudinal_force", "lateral_force", "spin_moment"};
/// Fitted, as the extents, to seeds 1, 3, 4 and 5 of benchmarks/placed_bars.py.
constexpr Rule of_force{0.25, 1.35, 1.35, 1.5, 1.3};
constexpr Rule of_moment{0.3, 1.60, 1.60, 1.5, 1.3};
constexpr Rule of_extent{0.3, 0.75, 0.80};
constexpr Rule of_adhesion{0.0, 0.64, 0.72};
constexpr Rule of_largest_traction{0.0, 0.65, 0.70};
constexpr Rule of_largest_traction_x{0.0, 0.74, 1.00};
/// Largest error at any y.
constexpr Rule of_pass_work{0.15, 1.17, 1.24, 1.2, 1.3};
/// Of the warming by friction: as the work of a row, of which it is an integral.
constexpr Rule of_temperature{0.2, 1.00, 1.20};
constexpr Rule of_creepage_work{0.2, 1.50, 1.50, 1.5};
constexpr Rule of_creepage{0.4, 1.70, 2.50};
constexpr Rule of_stress{0.3, 0.60, 0.75};

double root_of_squares(std::initializer_list<double> terms) {
  double sum = 0.0;
  for (const double term : terms) sum += term * term;
  return std::sqrt(sum);
}

double combined(const Rule& rule, bool three, std::initializer_list<double> terms) {
  return (three ? rule.with_three : rule.with_two) * root_of_squares(terms);
}

/// In the order of `forces`, N and N mm.
using Roughness = std::array<double, 3>;

class Bars {
 public:
  Bars(const Scene& scene, std::size_t k, const ContactGrid& grid, const PointResult& coarse,
       const PointResult* coarsest, const WaveErrors* waves, PointResult& fine)
      : load_(scene.points[k]),
        friction_(scene.friction_coefficient()),
        falls_(scene.friction_law && scene.friction_law->feels_slip()),
        layer_(scene.friction_law ? scene.friction_law->plasticity : std::nullopt),
        uneven_(layer_ || (scene.friction_law && scene.friction_law->varies())),
        grid_(grid),
        coarse_(coarse),
        coarsest_(coarsest),
        waves_(waves),
        fine_(fine),
        rounding_(rounding_errors(scene, grid, fine)),
        size_(contact::patch_size(grid, fine.fields.traction.n)),
        across_(elements_across(grid, fine)) {}

  void set_normal() const;
  void set_normal_force() const;
  void set_extents() const;
  void set_forces() const;
  void set_tractions() const;
  void set_works() const;
  void set_creepages() const;

 private:
  double value(const PointResult& point, const char* name) const {
    return contact::quantity_named(name).value(point).value_or(0.0);
  }
  bool known(const char* name) const {
    const contact::Quantity& quantity = contact::quantity_named(name);
    return quantity.value(fine_).has_value() && quantity.value(coarse_).has_value();
  }
  double change(const char* name) const { return value(fine_, name) - value(coarse_, name); }
  double before(const char* name) const {
    return coarsest_ ? value(coarse_, name) - value(*coarsest_, name) : 0.0;
  }
  double combine(const Rule& rule, double change, double before, double rest) const {
    return std::max(falls_ ? rule.falling : 1.0, uneven_ ? rule.uneven : 1.0) *
           combined(rule, coarsest_ != nullptr, {change, rule.before * before, rest});
  }
  std::optional<double> of_waves(const char* name, double times = 1.0) const {
    return waves_ ? std::optional(times * waves_->at(name)) : std::nullopt;
  }
  /// `of_waves`: change by narrower elements, where waves are too short for the current ones.
  /// Changes from coarser grids are then multiplied by `of_changes`.
  void set(const char* name, const Rule& rule, double rest, std::optional<double> of_waves = {},
           double of_changes = 1.0) const {
    if (!known(name)) return;
    const contact::Quantity& quantity = contact::quantity_named(name);
    const double full = contact::full_sliding(quantity, fine_, friction_);
    const double largest = std::max(std::abs(value(fine_, name)), std::abs(value(coarse_, name)));
    // Quantities that vanish by symmetry are rounding on every grid.
    constexpr double rounding = 1e-7;
    const bool vanishes = quantity.of_friction() && largest <= rounding * full;
    constexpr double of_narrower = 1.3;
    const double times = of_waves ? of_changes : 1.0;
    const double of_grids = combine(rule, times * change(name), times * before(name), rest);
    const auto rounded = rounding_.find(name);
    fine_.error_estimate[name] =
        vanishes ? largest
                 : std::hypot(of_grids, of_narrower * of_waves.value_or(0.0),
                              rounded == rounding_.end() ? 0.0 : rounded->second);
  }
  /// A further contribution, in the unit of the quantity.
  void add(const char* name, double error) const {
    const auto bar = fine_.error_estimate.find(name);
    if (bar != fine_.error_estimate.end()) bar->second = std::hypot(bar->second, error);
  }
  /// Relative error of a normal force that depends on friction, because the given force is not
  /// normal to the surface.
  double part_of_load() const {
    return load_.load.force && fine_.normal_force > 0.0
               ? bar_of(normal_force.name) / fine_.normal_force
               : 0.0;
  }
  /// Quantities of order 2. For lower orders, extrapolation increases the error.
  void extrapolate(const char* name) const {
    if (known(name)) fine_.richardson[name] = value(fine_, name) + change(name) / 3.0;
  }
  /// The size over n^1.5.
  double over_grid(double size) const { return size / std::pow(across_, 1.5); }
  double length() const {
    return grid_.is_line() ? fine_.semi_axis_x : std::sqrt(fine_.semi_axis_x * fine_.semi_axis_y);
  }
  double part_in_adhesion() const {
    return fine_.contact_area > 0.0 ? fine_.adhesion_area / fine_.contact_area : 0.0;
  }
  Roughness roughness() const;
  /// Contributions to the bar of force i of `forces` besides its changes; in its unit, including
  /// its part of the load if requested.
  double rest_of_force(std::size_t i, const Roughness& rough, bool over_load) const;
  double bar_of(const char* name) const {
    const auto found = fine_.error_estimate.find(name);
    return found == fine_.error_estimate.end() ? 0.0 : found->second;
  }
  /// N mm per mm^2, per row: the work that was missing in the elements, which do not resolve the
  /// end of the slip; empty except in steady rolling.
  Field put_right() const {
    if (fine_.fields.work.size() != grid_.size()) return {};
    return contact::pass_work(grid_, fine_) -
           contact::pass_work(grid_, fine_.fields.traction, fine_.fields.slip);
  }
  /// N mm per mm rolled, the same of the patch.
  double imbalance() const { return grid_.dy * put_right().sum(); }

  const contact::LoadPoint& load_;
  double friction_;
  bool falls_;  ///< friction, with the slip
  std::optional<contact::Plasticity> layer_;
  bool uneven_;
  const ContactGrid& grid_;
  const PointResult& coarse_;
  const PointResult* coarsest_;
  const WaveErrors* waves_;  ///< null: the elements follow the profiles
  PointResult& fine_;
  WaveErrors rounding_;
  contact::PatchSize size_;
  double across_;  ///< elements across the patch
};

void Bars::set_normal() const {
  constexpr double beside_narrower = 0.2;
  for (const SmoothQuantity& of : smooth_quantities) {
    const double size = value(fine_, of.name);
    set(of.name, of.rule, over_grid(of.size * size), of_waves(of.name), beside_narrower);
    add(of.name, of.power * part_of_load() * size);
    extrapolate(of.name);
  }
}

/// Under a given force, the error of F_z is that of friction along the direction of the force.
void Bars::set_normal_force() const {
  const bool given = load_.load.force.has_value();
  set(normal_force.name, normal_force.rule,
      given ? 0.0 : over_grid(normal_force.size * fine_.normal_force), of_waves(normal_force.name));
  extrapolate(normal_force.name);
  const auto& [across, along] = load_.load.direction;
  if (given)
    fine_.error_estimate[normal_force.name] =
        std::hypot(bar_of(normal_force.name), across / along * bar_of("lateral_force"));
}

void Bars::set_extents() const {
  constexpr double of_edges = 8.0, size = 0.11;
  const auto extent = [&](const char* axis, const char* whole, const char* middle, double unsure) {
    const double rest = std::hypot(of_edges * unsure, over_grid(size * value(fine_, whole)));
    set(whole, of_extent, rest, of_waves(whole));
    set(axis, of_extent, 0.5 * rest, of_waves(whole, 0.5));
    set(middle, of_extent, 0.6 * rest, of_waves(whole, 0.5));
    for (const char* name : {axis, whole}) add(name, part_of_load() / 3.0 * value(fine_, name));
  };
  extent("semi_axis_x", "contact_length", "patch_x_middle", size_.length_unsure);
  if (!grid_.is_line())
    extent("semi_axis_y", "contact_width", "patch_y_middle", size_.width_unsure);
  // With many rows, the errors of elements cut by the front cancel; a line contact has one row.
  const double front = area_of_front(grid_, fine_.fields.state);
  const double unsure = grid_.is_line() ? 1.3 * std::max(front, grid_.element_area()) : 0.3 * front;
  set("adhesion_area", of_adhesion, std::hypot(over_grid(1.2 * fine_.contact_area), unsure),
      of_waves("contact_area", part_in_adhesion()));
}

Roughness Bars::roughness() const {
  const contact::SurfaceField& traction = fine_.fields.traction;
  if (traction.x.size() != grid_.size() || traction.y.size() != grid_.size()) return {};
  Field moment(grid_.size());
  for (int j = 0; j < grid_.ny; ++j)
    for (int i = 0; i < grid_.nx; ++i) {
      const int k = grid_.index(i, j);
      moment[k] = grid_.x(i) * traction.y[k] - grid_.y(j) * traction.x[k];
    }
  return {roughness_of_rows(grid_, traction.x), roughness_of_rows(grid_, traction.y),
          roughness_of_rows(grid_, moment)};
}

double Bars::rest_of_force(std::size_t i, const Roughness& rough, bool over_load) const {
  constexpr double of_others = 0.3, of_rows = 0.2, of_balance = 0.5, of_adhering = 0.1;
  // Moments are compared as forces, divided by their arm.
  const std::array<double, 3> arms{1.0, 1.0, length()};
  const contact::Creepage& creepage = fine_.creepage;
  const double load = over_load ? fine_.normal_force / coarse_.normal_force : 1.0;
  double others = 0.0, whole = 0.0;
  for (std::size_t j = 0; j < arms.size(); ++j) {
    const double now = value(fine_, forces[j]) / arms[j];
    whole = std::hypot(whole, now);
    if (j != i) others = std::hypot(others, now - load * value(coarse_, forces[j]) / arms[j]);
  }
  // At least that which did the work: surfaces may slip without creepage.
  const double slip =
      std::max(root_of_squares({creepage.longitudinal, creepage.lateral, length() * creepage.spin}),
               whole > 0.0 ? std::abs(fine_.creepage_work.value_or(0.0)) / whole : 0.0);
  const double own = std::abs(value(fine_, forces[i])) / arms[i];
  const double share = whole > 0.0 ? std::min(1.0, own / whole) : 0.0;
  // With almost no slip, the work of friction comes from single elements; in full sliding, rows are
  // as rough as the load.
  const double adhering = part_in_adhesion();
  const double balance = slip > 0.0 ? (1.0 - adhering) * imbalance() / slip : 0.0;
  const double row = rough[i] / arms[i] * (over_load ? std::sqrt(adhering) : 1.0);
  const double change_of_adhering =
      fine_.contact_area > 0.0 ? change("adhesion_area") / fine_.contact_area : 0.0;
  return arms[i] *
         root_of_squares({of_others * std::sqrt(share) * others, of_rows * row,
                          of_balance * share * balance, of_adhering * change_of_adhering * own});
}

void Bars::set_forces() const {
  const Roughness rough = roughness();
  const bool given[] = {load_.force.longitudinal.has_value(), load_.force.lateral.has_value(),
                        false};
  for (std::size_t i = 0; i < rough.size(); ++i)
    set(forces[i], i == 2 ? of_moment : of_force, given[i] ? 0.0 : rest_of_force(i, rough, false));
  set_normal_force();
  if (!(fine_.normal_force > 0.0) || !(coarse_.normal_force > 0.0)) return;
  // Under a given F_x only F_z is uncertain.
  const double rest = given[0] ? fine_.traction_coefficient * bar_of("normal_force")
                               : rest_of_force(0, rough, true);
  set("traction_coefficient", of_force, rest / fine_.normal_force);
}

void Bars::set_tractions() const {
  constexpr double along = 0.4, across = 0.2, of_fall = 3.0, of_pressure = 1.5, of_missed = 1.6;
  const contact::SurfaceField& traction = fine_.fields.traction;
  if (traction.x.size() != grid_.size() || traction.y.size() != grid_.size()) return;
  // With slip almost everywhere, the largest traction is as smooth as the pressure; otherwise it is
  // at the end of adhesion and decreases on both sides.
  const double bound = friction_ * fine_.max_pressure;
  // A layer that softens bears its yield stress where it begins to yield, perhaps between elements.
  const auto& state = fine_.fields.state;
  const bool softens = layer_ && layer_->hardening < 0.0 &&
                       std::count(state.begin(), state.end(), contact::ElementState::plastic) > 0;
  const double missed = softens ? std::max(0.0, layer_->yield_stress - fine_.max_traction) : 0.0;
  const auto largest = [&](const char* name, const Rule& rule, const Field& field) {
    const Peak peak = peak_of(grid_, field);
    const double part = bound > 0.0 ? std::min(1.0, std::abs(value(fine_, name)) / bound) : 1.0;
    set(name, rule,
        root_of_squares({along * peak.sag_x, across * peak.sag_y,
                         of_fall * (1.0 - part) * peak.fall, of_missed * missed}),
        of_waves("max_pressure", of_pressure * part * friction_));
  };
  largest("max_traction", of_largest_traction,
          (traction.x.array().square() + traction.y.array().square()).sqrt().matrix());
  largest("max_traction_x", of_largest_traction_x, traction.x.cwiseAbs());
}

void Bars::set_works() const {
  constexpr double of_rows = 0.28, of_largest = 2.5, size = 1.5;
  if (fine_.max_temperature)
    set("max_temperature", of_temperature,
        over_grid(0.3 * (*fine_.max_temperature - fine_.fields.temperature_rail.minCoeff())));
  // Bodies of unlike temperature exchange heat along every row, which begins and ends in an
  // element.
  const double exchanged = 0.75 * std::abs(value(fine_, "heat_wheel") - value(fine_, "heat_rail"));
  if (!fine_.frictional_work || !fine_.creepage_work) {
    for (const char* name : {"heat_wheel", "heat_rail"})
      if (known(name))
        set(name, of_creepage_work, over_grid(size * std::abs(value(fine_, name)) + exchanged));
    return;
  }
  const Field added = put_right();
  set("max_pass_work", of_pass_work,
      std::hypot(of_rows * (added.size() > 0 ? added.cwiseAbs().maxCoeff() : 0.0),
                 over_grid(of_largest * *fine_.max_pass_work)));
  // In full sliding it is the bound times the creepage.
  constexpr double of_balance = 0.05, of_found = 0.3;
  const double adhering = part_in_adhesion();
  const double found = std::hypot(fine_.longitudinal_force * change("longitudinal_creepage"),
                                  fine_.lateral_force * change("lateral_creepage"));
  const auto set_work = [&](const char* name, double more) {
    set(name, of_creepage_work,
        root_of_squares({of_balance * adhering * imbalance(),
                         over_grid(size * std::sqrt(adhering) * value(fine_, name) + more),
                         of_found * found}));
  };
  for (const char* name : {"frictional_work", "creepage_work"}) set_work(name, 0.0);
  for (const char* name : {"heat_wheel", "heat_rail"})
    if (known(name)) set_work(name, exchanged);
}

void Bars::set_creepages() const {
  constexpr double size = 0.5, of_other = 0.2;
  const double rest =
      over_grid(size * std::hypot(fine_.creepage.longitudinal, fine_.creepage.lateral));
  const auto found = [&](const char* name, const char* other) {
    set(name, of_creepage, std::hypot(rest, of_other * change(other)));
  };
  if (load_.force.longitudinal) found("longitudinal_creepage", "lateral_creepage");
  if (load_.force.lateral) found("lateral_creepage", "longitudinal_creepage");
}

}  // namespace

void set_error_bars(const Scene& scene, std::size_t k, const ContactGrid& grid,
                    const PointResult& coarse, const PointResult* coarsest, PointResult& fine,
                    const WaveErrors* waves) {
  const Bars bars(scene, k, grid, coarse, coarsest, waves, fine);
  bars.set_forces();
  bars.set_normal();
  bars.set_extents();
  bars.set_tractions();
  bars.set_works();
  bars.set_creepages();
  contact::explain_singular_values(scene, grid, fine);
}

void mark_near_surface(double depth, PointResult& point) {
  for (const contact::StressMaximum& maximum : point.stress_maxima)
    if (maximum.measure != contact::surface_shear && std::abs(maximum.place[2]) < depth)
      point.no_bar[maximum.bar_name()] = contact::NoBar::near_surface;
}

void set_stress_bars(const ContactGrid& grid, const PointResult& coarse,
                     const PointResult* coarsest, PointResult& fine) {
  const auto bar = [&](double value, double middle, double first) {
    return combined(of_stress, coarsest != nullptr,
                    {value - middle, of_stress.before * (middle - first),
                     0.1 * fine.max_pressure / std::pow(elements_across(grid, fine), 1.5)});
  };
  for (std::size_t m = 0; m < fine.stress_maxima.size(); ++m) {
    const contact::StressMaximum& maximum = fine.stress_maxima[m];
    const contact::StressMaximum& middle = coarse.stress_maxima[m];
    if (maximum.measure == contact::surface_shear) continue;  // the largest traction has a bar
    const std::string name = maximum.bar_name();
    const auto told = [&](const PointResult& point) { return point.no_bar.count(name) != 0; };
    if (told(fine) || told(coarse))
      fine.no_bar[name] = contact::NoBar::near_surface;
    else
      fine.error_estimate[name] = bar(maximum.value, middle.value,
                                      coarsest ? coarsest->stress_maxima[m].value : middle.value);
  }
  double largest = 0.0;
  for (std::size_t r = 0; r < fine.subsurface.size(); ++r)
    for (std::size_t p = 0; p < fine.subsurface[r].stress.size(); ++p)
      for (std::size_t c = 0; c < 6; ++c) {
        const double middle = coarse.subsurface[r].stress[p][c];
        largest = std::max(largest, bar(fine.subsurface[r].stress[p][c], middle,
                                        coarsest ? coarsest->subsurface[r].stress[p][c] : middle));
      }
  if (!fine.subsurface.empty()) fine.error_estimate["subsurface_stress"] = largest;
}

}  // namespace rollfem::halfspace
