// SPDX-License-Identifier: LGPL-2.1-or-later
// Interpolation in stored hexahedra: fields that the cells hold exactly come out exactly, also in
// skew cells of different size; places outside are moved.
#include "modelling/stress/body_sampler.hpp"

#include "base/errors.hpp"

#include "support/test.hpp"

namespace rollfem::modelling {
namespace {

/// A block of nx by ny by nz cells over [-3, 3] x [-2, 2] x [-4, 0]: `bend` maps the places.
template <class Bend, class Field>
BodyField block(int nx, int ny, int nz, const Bend& bend, const Field& field) {
  BodyField body;
  body.name = "rail";
  const auto index = [=](int i, int j, int k) { return (k * (ny + 1) + j) * (nx + 1) + i; };
  for (int k = 0; k <= nz; ++k)
    for (int j = 0; j <= ny; ++j)
      for (int i = 0; i <= nx; ++i) {
        const Place place =
            bend(Place{-3.0 + 6.0 * i / nx, -2.0 + 4.0 * j / ny, -4.0 + 4.0 * k / nz});
        const auto values = field(place);
        body.points.push_back(place);
        body.displacement.push_back({values[0], values[1], values[2]});
        body.stress.push_back({values[3], values[4], values[5], values[6], values[7], values[8]});
      }
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i)
        body.cells.push_back({index(i, j, k), index(i + 1, j, k), index(i + 1, j + 1, k),
                              index(i, j + 1, k), index(i, j, k + 1), index(i + 1, j, k + 1),
                              index(i + 1, j + 1, k + 1), index(i, j + 1, k + 1)});
  return body;
}

/// A different linear function for each of the nine values.
std::array<double, 9> linear(const Place& p) {
  std::array<double, 9> values{};
  for (int c = 0; c < 9; ++c)
    values[c] = 1.0 + c + (0.5 - 0.2 * c) * p[0] + (0.3 + 0.1 * c) * p[1] - (0.7 * c - 2.0) * p[2];
  return values;
}

/// In boxes a trilinear function is one of the cells', too.
std::array<double, 9> trilinear(const Place& p) {
  std::array<double, 9> values = linear(p);
  for (int c = 0; c < 9; ++c)
    values[c] += (c - 4.0) * p[0] * p[1] + 0.3 * p[1] * p[2] - 0.2 * c * p[0] * p[1] * p[2];
  return values;
}

/// Skewed and stretched, finer towards z = 0, a curved top.
Place bent(const Place& p) {
  const double deep = -p[2] / 4.0;
  return {p[0] + 0.15 * std::sin(p[1] + p[2]), p[1] * (1.0 + 0.2 * deep) + 0.1 * p[0] * deep,
          -4.0 * std::pow(deep, 1.7) - 0.02 * p[1] * p[1]};
}

Place straight(const Place& p) {
  return p;
}

template <class Field>
double largest_error(const BodySample& sample, const Field& field, const Place& at) {
  const auto exact = field(at);
  double error = 0.0;
  for (int c = 0; c < 3; ++c) error = std::max(error, std::abs(sample.displacement[c] - exact[c]));
  for (int c = 0; c < 6; ++c) error = std::max(error, std::abs(sample.stress[c] - exact[3 + c]));
  return error;
}

TEST(BodySampler, LinearFieldsInSkewCellsAreExact) {
  const BodyField body = block(9, 7, 11, bent, linear);
  const BodySampler sampler(body);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (int k = 0; k < 500; ++k) {
    const Place at{-2.0 + 4.0 * share(random), -1.5 + 3.0 * share(random),
                   -3.8 + 3.6 * share(random)};
    const BodySample sample = sampler.at(at);
    EXPECT_LT(sample.moved, 1e-12);
    EXPECT_LT(largest_error(sample, linear, at), 1e-11) << at[0] << " " << at[1] << " " << at[2];
  }
  for (std::size_t p = 0; p < body.points.size(); p += 17)
    EXPECT_LT(largest_error(sampler.at(body.points[p]), linear, body.points[p]), 1e-11);
}

TEST(BodySampler, TrilinearFieldsInBoxesAreExact) {
  const BodyField body = block(4, 3, 5, straight, trilinear);
  const BodySampler sampler(body);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (int k = 0; k < 500; ++k) {
    const Place at{-3.0 + 6.0 * share(random), -2.0 + 4.0 * share(random), -4.0 * share(random)};
    EXPECT_LT(largest_error(sampler.at(at), trilinear, at), 1e-11);
  }
}

TEST(BodySampler, PlacesBeyondTheSurfaceAreMovedOntoIt) {
  const BodyField body = block(6, 4, 8, straight, linear);
  const BodySampler sampler(body);
  const BodySample above = sampler.at({0.3, -0.2, 0.4});
  EXPECT_NEAR(above.moved, 0.4, 1e-12);
  EXPECT_NEAR(above.place[2], 0.0, 1e-12);
  EXPECT_LT(largest_error(above, linear, {0.3, -0.2, 0.0}), 1e-11);
  const BodySample aside = sampler.at({3.2, 2.1, -1.3});
  EXPECT_NEAR(aside.place[0], 3.0, 1e-12);
  EXPECT_NEAR(aside.place[1], 2.0, 1e-12);
  EXPECT_NEAR(aside.moved, std::hypot(0.2, 0.1), 1e-12);
}

TEST(BodySampler, FindsTheSurfaceOfACurvedBody) {
  const auto field = [](const Place&) { return std::array<double, 9>{}; };
  const BodyField body = block(6, 40, 8, bent, field);
  const BodySampler sampler(body);
  for (const double y : {-1.7, 0.0, 0.85})
    EXPECT_NEAR(sampler.surface(0.1, y, -1.0, 0.5), -0.02 * y * y, 1e-4);
  EXPECT_THROW(sampler.surface(0.0, 0.0, 0.3, 0.5), contact::InputError);
  EXPECT_THROW(sampler.surface(0.0, 0.0, -1.0, -0.5), contact::InputError);
}

TEST(BodySampler, ABodyWithoutStressIsRefused) {
  BodyField body = block(1, 1, 1, straight, linear);
  body.stress.clear();
  EXPECT_THROW(const BodySampler sampler(body), contact::InputError);
}

}  // namespace
}  // namespace rollfem::modelling
