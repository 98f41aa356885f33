// SPDX-License-Identifier: LGPL-2.1-or-later
// Two discs of a twin-disc machine in line contact: Carter's solution, and a layer between them.
#include "contact/scene/scene.hpp"

#include "support/committed_cases.hpp"
#include "support/half_space_models.hpp"

namespace {

TEST(TwinDisc, OfEqualDiscsIsCartersSolution) {
  // Half width in mm of steel discs of 23.5 mm under 719.8 N/mm, and their relative radius.
  const double half_width = 0.305496, relative_radius = 11.75, mu = 0.46;
  const ModelResult result =
      half_space_models().run("halfspace", contact::Scene(committed_case("twin_disc")), {});
  EXPECT_NEAR(result.points.at(0).max_pressure, 1500.0, 1.5);
  for (const PointResult& point : result.points) {
    const double shift = point.creepage.longitudinal * relative_radius / (mu * half_width);
    const double exact = mu * (1.0 - std::pow(std::max(1.0 - shift, 0.0), 2));
    EXPECT_NEAR(-point.longitudinal_force / point.normal_force, exact, 1e-3 * exact) << shift;
  }
}

TEST(TwinDisc, WithALayerIsThatOfCollocation) {
  // benchmarks/book/layered_cylinders.py: tractions linear between nodes, 600 elements.
  const std::vector<double> exact = {0.09837, 0.22336, 0.36191, 0.45845};
  Case input = committed_case("twin_disc");
  input.layer.emplace();
  input.layer->thickness = 0.02;
  input.layer->shear_modulus = 12000.0;
  const ModelResult result = half_space_models().run("halfspace", contact::Scene(input), {});
  for (std::size_t k = 0; k < exact.size(); ++k) {
    const PointResult& point = result.points.at(k);
    EXPECT_NEAR(-point.longitudinal_force / point.normal_force, exact[k], 1e-3 * 0.46);
  }
}

}  // namespace
