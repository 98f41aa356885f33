// SPDX-License-Identifier: LGPL-2.1-or-later
// How the package solves the cases of a comparison and the levels of a study: from Python with a
// callback, from the command line with the frame of the computing commands.
#include "base/checkpoint.hpp"
#include "base/errors.hpp"
#include "base/progress.hpp"
#include "bindings/python/caller.hpp"
#include "halfspace/patch/patch_search.hpp"
#include "modelling/caches/correction_cache.hpp"
#include "modelling/frame/command_frame.hpp"
#include "modelling/frame/in_process.hpp"
#include "modelling/frame/interruption.hpp"
#include "modelling/frame/parts.hpp"
#include "modelling/program/provenance.hpp"
#include "modelling/solving/case_scenes.hpp"
#include "result/files/files_together.hpp"
#include "result/record.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <pybind11/functional.h>
#include <pybind11/stl.h>
#include <tuple>

namespace rollfem::python {

using namespace py::literals;
using contact::Scene;
using modelling::Solving;

namespace {

/// The load points of one level. Their records carry the seconds spent on the level so far, so that
/// the cost of a resumed level covers all calls.
class LevelPoints : public contact::CheckpointPart {
 public:
  using CheckpointPart::CheckpointPart;
  std::optional<std::string> find(const std::string& name) override {
    const std::optional<std::string> bytes = CheckpointPart::find(name);
    if (!bytes) return {};
    double seconds = 0.0;
    std::string content;
    if (!contact::reads(contact::Record(*bytes), [&](auto& r) { r.values(seconds, content); })) {
      refuse(name);
      return {};
    }
    before_ = std::max(before_, seconds);
    return content;
  }
  void keep(const std::string& name, const std::string& content) override {
    CheckpointPart::keep(name, contact::record_of(before_ + watch_.seconds(), content));
  }
  /// Seconds of earlier calls; known after the level is solved.
  double seconds_before() const { return before_; }

 private:
  double before_ = 0.0;
  contact::Stopwatch watch_;
};

/// A level of a study to solve.
struct Level {
  std::string model, label;
  Scene scene;
  std::string records;  ///< beginning of the names of its load points
};

class Computation {
 public:
  /// In Python.
  Computation(std::vector<std::string> models, py::object callback)
      : models_(std::move(models)), callback_(std::move(callback)) {}
  /// From the command line.
  Computation(std::vector<std::string> models, modelling::Computing& asked)
      : models_(std::move(models)), asked_(&asked) {
    frame_.emplace(asked, models_);
  }

  /// Calls `body` while MPI runs if a model needs it, and tells of stored work if it fails.
  void compute(const std::string& asked_by, const std::string& kept, const py::function& body) {
    if (!frame_) {
      modelling::check_built(known_models(), models_, asked_by);
      body();
      return;
    }
    frame_->compute(asked_by, kept, [&](const Solving& how) {
      how_ = how;
      how_.own = asked_->own;
      body();
    });
  }

  /// Models without a result are listed.
  Solved solve(const Case& input, const std::vector<std::string>& models) {
    auto result = std::make_shared<Result>();
    result->input = input;
    result->input.models = models;
    result->provenance = provenance("rollfem::solve");
    const std::vector<Missing> missing = working([&](Solving how) {
      how.go_on = true;
      return modelling::solve(*result, how);
    });
    return {result, missing_rows(missing)};
  }

  modelling::Scenes scenes(const Case& input) {
    return working([&](const Solving& how) {
      return modelling::scenes_of(input, modelling::placed_wheels(input), how.progress);
    });
  }

  /// Solves levels side by side, and tells of each at once: done(index, record, seconds, None), or
  /// done(index, None, why, whether another grid may have a solution).
  void solve_levels(const std::vector<Level>& levels, const std::vector<contact::Note>& notes,
                    const py::function& done) {
    working([&](const Solving& how) {
      contact::for_each_index(levels.size(), [&](std::size_t k) {
        solve_level(levels[k], notes, how, [&](auto&&... outcome) {
          const py::gil_scoped_acquire gil;
          done(k, std::forward<decltype(outcome)>(outcome)...);
        });
      });
      return 0;
    });
  }

  /// Collective: the text of the first process on every process.
  std::string from_first(const std::string& text) const {
    return frame_ && !how_.together && how_.session != nullptr ? how_.session->from_first(text)
                                                               : text;
  }

  /// Stored work; null where there is none.
  result::CheckpointFolder* kept() { return kept_; }
  /// Null in Python.
  modelling::CommandFrame* frame() { return frame_ ? &*frame_ : nullptr; }

  void keep_in(const std::string& folder, const Case& input) {
    if (frame_) kept_ = frame_->keep_in(folder, input);
  }
  void forget_kept() {
    kept_ = nullptr;
    if (frame_) frame_->forget_kept();
  }

  bool first() const { return !frame_ || frame_->first(); }
  bool idle() const { return frame_ && frame_->idle(); }
  bool together() const { return !frame_ || how_.together; }
  bool whole() const { return asked_ == nullptr || asked_->own.whole(); }
  bool holds(std::size_t k) const { return asked_ == nullptr || asked_->own.holds(k); }
  bool ends_part() { return frame_ && frame_->ends_part(); }
  result::Provenance provenance(const std::string& command) const {
    return frame_ ? frame_->provenance() : modelling::provenance_of(known_models(), command);
  }

 private:
  /// work(how) without the GIL.
  template <class Work>
  auto working(const Work& work) -> decltype(work(std::declval<const Solving&>())) {
    return without_gil(frame_ ? py::none() : callback_, [&](const Progress& progress) {
      if (!frame_) {
        const modelling::InProcess here = modelling::in_process(known_models(), models_, progress);
        return work(here.how);
      }
      Solving how = how_;
      if (how.models == nullptr) how.progress = frame_->progress();
      how.models = &known_models();
      how.checkpoint = kept_;
      return work(how);
    });
  }

  template <class Tell>
  void solve_level(const Level& level, const std::vector<contact::Note>& notes, const Solving& all,
                   const Tell& tell) {
    LevelPoints points(kept_, level.records);
    Solving how = all;
    how.checkpoint = &points;
    how.progress = [&](contact::ProgressEvent event) {
      event.stage = level.label + ": " + event.stage;
      contact::report(all.progress, event);
    };
    auto result = std::make_shared<Result>();
    try {
      result->models = {modelling::solve_scene(level.model, level.scene, notes, how)};
    } catch (const contact::Failure& error) {
      // Other processes may be inside a collective call.
      if (!all.together) throw;
      return tell(Shared(), error.what(), error.cause() != contact::Failure::Cause::solution);
    }
    const double seconds = points.seconds_before() + result->models.front().total_seconds();
    tell(result, seconds, false);
  }

  std::vector<std::string> models_;
  py::object callback_ = py::none();
  modelling::Computing* asked_ = nullptr;
  std::optional<modelling::CommandFrame> frame_;
  Solving how_;
  result::CheckpointFolder* kept_ = nullptr;
};

/// A method of the frame, or of stored work, which does nothing without one.
template <class Part, class Whole, class... Taken>
auto through(Part* (Computation::*part)(), void (Whole::*method)(Taken...)) {
  return [=](Computation& self, std::decay_t<Taken>... taken) {
    if (Part* const whole = (self.*part)()) (whole->*method)(std::move(taken)...);
  };
}

/// {program: {version, commit}, host, started, command, processes, labels}: the head of JSON files.
py::dict provenance_of(const result::Provenance& made) {
  return py::dict("program"_a = py::dict("version"_a = made.version, "commit"_a = made.commit),
                  "host"_a = made.host, "started"_a = made.started, "command"_a = made.command,
                  "processes"_a = made.processes, "labels"_a = made.labels);
}

/// What commands ask of the models, cheaper ones first.
py::list model_infos() {
  py::list found;
  for (const contact::ModelInfo& model : known_models().all()) {
    py::list ways;
    for (const contact::Refinement& way : model.refinements)
      ways.append(py::dict("word"_a = way.word, "also"_a = way.also, "parameter"_a = way.parameter,
                           "ratio"_a = way.ratio, "levels"_a = way.levels, "fixed"_a = way.fixed));
    py::dict one("name"_a = model.name, "ways"_a = ways);
    for (const contact::ModelTrait& trait : contact::model_traits())
      one[trait.name] = model.*trait.holds;
    found.append(one);
  }
  return found;
}

/// Label, parameter and scene of level k of `count`, coarsest first, refined in all of `ways`;
/// without fields and estimates that a study does not need.
std::tuple<std::string, double, Scene> refined(Scene scene, const std::string& model,
                                               const std::vector<std::string>& ways, int k,
                                               int count) {
  scene.accuracy.relative.reset();
  scene.subsurface.clear();
  scene.output.fields = false;
  contact::RefinedInput level{"as in the case", 0.0, std::move(scene)};
  std::string label;
  for (const std::string& word : ways)
    for (const contact::Refinement& way : known_models().at(model).refinements)
      if (way.word == word) {
        level = way.level(std::move(level.input), k, count);
        label += (label.empty() ? "" : ", ") + level.label;
      }
  return {label.empty() ? level.label : label, level.parameter, std::move(level.input)};
}

/// The shorter side of the expected patch, mm; empty where it is not known.
std::optional<double> patch_size(const Scene& scene) {
  const auto extent = contact::attempt([&] { return halfspace::PatchSearch(scene).extent(); });
  if (!extent) return {};
  return std::min(extent->length, extent->width);
}

/// Hertz's result if it is exact for the scene; otherwise none.
Shared exact_of(const Scene& scene) {
  if (scene.has_profiles()) return nullptr;
  const std::string closed_form = known_models().names(&contact::ModelInfo::frictionless).front();
  const auto found = contact::attempt([&] { return known_models().run(closed_form, scene, {}); });
  if (!found) return nullptr;
  auto result = std::make_shared<Result>();
  result->models = {*found.value};
  return result;
}

void define_scenes(py::module_& module) {
  py::class_<Scene>(module, "Scene")
      .def_property_readonly("place",
                             [](const Scene& scene) -> py::object {
                               return scene.place ? py::object(dict_of(*scene.place)) : py::none();
                             })
      .def_property_readonly(
          "key", [](const Scene& scene) { return scene.place ? scene.place->key() : ""; })
      .def_property_readonly("creepages", [](const Scene& scene) {
        std::vector<std::array<double, 3>> found;
        for (const contact::LoadPoint& point : scene.points)
          found.push_back(
              {point.creepage.longitudinal, point.creepage.lateral, point.creepage.spin});
        return found;
      });
  module.def("refined", &refined);
  module.def("patch_size", &patch_size);
  module.def("exact_of", &exact_of);
  module.def("check", [](const Scene& scene, const std::string& model) {
    known_models().check(scene, model);
  });
}

void define_frame(py::module_& module) {
  using modelling::Computing;
  py::class_<Computing>(module, "Computing")
      .def(py::init([](const std::string& command, bool quiet, bool resume, const std::string& part,
                       int merge) {
             const contact::RunPart own =
                 part.empty() ? contact::RunPart() : modelling::parse_part(part);
             return std::unique_ptr<Computing>(
                 new Computing{known_models(), command, quiet, resume, own, merge});
           }),
           "command"_a, "quiet"_a, "resume"_a, "part"_a, "merge"_a);
  module.def("in_parts", [](Computing& asked, bool divisible, const std::string& folder,
                            const py::function& work) {
    modelling::check_division(asked, 2, "");  // a study has several levels
    modelling::in_parts(asked, divisible, folder, [&] { work(); });
  });
  module.def("tell_of_interruptions", &modelling::handle_interruptions);
  module.def("refuse_other_result", [](const std::string& folder, const std::string& own) {
    modelling::refuse_other_result(folder, own);
  });
  module.def("check_directory", &result::check_directory);
  module.def("check_folder", [](const std::string& folder) { result::FilesTogether{folder}; });
  module.def("remove_records", &result::remove_records);
  module.def("checksum_of_case", &result::checksum_of_case);
  module.def("store", [](const std::string& folder, const Result& result) {
    modelling::store_results(folder, result);
  });
  module.def("switch_off_cache", &modelling::CorrectionCache::switch_off);
  module.def("rank", [] { return modelling::processes().rank; });
}

}  // namespace

void define_computations(py::module_& module) {
  define_scenes(module);
  define_frame(module);
  module.def("model_infos", &model_infos);
  module.def("checked_names", [](const std::vector<std::string>& names, const std::string& option) {
    return modelling::checked_names(known_models(), names, option);
  });
  module.def("refuse_choice",
             [](const std::vector<std::string>& names, const std::string& command) {
               modelling::refuse_choice(known_models(), names, command);
             });
  py::class_<contact::Note>(module, "Note").def_readonly("text", &contact::Note::text);
  py::class_<Level>(module, "Level").def(py::init<std::string, std::string, Scene, std::string>());
  py::class_<Computation>(module, "Computation")
      .def(py::init<std::vector<std::string>, modelling::Computing&>(), py::keep_alive<1, 3>())
      .def(py::init<std::vector<std::string>, py::object>())
      .def("compute", &Computation::compute)
      .def("solve", &Computation::solve)
      .def("scenes",
           [](Computation& self, const Case& input) {
             modelling::Scenes found = self.scenes(input);
             return std::pair(std::move(found.list), std::move(found.notes));
           })
      .def("solve_levels", &Computation::solve_levels)
      .def("from_first", &Computation::from_first)
      .def("find",
           [](Computation& self, const std::string& name) {
             const auto found = self.kept() == nullptr ? std::nullopt : self.kept()->find(name);
             return found ? std::optional<py::bytes>(*found) : std::nullopt;
           })
      .def("keep", through(&Computation::kept, &contact::Checkpoint::keep))
      .def("refuse", through(&Computation::kept, &contact::Checkpoint::refuse))
      .def("drop", through(&Computation::kept, &result::CheckpointFolder::drop))
      .def("keep_in", &Computation::keep_in)
      .def("forget_kept", &Computation::forget_kept)
      .def_property_readonly("first", &Computation::first)
      .def_property_readonly("idle", &Computation::idle)
      .def_property_readonly("together", &Computation::together)
      .def_property_readonly("whole", &Computation::whole)
      .def("holds", &Computation::holds)
      .def("ends_part", &Computation::ends_part)
      .def("say", through(&Computation::frame, &modelling::CommandFrame::say))
      .def("clear_line", through(&Computation::frame, &modelling::CommandFrame::clear_line))
      .def("own",
           [](Computation& self, const std::string& folder) {
             if (self.frame() != nullptr) self.frame()->own(folder);
           })
      .def("provenance", [](const Computation& self, const std::string& command) {
        return provenance_of(self.provenance(command));
      });
}

}  // namespace rollfem::python
