// SPDX-License-Identifier: LGPL-2.1-or-later
#include "theories/model_error.hpp"

#include "contact/result/bars.hpp"
#include "contact/result/quantities.hpp"
#include "halfspace/model/model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace rollfem::theories {

using contact::ModelResult;
using contact::PointResult;
using contact::Scene;

namespace {

/// Some ten milliseconds a load point. With 20, the discretisation error is often larger than the
/// error of a theory.
constexpr int elements_of_theories = 32;

/// The load point of a model that uses one solution for all load points.
Scene at_largest_load(const Scene& scene) {
  const contact::NormalLoad largest = contact::largest_load(scene);
  for (std::size_t k = 0; k < scene.points.size(); ++k)
    if (scene.points[k].load.force == largest.force &&
        scene.points[k].load.approach == largest.approach)
      return contact::at_point(scene, k);
  return contact::at_point(scene, 0);
}

/// Friction changes the pressure of unlike materials, and on a tilted plane it carries a part of
/// the load.
bool friction_moves_pressure(const Scene& scene) {
  return scene.material.couples() ||
         std::any_of(scene.points.begin(), scene.points.end(),
                     [](const auto& point) { return point.load.direction[0] != 0.0; });
}

Scene rough_scene(const Scene& scene, bool with_friction, std::size_t points) {
  Scene rough = points == scene.points.size() ? scene : at_largest_load(scene);
  if (!with_friction && !friction_moves_pressure(scene)) {
    rough.problem = contact::Problem::frictionless;
    for (contact::LoadPoint& point : rough.points) point.force = {};
  }
  return halfspace::on_few_elements(std::move(rough), elements_of_theories);
}

bool is_worth_it(const contact::Quantity& quantity, bool with_friction) {
  if (quantity.of_friction() || std::string(quantity.name) == "adhesion_area") return with_friction;
  return quantity.scale == contact::ErrorScale::value;
}

/// Which values of a theory are those of half-spaces.
struct Exact {
  bool patch = false;   ///< and pressure and approach: Hertz's solution of this problem
  bool forces = false;  ///< Carter's of a line contact

  Exact(const Scene& scene, const TheoryKind& kind)
      : patch(kind.hertzian && !scene.has_profiles() && !scene.geometry.distance_values &&
              scene.follows_surface == 0.0 && !friction_moves_pressure(scene)),
        forces(patch && scene.geometry.line.has_value()) {}
  bool all(const TheoryKind& kind) const { return patch && (forces || !kind.with_friction); }
  bool has(const contact::Quantity& quantity) const {
    return forces || (patch && !quantity.of_friction() && !quantity.member.may_be_absent &&
                      quantity.name != std::string("adhesion_area"));
  }
};

void add_errors(const PointResult& half, const Exact& exact, bool with_friction,
                PointResult& theory) {
  for (const contact::Quantity& quantity : contact::quantities()) {
    const auto value = quantity.value(theory);
    const auto other = quantity.value(half);
    const auto bar = half.error_estimate.find(quantity.name);
    const auto word = half.no_bar.find(quantity.name);
    const bool given = word != half.no_bar.end() && word->second == contact::no_bar::given;
    if (!value || !other || given || !is_worth_it(quantity, with_friction)) continue;
    if (exact.has(quantity)) {
      theory.model_error[quantity.name] = 0.0;
      continue;
    }
    // Without its error bar a half-space solution on so few elements is no reference.
    if (bar == half.error_estimate.end()) continue;
    // An error bar holds nearly always, half of it usually (docs/accuracy.md).
    theory.model_error[quantity.name] = std::abs(*value - *other) + 0.5 * bar->second;
  }
}

}  // namespace

void estimate_model_error(const Scene& scene, const TheoryKind& kind,
                          const contact::Progress& progress, ModelResult& theory) {
  const contact::Stopwatch watch;
  const contact::Progress told = [&](contact::ProgressEvent event) {
    event.stage = "model error: " + event.stage;
    contact::report(progress, event);
  };
  const Exact exact(scene, kind);
  try {
    const Scene rough = rough_scene(scene, kind.with_friction, theory.points.size());
    ModelResult half = exact.all(kind) ? theory : halfspace::run_halfspace(rough, told, nullptr);
    contact::explain_bars(rough, {}, half);
    for (std::size_t k = 0; k < theory.points.size() && k < half.points.size(); ++k)
      add_errors(half.points[k], exact, kind.with_friction, theory.points[k]);
    theory.model_error_source =
        exact.all(kind)
            ? std::string("none: exact for half-spaces")
            : fmt::format(
                  "difference from the half-space with {} elements across, plus half its error "
                  "bar{}",
                  elements_of_theories, exact.patch ? "; patch and pressure are exact" : "");
  } catch (const std::runtime_error& error) {  // InputError, SolveError and their base classes
    theory.model_error_source =
        fmt::format("not estimated: no result of the half-space with {} elements across ({})",
                    elements_of_theories, error.what());
  }
  // Not part of the total, which is the cost of the theory.
  theory.seconds["model error"] = watch.seconds();
}

}  // namespace rollfem::theories
