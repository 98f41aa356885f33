// study.json and study.csv.
#include "postprocess/study.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <iterator>

namespace rollfem::postprocess {
namespace {

using nlohmann::ordered_json;
using References = std::map<std::string, StudyReference>;

ordered_json level_json(const StudyRecord& record, const StudyLevel& level,
                        const References& refs) {
  ordered_json json{{"label", level.label},
                    {"parameter", level.parameter},
                    {"unknowns", level.unknowns},
                    {"contact_elements", level.contact_elements},
                    {"seconds", level.seconds},
                    {"values", ordered_json::object()},
                    {"errors", ordered_json::object()}};
  for (const auto& [key, value] : level.values) {
    json["values"][key] = value;
    if (const auto reference = refs.find(key); reference != refs.end())
      json["errors"][key] = study_error(record, key, value, reference->second);
  }
  return json;
}

ordered_json limits_json(const StudySeries& series, const References& refs) {
  ordered_json json = ordered_json::object();
  for (const auto& entry : refs)
    if (const auto limit = series_limit(series, entry.first)) {
      ordered_json& out = json[entry.first];
      if (limit->order)
        out["order"] = *limit->order;
      else
        out["no_order_because"] = limit->reason;
      out["value"] = limit->value;
      out["uncertainty"] = limit->uncertainty;
      out["uncertainty_of_finest"] = limit->grid_uncertainty;
    }
  return json;
}

}  // namespace

std::string study_json(const StudyRecord& record) {
  const References refs = references(record);
  ordered_json json;
  json["format"] = 1;
  json["kind"] = "study";
  json["program"] = {{"version", record.provenance.version}, {"commit", record.provenance.commit}};
  json["host"] = record.provenance.host;
  json["started"] = record.provenance.started;
  json["command"] = record.provenance.command;
  json["title"] = record.title;
  json["case_file"] = record.case_file;
  json["case_text"] = record.case_text;
  json["friction_coefficient"] = record.friction;
  json["points"] = ordered_json::array();
  for (const contact::Creepage& creepage : record.creepages)
    json["points"].push_back({{"longitudinal_creepage", creepage.longitudinal},
                              {"lateral_creepage", creepage.lateral},
                              {"spin", creepage.spin}});
  json["words"] = study_words(record);
  json["references"] = ordered_json::object();
  for (const auto& [key, reference] : refs)
    json["references"][key] = {{"value", reference.value},
                               {"uncertainty", reference.uncertainty},
                               {"kind", reference.kind}};
  json["series"] = ordered_json::array();
  for (const StudySeries& series : record.series) {
    ordered_json one{{"model", series.model},
                     {"vary", series.vary},
                     {"parameter", series.parameter},
                     {"ratio", series.ratio},
                     {"failure", series.failure},
                     {"levels", ordered_json::array()},
                     {"limits", limits_json(series, refs)}};
    for (const StudyLevel& level : series.levels)
      one["levels"].push_back(level_json(record, level, refs));
    for (const auto& [key, reference] : refs) {
      const auto orders = level_orders(record, series, key, reference);
      std::size_t k = 0;
      for (ordered_json& level : one["levels"])
        if (level["values"].contains(key)) {
          if (orders.at(k)) level["orders"][key] = *orders.at(k);
          ++k;
        }
    }
    json["series"].push_back(one);
  }
  return json.dump(1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

std::string study_csv(const StudyRecord& record) {
  const References refs = references(record);
  std::string text =
      "model,vary,level,parameter,unknowns,contact_elements,seconds [s],quantity,value,reference,"
      "reference_kind,error [-]\n";
  auto out = std::back_inserter(text);
  for (const StudySeries& series : record.series)
    for (const StudyLevel& level : series.levels)
      for (const auto& [key, value] : level.values) {
        fmt::format_to(out, "{},{},{},{},{},{},{},{},{}", series.model, series.vary, level.label,
                       level.parameter, level.unknowns, level.contact_elements, level.seconds, key,
                       value);
        if (const auto reference = refs.find(key); reference != refs.end())
          fmt::format_to(out, ",{},{},{}\n", reference->second.value, reference->second.kind,
                         study_error(record, key, value, reference->second));
        else
          text += ",,,\n";
      }
  return text;
}

}  // namespace rollfem::postprocess
