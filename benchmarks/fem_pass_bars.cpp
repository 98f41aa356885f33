// SPDX-License-Identifier: LGPL-2.1-or-later
// How often the error bars of passes over steel that yields hold: random rigid wheels on random
// rails, every sixth of them S1002 near the gauge corner of 60E1, with cells of 1/PARTS of the
// smaller semi-axis against cells of 1/FINER. p0 is 3 to 7 times the yield stress in shear for
// elastic bodies, friction 0 to 0.5, the steel perfectly plastic, linear, or saturating; of every
// fifth scene the pressure follows the groove. Prints the table of docs/plasticity.md, and to
// stderr what every scene is and costs, or why it has no result. Call: benchmark_fem_pass_bars
// PARTS FINER PASSES SEED FIRST NUMBER [rows], e.g. 3 4.5 3 1 0 30. With `rows`, also prints every
// number: scene, pass, quantity, on cells of twice the size, on the cells, on the finer ones, bar.
#include "case/reading/case_reader.hpp"
#include "fem/elasticity/fem_error_bars.hpp"
#include "fem/elasticity/run_level.hpp"
#include "fem/fem_options.hpp"
#include "fem/plasticity/yielding_bodies.hpp"
#include "halfspace/patch/patch_search.hpp"
#include "result/quantities.hpp"
#include "track/motion/placed_scenes.hpp"

#include <deal.II/base/mpi.h>
#include <fmt/format.h>

#include "tests/support/model_keys.hpp"
#include "tests/support/random_draws.hpp"
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>

using namespace rollfem;

namespace {

class RollingLoads : public testing::RandomDraws {
 public:
  explicit RollingLoads(unsigned seed) : RandomDraws(seed) {}

  contact::Scene scene(unsigned number, int passes) {
    begin(number);
    const bool corner = number % 6 == 5;
    const std::string text =
        corner ? of_file("cases/head_checks.toml")
               : fmt::format(
                     "[load]\nnormal_force = {}\n[friction]\ncoefficient = 0.3\n[wheel]\n"
                     "rolling_radius = 450.0\ntransverse_radius = inf\n[rail]\n"
                     "transverse_radius = {}\n[rail_plasticity]\nyield_stress = 1.0\n"
                     "[rolling]\nlongitudinal_creepage = 0.03\n",
                     log_uniform(30e3, 150e3), log_uniform(100.0, 2000.0));
    std::vector<std::string> changes{
        fmt::format("friction.coefficient={}", uniform(0.0, 0.5)),
        fmt::format("rolling.longitudinal_creepage={}", chance(0.5) ? 0.03 : uniform(1e-3, 5e-3)),
        fmt::format("fem.passes={}", passes), "wheel.young_modulus=inf",
        fmt::format("fem.pass_pressure={}", number % 5 == 0 ? "yielding" : "elastic")};
    if (corner) changes.push_back(fmt::format("wheelset.lateral_shift={}", uniform(-4.5, -2.0)));
    contact::Case input = contact::parse_case(contact::with_changes(text, "case", changes), "case");
    const double load_factor = uniform(3.0, 7.0);
    contact::BodyPlasticity steel;
    if (number % 3 == 1) steel.back_stresses[0].modulus = log_uniform(5e3, 60e3);
    if (number % 3 == 2) {
      steel.back_stresses[0] = {60e3, uniform(200.0, 400.0)};
      steel.back_stresses[1] = {16e3, uniform(30.0, 60.0)};
    }
    steel.yield_stress = 1.0;
    input.rail.plasticity = steel;
    contact::Scene made = corner ? track::make_scenes(input).front().scene : contact::Scene(input);
    made.rail.plasticity->yield_stress =
        std::sqrt(3.0) * halfspace::PatchSearch(made).patch().max_pressure / load_factor;
    // Saves most of the restarts with a larger region.
    made.options.set<fem::FemOptions>().plastic_extent = std::max(1.0, 0.3 + 0.2 * load_factor);
    return made;
  }

 private:
  static std::string of_file(const std::string& name) {
    std::ifstream file(name);
    return {std::istreambuf_iterator<char>(file), {}};
  }
};

struct Count {
  int numbers = 0, held = 0, without = 0;
  std::vector<double> parts;  ///< bars over values
};

/// The levels from the coarsest; all grow where steel yields at a border.
std::vector<contact::ModelResult> levels_of(contact::Scene scene, std::vector<double> cells) {
  for (int times = 0;; ++times) try {
      std::vector<contact::ModelResult> levels;
      for (const double cell : cells) {
        const contact::Stopwatch watch;
        levels.push_back(fem::run_level(scene, {cell, "", false}, {}));
        fmt::print(stderr, "cells of {:.3g} mm: {} unknowns, {:.0f} s\n", cell,
                   levels.back().unknowns, watch.seconds());
      }
      return levels;
    } catch (const fem::YieldsBeyondStreamlines& beyond) {
      if (times == 8) throw;
      scene.options.set<fem::FemOptions>().plastic_growth[beyond.direction] *= 1.3;
    }
}

}  // namespace

int main(int count, char** words) {
  if (count < 7) {
    fmt::print(stderr,
               "call: benchmark_fem_pass_bars PARTS FINER PASSES SEED FIRST NUMBER [rows]\n");
    return 2;
  }
  const auto given = [&](int k) { return std::atof(words[k]); };
  const bool rows = count > 7;
  int no_words = 1;
  const dealii::Utilities::MPI::MPI_InitFinalize session(no_words, words, 1);
  RollingLoads loads(static_cast<unsigned>(given(4)));
  std::map<std::string, Count> counts;
  int solved = 0;
  const auto first = static_cast<unsigned>(given(5)), end = first + static_cast<unsigned>(given(6));
  for (unsigned number = first; number < end; ++number) try {
      const contact::Scene scene = loads.scene(number, static_cast<int>(given(3)));
      const auto patch = halfspace::PatchSearch(scene).patch();
      fmt::print(stderr, "scene {}: p0 {:.0f} MPa, yield stress {:.0f} MPa, friction {:.2f}\n",
                 number, patch.max_pressure, scene.rail.plasticity->yield_stress,
                 scene.friction_coefficient());
      const double axis = halfspace::PatchSearch(scene).box().smaller();
      const double cell = axis / given(1);
      auto levels = levels_of(scene, {2.0 * cell, cell, axis / given(2)});
      const contact::ModelResult finer = std::move(levels.back());
      levels.pop_back();
      fem::set_error_bars(scene, levels);
      ++solved;
      for (std::size_t k = 0; k < finer.points.size(); ++k)
        for (const char* name : fem::pass_quantities) {
          const auto value = contact::quantity_named(name).member.get;
          const contact::PointResult& point = levels[1].points[k];
          const double here = *value(point), truth = *value(finer.points[k]);
          const auto bar = point.bar_of(name);
          if (rows)
            fmt::print("{} {} {} {:.6g} {:.6g} {:.6g} {:.6g}\n", number, k + 1, name,
                       *value(levels[0].points[k]), here, truth, bar.value_or(-1.0));
          Count& of = counts[name];
          if (!bar) {
            ++of.without;
            continue;
          }
          ++of.numbers;
          of.held += std::abs(truth - here) <= *bar ? 1 : 0;
          if (here != 0.0) of.parts.push_back(*bar / std::abs(here));
        }
      std::fflush(stdout);
    } catch (const std::exception& error) {
      fmt::print(stderr, "scene {}: {}\n", number, error.what());
    }
  fmt::print(
      "\n{} scenes solved\n\n| quantity | bars | held | no bar | median of bar / value |\n"
      "|---|---|---|---|---|\n",
      solved);
  for (auto& [name, of] : counts) {
    const auto middle = of.parts.begin() + static_cast<std::ptrdiff_t>(of.parts.size() / 2);
    std::nth_element(of.parts.begin(), middle, of.parts.end());
    fmt::print("| `{}` | {} | {} | {} | {:.2g} |\n", name, of.numbers, of.held, of.without,
               of.parts.empty() ? 0.0 : *middle);
  }
  return 0;
}
