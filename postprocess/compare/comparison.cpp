#include "postprocess/compare/comparison.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace rollfem::postprocess {
namespace {

using nlohmann::json;

/// What a difference of a quantity is relative to.
enum class Scale { reference, friction, friction_pressure };

struct Quantity {
  const char* name;
  bool of_friction;
  Scale scale;
  /// Under which names an estimate of its relative error may stand.
  std::vector<const char*> estimates;
};

const std::vector<Quantity>& quantities() {
  static const std::vector<Quantity> all{
      {"max_pressure", false, Scale::reference, {"max_pressure"}},
      {"semi_axis_x", false, Scale::reference, {"semi_axis_x"}},
      {"semi_axis_y", false, Scale::reference, {"semi_axis_y"}},
      {"contact_area", false, Scale::reference, {"contact_area"}},
      {"approach", false, Scale::reference, {"approach"}},
      {"normal_force", false, Scale::reference, {"normal_force"}},
      {"traction_coefficient",
       true,
       Scale::friction,
       {"traction_coefficient", "longitudinal_force"}},
      {"lateral_coefficient", true, Scale::friction, {"lateral_force"}},
      {"max_traction_x", true, Scale::friction_pressure, {"max_traction_x", "max_traction"}}};
  return all;
}

double value_of(const json& point, const std::string& quantity) {
  if (quantity != "lateral_coefficient") return point.at(quantity).get<double>();
  const double normal = point.at("normal_force").get<double>();
  return normal != 0.0 ? -point.at("lateral_force").get<double>() / normal : 0.0;
}

/// Estimates are relative to the value, or to a hundredth of full sliding where that is more
/// (contact/result/refinement.hpp).
std::optional<double> error_of(const json& point, const Quantity& quantity, double sliding) {
  for (const char* name : quantity.estimates) {
    const auto& estimates = point.at("error_estimate");
    if (!estimates.contains(name)) continue;
    const double value = std::abs(value_of(point, quantity.name));
    return estimates.at(name).get<double>() * std::max(value, 0.01 * sliding);
  }
  return {};
}

bool has_friction(const json& model) {
  const auto& points = model.at("points");
  return std::any_of(points.begin(), points.end(), [](const json& point) {
    return point.at("max_traction").get<double>() > 0.0;
  });
}

/// Whether any of the models has a lateral force worth a comparison.
bool has_lateral(const std::vector<const json*>& models) {
  for (const json* model : models)
    for (const json& point : model->at("points"))
      if (std::abs(point.at("lateral_force").get<double>()) >
          1e-4 * std::abs(point.at("normal_force").get<double>()))
        return true;
  return false;
}

std::string patch_label(const json& model) {
  if (!model.contains("place")) return {};
  const json& place = model.at("place");
  std::string text = fmt::format("{} wheel, position {:.0f}", place.at("wheel").get<std::string>(),
                                 place.at("position").get<double>());
  if (place.at("patches").get<double>() > 1.0)
    text += fmt::format(", patch {:.0f} of {:.0f}", place.at("patch").get<double>(),
                        place.at("patches").get<double>());
  return text;
}

const json* named(const std::vector<const json*>& models, const std::string& name) {
  for (const json* model : models)
    if (model->at("name") == name) return model;
  return nullptr;
}

std::vector<std::string> names_of(const std::vector<const json*>& models) {
  std::vector<std::string> names;
  for (const json* model : models) names.push_back(model->at("name").get<std::string>());
  return names;
}

/// A value of exactly 0 of a quantity that cannot be 0 is one that the model does not give.
bool is_given(const Quantity& quantity, double value) {
  return quantity.of_friction || value != 0.0;
}

ComparedNumber number_of(const json& model, const json& point, int index, const Quantity& quantity,
                         double friction) {
  ComparedNumber number;
  number.patch = patch_label(model);
  number.model = model.at("name").get<std::string>();
  number.point = index + 1;
  number.longitudinal_creepage = point.at("longitudinal_creepage").get<double>();
  number.lateral_creepage = point.at("lateral_creepage").get<double>();
  number.spin = point.at("spin").get<double>();
  number.quantity = quantity.name;
  number.value = value_of(point, quantity.name);
  const double sliding = quantity.scale == Scale::friction ? friction
                         : quantity.scale == Scale::friction_pressure
                             ? friction * point.at("max_pressure").get<double>()
                             : 0.0;
  number.error = error_of(point, quantity, sliding);
  return number;
}

void refer(ComparedNumber& number, const json& reference, const json& point,
           const Quantity& quantity, double friction) {
  const double value = value_of(point, quantity.name);
  if (!is_given(quantity, value)) return;
  const ComparedNumber base = number_of(reference, point, number.point - 1, quantity, friction);
  double scale = std::abs(value);
  if (quantity.scale == Scale::friction) scale = friction;
  if (quantity.scale == Scale::friction_pressure)
    scale = friction * point.at("max_pressure").get<double>();
  if (!(scale > 0.0)) return;
  number.scale = scale;
  number.reference = base.model;
  number.reference_value = value;
  number.reference_error = base.error.value_or(0.0);
}

/// All numbers of the models of one patch.
void append_patch(std::vector<ComparedNumber>& numbers, const std::vector<const json*>& models,
                  double friction, const std::string& wished) {
  std::vector<const json*> with_friction;
  for (const json* model : models)
    if (has_friction(*model)) with_friction.push_back(model);
  const json* base_patch = named(models, reference_of(names_of(models), wished));
  const json* base_friction = named(with_friction, reference_of(names_of(with_friction), wished));
  const bool lateral = has_lateral(with_friction);
  for (const json* model : models)
    for (std::size_t k = 0; k < model->at("points").size(); ++k)
      for (const Quantity& quantity : quantities()) {
        if (quantity.of_friction && !has_friction(*model)) continue;
        if (std::string(quantity.name) == "lateral_coefficient" && !lateral) continue;
        const json& point = model->at("points").at(k);
        ComparedNumber number = number_of(*model, point, static_cast<int>(k), quantity, friction);
        if (!is_given(quantity, number.value)) continue;
        const json* base = quantity.of_friction ? base_friction : base_patch;
        if (base != nullptr && base != model && k < base->at("points").size())
          refer(number, *base, base->at("points").at(k), quantity, friction);
        numbers.push_back(number);
      }
}

/// By how much a difference exceeds what the error bars allow.
double excess(const ComparedNumber& number) {
  return std::abs(number.difference()) - number.allowed();
}

/// Adds to the standing of the same place, model and quantity, or as a new one.
void gather(std::vector<Standing>& all, const Standing& more) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Standing& standing) {
    return standing.patch == more.patch && standing.model == more.model &&
           standing.quantity == more.quantity;
  });
  if (found == all.end()) {
    all.push_back(more);
    return;
  }
  found->compared += more.compared;
  found->differ += more.differ;
  if (std::abs(more.worst.difference()) > std::abs(found->worst.difference()))
    found->worst = more.worst;
  if (excess(more.beyond) > excess(found->beyond)) found->beyond = more.beyond;
}

}  // namespace

bool ComparedNumber::differs() const {
  // Models that agree to the last digits differ by rounding.
  return reference_value.has_value() && std::abs(difference()) > allowed() + 1e-9;
}

std::string reference_of(const std::vector<std::string>& models, const std::string& wished) {
  for (const std::string& name : {wished, std::string("halfspace"), std::string("fem")})
    if (std::find(models.begin(), models.end(), name) != models.end()) return name;
  return models.empty() ? std::string() : models.front();
}

std::vector<ComparedNumber> compared_numbers(const ComparedCase& compared,
                                             const std::string& wished_reference) {
  std::vector<ComparedNumber> numbers;
  if (compared.summary.empty()) return numbers;
  const json summary = json::parse(compared.summary);
  std::vector<std::string> order;
  std::map<std::string, std::vector<const json*>> patches;
  for (const json& model : summary.at("models")) {
    const std::string label = patch_label(model);
    if (patches.count(label) == 0) order.push_back(label);
    patches[label].push_back(&model);
  }
  for (const std::string& label : order)
    append_patch(numbers, patches[label], compared.friction, wished_reference);
  return numbers;
}

std::vector<Standing> standings(const std::vector<ComparedNumber>& numbers) {
  std::vector<Standing> all;
  for (const ComparedNumber& number : numbers)
    if (number.reference_value)
      gather(all, {number.patch, number.model, number.reference, number.quantity, 1,
                   number.differs() ? 1 : 0, number, number});
  return all;
}

std::vector<Standing> over_places(const std::vector<Standing>& standings) {
  std::vector<Standing> all;
  for (Standing standing : standings) {
    standing.patch.clear();
    gather(all, standing);
  }
  return all;
}

CaseStandings case_standings(const ComparedCase& compared, const std::string& wished_reference) {
  CaseStandings all{compared.name, standings(compared_numbers(compared, wished_reference)), {}};
  if (compared.summary.empty()) return all;
  const json summary = json::parse(compared.summary);
  for (const json& model : summary.at("models")) {
    const auto name = model.at("name").get<std::string>();
    const double seconds = model.at("seconds").value("total", 0.0);
    const auto found = std::find_if(all.seconds.begin(), all.seconds.end(),
                                    [&](const auto& entry) { return entry.first == name; });
    if (found == all.seconds.end())
      all.seconds.emplace_back(name, seconds);
    else
      found->second += seconds;
  }
  return all;
}

}  // namespace rollfem::postprocess
