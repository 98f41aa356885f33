// SPDX-License-Identifier: LGPL-2.1-or-later
// The command `rollfem bench`: error and run time of each model on this machine in cases with known
// solutions, and the speed of the machine relative to the one that predictions are based on.
#include "app/frame/command_frame.hpp"
#include "app/frame/screen.hpp"
#include "app/run/bench_cases.hpp"
#include "contact/base/errors.hpp"
#include "contact/base/progress.hpp"
#include "contact/case/case_reader.hpp"
#include "contact/result/quantities.hpp"
#include "halfspace/model/model.hpp"
#include "models/caches/correction_cache.hpp"
#include "models/caches/machine_speed.hpp"
#include "models/choice/forecast.hpp"
#include "models/registry.hpp"
#include "models/solving/auto_model.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
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
  double seconds = 30.0;  ///< time limit; runs expected to exceed it are skipped
  bool json = false;      ///< print JSON, and progress of the models on stderr
  bool quick = false;     ///< one case on coarse grids, nothing stored
};

/// Elements across of the half-space; the last grid measures the speed of the machine.
const std::vector<int> grids{24, 40, 80}, quick_grids{24, 40};
constexpr int grid_of_theories = 40;
/// Resolution of models that mesh bodies: elements across of the hybrid, cells across of finite
/// elements.
constexpr int grid_of_hybrid = 24, cells_of_fem = 16;
/// The smallest of this many measured times counts, because other programs may be running.
constexpr int repeats = 3;

/// Result of a model on a case.
struct Row {
  std::optional<double> pressure_error, force_error;  ///< parts of the whole
  double seconds = 0.0;
  double own_seconds = 0.0;  ///< CPU time if other programs were running; otherwise the same
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
  Bench(const BenchRequest& request, const modelling::Solving& how, std::filesystem::path keep_in,
        std::string made)
      : request_(request),
        models_(request.call.models),
        how_(how),
        keep_in_(std::move(keep_in)),
        made_(std::move(made)) {
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
    if (!left_out_.empty())
      print(fmt::format("\nskipped, because {:g} s would not suffice: {}; --seconds allows more\n",
                        request_.seconds, fmt::format("{}", fmt::join(left_out_, ", "))));
    print(
        "\np0: error against Hertz; force: largest difference from the converged half-space,\nin "
        "percent of full sliding; seconds: all load points of the case together\n");
    tell_speed();
    if (!request_.json || !how_.first) return;
    Json json = result_head("bench");
    json["rows"] = rows_;
    json["skipped"] = left_out_;
    if (speed_) json["times_predicted_seconds"] = *speed_;
    json["other_programs_running"] = busy_;
    print_result(json.dump(1));
  }

 private:
  void print(const std::string& text) const {
    if (how_.first) std::cout << text << std::flush;
  }

  void solve_by(const contact::ModelInfo& model, const BenchCase& given) {
    if (model.name == models_.reference().name) {
      half_spaces(model, given);
      return;
    }
    if (!model.has_stress) {
      tell(given, model, grid_of_theories, solved(given, model.name, grid_of_theories));
      return;
    }
    // The remaining models mesh the bodies.
    if (request_.quick || !given.of_bodies) return;
    const int across = model.keeps_bodies ? cells_of_fem : grid_of_hybrid;
    const double expected = predicted(given, model.name, across).value_or(0.0);
    if (watch_.seconds() + speed_.value_or(1.0) * expected > request_.seconds)
      left_out_.push_back(model.name);
    else
      tell(given, model, across, solved(given, model.name, across));
  }

  /// The difference between the coarsest and the finest grid measures the speed, because it
  /// contains no overhead independent of the grid.
  void half_spaces(const contact::ModelInfo& model, const BenchCase& given) {
    struct Timed {
      double measured, expected;
    };
    std::vector<Timed> timed;
    for (const int across : request_.quick ? quick_grids : grids) {
      const std::optional<Row> row = quickest(given, model.name, across);
      tell(given, model, across, row);
      const auto seconds = predicted(given, model.name, across);
      if (!row || !seconds) return;
      timed.push_back({row->own_seconds, *seconds});
      if (given.of_bodies) busy_ = busy_ || row->seconds > 1.5 * row->own_seconds;
    }
    if (!given.of_bodies) return;
    const double measured = timed.back().measured - timed.front().measured;
    const double expected = timed.back().expected - timed.front().expected;
    if (measured > 0.0 && expected > 0.0) speed_ = measured / expected;
  }

  /// The fastest of several runs of a case that measures the speed; a single run of any other case.
  std::optional<Row> quickest(const BenchCase& given, const std::string& model, int across) {
    std::optional<Row> row = solved(given, model, across);
    for (int k = 1; given.of_bodies && row && k < repeats; ++k)
      if (const auto again = solved(given, model, across)) {
        row->seconds = std::min(row->seconds, again->seconds);
        row->own_seconds = std::min(row->own_seconds, again->own_seconds);
      }
    return row;
  }

  /// Predicted seconds from choice/laws.hpp.
  std::optional<double> predicted(const BenchCase& given, const std::string& model,
                                  int across) const {
    const contact::Scene scene(input_of(given, model, across));
    for (const modelling::Forecast& forecast : modelling::forecasts_of(scene, models_))
      for (const modelling::Level& level : forecast.levels)
        if (forecast.model == model && level.across == across) return level.seconds;
    return {};
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
    const std::clock_t begin = std::clock();
    modelling::solve(record, how_);
    if (record.models.empty()) return {};
    Row row = row_of(given, record.models.front());
    row.seconds = watch.seconds();
    row.own_seconds = std::min(row.seconds, static_cast<double>(std::clock() - begin) /
                                                static_cast<double>(CLOCKS_PER_SEC));
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

  void tell_speed() const {
    if (!speed_) return;
    print(fmt::format(
        "\nthis machine takes {:.2f} times the predicted seconds (half-space, fastest of {} "
        "runs){}\n",
        *speed_, repeats, busy_ ? "; other programs are running, so CPU time counts" : ""));
    if (request_.quick || !how_.first || keep_in_.empty()) return;
    modelling::keep_machine_speed(keep_in_, {*speed_, made_});
    print(fmt::format("stored in {}; rollfem check uses it for its predictions\n",
                      keep_in_.string()));
  }

  const BenchRequest& request_;
  const contact::ModelRegistry& models_;
  modelling::Solving how_;
  contact::Stopwatch watch_;
  std::optional<double> speed_;
  bool busy_ = false;
  std::vector<std::string> left_out_;
  std::vector<Json> rows_;  ///< as printed with --json
  std::filesystem::path keep_in_;
  std::string made_;
};

void bench(const BenchRequest& request) {
  if (!(request.seconds > 0.0))
    throw contact::InputError(fmt::format(
        "--seconds {:g}: allowed: above 0; do: give the time limit in seconds", request.seconds));
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
  const std::filesystem::path keep_in = modelling::machine_speed_file();
  modelling::CorrectionCache::switch_off();
  frame.compute("rollfem bench", "cases", [&](const modelling::Solving& how) {
    Bench(request, how, keep_in, frame.provenance().started).run();
  });
}

}  // namespace

void add_bench(CLI::App& program, Call& call) {
  const auto request = std::make_shared<BenchRequest>(call);
  CLI::App* bench = program.add_subcommand(
      "bench",
      "measure error and run time of each model on this machine, in cases with known solutions");
  bench->add_option("--seconds", request->seconds,
                    "time limit; runs expected to exceed it are skipped (default: 30)");
  bench->add_flag(
      "--quick", request->quick,
      "one case on coarse grids, about a second; does not store the speed of the machine");
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
