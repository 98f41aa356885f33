// SPDX-License-Identifier: LGPL-2.1-or-later
#include "postprocess/read/summary_reader.hpp"

#include "contact/result/quantities.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace rollfem::postprocess {
namespace {

using nlohmann::json;

contact::PointResult read_point(const json& stored) {
  contact::PointResult point;
  for (const contact::Quantity& quantity : contact::quantities())
    if (const auto found = stored.find(quantity.name); found != stored.end())
      quantity.member.set(point, found->is_boolean() ? static_cast<double>(found->get<bool>())
                                                     : found->get<double>());
    else if (!quantity.member.may_be_absent)
      quantity.member.set(point, std::nan(""));  // a load point without a solution
  stored.at("error_estimate").get_to(point.error_estimate);
  if (stored.contains("no_bar")) stored.at("no_bar").get_to(point.no_bar);
  if (stored.contains("model_error")) stored.at("model_error").get_to(point.model_error);
  return point;
}

contact::ContactPlace read_place(const json& stored) {
  contact::ContactPlace place;
  place.left = stored.at("wheel") == "left";
  place.position = static_cast<int>(stored.at("position").get<double>());
  place.patch = static_cast<int>(stored.at("patch").get<double>());
  place.patches = static_cast<int>(stored.at("patches").get<double>());
  return place;
}

}  // namespace

std::vector<contact::ModelResult> models_of_summary(const std::string& summary) {
  const json run = json::parse(summary);
  std::vector<contact::ModelResult> models;
  for (const json& stored : run.at("models")) {
    contact::ModelResult& model = models.emplace_back();
    stored.at("name").get_to(model.name);
    stored.at("seconds").get_to(model.seconds);
    if (stored.contains("place")) model.place = read_place(stored.at("place"));
    for (const json& point : stored.at("points")) model.points.push_back(read_point(point));
  }
  return models;
}

}  // namespace rollfem::postprocess
