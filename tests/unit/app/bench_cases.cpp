// SPDX-License-Identifier: LGPL-2.1-or-later
// The reference limits of `rollfem bench`, recomputed.
#include "app/run/bench_cases.hpp"

#include "contact/case/case_reader.hpp"
#include "contact/result/quantities.hpp"
#include "models/registry.hpp"

#include "support/test.hpp"

namespace {

contact::ModelResult solved(const app::BenchCase& given, const std::string& model, int across) {
  const contact::ModelRegistry models = modelling::built_in_models();
  const contact::Case input = contact::parse_case(
      given.text + "[contact_grid]\nelements_across = " + std::to_string(across) + "\n", "bench",
      modelling::model_words(models));
  return models.run(model, contact::Scene(input), {});
}

}  // namespace

TEST(BenchCases, PressuresAreHertz) {
  for (const app::BenchCase& given : app::bench_cases()) {
    if (given.max_pressure == 0.0) continue;
    const auto hertz = solved(given, "hertz", 20);
    EXPECT_NEAR(hertz.points.front().max_pressure, given.max_pressure, 1e-6 * given.max_pressure)
        << given.name;
  }
}

// CONTACT's values, extrapolated, agree with the first case within 0.0005 (README.md), and with the
// circle's F_x to 0.1 % of full sliding: verification.HalfspaceRolling and .LeadingEdge.
TEST(BenchCases, LimitsAreReachedByFineGrids) {
  for (const app::BenchCase& given : app::bench_cases()) {
    const auto fine = solved(given, "halfspace", 64);
    for (const app::BenchLimit& limit : given.limits) {
      const double value =
          contact::quantity_named(limit.quantity).value(fine.points.at(limit.point)).value();
      EXPECT_NEAR(value, limit.value, 1e-3 * limit.whole) << given.name << ' ' << limit.point;
      EXPECT_LT(std::abs(limit.value), limit.whole);
    }
  }
}
