#include "contact/case/abilities.hpp"

#include "contact/base/errors.hpp"
#include "contact/case/case_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rollfem::contact {

namespace {

/// Something that a case may ask for, and the models that can take it.
struct Demand {
  const char* key;
  const char* what;
  bool (*asked)(const Case&);
  std::vector<std::string> models;
};

bool any_force(const Case& input) {
  const auto& forces = input.rolling.forces;
  return std::any_of(forces.begin(), forces.end(),
                     [](const PrescribedForce& f) { return f.any(); });
}

bool load_history(const Case& input) {
  const auto& steps = input.history;
  return std::any_of(steps.begin(), steps.end(), [](const HistoryStep& step) {
    return step.normal_force.has_value() || step.approach.has_value();
  });
}

bool is_history(const Case& input) {
  return input.rolling.problem == Problem::shift || input.rolling.problem == Problem::transient;
}

bool any_rigid(const Case& input) {
  return std::isinf(input.wheel.material.young_modulus) ||
         std::isinf(input.rail.material.young_modulus);
}

/// Points of a concave body on the other body's side of z = 0, where a half-space ends.
bool beyond_half_space(const Case& input) {
  return std::any_of(input.subsurface.begin(), input.subsurface.end(),
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

const std::vector<Demand>& demands() {
  // Hertz's theory knows no friction: it takes any problem, and gives the patch alone.
  static const std::vector<std::string> elliptic{"hertz",   "linear", "vermeulen-johnson", "carter",
                                                 "fastsim", "strip",  "halfspace"};
  static const std::vector<Demand> all{
      {"rolling.problem", "shift or transient", is_history, {"hertz", "halfspace"}},
      {"rolling.longitudinal_force or lateral_force",
       "a prescribed tangential force",
       any_force,
       {"hertz", "halfspace"}},
      {"history.normal_force or approach",
       "a load that changes from step to step",
       load_history,
       {"halfspace"}},
      {"wheel.profile and rail.profile",
       "true profiles",
       [](const Case& c) { return c.patch != nullptr; },
       {"hertz", "linear", "vermeulen-johnson", "fastsim", "strip", "fem", "halfspace"}},
      {"rolling.extra_slip",
       "extra slip on true profiles",
       [](const Case& c) { return c.patch && c.rolling.extra_slip != ExtraSlip::none; },
       {"hertz", "strip", "halfspace"}},
      {"undeformed_distance.file",
       "bodies given point by point",
       [](const Case& c) { return c.undeformed_distance.values.has_value(); },
       {"halfspace"}},
      {"undeformed_distance.quadratic", "bodies without radii",
       [](const Case& c) { return c.undeformed_distance.quadratic.has_value(); }, elliptic},
      {"given_pressure", "a given pressure",
       [](const Case& c) { return c.given_pressure.has_value(); }, elliptic},
      {"young_modulus = inf", "a rigid body", any_rigid, elliptic},
      {"fem.inertia", "the inertia of moving bodies", feels_inertia, {"fem"}},
      {"subsurface",
       "points of a concave body beyond z = 0, where the half-space ends ([[subsurface.surface]] "
       "follows the surface in both)",
       beyond_half_space,
       {"hertz", "linear", "vermeulen-johnson", "carter", "fastsim", "strip", "fem"}},
  };
  return all;
}

}  // namespace

void check_able(const Case& input, const std::string& model) {
  for (const Demand& demand : demands()) {
    if (!demand.asked(input)) continue;
    if (std::find(demand.models.begin(), demand.models.end(), model) != demand.models.end())
      continue;
    const std::string able = joined(demand.models);
    throw InputError(
        fmt::format("{}: model {}: {}: it cannot take {}; allowed: {}; do: run with "
                    "--model {}, or change the case",
                    input.file, model, demand.key, demand.what, able, demand.models.back()));
  }
}

}  // namespace rollfem::contact
