// SPDX-License-Identifier: LGPL-2.1-or-later
#include "models/stress/stress_request.hpp"

#include "contact/base/errors.hpp"
#include "contact/case/case_reader.hpp"
#include "postprocess/stress/shakedown.hpp"
#include "postprocess/stress/stress_report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>

namespace rollfem::modelling {

using contact::InputError;

namespace {

/// Whether a line and both sides of a plane have a length; otherwise they cannot be drawn.
bool has_length(const contact::SubsurfaceRequest& places) {
  using Kind = contact::SubsurfaceRequest::Kind;
  if (places.kind == Kind::point) return true;
  return places.to != places.from && (places.kind != Kind::plane || places.across != places.from);
}

}  // namespace

std::vector<NamedRequest> named_requests(const StressRequest& request) {
  std::vector<NamedRequest> all;
  if (request.places.empty()) return all;
  std::map<std::string, int> counts;
  for (const contact::SubsurfaceRequest& places : contact::read_places(request.places)) {
    const std::string kind = word_of(places.kind);
    const std::string name = fmt::format("{}_{}", kind, ++counts[kind]);
    if (!has_length(places))
      throw InputError(fmt::format("{}: {}: two of its points coincide; do: move one of them",
                                   request.places, name));
    all.push_back({name, fmt::format("{}: {}", request.places, name), places});
  }
  return all;
}

std::optional<double> yield_shear_stress(const StressRequest& request) {
  if (request.yield_shear_stress && request.yield_strength)
    throw InputError(
        "--yield-shear-stress and --yield-strength exclude each other; allowed: one of them; do: "
        "leave one out (k = Y / sqrt(3))");
  const auto positive = [](const char* name, double value) {
    if (!(value > 0.0) || !std::isfinite(value))
      throw InputError(
          fmt::format("{} {}: allowed: a stress > 0 in MPa; do: give one", name, value));
    return value;
  };
  if (request.yield_shear_stress)
    return positive("--yield-shear-stress", *request.yield_shear_stress);
  if (request.yield_strength)
    return postprocess::yield_shear_stress(positive("--yield-strength", *request.yield_strength));
  return std::nullopt;
}

}  // namespace rollfem::modelling
