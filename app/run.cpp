#include "app/run.hpp"

#include "app/fem_library.hpp"
#include "app/places.hpp"
#include "app/processes.hpp"
#include "app/progress_display.hpp"
#include "app/run_table.hpp"
#include "app/scene_checkpoint.hpp"
#include "app/scenes.hpp"
#include "app/version.hpp"
#include "contact/abilities.hpp"
#include "contact/case_reader.hpp"
#include "contact/errors.hpp"
#include "halfspace/registry.hpp"
#include "meshes/scenes.hpp"
#include "postprocess/checkpoint_folder.hpp"
#include "postprocess/output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <set>
#include <unistd.h>

namespace rollfem::app {

namespace fs = std::filesystem;

namespace {

volatile std::sig_atomic_t held_signal = 0;

/// Ctrl-C and its like wait while results are written, so that a folder is whole or not there. By
/// handlers, not by a mask: the threads of BLAS and MPI would take a signal that is masked here.
class SignalsHeld {
 public:
  SignalsHeld() {
    struct sigaction hold {};
    hold.sa_handler = [](int signal) { held_signal = signal; };
    hold.sa_flags = SA_RESTART;
    for (std::size_t i = 0; i < before_.size(); ++i) sigaction(signals[i], &hold, &before_[i]);
  }
  ~SignalsHeld() {
    for (std::size_t i = 0; i < before_.size(); ++i) sigaction(signals[i], &before_[i], nullptr);
    if (held_signal != 0) static_cast<void>(std::raise(held_signal));
  }
  SignalsHeld(const SignalsHeld&) = delete;
  SignalsHeld& operator=(const SignalsHeld&) = delete;

 private:
  static constexpr std::array<int, 3> signals{SIGINT, SIGTERM, SIGHUP};
  std::array<struct sigaction, 3> before_{};
};

/// MPI for as long as the models run.
class FemSession {
 public:
  FemSession(const std::string& asked_by, int argc, char** argv)
      : entry_(open_fem_library(asked_by)) {
    entry_.start(argc, argv);
  }
  ~FemSession() { entry_.stop(); }
  FemSession(const FemSession&) = delete;
  FemSession& operator=(const FemSession&) = delete;

  const fem::Entry& entry() const { return entry_; }

 private:
  const fem::Entry& entry_;
};

std::string utc_now() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm utc{};
  gmtime_r(&now, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

std::string host_name() {
  char name[256] = {};
  return gethostname(name, sizeof name - 1) == 0 ? name : "unknown";
}

fs::path output_directory(const RunRequest& request) {
  if (!request.directory.empty()) return request.directory;
  return fs::path("results") / fs::path(request.case_file).stem();
}

/// What would only come out after the hours of computing: a folder that cannot be made, a model
/// that cannot take the case.
void check_before(const RunRequest& request, const contact::Case& input) {
  postprocess::check_directory(output_directory(request).string());
  if (!input.has_profiles())
    for (const std::string& name : input.models) contact::check_able(input, name);
  const auto runs = [&](const char* model) {
    return std::find(input.models.begin(), input.models.end(), model) != input.models.end();
  };
  if (runs("halfspace") || runs("fem") || request.quiet) return;
  const auto warn = [&](const char* key) {
    std::cerr << fmt::format(
        "warning: {}: {} is computed by the models halfspace and fem, neither of which is run\n",
        input.file, key);
  };
  if (!input.subsurface.empty()) warn("[[subsurface]]");
  if (input.output.stress_maxima.value_or(false)) warn("[output] stress_maxima");
}

/// Where finished load points are kept; says what is there already.
std::unique_ptr<postprocess::CheckpointFolder> open_checkpoint(const RunRequest& request,
                                                               const contact::Case& input) {
  auto checkpoint = std::make_unique<postprocess::CheckpointFolder>(
      output_directory(request).string(), input, fmt::format("{} ({})", version(), commit()),
      request.resume, [](const std::string& warning) { std::cerr << warning << '\n'; });
  const std::string folder = fs::path(checkpoint->folder()).lexically_proximate(fs::current_path());
  if (checkpoint->found() > 0 && !request.resume)
    std::cerr << fmt::format(
        "warning: {} holds {} solutions of an earlier run that did not end; --resume takes them "
        "up, this run starts anew and will replace them\n",
        folder, checkpoint->found());
  else if (checkpoint->found() > 0 && !request.quiet)
    std::cerr << fmt::format("resume: {} solutions of an earlier run in {}\n", checkpoint->found(),
                             folder);
  else if (request.resume && !request.quiet)
    std::cerr << "resume: no load points of an earlier run are there; everything is computed\n";
  return checkpoint;
}

/// After a failure: finished work is not lost.
void tell_about(const RunRequest& request, const postprocess::CheckpointFolder* checkpoint) {
  if (checkpoint == nullptr || request.quiet || !checkpoint->holds_records()) return;
  std::cerr << fmt::format(
      "finished load points are kept; the same command with --resume takes "
      "them up: {}\n",
      checkpoint->folder().string());
}

/// Progress of a scene says which patch it is.
contact::Progress told(const contact::Case& scene, const contact::Progress& progress) {
  if (!scene.place) return progress;
  return [label = scene.place->label(), progress](contact::ProgressEvent event) {
    event.stage = label + ": " + event.stage;
    contact::report(progress, event);
  };
}

/// What the result of a patch says beyond what the model knows.
void finish(const contact::Case& scene, const std::vector<std::string>& notes,
            contact::ModelResult& result) {
  if (!scene.place) return;
  result.place = scene.place;
  result.notes.insert(result.notes.end(), notes.begin(), notes.end());
  for (contact::PointResult& point : result.points)
    point.derived["vertical_force"] =
        meshes::vertical_force(point.normal_force, point.lateral_force, *scene.place);
}

/// Runs one model; an error that does not say so gets the name of the model.
template <class Model>
contact::ModelResult run_model(const std::string& name, const contact::Case& input,
                               const Model& model) {
  try {
    return model();
  } catch (const contact::SolveError& error) {
    const std::string patch = input.place ? input.place->label() + ": " : "";
    throw contact::SolveError(
        fmt::format("{}: {}model {}: {}", input.file, patch, name, error.what()));
  }
}

void write_and_tell(const RunRequest& request, const postprocess::RunRecord& record) {
  const fs::path directory = output_directory(request);
  {
    const SignalsHeld held;
    postprocess::write_results(directory.string(), record);
  }
  std::string problem;
  if (request.report)
    problem = postprocess::make_report(directory.string(), script_directory().string());
  if (!problem.empty())
    std::cerr << "warning: results are written, but the report was not drawn: " << problem << '\n';
  if (request.quiet) return;
  std::cout << record.input.title << "\n\n" << run_table(record.models);
  std::set<std::string> said;  // patches share most notes
  for (const contact::ModelResult& model : record.models)
    for (const std::string& note : model.notes)
      if (said.insert(model.name + note).second) std::cout << '\n' << model.name << ": " << note;
  std::cout << "\n\nresults: " << directory.string() << '\n';
  if (request.report && problem.empty())
    std::cout << "report:  " << (directory / "report.html").string() << '\n';
}

/// Results that are sound but less than what was asked for are written and are a failure still.
void refuse_shortfall(const postprocess::RunRecord& record) {
  std::string text;
  for (const contact::ModelResult& model : record.models)
    if (!model.shortfall.empty())
      text += fmt::format("{}model {}: {}", text.empty() ? "" : "; ", model.name, model.shortfall);
  if (!text.empty())
    throw contact::SolveError(
        fmt::format("{}: the results are written, but {}", record.input.file, text));
}

}  // namespace

std::vector<std::string> known_models() {
  std::vector<std::string> names = halfspace::model_names();
  names.emplace_back("fem");
  return names;
}

void run(const RunRequest& request) {
  const Processes here = processes();
  postprocess::RunRecord record;
  record.input = contact::read_case(request.case_file);
  const bool named = !request.models.empty();
  if (named) record.input.models = request.models;
  const auto& names = record.input.models;
  const bool parallel = std::find(names.begin(), names.end(), "fem") != names.end();
  if (!here.first() && !parallel) return;
  if (here.first()) check_before(request, record.input);

  record.provenance.version = version();
  record.provenance.commit = commit();
  record.provenance.host = host_name();
  record.provenance.started = utc_now();
  record.provenance.command = request.command;
  record.provenance.processes = parallel ? here.count : 1;

  std::unique_ptr<FemSession> session;
  if (parallel)
    session = std::make_unique<FemSession>(named ? "--model fem" : request.case_file + ": models",
                                           request.argc, request.argv);
  ProgressDisplay display(request.quiet || !here.first() ? ProgressDisplay::Mode::silent
                                                         : ProgressDisplay::mode_of_stderr());
  const contact::Progress progress = [&](const contact::ProgressEvent& event) {
    display.show(event);
  };
  std::unique_ptr<postprocess::CheckpointFolder> checkpoint;
  try {
    if (here.first()) checkpoint = open_checkpoint(request, record.input);
    Scenes scenes = scenes_of(record.input, progress);
    for (const contact::Case& scene : scenes.cases)
      for (const std::string& name : names) contact::check_able(scene, name);
    for (const contact::Case& scene : scenes.cases) {
      SceneCheckpoint kept(checkpoint.get(), scene.place);
      contact::Checkpoint* keep = checkpoint ? &kept : nullptr;
      for (const std::string& name : names) {
        if (name != "fem" && !here.first()) continue;
        const auto run_it = [&] {
          return name == "fem" ? session->entry().run(scene, told(scene, progress), keep)
                               : halfspace::run_model(name, scene, told(scene, progress), keep);
        };
        record.models.push_back(run_model(name, scene, run_it));
        finish(scene, scenes.notes, record.models.back());
      }
    }
    record.pairs = std::move(scenes.pairs);
    display.clear();
    if (here.first()) {
      write_and_tell(request, record);
      checkpoint->remove();
      refuse_shortfall(record);
    }
  } catch (...) {
    display.clear();
    tell_about(request, checkpoint.get());
    // Finalising MPI would wait for processes that may not have failed: main leaves without it.
    static_cast<void>(session.release());
    throw;
  }
}

}  // namespace rollfem::app
