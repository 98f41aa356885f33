// SPDX-License-Identifier: LGPL-2.1-or-later
#include "result/bars.hpp"
#include "result/files/checkpoint_folder.hpp"
#include "result/patch_size.hpp"
#include "result/write/json_head.hpp"

#include <nlohmann/json.hpp>

namespace rollfem::result {
namespace {

using nlohmann::ordered_json;

ordered_json point_json(const contact::ModelResult& model, std::size_t number) {
  ordered_json json = json_of(point_tree(model, number, false));
  const contact::PointResult& point = model.points[number];
  if (point.patch_count > 1)
    for (const contact::PatchPart& part : contact::patch_parts(model.grid, point.fields)) {
      ordered_json& entry = json["patches"].emplace_back(ordered_json::object());
      contact::for_members(part, [&](const auto& each, double value) { entry[each.name] = value; });
      // Regions are distinguished only on the finest grid.
      entry["no_bar"] = word_of(contact::NoBar::one_grid);
    }
  return json;
}

ordered_json model_json(const contact::ModelResult& model, const contact::Case& input) {
  ordered_json json{{"name", model.name}};
  json.update(json_of(model_tree(model, input)));
  if (!model.choice.empty()) json["chosen_by"] = "auto";
  json["points"] = ordered_json::array();
  for (std::size_t k = 0; k < model.points.size(); ++k)
    json["points"].push_back(point_json(model, k));
  return json;
}

}  // namespace

std::string summary_json(const RunRecord& run) {
  ordered_json json;
  json["format"] = 3;
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

}  // namespace rollfem::result
