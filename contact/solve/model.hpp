// SPDX-License-Identifier: LGPL-2.1-or-later
// The common interface of all models, from Hertz to finite elements: a function of one signature
// with a name, its capabilities and further data needed to run it.
#pragma once

#include "base/checkpoint.hpp"
#include "base/progress.hpp"
#include "result/bars.hpp"
#include "result/result.hpp"
#include "scene/scene.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace rollfem::contact {

/// Input of a model.
using ModelInput = Scene;

/// Runs all load points. Throws InputError when the model does not support them, SolveError when
/// the solution fails.
using Model = std::function<ModelResult(const ModelInput&, const Progress&)>;

/// The same with finished load points stored in a checkpoint, which may be null.
using ModelRun = std::function<ModelResult(const ModelInput&, const Progress&, Checkpoint*)>;

/// Features of a problem that not every model supports. Key and words of each: model.cpp.
enum class Demand {
  history,                 ///< shift or transient
  tangential_force,        ///< prescribed
  load_history,            ///< a load that changes from step to step
  profiles,                ///< true ones of wheel and rail
  sections,                ///< profiles that change along the way
  lateral_creepage,        ///< of bodies with radii
  spin,                    ///< of bodies with radii; always present with profiles
  extra_slip,              ///< from a file, of bodies with radii
  extra_slip_on_profiles,  ///< from a file, in addition to that of the profiles
  line_contact,            ///< of endless rollers
  distance_points,         ///< undeformed distance point by point
  distance_quadratic,      ///< undeformed distance without radii
  given_pressure,
  rigid_body,
  stress_in_rigid_body,
  falling_friction,   ///< that falls with the slip velocity
  heated_friction,    ///< that follows the temperature of the surfaces
  varying_friction,   ///< over the inclination of the rail
  layer,              ///< between wheel and rail
  plastic_layer,      ///< that yields
  inertia,            ///< of wheel and rail
  yielding_body,      ///< wheel or rail
  beyond_half_space,  ///< stress where a concave body extends beyond z = 0
};

using Demands = std::vector<Demand>;

/// "rolling.spin: it cannot handle spin" for the first requested feature not in `takes`; empty if
/// there is none.
std::optional<std::string> first_beyond(const Demands& takes, const ModelInput& input);

/// The feature in a few words: "spin", "a given pressure".
std::string demand_words(Demand demand);
/// All features without `missing`, in the order in which they are checked.
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
  std::string word;       ///< name for --vary: "grid"
  std::string also;       ///< synonym for this model; may be empty
  std::string parameter;  ///< heading of the labels: "contact grid"
  double ratio = 0.0;     ///< ratio of cells from level to level; 0: not applicable
  int levels = 0;         ///< default number of levels
  bool fixed = false;     ///< `levels` is also the largest number
  /// Level k of n, coarsest first. Throws InputError when a starting value is missing.
  RefinedInput (*level)(ModelInput input, int k, int n) = nullptr;
};

/// Role of a model in `auto`; each has a forecast (modelling/choice/laws.hpp).
enum class Choosable { never, half_spaces, corrected_half_spaces, finite_bodies };

struct ModelInfo {
  std::string name;      ///< as in --model and `models` of a case file: "halfspace"
  std::string label;     ///< in figures and tables of reports: "half-space"
  std::string sentence;  ///< description for --help and docs/models.md
  Demands takes = {};    ///< supported features
  ModelRun run = nullptr;
  void (*add_keys)() = nullptr;  ///< declares its options' keys (case/keys/key_builder.hpp)
  std::vector<Refinement> refinements = {};  ///< the first is the default of a study
  bool bounded = true;                       ///< its tractions respect the friction bound
  bool own_bound = false;                    ///< that bound is the theory's own, not mu p_n
  bool frictionless = false;                 ///< has one load point, whatever the creepages
  bool half_spaces = true;                   ///< its bodies are half-spaces
  bool has_stress = false;                   ///< solves the elastic problem, with subsurface stress
  bool keeps_bodies = false;  ///< that stress is stored with the bodies, not summed from tractions
  /// The stress is summed from tractions and corrected for the difference between bodies and
  /// half-spaces.
  bool corrects_stress = false;
  /// Contacts in other planes displace its surface, and it can follow a surface that joins the
  /// planes.
  bool joins_planes = false;
  bool parallel =
      false;  ///< collective over MPI processes; needs a session (modelling/fem/fem_library.hpp)
  bool built = true;  ///< this build has it
  /// Chooses another model and passes on its result and name, without a run of its own
  /// (modelling/solving/auto_model.hpp).
  bool chooses = false;
  Choosable choosable = Choosable::never;
  bool measures_others = false;  ///< default references of `compare`, in this order
  bool in_run = false;           ///< computed by `run` if neither call nor case names models
  bool in_compare = false;       ///< the same for `compare`
  BarRules bars = {};            ///< reasons for values without error estimate
  /// Why it gives no PointResult::model_error, if so.
  const char* no_model_error = "not estimated";

  /// Why it does not support this problem; empty if it does.
  std::optional<std::string> cannot(const ModelInput& input) const {
    return first_beyond(takes, input);
  }
};

/// What may hold of a model, by the name that results keep it under (ModelResult::traits).
struct ModelTrait {
  const char* name;
  bool ModelInfo::*holds;
};
const std::vector<ModelTrait>& model_traits();

// The registry of models, used by commands, checks, help, documents, comparisons and studies. A
// model is registered by one call of ModelRegistry::add.

class ModelRegistry {
 public:
  /// Appends a model, whose keys case files then may give; cheaper models come first. Throws
  /// std::logic_error for a model without a run, a duplicate name, or a name unsuitable for files.
  ModelRegistry& add(ModelInfo model);

  const std::vector<ModelInfo>& all() const { return models_; }
  std::vector<std::string> names() const;
  /// Names of the models for which `wanted` (a member of ModelInfo) is set.
  std::vector<std::string> names(bool ModelInfo::*wanted) const;

  /// Default reference: the first model that solves the elastic problem. Throws std::logic_error if
  /// there is none.
  const ModelInfo& reference() const;

  /// nullptr if unknown.
  const ModelInfo* find(const std::string& name) const;
  /// Throws InputError that lists the names. `asked_by` begins the message: "--model".
  const ModelInfo& at(const std::string& name, const std::string& asked_by = "model") const;

  /// Throws InputError when the model does not support the problem, naming the models that do.
  void check(const ModelInput& input, const std::string& name) const;
  /// Checks and runs. The result passes the gate of result/validity.hpp, which throws
  /// SolveError and adds warnings to the notes.
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
