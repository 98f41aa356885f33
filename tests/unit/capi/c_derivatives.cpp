// SPDX-License-Identifier: LGPL-2.1-or-later
// Derivatives and stiffness of rollfem.h against Hertz, Kalker's printed coefficients and central
// differences of rollfem_solve.
#include "rollfem/rollfem.h"
#include "support/wheel_on_rail.hpp"

namespace {

rollfem_derivatives linearise(const Pair& pair, const rollfem_state& state) {
  char message[1000];
  auto result = sized<rollfem_result>();
  auto derivatives = sized<rollfem_derivatives>();
  EXPECT_EQ(rollfem_linearise(pair.get(), &state, &result, &derivatives, message, sizeof message),
            ROLLFEM_OK)
      << message;
  const rollfem_result alone = solve(pair, state);
  for (int d = 0; d < 3; ++d) EXPECT_EQ(result.force[d], alone.force[d]);
  return derivatives;
}

/// Rolls freely over the middle of the rail.
rollfem_state rolling() {
  rollfem_state state = state_at(0.0, 0.0);
  state.lateral_velocity = state.yaw_rate = 0.0;
  state.rotation_speed = state.forward_speed / sphere_radius;
  return state;
}

TEST(CDerivatives, StiffnessOfASphereIsThatOfHertz) {
  const TemporaryFolder folder;
  const Pair pair = sphere_on_plane(folder, 0.3);
  const double modulus = 210e3 / (2.0 * (1.0 - 0.09));
  for (const double force : {5e3, 50e3, 120e3}) {
    rollfem_state state = rolling();
    state.vertical_force = force;
    const double approach =
        std::cbrt(std::pow(0.75 * force / modulus, 2) / sphere_radius);  // N ~ approach^1.5
    EXPECT_NEAR(solve(pair, state).penetration / approach, 1.0, 0.005);
    EXPECT_NEAR(linearise(pair, state).stiffness / (1.5 * force / approach), 1.0, 0.01);
    state.given = ROLLFEM_PENETRATION;
    state.penetration = approach;
    const rollfem_derivatives by_penetration = linearise(pair, state);
    EXPECT_NEAR(solve(pair, state).force[2] / -force, 1.0, 0.01);
    EXPECT_NEAR(by_penetration.force[2][ROLLFEM_BY_LOAD] / (-1.5 * force / approach), 1.0, 0.01);
    EXPECT_EQ(by_penetration.stiffness, -by_penetration.force[2][ROLLFEM_BY_LOAD]);
  }
}

TEST(CDerivatives, WithoutCreepageAreKalkersCoefficients) {
  const TemporaryFolder folder;
  // Kalker 1990, table E3: a/b = 1, Poisson's ratio 0.25.
  constexpr double poisson_ratio = 0.25, c11 = 4.12, c22 = 3.67, c23 = 1.47, c33 = 1.19;
  const double shear = 210e3 / (2.0 * (1.0 + poisson_ratio));
  const double modulus = 210e3 / (2.0 * (1.0 - poisson_ratio * poisson_ratio));
  for (const rollfem_side side : {ROLLFEM_LEFT, ROLLFEM_RIGHT}) {
    const Pair pair = sphere_on_plane(folder, poisson_ratio, side, 20);
    const rollfem_state state = rolling();
    const rollfem_derivatives by = linearise(pair, state);
    const double c = std::cbrt(0.75 * 50e3 * sphere_radius / modulus), speed = state.forward_speed;
    const double along = shear * c * c * c11, across = shear * c * c * c22;
    EXPECT_NEAR(by.force[0][ROLLFEM_BY_ROTATION_SPEED] * speed / (along * sphere_radius), 1.0,
                0.02);
    EXPECT_NEAR(by.force[0][ROLLFEM_BY_FORWARD_SPEED] * speed / -along, 1.0, 0.02);
    EXPECT_NEAR(by.force[1][ROLLFEM_BY_LATERAL_VELOCITY] * speed / -across, 1.0, 0.02);
    // Under lateral creepage alone the wheel is turned by C23, under spin pushed aside by it.
    const rollfem_result result = solve(pair, state);
    const double arm = result.patch[0].position[1];
    const auto spin_moment = [&](int variable) {  // about z, which points down
      return by.moment[2][variable] + arm * by.force[0][variable];
    };
    const double turned = shear * c * c * c * c23;
    EXPECT_NEAR(std::abs(spin_moment(ROLLFEM_BY_LATERAL_VELOCITY)) * speed / turned, 1.0, 0.03);
    EXPECT_NEAR(std::abs(by.force[1][ROLLFEM_BY_YAW_RATE]) * speed / turned, 1.0, 0.03);
    EXPECT_NEAR(spin_moment(ROLLFEM_BY_YAW_RATE) * speed / (-shear * std::pow(c, 4) * c33), 1.0,
                0.03);
    // A wheel that stands askew slides to the other side.
    EXPECT_NEAR(by.force[1][ROLLFEM_BY_YAW] / across, 1.0, 0.02);
    EXPECT_NEAR(by.force[2][ROLLFEM_BY_LOAD], -1.0, 1e-9);
    for (int k = 0; k < ROLLFEM_BY_LOAD; ++k)
      EXPECT_NEAR(by.force[2][k], 0.0, 1e-4 * std::abs(by.force[1][k]) + 1e-3);
  }
}

struct Variable {
  double rollfem_state::*member;
  double step;
};

/// Half the steps of rollfem.h for what it differentiates by differences itself, other ones else.
std::vector<Variable> variables(const rollfem_state& state) {
  double rollfem_state::*load =
      state.given == ROLLFEM_HEIGHT ? &rollfem_state::height : &rollfem_state::vertical_force;
  return {{&rollfem_state::lateral_shift, 0.03},
          {&rollfem_state::yaw, 5e-5},
          {&rollfem_state::roll, 3e-5},
          {&rollfem_state::forward_speed, 1.0},
          {&rollfem_state::lateral_velocity, 1.0},
          {&rollfem_state::yaw_rate, 1e-3},
          {&rollfem_state::rotation_speed, 2e-3},
          {load, state.given == ROLLFEM_HEIGHT ? 2e-3 : 1e3}};
}

/// From central differences, over the largest number of the column or over mu N for a millimetre, a
/// milliradian, a tenth of a percent of creepage or the whole load, whichever is larger; moments
/// over half the gauge.
double largest_error(const Pair& pair, const rollfem_state& state, int first = 0) {
  const rollfem_derivatives by = linearise(pair, state);
  const std::vector<Variable> all = variables(state);
  const double bound = 0.3 * 50e3, half_gauge = 750.0, speed = state.forward_speed;
  const double range[] = {1.0,
                          1e-3,
                          1e-3,
                          1e-3 * speed,
                          1e-3 * speed,
                          1e-3 * speed / half_gauge,
                          1e-3 * speed / 460.0,
                          state.given == ROLLFEM_HEIGHT ? 0.05 : 50e3};
  double largest = 0.0;
  for (int k = first; k < ROLLFEM_STATE_VARIABLES; ++k) {
    const auto& [member, step] = all[static_cast<std::size_t>(k)];
    rollfem_state above = state, below = state;
    above.*member += step;
    below.*member -= step;
    const rollfem_result more = solve(pair, above), less = solve(pair, below);
    double error = 0.0, scale = bound / range[k];
    for (int d = 0; d < 3; ++d) {
      const double force = (more.force[d] - less.force[d]) / (2.0 * step),
                   moment = (more.moment[d] - less.moment[d]) / (2.0 * step);
      scale = std::max({scale, std::abs(force), std::abs(moment) / half_gauge});
      error = std::max({error, std::abs(by.force[d][k] - force),
                        std::abs(by.moment[d][k] - moment) / half_gauge});
    }
    largest = std::max(largest, error / scale);
  }
  return largest;
}

rollfem_state at_its_height(const Pair& pair, rollfem_state state) {
  const rollfem_result result = solve(pair, state);
  state.given = ROLLFEM_HEIGHT;
  state.height = result.touching_height + result.penetration;
  return state;
}

TEST(CDerivatives, AreThoseOfCentralDifferencesOnTheTread) {
  const Pair pair = make(defaults(ROLLFEM_RIGHT));
  for (const double shift : {-3.0, 1.5, 3.0}) {
    const rollfem_state state = state_at(shift, 0.0005 * shift);
    EXPECT_LT(largest_error(pair, state), 0.02) << shift;
    EXPECT_LT(largest_error(pair, at_its_height(pair, state)), 0.02) << shift;
  }
}

TEST(CDerivatives, OfFallingFrictionAndOfALayerAreThoseOfCentralDifferences) {
  rollfem_definition definition = defaults(ROLLFEM_RIGHT);
  definition.friction_law = ROLLFEM_EXPONENTIAL;
  definition.kinetic_coefficient = 0.1;
  definition.half_velocity = 100.0;
  definition.memory_distance = 0.003;
  rollfem_state state = state_at(1.5, 0.0005);
  state.rotation_speed = 20e3 / 460.0 * 1.01;  // beyond the peak
  EXPECT_LT(largest_error(make(definition), state), 0.02);
  definition = defaults(ROLLFEM_RIGHT);
  definition.friction_law = ROLLFEM_TEMPERATURE;
  definition.law_constants[1] = 120.0;
  definition.law_constants[2] = 0.1;
  EXPECT_LT(largest_error(make(definition), state), 0.02);
  definition = defaults(ROLLFEM_RIGHT);
  definition.layer_thickness = 1.0;
  definition.layer_shear_modulus = 8200.0;
  EXPECT_LT(largest_error(make(definition), state), 0.02);
}

TEST(CDerivatives, AreThoseOfCentralDifferencesAtTheFlange) {
  const Pair pair = make(defaults(ROLLFEM_RIGHT));
  rollfem_state state = state_at(6.1, 0.02);
  state.roll = -2.5e-5 * 6.1 * 6.1;
  // Where two planes share the load, it moves from one to the other within tenths of a millimetre:
  // differences by the shift say what their step is.
  EXPECT_LT(largest_error(pair, state, ROLLFEM_BY_YAW), 0.03);
}

TEST(CDerivatives, InEveryUnit) {
  const rollfem_derivatives mm = linearise(make(defaults()), state_at(2.0, 0.001));
  rollfem_state state = state_at(2.0, 0.001);
  for (double rollfem_state::*length :
       {&rollfem_state::lateral_shift, &rollfem_state::forward_speed,
        &rollfem_state::lateral_velocity})
    state.*length *= 1e-3;
  const rollfem_derivatives m = linearise(make(defaults(ROLLFEM_LEFT, ROLLFEM_M_N)), state);
  const double unit[] = {1e3, 1.0, 1.0, 1e3, 1e3, 1.0, 1.0, 1.0};
  for (int k = 0; k < ROLLFEM_STATE_VARIABLES; ++k) {
    EXPECT_NEAR(m.force[0][k], mm.force[0][k] * unit[k], 1e-6 * std::abs(m.force[0][k]));
    EXPECT_NEAR(m.moment[2][k], mm.moment[2][k] * 1e-3 * unit[k], 1e-6 * std::abs(m.moment[2][k]));
  }
  EXPECT_NEAR(m.stiffness / mm.stiffness, 1e3, 1e-3);
}

TEST(CDerivatives, ARollThatIsFoundHasNone) {
  rollfem_state state = state_at(2.0, 0.001);
  state.roll = std::nan("");
  const rollfem_derivatives by = linearise(make(defaults()), state);
  for (int d = 0; d < 3; ++d) EXPECT_EQ(by.force[d][ROLLFEM_BY_ROLL], 0.0);
  EXPECT_GT(std::abs(by.force[0][ROLLFEM_BY_LATERAL_SHIFT]), 0.0);
}

}  // namespace
