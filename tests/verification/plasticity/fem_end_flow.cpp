// SPDX-License-Identifier: LGPL-2.1-or-later
// How far the clamped ends of a segment hold plastic flow back.
#include "fem/discretisation/body_points.hpp"

#include "support/fem_plane_strain.hpp"

namespace {

/// Forward displacement of the surface behind a load of 4.2 k with a friction of 0.2 after one
/// pass, mm, with ends this far away.
double flow_of_surface(double extent) {
  SlabOptions options;
  options.per_half_width = 4;
  options.extent = extent;
  const auto slab = rolled_slab(options);
  Passes passes(*slab, plain_steel(300.0, 10e3), 4.2 * 300.0, 0.2);
  passes.next();
  const auto place = fem::BodyLocator(*slab->body).find({{-1.5, 0.1, 0.0}}, 0.1);
  return place.values(passes.state.displacement, {1, 1, 1}).front()[0];
}

// In plane strain, where what ends do decays slowest: 2.1 % at eight half-widths, the usual extent.
TEST(PlasticLineContact, FlowsForwardsBetweenNearEndsAsBetweenFarOnes) {
  const double far = flow_of_surface(80.0);
  EXPECT_GT(far, 0.0);
  EXPECT_NEAR(flow_of_surface(8.0), far, 0.03 * far);
}

}  // namespace
