// SPDX-License-Identifier: LGPL-2.1-or-later
#include "modelling/fem/fem_models.hpp"

#include "base/errors.hpp"
#include "base/progress.hpp"
#include "case/checks/case_rules.hpp"
#include "case/keys/key_builder.hpp"
#include "fem/fem_options.hpp"
#include "halfspace/model/halfspace_model.hpp"
#include "halfspace/patch/patch_search.hpp"
#include "hybrid/correction_scene.hpp"
#include "modelling/caches/correction_cache.hpp"
#include "modelling/fem/fem_library.hpp"
#include "modelling/program/provenance.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace rollfem::modelling {

using contact::Case;
using contact::Demand;
using contact::GivenCase;
using contact::ModelInput;
using contact::RefinedInput;
using fem::FarBoundary, fem::FemOptions, fem::LinearMethod, fem::MeshFamily, fem::PassPressure;

namespace {

using hybrid::SmoothParts;

/// Takes the correction from the cache, otherwise computes it by finite elements and stores it
/// there.
SmoothParts found_here(const contact::Scene& scene, const contact::Progress& progress) {
  const contact::Scene correction = hybrid::correction_scene(scene);
  const CorrectionCache cache;
  const auto stored = cache.find(correction, scene.asks_for_stress());
  if (stored.parts) return *stored.parts;
  const FemLock alone = lock_fem();
  const fem::Entry& library = parallel_session("model hybrid");
  const contact::Stopwatch watch;
  SmoothParts parts = library.find_smooth_parts(scene, progress);
  const std::string why = cache.keep(correction, parts, watch.seconds());
  if (!stored.note.empty()) parts.notes.push_back({"cache", stored.note});
  if (!why.empty()) parts.notes.push_back({"cache_full", why});
  return parts;
}

using contact::between, contact::otherwise, contact::positive, contact::silent_default;
using contact::symbol, contact::unit;
using FemKeys = contact::Keys<FemOptions>;

void add_elements(FemKeys& keys) {
  keys.add("cell_size", &FemOptions::cell_size, symbol("h"), unit("mm"), positive(),
           otherwise("chosen from the size of the patch"),
           "Size of a finite element in the patch, and of its contact elements.");
  keys.add("degree", &FemOptions::degree, between(1, 2),
           "Polynomial degree; 1 is 15 to 20 times less accurate on the same cells.");
  keys.add("extent", &Case::body_extent, symbol("L"), unit("mm"), positive(),
           otherwise("chosen from the size of the patch"),
           "Meshed distance from the middle of the patch.");
  keys.add("fine_extent", &FemOptions::fine_extent, symbol("c"), between(1.0, 10.0),
           otherwise("chosen by the model"),
           "Extent of the finest cells in semi-axes; more than 1.1 gains nothing.");
  keys.add("linear_solver", &FemOptions::linear_solver,
           {{"automatic", LinearMethod::automatic},
            {"factorisation", LinearMethod::factorisation},
            {"multigrid", LinearMethod::multigrid},
            {"algebraic", LinearMethod::algebraic}},
           "`automatic`: the faster one; `algebraic` (Trilinos ML): for imported meshes too fine "
           "as a coarse level.");
  keys.add("inertia", &Case::inertia,
           "Include inertia and the wheel's centrifugal load at rolling.speed, below 0.9 of the "
           "Rayleigh wave speed.");
}

void add_meshes(FemKeys& keys) {
  keys.add("mesh", &FemOptions::mesh,
           {{"structured", MeshFamily::structured}, {"gmsh", MeshFamily::gmsh}},
           otherwise("`structured`"),
           "`structured`: a graded box on the surface; `gmsh`: a mesh of the cross-section, "
           "revolved or extruded; with profiles the true section of rail and wheel rim.");
  keys.add("width", &FemOptions::width, unit("mm"), positive(), otherwise("twice the extent"),
           "Width of the segments across rolling.");
  keys.add(
      "depth", &FemOptions::depth, unit("mm"), positive(),
      otherwise("the extent; for true sections 172 (rail foot)"),
      "Depth of the segments; of a true section, below the top of the rail, where it is fixed.");
  keys.add("rim_thickness", &FemOptions::rim_thickness, unit("mm"), positive(), otherwise("65"),
           "True section: thickness of the rim below the contact; its inner side is fixed.");
  keys.add("length", &FemOptions::length, unit("mm"), positive(), otherwise("twice the extent"),
           "Length of the segments along rolling (arc).");
  keys.add("far_boundary", &FemOptions::far_boundary,
           {{"clamped", FarBoundary::clamped}, {"point_load", FarBoundary::point_load}},
           otherwise("`point_load`; own mesh and true sections `clamped`"),
           "`clamped`, or displaced like a half-space under the force (`point_load`).");
}

void add_passes(FemKeys& keys) {
  keys.add("passes", &FemOptions::passes, between(1, 1000), silent_default,
           otherwise("one for each load point"),
           "Passes over bodies that yield; the load points follow one another, again and again.");
  keys.add("pass_pressure", &FemOptions::pass_pressure,
           {{"yielding", PassPressure::yielding}, {"elastic", PassPressure::elastic}},
           "Contact of the passes: of the bodies as they are, or `elastic`, as if their shape had "
           "not changed (for theory).");
  keys.add("limit_state", &FemOptions::limit_state,
           "Extrapolate each pass (cycle of load points), which reaches the repeating state in "
           "half the passes; only increments of plastic strain then count.");
  keys.add("plastic_extent", &FemOptions::plastic_extent, between(0.5, 10.0),
           "Extent of the region that may yield, relative to the usual one; it grows by itself, "
           "the default cell_size with it.");
  keys.add("surface_layer", &FemOptions::surface_layer, unit("mm"), contact::zero_or(1e-4, 1e3),
           otherwise("chosen"),
           "Height of the cells at the surface of a body that yields, growing below "
           "(docs/plasticity.md); 0: equal rows.");
}

/// Inertia needs a speed below the Rayleigh wave speed, at which moving loads have no steady
/// solution and the stiffness with inertia becomes indefinite.
void check_inertia(const GivenCase& given, const Case& input) {
  if (!input.inertia) return;
  if (input.rolling.speed <= 0.0)
    fail_at(given, "fem.inertia", "needs a rolling speed, and rolling.speed is 0",
            "true with rolling.speed > 0", "give `speed` in mm/s under [rolling], or remove it");
  for (const bool wheel : {true, false}) {
    const contact::Material& material = wheel ? input.wheel.material : input.rail.material;
    const double limit = contact::largest_rayleigh_fraction * contact::rayleigh_speed(material);
    if (input.rolling.speed < limit) continue;
    fail_at(given, "rolling.speed",
            fmt::format("is at or above {} of the Rayleigh wave speed of the {}, {:.4g} mm/s",
                        contact::largest_rayleigh_fraction, wheel ? "wheel" : "rail",
                        contact::rayleigh_speed(material)),
            fmt::format("below {:.4g} mm/s", limit),
            "lower the speed (mm/s), check young_modulus (MPa) and density (t/mm^3), or remove "
            "fem.inertia");
  }
}

/// One load point for each pass, by default one pass for each load point.
void repeat_load_points(const GivenCase& given, Case& input) {
  FemOptions& fem = input.options.set<FemOptions>();
  const int points = fem.cycle = static_cast<int>(input.rolling.creepages.size());
  const contact::GivenValue* passes = given.find("fem", "passes");
  if (passes == nullptr) fem.passes = points;
  if (fem.passes < points)
    fail_at(given, "fem.passes",
            fmt::format("leaves out some of the {} load points, each of which is a pass", points),
            fmt::format("at least {}, one cycle of them", points),
            "raise it, or shorten the lists of creepages or forces");
  const auto repeat = [&](auto& entries) {
    if (entries.empty()) return;
    const auto once = entries;
    entries.clear();
    for (int pass = 0; pass < fem.passes; ++pass) entries.push_back(once[pass % once.size()]);
  };
  repeat(input.rolling.creepages);
  repeat(input.rolling.forces);
  repeat(input.wheelset.rotation_change);
  repeat(input.wheelset.longitudinal_force);
  repeat(input.wheelset.axle_torque);
}

void complete(const GivenCase& given, Case& input) {
  namespace when = contact::when;
  static const std::vector<contact::Exclusion> exclusions{
      {!when::yields,
       {"fem.passes", "fem.pass_pressure", "fem.limit_state", "fem.plastic_extent",
        "fem.surface_layer"},
       "is for bodies that yield, but this case has none",
       "with [rail_plasticity] or [wheel_plasticity]",
       "add `yield_stress = 520.0` under [rail_plasticity], or remove it"},
      {when::shift,
       {"fem.passes", "fem.pass_pressure", "fem.limit_state"},
       "is of loads that roll over a body, but rolling.problem is shift",
       "the problems steady and frictionless",
       "remove it; the steps of [history] press bodies that yield"},
      {!when::profiles || !when::has("fem", "mesh") || when::is("fem", "mesh", "structured"),
       {"fem.rim_thickness"},
       "is of the wheel's true section, which this case does not mesh",
       "with profiles and mesh = \"gmsh\"",
       "write `mesh = \"gmsh\"` under [fem], or remove it"},
      {when::yields,
       {"fem.inertia"},
       "is for elastic bodies, but this case has bodies that yield",
       "without [rail_plasticity] and [wheel_plasticity]",
       "remove one of the two"},
      // A given mesh is clamped at its group `fixed`, which need not enclose it.
      {when::own_mesh,
       {"fem.far_boundary"},
       "applies to segments meshed by rollfem, but this case provides a mesh",
       "\"clamped\"",
       "remove fem.far_boundary, or the mesh"}};
  for (const contact::Exclusion& one : exclusions) contact::check_exclusion(given, one);
  if (input.yields() && input.rolling.problem != contact::Problem::shift)
    repeat_load_points(given, input);
  check_inertia(given, input);
}

void add_fem_keys() {
  FemKeys keys("fem", "Finite-element model");
  add_elements(keys);
  add_meshes(keys);
  add_passes(keys);
  keys.section().position = 5;
  keys.section().complete = complete;
  contact::add_section(keys);
}

/// The expected patch, from which the model derives values missing from the case.
halfspace::PatchBox box_for(const ModelInput& input, const char* key) {
  try {
    return halfspace::PatchSearch(input).box();
  } catch (const contact::InputError& error) {
    throw contact::InputError(
        fmt::format("{}: study: the study starts from fem.{}, which this case does not give and "
                    "which cannot be derived from a patch ({}); do: give fem.{}",
                    input.file, key, error.what(), key));
  }
}

/// The case's own cell is the last level.
RefinedInput cell_level(ModelInput input, int k, int n) {
  auto& cell = input.options.set<FemOptions>().cell_size;
  if (!cell) cell = box_for(input, "cell_size").smaller() / 8.0;
  const double size = *cell * std::exp2(n - 1 - k);
  cell = size;
  return {fmt::format("{:.4g} mm", size), size, std::move(input)};
}

RefinedInput degree_level(ModelInput input, int k, int /*n*/) {
  input.options.set<FemOptions>().degree = k + 1;
  return {fmt::format("degree {}", k + 1), k + 1.0, std::move(input)};
}

/// The case's own domain is the last but one.
RefinedInput domain_level(ModelInput input, int k, int n) {
  if (!input.body_extent) input.body_extent = 8.0 * box_for(input, "extent").larger();
  const double factor = std::exp2(k - (n - 2));
  auto& options = input.options.set<FemOptions>();
  for (auto* length : {&input.body_extent, &options.width, &options.depth, &options.length})
    if (*length) **length *= factor;
  const double size = *input.body_extent;
  return {fmt::format("extent {:.4g} mm", size), size, std::move(input)};
}

}  // namespace

SmoothParts find_smooth_parts(const contact::Scene& scene, const contact::Progress& progress) {
  const Processes here = processes();  // the first looks for all of them
  if (here.count == 1) return found_here(scene, progress);
  const std::string bytes = here.first() ? packed(found_here(scene, progress)) : "";
  return unpacked(open_fem_library("model hybrid").from_first(bytes));
}

bool correction_is_kept(const contact::Scene& scene) {
  contact::Scene curved = scene;
  curved.follows_surface = 1.0;
  const auto correction = contact::attempt([&] { return hybrid::correction_scene(curved); });
  return correction &&
         CorrectionCache().find(*correction, scene.asks_for_stress()).parts.has_value();
}

contact::ModelInfo hybrid_model() {
  contact::ModelInfo hybrid{"hybrid", "hybrid",
                            "half-space on a fine grid with a correction for curved, finite bodies "
                            "from coarse finite elements"};
  hybrid.takes = contact::all_demands_but({Demand::sections, Demand::line_contact, Demand::inertia,
                                           Demand::distance_points, Demand::distance_quadratic,
                                           Demand::given_pressure, Demand::yielding_body});
  hybrid.run = [](const ModelInput& input, const contact::Progress& progress,
                  contact::Checkpoint* checkpoint) {
    return hybrid::run_hybrid(input, progress, checkpoint, find_smooth_parts);
  };
  hybrid.refinements = {halfspace::contact_grid()};
  hybrid.add_keys = add_fem_keys;
  hybrid.half_spaces = false;
  hybrid.choosable = contact::Choosable::corrected_half_spaces;
  hybrid.has_stress = hybrid.corrects_stress = hybrid.parallel = true;
  hybrid.built = ROLLFEM_WITH_FEM;
  hybrid.no_model_error =
      "not estimated: the error estimates include a tenth of the correction's effect";
  return hybrid;
}

contact::ModelInfo fem_model() {
  contact::ModelInfo fem{"fem", "FEM", "3D finite elements of both bodies"};
  fem.takes = contact::all_demands_but(
      {Demand::sections, Demand::line_contact, Demand::stress_in_rigid_body});
  fem.run = [](const ModelInput& input, const contact::Progress& progress,
               contact::Checkpoint* checkpoint) {
    return open_fem_library("model fem").run(input, progress, checkpoint);
  };
  // In a study of finite elements the contact element is the cell.
  fem.refinements = {{"cell", "grid", "FE cell", 2.0, 3, false, cell_level},
                     {"degree", "", "degree", 0.0, 2, true, degree_level},
                     {"domain", "", "extent", 2.0, 3, false, domain_level}};
  fem.add_keys = add_fem_keys;
  fem.half_spaces = false;
  fem.choosable = contact::Choosable::finite_bodies;
  fem.measures_others = fem.has_stress = fem.keeps_bodies = fem.parallel = fem.in_compare = true;
  fem.built = ROLLFEM_WITH_FEM;
  fem.no_model_error = "none known: linear elasticity of the bodies as given in the case";
  return fem;
}

}  // namespace rollfem::modelling
