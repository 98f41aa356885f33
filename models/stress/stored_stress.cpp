// SPDX-License-Identifier: LGPL-2.1-or-later
#include "models/stress/stored_stress.hpp"

#include "contact/base/errors.hpp"
#include "contact/result/stress_extremes.hpp"
#include "halfspace/stress/stress_maxima.hpp"
#include "models/stress/stress_places.hpp"
#include "postprocess/read/body_sampler.hpp"
#include "postprocess/read/results_reader.hpp"
#include "postprocess/stress/shakedown.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rollfem::modelling {
namespace {

using contact::InputError;
using contact::ModelResult;
using contact::PointResult;
using postprocess::ResultsFile;
using postprocess::StoredModel;
using postprocess::StressOfModel;
using postprocess::StressSet;

std::string patch_name(const StoredModel& model) {
  return model.place->key(',');
}

template <class Range, class Name>
std::string listed(const Range& range, const Name& name) {
  std::vector<std::string> once;
  for (const auto& entry : range)
    if (std::find(once.begin(), once.end(), name(entry)) == once.end()) once.push_back(name(entry));
  return contact::listed(once);
}

/// The models of the requested patch.
std::vector<StoredModel> models_of_patch(const ResultsFile& file, const std::string& patch) {
  if (file.models().empty())
    throw InputError(fmt::format("{} holds no models; do: run a case", file.path()));
  const bool placed = file.models().front().place.has_value();
  if (!patch.empty() && !placed)
    throw InputError(
        fmt::format("--patch {}: {} comes from a case without profiles and has one patch; do: "
                    "leave --patch out",
                    patch, file.path()));
  const std::string wanted = patch.empty() && placed ? patch_name(file.models().front()) : patch;
  std::vector<StoredModel> found;
  for (const StoredModel& model : file.models())
    if (!placed || patch_name(model) == wanted) found.push_back(model);
  if (found.empty())
    throw InputError(
        fmt::format("--patch {}: no such patch in {}; allowed: {}; do: name one of them", patch,
                    file.path(), listed(file.models(), patch_name)));
  return found;
}

/// The requested models, otherwise those with stress, otherwise the first one.
std::vector<StoredModel> models_by_name(const std::vector<StoredModel>& there,
                                        const StressRequest& request,
                                        const contact::ModelRegistry& models) {
  std::vector<StoredModel> chosen;
  const auto take = [&](const std::string& name) {
    for (const StoredModel& model : there)
      if (model.name == name) chosen.push_back(model);
  };
  for (const std::string& name : request.models) {
    const std::size_t before = chosen.size();
    take(name);
    if (chosen.size() == before)
      throw InputError(fmt::format(
          "--model {}: it is not in {}; allowed: {}; do: name one of them", name, request.result,
          listed(there, [](const StoredModel& model) { return model.name; })));
  }
  if (!request.models.empty()) return chosen;
  for (const std::string& name : models.names(&contact::ModelInfo::has_stress)) take(name);
  if (chosen.empty()) chosen.push_back(there.front());
  return chosen;
}

std::size_t numbered(const ModelResult& model, int point) {
  const int count = static_cast<int>(model.points.size());
  if (point < 1 || point > count)
    throw InputError(
        fmt::format("--point {}: model {} has load points 1 to {}; do: name one of them", point,
                    model.key(), count));
  return static_cast<std::size_t>(point) - 1;
}

std::size_t with_creepage(const ModelResult& model, double creepage) {
  for (std::size_t k = 0; k < model.points.size(); ++k) {
    const double xi = model.points[k].creepage.longitudinal;
    if (std::abs(xi - creepage) <= 1e-9 * std::max(std::abs(xi), 1e-6)) return k;
  }
  throw InputError(fmt::format(
      "--creepage {:g}: model {} has no such load point; allowed: {}; do: name one of them",
      creepage, model.key(), listed(model.points, [](const PointResult& point) {
        return fmt::format("{:g}", point.creepage.longitudinal);
      })));
}

/// Numbers of the requested load points without duplicates; default: the last.
std::vector<std::size_t> chosen_points(const ModelResult& model, const StressRequest& request) {
  if (model.points.empty())
    throw InputError(fmt::format("{}: model {} has no load points; do: run the case again",
                                 request.result, model.key()));
  if (!request.points.empty() && !request.creepages.empty())
    throw InputError(
        "--point and --creepage exclude each other; allowed: one of them; do: leave one out");
  std::vector<std::size_t> chosen;
  const auto take = [&](std::size_t k) {
    if (std::find(chosen.begin(), chosen.end(), k) == chosen.end()) chosen.push_back(k);
  };
  for (const int point : request.points) take(numbered(model, point));
  for (const double creepage : request.creepages) take(with_creepage(model, creepage));
  if (chosen.empty()) chosen.push_back(model.points.size() - 1);
  return chosen;
}

/// Whether stresses come from the stored bodies of wheel and rail instead of sums over the contact
/// elements.
bool in_bodies(const std::string& model, const contact::ModelRegistry& models) {
  const contact::ModelInfo* info = models.find(model);
  return info != nullptr && info->keeps_bodies;
}

/// Refuses load points whose stored data do not give stresses.
void check_stored(const StoredModel& stored, const PointResult& point, std::size_t number,
                  const StressRequest& request, const contact::ModelRegistry& models) {
  if (!in_bodies(stored.name, models)) {
    if (point.fields.traction.n.size() == 0)
      throw InputError(fmt::format(
          "{}: model {} stores no tractions at load point {}; do: name another with "
          "--point or --model, or run the case again with [output] grid_fields = \"all\"",
          request.result, stored.key, number + 1));
    return;
  }
  const std::vector<std::size_t>& kept = stored.points_with_bodies;
  if (kept.empty())
    throw InputError(fmt::format(
        "{}: the bodies of model {} are not stored; do: run the case again with [output] "
        "body_fields = \"all\" (and without fields = false)",
        request.result, stored.key));
  if (std::find(kept.begin(), kept.end(), number) != kept.end()) return;
  throw InputError(fmt::format(
      "load point {}: model {} stores its bodies only for these load points: {}; do: choose one of "
      "them or --model {}, or run the case again with [output] body_fields = \"all\"",
      number + 1, stored.key, listed(kept, [](std::size_t k) { return fmt::format("{}", k + 1); }),
      models.reference().name));
}

/// k from --yield-shear-stress or --yield-strength, MPa; empty if neither is given.
std::optional<double> yield_stress_of(const StressRequest& request) {
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

/// The largest range of xz, from the body's nodes.
contact::StressMaximum largest_range(const contact::BodyField& body, const PointResult& point) {
  const postprocess::BodySampler sampler(body);
  const double sign = body.name == "wheel" ? 1.0 : -1.0;
  const auto within = [&](double value, std::size_t c) {
    return std::clamp(value, sampler.lower()[c], sampler.upper()[c]);
  };
  const contact::RollingLines lines = contact::rolling_lines(
      point, contact::rolling_step(point), contact::rolling_layers,
      [&](double x, double y, double depth) {
        return postprocess::Place{within(x, 0), within(y, 1), within(sign * depth, 2)};
      });
  std::vector<double> xz;
  for (const postprocess::Place& place : lines.places) xz.push_back(sampler.at(place).stress[5]);
  return contact::largest_xz_range(body.name, lines, xz);
}

/// Largest values at the nodes. Between them there are no larger ones: each measure is a convex
/// function of the stress, and the interpolated stress is a mean of those of the nodes. On a curved
/// surface nodes have a small z.
std::vector<contact::StressMaximum> largest_at_nodes(const ModelResult& model, std::size_t point) {
  std::vector<contact::StressMaximum> maxima;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const contact::BodyField body = model.body_at(point, b);
    const double near_surface = 0.5 * model.grid.longer_side();
    for (const auto& found :
         postprocess::largest_stresses(body.name, body.points, body.stress, 0.0, near_surface))
      maxima.push_back(found);
    maxima.push_back(contact::largest_surface_shear(body.name, model.grid, model.points.at(point)));
    maxima.push_back(largest_range(body, model.points.at(point)));
  }
  return maxima;
}

/// Raises the largest values to those at the requested places: the search skips depths below one
/// element, which matters if elements are long. Ignores places closer to the surface than `least`
/// but not on it.
void add_largest_of_sets(const std::vector<StressSet>& sets, double least,
                         std::vector<contact::StressMaximum>& maxima) {
  for (const StressSet& set : sets)
    for (const auto& found :
         postprocess::largest_stresses(set.field.request.wheel ? "wheel" : "rail", set.field.points,
                                       set.field.stress, least, least))
      for (contact::StressMaximum& maximum : maxima)
        if (maximum.measure == found.measure && found.measure != contact::surface_shear &&
            maximum.body == found.body && found.value > maximum.value)
          maximum = found;
}

StressOfModel stress_of(const contact::Case& input, ModelResult model, std::size_t number,
                        const std::vector<NamedRequest>& asked, const StressRequest& request,
                        const contact::ModelRegistry& models) {
  const PointResult& point = model.points[number];
  std::vector<NamedRequest> requests = asked;
  if (request.depth_profile || asked.empty()) {
    const auto profiles = depth_profiles(model, number, request);
    requests.insert(requests.begin(), profiles.begin(), profiles.end());
  }
  StressOfModel found;
  found.point = number;
  const contact::ModelInfo* info = models.find(model.name);
  const bool bodies = in_bodies(model.name, models);
  if (info != nullptr && info->corrects_stress) {
    found.sets = hybrid_sets(input, model, number, requests, found.maxima);
    found.result = std::move(model);
    return found;
  }
  found.sets =
      bodies ? body_sets(model, number, requests) : halfspace_sets(input, model, number, requests);
  found.maxima = point.stress_maxima;
  if (found.maxima.empty())
    found.maxima = bodies ? largest_at_nodes(model, number)
                          : halfspace::stress_maxima(input, model.grid, point);
  const double element = model.grid.longer_side();
  add_largest_of_sets(found.sets, bodies ? 0.0 : 0.5 * element, found.maxima);
  found.result = std::move(model);
  return found;
}

}  // namespace

postprocess::StressReport stored_stress(const StressRequest& request,
                                        const contact::ModelRegistry& models,
                                        std::vector<std::string>& warnings) {
  const std::vector<NamedRequest> asked = named_requests(request);
  postprocess::StressReport report;
  report.yield_shear_stress = yield_stress_of(request);

  const ResultsFile file(request.result);
  report.source = file.path();
  report.title = file.input().title;
  report.point_named = !request.points.empty() || !request.creepages.empty();
  std::vector<std::string> left_out;
  for (const StoredModel& stored :
       models_by_name(models_of_patch(file, request.patch), request, models)) {
    const ModelResult whole = file.read(stored);
    for (const std::size_t point : chosen_points(whole, request)) {
      try {
        check_stored(stored, whole.points[point], point, request, models);
      } catch (const InputError& error) {
        if (left_out.empty() || left_out.back() != error.what())
          left_out.emplace_back(error.what());
        continue;
      }
      ModelResult model = whole;
      if (in_bodies(stored.name, models)) file.read_bodies(stored, point, model);
      report.models.push_back(
          stress_of(file.input(), std::move(model), point, asked, request, models));
    }
  }
  if (report.models.empty()) throw InputError(left_out.front());
  for (const std::string& why : left_out) warnings.push_back("left out: " + why);
  return report;
}

}  // namespace rollfem::modelling
