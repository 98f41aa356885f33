#include "app/stress.hpp"

#include "app/files_together.hpp"
#include "app/places.hpp"
#include "contact/errors.hpp"
#include "contact/stress_measures.hpp"
#include "halfspace/stress_maxima.hpp"
#include "halfspace/subsurface.hpp"
#include "halfspace/subsurface_fields.hpp"
#include "postprocess/body_sampler.hpp"
#include "postprocess/output.hpp"
#include "postprocess/results_reader.hpp"
#include "postprocess/stress_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <utility>

namespace fs = std::filesystem;

namespace rollfem::app {
namespace {

using contact::InputError;
using contact::ModelResult;
using contact::PointResult;
using contact::SubsurfaceField;
using contact::SubsurfaceRequest;
using postprocess::BodySampler;
using postprocess::ResultsFile;
using postprocess::StoredModel;
using postprocess::StressOfModel;
using postprocess::StressSet;

constexpr int profile_points = 121;
constexpr double profile_depth = 3.0;  ///< in smaller semi-axes

bool is_fem(const std::string& name) {
  return name == "fem";
}

std::string patch_name(const StoredModel& model) {
  return fmt::format("{},{},{}", model.left ? "left" : "right", model.position, model.patch);
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

/// The models of the patch that is asked for.
std::vector<StoredModel> models_of_patch(const ResultsFile& file, const std::string& patch) {
  if (file.models().empty())
    throw InputError(fmt::format("{} holds no models; do: run a case", file.path()));
  const bool placed = file.models().front().placed;
  if (!patch.empty() && !placed)
    throw InputError(
        fmt::format("--patch {}: {} is of a case without profiles and has one patch; do: leave "
                    "--patch out",
                    patch, file.path()));
  const std::string wanted = patch.empty() && placed ? patch_name(file.models().front()) : patch;
  std::vector<StoredModel> found;
  for (const StoredModel& model : file.models())
    if (!placed || patch_name(model) == wanted) found.push_back(model);
  if (found.empty())
    throw InputError(
        fmt::format("--patch {}: there is no such patch in {}; allowed: {}; do: name "
                    "one of them",
                    patch, file.path(), listed(file.models(), patch_name)));
  return found;
}

/// The models that are asked for, else half-space and finite elements, else the first there is.
std::vector<StoredModel> chosen_models(const std::vector<StoredModel>& there,
                                       const StressRequest& request) {
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
  take("halfspace");
  take("fem");
  if (chosen.empty()) chosen.push_back(there.front());
  return chosen;
}

std::size_t chosen_point(const ModelResult& model, const StressRequest& request) {
  if (model.points.empty())
    throw InputError(fmt::format("{}: model {} has no load points; do: run the case again",
                                 request.result, model.key()));
  const int count = static_cast<int>(model.points.size());
  if (request.point && request.creepage)
    throw InputError(
        "--point and --creepage are both given; allowed: one of them; do: leave one out");
  if (request.point) {
    if (*request.point < 0 || *request.point >= count)
      throw InputError(
          fmt::format("--point {}: model {} has load points 0 to {}; do: name one of "
                      "them",
                      *request.point, model.key(), count - 1));
    return static_cast<std::size_t>(*request.point);
  }
  if (!request.creepage) return model.points.size() - 1;
  for (std::size_t k = 0; k < model.points.size(); ++k) {
    const double xi = model.points[k].creepage.longitudinal;
    if (std::abs(xi - *request.creepage) <= 1e-9 * std::max(std::abs(xi), 1e-6)) return k;
  }
  throw InputError(fmt::format(
      "--creepage {:g}: model {} has no load point of it; allowed: {}; do: name one of them",
      *request.creepage, model.key(), listed(model.points, [](const PointResult& point) {
        return fmt::format("{:g}", point.creepage.longitudinal);
      })));
}

struct Spot {
  double x = 0.0;
  double y = 0.0;
};

/// Middle of the elements that carry pressure, and of the one that carries most.
std::pair<Spot, Spot> spots(const contact::ContactGrid& grid, const contact::Field& pressure) {
  Spot centre;
  int count = 0;
  Eigen::Index most = 0;
  pressure.maxCoeff(&most);
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      if (pressure[grid.index(i, j)] > 0.0) {
        centre.x += grid.x(i);
        centre.y += grid.y(j);
        ++count;
      }
  const auto clean = [](double sum, int n, double size) {
    const double mean = n > 0 ? sum / n : 0.0;
    return std::abs(mean) < 1e-9 * size ? 0.0 : mean;
  };
  centre = {clean(centre.x, count, grid.dx), clean(centre.y, count, grid.dy)};
  const int k = static_cast<int>(most);
  return {centre, {grid.x(k % grid.nx), grid.y(k / grid.nx)}};
}

/// Lines from the surface down under the centre of the patch, and under the most loaded element
/// unless the centre is in it.
std::vector<NamedRequest> depth_profiles(const ModelResult& model, const PointResult& point,
                                         const StressRequest& request) {
  const double semi_axis = std::min(point.semi_axis_x, point.semi_axis_y);
  const double depth = request.depth.value_or(profile_depth * semi_axis);
  if (!(depth > 0.0) || !std::isfinite(depth))
    throw InputError(
        request.depth
            ? fmt::format("--depth {:g}: allowed: a depth > 0 in mm; do: name one", *request.depth)
            : fmt::format("model {} does not give the size of the patch; do: name a --depth",
                          model.key()));
  const auto [centre, most] = spots(model.grid, point.fields.traction.n);
  const bool apart = std::abs(most.x - centre.x) > 0.51 * model.grid.dx ||
                     std::abs(most.y - centre.y) > 0.51 * model.grid.dy;
  std::vector<NamedRequest> profiles;
  const auto add = [&](const char* name, const Spot& spot) {
    for (const bool wheel : {true, false}) {
      if (!request.body.empty() && request.body != (wheel ? "wheel" : "rail")) continue;
      SubsurfaceRequest line;
      line.kind = SubsurfaceRequest::Kind::line;
      line.wheel = wheel;
      line.from = {spot.x, spot.y, 0.0};
      line.to = {spot.x, spot.y, wheel ? depth : -depth};
      line.points = {profile_points, 1};
      profiles.push_back({name, "depth profile", line});
    }
  };
  add("depth_centre", centre);
  if (apart) add("depth_most_loaded", most);
  return profiles;
}

/// A half-space has no material beyond z = 0.
void refuse_beyond_surface(const NamedRequest& named, const std::string& model) {
  for (const auto& place : halfspace::subsurface_points(named.request))
    if ((named.request.wheel ? place[2] : -place[2]) < 0.0)
      throw InputError(fmt::format(
          "{}: ({:g}, {:g}, {:g}) mm is not in the {} of model {}, a half-space with z {} 0; do: "
          "name places in it, or leave --body out",
          named.call, place[0], place[1], place[2], named.request.wheel ? "wheel" : "rail", model,
          named.request.wheel ? ">=" : "<="));
}

/// On the surface the steps of the tractions from element to element make the stress along it
/// infinite at their edges. Places there get the stress interpolated between the middles of the
/// four elements around them, where it is good.
void smooth_surface(const halfspace::LoadedBody& body, SubsurfaceField& field) {
  std::vector<std::size_t> places;
  std::vector<halfspace::SubsurfacePoint> middles;
  std::vector<std::array<double, 2>> shares;
  for (std::size_t k = 0; k < field.points.size(); ++k) {
    if (field.points[k][2] != 0.0) continue;
    const double i = (field.points[k][0] - body.grid.x_first) / body.grid.dx;
    const double j = (field.points[k][1] - body.grid.y_first) / body.grid.dy;
    places.push_back(k);
    shares.push_back({i - std::floor(i), j - std::floor(j)});
    for (const int b : {0, 1})
      for (const int a : {0, 1})
        middles.push_back({body.grid.x_first + (std::floor(i) + a) * body.grid.dx,
                           body.grid.y_first + (std::floor(j) + b) * body.grid.dy, 0.0});
  }
  if (places.empty()) return;
  const auto states = halfspace::subsurface_at(body, middles);
  for (std::size_t k = 0; k < places.size(); ++k) {
    std::array<double, 6>& stress = field.stress[places[k]];
    stress.fill(0.0);
    for (std::size_t corner = 0; corner < 4; ++corner) {
      const auto [s, t] = shares[k];
      const double weight = (corner % 2 == 1 ? s : 1.0 - s) * (corner / 2 == 1 ? t : 1.0 - t);
      const auto values = states[4 * k + corner].stress.as_array();
      for (std::size_t c = 0; c < 6; ++c) stress[c] += weight * values[c];
    }
  }
}

std::vector<StressSet> halfspace_sets(contact::Case input, const ModelResult& model,
                                      const PointResult& point,
                                      const std::vector<NamedRequest>& requests) {
  for (const NamedRequest& named : requests) {
    refuse_beyond_surface(named, model.key());
    input.subsurface.push_back(named.request);
  }
  std::vector<StressSet> sets;
  for (SubsurfaceField& field :
       halfspace::subsurface_fields(input, model.grid, point.fields.traction)) {
    const bool wheel = field.request.wheel;
    smooth_surface(
        {wheel ? halfspace::Body::wheel : halfspace::Body::rail,
         wheel ? input.wheel.material : input.rail.material, model.grid, point.fields.traction},
        field);
    sets.push_back({requests[sets.size()].name, std::move(field), 0.0});
  }
  return sets;
}

/// The finite-element bodies of a model, ready for interpolation.
class Bodies {
 public:
  explicit Bodies(const ModelResult& model) {
    for (const contact::BodyField& body : model.bodies)
      (body.name == "wheel" ? wheel_ : rail_) = std::make_unique<BodySampler>(body);
  }

  std::vector<StressSet> sets(const std::vector<NamedRequest>& requests, double semi_axis) const {
    std::vector<StressSet> found;
    for (const NamedRequest& named : requests) found.push_back(set(named, semi_axis));
    return found;
  }

 private:
  StressSet set(const NamedRequest& named, double semi_axis) const {
    const BodySampler* body = named.request.wheel ? wheel_.get() : rail_.get();
    if (body == nullptr)
      throw InputError(fmt::format("{}: the {} is not stored; do: run the case again", named.call,
                                   named.request.wheel ? "wheel" : "rail"));
    StressSet set;
    set.name = named.name;
    set.field.request = named.request;
    auto places = halfspace::subsurface_points(named.request);
    if (named.call == "depth profile") {
      // Depth counts from the surface, which is at z = 0 in the middle of the patch only.
      const double side = named.request.wheel ? 1.0 : -1.0;
      const double surface = body->surface(places.front()[0], places.front()[1],
                                           side * 0.5 * semi_axis, -side * 0.5 * semi_axis);
      for (auto& place : places) place[2] += surface;
    }
    for (const auto& place : places) {
      try {
        const postprocess::BodySample sample = body->at(place);
        set.field.points.push_back(sample.place);
        set.field.displacement.push_back(sample.displacement);
        set.field.stress.push_back(sample.stress);
        set.moved = std::max(set.moved, sample.moved);
      } catch (const InputError& error) {
        throw InputError(fmt::format("{}: {}", named.call, error.what()));
      }
    }
    return set;
  }

  std::unique_ptr<BodySampler> wheel_;
  std::unique_ptr<BodySampler> rail_;
};

/// Largest values at the nodes. Between them there are no larger ones: each measure is a convex
/// function of the stress, and the interpolated stress is a mean of those of the nodes.
std::vector<contact::StressMaximum> largest_at_nodes(const ModelResult& model) {
  std::vector<contact::StressMaximum> maxima;
  for (const contact::BodyField& body : model.bodies)
    for (const contact::StressMeasure& measure : contact::reported_measures()) {
      contact::StressMaximum best{body.name, measure.name, -contact::infinity, {}};
      for (std::size_t k = 0; k < body.stress.size(); ++k) {
        const double value = measure.value(contact::Stress::from_array(body.stress[k]));
        if (value > best.value) best = {body.name, measure.name, value, body.points[k]};
      }
      maxima.push_back(best);
    }
  return maxima;
}

/// Throws contact::InputError where stresses cannot be had from what is stored.
void check_stored(const ModelResult& model, std::size_t point, const StressRequest& request) {
  if (is_fem(model.name)) {
    if (model.bodies.empty())
      throw InputError(fmt::format(
          "{}: the bodies of model {} are not stored; they are in results of this version unless "
          "the case has [output] fields = false; do: run the case again",
          request.result, model.key()));
    if (point + 1 != model.points.size())
      throw InputError(fmt::format(
          "{}: of model {} the bodies are stored for the last load point, {}, only; do: ask for "
          "that, or for --model halfspace, or give the case [[subsurface.*]] requests",
          request.point ? fmt::format("--point {}", *request.point)
                        : fmt::format("--creepage {:g}", request.creepage.value_or(0.0)),
          model.key(), model.points.size() - 1));
    return;
  }
  if (model.points[point].fields.traction.n.size() == 0)
    throw InputError(fmt::format("{}: model {} stores no tractions; do: name another with --model",
                                 request.result, model.key()));
}

/// Largest values that the places asked for show and the search has missed: it leaves out depths of
/// less than an element, which counts where elements are long. Places nearer to the surface than
/// `least`, but not on it, are left out.
void add_largest_of_sets(const std::vector<StressSet>& sets, double least,
                         std::vector<contact::StressMaximum>& maxima) {
  for (const StressSet& set : sets)
    for (std::size_t k = 0; k < set.field.points.size(); ++k) {
      const double depth = std::abs(set.field.points[k][2]);
      if (depth > 0.0 && depth < least) continue;
      const contact::Stress stress = contact::Stress::from_array(set.field.stress[k]);
      for (const contact::StressMeasure& measure : contact::reported_measures())
        for (contact::StressMaximum& maximum : maxima) {
          if (maximum.measure != measure.name ||
              (maximum.body == "wheel") != set.field.request.wheel)
            continue;
          const double value = measure.value(stress);
          if (value <= maximum.value) continue;
          maximum.value = value;
          maximum.place = set.field.points[k];
        }
    }
}

StressOfModel stress_of(const ResultsFile& file, ModelResult model, std::size_t number,
                        const std::vector<NamedRequest>& asked, const StressRequest& request) {
  const PointResult& point = model.points[number];
  std::vector<NamedRequest> requests = asked;
  if (request.depth_profile || asked.empty()) {
    const auto profiles = depth_profiles(model, point, request);
    requests.insert(requests.begin(), profiles.begin(), profiles.end());
  }
  StressOfModel found;
  found.point = number;
  if (is_fem(model.name))
    found.sets = Bodies(model).sets(requests, std::min(point.semi_axis_x, point.semi_axis_y));
  else
    found.sets = halfspace_sets(file.input(), model, point, requests);
  found.maxima = point.stress_maxima;
  if (found.maxima.empty())
    found.maxima = is_fem(model.name) ? largest_at_nodes(model)
                                      : halfspace::stress_maxima(file.input(), model.grid, point);
  const double element = std::max(model.grid.dx, model.grid.dy);
  add_largest_of_sets(found.sets, is_fem(model.name) ? 0.0 : 0.5 * element, found.maxima);
  model.bodies.clear();
  found.result = std::move(model);
  return found;
}

/// results/thesis_a_stress for results/thesis_a.
fs::path output_folder(const ResultsFile& file, const StressRequest& request) {
  if (!request.directory.empty()) return request.directory;
  std::error_code error;
  const fs::path folder = fs::weakly_canonical(fs::absolute(file.directory()), error);
  return fs::path(file.directory()) / ".." / (folder.filename().string() + "_stress");
}

/// Figures of an earlier call that this one may not draw.
void remove_figures(const fs::path& folder) {
  std::error_code error;
  if (!fs::exists(folder / "stress.json", error)) return;
  for (fs::directory_iterator entry(folder / "figures", error), end; !error && entry != end;
       entry.increment(error))
    for (const char* ours : {"depth_", "line_", "plane_", "shakedown_map"})
      if (entry->path().extension() == ".svg" &&
          entry->path().filename().string().rfind(ours, 0) == 0)
        fs::remove(entry->path(), error);
}

}  // namespace

void stress(const StressRequest& request) {
  const std::vector<NamedRequest> asked = named_requests(request);
  postprocess::StressReport report;
  report.yield_shear_stress = yield_shear_stress(request);

  const ResultsFile file(request.result);
  report.source = file.path();
  report.title = file.input().title;
  std::string left_out;
  for (const StoredModel& stored : chosen_models(models_of_patch(file, request.patch), request)) {
    ModelResult model = file.read(stored);
    const std::size_t point = chosen_point(model, request);
    try {
      check_stored(model, point, request);
    } catch (const InputError& error) {
      // Only what the user names must be there.
      if (!request.models.empty()) throw;
      left_out = error.what();
      continue;
    }
    report.models.push_back(stress_of(file, std::move(model), point, asked, request));
  }
  if (report.models.empty()) throw InputError(left_out);

  const fs::path folder = output_folder(file, request).lexically_normal();
  FilesTogether files("stress", folder);
  files.write("stress.csv", stress_csv(report));
  files.write("stress.json", stress_json(report));
  remove_figures(folder);
  files.commit();
  std::string problem;
  if (request.figures)
    problem = postprocess::draw_stress(folder.string(), script_directory().string());
  if (!left_out.empty()) std::cerr << "warning: left out: " << left_out << '\n';
  if (!problem.empty())
    std::cerr << "warning: stresses are written, but figures were not drawn: " << problem << '\n';
  if (!request.quiet)
    std::cout << stress_table(report) << "\nstresses: " << folder.string()
              << " (stress.csv, stress.json"
              << (request.figures && problem.empty() ? ", figures" : "") << ")\n";
}

}  // namespace rollfem::app
