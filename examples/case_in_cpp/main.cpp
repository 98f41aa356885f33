// SPDX-License-Identifier: LGPL-2.1-or-later
// Reads a case, changes it, solves it with two models and prints a creep curve with error bars;
// then solves a case from text with a known answer: the largest Hertzian pressure of case a is
// 578.967 MPa. Call: case_in_cpp CASE.toml
#include <cmath>
#include <cstdio>
#include <rollfem/rollfem.hpp>

int main(int, char** words) try {
  rollfem::Case input = rollfem::read_case(words[1]);
  input.contact_grid.elements_across = 20;
  const rollfem::Result result = rollfem::solve(input, {"hertz", "halfspace"});
  for (const rollfem::ModelResult& model : result.models)
    for (const rollfem::PointResult& point : model.points) {
      const auto bar = point.error_estimate.find("traction_coefficient");
      std::printf("%-10s xi %.4f  -F_x/F_z %.5f +- %.5f  p_0 %.2f MPa\n", model.name.c_str(),
                  point.creepage.longitudinal, point.traction_coefficient,
                  bar == point.error_estimate.end() ? 0.0 : bar->second, point.max_pressure);
    }
  const rollfem::Case same = rollfem::parse_case(R"(
    [load]
    normal_force = 50e3
    [friction]
    coefficient = 0.55
    [wheel]
    rolling_radius = 405.0
    transverse_radius = inf
    [rail]
    transverse_radius = 2000.0
  )");
  const double p0 = rollfem::solve(same, {"hertz"}).models.front().points.front().max_pressure;
  std::printf("p0 = %.3f MPa\n", p0);
  return std::abs(p0 / 578.967 - 1.0) < 1e-5 ? 0 : 1;
} catch (const rollfem::InputError& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
} catch (const rollfem::SolveError& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
