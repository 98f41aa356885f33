// SPDX-License-Identifier: LGPL-2.1-or-later
// Writes compare.json and compare.csv.
#include "postprocess/compare/comparison.hpp"
#include "postprocess/write/csv.hpp"
#include "postprocess/write/json_head.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <iterator>

namespace rollfem::postprocess {
namespace {

using nlohmann::ordered_json;

ordered_json standing_json(const Standing& standing) {
  ordered_json json;
  if (!standing.patch.empty()) json["patch"] = standing.patch;
  json["model"] = standing.model;
  json["reference"] = standing.reference;
  json["quantity"] = standing.quantity;
  json["compared"] = standing.compared;
  json["differ"] = standing.differ;
  json["largest_difference"] = standing.worst.difference();
  json["allowed_there"] = standing.worst.allowed();
  json["point"] = standing.worst.point;
  return json;
}

ordered_json case_json(const ComparedCase& compared, const CaseStandings& stand) {
  ordered_json json;
  json["name"] = compared.name;
  json["title"] = compared.title;
  json["case_file"] = compared.case_file;
  json["complete"] = !compared.models.empty();
  json["missing"] = ordered_json::array();
  for (const MissingModel& model : compared.missing)
    json["missing"].push_back(
        {{"model", model.model}, {"reason", model.reason}, {"failed", model.failed}});
  json["seconds"] = ordered_json::object();
  for (const auto& [model, seconds] : stand.seconds) json["seconds"][model] = seconds;
  json["standings"] = ordered_json::array();
  for (const Standing& standing : stand.standings)
    json["standings"].push_back(standing_json(standing));
  return json;
}

}  // namespace

std::string comparison_json(const ComparisonRecord& record) {
  ordered_json json = json_head(3, "compare", record.provenance);
  json["models"] = record.models;
  json["reference"] = record.reference;
  const std::vector<contact::Quantity> quantities = compared_quantities();
  json["quantities"] = headings_json(quantities);
  for (const contact::Quantity& quantity : quantities)
    json["quantities"][quantity.name]["relative_to"] = contact::text_of(quantity.scale);
  std::vector<CaseStandings> all;
  for (const ComparedCase& compared : record.cases)
    all.push_back(case_standings(compared, record.references));
  json["verdict"] = comparison_verdict(all);
  json["cases"] = ordered_json::array();
  for (std::size_t k = 0; k < all.size(); ++k)
    json["cases"].push_back(case_json(record.cases[k], all[k]));
  return json_text(json);
}

std::string comparison_csv(const ComparisonRecord& record) {
  std::string text =
      "case,patch,model,point,longitudinal_creepage [-],lateral_creepage [-],spin [rad/mm],"
      "quantity,value,error_estimate,model_error,reference,reference_value,reference_error,scale,"
      "difference [%],allowed by error bars [%],differs\n";
  auto out = std::back_inserter(text);
  for (const ComparedCase& compared : record.cases)
    for (const ComparedNumber& n : compared_numbers(compared, record.references)) {
      fmt::format_to(out, "{},{},{},{},{},{},{},{},{},{},{}", quoted(compared.name),
                     quoted(n.patch), n.model, n.point, n.longitudinal_creepage, n.lateral_creepage,
                     n.spin, n.quantity, n.value, csv_cell(n.error), csv_cell(n.model_error));
      if (n.reference_value)
        fmt::format_to(out, ",{},{},{},{},{},{},{}\n", n.reference, *n.reference_value,
                       n.reference_error, n.scale, 100.0 * n.difference(), 100.0 * n.allowed(),
                       n.differs() ? 1 : 0);
      else
        text += ",,,,,,,\n";
    }
  return text;
}

}  // namespace rollfem::postprocess
