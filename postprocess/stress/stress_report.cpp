// SPDX-License-Identifier: LGPL-2.1-or-later
#include "postprocess/stress/stress_report.hpp"

#include "contact/result/bars.hpp"
#include "contact/result/stress_extremes.hpp"
#include "postprocess/stress/shakedown.hpp"
#include "postprocess/write/csv.hpp"
#include "postprocess/write/json_head.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>

namespace rollfem::postprocess {
namespace {

using contact::PointResult;
using contact::StressMaximum;
using Json = nlohmann::ordered_json;

/// Name of the stored error bar of a largest stress, if `maximum` is that stress; otherwise empty.
std::string name_of_stored(const PointResult& point, const StressMaximum& maximum) {
  for (const StressMaximum& stored : point.stress_maxima)
    if (stored.body == maximum.body && stored.measure == maximum.measure &&
        stored.value == maximum.value)
      return fmt::format("max_{}_{}", maximum.measure, maximum.body);
  return {};
}

/// Stresses computed from a stored result have only its single grid.
std::string bar_of(const PointResult& point, const StressMaximum& maximum) {
  const std::string text = contact::bar_text(point, name_of_stored(point, maximum));
  return text.empty() ? contact::no_bar::one_grid : text;
}

/// Adds "error_estimate" or "no_bar" of a stress.
void add_bar(const PointResult& point, const StressMaximum& maximum, Json& entry) {
  const auto bar = point.error_estimate.find(name_of_stored(point, maximum));
  if (bar != point.error_estimate.end())
    entry["error_estimate"] = bar->second;
  else
    entry["no_bar"] = bar_of(point, maximum);
}

const char* body_of(const StressSet& set) {
  return set.field.request.wheel ? "wheel" : "rail";
}

std::vector<StressMaximum> largest(const StressSet& set) {
  return largest_stresses(body_of(set), set.field.points, set.field.stress);
}

Json maxima_json(const std::vector<StressMaximum>& maxima, const PointResult& point,
                 bool with_body) {
  Json list = Json::array();
  for (const StressMaximum& maximum : maxima) {
    Json entry;
    if (with_body) entry["body"] = maximum.body;
    entry["measure"] = maximum.measure;
    entry["value"] = maximum.value;
    if (point.max_pressure > 0.0) entry["over_max_pressure"] = maximum.value / point.max_pressure;
    entry["place"] = maximum.place;
    add_bar(point, maximum, entry);
    list.push_back(entry);
  }
  return list;
}

Json set_json(const StressSet& set, const PointResult& point) {
  const contact::SubsurfaceRequest& request = set.field.request;
  Json entry{{"name", set.name},
             {"kind", word_of(request.kind)},
             {"body", body_of(set)},
             {"points_along", request.points[0]},
             {"points_across", request.points[1]},
             {"moved", set.moved}};
  entry["largest"] = maxima_json(largest(set), point, false);
  return entry;
}

Json limits_json(const ShakedownLimits& limits, double load_factor) {
  return {{"elastic", limits.elastic},
          {"shakedown", limits.shakedown},
          {"region", shakedown_region(limits, load_factor)}};
}

/// Largest von Mises stress of the bodies over the yield value sqrt(3) k.
double yield_ratio(const std::vector<StressMaximum>& maxima, double k) {
  double most = 0.0;
  for (const StressMaximum& maximum : maxima)
    if (maximum.measure == "von_mises") most = std::max(most, maximum.value);
  return most / (std::sqrt(3.0) * k);
}

/// The computed stresses of a load point of the model; null if they were not requested.
const StressOfModel* chosen_at(const StressReport& report, const StressOfModel& model,
                               std::size_t number) {
  for (const StressOfModel& other : report.models)
    if (other.point == number && other.result.key() == model.result.key()) return &other;
  return nullptr;
}

/// Yield ratio of a load point: from the computed stresses of chosen load points, from stored ones
/// of the others; empty if nothing is stored.
std::optional<double> yield_ratio_at(const StressReport& report, const StressOfModel& model,
                                     std::size_t number, double k) {
  const StressOfModel* chosen = chosen_at(report, model, number);
  const auto& maxima =
      chosen != nullptr ? chosen->maxima : model.result.points[number].stress_maxima;
  if (chosen == nullptr && maxima.empty()) return std::nullopt;
  return yield_ratio(maxima, k);
}

/// The ellipse that fits the patch of the load point, or a line.
EllipseStress ellipse_of(const StressOfModel& model) {
  if (model.result.grid.is_line()) return EllipseStress(contact::infinity);
  const PointResult& point = model.result.points[model.point];
  return EllipseStress(point.semi_axis_x > 0.0 ? point.semi_axis_y / point.semi_axis_x : 1.0);
}

/// State of the material: first yield from the computed stress if known, otherwise from the lower
/// elastic limit of line and circle; shakedown from the limit of the ellipse.
std::string verdict(double load_factor, double traction, double shakedown_limit,
                    std::optional<double> ratio) {
  const double elastic =
      std::min(line_contact_limits(traction).elastic, point_contact_limits(traction).elastic);
  if (load_factor > shakedown_limit) return "beyond shakedown";
  return (ratio ? *ratio < 1.0 : load_factor <= elastic) ? "elastic" : "elastic shakedown";
}

/// The distance of the load point from the shakedown limit at its tangential coefficient.
std::string margin(double load_factor, double shakedown_limit) {
  return fmt::format("p0 is {:.2g} % {} the limit",
                     100.0 * std::abs(load_factor / shakedown_limit - 1.0),
                     load_factor > shakedown_limit ? "above" : "below");
}

/// All load points in the map.
Json shakedown_json(const StressReport& report, const StressOfModel& model, double k) {
  Json list = Json::array();
  const EllipseStress ellipse = ellipse_of(model);
  for (std::size_t number = 0; number < model.result.points.size(); ++number) {
    const PointResult& point = model.result.points[number];
    const double traction = tangential_coefficient(point);
    const double factor = point.max_pressure / k;
    list.push_back({{"point", number + 1},
                    {"longitudinal_creepage", point.creepage.longitudinal},
                    {"tangential_coefficient", traction},
                    {"load_factor", factor},
                    {"max_traction_over_k", point.max_traction / k},
                    {"surface_fatigue_index", surface_fatigue_index(traction, factor)},
                    {"line", limits_json(line_contact_limits(traction), factor)},
                    {"circle", limits_json(point_contact_limits(traction), factor)}});
    const auto ratio = yield_ratio_at(report, model, number, k);
    const double limit = ellipse.shakedown_limit(traction);
    list.back()["ellipse"] = {{"ratio", ellipse.ratio()}, {"shakedown", limit}};
    list.back()["verdict"] = verdict(factor, traction, limit, ratio);
    list.back()["margin"] = margin(factor, limit);
    if (ratio) list.back()["yield_ratio"] = *ratio;
  }
  return list;
}

/// Boundaries of the map as curves, for drawing.
Json map_json(const EllipseStress& ellipse) {
  Json map{{"ellipse_ratio", ellipse.ratio()}};
  for (int step = 0; step <= 60; ++step) {
    const double traction = 0.01 * step;
    const ShakedownLimits line = line_contact_limits(traction);
    const ShakedownLimits circle = point_contact_limits(traction);
    map["tangential_coefficient"].push_back(traction);
    map["line_elastic"].push_back(line.elastic);
    map["line_shakedown"].push_back(line.shakedown);
    map["circle_elastic"].push_back(circle.elastic);
    map["circle_shakedown"].push_back(circle.shakedown);
    map["ellipse_shakedown"].push_back(ellipse.shakedown_limit(traction));
  }
  return map;
}

std::string heading(const StressOfModel& model, bool named) {
  const PointResult& point = model.result.points[model.point];
  const std::size_t count = model.result.points.size();
  std::string text = fmt::format("{}: load point {}", model.result.key(), model.point + 1);
  if (!named && count > 1)
    text += fmt::format(" (the last of {}; others: --point 1 to {}, --creepage)", count, count);
  if (point.step > 0)
    text += fmt::format(" (step {})", point.step);
  else
    text += fmt::format(", xi = {:g}, eta = {:g}, spin = {:g} rad/mm", point.creepage.longitudinal,
                        point.creepage.lateral, point.creepage.spin);
  return text + fmt::format("; F_z = {:g} N ({}), p0 = {:.2f} MPa ({}), T/F_z = {:.4f}\n",
                            point.normal_force, contact::bar_text(point, "normal_force"),
                            point.max_pressure, contact::bar_text(point, "max_pressure"),
                            tangential_coefficient(point));
}

std::string row(const std::string& what, const StressMaximum& maximum, const PointResult& point) {
  const double pressure = point.max_pressure;
  const auto& p = maximum.place;
  // Avoids printing -0.000.
  const auto zero = [](double value) { return std::abs(value) < 5e-4 ? 0.0 : value; };
  return fmt::format("  {:<22}{:<6} {:<25}{:>10.2f} {:<14}{:>8.4f}{:>10.3f}{:>9.3f}{:>9.3f}\n",
                     what, maximum.body, maximum.measure, maximum.value, bar_of(point, maximum),
                     pressure > 0.0 ? maximum.value / pressure : 0.0, zero(p[0]), zero(p[1]),
                     zero(p[2]));
}

/// Shakedown table of all load points of a model.
std::string shakedown_table(const StressReport& report, const StressOfModel& model, double k) {
  const EllipseStress ellipse = ellipse_of(model);
  std::string text = fmt::format(
      "\n  shakedown map, k = {:.1f} MPa (yield stress in shear); limit of p0/k of {}\n"
      "  {:<6}{:>11}{:>8}{:>8}{:>10}{:>9}{:>8}  {}\n",
      k,
      ellipse.is_line() ? "the line contact"
                        : fmt::format("the ellipse that fits, b/a = {:.2f}", ellipse.ratio()),
      "point", "xi", "T/F_z", "p0/k", "limit", "FI_surf", "Y-ratio",
      "verdict, and margin to the limit");
  for (std::size_t number = 0; number < model.result.points.size(); ++number) {
    const PointResult& point = model.result.points[number];
    const double traction = tangential_coefficient(point);
    const double factor = point.max_pressure / k, limit = ellipse.shakedown_limit(traction);
    const std::optional<double> ratio = yield_ratio_at(report, model, number, k);
    text += fmt::format("  {:<6}{:>11g}{:>8.4f}{:>8.3f}{:>10.2f}{:>9.3f}{:>8}  {}; {}{}\n",
                        number + 1, point.creepage.longitudinal, traction, factor, limit,
                        surface_fatigue_index(traction, factor),
                        ratio ? fmt::format("{:.3f}", *ratio) : "-",
                        verdict(factor, traction, limit, ratio), margin(factor, limit),
                        chosen_at(report, model, number) ? "  <" : "");
  }
  return text +
         "  elastic: the largest von Mises stress is below sqrt(3) k (Y-ratio; if unknown, p0 "
         "below the limits of line and circle); shakedown: under full slip, at the same T/F_z\n";
}

}  // namespace

std::vector<StressMaximum> largest_stresses(const std::string& body,
                                            const std::vector<std::array<double, 3>>& places,
                                            const std::vector<std::array<double, 6>>& stress,
                                            double least_depth, double below) {
  const auto depth = [&](std::size_t k) { return std::abs(places[k][2]); };
  bool on_surface = true;
  for (std::size_t k = 0; k < places.size(); ++k) on_surface = on_surface && depth(k) <= below;
  std::vector<StressMaximum> found;
  for (const contact::StressMeasure& measure : contact::reported_measures()) {
    const bool only_below = contact::only_below(measure) && !on_surface;
    const char* name =
        contact::only_below(measure) && on_surface ? contact::surface_shear : measure.name;
    StressMaximum best{body, name, -contact::infinity, {}};
    for (std::size_t k = 0; k < stress.size(); ++k) {
      if (only_below ? depth(k) <= below : depth(k) > 0.0 && depth(k) < least_depth) continue;
      const double value = measure.value(contact::Stress::from_array(stress[k]));
      if (value > best.value) best = {body, name, value, places[k]};
    }
    found.push_back(best);
  }
  return found;
}

double tangential_coefficient(const PointResult& point) {
  if (!(point.normal_force > 0.0)) return 0.0;
  // On a curved patch the pressure, too, acts across.
  return std::hypot(point.longitudinal_force, point.lateral_force - point.lateral_pressure) /
         point.normal_force;
}

std::string stress_csv(const StressReport& report) {
  std::string text = "model,point,set,body," + subsurface_columns() + "\n";
  for (const StressOfModel& model : report.models)
    for (const StressSet& set : model.sets)
      for (std::size_t k = 0; k < set.field.points.size(); ++k)
        fmt::format_to(std::back_inserter(text), "{},{},{},{},{}\n", model.result.key(),
                       model.point + 1, set.name, body_of(set), subsurface_row(set.field, k));
  return text;
}

std::string stress_json(const StressReport& report) {
  Json json{{"format", 2}, {"source", report.source}, {"title", report.title}};
  const auto& k = report.yield_shear_stress;
  if (k) json["yield_shear_stress"] = *k;
  json["models"] = Json::array();
  for (const StressOfModel& model : report.models) {
    const PointResult& point = model.result.points[model.point];
    Json entry{{"name", model.result.name}, {"key", model.result.key()}};
    if (!model.result.label.empty()) entry["label"] = model.result.label;
    if (model.result.place) entry["place"] = place_json(*model.result.place);
    entry["point"] = model.point + 1;
    entry["longitudinal_creepage"] = point.creepage.longitudinal;
    entry["lateral_creepage"] = point.creepage.lateral;
    entry["spin"] = point.creepage.spin;
    entry["step"] = point.step;
    entry["normal_force"] = point.normal_force;
    entry["max_pressure"] = point.max_pressure;
    entry["max_traction"] = point.max_traction;
    entry["tangential_coefficient"] = tangential_coefficient(point);
    entry["maxima"] = maxima_json(model.maxima, point, true);
    entry["sets"] = Json::array();
    for (const StressSet& set : model.sets) entry["sets"].push_back(set_json(set, point));
    if (k) {
      entry["yield_ratio"] = yield_ratio(model.maxima, *k);
      entry["shakedown"] = shakedown_json(report, model, *k);
    }
    json["models"].push_back(entry);
  }
  if (k) json["shakedown_map"] = map_json(ellipse_of(report.models.front()));
  return json_text(json, 2);
}

std::string stress_table(const StressReport& report) {
  std::string text = report.title + "\n" + report.source + "\n";
  for (const StressOfModel& model : report.models) {
    const PointResult& point = model.result.points[model.point];
    text += fmt::format("\n{}  {:<22}{:<6} {:<25}{:>10} {:<14}{:>8}{:>10}{:>9}{:>9}\n",
                        heading(model, report.point_named), "largest", "body", "stress", "MPa",
                        "+-", "of p0", "x in mm", "y", "z");
    for (const StressMaximum& maximum : model.maxima) text += row("of the body", maximum, point);
    for (const StressSet& set : model.sets)
      for (const StressMaximum& maximum : largest(set)) text += row(set.name, maximum, point);
    const bool last_of_model =
        &model == &report.models.back() || (&model)[1].result.key() != model.result.key();
    if (report.yield_shear_stress && last_of_model)
      text += shakedown_table(report, model, *report.yield_shear_stress);
  }
  return text;
}

}  // namespace rollfem::postprocess
