// SPDX-License-Identifier: LGPL-2.1-or-later
// Differences, scales and error bars of a comparison, against numbers worked out by hand.
#include "postprocess/compare/comparison.hpp"

#include <nlohmann/json.hpp>

#include "support/test.hpp"

namespace {

using namespace rollfem::postprocess;
using nlohmann::json;

using Bars = std::map<std::string, double>;

PointResult point(double xi, double p0, double traction, double largest, const Bars& errors) {
  PointResult found;
  found.creepage.longitudinal = xi;
  found.normal_force = 1000.0;
  found.longitudinal_force = -1000.0 * traction;
  found.traction_coefficient = traction;
  found.max_pressure = p0;
  found.max_traction = found.max_traction_x = largest;
  found.semi_axis_x = 2.0;
  found.semi_axis_y = 3.0;
  found.contact_area = 18.8;
  found.error_estimate = errors;
  return found;
}

ModelResult model(const char* name, const std::vector<PointResult>& points) {
  ModelResult found;
  found.name = name;
  found.seconds = {{"total", 0.5}};
  found.points = points;
  return found;
}

/// Half-space with error bars, FASTSIM without, Hertz with one point.
ComparedCase example() {
  const Bars errors{{"max_pressure", 1.0}, {"traction_coefficient", 0.004}};
  ComparedCase compared;
  compared.name = "a";
  compared.friction = 0.5;
  compared.models = {
      model("hertz", {point(0.0, 101.0, 0.0, 0.0, {})}),
      model("fastsim", {point(0.0, 100.0, 0.0, 0.0, {}), point(0.001, 100.0, 0.19, 30.0, {})}),
      model("halfspace",
            {point(0.0, 100.0, 0.0, 0.0, errors), point(0.001, 100.0, 0.20, 25.0, errors)})};
  return compared;
}

ComparedNumber number(const std::vector<ComparedNumber>& all, const char* name, int load_point,
                      const char* quantity) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const ComparedNumber& n) {
    return n.model == name && n.point == load_point && n.quantity == quantity;
  });
  EXPECT_NE(found, all.end()) << name << ' ' << quantity;
  return found == all.end() ? ComparedNumber{} : *found;
}

const std::vector<std::string> references{"halfspace", "fem"};

TEST(Comparison, DifferencesAreRelativeToReferenceFrictionAndItsPressure) {
  const auto all = compared_numbers(example(), references);
  const auto pressure = number(all, "hertz", 1, "max_pressure");
  EXPECT_EQ(pressure.reference, "halfspace");
  EXPECT_NEAR(pressure.difference(), 0.01, 1e-12);
  EXPECT_NEAR(pressure.allowed(), 0.01, 1e-12);
  EXPECT_FALSE(pressure.differs());
  EXPECT_FALSE(pressure.error);
  const auto force = number(all, "fastsim", 2, "traction_coefficient");
  EXPECT_NEAR(force.difference(), -0.01 / 0.5, 1e-12);
  EXPECT_NEAR(force.allowed(), 0.02 * 0.20 / 0.5, 1e-12);
  EXPECT_TRUE(force.differs());
  // mu p0 = 50 MPa
  EXPECT_NEAR(number(all, "fastsim", 2, "max_traction_x").difference(), 5.0 / 50.0, 1e-12);
}

TEST(Comparison, AForceThatVanishesHasItsBar) {
  const auto force =
      number(compared_numbers(example(), references), "halfspace", 1, "traction_coefficient");
  EXPECT_NEAR(*force.error, 0.004, 1e-12);
  EXPECT_FALSE(force.reference_value);  // it is the reference
}

TEST(Comparison, WhatAModelDoesNotGiveIsNotCompared) {
  for (const ComparedNumber& n : compared_numbers(example(), references)) {
    EXPECT_NE(n.quantity, "approach");             // 0: not given
    EXPECT_NE(n.quantity, "lateral_coefficient");  // nothing lateral in this case
    EXPECT_FALSE(n.model == "hertz" && n.quantity == "traction_coefficient");
  }
}

TEST(Comparison, TheLateralCoefficientRisesAgainstTheForceOnTheWheel) {
  ComparedCase sideways = example();
  // -F_y/F_z of 0.12 and 0.15, as positive lateral creepage makes.
  sideways.models[1].points[1].lateral_force = -120.0;
  sideways.models[2].points[1].lateral_force = -150.0;
  const auto force =
      number(compared_numbers(sideways, references), "fastsim", 2, "lateral_coefficient");
  EXPECT_NEAR(force.value, 0.12, 1e-12);
  EXPECT_NEAR(force.reference_value.value_or(0.0), 0.15, 1e-12);
}

TEST(Comparison, OfAPrescribedForceTheCreepageIsTheResult) {
  ComparedCase forced = example();
  const double found[] = {0.0, 1.0e-3, 1.25e-3};  // by fastsim and half-space
  for (const std::size_t k : {1U, 2U}) {
    PointResult& last = forced.models[k].points[1];
    last.traction_coefficient = 0.2;
    last.creepage.longitudinal = found[k];
    last.no_bar = {{"lateral_creepage", "given"}, {"spin", "given"}};
    if (k == 1) last.no_bar["longitudinal_creepage"] = "theory";
    if (k == 2) last.error_estimate["longitudinal_creepage"] = 1e-4;
  }
  const auto all = compared_numbers(forced, references);
  const auto creepage = number(all, "fastsim", 2, "longitudinal_creepage");
  EXPECT_NEAR(creepage.difference(), -0.2, 1e-12);
  EXPECT_NEAR(creepage.allowed(), 0.08, 1e-12);
  EXPECT_TRUE(creepage.differs());
  EXPECT_NEAR(*number(all, "halfspace", 2, "longitudinal_creepage").error, 1e-4, 1e-12);
  for (const ComparedNumber& n : all)
    EXPECT_FALSE(n.point == 2 &&
                 (n.quantity == "traction_coefficient" || n.quantity == "lateral_creepage"))
        << n.model << n.quantity;
  EXPECT_NE(comparison_verdict({case_standings(forced, references)}).find("xi 20 %"),
            std::string::npos);
}

TEST(Comparison, TheWishedReferenceIsTakenWhereItHasTheNumber) {
  const auto all = compared_numbers(example(), {"hertz", "halfspace"});
  EXPECT_EQ(number(all, "halfspace", 1, "max_pressure").reference, "hertz");
  EXPECT_NEAR(number(all, "halfspace", 1, "max_pressure").difference(), -1.0 / 101.0, 1e-12);
  EXPECT_EQ(number(all, "fastsim", 2, "traction_coefficient").reference, "halfspace");
  EXPECT_EQ(reference_of({"strip", "fem"}, references), "fem");
  EXPECT_EQ(reference_of({"strip"}, references), "strip");
  EXPECT_EQ(reference_of({}, references), "");
}

TEST(Comparison, AnExactValueIsTheReferenceUnlessTheOtherOneResolvesItsModelError) {
  ComparedCase exact = example();
  PointResult& hertz = exact.models[0].points[0];
  hertz.no_bar = {{"max_pressure", "exact"}};
  const auto pressure = [&](double model_error, const char* model, const std::string& wished) {
    hertz.model_error = {{"max_pressure", model_error}};
    return number(compared_numbers(exact, {wished, "halfspace"}), model, 1, "max_pressure");
  };
  // The half-space's bar is 1 MPa.
  EXPECT_EQ(pressure(0.9, "halfspace", "").reference, "hertz");
  EXPECT_NEAR(pressure(0.9, "halfspace", "").difference(), -1.0 / 101.0, 1e-12);
  EXPECT_FALSE(pressure(0.9, "hertz", "").reference_value);
  EXPECT_EQ(pressure(1.1, "hertz", "").reference, "halfspace");
  EXPECT_EQ(pressure(0.9, "hertz", "halfspace").reference, "halfspace") << "as requested";
}

/// The words of a line, one space between them.
std::string words(const std::string& line) {
  std::istringstream stream(line);
  std::string text;
  for (std::string word; stream >> word;) text += (text.empty() ? "" : " ") + word;
  return text;
}

TEST(Comparison, TheTableMarksDifferencesBeyondTheErrorBars) {
  const CaseStandings stand = case_standings(example(), references);
  ASSERT_EQ(stand.seconds.size(), 3U);
  std::istringstream table(comparison_table(stand));
  std::vector<std::string> lines;
  for (std::string line; std::getline(table, line);) lines.push_back(words(line));
  ASSERT_EQ(lines.size(), 5U);
  EXPECT_EQ(lines[0], "p0 semi-axis x semi-axis y -F_x/F_z |p_x| seconds");
  EXPECT_EQ(lines[1], "% % % % of mu % of mu p0");
  EXPECT_EQ(lines[2], "hertz 1.0 0 0 - - 0.5");
  EXPECT_EQ(lines[3], "fastsim 0 0 0 -2.0* 10* 0.5");
  EXPECT_EQ(lines[4], "halfspace - - - - - 0.5");
}

TEST(Comparison, TheVerdictNamesTheLargestDifferenceBeyondTheErrorBarsOfAllCases) {
  const CaseStandings good = case_standings(example(), references);
  CaseStandings bad = good;
  bad.name = "b";
  EXPECT_EQ(comparison_verdict({good}),
            "Within the error bars of halfspace: hertz. Beyond them: fastsim (-F_x/F_z 2.0 % of "
            "mu, |p_x| 10 % of mu p0).");
  for (Standing& standing : bad.standings) {
    if (standing.model == "hertz" && standing.quantity == "max_pressure") standing.differ = 1;
    if (standing.quantity == "max_traction_x") standing.beyond.value += 10.0;  // of mu p0 = 50 MPa
  }
  EXPECT_EQ(comparison_verdict({good, bad}),
            "Within the error bars of halfspace: none. Beyond them: hertz (p0 1.0 %), fastsim "
            "(-F_x/F_z 2.0 % of mu, |p_x| 30 % of mu p0).");
  EXPECT_EQ(comparison_verdict({}), "");
}

/// Of the worn wheel: the first patch agrees, the second does not.
ComparedCase two_places() {
  ComparedCase compared;
  compared.name = "worn";
  compared.friction = 0.5;
  for (const int patch : {1, 2})
    for (const char* name : {"halfspace", "fem"}) {
      const double p0 = std::string(name) == "fem" && patch == 2 ? 110.0 : 100.0;
      compared.models.push_back(model(name, {point(0.0, p0, 0.0, 0.0, {{"max_pressure", 1.0}})}));
      rollfem::contact::ContactPlace& place = compared.models.back().place.emplace();
      place.patch = patch;
      place.patches = 2;
    }
  return compared;
}

TEST(Comparison, PlacesStandForThemselves) {
  const CaseStandings stand = case_standings(two_places(), references);
  int of_pressure = 0;
  for (const Standing& standing : stand.standings) {
    if (standing.quantity != "max_pressure") continue;
    ++of_pressure;
    EXPECT_EQ(standing.compared, 1);
    EXPECT_EQ(standing.differ, standing.patch == "left wheel, position 1, patch 2 of 2" ? 1 : 0);
  }
  EXPECT_EQ(of_pressure, 2);
  EXPECT_EQ(comparison_verdict({stand}),
            "Within the error bars of halfspace: none. Beyond them: fem (p0 10 %).");
  const auto all = over_places(stand.standings);
  const auto pressure = std::find_if(all.begin(), all.end(), [](const Standing& standing) {
    return standing.quantity == "max_pressure";
  });
  ASSERT_NE(pressure, all.end());
  EXPECT_EQ(pressure->compared, 2);
  EXPECT_EQ(pressure->differ, 1);
  ComparisonRecord record;
  record.cases = {two_places()};
  const json out = json::parse(comparison_json(record));
  EXPECT_EQ(out.at("cases")[0].at("standings")[0].at("patch"),
            "left wheel, position 1, patch 1 of 2");
}

TEST(Comparison, TheVerdictTellsTheDifferenceThatTheErrorBarsAllowLeast) {
  // Point 1 is off by 3 with bars of 4, point 2 by 2 with bars of 1.
  ComparedNumber wide;
  wide.model = "fem";
  wide.reference = "halfspace";
  wide.quantity = "traction_coefficient";
  wide.value = 0.03;
  wide.error = 0.04;
  wide.reference_value = 0.0;
  wide.scale = 1.0;
  ComparedNumber narrow = wide;
  narrow.point = 2;
  narrow.value = 0.02;
  narrow.error = 0.01;
  EXPECT_EQ(comparison_verdict({{"a", standings({wide, narrow}), {{"fem", 1.0}}}}),
            "Within the error bars of halfspace: none. Beyond them: fem (-F_x/F_z 2.0 % of mu).");
}

TEST(Comparison, FilesHoldEveryNumberAndTheMissingModels) {
  ComparisonRecord record;
  record.models = {"hertz", "fastsim", "halfspace", "fem"};
  record.references = references;
  record.cases = {example(), {}};
  record.cases[1].name = "b";
  record.cases[1].missing = {{"fem", "did not converge", true}};
  const json out = json::parse(comparison_json(record));
  EXPECT_EQ(out.at("kind"), "compare");
  EXPECT_TRUE(out.at("cases")[0].at("complete").get<bool>());
  EXPECT_FALSE(out.at("cases")[1].at("complete").get<bool>());
  EXPECT_EQ(out.at("cases")[1].at("missing")[0].at("reason"), "did not converge");
  const std::string csv = comparison_csv(record);
  const auto rows = static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n'));
  EXPECT_EQ(rows, 1 + compared_numbers(record.cases[0], record.references).size());
  const auto commas = [](const std::string& line) {
    return std::count(line.begin(), line.end(), ',');
  };
  const long head = commas(csv.substr(0, csv.find('\n')));
  for (std::size_t at = 0; at < csv.size(); at = csv.find('\n', at) + 1)
    EXPECT_EQ(commas(csv.substr(at, csv.find('\n', at) - at)), head);
}

}  // namespace
