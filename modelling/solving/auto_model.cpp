// SPDX-License-Identifier: LGPL-2.1-or-later
#include "modelling/solving/auto_model.hpp"

#include "base/errors.hpp"
#include "base/threads.hpp"
#include "fem/fem_options.hpp"
#include "halfspace/curvature/curvature_error.hpp"
#include "halfspace/halfspace_models.hpp"
#include "halfspace/model/halfspace_model.hpp"
#include "halfspace/patch/patch_search.hpp"
#include "halfspace/patch/profile_reach.hpp"
#include "modelling/choice/laws.hpp"
#include "modelling/fem/fem_models.hpp"
#include "modelling/program/provenance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <utility>

namespace rollfem::modelling {

namespace {

using contact::Choosable;
using contact::ModelRegistry;
using contact::Scene;

/// Mean radius of a section of true profiles, from its slopes at both ends of the patch, mm.
double mean_radius(const contact::HeightCurve& curve, double lower, double upper) {
  return (upper - lower) / std::abs(curve.at(upper).slope - curve.at(lower).slope);
}

double radius_across(const Scene& scene) {
  const contact::ContactSurface& surface = scene.geometry.surface;
  if (!surface.profiles)
    return std::min(std::abs(surface.wheel_transverse_radius),
                    std::abs(surface.rail_transverse_radius));
  const halfspace::ExpectedPatch patch = halfspace::PatchSearch(scene).patch();
  return std::min(mean_radius(surface.profiles->rail(), patch.y_lower, patch.y_upper),
                  mean_radius(surface.profiles->wheel(), patch.y_lower, patch.y_upper));
}

/// Smallest over largest size of Hertz's patches: sizes grow with the cube root of the force or the
/// square root of the approach.
double smallest_part(const Scene& scene) {
  double least = contact::infinity, most = 0.0;
  for (const contact::LoadPoint& point : scene.points) {
    const contact::NormalLoad& load = point.load;
    const double size =
        load.force ? std::cbrt(*load.force) : std::sqrt(load.approach.value_or(0.0));
    least = std::min(least, size);
    most = std::max(most, size);
  }
  return least > 0.0 && most > 0.0 ? least / most : 1.0;
}

/// Number of bodies that the hybrid meshes: neither rigid nor flat ones.
int meshed_bodies(const Scene& scene) {
  const contact::ContactSurface& surface = scene.geometry.surface;
  const bool flat_rail = !surface.profiles && std::isinf(surface.rail_transverse_radius);
  return (scene.wheel.material.rigid() ? 0 : 1) +
         (scene.rail.material.rigid() || (flat_rail && !scene.asks_for_stress()) ? 0 : 1);
}

/// True if the geometry suffices to estimate the half-space's model error.
bool bodies_known(const Scene& scene) {
  return scene.geometry.has_surfaces() && !scene.geometry.line;
}

ContactSize size_of(const Scene& scene) {
  const halfspace::PatchExtent extent = halfspace::PatchSearch(scene).extent();
  ContactSize size;
  size.half_length = 0.5 * extent.length;
  size.half_width = 0.5 * extent.width;
  const halfspace::PatchBox box = halfspace::PatchSearch(scene).box();
  size.wider = box.half_width / box.half_loaded;
  size.bodies_known = bodies_known(scene);
  if (size.bodies_known) {
    size.rolling_radius = std::abs(scene.geometry.surface.relative_rolling_radius());
    size.radius_across = radius_across(scene);
  }
  if (scene.friction() != nullptr) size.friction = scene.friction_coefficient();
  size.smallest_part = smallest_part(scene);
  size.load_points = std::max<std::size_t>(1, scene.points.size());
  size.symmetric = scene.is_symmetric();
  size.coupled =
      scene.friction() != nullptr && (scene.material.couples() || scene.follows_surface > 0.0);
  size.shares_load =
      scene.friction() != nullptr && !scene.points.empty() && scene.points.front().load.is_tilted();
  size.meshed_bodies = meshed_bodies(scene);
  size.line = scene.geometry.line.has_value();
  size.true_sections = fem::has_true_sections(scene);
  size.steep = halfspace::is_steep(scene);
  // No look-up with several processes, which might disagree.
  if (size.bodies_known && !scene.given_pressure && processes().count == 1)
    size.correction_kept = correction_is_kept(scene);
  return size;
}

/// Why a model cannot take the scene; otherwise empty.
std::string out_of_question(const contact::ModelInfo& model, const Scene& scene) {
  if (!model.built) return "not in this build";
  if (const auto reason = model.cannot(scene)) return *reason;
  // Without radii wheel and rail are taken as flat.
  if (model.choosable == Choosable::finite_bodies && scene.given_pressure &&
      std::isinf(scene.geometry.surface.relative_rolling_radius()))
    return "the shape of the bodies is not given";
  if (scene.asks_for_stress() && !model.has_stress)
    return "it computes no stress below the surface";
  const bool meshes = !scene.wheel.mesh.empty() || !scene.rail.mesh.empty();
  const bool boxes = fem::options_of(scene).mesh != fem::MeshFamily::gmsh;
  if (model.choosable == Choosable::corrected_half_spaces && (meshes || !boxes) &&
      scene.asks_for_stress())
    return "it computes stress only in bodies that are boxes below their surface";
  return "";
}

Forecast forecast_as(Choosable kind, const ContactSize& size) {
  if (kind == Choosable::finite_bodies) return fem_forecast(size);
  return kind == Choosable::corrected_half_spaces ? hybrid_forecast(size)
                                                  : halfspace_forecast(size);
}

/// Forecasts for the models of a scene before anything is solved. Throws contact::InputError, and
/// contact::SolveError if the scene has no patch.
std::vector<Forecast> forecasts_of(const Scene& scene, const ModelRegistry& models) {
  const ContactSize size = size_of(scene);
  std::vector<Forecast> all;
  std::string half_spaces;
  for (const contact::ModelInfo& model : models.all()) {
    if (model.choosable == Choosable::never) continue;
    Forecast& forecast = all.emplace_back(forecast_as(model.choosable, size));
    forecast.model = model.name;
    forecast.on_one_thread = !model.parallel;
    if (model.choosable == Choosable::half_spaces) {
      half_spaces = model.name;
      forecast.estimates_model_error = bodies_known(scene);
      if (!bodies_known(scene))
        forecast.no_model_error =
            scene.geometry.line ? "the model error of half-planes in line contact is not estimated"
                                : "only the undeformed distance of the bodies is known";
    }
    if (model.choosable == Choosable::corrected_half_spaces) forecast.corrects = half_spaces;
    if (const std::string why = out_of_question(model, scene); !why.empty()) forecast.cannot = why;
  }
  return all;
}

/// The scene with a grid set by the choice, for half-space and hybrid.
Scene on_grid(Scene scene, int across) {
  if (auto& cell = scene.contact_grid.cell_size) {
    const halfspace::PatchExtent extent = halfspace::PatchSearch(scene).extent();
    const double given = std::min(extent.length / (*cell)[0], extent.width / (*cell)[1]);
    for (double& side : *cell) side *= given / across;
  } else {
    scene.contact_grid.elements_across = across;
  }
  return scene;
}

Scene on_cells(Scene scene, int across) {
  const halfspace::PatchExtent extent = halfspace::PatchSearch(scene).extent();
  scene.options.set<fem::FemOptions>().cell_size = std::min(extent.length, extent.width) / across;
  return scene;
}

/// The estimate of the half-space's model error for one scene, by load point.
struct Estimate {
  std::vector<std::map<std::string, double>> errors;
  contact::Note source;
};

/// Finer grids hardly change the model error: the first estimate serves all of them.
void share_model_error(const Scene& scene, const contact::Progress& progress, Estimate& first,
                       contact::ModelResult& result) {
  if (first.errors.empty()) {
    halfspace::add_model_error(scene, progress, result);
    for (const contact::PointResult& point : result.points)
      first.errors.push_back(point.model_error);
    first.source = *result.note_about(contact::about_model_error);
    return;
  }
  for (std::size_t k = 0; k < result.points.size(); ++k)
    result.points[k].model_error = first.errors[k];
  result.set_note(first.source);
}

/// A scene and how a model solves it.
Subject subject_of(const Scene& asked, std::vector<Forecast> forecasts, const Solving& how) {
  Subject made;
  made.forecasts = std::move(forecasts);
  made.friction_coefficient = asked.friction_coefficient();
  made.where = asked.where();
  const auto scene = std::make_shared<Scene>(asked);
  scene->accuracy.relative.reset();  // accuracy and estimates are the matter of the choice
  scene->options.set<halfspace::HalfspaceOptions>().model_error = false;
  const auto estimate = std::make_shared<Estimate>();
  made.solve = [scene, estimate, &how](const Forecast& forecast, int across) {
    const contact::ModelInfo& model = how.models->at(forecast.model);
    if (model.parallel && how.need_session) how.need_session();
    const bool cells = model.choosable == Choosable::finite_bodies;
    contact::ModelResult result =
        run_model(model.name, cells ? on_cells(*scene, across) : on_grid(*scene, across), how);
    result.label = model.label;
    if (forecast.estimates_model_error) share_model_error(*scene, how.progress, *estimate, result);
    return result;
  };
  return made;
}

}  // namespace

contact::ModelInfo auto_model() {
  contact::ModelInfo choice{
      "auto", "auto",
      "chooses the cheapest of halfspace, hybrid and fem whose total error is within `accuracy`"};
  choice.takes = contact::all_demands_but({contact::Demand::yielding_body});
  choice.chooses = choice.in_run = true;
  choice.parallel = ROLLFEM_WITH_FEM;
  return choice;
}

bool any_choice(const ModelRegistry& models, const std::vector<std::string>& names) {
  return std::any_of(names.begin(), names.end(),
                     [&](const std::string& name) { return models.at(name).chooses; });
}

void check_alone(const ModelRegistry& models, const std::vector<std::string>& names,
                 const std::string& asked_by) {
  if (names.size() < 2 || !any_choice(models, names)) return;
  throw contact::InputError(
      fmt::format("{}: auto cannot be combined with other models, because it chooses one of them; "
                  "allowed: auto alone, or models by name; do: name one or the other",
                  asked_by));
}

void refuse_choice(const ModelRegistry& models, const std::vector<std::string>& names,
                   const std::string& command) {
  if (!any_choice(models, names)) return;
  std::vector<std::string> others;
  for (const contact::ModelInfo& model : models.all())
    if (!model.chooses) others.push_back(model.name);
  throw contact::InputError(
      fmt::format("{} --model auto: auto chooses one of the other models and cannot be compared "
                  "with them; allowed: {}; do: name those, or use rollfem run --model auto",
                  command, contact::listed(others)));
}

Chosen solve_by_choice(const std::vector<Scene>& scenes, const Solving& how) {
  std::vector<Subject> subjects(scenes.size());
  contact::for_each_index(scenes.size(), [&](std::size_t c) {
    subjects[c] = subject_of(scenes[c], forecasts_of(scenes[c], *how.models), how);
  });
  Wanted wanted;
  wanted.accuracy = scenes.front().accuracy;  // the same for all scenes of a case
  // A part of a run has its part of the time.
  if (!wanted.accuracy.relative) wanted.seconds = seconds_by_default / how.own.of;
  wanted.accuracy.relative = wanted.accuracy.relative.value_or(contact::default_accuracy);
  wanted.progress = how.progress;
  wanted.go_on = how.together;
  if (!how.together && how.session != nullptr)
    wanted.agree = [&](const std::string& text) { return how.session->from_first(text); };
  return choose(std::move(subjects), wanted);
}

}  // namespace rollfem::modelling
