// SPDX-License-Identifier: LGPL-2.1-or-later
// The command `rollfem bench`: error and run time of each model on this machine in cases with known
// solutions.
#include "app/frame/command_frame.hpp"
#include "app/frame/screen.hpp"
#include "app/run/bench_cases.hpp"
#include "contact/base/errors.hpp"
#include "contact/base/progress.hpp"
#include "contact/case/case_reader.hpp"
#include "contact/result/quantities.hpp"
#include "halfspace/model/halfspace_model.hpp"
#include "models/caches/correction_cache.hpp"
#include "models/registry.hpp"
#include "models/solving/solving.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

namespace rollfem::app {

namespace {

using contact::ModelResult;
using Json = nlohmann::ordered_json;

struct BenchRequest : ComputingRequest {
  using ComputingRequest::ComputingRequest;
  bool json = false;   ///< print JSON, and progress of the models on stderr
  bool quick = false;  ///< one case on coarse grids, without models that mesh bodies
};

/// Elements across of the half-space.
const std::vector<int> grids{24, 40, 80}, quick_grids{24, 40};
constexpr int grid_of_theories = 40;
/// Resolution of models that mesh bodies: elements across of the hybrid, cells across of finite
/// elements.
constexpr int grid_of_hybrid = 24, cells_of_fem = 16;

/// Result of a model on a case.
struct Row {
  std::optional<double> pressure_error, force_error;  ///< parts of the whole
  double seconds = 0.0;
};

Row row_of(const BenchCase& given, const ModelResult& result) {
  Row row;
  if (given.max_pressure > 0.0 && !result.points.empty())
    row.pressure_error = result.points.front().max_pressure / given.max_pressure - 1.0;
  if (result.has_friction())
    for (const BenchLimit& limit : given.limits) {
      if (limit.point >= result.points.size()) continue;
      const auto value = contact::quantity_named(limit.quantity).value(result.points[limit.point]);
      if (!value) continue;
      const double error = (*value - limit.value) / limit.whole;
      if (!row.force_error || std::abs(error) > std::abs(*row.force_error)) row.force_error = error;
    }
  return row;
}

std::string percent_of(const std::optional<double>& part) {
  if (!part) return "-";
  const double rounded = std::abs(*part) < 5e-6 ? 0.0 : 100.0 * *part;
  return fmt::format("{:+.3f} %", rounded);
}

class Bench {
 public:
  Bench(const BenchRequest& request, const modelling::Solving& how)
      : request_(request), models_(request.call.models), how_(how) {
    how_.go_on = true;
  }

  void run() {
    for (const BenchCase& given : bench_cases()) {
      print(fmt::format("\n{}: {}\n{:<20}{:>8}{:>13}{:>13}{:>10}\n", given.name, given.sentence,
                        "model", "across", "p0", "force", "seconds"));
      for (const contact::ModelInfo& model : models_.all())
        if (!model.chooses && model.built) solve_by(model, given);
      if (request_.quick) break;
    }
    print(
        "\np0: error against Hertz; force: largest difference from the converged half-space,\nin "
        "percent of full sliding; seconds: all load points of the case together\n");
    if (!request_.json || !how_.first) return;
    Json json = result_head("bench");
    json["rows"] = rows_;
    print_result(json.dump(1));
  }

 private:
  void print(const std::string& text) const {
    if (how_.first) std::cout << text << std::flush;
  }

  void solve_by(const contact::ModelInfo& model, const BenchCase& given) {
    const bool meshes_bodies = model.has_stress && model.name != models_.reference().name;
    if (meshes_bodies && (request_.quick || !given.of_bodies)) return;
    std::vector<int> all{model.keeps_bodies ? cells_of_fem : grid_of_hybrid};
    if (!model.has_stress) all = {grid_of_theories};
    if (model.name == models_.reference().name) all = request_.quick ? quick_grids : grids;
    for (const int across : all) tell(given, model, across, solved(given, model.name, across));
  }

  contact::Case input_of(const BenchCase& given, const std::string& model, int across) const {
    const auto parsed = [&](const std::string& keys) {
      return contact::parse_case(given.text + keys, "bench " + given.name,
                                 modelling::model_words(models_));
    };
    contact::Case input = parsed(fmt::format("[contact_grid]\nelements_across = {}\n", across));
    if (models_.at(model).keeps_bodies) {
      const halfspace::PatchExtent extent = halfspace::PatchSearch(contact::Scene(input)).extent();
      input = parsed(
          fmt::format("[fem]\ncell_size = {}\n", std::min(extent.length, extent.width) / across));
    }
    input.models = {model};
    return input;
  }

  /// Empty if the model cannot take the case.
  std::optional<Row> solved(const BenchCase& given, const std::string& model, int across) {
    postprocess::RunRecord record;
    record.input = input_of(given, model, across);
    const contact::Stopwatch watch;
    modelling::solve(record, how_);
    if (record.models.empty()) return {};
    Row row = row_of(given, record.models.front());
    row.seconds = watch.seconds();
    return row;
  }

  void tell(const BenchCase& given, const contact::ModelInfo& model, int across,
            const std::optional<Row>& row) {
    if (!row) return;
    Json json{{"case", given.name}, {"model", model.name}};
    if (!model.refinements.empty()) json["elements_across"] = across;
    if (row->pressure_error) json["pressure_error"] = *row->pressure_error;
    if (row->force_error) json["force_error"] = *row->force_error;
    json["seconds"] = row->seconds;
    rows_.push_back(json);
    print(fmt::format("{:<20}{:>8}{:>13}{:>13}{:>10.3f}\n", model.name,
                      model.refinements.empty() ? "-" : fmt::format("{}", across),
                      percent_of(row->pressure_error), percent_of(row->force_error), row->seconds));
  }

  const BenchRequest& request_;
  const contact::ModelRegistry& models_;
  modelling::Solving how_;
  std::vector<Json> rows_;  ///< as printed with --json
};

void bench(const BenchRequest& request) {
  std::vector<std::string> names;
  for (const contact::ModelInfo& model : request.call.models.all())
    if (!model.chooses && model.built && !(request.quick && model.parallel))
      names.push_back(model.name);
  ComputingRequest silent = request;
  silent.quiet = request.quiet || !request.json;
  CommandFrame frame(silent, names);
  if (frame.idle()) return;
  if (frame.first())
    std::cout << fmt::format(
        "rollfem bench: errors and seconds of the models on this machine, {} processors\n",
        std::thread::hardware_concurrency());
  modelling::CorrectionCache::switch_off();
  frame.compute("rollfem bench", "cases",
                [&](const modelling::Solving& how) { Bench(request, how).run(); });
}

}  // namespace

void add_bench(CLI::App& program, Call& call) {
  const auto request = std::make_shared<BenchRequest>(call);
  CLI::App* bench = program.add_subcommand(
      "bench",
      "measure error and run time of each model on this machine, in cases with known solutions");
  bench->add_flag("--quick", request->quick, "one case on coarse grids, about a second");
  add_json_flag(*bench, request->json);
  bench->add_flag_callback(
      "-q,--quiet",
      [request] {
        request->quiet = true;
        silence();
      },
      "print errors and warnings only");
  bench->footer("example: rollfem bench");
  bench->callback([request] { app::bench(*request); });
}

}  // namespace rollfem::app
