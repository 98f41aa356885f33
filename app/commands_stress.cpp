// SPDX-License-Identifier: LGPL-2.1-or-later
#include "app/commands.hpp"

namespace rollfem::app {

void add_stress_command(CLI::App& program, Call& call) {
  StressCommand& request = call.stress;
  CLI::App* stress = program.add_subcommand(
      "stress",
      "stress and displacement at points, on lines and on planes from stored results, without "
      "solving again; largest stresses; shakedown map");
  stress->add_option("result", request.result, "result folder of rollfem run, or its results.h5")
      ->required();
  stress
      ->add_option("-m,--model", request.models,
                   "models of the result, separated by commas; default: " +
                       contact::listed(call.models.names(&contact::ModelInfo::has_stress)) +
                       ", if present")
      ->delimiter(',')
      ->allow_extra_args(false);
  stress->add_option("--patch", request.patch,
                     "with profiles: SIDE,POSITION,PATCH, e.g. left,1,1; default: the first");
  stress
      ->add_option("--point", request.points,
                   "load points, counted from 1, separated by commas; default: the last")
      ->delimiter(',')
      ->allow_extra_args(false);
  stress
      ->add_option("--creepage", request.creepages,
                   "load points with these longitudinal creepages, separated by commas")
      ->delimiter(',')
      ->allow_extra_args(false);
  stress->add_option(
      "--places", request.places,
      "TOML file with [[subsurface.point]], .line, .plane and .surface, as in a case file");
  stress->add_flag("--depth-profile", request.depth_profile,
                   "add vertical lines below the centre of the patch and below the most loaded "
                   "element; the default when no points are requested");
  stress->add_option("--depth", request.depth,
                     "depth of these lines in mm; default: three times the smaller semi-axis");
  stress->add_option("--yield-shear-stress", request.yield_shear_stress,
                     "shear yield stress k in MPa, for the shakedown map");
  stress->add_option("--yield-strength", request.yield_strength,
                     "yield strength in MPa, instead of k (k = strength / sqrt(3))");
  stress->add_option("-o,--output", request.directory,
                     "folder for stress.csv, stress.json and figures; default: the name of the "
                     "result folder with _stress");
  add_json_flag(*stress, request.json);
  stress->add_flag("-q,--quiet", request.quiet, "print errors and warnings only");
  stress->add_flag_callback(
      "--no-figures", [&request] { request.figures = false; }, "write the tables only");
  stress->footer(
      "example: rollfem stress results/thesis_a --yield-strength 520 --places places.toml\n"
      "x along rolling, y lateral, z into the wheel: z > 0 in the wheel, z < 0 in the rail.");
  stress->callback([&call] { app::stress(call.stress, call.models, call.undrawn); });
}

}  // namespace rollfem::app
