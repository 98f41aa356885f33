// SPDX-License-Identifier: LGPL-2.1-or-later
// First-order differences on CONTACT's elements give the numbers that CONTACT prints, digit by
// digit. Printed: the results shipped with the examples of CONTACT (E. A. H. Vollebregt, user
// guide, chapter on examples; open version r2707): FASTSIM (given there beside the full solution),
// traction curves, from Cattaneo to Carter; and its solution of benchmark 9, run for this project.
#include "halfspace/closed_forms/hertz.hpp"
#include "halfspace/model/halfspace_model.hpp"
#include "theories/fastsim.hpp"

#include "support/test.hpp"

namespace {

constexpr double steel_modulus = 82000.0, steel_ratio = 0.28;

/// CONTACT prints four digits.
void expect_printed(double ours, double printed, const char* what) {
  const double unit = std::pow(10.0, std::floor(std::log10(std::abs(printed))) - 3.0);
  EXPECT_NEAR(ours, printed, 0.501 * unit) << what;
}

halfspace::HertzContact hertz(double a, double b, double force) {
  return {a, b, 1.5 * force / (M_PI * a * b), 0.0, force};
}

contact::Curvatures curvatures(double a, double b, double force) {
  return halfspace::hertz_curvatures(hertz(a, b, force), steel_modulus / (1.0 - steel_ratio));
}

/// Elements nx by ny on a potential contact of `scale` times the ellipse, as CONTACT lays them.
Case rolling_ellipse(double a, double b, double force, const std::array<int, 2>& elements,
                     double scale) {
  Case input;
  input.file = "test.toml";
  input.load.normal_force = force;
  input.wheel.material =
      input.rail.material = {2.0 * steel_modulus * (1.0 + steel_ratio), steel_ratio};
  const contact::Curvatures c = curvatures(a, b, force);
  input.undeformed_distance.quadratic = {c.A, c.B};
  input.contact_grid.extent = {2.0 * scale * a, 2.0 * scale * b};
  input.contact_grid.cell_size = {2.0 * scale * a / elements[0], 2.0 * scale * b / elements[1]};
  input.rolling.upwind_order = UpwindOrder::first;
  return input;
}

int adhering(const PointResult& point) {
  const auto& state = point.fields.state;
  return static_cast<int>(std::count(state.begin(), state.end(), ElementState::adhesion));
}

TEST(DigitsOfContact, CombinedCreepageAndSpinOnAnEllipse) {
  Case input = rolling_ellipse(8.0, 4.0, 82e3, {44, 44}, 1.1);
  input.friction_coefficient = 0.3;
  input.rolling.creepages = {{0.0, -6.25e-4, 6.25e-4}};
  const ModelResult result = halfspace::run_halfspace(input, {});
  const PointResult& point = result.points[0];
  expect_printed(point.lateral_force, -1.494e4, "F_y");
  expect_printed(point.lateral_force / 24600.0, -0.6074, "F_y over mu F_z");
  expect_printed(point.spin_moment, -4.821e4, "M_z");
  expect_printed(point.max_pressure, 1223.0, "p0");
  expect_printed(point.approach, 9.266e-2, "approach");
  EXPECT_EQ(result.contact_elements, 1276);
  EXPECT_EQ(adhering(point), 356);
}

TEST(DigitsOfContact, Benchmark9) {
  struct Row {
    int across, contact, adhesion;
    double fx, fy, mz;
  };
  for (const Row& row : {Row{20, 316, 220, 10510.0, -7275.0, -1896.0},
                         {40, 1272, 878, 10400.0, -7201.0, -1592.0},
                         {80, 5048, 3521, 10320.0, -7126.0, -1364.0}}) {
    SCOPED_TRACE(row.across);
    const int elements = row.across + 6;
    Case input = rolling_ellipse(6.0, 6.0, 82e3, {elements, elements}, 1.0 + 6.0 / row.across);
    input.friction_coefficient = 0.3;
    input.rolling.creepages = {{-1e-3, 5e-4, 1e-4}};
    const ModelResult result = halfspace::run_halfspace(input, {});
    const PointResult& point = result.points[0];
    EXPECT_NEAR(point.longitudinal_force, row.fx, 5.0);
    expect_printed(point.lateral_force, row.fy, "F_y");
    expect_printed(point.spin_moment, row.mz, "M_z");
    EXPECT_EQ(result.contact_elements, row.contact);
    EXPECT_EQ(adhering(point), row.adhesion);
  }
}

TEST(DigitsOfContact, TractionCurve) {
  struct Row {
    double creepage, force;  // F_x over mu F_z
    int adhesion;
  };
  const std::array<Row, 11> rows{{{1e-5, -7.015e-3, 1382},
                                  {4e-4, -0.2588, 1182},
                                  {8e-4, -0.4742, 976},
                                  {1.2e-3, -0.6482, 782},
                                  {1.6e-3, -0.7831, 596},
                                  {2e-3, -0.8816, 422},
                                  {2.4e-3, -0.9467, 262},
                                  {2.8e-3, -0.9832, 132},
                                  {3.2e-3, -0.9976, 32},
                                  {3.6e-3, -0.9991, 0},
                                  {8e-3, -0.9998, 0}}};
  // A is given, 8e-4 per mm, and a/b = 1/2; the load then says how large the ellipse is.
  const double force = 106.7e3;
  const double a = std::cbrt(curvatures(1.0, 2.0, force).A / 8e-4);
  Case input = rolling_ellipse(a, 2.0 * a, force, {48, 44}, 1.1);
  input.friction_coefficient = 0.33;
  input.rolling.creepages.clear();
  for (const Row& row : rows) input.rolling.creepages.push_back({row.creepage, 0.0, 0.0});
  const ModelResult result = halfspace::run_halfspace(input, {});
  for (std::size_t k = 0; k < rows.size(); ++k) {
    SCOPED_TRACE(rows[k].creepage);
    const PointResult& point = result.points[k];
    expect_printed(point.longitudinal_force / (0.33 * force), rows[k].force, "F_x over mu F_z");
    expect_printed(point.max_pressure, 640.7, "p0");
    EXPECT_EQ(adhering(point), rows[k].adhesion);
  }
}

TEST(DigitsOfContact, FromCattaneoToCarter) {
  // A first step from rest under a given force is the shift by that force, and what CONTACT calls
  // case 1; its cases 2 to 57 roll on by an element each.
  Case input;
  input.file = "test.toml";
  input.load.normal_force = 0.4705;
  input.friction_coefficient = 0.4013;
  input.wheel.material = input.rail.material = {2.56, 0.28};
  input.undeformed_distance.quadratic = {0.002963, 0.002963};
  input.contact_grid.cell_size = {0.25, 0.25};
  input.contact_grid.extent = {8.5, 8.25};
  input.contact_grid.middle = {0.125, 0.0};
  input.rolling.upwind_order = UpwindOrder::first;
  roll_on(input, 57, 0.25);
  input.rolling.forces.assign(57, {-0.657 * 0.4013 * 0.4705, {}});
  const ModelResult result = halfspace::run_halfspace(input, {});
  const PointResult& shifted = result.points[0];
  expect_printed(0.25 * shifted.creepage.longitudinal, 1.774e-2, "shift");
  expect_printed(result.points[1].creepage.longitudinal, 1.824e-3, "creepage of the first step");
  expect_printed(result.points[56].creepage.longitudinal, 3.101e-3, "creepage at the end");
  expect_printed(shifted.approach, 7.258e-2, "approach");
  expect_printed(shifted.max_pressure, 1.834e-2, "p0");
  EXPECT_EQ(result.contact_elements, 621);
  EXPECT_EQ(adhering(shifted), 305);
  EXPECT_EQ(adhering(result.points[1]), 422);
  EXPECT_EQ(adhering(result.points[56]), 346);
}

TEST(DigitsOfContact, StepsOfOneElementWithSpinEndInSteadyRolling) {
  Case input = rolling_ellipse(8.0, 4.0, 82e3, {22, 22}, 1.1);
  input.friction_coefficient = 0.3;
  input.rolling.creepages = {{0.0, -6.25e-4, 6.25e-4}};
  const PointResult steady = halfspace::run_halfspace(input, {}).points[0];
  roll_on(input, 120, (*input.contact_grid.cell_size)[0], {0.0, -6.25e-4, 6.25e-4});
  const PointResult last = halfspace::run_halfspace(input, {}).points.back();
  EXPECT_NEAR(last.lateral_force, steady.lateral_force, 5e-5 * 24600.0);
  EXPECT_NEAR(last.spin_moment, steady.spin_moment, 1e-4 * std::abs(steady.spin_moment));
}

struct FastsimRow {
  int across;
  contact::BoundShape bound;
  double fy, mz;
  double adhesion;
};

/// With the flexibilities that CONTACT prints: it blends Kalker's three into one as creepages grow.
TEST(DigitsOfContact, FastsimOnItsElements) {
  using contact::BoundShape;
  const theories::BrushFlexibilities printed{0.4937e-4, 0.5152e-4, 0.4090e-4};
  const double a = 8.0, b = 4.0, force = 82e3;
  const halfspace::HertzContact ellipse = hertz(a, b, force);
  for (const FastsimRow& row : {FastsimRow{40, BoundShape::parabolic, -1.505e4, -3.900e4, 738},
                                {40, BoundShape::elliptic, -1.480e4, -4.829e4, 618}}) {
    SCOPED_TRACE(row.fy);
    const double largest =
        0.3 * ellipse.max_pressure * (row.bound == BoundShape::parabolic ? 4.0 / 3.0 : 1.0);
    const double width = 2.0 * b / row.across;
    theories::BrushTotals totals;
    for (int j = 0; j < row.across; ++j) {
      const auto strip =
          theories::ellipse_strip(ellipse, -b + (j + 0.5) * width, largest, row.bound);
      add_strip(strip,
                solve_strip(strip, printed, {0.0, -6.25e-4, 6.25e-4},
                            theories::grid_elements(strip, a, row.across)),
                width, totals);
    }
    expect_printed(totals.forces.lateral, row.fy, "F_y");
    expect_printed(totals.forces.spin_moment, row.mz, "M_z");
    EXPECT_EQ(std::lround(totals.adhesion_area / (width * 2.0 * a / row.across)), row.adhesion);
  }
}

}  // namespace
