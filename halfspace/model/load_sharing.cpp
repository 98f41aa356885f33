#include "halfspace/model/load_sharing.hpp"

#include "contact/base/errors.hpp"
#include "halfspace/model/expected_patch.hpp"
#include "halfspace/model/patch_ridge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rollfem::halfspace {

using contact::Scene;

namespace {

/// Relative error of the vertical force at which the search ends: below that of the forces.
constexpr double tolerance = 1e-5;
constexpr int most_steps = 60;
/// First guess of the sinking, mm; a wheel's patch approaches by 0.05 to 0.2.
constexpr double first_sinking = 0.05;
/// No wheel sinks deeper than this, mm.
constexpr double deepest_sinking = 20.0;

struct Patch {
  Scene scene;  ///< one load point
  double cosine;
  double separation;
  double least_distance;  ///< mm, of the patch geometry: its own zero of the approach
};

Patch patch_of(const Scene& scene) {
  if (!scene.has_profiles() || !scene.place)
    throw contact::InputError(
        "sharing of the load between patches: every scene needs the geometry and the place of its "
        "patch; do: make scenes of a case with profiles");
  return {contact::at_point(scene, 0), std::cos(scene.place->contact_angle),
          scene.place->separation, Ridge(*scene.geometry.surface.profiles).least_distance()};
}

double force_at(Patch& patch, double sinking) {
  const double approach = sinking * patch.cosine - patch.separation;
  if (!(approach > 0.0)) return 0.0;
  patch.scene.points.front().load = {{}, patch.least_distance + approach};
  return expected_patch(patch.scene).normal_force;
}

}  // namespace

SharedLoad share_load(const std::vector<Scene>& inputs, double vertical_force) {
  if (inputs.empty() || !(vertical_force > 0.0))
    throw contact::InputError(fmt::format(
        "sharing of the load between patches: {} patches and a vertical force of {} N; allowed: at "
        "least one patch and a force above 0",
        inputs.size(), vertical_force));
  std::vector<Patch> patches;
  for (const Scene& scene : inputs) patches.push_back(patch_of(scene));
  SharedLoad shared;
  // Force by Hertz's law is a 3/2 power of the approach: its 2/3 power is searched, nearly
  // straight.
  const auto defect = [&](double sinking) {
    shared.sinking = sinking;
    shared.normal_forces.clear();
    double sum = 0.0;
    for (Patch& patch : patches) {
      shared.normal_forces.push_back(force_at(patch, sinking));
      sum += shared.normal_forces.back() * patch.cosine;
    }
    return std::pow(sum / vertical_force, 2.0 / 3.0) - 1.0;
  };
  double lower = deepest_sinking;
  for (const Patch& patch : patches) lower = std::min(lower, patch.separation / patch.cosine);
  double at_lower = -1.0;
  double upper = lower + first_sinking;
  double at_upper = defect(upper);
  for (; at_upper < 0.0; at_upper = defect(upper)) {
    if (upper > deepest_sinking)
      throw contact::SolveError(fmt::format(
          "sharing of the load between patches: a sinking of {:.3g} mm does not carry {} N; do: "
          "check the profiles and the load",
          upper, vertical_force));
    lower = upper;
    at_lower = at_upper;
    upper += 1.5 * first_sinking;
  }
  // Regula falsi in the manner of Illinois: an end that stays counts for half.
  int stayed = 0;
  for (int step = 0; step < most_steps; ++step) {
    const double middle = (lower * at_upper - upper * at_lower) / (at_upper - at_lower);
    const double value = defect(middle);
    if (std::abs(value) < tolerance || upper - lower < 1e-9) return shared;
    if (value < 0.0) {
      lower = middle;
      at_lower = value;
      if (stayed == -1) at_upper *= 0.5;
      stayed = -1;
    } else {
      upper = middle;
      at_upper = value;
      if (stayed == 1) at_lower *= 0.5;
      stayed = 1;
    }
  }
  throw contact::SolveError(fmt::format(
      "sharing of the load between patches did not converge: sinking between {:.6g} and {:.6g} mm",
      lower, upper));
}

}  // namespace rollfem::halfspace
