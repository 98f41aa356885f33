// SPDX-License-Identifier: LGPL-2.1-or-later
#include "postprocess/write/json_head.hpp"

#include "postprocess/files/seal.hpp"

#include <nlohmann/json.hpp>

namespace rollfem::postprocess {

using nlohmann::ordered_json;

ordered_json json_head(int format, const std::string& kind, const Provenance& provenance) {
  ordered_json json;
  json["format"] = format;
  json["kind"] = kind;
  json["program"] = {{"version", provenance.version}, {"commit", provenance.commit}};
  json["host"] = provenance.host;
  json["started"] = provenance.started;
  json["command"] = provenance.command;
  json["processes"] = provenance.processes;
  json["labels"] = provenance.labels;
  return json;
}

ordered_json headings_json(const std::vector<contact::Quantity>& quantities) {
  ordered_json json = ordered_json::object();
  for (const contact::Quantity& quantity : quantities)
    json[quantity.name] = {
        {"title", quantity.title}, {"symbol", quantity.symbol}, {"unit", quantity.unit}};
  return json;
}

ordered_json place_json(const contact::ContactPlace& place) {
  return {{"wheel", place.side()}, {"position", place.position}, {"patch", place.patch}};
}

std::string json_text(const ordered_json& json, int indent) {
  return sealed_json(json.dump(indent, ' ', false, ordered_json::error_handler_t::replace));
}

}  // namespace rollfem::postprocess
