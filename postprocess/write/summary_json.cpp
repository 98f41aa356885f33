// SPDX-License-Identifier: LGPL-2.1-or-later

#include "contact/result/bars.hpp"
#include "contact/result/patch_size.hpp"
#include "contact/result/quantities.hpp"
#include "postprocess/files/checkpoint_folder.hpp"
#include "postprocess/write/json_head.hpp"
#include "postprocess/write/output.hpp"
#include "postprocess/write/point_table.hpp"

#include <nlohmann/json.hpp>

namespace rollfem::postprocess {
namespace {

using nlohmann::ordered_json;

ordered_json part_json(const contact::PatchPart& part) {
  return {{"x", part.x},
          {"y", part.y},
          {"length", part.length},
          {"width", part.width},
          {"normal_force", part.normal_force},
          {"longitudinal_force", part.longitudinal_force},
          {"lateral_force", part.lateral_force},
          {"max_pressure", part.max_pressure},
          // Regions are distinguished only on the finest grid.
          {"no_bar", contact::no_bar::one_grid}};
}

ordered_json point_json(const contact::ModelResult& model, const contact::PointResult& point) {
  ordered_json json;
  for (const contact::Quantity& quantity : contact::quantities()) {
    const std::optional<double> value = quantity.value(point);
    if (!value) continue;
    switch (quantity.member.kind) {
      case contact::QuantityKind::number:
        json[quantity.name] = *value;
        break;
      case contact::QuantityKind::count:
        json[quantity.name] = static_cast<long>(*value);
        break;
      case contact::QuantityKind::truth:
        json[quantity.name] = *value != 0.0;
        break;
    }
  }
  json["error_estimate"] = ordered_json::object();
  for (const auto& [quantity, error] : point.error_estimate)
    json["error_estimate"][quantity] = error;
  json["no_bar"] = ordered_json::object();
  for (const auto& [quantity, word] : point.no_bar) json["no_bar"][quantity] = word;
  if (!point.model_error.empty()) json["model_error"] = point.model_error;
  if (!point.richardson.empty()) json["richardson"] = point.richardson;
  for (const contact::StressMaximum& maximum : point.stress_maxima)
    json["stress_maxima"].push_back({{"body", maximum.body},
                                     {"measure", maximum.measure},
                                     {"value", maximum.value},
                                     {"place", maximum.place}});
  for (const contact::YieldedSection& body : point.yielded) {
    ordered_json entry{
        {"body", body.body}, {"verdict", body.verdict}, {"from_pass", body.from_pass}};
    for (const auto& [name, value] : contact::scalars_of(body)) entry[name] = value;
    entry["iterations"] = body.iterations;
    json["yielded"].push_back(std::move(entry));
  }
  if (point.patch_count > 1)
    for (const contact::PatchPart& part : contact::patch_parts(model.grid, point.fields))
      json["patches"].push_back(part_json(part));
  return json;
}

ordered_json model_json(const contact::ModelResult& model, const contact::Case& input) {
  ordered_json json;
  json["name"] = model.name;
  if (!model.label.empty()) json["label"] = model.label;
  if (model.place) {
    json["place"] = {{"wheel", model.place->side()}};
    for (const PlaceScalar& scalar : place_scalars())
      json["place"][scalar.name] = scalar.value(*model.place);
    for (const WayScalar& way : ways_of(input))
      json["place"][way.name] = way.at(input, model.place->position);
  }
  json["seconds"] = ordered_json::object();
  for (const auto& [stage, seconds] : model.seconds) json["seconds"][stage] = seconds;
  json["unknowns"] = model.unknowns;
  json["contact_elements"] = model.contact_elements;
  if (!model.choice.empty()) {
    json["chosen_by"] = "auto";
    json["choice"] = model.choice;
  }
  json["notes"] = model.notes;
  json["model_error_source"] = model.model_error_source;
  json["points"] = ordered_json::array();
  for (const contact::PointResult& point : model.points)
    json["points"].push_back(point_json(model, point));
  return json;
}

}  // namespace

std::string summary_json(const RunRecord& run) {
  ordered_json json;
  json["format"] = 2;
  json["title"] = run.input.title;
  json["case_file"] = run.input.file;
  json["case_checksum"] = checksum_of_case(run.input);
  json["program"] = {{"version", run.provenance.version}, {"commit", run.provenance.commit}};
  json["verdict"] = run.verdict;
  json["models"] = ordered_json::array();
  for (const contact::ModelResult& model : run.models)
    json["models"].push_back(model_json(model, run.input));
  return json_text(json, 2);
}

}  // namespace rollfem::postprocess
