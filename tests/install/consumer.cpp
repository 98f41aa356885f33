// Pressure of case a by the installed half-space model, against exact Hertz.
#include "contact/case/case_reader.hpp"
#include "halfspace/model/model.hpp"

#include <cmath>
#include <cstdio>

int main(int, char** arguments) {
  rollfem::contact::Case input = rollfem::contact::read_case(arguments[1]);
  input.rolling.creepages.resize(1);
  input.contact_grid.elements_across = 20;
  const auto result = rollfem::halfspace::run_halfspace(input, {});
  const double p0 = result.points.front().max_pressure;
  std::printf("p0 = %.3f MPa\n", p0);
  return std::abs(p0 / 578.967 - 1.0) < 0.005 ? 0 : 1;
}
