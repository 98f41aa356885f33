// SPDX-License-Identifier: LGPL-2.1-or-later
// Worn wheels on worn rails, each from a seed and its number: S1002 and 60E1 as a profile gauge
// lists them, with waves, scatter and the steps of rounded heights. Spacings, decimals and
// pressures of the waves are those of three measured pairs.
#pragma once

#include "profiles/formula_profiles.hpp"
#include "profiles/profiles.hpp"
#include "track/motion/placed_scenes.hpp"

#include <fmt/format.h>

#include "tests/support/random_draws.hpp"
#include <array>
#include <cmath>
#include <string>

namespace rollfem::testing {

class WornPairs : private RandomDraws {
 public:
  explicit WornPairs(unsigned seed) : RandomDraws(seed) {}

  /// The most loaded patch of the left wheel, without a contact grid, rolling with its motion.
  contact::Scene scene(unsigned number) {
    begin(number);
    contact::Case input;
    input.file = fmt::format("worn pair {}", number);
    input.models = {"halfspace"};
    input.load.vertical_force = log_uniform(30e3, 150e3);
    input.friction_coefficient = uniform(0.15, 0.5);
    input.wheel.rolling_radius = uniform(380.0, 500.0);
    input.track.inclination = 1.0 / 40.0;
    input.wheelset.lateral_shift = {uniform(-4.0, 6.0)};
    input.wheelset.roll = {0.0};
    input.rolling.given.longitudinal = true;
    input.rolling.creepages = {{sign() * log_uniform(1e-4, 5e-3), 0.0, 0.0}};
    const double spacing = log_uniform(0.15, 0.6);
    const int decimals = chance(0.3) ? 2 : 4;
    profiles::ProfileCurve wheel = measured("S1002", true, spacing, decimals);
    profiles::ProfileCurve rail = measured("60E1", false, spacing, decimals);
    const auto search = track::make_search_scene(input, {std::move(wheel), std::move(rail)});
    return track::make_scenes(input, search).front().scene;
  }

 private:
  struct Wave {
    double number = 0.0;     ///< 1/mm, 2 pi over its length
    double amplitude = 0.0;  ///< mm
    double phase = 0.0;
  };

  /// A wave under pressure all along presses with pi E* A / l.
  Wave wave(double spacing) {
    constexpr double modulus = 115e3;  // MPa, E* of steel on steel
    const double length = log_uniform(2.0 * spacing, 10.0);
    const double pressure = log_uniform(20.0, 500.0);
    return {2.0 * M_PI / length, pressure * length / (M_PI * modulus), uniform(0.0, 2.0 * M_PI)};
  }

  profiles::ProfileCurve measured(const std::string& name, bool wheel, double spacing,
                                  int decimals) {
    const profiles::ProfileCurve curve = profiles::find_built_in_profile(name)->make();
    const std::array<Wave, 3> waves{wave(spacing), wave(spacing), wave(spacing)};
    const double scatter = log_uniform(1e-5, 1e-3);
    std::string text;
    for (double p = curve.first(); p <= curve.last(); p += spacing * uniform(0.9, 1.1)) {
      double off = scatter * uniform(-1.0, 1.0);
      for (const Wave& wave : waves) off += wave.amplitude * std::cos(wave.number * p + wave.phase);
      const profiles::ProfilePoint place = curve.at(p);
      text += fmt::format("{:.{}f} {:.{}f}\n", place.y - off * place.tangent_z, decimals,
                          place.z + off * place.tangent_y, decimals);
    }
    contact::ProfileSource source;
    source.name = name + ".txt";
    source.largest_kink = 40.0;
    return profiles::profile_of_text(text, source, wheel);
  }
};

}  // namespace rollfem::testing
