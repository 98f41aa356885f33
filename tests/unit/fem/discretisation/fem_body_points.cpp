// SPDX-License-Identifier: LGPL-2.1-or-later
// Points of finite-element bodies: found by inverse mapping, moved onto the surface, mirrored,
// refused.
#include "base/errors.hpp"
#include "case/reading/case_reader.hpp"
#include "fem/discretisation/body_points.hpp"
#include "fem/stress/stress_output.hpp"
#include "fem/stress/stress_recovery.hpp"
#include "fem/trace/far_field.hpp"

#include "support/fem_test_support.hpp"
#include "support/temporary_folder.hpp"

namespace {

constexpr contact::Material steel{210e3, 0.3};

/// A linear displacement, which the elements hold exactly: u_i = sum_j gradient_ij x_j.
fem::Vector linear(const fem::Body& body, const double (&gradient)[3][3]) {
  return fem::nodal_values(body.problem(), [&](const dealii::Point<3>& p) {
    dealii::Tensor<1, 3> u;
    for (int c = 0; c < 3; ++c)
      u[c] = gradient[c][0] * p[0] + gradient[c][1] * p[1] + gradient[c][2] * p[2];
    return u;
  });
}

constexpr double gradient[3][3] = {{1e-3, 2e-4, 3e-4}, {-1e-4, 5e-4, 2e-4}, {1e-4, -3e-4, -7e-4}};

}  // namespace

TEST(BodyPoints, FieldsAreInterpolatedAtPointsOfACurvedBody) {
  const fem::Body body(wheel_shape(60, -40), steel, small_options(), MPI_COMM_WORLD);
  std::vector<fem::Place> places;
  for (const double s : {-9.3, -1.7, 0.0, 2.2})
    for (const double t : {-7.1, 0.0, 0.4, 3.0})
      for (const double depth : {0.0, 0.3, 5.7}) {
        const auto p = body.shape().place(s, t, depth);
        places.push_back({p[0], p[1], p[2]});
      }
  const auto points = fem::BodyLocator(body).find(places, 0.1);
  const auto values = points.values(linear(body, gradient), {1, 1, 1});
  for (std::size_t k = 0; k < places.size(); ++k) {
    EXPECT_LT(points.moved(k), 5e-3) << k;  // the cells' own error of the surface
    const auto& p = points.place(k);
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(values[k][c],
                  gradient[c][0] * p[0] + gradient[c][1] * p[1] + gradient[c][2] * p[2], 1e-12);
  }
}

TEST(BodyPoints, PointsJustAboveTheSurfaceAreMovedOntoItOthersAreNotFound) {
  const fem::Body body(rail_shape(50), steel, small_options(), MPI_COMM_WORLD);
  const fem::BodyLocator locator(body);
  const double y = 3.0;
  const double drop = contact::profile_drop(50, y).value;
  const auto points =
      locator.find({{0.5, y, 0.0}, {0.5, y, 2.0}, {0.5, y, -drop - 0.4}, {99, 0, -1}}, 1.0);
  EXPECT_NEAR(points.moved(0), drop, 0.1 * drop);
  EXPECT_NEAR(points.place(0)[2], -contact::profile_drop(50, points.place(0)[1]).value, 1e-4);
  EXPECT_TRUE(std::isinf(points.moved(1)));
  EXPECT_EQ(points.moved(2), 0.0);
  EXPECT_TRUE(std::isinf(points.moved(3)));
}

TEST(BodyPoints, AHalfBodyStandsForItsMirrorImage) {
  fem::BodyOptions options = small_options();
  options.half = true;
  const fem::Body body(rail_shape(contact::infinity), steel, options, MPI_COMM_WORLD);
  const auto points =
      fem::BodyLocator(body).find({{1.0, 2.0, -1.0}, {1.0, -2.0, -1.0}, {1, 0, -1}}, 0.1);
  const auto u = points.values(linear(body, gradient), {1, -1, 1});
  EXPECT_DOUBLE_EQ(u[0][0], u[1][0]);
  EXPECT_DOUBLE_EQ(u[0][1], -u[1][1]);
  EXPECT_EQ(points.place(1)[1], -2.0);
  EXPECT_EQ(points.moved(2), 0.0);
}

TEST(BodyPoints, UniformStrainGivesHookesStressEverywhere) {
  const fem::Body body(wheel_shape(60, 30), steel, small_options(), MPI_COMM_WORLD);
  const auto stress = fem::StressRecovery(body).recover(linear(body, gradient));
  const double mu = 210e3 / 2.6, lambda = 2 * mu * 0.3 / 0.4, trace = 1e-3 + 5e-4 - 7e-4;
  const double expected[6] = {lambda * trace + 2e-3 * mu,
                              lambda * trace + 1e-3 * mu,
                              lambda * trace - 1.4e-3 * mu,
                              1e-4 * mu,
                              -1e-4 * mu,
                              4e-4 * mu};
  int nodes = 0;
  fem::StressRecovery(body).for_each_node(
      stress, [&](const fem::Place&, const std::array<double, 6>& value, double) {
        ++nodes;
        for (int c = 0; c < 6; ++c) EXPECT_NEAR(value[c], expected[c], 1e-7);
      });
  EXPECT_GT(nodes, 1000);
}

TEST(StressOutput, PlacesBelowACurvedSurfaceLieOnIt) {
  for (const auto& shape : {wheel_shape(60, -40), wheel_shape(60, 30), rail_shape(20)}) {
    const fem::Place p = fem::place_below(shape, 4.0, -3.0, 0.7);
    EXPECT_NEAR(p[0], 4.0, 1e-12);
    EXPECT_NEAR(p[1], -3.0, 1e-12);
    EXPECT_NEAR(shape.coordinates(dealii::Point<3>(p[0], p[1], p[2]))[2], 0.7, 1e-12);
  }
}

TEST(StressOutput, RefusesPointsOutsideOfTheBody) {
  const fem::Body wheel(wheel_shape(60, contact::infinity), steel, small_options(), MPI_COMM_WORLD);
  const fem::Body rail(rail_shape(20), steel, small_options(), MPI_COMM_WORLD);
  const auto message = [&](const std::string& request) {
    const contact::Case input = contact::parse_case(
        "title = \"t\"\nmodels = [\"fem\"]\n[load]\nnormal_force = 1e3\n[friction]\ncoefficient = "
        "0.3\n[wheel]\nrolling_radius = 60.0\ntransverse_radius = inf\n[rail]\ntransverse_radius = "
        "20.0\n" +
            request,
        "t.toml");
    return refusal<contact::InputError>([&] {
      fem::StressOutput(input, {&wheel, &rail}, contact::ContactGrid::centred(4, 4, 1.0, 1.0), 0.5,
                        false);
    });
  };
  EXPECT_EQ(message("[[subsurface.point]]\nat = [1, 0, 1]\n"), "");
  const std::string above = message(
      "[[subsurface.point]]\nat = [1, 0, 1]\n[[subsurface.line]]\nbody = \"rail\"\nfrom = "
      "[0, 0, -0.1]\nto = [0, 8, -0.1]\npoints = 5\n");
  EXPECT_TRUE(says(above, "t.toml", "[[subsurface.line]] (request 2", "(0, 6, -0.1) mm", "rail",
                   "above its surface", "subsurface.surface"));
  const std::string beyond = message("[[subsurface.point]]\nat = [40, 0, 1]\n");
  EXPECT_TRUE(says(beyond, "extends 16 mm", "[fem] extent"));
}
