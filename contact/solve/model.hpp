// SPDX-License-Identifier: LGPL-2.1-or-later
// The common interface of all models, from Hertz to finite elements: a function of one signature
// with a name, its capabilities and whatever else is needed to run it.
#pragma once

#include "contact/base/checkpoint.hpp"
#include "contact/base/progress.hpp"
#include "contact/result/bars.hpp"
#include "contact/result/result.hpp"
#include "contact/scene/scene.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace rollfem::contact {

/// What a model is given.
using ModelInput = Scene;

/// Runs all load points. Throws InputError when the model cannot take them, SolveError when the
/// solution failed.
using Model = std::function<ModelResult(const ModelInput&, const Progress&)>;

/// The same with finished load points kept in a checkpoint, which may be null.
using ModelRun = std::function<ModelResult(const ModelInput&, const Progress&, Checkpoint*)>;

/// What a problem may ask for that not every model has. Key and words of each: demands.cpp.
enum class Demand {
  history,                 ///< shift or transient
  tangential_force,        ///< prescribed
  load_history,            ///< a load that changes from step to step
  profiles,                ///< true ones of wheel and rail
  lateral_creepage,        ///< of bodies with radii
  spin,                    ///< of bodies with radii: with profiles there is always some
  extra_slip,              ///< from a file, of bodies with radii
  extra_slip_on_profiles,  ///< from a file, beyond what the profiles bring
  line_contact,            ///< of rollers without ends across
  stress_of_line,          ///< below a line contact
  distance_points,         ///< undeformed distance point by point
  distance_quadratic,      ///< undeformed distance without radii
  given_pressure,
  rigid_body,
  stress_in_rigid_body,
  inertia,            ///< of wheel and rail
  beyond_half_space,  ///< stress where a concave body reaches beyond z = 0
};

using Demands = std::vector<Demand>;

/// "rolling.spin: it cannot take spin" for the first thing that is asked for and not among
/// `takes`; nothing when there is none.
std::optional<std::string> first_beyond(const Demands& takes, const ModelInput& input);

/// What is asked for, in a few words: "spin", "a given pressure".
std::string demand_words(Demand demand);
/// All of them, in the order of refusal; those without `missing`.
const Demands& all_demands();
Demands all_demands_but(const Demands& missing);

/// One level of a refinement study.
struct RefinedInput {
  std::string label;       ///< "40 across"
  double parameter = 0.0;  ///< 40
  ModelInput input;
};

/// A way to refine a model in a study.
struct Refinement {
  std::string word;       ///< as --vary takes it: "grid"
  std::string also;       ///< another word that means the same for this model; may be empty
  std::string parameter;  ///< heading of the labels: "contact grid"
  double ratio = 0.0;     ///< of cells from level to level; 0: has no meaning
  int levels = 0;         ///< unless the user says how many
  bool fixed = false;     ///< there are no more levels than that
  /// Level k of n, coarsest first. Throws InputError when a starting value is missing.
  RefinedInput (*level)(ModelInput input, int k, int n) = nullptr;
};

/// As what `auto` may take a model; each has a forecast (models/choice/laws.hpp).
enum class Choosable { never, half_spaces, corrected_half_spaces, finite_bodies };

struct ModelInfo {
  std::string name;      ///< as --model and `models` of a case file have it: "halfspace"
  std::string label;     ///< in figures and tables of reports: "half-space"
  std::string sentence;  ///< what it is, for --help and docs/models.md
  Demands takes = {};    ///< of what a problem may ask for
  ModelRun run = nullptr;
  std::vector<Refinement> refinements = {};  ///< the first unless a study is told otherwise
  bool bounded = true;                       ///< its tractions keep the bound of friction
  bool half_spaces = true;                   ///< its bodies are plane for the elasticity
  bool has_stress = false;    ///< solves the elastic problem, and has stress below the surface
  bool keeps_bodies = false;  ///< that stress is stored with the bodies, not summed from tractions
  /// That stress is summed from tractions and corrected by what the bodies differ from half-spaces.
  bool corrects_stress = false;
  /// Contacts of other planes displace its surface, and it can follow one that joins the planes.
  bool joins_planes = false;
  bool parallel =
      false;  ///< collective over MPI processes; needs a session (models/fem/fem_library.hpp)
  bool built = true;  ///< this build has it
  /// Takes one of the others, whose result and name it hands on: no run of its own; the program
  /// chooses (models/solving/auto_model.hpp).
  bool chooses = false;
  Choosable choosable = Choosable::never;
  bool measures_others = false;  ///< a reference where `compare` is told of none, in their order
  bool in_run = false;           ///< `run` computes it where neither call nor case names models
  bool in_compare = false;       ///< the same for `compare`
  BarRules bars = {};            ///< what it says of values without an error estimate
  /// Why it gives no PointResult::model_error, where it does not.
  const char* no_model_error = "not estimated";

  /// Why it cannot take this problem; nothing when it can.
  std::optional<std::string> cannot(const ModelInput& input) const {
    return first_beyond(takes, input);
  }
};

// The registry of models, which commands, checks, help, documents, comparisons and studies
// read. A model is registered by one call of ModelRegistry::add.

class ModelRegistry {
 public:
  /// Behind those that are there; the cheaper come first. Throws std::logic_error for a model
  /// without a run, a name that is there already, or one that could not name a file.
  ModelRegistry& add(ModelInfo model);

  const std::vector<ModelInfo>& all() const { return models_; }
  std::vector<std::string> names() const;
  /// Names of those that `wanted` (a member of ModelInfo) is set for.
  std::vector<std::string> names(bool ModelInfo::*wanted) const;

  /// What others are measured against where nothing else is asked for: the first that solves the
  /// elastic problem. Throws std::logic_error when there is none.
  const ModelInfo& reference() const;

  /// nullptr when there is none.
  const ModelInfo* find(const std::string& name) const;
  /// Throws InputError that lists the names. `asked_by` begins the message: "--model".
  const ModelInfo& at(const std::string& name, const std::string& asked_by = "model") const;

  /// Throws InputError when the model cannot take the problem; it names the models that can.
  void check(const ModelInput& input, const std::string& name) const;
  /// Checks and runs. What the model gives passes the gate of contact/result/validity.hpp, which
  /// throws SolveError and adds warnings to the notes.
  ModelResult run(const std::string& name, const ModelInput& input, const Progress& progress,
                  Checkpoint* checkpoint = nullptr) const;

 private:
  /// "allowed: hertz, halfspace; do: run with --model halfspace, or change the case".
  std::string advice(const ModelInput& input) const;

  std::vector<ModelInfo> models_;
};

/// "a, b, c"
std::string listed(const std::vector<std::string>& names);

}  // namespace rollfem::contact
