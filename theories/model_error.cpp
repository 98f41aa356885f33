#include "theories/model_error.hpp"

#include "contact/base/errors.hpp"
#include "contact/base/stopwatch.hpp"
#include "contact/result/bars.hpp"
#include "contact/result/quantities.hpp"
#include "halfspace/model/model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rollfem::theories {

using contact::ModelResult;
using contact::PointResult;
using contact::Scene;

namespace {

/// Some ten milliseconds a load point. With 20 what these few elements leave uncertain is often
/// more than what a theory is off by.
constexpr int elements_of_theories = 32;

/// The load point of a model that has one for all of them.
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

void add_errors(const PointResult& half, bool with_friction, PointResult& theory) {
  for (const contact::Quantity& quantity : contact::quantities()) {
    const auto value = quantity.value(theory);
    const auto other = quantity.value(half);
    const auto bar = half.error_estimate.find(quantity.name);
    const auto word = half.no_bar.find(quantity.name);
    const bool given = word != half.no_bar.end() && word->second == contact::no_bar::given;
    if (!value || !other || given || !is_worth_it(quantity, with_friction)) continue;
    // Without its bar a half-space of so few elements says nothing.
    if (bar == half.error_estimate.end()) continue;
    // A bar holds nearly always; half of it does as a rule (docs/accuracy.md).
    theory.model_error[quantity.name] = std::abs(*value - *other) + 0.5 * bar->second;
  }
}

}  // namespace

void estimate_model_error(const Scene& scene, bool with_friction, ModelResult& theory) {
  const contact::Stopwatch watch;
  try {
    const Scene rough = rough_scene(scene, with_friction, theory.points.size());
    ModelResult half = halfspace::run_halfspace(rough, {}, nullptr);
    contact::explain_bars(rough, {}, half);
    for (std::size_t k = 0; k < theory.points.size() && k < half.points.size(); ++k)
      add_errors(half.points[k], with_friction, theory.points[k]);
    theory.model_error_source =
        fmt::format("difference from the half-space with {} elements across, plus half its bar",
                    elements_of_theories);
  } catch (const std::runtime_error& error) {  // InputError, SolveError and what they are made of
    theory.model_error_source =
        fmt::format("not estimated: no result of the half-space with {} elements across ({})",
                    elements_of_theories, error.what());
  }
  // Not of the total, which is what the theory costs.
  theory.seconds["model error"] = watch.seconds();
}

}  // namespace rollfem::theories
