// SPDX-License-Identifier: LGPL-2.1-or-later
#include "models/stress/stress_choice.hpp"

#include "contact/base/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rollfem::modelling {
namespace {

using contact::InputError;
using contact::ModelResult;
using contact::PointResult;
using postprocess::ResultsFile;
using postprocess::StoredModel;

std::string patch_name(const StoredModel& model) {
  return fmt::format("{},{},{}", model.place->left ? "left" : "right", model.place->position,
                     model.place->patch);
}

template <class Range, class Name>
std::string listed(const Range& range, const Name& name) {
  std::vector<std::string> once;
  std::string text;
  for (const auto& entry : range) {
    const std::string one = name(entry);
    if (std::find(once.begin(), once.end(), one) != once.end()) continue;
    once.push_back(one);
    text += (text.empty() ? "" : ", ") + one;
  }
  return text;
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

}  // namespace

std::vector<StoredModel> chosen_models(const ResultsFile& file, const StressRequest& request,
                                       const contact::ModelRegistry& models) {
  return models_by_name(models_of_patch(file, request.patch), request, models);
}

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

bool in_bodies(const std::string& model, const contact::ModelRegistry& models) {
  const contact::ModelInfo* info = models.find(model);
  return info != nullptr && info->keeps_bodies;
}

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

}  // namespace rollfem::modelling
