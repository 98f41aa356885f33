// SPDX-License-Identifier: LGPL-2.1-or-later
#include "models/stress/stored_stress.hpp"

#include "contact/base/errors.hpp"
#include "contact/result/stress_extremes.hpp"
#include "halfspace/stress/stress_maxima.hpp"
#include "models/stress/stress_choice.hpp"
#include "models/stress/stress_places.hpp"
#include "postprocess/read/body_sampler.hpp"
#include "postprocess/read/results_reader.hpp"

#include <algorithm>
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
    const double near_surface = 0.5 * std::max(model.grid.dx, model.grid.dy);
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
  const double element = std::max(model.grid.dx, model.grid.dy);
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
  report.yield_shear_stress = yield_shear_stress(request);

  const ResultsFile file(request.result);
  report.source = file.path();
  report.title = file.input().title;
  report.point_named = !request.points.empty() || !request.creepages.empty();
  std::vector<std::string> left_out;
  for (const StoredModel& stored : chosen_models(file, request, models)) {
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
