// SPDX-License-Identifier: LGPL-2.1-or-later
// Features of problems that not every model supports: detection and names.
#include "contact/solve/model.hpp"

#include "base/errors.hpp"
#include "base/text_fields.hpp"
#include "result/quantities.hpp"
#include "result/validity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace rollfem::contact {

namespace {

struct DemandRow {
  Demand demand;
  const char* key;
  const char* what;
  bool (*asked)(const Scene&);
};

bool any_force(const Scene& scene) {
  return std::any_of(scene.points.begin(), scene.points.end(),
                     [](const LoadPoint& point) { return point.force.any(); });
}

bool stress_in_rigid(const Scene& scene) {
  return std::any_of(scene.subsurface.begin(), scene.subsurface.end(),
                     [&](const SubsurfaceRequest& request) {
                       return (request.wheel ? scene.wheel : scene.rail).material.rigid();
                     });
}

bool any_of_radii(const Scene& scene, double Creepage::*component) {
  return !scene.has_profiles() &&
         std::any_of(scene.points.begin(), scene.points.end(),
                     [&](const LoadPoint& point) { return point.creepage.*component != 0.0; });
}

/// An equivalent ellipse passes the slip at the patch's points to its theory, which no file
/// contains.
bool slip_from_file(const Scene& scene) {
  const auto& values = scene.geometry.extra_slip_values;
  return scene.geometry.extra_slip == ExtraSlip::file && values && !values->file.empty();
}

/// Points of a concave body beyond z = 0, where a half-space ends.
bool beyond_half_space(const Scene& scene) {
  return std::any_of(scene.subsurface.begin(), scene.subsurface.end(),
                     [](const SubsurfaceRequest& request) {
                       double least = request.wheel ? request.from[2] : -request.from[2];
                       for (const auto* corner : {&request.to, &request.across})
                         least = std::min(least, request.wheel ? (*corner)[2] : -(*corner)[2]);
                       const double fourth = request.to[2] + request.across[2] - request.from[2];
                       if (request.kind == SubsurfaceRequest::Kind::plane)
                         least = std::min(least, request.wheel ? fourth : -fourth);
                       return least < 0.0;
                     });
}

/// In the order in which they are named when several are requested.
const std::vector<DemandRow>& rows() {
  static const std::vector<DemandRow> all{
      {Demand::history, "rolling.problem", "shift or transient",
       [](const Scene& c) { return c.is_history(); }},
      {Demand::tangential_force, "rolling.longitudinal_force or lateral_force",
       "a prescribed tangential force", any_force},
      {Demand::load_history, "history.normal_force or approach",
       "a load that changes from step to step",
       [](const Scene& c) { return c.is_history() && c.load_changes(); }},
      {Demand::profiles, "wheel.profile and rail.profile", "true profiles",
       [](const Scene& c) { return c.has_profiles(); }},
      {Demand::sections, "wheel.profile or rail.profile",
       "profiles that change over the patch by more than 1 % of the approach",
       [](const Scene& c) {
         // Less than the half-space's own error on patches as long as a tenth of the radii.
         constexpr double most = 0.01;
         return c.has_profiles() && c.geometry.surface.profiles->variation() > most;
       }},
      {Demand::extra_slip_on_profiles, "rolling.extra_slip",
       "extra slip from a file on true profiles",
       [](const Scene& c) { return c.has_profiles() && slip_from_file(c); }},
      {Demand::line_contact, "geometry.shape", "a line contact",
       [](const Scene& c) { return c.geometry.line.has_value(); }},
      {Demand::distance_points, "undeformed_distance.file", "bodies given point by point",
       [](const Scene& c) { return c.geometry.distance_values.has_value(); }},
      {Demand::distance_quadratic, "undeformed_distance.quadratic", "bodies without radii",
       [](const Scene& c) { return c.geometry.quadratic.has_value(); }},
      {Demand::given_pressure, "given_pressure", "a given pressure",
       [](const Scene& c) { return c.given_pressure.has_value(); }},
      {Demand::rigid_body, "young_modulus = inf", "a rigid body",
       [](const Scene& c) { return c.wheel.material.rigid() || c.rail.material.rigid(); }},
      {Demand::stress_in_rigid_body, "subsurface", "the stress in a rigid body", stress_in_rigid},
      {Demand::falling_friction, "friction.law", "friction that falls with the slip velocity",
       [](const Scene& c) {
         return c.friction() && c.friction()->feels_slip() && !c.friction()->by_temperature();
       }},
      {Demand::heated_friction, "friction.law", "friction that follows the temperature",
       [](const Scene& c) { return c.friction() && c.friction()->by_temperature(); }},
      {Demand::varying_friction, "friction.inclination or lateral_position",
       "friction that varies over the rail",
       [](const Scene& c) { return c.friction() && c.friction()->varies(); }},
      {Demand::layer, "layer", "a layer between wheel and rail",
       [](const Scene& c) { return c.material.layer > 0.0; }},
      {Demand::plastic_layer, "layer.yield_stress", "a layer that yields",
       [](const Scene& c) { return c.friction() && c.friction()->plasticity; }},
      {Demand::inertia, "fem.inertia", "the inertia of moving bodies",
       [](const Scene& c) { return c.feels_inertia(); }},
      {Demand::yielding_body, "wheel_plasticity or rail_plasticity", "bodies that yield",
       [](const Scene& c) { return c.yields(); }},
      {Demand::beyond_half_space, "subsurface",
       "points of a concave body beyond z = 0, where the half-space ends ([[subsurface.surface]] "
       "follows the surface in either)",
       beyond_half_space},
      {Demand::lateral_creepage, "rolling.lateral_creepage", "lateral creepage",
       [](const Scene& c) { return any_of_radii(c, &Creepage::lateral); }},
      {Demand::spin, "rolling.spin", "spin",
       [](const Scene& c) { return any_of_radii(c, &Creepage::spin); }},
      {Demand::extra_slip, "rolling.extra_slip", "extra slip from a file",
       [](const Scene& c) { return !c.has_profiles() && slip_from_file(c); }},
  };
  return all;
}

}  // namespace

std::optional<std::string> first_beyond(const Demands& takes, const ModelInput& input) {
  for (const DemandRow& row : rows())
    if (std::find(takes.begin(), takes.end(), row.demand) == takes.end() && row.asked(input))
      return fmt::format("{}: it cannot handle {}", row.key, row.what);
  return std::nullopt;
}

std::string demand_words(Demand demand) {
  for (const DemandRow& row : rows())
    if (row.demand == demand) return row.what;
  return {};
}

const Demands& all_demands() {
  static const Demands all = [] {
    Demands list;
    for (const DemandRow& row : rows()) list.push_back(row.demand);
    return list;
  }();
  return all;
}

Demands all_demands_but(const Demands& missing) {
  Demands list;
  for (const Demand demand : all_demands())
    if (std::find(missing.begin(), missing.end(), demand) == missing.end()) list.push_back(demand);
  return list;
}

namespace {

/// Model names are also names of groups in files and of checkpoints, and words of a case file.
bool is_plain(const std::string& name) {
  const auto plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
  };
  return !name.empty() && name.front() != '-' && std::all_of(name.begin(), name.end(), plain);
}

}  // namespace

const std::vector<ModelTrait>& model_traits() {
  using M = ModelInfo;
  static const std::vector<ModelTrait> all{{"bounded", &M::bounded},
                                           {"own_bound", &M::own_bound},
                                           {"frictionless", &M::frictionless},
                                           {"half_spaces", &M::half_spaces},
                                           {"has_stress", &M::has_stress},
                                           {"keeps_bodies", &M::keeps_bodies},
                                           {"corrects_stress", &M::corrects_stress},
                                           {"measures_others", &M::measures_others},
                                           {"parallel", &M::parallel},
                                           {"built", &M::built},
                                           {"chooses", &M::chooses},
                                           {"in_compare", &M::in_compare}};
  return all;
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

ModelRegistry& ModelRegistry::add(ModelInfo model) {
  if (!is_plain(model.name) || !(model.run || model.chooses))
    throw std::logic_error(fmt::format(
        "model \"{}\" has no run function, or a name with characters other than a-z, 0-9 and -",
        model.name));
  if (find(model.name) != nullptr)
    throw std::logic_error(fmt::format("two models are named {}", model.name));
  if (model.label.empty()) model.label = model.name;
  if (model.add_keys != nullptr) model.add_keys();
  models_.push_back(std::move(model));
  return *this;
}

std::vector<std::string> ModelRegistry::names() const {
  std::vector<std::string> all;
  for (const ModelInfo& model : models_) all.push_back(model.name);
  return all;
}

std::vector<std::string> ModelRegistry::names(bool ModelInfo::*wanted) const {
  std::vector<std::string> all;
  for (const ModelInfo& model : models_)
    if (model.*wanted) all.push_back(model.name);
  return all;
}

const ModelInfo& ModelRegistry::reference() const {
  for (const ModelInfo& model : models_)
    if (model.has_stress) return model;
  throw std::logic_error("no registered model solves the elastic problem");
}

const ModelInfo* ModelRegistry::find(const std::string& name) const {
  const auto found = std::find_if(models_.begin(), models_.end(),
                                  [&](const ModelInfo& model) { return model.name == name; });
  return found == models_.end() ? nullptr : &*found;
}

const ModelInfo& ModelRegistry::at(const std::string& name, const std::string& asked_by) const {
  if (const ModelInfo* model = find(name)) return *model;
  throw InputError(fmt::format("{} {}: no such model; {}allowed: {}; do: name one of them",
                               asked_by, name, did_you_mean(name, names()), listed(names())));
}

std::string ModelRegistry::advice(const ModelInput& input) const {
  std::vector<std::string> able;
  const ModelInfo* best = nullptr;
  for (const ModelInfo& model : models_) {
    if (model.chooses || model.cannot(input)) continue;
    able.push_back(model.name);
    // The cheapest model that solves the elastic problem; theories only if nothing else can.
    if (best == nullptr || (model.has_stress && !best->has_stress)) best = &model;
  }
  if (best == nullptr) return "allowed: no model can solve all of this case; do: change it";
  return fmt::format("allowed: {}; do: run with --model {}, or change the case", listed(able),
                     best->name);
}

void ModelRegistry::check(const ModelInput& input, const std::string& name) const {
  if (const auto reason = at(name).cannot(input))
    throw InputError(fmt::format("{}: model {}: {}; {}", input.file, name, *reason, advice(input)));
}

namespace {

/// Checks a result and adds what the registry knows of its model.
void complete(const ModelRegistry& models, const ModelInfo& model, const ModelInput& input,
              ModelResult& result) {
  const ResultKind kind{model.has_stress, model.bounded, model.half_spaces};
  check_validity(input, result, kind);
  for (Note& warning : validity_warnings(input, result, kind))
    result.notes.push_back(std::move(warning));
  if (input.asks_for_stress() && !model.has_stress)
    add_note(result.notes, "stress", "no stress below the surface; models that compute it: {}",
             listed(models.names(&ModelInfo::has_stress)));
  explain_bars(input, model.bars, result);
  result.traits.clear();
  for (const ModelTrait& trait : model_traits())
    if (model.*trait.holds) result.traits.emplace_back(trait.name);
  if (result.note_about(about_model_error) == nullptr)
    result.notes.push_back({about_model_error, model.no_model_error});
}

}  // namespace

ModelResult ModelRegistry::run(const std::string& name, const ModelInput& input,
                               const Progress& progress, Checkpoint* checkpoint) const {
  check(input, name);
  const ModelInfo& model = at(name);
  if (!model.run) throw std::logic_error(name + " chooses one of the other models, which are run");
  ModelResult result;
  try {
    result = model.run(input, progress, checkpoint);
  } catch (PartlySolved& partly) {
    complete(*this, model, input, partly.result);
    throw;
  }
  complete(*this, model, input, result);
  return result;
}

}  // namespace rollfem::contact
