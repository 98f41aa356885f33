#include "halfspace/model/error_bars.hpp"

#include "contact/result/patch_size.hpp"
#include "contact/result/quantities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace rollfem::halfspace {

using contact::ContactGrid;
using contact::Field;
using contact::PointResult;
using contact::Scene;

namespace {

/// A bar is a factor times the root of the sum of squares of the change from 2h to h, of `before`
/// times the change from 4h to 2h, since two changes rarely vanish together by chance, and of what
/// else is known of the quantity. Factors and weights: the smallest median bar that holds in 96 %
/// of some 1000 random load points (benchmarks/bar_coverage.cpp, seeds 7 to 9; docs/accuracy.md).
struct Rule {
  double before;
  double with_three;  ///< factor with a grid of 4h
  double with_two;    ///< without one
};

/// What is as smooth as the pressure; besides the changes `size` of the value over n^1.5, n
/// elements across.
struct SmoothQuantity {
  const char* name;
  double size;
  Rule rule;
};
constexpr SmoothQuantity smooth_quantities[] = {
    {"max_pressure", 0.30, {0.2, 0.50, 0.50}},
    {"approach", 0.15, {0.2, 0.28, 0.50}},
    {"elastic_energy", 0.30, {0.2, 0.31, 0.58}},
    {"contact_area", 0.60, {0.0, 0.98, 1.40}},
};
constexpr SmoothQuantity normal_force{"normal_force", 0.30, {0.0, 0.30, 0.45}};

/// Forces: changes of the other two, what friction and creepages do not agree about, the change of
/// the area that adheres and the largest traction over n^1.5 say that one of them does not change
/// by chance.
struct ForceQuantity {
  const char* name;
  double others;
  double balance;
  double adhesion;
  double size;
  Rule rule;
};
constexpr ForceQuantity forces[] = {
    {"longitudinal_force", 0.1, 0.2, 0.02, 0.0, {0.3, 0.56, 0.90}},
    {"lateral_force", 0.7, 0.0, 0.0, 0.02, {0.2, 0.63, 0.90}},
    {"spin_moment", 0.4, 0.0, 0.05, 0.05, {0.2, 0.74, 0.85}},
};

constexpr Rule of_extent{0.0, 1.25, 1.28};
constexpr Rule of_adhesion{0.0, 0.56, 0.75};
constexpr Rule of_largest_traction{0.0, 0.95, 0.85};
constexpr Rule of_largest_traction_x{0.2, 1.10, 1.20};
constexpr Rule of_friction_work{0.0, 0.83, 0.83};
constexpr Rule of_creepage_work{0.2, 0.58, 0.85};
constexpr Rule of_creepage{0.5, 1.05, 1.58};
constexpr Rule of_stress{0.3, 0.52, 0.72};

double root_of_squares(std::initializer_list<double> terms) {
  double sum = 0.0;
  for (const double term : terms) sum += term * term;
  return std::sqrt(sum);
}

double combined(const Rule& rule, bool three, std::initializer_list<double> terms) {
  return (three ? rule.with_three : rule.with_two) * root_of_squares(terms);
}

/// How far the largest value of a field may lie above those of its elements: it falls by `x` and
/// `y` to the nearer of the neighbours along and across.
struct Fall {
  double x = 0.0, y = 0.0;
};
Fall fall_beside_largest(const ContactGrid& grid, const Field& field) {
  Eigen::Index at = 0;
  const double largest = field.maxCoeff(&at);
  const int i = static_cast<int>(at) % grid.nx, j = static_cast<int>(at) / grid.nx;
  const auto value = [&](int column, int row) {
    const bool inside = column >= 0 && row >= 0 && column < grid.nx && row < grid.ny;
    return inside ? field[grid.index(column, row)] : 0.0;
  };
  return {largest - std::max(value(i - 1, j), value(i + 1, j)),
          largest - std::max(value(i, j - 1), value(i, j + 1))};
}

/// Area of the elements along the border between adhesion and slip, mm^2.
double area_of_front(const ContactGrid& grid, const std::vector<contact::ElementState>& state) {
  if (state.size() != static_cast<std::size_t>(grid.size())) return 0.0;
  const auto parted = [&](int one, int other) {
    const contact::ElementState a = state[static_cast<std::size_t>(one)];
    const contact::ElementState b = state[static_cast<std::size_t>(other)];
    return a != b && a != contact::ElementState::exterior && b != contact::ElementState::exterior;
  };
  int count = 0;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      if (i + 1 < grid.nx && parted(grid.index(i, j), grid.index(i + 1, j))) ++count;
      if (j + 1 < grid.ny && parted(grid.index(i, j), grid.index(i, j + 1))) ++count;
    }
  return count * grid.element_area();
}

double elements_across(const ContactGrid& grid, const PointResult& point) {
  return std::max(1.0, 2.0 * std::min(point.semi_axis_x / grid.dx, point.semi_axis_y / grid.dy));
}

class Bars {
 public:
  Bars(const Scene& scene, std::size_t k, const ContactGrid& grid, const PointResult& coarse,
       const PointResult* coarsest, PointResult& fine)
      : load_(scene.points[k]),
        friction_(scene.friction_coefficient()),
        couples_(scene.material.couples()),
        grid_(grid),
        coarse_(coarse),
        coarsest_(coarsest),
        fine_(fine),
        size_(contact::patch_size(grid, fine.fields.traction.n)),
        across_(elements_across(grid, fine)) {}

  void set_normal() const;
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
    return combined(rule, coarsest_ != nullptr, {change, rule.before * before, rest});
  }
  /// Of a quantity with an order for its extrapolated value.
  void set(const char* name, const Rule& rule, double rest, double order = 1.0) const {
    if (!known(name)) return;
    const contact::Quantity& quantity = contact::quantity_named(name);
    const double full = contact::full_sliding(quantity, fine_, friction_);
    const double largest = std::max(std::abs(value(fine_, name)), std::abs(value(coarse_, name)));
    // What vanishes by symmetry is rounding on every grid.
    constexpr double rounding = 1e-7;
    const bool vanishes = quantity.of_friction() && largest <= rounding * full;
    fine_.error_estimate[name] =
        vanishes ? largest : combine(rule, change(name), before(name), rest);
    fine_.richardson[name] = value(fine_, name) + change(name) / (std::exp2(order) - 1.0);
  }
  /// The size over n^1.5.
  double over_grid(double size) const { return size / std::pow(across_, 1.5); }
  double length() const { return std::sqrt(fine_.semi_axis_x * fine_.semi_axis_y); }
  /// N mm per mm rolled, by which the works of friction and creepages differ; 0 but in steady
  /// rolling.
  static double imbalance_of(const PointResult& point) {
    if (!point.frictional_work || !point.creepage_work) return 0.0;
    return *point.frictional_work - *point.creepage_work;
  }
  /// What of it the grid makes. Between unlike materials pressure, shifted by friction, works as
  /// well, on every grid alike.
  double imbalance() const {
    return imbalance_of(fine_) - (couples_ ? imbalance_of(coarse_) : 0.0);
  }

  const contact::LoadPoint& load_;
  double friction_;
  bool couples_;  ///< pressure and friction
  const ContactGrid& grid_;
  const PointResult& coarse_;
  const PointResult* coarsest_;
  PointResult& fine_;
  contact::PatchSize size_;
  double across_;  ///< elements across the patch
};

void Bars::set_normal() const {
  constexpr double order = 2.0;
  for (const SmoothQuantity& of : smooth_quantities)
    set(of.name, of.rule, over_grid(of.size * value(fine_, of.name)), order);
  const bool given = load_.load.force.has_value() && load_.load.direction[0] == 0.0;
  set(normal_force.name, normal_force.rule,
      given ? 0.0 : over_grid(normal_force.size * fine_.normal_force), order);
}

void Bars::set_extents() const {
  constexpr double size = 0.02;
  const auto extent = [&](const char* axis, const char* whole, const char* middle, double unsure) {
    const double rest = std::hypot(unsure, over_grid(size * value(fine_, whole)));
    set(whole, of_extent, rest);
    set(axis, of_extent, 0.5 * rest);
    set(middle, of_extent, 0.5 * rest);
  };
  extent("semi_axis_x", "contact_length", "patch_x_middle", size_.length_unsure);
  extent("semi_axis_y", "contact_width", "patch_y_middle", size_.width_unsure);
  const double front = area_of_front(grid_, fine_.fields.state);
  set("adhesion_area", of_adhesion, std::hypot(over_grid(1.2 * fine_.contact_area), 0.3 * front));
}

void Bars::set_forces() const {
  const double arm = length();
  const contact::Creepage& creepage = fine_.creepage;
  const double slip =
      root_of_squares({creepage.longitudinal, creepage.lateral, arm * creepage.spin});
  const double bound = friction_ * fine_.normal_force;
  const double adhesion =
      fine_.contact_area > 0.0 ? bound * change("adhesion_area") / fine_.contact_area : 0.0;
  // As forces: moments over the arm.
  const auto arm_of = [&](const ForceQuantity& of) { return &of == forces + 2 ? arm : 1.0; };
  for (const ForceQuantity& of : forces) {
    double others = 0.0;
    for (const ForceQuantity& other : forces)
      if (&other != &of) others = std::hypot(others, change(other.name) / arm_of(other));
    const double rest = root_of_squares(
        {of.others * others, of.balance * (slip > 0.0 ? imbalance() / slip : 0.0),
         of.adhesion * adhesion, of.size * over_grid(fine_.max_traction * arm * arm)});
    set(of.name, of.rule, rest * arm_of(of));
    if (&of == forces && fine_.normal_force > 0.0)
      set("traction_coefficient", of.rule, rest / fine_.normal_force);
  }
}

void Bars::set_tractions() const {
  const contact::SurfaceField& traction = fine_.fields.traction;
  if (traction.x.size() != grid_.size() || traction.y.size() != grid_.size()) return;
  const Fall whole = fall_beside_largest(
      grid_, (traction.x.array().square() + traction.y.array().square()).sqrt().matrix());
  set("max_traction", of_largest_traction, std::hypot(whole.x, 0.6 * whole.y));
  const Fall along = fall_beside_largest(grid_, traction.x.cwiseAbs());
  set("max_traction_x", of_largest_traction_x, 0.6 * std::hypot(along.x, along.y));
}

void Bars::set_works() const {
  set("frictional_work", of_friction_work, imbalance());
  if (!fine_.creepage_work) return;
  set("creepage_work", of_creepage_work,
      std::hypot(0.15 * imbalance(), over_grid(0.6 * *fine_.creepage_work)));
}

void Bars::set_creepages() const {
  const double size = std::hypot(fine_.creepage.longitudinal, fine_.creepage.lateral);
  const double rest = over_grid(0.6 * size);
  if (load_.force.longitudinal) set("longitudinal_creepage", of_creepage, rest);
  if (load_.force.lateral) set("lateral_creepage", of_creepage, rest);
}

}  // namespace

void set_error_bars(const Scene& scene, std::size_t k, const ContactGrid& grid,
                    const PointResult& coarse, const PointResult* coarsest, PointResult& fine) {
  const Bars bars(scene, k, grid, coarse, coarsest, fine);
  bars.set_normal();
  bars.set_extents();
  bars.set_forces();
  bars.set_tractions();
  bars.set_works();
  bars.set_creepages();
}

void set_stress_bars(const ContactGrid& grid, const PointResult& coarse,
                     const PointResult* coarsest, PointResult& fine) {
  const auto bar = [&](double value, double middle, double first) {
    return combined(of_stress, coarsest != nullptr,
                    {value - middle, of_stress.before * (middle - first),
                     0.1 * fine.max_pressure / std::pow(elements_across(grid, fine), 1.5)});
  };
  const double layer = std::max(grid.dx, grid.dy);
  for (std::size_t m = 0; m < fine.stress_maxima.size(); ++m) {
    constexpr double below = 1.5, below_coarse = 2.2;
    const contact::StressMaximum& maximum = fine.stress_maxima[m];
    const contact::StressMaximum& middle = coarse.stress_maxima[m];
    if (std::abs(maximum.place[2]) < below * layer ||
        std::abs(middle.place[2]) < below_coarse * layer)
      continue;
    fine.error_estimate[fmt::format("max_{}_{}", maximum.measure, maximum.body)] = bar(
        maximum.value, middle.value, coarsest ? coarsest->stress_maxima[m].value : middle.value);
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
