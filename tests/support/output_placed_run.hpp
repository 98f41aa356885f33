// SPDX-License-Identifier: LGPL-2.1-or-later
// A run of several patches on profiles, for the tests of output, figures and report.
#pragma once

#include "result/write/output.hpp"

#include "support/output_synthetic_run.hpp"
#include "support/test.hpp"

namespace rollfem::testing {

using result::PlacedPair;
using result::RunRecord;

/// Left wheel at `positions` positions, of which the last has two patches.
inline RunRecord placed_run(int positions) {
  const RunRecord plain = synthetic_run();
  RunRecord run = plain;
  run.models.clear();
  run.input.wheel.profile.name = "S1002";
  run.input.rail.profile.name = "60E1";
  run.input.load.normal_force.reset();
  run.input.load.vertical_force = 50e3;
  for (int position = 1; position <= positions; ++position)
    for (int patch = 1; patch <= (position == positions ? 2 : 1); ++patch)
      for (std::size_t k = 1; k < plain.models.size(); ++k) {
        contact::ModelResult model = plain.models[k];
        contact::ContactPlace place;
        place.position = position;
        place.patch = patch;
        place.patches = position == positions ? 2 : 1;
        place.lateral_shift = position - 1.0;
        place.y_track = -755.0 - position + 30.0 * (patch - 1);
        place.z_track = patch == 1 ? 0.1 : 12.5;
        place.contact_angle = patch == 1 ? 0.016 : 1.1;
        place.rolling_radius = 450.177;
        model.place = place;
        model.bodies.clear();
        for (contact::PointResult& point : model.points) {
          point.bodies.clear();
          point.lateral_force_track = 3e3;
        }
        run.models.push_back(model);
      }
  for (int position = 1; position <= positions; ++position) {
    PlacedPair pair;
    pair.position = position;
    for (int k = -30; k <= 30; ++k) {
      pair.rail.push_back({-760.5 + k, k * k / 300.0});
      pair.wheel.push_back({-760.0 + k, -0.1 + k / 40.0});
    }
    run.pairs.push_back(pair);
  }
  return run;
}

}  // namespace rollfem::testing
