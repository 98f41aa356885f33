// SPDX-License-Identifier: LGPL-2.1-or-later
// rollfem.h at a given height or penetration of the wheel, structures of other sizes, more patches
// than are listed, and T-gamma.
#include "rollfem/rollfem.h"
#include "support/temporary_folder.hpp"
#include "support/wheel_on_rail.hpp"
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <fstream>

namespace {

void expect_same(const rollfem_result& a, const rollfem_result& b, double of_bound) {
  ASSERT_EQ(a.patch_count, b.patch_count);
  const double within = of_bound * 0.3 * 50e3;
  for (int d = 0; d < 3; ++d) {
    EXPECT_NEAR(a.force[d], b.force[d], within);
    EXPECT_NEAR(a.moment[d], b.moment[d], 750.0 * within);
  }
  for (int k = 0; k < a.patch_count; ++k)
    EXPECT_NEAR(a.patch[k].normal_force, b.patch[k].normal_force, within);
}

TEST(CHeight, IsTheOneOfTheForceAndBack) {
  const Pair pair = make(defaults(ROLLFEM_RIGHT));
  struct Place {
    double shift, yaw;
  };
  // On the tread, in two regions, in two planes, in a conformal patch.
  for (const auto& [shift, yaw] :
       {Place{-2.0, -1e-3}, {3.0, 2e-3}, {5.0, 4e-3}, {5.9, 0.03}, {6.6, 5e-3}}) {
    rollfem_state state = state_at(shift, yaw);
    state.roll = shift == 5.9 ? -2.5e-5 * shift * shift : 0.0;
    const rollfem_result by_force = solve(pair, state);
    EXPECT_GT(by_force.penetration, 0.02);
    state.vertical_force = -1.0;  // not read
    state.given = ROLLFEM_HEIGHT;
    state.height = by_force.touching_height + by_force.penetration;
    const rollfem_result by_height = solve(pair, state);
    expect_same(by_height, by_force, 5e-3);
    EXPECT_NEAR(by_height.penetration, by_force.penetration, 1e-9);
    state.given = ROLLFEM_PENETRATION;
    state.penetration = by_force.penetration;
    state.height = 1e9;  // not read
    expect_same(solve(pair, state), by_height, 1e-6);
  }
}

TEST(CHeight, IsThatOfTheFullHalfSpace) {
  rollfem_definition definition = defaults(ROLLFEM_RIGHT);
  definition.elements_across = 24;
  const Pair quick = make(defaults(ROLLFEM_RIGHT)), fine = make(definition);
  for (const double shift : {-2.0, 3.0}) {
    rollfem_state state = state_at(shift, 5e-4 * shift);
    const rollfem_result by_force = solve(quick, state);
    EXPECT_NEAR(solve(fine, state).penetration / by_force.penetration, 1.0, 0.01);
    state.given = ROLLFEM_PENETRATION;
    state.penetration = by_force.penetration;
    expect_same(solve(fine, state), by_force, 0.03);
  }
}

/// A sphere as a wheel below its axle or as a roller above it, z down; its file.
std::string sphere(double radius, double sign, const std::string& path) {
  std::ofstream file(path);
  for (double y = -40.0; y <= 40.0; y += 0.5)
    file << y << ' ' << sign * (std::sqrt(radius * radius - y * y) - radius) << '\n';
  return path;
}

TEST(CHeight, OfASphereOnASphericalRollerIsHertzs) {
  const TemporaryFolder folder;
  const std::string wheel = sphere(300.0, 1.0, folder.path("wheel.csv"));
  const std::string roller = sphere(500.0, -1.0, folder.path("roller.csv"));
  rollfem_definition definition = defaults(ROLLFEM_RIGHT);
  definition.gauge = 0.0;
  definition.wheel_profile = wheel.c_str();
  definition.rail_profile = roller.c_str();
  definition.rolling_radius = 300.0;
  definition.rail_rolling_radius = 500.0;
  rollfem_state state = state_at(0.0, 0.0);
  state.roll = 0.0;
  state.rotation_speed = state.forward_speed / 300.0;
  state.given = ROLLFEM_HEIGHT;
  state.height = 0.05;
  const rollfem_result result = solve(make(definition), state);
  const double modulus = 210e3 / (2.0 * (1.0 - 0.09)), relative = 1.0 / (1.0 / 300.0 + 1.0 / 500.0);
  const double force = 4.0 / 3.0 * modulus * std::sqrt(relative) * std::pow(0.05, 1.5);
  ASSERT_EQ(result.patch_count, 1);
  EXPECT_NEAR(result.touching_height, 0.0, 1e-6);
  EXPECT_NEAR(result.patch[0].normal_force / force, 1.0, 0.01);
  EXPECT_NEAR(result.patch[0].longitudinal_creepage, 0.0, 1e-6);
  state.lateral_shift = 8.0;  // up the roller's side
  EXPECT_NEAR(solve(make(definition), state).patch[0].position[1], 8.0 * 500.0 / 800.0, 0.01);
  definition.side = ROLLFEM_LEFT;
  char message[512];
  EXPECT_EQ(rollfem_create(&definition, message, sizeof message), nullptr);
  EXPECT_TRUE(says(message, "side", "ROLLFEM_RIGHT"));
}

TEST(CHeight, AboveTheRailThereIsNoForce) {
  for (const int across : {12, 24}) {
    rollfem_definition definition = defaults();
    definition.elements_across = across;
    const Pair pair = make(definition);
    rollfem_state state = state_at(1.0, 0.0);
    const double touching = solve(pair, state).touching_height;
    state.given = ROLLFEM_HEIGHT;
    state.height = touching - 0.5;
    const rollfem_result result = solve(pair, state);
    EXPECT_EQ(result.patch_count, 0);
    EXPECT_EQ(result.force[2], 0.0);
    EXPECT_NEAR(result.penetration, -0.5, 1e-9);
    EXPECT_NEAR(result.touching_height, touching, 1e-9);
    state.given = ROLLFEM_PENETRATION;
    state.penetration = 0.0;
    EXPECT_EQ(solve(pair, state).patch_count, 0);
    auto derivatives = sized<rollfem_derivatives>();
    auto place = sized<rollfem_result>();
    EXPECT_EQ(rollfem_linearise(pair.get(), &state, &place, &derivatives, nullptr, 0), ROLLFEM_OK);
    EXPECT_EQ(derivatives.stiffness, 0.0);
  }
}

TEST(CHeight, ARollThatIsFoundServesTheOtherWheel) {
  const Pair left = make(defaults(ROLLFEM_LEFT)), right = make(defaults(ROLLFEM_RIGHT));
  rollfem_state state = state_at(2.0, 0.0);
  state.roll = std::nan("");
  const rollfem_result found = solve(left, state), other = solve(right, state);
  EXPECT_NEAR(found.touching_height, other.touching_height, 1e-6) << "both wheels touch";
  state.roll = found.roll;
  EXPECT_EQ(solve(right, state).force[1], other.force[1]);
}

TEST(CHeight, RefusesUnknownAndNonFiniteLoads) {
  char message[1000];
  const Pair pair = make(defaults());
  auto result = sized<rollfem_result>();
  rollfem_state state = state_at(0.0, 0.0);
  state.given = static_cast<rollfem_given>(5);
  EXPECT_EQ(rollfem_solve(pair.get(), &state, &result, message, sizeof message), ROLLFEM_REFUSED);
  EXPECT_TRUE(says(message, "given = 5"));
  state.given = ROLLFEM_PENETRATION;
  state.penetration = std::nan("");
  EXPECT_EQ(rollfem_solve(pair.get(), &state, &result, message, sizeof message), ROLLFEM_REFUSED);
  EXPECT_TRUE(says(message, "penetration in mm"));
}

TEST(CHeight, TGammaIsTheWorkOfTheCreepages) {
  const TemporaryFolder folder;
  const Pair pair = sphere_on_plane(folder, 0.3);
  rollfem_state state = state_at(0.0, 0.0);
  state.rotation_speed = 20e3 / sphere_radius * 1.1;  // slides all over
  state.lateral_velocity = state.yaw_rate = 0.0;
  EXPECT_NEAR(solve(pair, state).creepage_work / (0.3 * 50e3 * 0.1), 1.0, 1e-3);
  state.rotation_speed = 20e3 / sphere_radius * 1.001;
  state.lateral_velocity = 20.0;
  state.yaw_rate = 0.1;
  const rollfem_result result = solve(pair, state);
  const rollfem_patch& patch = result.patch[0];
  EXPECT_NEAR(patch.creepage_work,
              -patch.longitudinal_force * patch.longitudinal_creepage -
                  patch.lateral_force * patch.lateral_creepage - patch.spin_moment * patch.spin,
              1e-6 * patch.creepage_work);
  EXPECT_EQ(result.creepage_work, patch.creepage_work);
}

TEST(CStructures, AreTakenAsFarAsTheirSize) {
  char message[1000];
  const Pair pair = make(defaults());
  const rollfem_state state = state_at(1.0, 0.0);
  const rollfem_result whole = solve(pair, state);
  // A program whose header ended with the sums.
  rollfem_result result;
  std::memset(&result, 0x5a, sizeof result);
  result.struct_size = offsetof(rollfem_result, touching_height);
  rollfem_state shorter = state;
  shorter.struct_size = offsetof(rollfem_state, given);
  shorter.given = static_cast<rollfem_given>(77);  // beyond its end
  EXPECT_EQ(rollfem_solve(pair.get(), &shorter, &result, message, sizeof message), ROLLFEM_OK)
      << message;
  EXPECT_EQ(result.force[1], whole.force[1]);
  EXPECT_EQ(result.struct_size, offsetof(rollfem_result, touching_height));
  unsigned char beyond[sizeof result.touching_height];
  std::memcpy(beyond, &result.touching_height, sizeof beyond);
  for (const unsigned char byte : beyond) EXPECT_EQ(byte, 0x5a);
}

/// A round rail under a wheel whose hollow touches it along five tangents, and nearly along four.
Pair five_contacts(const TemporaryFolder& folder) {
  constexpr double radius = 30.0;
  std::string wheel = "# y z, mm\n", rail = wheel;
  const auto tangent = [&](double angle, double y) {
    return radius * (1.0 - std::cos(angle)) + std::tan(angle) * (y - radius * std::sin(angle));
  };
  const auto row = [](double y, double z) {
    char text[60];
    std::snprintf(text, sizeof text, "%.2f %.9f\n", y, z);
    return std::string(text);
  };
  for (double y = -27.0; y <= 24.0; y += 0.25) {
    double z = -1e9;
    for (const double angle : {-0.8, -0.4, 0.0, 0.4, 0.8}) z = std::max(z, tangent(angle, y));
    for (const double angle : {-0.6, -0.2, 0.2, 0.6})
      z = std::max(z, tangent(angle, y) - 0.3 / std::cos(angle));
    wheel += row(y, z);
  }
  for (double y = -28.0; y <= 28.0; y += 0.25)
    rail += row(y, radius - std::sqrt(radius * radius - y * y));
  rollfem_definition definition = defaults();
  const std::string wheel_file = folder.file("wheel.txt", wheel),
                    rail_file = folder.file("rail.txt", rail);
  definition.wheel_profile = wheel_file.c_str();
  definition.rail_profile = rail_file.c_str();
  definition.inclination = 0.0;
  definition.gauge = 2.0 * (750.0 - std::sqrt(2.0 * radius - 1.0));
  definition.gauge_height = 1.0;
  definition.elements_across = 8;
  return make(definition);
}

TEST(CStructures, PatchesBeyondTheListAreInTheSums) {
  const TemporaryFolder folder;
  rollfem_state state = state_at(0.0, 0.0);
  state.lateral_velocity = state.yaw_rate = 0.0;
  state.vertical_force = 10e3;
  const rollfem_result result = solve(five_contacts(folder), state);
  EXPECT_EQ(result.patch_count, ROLLFEM_MAX_PATCHES);
  EXPECT_EQ(result.patches_unlisted, 1);
  EXPECT_NEAR(result.force[2], -10e3, 1.0);
  // The one that is left out mirrors the last one.
  double listed = 0.0;
  for (const rollfem_patch& patch : result.patch) listed += patch.force[2];
  EXPECT_NEAR((listed + result.patch[3].force[2]) / result.force[2], 1.0, 0.01);
}

TEST(CStructures, WithoutTheirSizeAreRefused) {
  char message[1000];
  rollfem_definition definition{};
  rollfem_defaults(&definition, ROLLFEM_MM_N);
  EXPECT_EQ(definition.wheel_profile, nullptr);
  EXPECT_EQ(rollfem_create(&definition, message, sizeof message), nullptr);
  EXPECT_TRUE(says(message, "definition: struct_size = 0"));
  const Pair pair = make(defaults());
  rollfem_state state = state_at(1.0, 0.0);
  auto result = sized<rollfem_result>();
  state.struct_size = sizeof state + 8;
  EXPECT_EQ(rollfem_solve(pair.get(), &state, &result, message, sizeof message), ROLLFEM_REFUSED);
  EXPECT_TRUE(says(message, "state: struct_size"));
  state.struct_size = sizeof state;
  result.struct_size = sizeof result + 8;
  EXPECT_EQ(rollfem_solve(pair.get(), &state, &result, message, sizeof message), ROLLFEM_REFUSED);
  EXPECT_TRUE(says(message, "result: struct_size"));
  result.struct_size = sizeof result;
  EXPECT_EQ(rollfem_linearise(pair.get(), &state, &result, nullptr, message, sizeof message),
            ROLLFEM_REFUSED);
  EXPECT_TRUE(says(message, "derivatives is NULL"));
}

TEST(CStructures, TheVersionIsThatOfTheHeader) {
  EXPECT_EQ(rollfem_version_number(), ROLLFEM_VERSION_NUMBER);
  EXPECT_EQ(std::string(rollfem_version()), std::to_string(ROLLFEM_VERSION_MAJOR) + "." +
                                                std::to_string(ROLLFEM_VERSION_MINOR) + "." +
                                                std::to_string(ROLLFEM_VERSION_PATCH));
}

}  // namespace
