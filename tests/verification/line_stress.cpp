// SPDX-License-Identifier: LGPL-2.1-or-later
// Stress below strips is that of long elements (McEwen, antiplane shear, Norton's crane wheel: the
// book).
#include "halfspace/stress/subsurface.hpp"

#include "support/random_field.hpp"

namespace {

using halfspace::LoadedBody;
using halfspace::SubsurfacePoint;

TEST(LineStress, IsThatOfLongElements) {
  // Any tractions, all components and the displacements of both bodies; the middle of elements as
  // long as the line's width, relative to distant points.
  for (const auto side : {halfspace::Body::wheel, halfspace::Body::rail}) {
    LoadedBody strips{side, {180e3, 0.33}, ContactGrid::centred(9, 1, 0.3, 2e5), {}};
    strips.traction = random_field(strips.grid, 11);
    LoadedBody line = strips;
    line.grid.line_reference = contact::infinity;
    std::vector<SubsurfacePoint> points{{0.0, 0.0, 0.0}, {1.2, 0.0, 0.0}};
    for (const double z : {0.05, 0.7, 3.0})
      for (const double x : {-2.0, -0.45, 0.1, 1.9}) points.push_back({x, 0.0, z});
    const auto one = halfspace::subsurface_at(line, points);
    const auto other = halfspace::subsurface_at(strips, points);
    for (std::size_t k = 0; k < points.size(); ++k) {
      SCOPED_TRACE(k);
      for (std::size_t c = 0; c < 6; ++c) EXPECT_NEAR(one[k].stress[c], other[k].stress[c], 1e-6);
      for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(one[k].displacement[c], other[k].displacement[c], 1e-9);
    }
  }
}

}  // namespace
