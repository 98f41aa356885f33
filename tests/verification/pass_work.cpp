// SPDX-License-Identifier: LGPL-2.1-or-later
// Frictional work over the profile: a Hertzian patch in full sliding and Carter's line contact in
// closed form, the balance with the creep forces, every model that gives it, and both wheels.
#include "base/pi.hpp"
#include "case/reading/case_reader.hpp"
#include "halfspace/closed_forms/hertz.hpp"
#include "halfspace/closed_forms/kalker.hpp"
#include "halfspace/model/halfspace_model.hpp"
#include "result/derived.hpp"
#include "theories/carter.hpp"

#include "support/half_space_models.hpp"
#include "support/recorded.hpp"
#include "support/thesis_cases.hpp"

namespace {

using contact::Field;

ModelResult run(const contact::Scene& scene, const char* model = "halfspace") {
  return rollfem::testing::half_space_models().run(model, scene, {});
}

/// Integral of the work over the rows against the frictional work, to rounding.
void expect_its_integral(const ModelResult& model) {
  for (const PointResult& point : model.points) {
    const Field work = contact::pass_work(model.grid, point);
    ASSERT_EQ(work.size(), model.rows.width.size());
    EXPECT_NEAR(work.dot(model.rows.width) / point.frictional_work.value(), 1.0, 1e-12);
    EXPECT_EQ(work.maxCoeff(), point.max_pass_work.value());
  }
}

/// w(y) = mu p_0 a pi/2 xi (1 - y^2/b^2): elastic slip does no work in a symmetric strip. FASTSIM's
/// parabolic bound gives 16/9 and the power 3/2.
TEST(PassWork, OfAHertzianPatchInFullSlidingIsItsClosedForm) {
  constexpr double creepage = 0.05;
  Case input = thesis_case('b', 40, {{creepage, 0.0, 0.0}});
  const auto hertz = halfspace::hertz_of_scene(contact::Scene(input));
  struct Bound {
    const char* model;
    double factor, power, within;
  };
  for (const Bound& of : {Bound{"halfspace", 0.5 * contact::pi, 1.0, 2e-3},
                          Bound{"fastsim", 16.0 / 9.0, 1.5, 5e-3}}) {
    SCOPED_TRACE(of.model);
    const double largest = of.factor * 0.55 * hertz.max_pressure * hertz.semi_axis_x;
    const ModelResult model = run(input, of.model);
    expect_its_integral(model);
    const Field work = contact::pass_work(model.grid, model.points[0]);
    for (int j = 0; j < model.grid.ny; ++j) {
      const double t = model.grid.y(j) / hertz.semi_axis_y;
      // The last rows have few elements.
      const double within = std::abs(t) > 0.95 ? 6e-3 : of.within;
      EXPECT_NEAR(work[j] / (largest * creepage), std::pow(std::max(0.0, 1.0 - t * t), of.power),
                  within)
          << t;
    }
  }
}

/// Steel rollers of R = 500 mm: the work per width is what the creep force does, also where the
/// zone of slip is a fiftieth of an element.
TEST(PassWork, OfCartersLineContactIsForceTimesCreepage) {
  for (const char* name : {"halfspace", "carter"})
    for (const int across : {16, 64})
      for (const double part : {0.002, 0.02, 0.1, 0.3, 0.6, 0.9, 1.5}) {
        SCOPED_TRACE(fmt::format("{} {} {}", name, across, part));
        const double creepage = part * 0.3 / 500.0;
        const std::string text = fmt::format(
            "[load]\nnormal_force = 178.89625\n[friction]\ncoefficient = "
            "0.3\n[wheel]\nrolling_radius "
            "= 500.0\nyoung_modulus = 209920.0\npoisson_ratio = 0.28\n[rail]\nyoung_modulus = "
            "209920.0\npoisson_ratio = 0.28\n[geometry]\nshape = \"line\"\n[contact_grid]\n"
            "elements_across = {}\n[rolling]\nlongitudinal_creepage = {}\n",
            across, creepage);
        const ModelResult model = run(contact::Scene(contact::parse_case(text, "line.toml")), name);
        const double stick = std::max(0.0, 1.0 - part);
        const double work = 0.3 * 178.89625 * (1.0 - stick * stick) * creepage;
        const Field rows = contact::pass_work(model.grid, model.points[0]);
        EXPECT_NEAR(rows[0] * model.rows.width[0] / work, 1.0, 0.5 / across);
        const auto& bars = model.points[0].error_estimate;
        if (const auto bar = bars.find("frictional_work"); bar != bars.end()) {
          EXPECT_NEAR(*model.points[0].frictional_work, work, bar->second);
        }
        EXPECT_FALSE(model.points[0].revolution_work.has_value());
      }
}

/// Where hardly an element slips it is that of Kalker's linear theory, and its place that of fine
/// grids.
TEST(PassWork, OfSmallCreepageIsThatOfTheLinearTheory) {
  Case input = thesis_case('b', 20, {{1e-5, 0.0, 0.0}, {1e-4, 0.0, 0.0}, {5e-4, 0.0, 0.0}});
  const contact::Scene scene(input);
  const auto hertz = halfspace::hertz_of_scene(scene);
  const double linear = -halfspace::linear_creep_forces(
                             hertz.semi_axis_x, hertz.semi_axis_y, scene.material.shear_modulus,
                             scene.material.poisson_ratio, {1e-5, 0.0, 0.0})
                             .longitudinal *
                        1e-5;
  input.contact_grid.elements_across = 96;
  const ModelResult fine = run(input);
  const ContactGrid& narrow = fine.grid;
  for (const int across : {12, 20, 40}) {
    SCOPED_TRACE(across);
    input.contact_grid.elements_across = across;
    const ModelResult model = run(input);
    expect_its_integral(model);
    EXPECT_NEAR(*model.points[0].frictional_work / linear, 1.0, 0.5 / across);
    for (std::size_t k = 0; k < 3; ++k) {
      const PointResult& point = model.points[k];
      EXPECT_NEAR(*point.frictional_work, *fine.points[k].frictional_work,
                  point.error_estimate.at("frictional_work"));
      EXPECT_NEAR(*point.frictional_work, *point.creepage_work, 1e-9 * *point.creepage_work);
      const Field rows = contact::pass_work(model.grid, point),
                  right = contact::pass_work(narrow, fine.points[k]);
      EXPECT_GE(point.fields.work.minCoeff(), 0.0);
      for (int j = 0; j < model.grid.ny; ++j) {
        double sum = 0.0;
        for (int i = 0; i < narrow.ny; ++i) {
          const double within =
              0.5 * (model.grid.dy + narrow.dy) - std::abs(narrow.y(i) - model.grid.y(j));
          sum += std::clamp(within, 0.0, narrow.dy) * right[i];
        }
        EXPECT_NEAR(rows[j], sum / model.grid.dy, point.error_estimate.at("max_pass_work")) << j;
      }
    }
  }
}

/// The pressure of unlike materials, shifted ahead by friction, closes the distance x^2/2 (1/R_1 +
/// 1/R_2) behind it: rolling resistance.
TEST(PassWork, OfUnlikeMaterialsIsThatOfCreepForcesAndRollingResistance) {
  Case input = thesis_case('b', 40, {{1e-3, -5e-4, 2e-4}});
  input.wheel.material.young_modulus = 1.5e5;
  const ModelResult model = run(input);
  const PointResult& point = model.points[0];
  const contact::Creepage& creepage = point.creepage;
  const double power =
      -(creepage.longitudinal * point.longitudinal_force + creepage.lateral * point.lateral_force +
        creepage.spin * point.spin_moment);
  const Field x = model.grid.sample([](double at, double) { return at; });
  const double resistance =
      model.grid.element_area() * x.dot(point.fields.traction.n) / input.wheel.rolling_radius;
  EXPECT_GT(std::abs(resistance), 0.05 * power);
  EXPECT_NEAR(*point.creepage_work, power + resistance, 0.02 * std::abs(resistance));
  EXPECT_NEAR(*point.frictional_work, *point.creepage_work, 1e-6 * power);
}

TEST(PassWork, IsThePowerOfTheCreepForcesEverywhereAndConverges) {
  Case input = thesis_case('b', 20, {{0.002, 0.001, 1e-4}});
  std::vector<double> largest;
  for (const int across : {20, 40, 80}) {
    input.contact_grid.elements_across = across;
    const ModelResult model = run(input);
    expect_its_integral(model);
    const PointResult& point = model.points[0];
    const double work =
        contact::pass_work(model.grid, point).dot(model.rows.width) / point.creepage_work.value();
    EXPECT_NEAR(work, 1.0, 1e-9) << across;
    largest.push_back(*point.max_pass_work);
    if (across == 40) {
      record("max_pass_work", *point.max_pass_work);
    }
  }
  EXPECT_NEAR(largest[0] / largest[2], 1.0, 0.01);
  EXPECT_NEAR(largest[1] / largest[2], 1.0, 0.005);
  // The bars of the coarse grids hold against the finest.
  for (std::size_t k = 0; k < 2; ++k) {
    input.contact_grid.elements_across = k == 0 ? 20 : 40;
    const PointResult point = run(input).points[0];
    EXPECT_NEAR(largest[k], largest[2], point.error_estimate.at("max_pass_work"));
    EXPECT_NEAR(point.error_estimate.at("revolution_work") / *point.revolution_work,
                point.error_estimate.at("frictional_work") / *point.frictional_work, 1e-12);
  }
}

TEST(PassWork, IsGivenByEveryModelWithSlipAndByNoOther) {
  const Case input = thesis_case('a', 20, {{0.002, 0.0, 0.0}});
  const double halfspace = *run(input).points[0].frictional_work;
  for (const char* name : {"carter", "fastsim", "fastrip", "strip"}) {
    const ModelResult model = run(input, name);
    expect_its_integral(model);
    EXPECT_NEAR(*model.points[0].frictional_work / halfspace, 1.0, 0.15) << name;
  }
  // Brushes of one flexibility and strips of half-planes obey the identity, three only without
  // spin.
  Case spinning = thesis_case('a', 12, {{2e-5, 0.0, 0.0}, {1e-3, 5e-4, 3e-4}});
  for (const char* name : {"fastsim", "fastrip", "strip"})
    for (const bool one : {false, true}) {
      SCOPED_TRACE(fmt::format("{} {}", name, one));
      if (one) spinning.fastsim.flexibilities = contact::Flexibilities::one;
      const ModelResult model = run(spinning, name);
      expect_its_integral(model);
      for (const PointResult& point : model.points) {
        const contact::Creepage& c = point.creepage;
        const double power = -(c.longitudinal * point.longitudinal_force +
                               c.lateral * point.lateral_force + c.spin * point.spin_moment);
        EXPECT_NEAR(*point.creepage_work, power, 1e-9 * power);
        const bool obeys = c.spin == 0.0 || name == std::string("fastrip") ||
                           (one && name == std::string("fastsim"));
        EXPECT_NEAR(*point.frictional_work, power, (obeys ? 1e-9 : 0.3) * power);
        EXPECT_GE(point.fields.work.minCoeff(), 0.0);
      }
    }
  for (const char* name : {"hertz", "linear", "vermeulen-johnson", "polach"})
    EXPECT_FALSE(run(input, name).points[0].max_pass_work.has_value()) << name;
}

}  // namespace
