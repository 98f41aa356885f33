// SPDX-License-Identifier: LGPL-2.1-or-later
#include "result/bars.hpp"

#include "result/stress_extremes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace rollfem::contact {

namespace {

/// Relative difference of equal forces; balances are more accurate.
constexpr double same_force = 1e-6;

/// The load point of a result; a model with one result for all load points uses the largest load.
NormalLoad load_behind(const Scene& scene, const ModelResult& result, std::size_t k) {
  return result.points.size() == scene.points.size() ? scene.points[k].load : largest_load(scene);
}

PrescribedForce force_of(const Scene& scene, const ModelResult& result, std::size_t k) {
  return result.points.size() == scene.points.size() ? scene.points[k].force : PrescribedForce{};
}

bool is_creepage(const std::string& name) {
  return name == "longitudinal_creepage" || name == "lateral_creepage" || name == "spin";
}

/// Error bars of creepages from a balance.
void add_creepage_bars(const LoadPoint& load_point, PointResult& point) {
  if (!load_point.creepage_error) return;
  const Creepage& error = *load_point.creepage_error;
  point.error_estimate.emplace("longitudinal_creepage", error.longitudinal);
  point.error_estimate.emplace("lateral_creepage", error.lateral);
  point.error_estimate.emplace("spin", error.spin);
}

/// Quantities prescribed by the case at this load point.
bool is_given(const Scene& scene, const ModelResult& result, std::size_t k,
              const std::string& name) {
  if (scene.given_pressure && name != "normal_force") return false;
  if (scene.geometry.line &&
      (name == "contact_width" || name == "semi_axis_y" || name == "patch_y_middle"))
    return true;
  const NormalLoad load = load_behind(scene, result, k);
  // On a curved surface tangential tractions add to the force along z.
  if (name == "normal_force")
    return load.force && load.direction[0] == 0.0 &&
           std::abs(result.points[k].normal_force - *load.force) <= same_force * *load.force;
  return name == "approach" && load.approach && !load.force;
}

/// Quantities of a line contact that depend on the reference distance, because displacements of
/// half-planes are known up to a constant.
bool is_relative(const Scene& scene, const std::string& name) {
  return scene.geometry.line && std::isfinite(scene.geometry.line->reference) &&
         (name == "approach" || name == "elastic_energy");
}

/// Quantities found for a prescribed force: the creepage in rolling, otherwise the shift.
bool is_found(const Scene& scene, const PrescribedForce& force, const std::string& name) {
  const bool shifts = scene.problem == Problem::shift;
  return (force.longitudinal &&
          name == (shifts ? "longitudinal_shift" : "longitudinal_creepage")) ||
         (force.lateral && name == (shifts ? "lateral_shift" : "lateral_creepage"));
}

/// Reason why a value has no error bar.
NoBar reason_of(const Scene& scene, const BarRules& rules, const ModelResult& result, std::size_t k,
                const Quantity& quantity) {
  const std::string name = quantity.name;
  if (scene.turns_freely && is_creepage(name)) return NoBar::balance;
  if (is_relative(scene, name)) return NoBar::relative;
  if (quantity.no_bar && !is_found(scene, force_of(scene, result, k), name))
    return *quantity.no_bar;
  if (is_given(scene, result, k, name)) return NoBar::given;
  // True profiles are approximated by an ellipse, which is not their exact contact.
  const bool exact = rules.hertzian && !scene.has_profiles();
  if (rules.hertzian && quantity.member.normal_problem) return exact ? NoBar::exact : NoBar::theory;
  // Without tangential tractions these are exact.
  if (exact && result.points[k].max_traction == 0.0 &&
      (quantity.of_friction() || name == "adhesion_area"))
    return NoBar::exact;
  const bool estimates = rules.otherwise == NoBar::not_estimated;
  return estimates && result.points[k].error_estimate.empty() ? NoBar::one_grid : rules.otherwise;
}

void explain_stresses(const BarRules& rules, PointResult& point) {
  const auto explain = [&](const std::string& name) {
    if (!point.has_bar(name)) point.no_bar.emplace(name, rules.otherwise);
  };
  for (const StressMaximum& maximum : point.stress_maxima) {
    const std::string name = maximum.bar_name();
    // It is the largest traction.
    if (maximum.measure == surface_shear && point.has_bar("max_traction"))
      point.error_estimate.emplace(name, point.error_estimate.at("max_traction"));
    else if (maximum.measure == surface_shear && point.no_bar.count("max_traction") != 0)
      point.no_bar.emplace(name, point.no_bar.at("max_traction"));
    explain(name);
  }
  if (!point.subsurface.empty()) explain("subsurface_stress");
}

/// Error bars derived from others of the point: length and width of the patch from its semi-axes,
/// work of the creepages from forces and creepages. Existing bars are kept.
void derive_bars(PointResult& point) {
  const auto twice = [&](const char* extent, const char* half) {
    if (point.has_bar(half))
      point.error_estimate.emplace(extent, 2.0 * point.error_estimate.at(half));
  };
  twice("contact_length", "semi_axis_x");
  twice("contact_width", "semi_axis_y");
  if (point.has_bar("frictional_work") && point.revolution_work) {
    const double work = *point.frictional_work, bar = point.error_estimate.at("frictional_work");
    if (work > 0.0)
      point.error_estimate.emplace("revolution_work", bar * *point.revolution_work / work);
    else if (bar == 0.0)
      point.error_estimate.emplace("revolution_work", 0.0);
    else
      point.no_bar.emplace("revolution_work", NoBar::one_grid);
  }
  if (!point.creepage_work || !point.has_bar("longitudinal_force") ||
      !point.has_bar("lateral_force") || !point.has_bar("spin_moment"))
    return;
  const Creepage& c = point.creepage;
  const double of_forces =
      std::abs(c.longitudinal) * point.error_estimate.at("longitudinal_force") +
      std::abs(c.lateral) * point.error_estimate.at("lateral_force") +
      std::abs(c.spin) * point.error_estimate.at("spin_moment");
  const double of_creepages =
      std::abs(point.longitudinal_force) * point.bar_of("longitudinal_creepage").value_or(0.0) +
      std::abs(point.lateral_force) * point.bar_of("lateral_creepage").value_or(0.0);
  point.error_estimate.emplace("creepage_work", of_forces + of_creepages);
}

}  // namespace

void explain_bars(const Scene& scene, const BarRules& rules, ModelResult& result) {
  for (std::size_t k = 0; k < result.points.size(); ++k) {
    PointResult& point = result.points[k];
    if (result.points.size() == scene.points.size()) add_creepage_bars(scene.points[k], point);
    derive_bars(point);
    for (const Quantity& quantity : quantities()) {
      if (!quantity.value(point)) continue;
      if (is_given(scene, result, k, quantity.name) || is_relative(scene, quantity.name))
        point.error_estimate.erase(quantity.name);
      if (!point.has_bar(quantity.name))
        point.no_bar.emplace(quantity.name, reason_of(scene, rules, result, k, quantity));
    }
    explain_stresses(rules, point);
  }
}

std::string bar_text(const PointResult& point, const std::string& quantity, double scale) {
  if (const auto bar = point.bar_of(quantity)) return fmt::format("+- {:.2g}", *bar / scale);
  const auto word = point.no_bar.find(quantity);
  return word == point.no_bar.end() ? "" : word_of(word->second);
}

}  // namespace rollfem::contact
