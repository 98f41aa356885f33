// SPDX-License-Identifier: LGPL-2.1-or-later
#include "app/run/bench_cases.hpp"

namespace rollfem::app {

namespace {

/// Cases of the study of 2012 (cases/thesis_a.toml, thesis_c.toml) with varying rail radius and
/// creepages.
std::string crowned_rail(const std::string& title, const std::string& radius,
                         const std::string& creepages) {
  return "title = \"" + title +
         "\"\n"
         "[load]\nnormal_force = 50e3\n"
         "[friction]\ncoefficient = 0.55\n"
         "[wheel]\nrolling_radius = 405.0\ntransverse_radius = inf\nyoung_modulus = 210e3\n"
         "poisson_ratio = 0.3\n"
         "[rail]\ntransverse_radius = " +
         radius +
         "\nyoung_modulus = 210e3\npoisson_ratio = 0.3\n"
         "[rolling]\nlongitudinal_creepage = [" +
         creepages + "]\n";
}

/// cases/benchmark9.toml
const char* const circle =
    "title = \"circle with creepage and spin\"\n"
    "[load]\nnormal_force = 82e3\n"
    "[friction]\ncoefficient = 0.3\n"
    "[wheel]\nyoung_modulus = 209920.0\npoisson_ratio = 0.28\n"
    "[rail]\nyoung_modulus = 209920.0\npoisson_ratio = 0.28\n"
    "[given_pressure]\nsemi_axis_x = 6.0\nsemi_axis_y = 6.0\n"
    "[rolling]\nlongitudinal_creepage = -1e-3\nlateral_creepage = 5e-4\nspin = 1e-4\n";

constexpr const char* coefficient = "traction_coefficient";

}  // namespace

const std::vector<BenchCase>& bench_cases() {
  static const std::vector<BenchCase> cases{
      {"wide",
       "ellipse of 7.6 by 21.7 mm, 50 kN, braking at 0.05, 0.2 and 0.4 %",
       crowned_rail("wide ellipse", "2000.0", "0.0005, 0.002, 0.004"),
       578.967,
       {{0, coefficient, 0.11533, 0.55},
        {1, coefficient, 0.37212, 0.55},
        {2, coefficient, 0.53012, 0.55}},
       true},
      {"narrow",
       "ellipse of 12.5 by 4.9 mm, 50 kN, braking at 0.1 and 0.4 %",
       crowned_rail("narrow ellipse", "100.0", "0.001, 0.004"),
       1548.581,
       {{0, coefficient, 0.13237, 0.55}, {1, coefficient, 0.40478, 0.55}},
       false},
      {"spin",
       "circle of 12 mm under Hertz's pressure, 82 kN, creepage both ways and spin",
       circle,
       0.0,
       {{0, "longitudinal_force", 10250.5, 24600.0}, {0, "lateral_force", -7073.0, 24600.0}},
       false},
  };
  return cases;
}

}  // namespace rollfem::app
