// Point and line loads on the half-space: Hooke's law and equilibrium by differences of the
// displacement, balance with the load, surface values.
#include "halfspace/closed_forms/point_loads.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

namespace rollfem::halfspace {
namespace {

const double pi = std::acos(-1.0);
const ElasticHalfspace steel{80769.0, 0.3};
constexpr double load = 1000.0;

struct Field {
  const char* name;
  std::function<Displacement(const Position&)> displacement;
  std::function<Stress(const Position&)> stress;
};

std::vector<Field> fields(const ElasticHalfspace& body) {
  const LineLoad line{700.0, -300.0};
  return {{"Boussinesq", [=](const Position& p) { return boussinesq_displacement(body, load, p); },
           [=](const Position& p) { return boussinesq_stress(body, load, p); }},
          {"Cerruti", [=](const Position& p) { return cerruti_displacement(body, load, p); },
           [=](const Position& p) { return cerruti_stress(body, load, p); }},
          {"line", [=](const Position& p) { return line_load_displacement(body, line, p.x, p.z); },
           [=](const Position& p) { return line_load_stress(body, line, p.x, p.z); }}};
}

using Matrix = std::array<std::array<double, 3>, 3>;

Matrix matrix(const Stress& s) {
  return {{{s.xx, s.xy, s.xz}, {s.xy, s.yy, s.yz}, {s.xz, s.yz, s.zz}}};
}

Position moved(Position at, int direction, double step) {
  (direction == 0 ? at.x : direction == 1 ? at.y : at.z) += step;
  return at;
}

/// Hooke's law on central differences.
Matrix stress_by_differences(const Field& field, const ElasticHalfspace& body, const Position& at) {
  const double step = 1e-4;
  Matrix gradient;
  for (int j = 0; j < 3; ++j) {
    const Displacement ahead = field.displacement(moved(at, j, step));
    const Displacement behind = field.displacement(moved(at, j, -step));
    for (int i = 0; i < 3; ++i) gradient[i][j] = (ahead[i] - behind[i]) / (2.0 * step);
  }
  const double dilatation = gradient[0][0] + gradient[1][1] + gradient[2][2];
  Matrix stress;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      stress[i][j] = body.shear_modulus * (gradient[i][j] + gradient[j][i]) +
                     (i == j ? 2.0 * body.shear_modulus * body.poisson_ratio /
                                   (1.0 - 2.0 * body.poisson_ratio) * dilatation
                             : 0.0);
  return stress;
}

const std::vector<Position> places{
    {1.0, 0.5, 0.7}, {-2.0, 0.3, 1.5}, {0.01, -0.02, 2.0}, {0.8, -1.1, 0.02}};

TEST(PointLoads, StressIsHookesLawOfTheDisplacement) {
  for (const ElasticHalfspace& body : {steel, ElasticHalfspace{500.0, 0.0}})
    for (const Field& field : fields(body))
      for (const Position& at : places) {
        const Matrix closed = matrix(field.stress(at));
        const Matrix differences = stress_by_differences(field, body, at);
        const double r2 = at.x * at.x + at.y * at.y + at.z * at.z;
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j)
            EXPECT_NEAR(closed[i][j], differences[i][j], 1e-6 * load / r2)
                << field.name << " " << i << j << " at " << at.x << " " << at.y << " " << at.z;
      }
}

TEST(PointLoads, StressIsInEquilibrium) {
  const double step = 1e-4;
  for (const Field& field : fields(steel))
    for (const Position& at : places)
      for (int i = 0; i < 3; ++i) {
        double divergence = 0.0;
        double largest = 0.0;
        for (int j = 0; j < 3; ++j) {
          const double slope = (matrix(field.stress(moved(at, j, step)))[i][j] -
                                matrix(field.stress(moved(at, j, -step)))[i][j]) /
                               (2.0 * step);
          divergence += slope;
          largest = std::max(largest, std::abs(slope));
        }
        EXPECT_NEAR(divergence, 0.0, 2e-4 * largest + 1e-6) << field.name << " component " << i;
      }
}

TEST(PointLoads, TractionsOnAHemisphereBalanceTheLoad) {
  using boost::math::quadrature::gauss_kronrod;
  const auto resultant = [](const Field& field, int component, double radius) {
    const auto ring = [&](double polar) {
      double sum = 0.0;
      const int n = 64;
      for (int k = 0; k < n; ++k) {
        const double angle = 2.0 * pi * k / n;
        const std::array<double, 3> normal{std::sin(polar) * std::cos(angle),
                                           std::sin(polar) * std::sin(angle), std::cos(polar)};
        const Matrix s =
            matrix(field.stress({radius * normal[0], radius * normal[1], radius * normal[2]}));
        for (int j = 0; j < 3; ++j) sum += s[component][j] * normal[j] * 2.0 * pi / n;
      }
      return sum * radius * radius * std::sin(polar);
    };
    return gauss_kronrod<double, 31>::integrate(ring, 0.0, 0.5 * pi, 5, 1e-10);
  };
  const std::vector<Field> all = fields(steel);
  const double expected[2][3] = {{0.0, 0.0, -load}, {-load, 0.0, 0.0}};
  for (int which = 0; which < 2; ++which)
    for (int component = 0; component < 3; ++component)
      EXPECT_NEAR(resultant(all[which], component, 2.5), expected[which][component], 1e-7 * load)
          << all[which].name << " component " << component;
}

TEST(PointLoads, SurfaceIsFreeAndHasTheKnownDisplacement) {
  const double nu = steel.poisson_ratio;
  const Position at{3.0, -4.0, 0.0};
  const double r = 5.0;
  const double unit = load / (2.0 * pi * steel.shear_modulus * r);
  const Displacement normal = boussinesq_displacement(steel, load, at);
  EXPECT_NEAR(normal[2] / unit, 1.0 - nu, 1e-13);
  EXPECT_NEAR(normal[0] / unit, -(1.0 - 2.0 * nu) / 2.0 * at.x / r, 1e-13);
  const Displacement along = cerruti_displacement(steel, load, at);
  EXPECT_NEAR(along[0] / unit, 1.0 - nu + nu * at.x * at.x / (r * r), 1e-13);
  EXPECT_NEAR(along[1] / unit, nu * at.x * at.y / (r * r), 1e-13);
  EXPECT_NEAR(along[2] / unit, (1.0 - 2.0 * nu) * at.x / (2.0 * r), 1e-13);
  for (const Stress& s : {boussinesq_stress(steel, load, at), cerruti_stress(steel, load, at)}) {
    EXPECT_EQ(s.zz, 0.0);
    EXPECT_EQ(s.xz, 0.0);
    EXPECT_EQ(s.yz, 0.0);
  }
}

TEST(PointLoads, NormalDisplacementUnderAShearLoadIsReciprocal) {
  // Betti: u_x of a normal load at one point is u_z of a tangential load, seen the other way round.
  const Position there{1.2, 0.7, 0.0};
  const Position back{-1.2, -0.7, 0.0};
  EXPECT_NEAR(boussinesq_displacement(steel, load, there)[0],
              cerruti_displacement(steel, load, back)[2], 1e-15);
}

TEST(LineLoad, IsTheSumOfPointLoads) {
  using boost::math::quadrature::gauss_kronrod;
  const double x = 0.7;
  const double z = 0.4;
  const auto summed = [&](auto&& component) {
    return gauss_kronrod<double, 61>::integrate(component, -INFINITY, INFINITY, 10, 1e-10);
  };
  const Stress line = line_load_stress(steel, {load, 0.0}, x, z);
  const Stress tangential = line_load_stress(steel, {0.0, load}, x, z);
  const auto normal_at = [&](double y) { return boussinesq_stress(steel, load, {x, y, z}); };
  const auto along_at = [&](double y) { return cerruti_stress(steel, load, {x, y, z}); };
  EXPECT_NEAR(summed([&](double y) { return normal_at(y).xx; }), line.xx, 1e-6 * load);
  EXPECT_NEAR(summed([&](double y) { return normal_at(y).yy; }), line.yy, 1e-6 * load);
  EXPECT_NEAR(summed([&](double y) { return normal_at(y).xz; }), line.xz, 1e-6 * load);
  EXPECT_NEAR(summed([&](double y) { return along_at(y).xx; }), tangential.xx, 1e-6 * load);
  EXPECT_NEAR(summed([&](double y) { return along_at(y).zz; }), tangential.zz, 1e-6 * load);
}

TEST(Love, GivesCentreAndCornerOfASquare) {
  // u_z E / ((1 - nu^2) p L) = (4/pi) ln(1 + sqrt 2) in the middle, half of it at a corner.
  const double side = 3.0;
  const double unit = (1.0 - steel.poisson_ratio) * 100.0 * side / (2.0 * steel.shear_modulus);
  EXPECT_NEAR(love_displacement(steel, 100.0, side, side, 0.0, 0.0) / unit, 1.122200, 5e-7);
  EXPECT_NEAR(love_displacement(steel, 100.0, side, side, 1.5, 1.5) / unit, 0.561100, 5e-7);
}

TEST(Love, TendsToThePointLoad) {
  const double point = boussinesq_displacement(steel, 100.0 * 2.0 * 3.0, {60.0, 80.0, 0.0})[2];
  EXPECT_NEAR(love_displacement(steel, 100.0, 2.0, 3.0, 60.0, 80.0) / point, 1.0, 1e-4);
}

}  // namespace
}  // namespace rollfem::halfspace
