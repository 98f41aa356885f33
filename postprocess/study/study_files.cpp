// SPDX-License-Identifier: LGPL-2.1-or-later
// Writes study.json and study.csv.
#include "postprocess/study/study.hpp"
#include "postprocess/write/csv.hpp"
#include "postprocess/write/json_head.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <iterator>

namespace rollfem::postprocess {
namespace {

using nlohmann::ordered_json;
using References = std::map<std::string, StudyReference>;

ordered_json level_json(const StudyLevel& level) {
  return {{"label", level.label},
          {"parameter", level.parameter},
          {"unknowns", level.unknowns},
          {"contact_elements", level.contact_elements},
          {"seconds", level.seconds}};
}

ordered_json limits_json(const StudySeries& series, const References& refs) {
  ordered_json json = ordered_json::object();
  for (const auto& entry : refs)
    if (const auto limit = series_limit(series, entry.first)) {
      ordered_json& out = json[entry.first];
      if (limit->order) {
        out["order"] = *limit->order;
        out["fitted"] = limit->fitted;
      } else {
        out["no_order_because"] = limit->reason;
      }
      out["settled"] = limit->settled;
      out["value"] = limit->value;
      out["uncertainty"] = limit->uncertainty;
      out["uncertainty_of_finest"] = limit->grid_uncertainty;
    }
  return json;
}

ordered_json references_json(const References& refs) {
  ordered_json json = ordered_json::object();
  for (const auto& [key, reference] : refs)
    json[key] = {{"value", reference.value},
                 {"uncertainty", reference.uncertainty},
                 {"kind", reference.kind},
                 {"relative_to", percent_of(key)}};
  return json;
}

ordered_json series_json(const StudyRecord& record, const StudyPlace& place,
                         const StudySeries& series) {
  const References refs = references(place, series, record.rule);
  ordered_json json{{"model", series.model},           {"vary", series.vary},
                    {"parameter", series.parameter},   {"ratio", series.ratio},
                    {"failure", series.failure},       {"left_out", series.left_out},
                    {"levels", ordered_json::array()}, {"limits", limits_json(series, refs)}};
  for (const StudyLevel& level : series.levels) json["levels"].push_back(level_json(level));
  json["references"] = references_json(refs);
  for (const auto& [key, difference] : model_differences(record, place, series))
    json["model_differences"][key] = {{"value", difference.value},
                                      {"uncertainty", difference.uncertainty},
                                      {"relative_to", percent_of(key)}};
  return json;
}

ordered_json place_json(const StudyRecord& record, const StudyPlace& place) {
  const StudySeries& base = place.series.at(reference_series(place));
  ordered_json json{{"key", place_key(place)}, {"name", place_name(place)}};
  if (place.place) {
    json["lateral_shift"] = place.place->lateral_shift;
    json["yaw"] = place.place->yaw;
  }
  json["points"] = ordered_json::array();
  for (const contact::Creepage& creepage : place.creepages)
    json["points"].push_back({{"longitudinal_creepage", creepage.longitudinal},
                              {"lateral_creepage", creepage.lateral},
                              {"spin", creepage.spin}});
  json["reference"] = base.model;
  json["references"] = references_json(references(place, base, record.rule));
  json["series"] = ordered_json::array();
  for (const StudySeries& series : place.series)
    json["series"].push_back(series_json(record, place, series));
  return json;
}

/// Cells ",reference,uncertainty,kind,error,percent of,order" of a value; missing entries are
/// empty.
std::string reference_cells(const StudyRecord& record, const StudySeries& series,
                            const std::string& key, const StudyLevel& level,
                            const References& refs) {
  const auto reference = refs.find(key);
  if (reference == refs.end()) return ",,,,,,";
  std::size_t k = 0;  // index among the levels with the key
  for (const StudyLevel& other : series.levels) {
    if (&other == &level) break;
    if (other.values.count(key) > 0) ++k;
  }
  const auto order = level_orders(record, series, key, reference->second).at(k);
  return fmt::format(",{},{},{},{},{},{}", reference->second.value, reference->second.uncertainty,
                     reference->second.kind,
                     study_error(record, key, level.values.at(key), reference->second),
                     percent_of(key), csv_cell(order));
}

}  // namespace

std::string study_json(const StudyRecord& record) {
  ordered_json json = json_head(4, "study", record.provenance);
  json["title"] = record.title;
  json["case_file"] = record.case_file;
  json["case_text"] = record.case_text;
  json["friction_coefficient"] = record.friction;
  json["notes"] = record.notes;
  json["quantities"] = headings_json(contact::quantities());
  json["verdict"] = study_verdict(record);
  json["places"] = ordered_json::array();
  for (const StudyPlace& place : record.places) json["places"].push_back(place_json(record, place));
  return json_text(json);
}

std::string study_csv(const StudyRecord& record) {
  std::string text =
      "place,model,vary,level,parameter,unknowns,contact_elements,seconds [s],quantity,value,"
      "error_estimate,reference,reference_uncertainty,reference_kind,error [-],relative_to,"
      "order [-]\n";
  auto out = std::back_inserter(text);
  for (const StudyPlace& place : record.places) {
    for (const StudySeries& series : place.series) {
      const References refs = references(place, series, record.rule);
      for (const StudyLevel& level : series.levels) {
        // Labels of several things refined together have commas.
        const bool several = level.label.find(',') != std::string::npos;
        const std::string label = several ? quoted(level.label) : level.label;
        for (const auto& [key, value] : level.values)
          fmt::format_to(out, "{},{},{},{},{},{},{},{},{},{},{}{}\n", place_key(place),
                         series.model, series.vary, label, level.parameter, level.unknowns,
                         level.contact_elements, level.seconds, key, value,
                         csv_cell(bar_of(level, key)),
                         reference_cells(record, series, key, level, refs));
      }
    }
  }
  return text;
}

}  // namespace rollfem::postprocess
