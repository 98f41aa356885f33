// SPDX-License-Identifier: LGPL-2.1-or-later
#include "app/run/run_table.hpp"

#include "result/bars.hpp"
#include "result/derived.hpp"
#include "result/quantities.hpp"
#include "result/write/contents.hpp"
#include "result/write/wheelset_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>
#include <utility>

namespace rollfem::app {

namespace {

using contact::ModelResult;
using contact::PointResult;

/// Ignores the residue of a search for zero creepage.
bool any_motion(const std::vector<PointResult>& points, const char* name) {
  return std::any_of(points.begin(), points.end(), [&](const PointResult& point) {
    return std::abs(contact::quantity(point, name)) > 1e-15;
  });
}

/// Row below the values of a model: their bars, or why there are none.
std::string bar_row(const PointResult& point) {
  std::string text = fmt::format("{:<19}", "");
  const std::pair<const char*, int> columns[] = {{"max_pressure", 12},
                                                 {"semi_axis_x", 13},
                                                 {"semi_axis_y", 13},
                                                 {"approach", 15},
                                                 {"normal_force", 13}};
  for (const auto& [name, width] : columns)
    text += fmt::format(" {:>{}}", contact::bar_text(point, name), width - 1);
  return text + "\n";
}

/// Patch at the headline of every model.
std::string patch_table(const std::vector<ModelResult>& models) {
  std::string text =
      fmt::format("{:<19}{:>12}{:>13}{:>13}{:>15}{:>13}{:>10}\n", "model", "p0 in MPa", "a in mm",
                  "b in mm", "approach in mm", "F_z in N", "seconds");
  for (const ModelResult& model : models) {
    if (model.points.empty()) continue;
    const PointResult& point = model.points[result::headline(model)];
    text += fmt::format("{:<19}{:>12.3f}{:>13.4f}{:>13.4f}{:>15.7f}{:>13.6g}{:>10.2f}\n",
                        model.name, point.max_pressure, point.semi_axis_x, point.semi_axis_y,
                        point.approach, point.normal_force, model.total_seconds());
    text += bar_row(point);
  }
  return text;
}

/// What the headline of bodies that yield says of the steel, and the verdict on each; empty if
/// nothing yields.
std::string yielded_lines(const std::vector<ModelResult>& models) {
  std::string text;
  for (const ModelResult& model : models) {
    if (model.points.empty()) continue;
    const std::size_t at = result::headline(model);
    const PointResult& point = model.points[at];
    if (point.yielded.empty()) continue;
    text += fmt::format("\n{} after {} {} of {}, which the numbers above are of:\n", model.name,
                        point.forward_flow ? "pass" : "step", at + 1, model.points.size());
    for (const auto& [name, unit, scale] : {std::tuple{"residual_stress", "MPa", 1.0},
                                            {"plastic_increment", "%", 0.01},
                                            {"net_plastic_increment", "%", 0.01},
                                            {"groove_depth", "um", 1e-3}})
      if (const auto value = contact::quantity_named(name).value(point))
        text += fmt::format("  {:<30} {:>9.4g} {:<3} {}\n", contact::quantity_named(name).title,
                            *value / scale, unit, contact::bar_text(point, name, scale));
    for (const contact::YieldedSection& body : point.yielded)
      text += fmt::format("  {}: {}\n", body.body, body.finding);
  }
  return text;
}

/// Column width, enough for the heading and for the model error.
std::size_t width_of(const ModelResult& model) {
  return std::max<std::size_t>(model.has_model_error() ? 38 : 24, model.name.size() + 2);
}

/// "0.21601 +- 0.0012", with the model error if known: "0.20970 +- 1.7e-05, model 0.0062". The
/// bars of the quantity are divided by `scale`.
std::string barred(const std::string& value, const PointResult& point, const char* quantity,
                   double scale) {
  std::string text = contact::bar_text(point, quantity, scale);
  if (const auto error = point.model_error.find(quantity); error != point.model_error.end())
    text += fmt::format(", model {:.2g}", error->second / scale);
  return fmt::format("{} {:<10}", value, text);
}

/// Never -0.00000.
std::string five_digits(double value) {
  return fmt::format("{:.5f}", std::abs(value) < 5e-6 ? 0.0 : value);
}

/// A motion that may be given, or found for a force, which then stands in its place.
struct Motion {
  const char *name, *heading, *force, *force_heading;
};
constexpr Motion motions[] = {{"longitudinal_creepage", "xi", "longitudinal_force", "F_x in N"},
                              {"lateral_creepage", "eta", "lateral_force", "F_y in N"},
                              {"spin", "phi", "", ""},
                              {"longitudinal_shift", "", "longitudinal_force", "F_x in N"},
                              {"lateral_shift", "", "lateral_force", "F_y in N"}};

/// Whether a motion is a result at one of the load points.
bool is_found(const std::vector<PointResult>& points, const char* name) {
  return std::any_of(points.begin(), points.end(), [&](const PointResult& point) {
    return contact::found_for_force(point, name);
  });
}

/// Quantities and headings of the columns that tell load points apart: the step, or xi, even where
/// it is 0, and whatever else is given.
std::vector<std::pair<const char*, const char*>> given_columns(
    const std::vector<PointResult>& points) {
  std::vector<std::pair<const char*, const char*>> columns;
  if (points.front().step > 0) columns.emplace_back("step", "step");
  for (const Motion& motion : motions) {
    if (is_found(points, motion.name))
      columns.emplace_back(motion.force, motion.force_heading);
    else if (*motion.heading != '\0' && (columns.empty() || any_motion(points, motion.name)))
      columns.emplace_back(motion.name, motion.heading);
  }
  return columns;
}

/// Table with one row per load point and one column per model.
template <class Quantity>
std::string curve_table(const std::vector<const ModelResult*>& models, const std::string& heading,
                        const Quantity& quantity) {
  const auto& points = models.front()->points;
  const auto given = given_columns(points);
  const auto text_of = [](const PointResult& point, const auto& name) {
    return fmt::format("{:.6g}", contact::quantity(point, name));
  };
  std::size_t width = 12;
  for (const auto& [name, head] : given)
    for (const PointResult& point : points)
      width = std::max(width, text_of(point, name).size() + 2);
  std::string text = fmt::format("\n{}\n", heading);
  for (const auto& [name, head] : given) text += fmt::format("{:<{}}", head, width);
  for (const ModelResult* model : models)
    text += fmt::format("{:>{}}", model->name, width_of(*model));
  for (std::size_t k = 0; k < points.size(); ++k) {
    text += '\n';
    for (const auto& [name, head] : given)
      text += fmt::format("{:<{}}", text_of(points[k], name), width);
    for (const ModelResult* model : models) {
      if (k >= model->points.size() || !contact::is_solved(model->points[k])) {
        text += fmt::format("{:>{}}", "-", width_of(*model));
        continue;
      }
      text += fmt::format(" {:>{}}", quantity(model->points[k]), width_of(*model) - 1);
    }
  }
  return text + "\n";
}

/// All tables of one patch.
std::string scene_table(const std::vector<ModelResult>& models) {
  std::string text = patch_table(models) + yielded_lines(models);
  std::vector<const ModelResult*> with_friction;
  for (const ModelResult& model : models)
    if (model.has_friction()) with_friction.push_back(&model);
  if (with_friction.empty()) return text;
  const auto& points = with_friction.front()->points;
  std::set<std::string> given;
  for (const auto& [name, symbol, force, heading] : motions) {
    if (!is_found(points, name)) continue;
    given.insert(force);
    text += curve_table(
        with_friction,
        fmt::format("{}{}{}, found for the given {:.3}", contact::quantity_named(name).title,
                    *symbol ? " " : " in mm", symbol, heading),
        [name = name](const PointResult& point) {
          return barred(fmt::format("{:.6g}", contact::quantity(point, name)), point, name, 1.0);
        });
  }
  if (given.count("longitudinal_force") == 0)
    text += curve_table(with_friction, "traction coefficient -F_x/F_z (forces on the wheel)",
                        [](const PointResult& point) {
                          return barred(five_digits(point.traction_coefficient), point,
                                        "traction_coefficient", 1.0);
                        });
  if (points.front().max_temperature)
    text += curve_table(
        with_friction, "largest temperature of the surfaces in degC", [](const PointResult& point) {
          return point.max_temperature ? barred(fmt::format("{:.1f}", *point.max_temperature),
                                                point, "max_temperature", 1.0)
                                       : std::string("-");
        });
  if ((any_motion(points, "lateral_creepage") || any_motion(points, "spin")) &&
      given.count("lateral_force") == 0)
    text += curve_table(with_friction, "lateral coefficient -F_y/F_z (forces on the wheel)",
                        [](const PointResult& point) {
                          return barred(five_digits(-point.lateral_force / point.normal_force),
                                        point, "lateral_force", point.normal_force);
                        });
  return text;
}

std::string place_line(const contact::ContactPlace& place) {
  return fmt::format(
      "{}: y = {:.4f} mm on the track, {:.4f} on the rail, {:.4f} on the wheel; angle {:.5f} rad, "
      "rolling radius {:.4f} mm\n",
      place.label(" wheel"), place.y_track, place.y_rail, place.y_wheel, place.contact_angle,
      place.rolling_radius);
}

/// More patches than this get one line each.
constexpr std::size_t most_tables = 3;

/// "0.3052 +- 0.0028"
std::string with_bar(const std::string& value, const PointResult& point, const char* quantity) {
  return value + ' ' + contact::bar_text(point, quantity);
}

/// What distinguishes the positions: heading and value of each key that differs between them.
struct Varied {
  std::string heading;
  std::vector<double> values;  ///< by position
};
std::vector<Varied> varied(const contact::Case& input) {
  const contact::Wheelset& wheelset = input.wheelset;
  const char* const shift = wheelset.on_rail ? "lateral mm" : "shift mm";
  std::vector<Varied> all{{shift, wheelset.lateral_shift}, {"yaw mrad", wheelset.yaw}};
  for (double& yaw : all[1].values) yaw *= 1e3;
  for (const result::WayScalar& way : result::ways_of(input))
    all.push_back({*way.unit == 'm' ? "along mm" : "angle rad", wheelset.*way.list});
  all.erase(std::remove_if(all.begin(), all.end(),
                           [](const Varied& one) {
                             return std::all_of(one.values.begin(), one.values.end(),
                                                [&](double v) { return v == one.values.front(); });
                           }),
            all.end());
  return all;
}

/// One line per result: what was varied, place, size and the headline with its bars.
std::string row_table(const std::vector<ModelResult>& models, const contact::Case& input) {
  const std::vector<Varied> given = varied(input);
  const bool moves = !result::ways_of(input).empty();
  std::string text = fmt::format("{:<6}{:>4}{:>6}", "wheel", "pos", "patch");
  for (const Varied& one : given) text += fmt::format("{:>11}", one.heading);
  if (moves) text += fmt::format("{:>11}", "height mm");
  text += fmt::format("{:>10}{:>11}{:>10}  {:<12}{:>9}{:>10}{:>10}{:>23}{:>13}{:>23}\n",
                      "y rail mm", "y wheel mm", "angle rad", "model", "F_n N", "length mm",
                      "width mm", "p0 MPa", "xi", "-F_x/F_z");
  for (const ModelResult& model : models) {
    if (model.points.empty() || !model.place) continue;
    const contact::ContactPlace& place = *model.place;
    const PointResult& point = model.points[result::headline(model)];
    const double coefficient =
        std::abs(point.traction_coefficient) < 5e-5 ? 0.0 : point.traction_coefficient;
    text += fmt::format("{:<6}{:>4}{:>6}", place.side(), place.position, place.patch);
    for (const Varied& one : given)
      text += fmt::format("{:>11.6g}", one.values[static_cast<std::size_t>(place.position) - 1]);
    if (moves) text += fmt::format("{:>11.4f}", point.loaded_height.value_or(place.height));
    text += fmt::format(
        "{:>10.4f}{:>11.4f}{:>10.4f}  {:<12} {:>8.5g} {:>9.3f} {:>9.3f} {:>22} {:>12.4e} {:>22}\n",
        place.y_rail, place.y_wheel, place.contact_angle, model.name, point.normal_force,
        point.contact_length, point.contact_width,
        with_bar(fmt::format("{:.2f}", point.max_pressure), point, "max_pressure"),
        point.creepage.longitudinal,
        with_bar(fmt::format("{:.4f}", coefficient), point, "traction_coefficient"));
  }
  if (moves)
    text += "height: of the middle of the axle plus the nominal radius, under load, down\n";
  return text;
}

/// The largest model errors of all load points: "p0 12 MPa, a 0.02 mm".
std::string largest_model_errors(const ModelResult& model) {
  std::string text;
  for (const auto& [name, format] : {std::pair{"max_pressure", "p0 {:.2g} MPa"},
                                     {"semi_axis_x", "a {:.2g} mm"},
                                     {"semi_axis_y", "b {:.2g} mm"},
                                     {"traction_coefficient", "-F_x/F_z {:.2g}"}}) {
    double largest = 0.0;
    for (const PointResult& point : model.points)
      if (const auto found = point.model_error.find(name); found != point.model_error.end())
        largest = std::max(largest, found->second);
    if (largest > 0.0)
      text += (text.empty() ? "" : ", ") + fmt::format(fmt::runtime(format), largest);
  }
  return text;
}

/// The note on model errors stands with their numbers, and not at all without errors or failure.
std::string printed(const ModelResult& model, const contact::Note& note) {
  const bool warns = note.severity == contact::Note::warning;
  if (note.about != contact::about_model_error) return (warns ? "warning: " : "") + note.text;
  if (warns) return "warning: model error " + note.text;
  const std::string errors = largest_model_errors(model);
  if (errors.empty()) return {};
  return fmt::format("model error beside the bars, the largest of all load points: {} ({})", errors,
                     note.text);
}

}  // namespace

std::string run_table(const result::RunRecord& record) {
  const std::vector<ModelResult>& models = record.models;
  std::vector<std::vector<ModelResult>> scenes;
  for (const ModelResult& model : models) {
    const auto same = [&](const std::vector<ModelResult>& scene) {
      const auto& place = scene.front().place;
      return !place || !model.place || place->same_patch(*model.place);
    };
    const auto found = std::find_if(scenes.begin(), scenes.end(), same);
    if (found == scenes.end())
      scenes.push_back({model});
    else
      found->push_back(model);
  }
  std::string text;
  if (scenes.size() > most_tables) {
    text = row_table(models, record.input);
    for (const result::WheelDip& dip : result::wheel_dips(record))
      if (dip.model == models.front().name)
        text += fmt::format(
            "\n{} wheel: lowest at {:g} mm, {:.3f} mm down; dip angle {:.2f} mrad (steepest fall "
            "before and rise after it)\n",
            dip.wheel, dip.track_position, dip.loaded_height, 1e3 * dip.dip_angle);
    return text;
  }
  for (const auto& scene : scenes) {
    if (!text.empty()) text += '\n';
    if (scene.front().place) text += place_line(*scene.front().place);
    text += scene_table(scene);
  }
  return text;
}

std::string notes_text(const std::vector<ModelResult>& models, contact::Note::Severity severity) {
  struct Said {
    std::string model, about, text, place;
    std::set<std::string> others = {};  // patches with other numbers
  };
  std::vector<Said> all;
  for (const ModelResult& model : models)
    for (const contact::Note& note : model.notes) {
      std::string text = note.severity == severity ? printed(model, note) : "";
      if (text.empty()) continue;
      const auto same = [&](const Said& said) {
        return said.model == model.name && said.about == note.about;
      };
      const auto found = std::find_if(all.begin(), all.end(), same);
      if (found == all.end())
        all.push_back({model.name, note.about, std::move(text),
                       model.place ? model.place->label(" wheel") : ""});
      else if (found->text != text)
        found->others.insert(model.key());
    }
  std::string text;
  for (const Said& said : all) {
    text += said.model + ": " + said.text;
    if (!said.others.empty())
      text += fmt::format(" ({}; values differ for {})", said.place,
                          said.others.size() == 1
                              ? "1 other patch"
                              : fmt::format("{} other patches", said.others.size()));
    text += '\n';
  }
  return text;
}

}  // namespace rollfem::app
