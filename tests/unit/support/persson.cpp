// SPDX-License-Identifier: LGPL-2.1-or-later
// Persson's conformal contact in closed form against the table of reference/benchmarks.md (which an
// independent Fourier solution gave) and against its limits.
#include "support/persson.hpp"

namespace {

constexpr double degree = M_PI / 180;

struct Row {
  double half_angle, clearance_number, pressure;
};

}  // namespace

TEST(Persson, GivesTheTableOfTheFourierSolution) {
  for (const Row row :
       {Row{10, 82.2206, 3.66156}, Row{20, 19.5353, 1.85239}, Row{30, 7.94354, 1.26029},
        Row{40, 3.90504, 0.97388}, Row{60, 1.06720, 0.71172}, Row{80, 0.12615, 0.61161}}) {
    const PerssonContact contact{row.half_angle * degree};
    EXPECT_NEAR(contact.clearance_number(), row.clearance_number,
                6e-6 * row.clearance_number + 5e-6);
    EXPECT_NEAR(contact.pressure(0), row.pressure, 1e-5);
  }
}

TEST(Persson, PerfectFitTouchesOver84Point8DegreesWhateverTheLoad) {
  EXPECT_NEAR(PerssonContact{84.828 * degree}.clearance_number(), 0.0, 2e-5);
}

TEST(Persson, PressureCarriesTheLoad) {
  for (const double angle : {5.0, 40.0, 80.0}) {
    const PerssonContact contact{angle * degree};
    // phi = angle sin(x): the pressure's root at the edge does no harm to the midpoint rule.
    constexpr int steps = 400;
    double sum = 0;
    for (int k = 0; k < steps; ++k) {
      const double x = (k + 0.5) / steps * M_PI / 2;
      const double phi = angle * degree * std::sin(x);
      sum += 2 * contact.pressure(phi) * std::cos(phi) * angle * degree * std::cos(x);
    }
    EXPECT_NEAR(sum * M_PI / 2 / steps, 1.0, 2e-5) << angle;
  }
}

TEST(Persson, SmallContactsAreHertzLines) {
  const PerssonContact contact{0.5 * degree};
  // a^2 = 4 Q R (R + dR) / (pi (E1*/2) dR), p0 = 2 Q / (pi a).
  EXPECT_NEAR(contact.pressure(0) * M_PI / 2 * 0.5 * degree, 1.0, 1e-4);
  EXPECT_NEAR(contact.clearance_number() * M_PI / 8 * std::pow(0.5 * degree, 2), 1.0, 1e-4);
}
