// SPDX-License-Identifier: LGPL-2.1-or-later
// Orders, limits and uncertainties against sequences with known limit and order, and their use in a
// study.
#include "postprocess/study/study.hpp"

#include <nlohmann/json.hpp>

#include "support/csv_rows.hpp"
#include "support/temporary_folder.hpp"

namespace {

using namespace rollfem::postprocess;

/// limit + 0.1 ratio^(-order k)
std::vector<double> sequence(double order, int levels, double ratio = 2.0, double limit = 3.0) {
  std::vector<double> values;
  for (int k = 0; k < levels; ++k) values.push_back(limit + 0.1 * std::pow(ratio, -order * k));
  return values;
}

TEST(Limit, IsExactForAPureOrder) {
  for (const double ratio : {1.5, 2.0, 4.0})
    for (const double order : {0.7, 1.0, 2.0, 3.0}) {
      const Limit limit = limit_of(sequence(order, 4, ratio), ratio);
      ASSERT_TRUE(limit.order) << order << ' ' << limit.reason;
      EXPECT_NEAR(*limit.order, order, 1e-9);
      EXPECT_NEAR(limit.value, 3.0, 1e-12);
      EXPECT_EQ(limit.reason, "");
    }
}

TEST(Limit, GridUncertaintyIsRoachesIndex) {
  // Order 2, ratio 2: 1.25 |f3 - f2| / 3, which is 1.25 times the true error.
  const auto values = sequence(2.0, 3);
  const Limit limit = limit_of(values, 2.0);
  EXPECT_NEAR(limit.grid_uncertainty, 1.25 * (values[2] - 3.0), 1e-12);
  EXPECT_DOUBLE_EQ(limit.uncertainty, limit.grid_uncertainty);
}

TEST(Limit, AQuickOrderIsNotBelievedInTheUncertainty) {
  // Order 3 is chance: half of the change before, which is 0.1 (1/8 - 1/64), over 1, times 1.25.
  const Limit limit = limit_of(sequence(3.0, 4), 2.0);
  EXPECT_NEAR(limit.grid_uncertainty, 1.25 * 0.5 * 0.1 * (1.0 / 8.0 - 1.0 / 64.0), 1e-12);
  EXPECT_DOUBLE_EQ(limit.uncertainty, limit.grid_uncertainty);
}

/// Sequences that fall fast and then stay on the other side of their limit: semi-axes of Hertz's
/// ellipses by the half-space with 20, 40, ... elements across, relative to the exact ones.
TEST(Limit, BarsHoldWhereFastConvergenceIsChance) {
  const std::vector<double> off[] = {{1.99e-4, 2.42e-6, -1.90e-5, -1.59e-5},
                                     {3.01e-4, 2.26e-5, -1.40e-5, -1.51e-5},
                                     {3.22e-4, 2.75e-5, -1.26e-5, -1.48e-5},
                                     {7.14e-5, -1.66e-5, -2.27e-5, -1.62e-5},
                                     {2.72e-4, 1.62e-5, -1.57e-5, -1.54e-5}};
  for (const auto& errors : off)
    for (const std::size_t levels : {3U, 4U}) {
      std::vector<double> values;
      for (std::size_t k = 0; k < levels; ++k) values.push_back(5.001008 * (1.0 + errors[k]));
      const Limit limit = limit_of(values, 2.0);
      EXPECT_LE(std::abs(limit.value - 5.001008), limit.uncertainty) << errors[0] << ' ' << levels;
      EXPECT_LE(std::abs(values.back() - 5.001008), limit.grid_uncertainty) << errors[0];
      EXPECT_LE(limit.uncertainty, 1e-3) << errors[0];
    }
}

/// f + a h^p + b h^q with signs and sizes of every kind.
TEST(Limit, BarsHoldForSumsOfTwoOrders) {
  int covered = 0, all = 0;
  for (const double order : {1.0, 1.5, 2.0})
    for (const double more : {0.5, 1.0, 2.0})
      for (const double second : {-3.0, -1.0, -0.3, -0.1, 0.1, 0.3, 1.0, 3.0})
        for (const int levels : {3, 4, 5}) {
          std::vector<double> values;
          for (int k = 1; k <= levels; ++k)
            values.push_back(
                3.0 + 0.1 * (std::exp2(-order * k) + second * std::exp2(-(order + more) * k)));
          const Limit limit = limit_of(values, 2.0);
          ++all;
          if (std::abs(limit.value - 3.0) <= limit.uncertainty) ++covered;
        }
  EXPECT_GE(covered, 0.95 * all) << "of " << all;
}

TEST(Limit, AValueConvergedToRoundingHasNoOrderButABar) {
  const double a = 5.001008;
  const double bit = 8.9e-16;
  for (const auto& values : {std::vector<double>{a, a, a},
                             std::vector<double>{a + 4 * bit, a, a + 2 * bit, a - bit, a}}) {
    const Limit limit = limit_of(values, 2.0);
    EXPECT_TRUE(limit.settled);
    EXPECT_FALSE(limit.order);
    EXPECT_EQ(limit.reason, "converged to rounding");
    EXPECT_GE(limit.uncertainty, 1e-12 * a);
    EXPECT_LT(limit.uncertainty, 1e-11 * a);
  }
  // A solver with a tolerance of 1e-6 does not resolve changes of 3e-7.
  const Limit rough = limit_of({1.0, 1.0 + 3e-7, 1.0 + 4e-7}, 2.0, 1e-6);
  EXPECT_TRUE(rough.settled);
  EXPECT_GE(rough.uncertainty, 1e-6);
  EXPECT_FALSE(limit_of({1.0, 1.0 + 3e-7, 1.0 + 4e-7}, 2.0).settled);
}

TEST(Limit, FourLevelsOfAMixedSequenceEncloseTheirLimit) {
  std::vector<double> values;
  for (int k = 0; k < 5; ++k) {
    const double h = std::exp2(-k);
    values.push_back(1.0 + 0.2 * h * h + 0.05 * h * h * h);
  }
  const Limit limit = limit_of(values, 2.0);
  ASSERT_TRUE(limit.order);
  EXPECT_NEAR(*limit.order, 2.0, 0.05);
  EXPECT_LT(std::abs(limit.value - 1.0), limit.uncertainty);
  EXPECT_LT(limit.uncertainty, 0.5 * limit.grid_uncertainty);
  EXPECT_LT(std::abs(values.back() - 1.0), limit.grid_uncertainty);
}

TEST(Limit, NoOrderIsClaimedWhereThereIsNone) {
  const auto reason = [](const std::vector<double>& values) {
    const Limit limit = limit_of(values, 2.0);
    EXPECT_FALSE(limit.order);
    EXPECT_DOUBLE_EQ(limit.value, values.back());
    return limit.reason;
  };
  EXPECT_EQ(reason({1.0, 1.2, 1.1}), "the sequence is not monotone");
  EXPECT_EQ(reason({1.0, 1.1, 1.3}), "its changes do not decrease");
  EXPECT_EQ(reason({1.0, 1.1, 1.1}), "the last two values are the same");
  EXPECT_EQ(reason({1.0, 1.1}), "two levels cannot show an order");
  EXPECT_TRUE(says(reason(sequence(0.2, 3)), "too slowly"));
  EXPECT_TRUE(says(reason(sequence(8.0, 3)), "coincidence"));
  // Three times the largest of the last two changes.
  EXPECT_NEAR(limit_of({1.0, 1.2, 1.1}, 2.0).grid_uncertainty, 0.6, 1e-12);
  EXPECT_THROW(limit_of({1.0}, 2.0), std::logic_error);
  EXPECT_THROW(limit_of({1.0, 2.0}, 1.0), std::logic_error);
}

TEST(Limit, ALittleScatterDoesNotHideTheOrderOfManyLevels) {
  // The last three changes do not fall, but all five values follow 3 + 0.1 / 4^k within 2e-3.
  std::vector<double> values = sequence(2.0, 5);
  values[3] += 2e-3;
  const Limit limit = limit_of(values, 2.0);
  ASSERT_TRUE(limit.order) << limit.reason;
  EXPECT_TRUE(limit.fitted);
  EXPECT_NE(limit.reason, "");
  EXPECT_NEAR(*limit.order, 2.0, 0.2);
  EXPECT_LT(std::abs(limit.value - 3.0), limit.uncertainty);
  EXPECT_LT(limit.uncertainty, 5e-3);
  // As much scatter as change, or an order that no method here has, is no curve.
  EXPECT_FALSE(limit_of({3.1, 3.0, 3.05, 2.98, 3.06}, 2.0).order);
  EXPECT_FALSE(limit_of({3.1, 3.001, 3.0, 2.9995, 3.0001}, 2.0).order);
}

TEST(Limit, OrderOfErrorsOnAnyRatio) {
  EXPECT_NEAR(*order_of_errors(9.0, 1.0, 3.0), 2.0, 1e-12);
  EXPECT_NEAR(*order_of_errors(-2.0, 4.0, 2.0), -1.0, 1e-12);
  EXPECT_FALSE(order_of_errors(1.0, 0.0, 2.0));
}

/// Pressure of order 2 towards 100, a coefficient of order 1 towards 0.2.
StudyRecord record() {
  StudyRecord study;
  study.title = "a case";
  study.friction = 0.4;
  StudyPlace place;
  place.creepages = {{0.0, 0.0, 0.0}, {0.001, 0.0, 0.0}};
  StudySeries series{"halfspace", "grid", "contact grid", 2.0, {}, ""};
  series.measures_others = true;
  for (int k = 0; k < 4; ++k) {
    StudyLevel level;
    level.label = std::to_string(10 << k);
    level.unknowns = 100L << (2 * k);
    level.seconds = 0.1 * std::exp2(2 * k);
    level.values = {{"max_pressure", 100.0 + std::exp2(-2 * k)},
                    {"traction_coefficient:2", 0.2 - 0.01 * std::exp2(-k)}};
    series.levels.push_back(level);
  }
  place.series = {series};
  study.places = {place};
  return study;
}

std::map<std::string, StudyReference> references_of(const StudyRecord& study,
                                                    std::size_t series = 0) {
  return references(study.places[0], study.places[0].series[series], study.rule);
}

TEST(Study, UsesExactValuesAndExtrapolatesTheOthers) {
  StudyRecord study = record();
  study.places[0].exact = {{"max_pressure", 100.0}};
  auto refs = references_of(study);
  EXPECT_EQ(refs.at("max_pressure").kind, "exact");
  EXPECT_EQ(refs.at("traction_coefficient:2").kind, "extrapolated");
  EXPECT_NEAR(refs.at("traction_coefficient:2").value, 0.2, 1e-12);
  study.rule = ReferenceRule::finest;
  refs = references_of(study);
  EXPECT_EQ(refs.at("max_pressure").kind, "finest");
  EXPECT_DOUBLE_EQ(refs.at("max_pressure").value, 100.0 + 1.0 / 64.0);
  study.places[0].given = {{"max_pressure", 99.0}};
  EXPECT_EQ(references_of(study).at("max_pressure").kind, "given");
  study.rule = ReferenceRule::exact;
  EXPECT_EQ(references_of(study).count("traction_coefficient:2"), 0U);
}

/// Finite bodies whose limits differ from those of half-spaces by 1.5 MPa of 100.5 and 0.012 of mu
/// = 0.4: that is no error of their cells.
TEST(Study, FiniteBodiesAreMeasuredAgainstTheirOwnLimit) {
  StudyRecord study = record();
  study.places[0].exact = {{"max_pressure", 100.5}};
  StudySeries fem = study.places[0].series[0];
  fem.model = "fem";
  fem.limit_of_its_own = true;
  fem.measures_others = false;
  for (StudyLevel& level : fem.levels) {
    level.values["max_pressure"] += 2.0;
    level.values["traction_coefficient:2"] += 0.012;
  }
  study.places[0].series.insert(study.places[0].series.begin(), fem);
  EXPECT_EQ(reference_series(study.places[0]), 1U);
  EXPECT_EQ(references_of(study, 1).at("max_pressure").kind, "exact");
  const auto own = references_of(study, 0);
  EXPECT_EQ(own.at("max_pressure").kind, "extrapolated");
  EXPECT_NEAR(own.at("max_pressure").value, 102.0, 1e-9);
  EXPECT_NEAR(study_error(study, "max_pressure", fem.levels.back().values.at("max_pressure"),
                          own.at("max_pressure")),
              1.0 / 64.0 / 102.0, 1e-9);
  const auto differences = model_differences(study, study.places[0], study.places[0].series[0]);
  EXPECT_NEAR(differences.at("max_pressure").value, 1.5 / 100.5, 1e-9);
  EXPECT_NEAR(differences.at("traction_coefficient:2").value, 0.012 / 0.4, 1e-9);
  EXPECT_TRUE(model_differences(study, study.places[0], study.places[0].series[1]).empty());
  EXPECT_TRUE(says(study_verdict(study),
                   "Model differences from halfspace: fem (grid) p0 1.5 %, -F_x/F_z 3 % of mu."));
  EXPECT_TRUE(says(study_table(study), "model difference from halfspace: +1.5 % +- "));
  const auto json = nlohmann::json::parse(study_json(study)).at("places")[0];
  EXPECT_EQ(json.at("reference"), "halfspace");
  EXPECT_NEAR(json.at("series")[0].at("model_differences").at("max_pressure").at("value"),
              1.5 / 100.5, 1e-9);
}

TEST(Study, ErrorsAreRelativeAndOfCoefficientsToFriction) {
  StudyRecord study = record();
  study.places[0].exact = {{"max_pressure", 100.0}};
  const auto refs = references_of(study);
  EXPECT_NEAR(study_error(study, "max_pressure", 101.0, refs.at("max_pressure")), 0.01, 1e-12);
  EXPECT_NEAR(study_error(study, "traction_coefficient:2", 0.19, refs.at("traction_coefficient:2")),
              0.025, 1e-12);
}

TEST(Study, OrdersComeFromErrorsOnlyWhereTheReferenceIsKnown) {
  StudyRecord study = record();
  study.places[0].exact = {{"max_pressure", 100.0}};
  const auto refs = references_of(study);
  const auto of = [&](const char* key) {
    return level_orders(study, study.places[0].series[0], key, refs.at(key));
  };
  const auto pressure = of("max_pressure");
  ASSERT_EQ(pressure.size(), 4U);
  EXPECT_FALSE(pressure[0]);
  for (int k = 1; k < 4; ++k) EXPECT_NEAR(*pressure[static_cast<std::size_t>(k)], 2.0, 1e-9);
  const auto force = of("traction_coefficient:2");
  EXPECT_FALSE(force[1]);
  EXPECT_NEAR(*force[3], 1.0, 1e-9);
}

TEST(Study, FilesHoldValuesErrorsOrdersAndTheVerdict) {
  StudyRecord study = record();
  study.places[0].exact = {{"max_pressure", 100.0}};
  const auto json = nlohmann::json::parse(study_json(study));
  EXPECT_NEAR(json.at("places")[0]
                  .at("series")[0]
                  .at("limits")
                  .at("traction_coefficient:2")
                  .at("value")
                  .get<double>(),
              0.2, 1e-9);
  const std::string csv = study_csv(study);
  const auto finest = csv_records(csv).at(6);
  EXPECT_EQ(finest.at("quantity"), "max_pressure");
  EXPECT_NEAR(std::stod(finest.at("error")), 1.0 / 6400.0, 1e-12);
  EXPECT_NEAR(std::stod(finest.at("order")), 2.0, 1e-9);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 4 * 2);
  EXPECT_TRUE(
      says(csv, ",halfspace,grid,10,0,100,0,0.1,max_pressure,101,,100,0,exact,0.01,value,\n"));
  const std::string table = study_table(study);
  EXPECT_TRUE(says(table, "order 1.00 from the last three levels"));
  // 101, 100.25, ... and 0.19, 0.195, ...: the finest is off by 1/64 and, of mu = 0.4, 0.00125.
  EXPECT_EQ(study_verdict(study),
            "Finest levels against their references: halfspace (grid) p0 0.016 %, -F_x/F_z 0.31 % "
            "of mu. Of 2 sequences of levels 2 show an order.");
}

TEST(Study, OneLevelHasNoOrderAndBreaksNothing) {
  StudyRecord study = record();
  study.places[0].series[0].levels.resize(1);
  study.places[0].series[0].ratio = 0.0;
  EXPECT_FALSE(series_limit(study.places[0].series[0], "max_pressure"));
  EXPECT_EQ(references_of(study).at("max_pressure").kind, "finest");
  EXPECT_FALSE(study_table(study).empty());
}

}  // namespace
