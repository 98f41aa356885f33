// SPDX-License-Identifier: LGPL-2.1-or-later
// Three dimensions against plane strain: below the middle of a patch much wider than long, steel
// flows as below a line contact.
#include "support/fem_plane_strain.hpp"

namespace {

/// MPa.
constexpr double yield_below_patch = 300.0, pressure_of_patch = 3.8 * yield_below_patch;

/// Below the middle behind the load: plastic strain xz, residual stress along and across over p0,
/// for every depth.
using Profile = std::vector<std::array<double, 3>>;

/// After each of so many passes.
std::vector<Profile> profiles_below_middle(const RolledBody& slab, double friction, int passes) {
  Passes rolled(slab, plain_steel(yield_below_patch, 210e3 / 20.0), pressure_of_patch, friction);
  rolled.accuracy.residual = 1e-4;
  std::vector<Profile> profiles;
  for (int pass = 0; pass < passes; ++pass) {
    rolled.next();
    Passes unloaded = rolled.unloaded();
    unloaded.next();
    Profile profile;
    for (const auto& [depth, stress] : residual_below(unloaded, -1.0, 1.0)) {
      const auto stream = profile.size() * slab.lines.width();
      profile.push_back({rolled.state.leaving[stream].strain[5], stress[0] / pressure_of_patch,
                         stress[1] / pressure_of_patch});
    }
    profiles.push_back(profile);
  }
  return profiles;
}

/// Largest differences of two profiles: that of strain over its largest.
std::array<double, 3> differences(const Profile& of, const Profile& from) {
  std::array<double, 3> largest{};
  double strain = 0.0;
  for (std::size_t row = 0; row < from.size(); ++row) {
    strain = std::max(strain, std::abs(from[row][0]));
    for (int c = 0; c < 3; ++c)
      largest[c] = std::max(largest[c], std::abs(of[row][c] - from[row][c]));
  }
  largest[0] /= strain;
  return largest;
}

std::unique_ptr<RolledBody> slab_under_patch(double wide) {
  SlabOptions options;
  options.per_half_width = 4;
  options.extent = 6.0;
  options.growth = 2.0;
  options.wide = wide;
  return rolled_slab(options);
}

}  // namespace

// Hertz's pressure of a line over a width of 4 and 8 half-widths, with the same cells of a/4 along
// and down. What the ends of the patch do falls with its width. At the greater one strain differs
// by 3.5 % without and 0.9 % with friction (6.5 % after the second pass, which adds a thin layer),
// stress along by 0.007 and 0.011 p0. Stress across differs by 0.03 and 0.05 p0 and falls as the
// inverse of the width only: plastic flow lengthens a band as wide as the patch, which the steel
// beside it does not hold as firmly as the sides of a slab.
TEST(PlasticWidePatch, FlowsInItsMiddleAsInPlaneStrain) {
  const auto plane = slab_under_patch(0.0), narrow = slab_under_patch(2.0),
             wide = slab_under_patch(4.0);
  for (const double friction : {0.0, 0.2}) {
    const int passes = friction > 0.0 ? 2 : 1;
    const auto expected = profiles_below_middle(*plane, friction, passes);
    const auto of_narrow = profiles_below_middle(*narrow, friction, 1);
    const auto of_wide = profiles_below_middle(*wide, friction, passes);
    const auto far = differences(of_narrow[0], expected[0]);
    const auto near = differences(of_wide[0], expected[0]);
    EXPECT_LT(near[0], 0.045) << friction;
    EXPECT_LT(near[1], 0.015) << friction;
    EXPECT_LT(near[2], 0.055) << friction;
    for (int c = 0; c < 3; ++c) EXPECT_LT(near[c], 0.5 * far[c]) << friction << ' ' << c;
    if (passes == 1) continue;
    const auto second = differences(of_wide[1], expected[1]);
    EXPECT_LT(second[0], 0.08);
    EXPECT_LT(second[1], 0.015);
    EXPECT_LT(second[2], 0.055);
  }
}
