// SPDX-License-Identifier: LGPL-2.1-or-later
#include "postprocess/compare/comparison.hpp"

#include "contact/result/bars.hpp"
#include "contact/result/derived.hpp"
#include "contact/result/quantities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

namespace rollfem::postprocess {
namespace {

using contact::ModelResult;
using contact::PointResult;
using contact::Quantity;

/// -F_y / F_z, which no file contains.
Quantity lateral_coefficient() {
  Quantity quantity = contact::quantity_named("traction_coefficient");
  quantity.name = "lateral_coefficient";
  quantity.title = "lateral coefficient";
  quantity.symbol = "-F_y/F_z";
  quantity.member.get = [](const PointResult& point) -> std::optional<double> {
    return point.normal_force != 0.0 ? -point.lateral_force / point.normal_force : 0.0;
  };
  return quantity;
}

/// What may be found for a prescribed force, with the force that is then no result.
struct Found {
  const char *motion, *symbol, *force;
};
constexpr Found found_motions[] = {{"longitudinal_creepage", "xi", "traction_coefficient"},
                                   {"lateral_creepage", "eta", "lateral_coefficient"},
                                   {"longitudinal_shift", "shift x", "traction_coefficient"},
                                   {"lateral_shift", "shift y", "lateral_coefficient"}};

/// Compared by its value.
Quantity found_motion(const Found& found) {
  Quantity quantity = contact::quantity_named(found.motion);
  quantity.symbol = found.symbol;
  quantity.scale = contact::ErrorScale::value;
  return quantity;
}

bool is_named(const Quantity& quantity, const char* name) {
  return std::string(quantity.name) == name;
}

double value_of(const PointResult& point, const Quantity& quantity) {
  return quantity.value(point).value_or(0.0);
}

/// The error bar of a value; for the lateral coefficient it follows from the bar of the force.
std::optional<double> error_of(const PointResult& point, const Quantity& quantity) {
  const bool lateral = is_named(quantity, "lateral_coefficient");
  const auto found = point.error_estimate.find(lateral ? "lateral_force" : quantity.name);
  if (found == point.error_estimate.end()) return {};
  if (!lateral) return found->second;
  if (point.normal_force == 0.0) return {};
  return found->second / std::abs(point.normal_force);
}

/// Whether one of the models has a lateral force worth comparing.
bool has_lateral(const std::vector<const ModelResult*>& models) {
  for (const ModelResult* model : models)
    for (const PointResult& point : model->points)
      if (std::abs(point.lateral_force) > 1e-4 * std::abs(point.normal_force)) return true;
  return false;
}

std::string patch_label(const ModelResult& model) {
  return model.place ? model.place->label(" wheel") : "";
}

/// The reference model; null if there are no models.
const ModelResult* reference_among(const std::vector<const ModelResult*>& models,
                                   const std::vector<std::string>& references) {
  std::vector<std::string> names;
  for (const ModelResult* model : models) names.push_back(model->name);
  const std::string name = reference_of(names, references);
  for (const ModelResult* model : models)
    if (model->name == name) return model;
  return nullptr;
}

/// False for exactly 0 in a quantity that cannot be 0: the model does not give it.
bool is_given(const Quantity& quantity, double value) {
  return quantity.of_friction() || value != 0.0;
}

bool is_motion(const Quantity& quantity) {
  return std::any_of(std::begin(found_motions), std::end(found_motions),
                     [&](const Found& found) { return is_named(quantity, found.motion); });
}

/// Whether a quantity is a result at a load point. A motion found for a force is, in place of that
/// force.
bool is_result(const PointResult& point, const Quantity& quantity) {
  if (is_motion(quantity)) return contact::found_for_force(point, quantity.name);
  return std::none_of(std::begin(found_motions), std::end(found_motions), [&](const Found& found) {
    return is_named(quantity, found.force) && contact::found_for_force(point, found.motion);
  });
}

ComparedNumber number_of(const ModelResult& model, std::size_t k, const Quantity& quantity) {
  const PointResult& point = model.points[k];
  ComparedNumber number;
  number.patch = patch_label(model);
  number.model = model.name;
  number.point = static_cast<int>(k) + 1;
  number.longitudinal_creepage = point.creepage.longitudinal;
  number.lateral_creepage = point.creepage.lateral;
  number.spin = point.creepage.spin;
  number.quantity = quantity.name;
  number.value = value_of(point, quantity);
  number.error = error_of(point, quantity);
  if (const auto left_out = point.model_error.find(quantity.name);
      left_out != point.model_error.end())
    number.model_error = left_out->second;
  return number;
}

void refer(ComparedNumber& number, const ModelResult& reference, std::size_t k,
           const Quantity& quantity, double friction) {
  const PointResult& point = reference.points[k];
  const double value = value_of(point, quantity);
  if (!is_given(quantity, value)) return;
  const double scale = contact::whole_of(quantity, point, friction);
  if (!(scale > 0.0)) return;
  number.scale = scale;
  number.reference = reference.name;
  number.reference_value = value;
  number.reference_error = error_of(point, quantity).value_or(0.0);
}

/// The model whose value is exact, and whose model error the reference does not resolve; null if
/// there is none.
const ModelResult* exact_among(const std::vector<const ModelResult*>& models,
                               const ModelResult& reference, std::size_t k,
                               const Quantity& quantity) {
  if (k >= reference.points.size()) return nullptr;
  const double resolved = error_of(reference.points[k], quantity).value_or(0.0);
  for (const ModelResult* model : models) {
    if (k >= model->points.size()) continue;
    const PointResult& point = model->points[k];
    const auto word = point.no_bar.find(quantity.name);
    if (word == point.no_bar.end() || word->second != contact::no_bar::exact) continue;
    const auto left_out = point.model_error.find(quantity.name);
    if (left_out == point.model_error.end() || left_out->second <= resolved) return model;
  }
  return nullptr;
}

/// Appends all numbers of the models of one patch.
void append_patch(std::vector<ComparedNumber>& numbers,
                  const std::vector<const ModelResult*>& models, double friction,
                  const std::vector<std::string>& references) {
  std::vector<const ModelResult*> with_friction;
  for (const ModelResult* model : models)
    if (model->has_friction()) with_friction.push_back(model);
  const ModelResult* base_patch = reference_among(models, references);
  const ModelResult* base_friction = reference_among(with_friction, references);
  const bool lateral = has_lateral(with_friction);
  const std::vector<Quantity> quantities = compared_quantities();
  for (const ModelResult* model : models)
    for (std::size_t k = 0; k < model->points.size(); ++k)
      for (const Quantity& quantity : quantities) {
        const bool of_friction = quantity.of_friction() || is_motion(quantity);
        if (of_friction && !is_result(model->points[k], quantity)) continue;
        if (of_friction && !model->has_friction()) continue;
        if (is_named(quantity, "lateral_coefficient") && !lateral) continue;
        ComparedNumber number = number_of(*model, k, quantity);
        if (!is_given(quantity, number.value)) continue;
        const ModelResult* base = of_friction ? base_friction : base_patch;
        if (base != nullptr && (references.empty() || base->name != references.front()))
          if (const ModelResult* exact = exact_among(models, *base, k, quantity)) base = exact;
        if (base != nullptr && base != model && k < base->points.size())
          refer(number, *base, k, quantity, friction);
        numbers.push_back(number);
      }
}

/// Amount by which a difference exceeds the error bars.
double excess(const ComparedNumber& number) {
  return std::abs(number.difference()) - number.allowed();
}

/// Adds to the standing of the same place, model and quantity, or creates a new one.
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

std::vector<ModelResult> scalars_of(std::vector<ModelResult> models) {
  for (ModelResult& model : models) {
    model.bodies = {};
    for (PointResult& point : model.points) {
      point.fields = {};
      point.subsurface = {};
      point.bodies = {};
    }
  }
  return models;
}

std::vector<contact::Quantity> compared_quantities() {
  std::vector<Quantity> list;
  for (const bool of_friction : {false, true})
    for (const Quantity& quantity : contact::quantities())
      if (quantity.use >= contact::QuantityUse::compared && quantity.of_friction() == of_friction)
        list.push_back(quantity);
  list.push_back(lateral_coefficient());
  for (const Found& found : found_motions) list.push_back(found_motion(found));
  return list;
}

bool ComparedNumber::differs() const {
  // Tiny differences are rounding.
  return reference_value.has_value() && std::abs(difference()) > allowed() + 1e-9;
}

std::string reference_of(const std::vector<std::string>& models,
                         const std::vector<std::string>& order) {
  for (const std::string& name : order)
    if (std::find(models.begin(), models.end(), name) != models.end()) return name;
  return models.empty() ? std::string() : models.front();
}

std::vector<ComparedNumber> compared_numbers(const ComparedCase& compared,
                                             const std::vector<std::string>& references) {
  std::vector<ComparedNumber> numbers;
  std::vector<std::string> order;
  std::map<std::string, std::vector<const ModelResult*>> patches;
  for (const ModelResult& model : compared.models) {
    const std::string label = patch_label(model);
    if (patches.count(label) == 0) order.push_back(label);
    patches[label].push_back(&model);
  }
  for (const std::string& label : order)
    append_patch(numbers, patches[label], compared.friction, references);
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

ComparedCase compared_case(const std::string& name, const contact::Case& input) {
  return {name, input.file, input.title, input.friction_coefficient, {}, {}};
}

CaseStandings case_standings(const ComparedCase& compared,
                             const std::vector<std::string>& references) {
  CaseStandings all{compared.name, standings(compared_numbers(compared, references)), {}};
  for (const ModelResult& model : compared.models) {
    const double seconds = model.total_seconds();
    const auto found = std::find_if(all.seconds.begin(), all.seconds.end(),
                                    [&](const auto& entry) { return entry.first == model.name; });
    if (found == all.seconds.end())
      all.seconds.emplace_back(model.name, seconds);
    else
      found->second += seconds;
  }
  return all;
}

}  // namespace rollfem::postprocess
