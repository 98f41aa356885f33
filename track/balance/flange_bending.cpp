// SPDX-License-Identifier: LGPL-2.1-or-later
#include "track/balance/flange_bending.hpp"

#include "halfspace/patch/load_sharing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace rollfem::track {

using contact::Case;
using contact::Scene;

namespace {

/// Length in the compliance of the flange, mm (shares_with_bending).
constexpr double length_of_bending = 18.4;
/// Less bending than this, mm, is not worth another solution.
constexpr double least_bending = 1e-3;
/// Smallest change of a share that is noted, relative to the load.
constexpr double worth_noting = 5e-3;

std::vector<double> normal_forces(const std::vector<Scene>& scenes, double load) {
  std::vector<double> forces;
  for (const halfspace::PatchLoad& share : halfspace::share_load(scenes, load).shares)
    forces.push_back(share.normal_force);
  return forces;
}

}  // namespace

BentShares shares_with_bending(const Case& input, const std::vector<Scene>& scenes) {
  double load = 0.0, highest = 0.0;
  std::vector<double> height, sine;
  for (const Scene& scene : scenes) {
    const contact::ContactPlace& place = *scene.place;
    height.push_back(std::max(place.rolling_radius - input.wheel.rolling_radius, 0.0));
    sine.push_back(std::sin(place.contact_angle));
    load += scene.points.front().load.force.value_or(0.0);
    highest = std::max(highest, height.back());
  }
  // Angle of bending per moment of the lateral forces about the tread.
  const double flexibility =
      1.0 / (input.wheel.material.young_modulus * std::pow(length_of_bending, 3));
  const auto moment_of = [&](const std::vector<double>& normal) {
    double moment = 0.0;
    for (std::size_t i = 0; i < normal.size(); ++i) moment += normal[i] * sine[i] * height[i];
    return moment;
  };
  BentShares shares;
  if (!(flexibility * load * highest * highest > least_bending)) return shares;
  shares.stiff = normal_forces(scenes, load);
  const double moment = moment_of(shares.stiff);
  if (!(flexibility * moment * highest > least_bending)) return shares;
  std::vector<Scene> bent = scenes;
  for (std::size_t i = 0; i < bent.size(); ++i)
    bent[i].place->separation += flexibility * moment * height[i] * sine[i];
  shares.bent = normal_forces(bent, load);
  // Bending falls with the force that causes it; the shares are taken as linear in it.
  const double part = moment / (2.0 * moment - moment_of(shares.bent));
  for (std::size_t i = 0; i < bent.size(); ++i)
    shares.bent[i] = shares.stiff[i] + part * (shares.bent[i] - shares.stiff[i]);
  shares.bending = part * flexibility * moment * highest;
  return shares;
}

std::vector<contact::Note> bending_notes(const Case& input, const std::vector<Scene>& scenes) {
  std::vector<contact::Note> notes;
  if (!input.load.vertical_force) return notes;
  for (const bool left : {true, false}) {
    std::vector<Scene> wheel;
    for (const Scene& scene : scenes)
      if (scene.place->left == left) wheel.push_back(scene);
    if (wheel.size() < 2) continue;
    const BentShares shares = shares_with_bending(input, wheel);
    std::string changes;
    double largest = 0.0;
    for (std::size_t i = 0; i < shares.bent.size(); ++i) {
      largest = std::max(largest, std::abs(shares.bent[i] - shares.stiff[i]));
      changes += fmt::format("{}{:.1f} for {:.1f}", i > 0 ? ", " : "", 1e-3 * shares.bent[i],
                             1e-3 * shares.stiff[i]);
    }
    if (largest > worth_noting * *input.load.vertical_force)
      contact::add_note(notes, fmt::format("flange_bending_{}", contact::side_word(left)),
                        "{} wheel{}: a flange 30 mm thick would bend by some {:.0f} um under this "
                        "load, which no "
                        "model includes: its contacts would carry {} kN",
                        contact::side_word(left),
                        input.wheelset.positions() > 1
                            ? fmt::format(" at position {}", wheel.front().place->position)
                            : "",
                        1e3 * shares.bending, changes);
  }
  return notes;
}

}  // namespace rollfem::track
