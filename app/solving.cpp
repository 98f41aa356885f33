#include "app/solving.hpp"

#include "app/places.hpp"
#include "app/scene_checkpoint.hpp"
#include "app/scenes.hpp"
#include "app/version.hpp"
#include "contact/base/errors.hpp"
#include "contact/case/abilities.hpp"
#include "halfspace/model/registry.hpp"
#include "meshes/track/scenes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <ctime>
#include <filesystem>
#include <iostream>
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
    point.vertical_force =
        meshes::vertical_force(point.normal_force, point.lateral_force, *scene.place);
}

/// Runs one model; an error that does not say so gets the name of the model.
contact::ModelResult run_model(const std::string& name, const contact::Case& scene,
                               const Solving& how) {
  SceneCheckpoint kept(how.checkpoint, scene.place);
  contact::Checkpoint* keep = how.checkpoint != nullptr ? &kept : nullptr;
  const contact::Progress progress = told(scene, how.progress);
  try {
    return name == "fem" ? how.session->entry().run(scene, progress, keep)
                         : halfspace::run_model(name, scene, progress, keep);
  } catch (const contact::SolveError& error) {
    const std::string patch = scene.place ? scene.place->label() + ": " : "";
    throw contact::SolveError(
        fmt::format("{}: {}model {}: {}", scene.file, patch, name, error.what()));
  }
}

/// The models that can take every scene; of the others a sentence, or what check_able throws.
std::vector<std::string> able_models(const contact::Case& input, const Scenes& scenes,
                                     const Solving& how, std::vector<Missing>& missing) {
  std::vector<std::string> able;
  for (const std::string& name : input.models) try {
      for (const contact::Case& scene : scenes.cases) contact::check_able(scene, name);
      able.push_back(name);
    } catch (const contact::InputError& error) {
      if (!how.go_on) throw;
      missing.push_back({name, error.what(), false});
    }
  return able;
}

}  // namespace

FemSession::FemSession(const std::string& asked_by, int argc, char** argv)
    : entry_(open_fem_library(asked_by)) {
  entry_.start(argc, argv);
}

FemSession::~FemSession() {
  entry_.stop();
}

contact::ModelResult solve_scene(const std::string& model, const contact::Case& scene,
                                 const std::vector<std::string>& notes, const Solving& how) {
  contact::ModelResult result = run_model(model, scene, how);
  finish(scene, notes, result);
  return result;
}

Solved solve(const contact::Case& input, const Solving& how) {
  Solved solved;
  Scenes scenes = scenes_of(input, how.progress);
  std::vector<std::string> able = able_models(input, scenes, how, solved.missing);
  for (const contact::Case& scene : scenes.cases)
    for (const std::string& name : std::vector<std::string>(able)) {
      if (name != "fem" && !how.first) continue;
      const auto miss = [&](const std::exception& error, bool failed) {
        solved.missing.push_back({name, error.what(), failed});
        able.erase(std::find(able.begin(), able.end(), name));
      };
      const bool must_throw = !how.go_on || (name == "fem" && !how.together);
      try {
        solved.results.push_back(solve_scene(name, scene, scenes.notes, how));
      } catch (const contact::SolveError& error) {
        if (must_throw) throw;
        miss(error, true);
      } catch (const contact::InputError& error) {
        if (must_throw) throw;
        miss(error, false);
      }
    }
  solved.pairs = std::move(scenes.pairs);
  return solved;
}

std::unique_ptr<postprocess::CheckpointFolder> open_checkpoint(const std::string& directory,
                                                               const contact::Case& input,
                                                               bool resume, bool quiet) {
  auto checkpoint = std::make_unique<postprocess::CheckpointFolder>(
      directory, input, fmt::format("{} ({})", version(), commit()), resume,
      [](const std::string& warning) { std::cerr << warning << '\n'; });
  const std::string folder = fs::path(checkpoint->folder()).lexically_proximate(fs::current_path());
  if (checkpoint->found() > 0 && !resume)
    std::cerr << fmt::format(
        "warning: {} holds {} solutions of an earlier run that did not end; --resume takes them "
        "up, this run starts anew and will replace them\n",
        folder, checkpoint->found());
  else if (checkpoint->found() > 0 && !quiet)
    std::cerr << fmt::format("resume: {} solutions of an earlier run in {}\n", checkpoint->found(),
                             folder);
  else if (resume && !quiet)
    std::cerr << "resume: no load points of an earlier run are there; everything is computed\n";
  return checkpoint;
}

postprocess::Provenance provenance_of(const std::string& command, int processes) {
  postprocess::Provenance made;
  made.version = version();
  made.commit = commit();
  made.host = host_name();
  made.started = utc_now();
  made.command = command;
  made.processes = processes;
  return made;
}

void write_whole(const std::string& directory, const postprocess::RunRecord& record) {
  const SignalsHeld held;
  postprocess::write_results(directory, record);
}

bool report_drawn(const std::string& directory) {
  const std::string problem = postprocess::make_report(directory, script_directory().string());
  if (!problem.empty())
    std::cerr << "warning: results are written, but the report was not drawn: " << problem << '\n';
  return problem.empty();
}

std::string result_directory(const std::string& case_file, const std::string& named) {
  return named.empty() ? (fs::path("results") / fs::path(case_file).stem()).string() : named;
}

}  // namespace rollfem::app
