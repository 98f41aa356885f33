// SPDX-License-Identifier: LGPL-2.1-or-later
// Every scalar in the results has an error bar or a reason why it has none, for all models and
// kinds of problems.
#include "contact/result/bars.hpp"

#include "contact/result/quantities.hpp"

#include <fmt/format.h>

#include "support/case_examples.hpp"
#include "support/program.hpp"

namespace {

using nlohmann::json;

const std::set<std::string> words{contact::no_bar::exact,         contact::no_bar::given,
                                  contact::no_bar::counted,       contact::no_bar::theory,
                                  contact::no_bar::measured,      contact::no_bar::one_grid,
                                  contact::no_bar::not_estimated, contact::no_bar::balance};

json summary_of(const std::string& text, const std::vector<std::string>& models) {
  const Folder folder;
  folder.done(joined(
      {"run", folder.file("case.toml", text), "-o", "out", "-q", "--no-report", "-m"}, models));
  return folder.json("out/summary.json");
}

/// Each number has either a valid error bar or a word of the list.
void expect_all_said(const json& summary) {
  EXPECT_FALSE(summary["models"].empty());
  for (const json& model : summary["models"]) {
    EXPECT_NE(model["model_error_source"].get<std::string>(), "") << model["name"];
    for (const json& point : model["points"]) {
      const json& bars = point["error_estimate"];
      const json& without = point["no_bar"];
      for (const contact::Quantity& quantity : contact::quantities()) {
        const std::string at = model["name"].get<std::string>() + ": " + quantity.name;
        const bool barred = bars.contains(quantity.name);
        EXPECT_EQ(barred || without.contains(quantity.name), point.contains(quantity.name)) << at;
        EXPECT_FALSE(barred && without.contains(quantity.name)) << at;
        if (barred) {
          EXPECT_TRUE(std::isfinite(bars[quantity.name].get<double>())) << at;
          EXPECT_GE(bars[quantity.name].get<double>(), 0.0) << at;
        } else if (without.contains(quantity.name)) {
          EXPECT_EQ(words.count(without[quantity.name].get<std::string>()), 1U) << at;
          EXPECT_NE(without[quantity.name], contact::no_bar::not_estimated) << at;
        }
      }
      const json errors = point.value("model_error", json::object());
      for (const auto& [name, error] : errors.items())
        EXPECT_GE(error.get<double>(), 0.0) << model["name"] << ": " << name;
    }
  }
}

const json& model_of(const json& summary, const std::string& name) {
  for (const json& model : summary["models"])
    if (model["name"] == name) return model;
  throw std::runtime_error("no model " + name);
}

const std::vector<std::string> theories{"hertz",   "linear", "vermeulen-johnson",
                                        "polach",  "carter", "fastsim",
                                        "fastrip", "strip",  "halfspace"};

TEST(Bars, ArePrintedForEveryNumberOfEveryModel) {
  const json summary = summary_of(rolling("[0.0, 0.001, 0.02]", 20), theories);
  expect_all_said(summary);
  const json& hertz = model_of(summary, "hertz")["points"][0];
  for (const char* name :
       {"max_pressure", "semi_axis_x", "semi_axis_y", "approach", "contact_area"})
    EXPECT_EQ(hertz["no_bar"][name], "exact") << name;
  const json& linear = model_of(summary, "linear")["points"][1];
  EXPECT_EQ(linear["no_bar"]["max_pressure"], "exact");
  EXPECT_EQ(linear["no_bar"]["longitudinal_force"], "theory");
  const json& half = model_of(summary, "halfspace")["points"][1];
  EXPECT_EQ(half["no_bar"]["normal_force"], "given");
  EXPECT_EQ(half["no_bar"]["longitudinal_creepage"], "given");
  EXPECT_FALSE(half.contains("model_error"));
  for (const char* name : {"contact_length", "contact_width"})
    EXPECT_GT(half["error_estimate"][name].get<double>(), 0.0) << name;
}

/// The model error of a theory is at least its distance from the half-space, which a fine grid
/// knows up to its bar; Hertz's pressure is the half-space's.
TEST(Bars, ModelErrorsCoverTheErrorsOfTheories) {
  const json summary = summary_of(rolling("0.001", 80), theories);
  const json& half = model_of(summary, "halfspace")["points"][0];
  for (const char* name :
       {"linear", "vermeulen-johnson", "polach", "carter", "fastsim", "fastrip", "strip"}) {
    const json& theory = model_of(summary, name)["points"][0];
    for (const char* quantity : {"longitudinal_force", "traction_coefficient", "max_pressure"}) {
      const double off = std::abs(theory[quantity].get<double>() - half[quantity].get<double>());
      const double bar = half["error_estimate"][quantity].get<double>();
      EXPECT_GE(theory["model_error"][quantity].get<double>(), off - bar)
          << name << ": " << quantity;
    }
    const bool hertzian = name != std::string("strip");
    EXPECT_EQ(theory["model_error"]["max_pressure"] == 0.0, hertzian) << name;
    EXPECT_GT(theory["model_error"]["traction_coefficient"], 0.0) << name;
  }
  EXPECT_EQ(model_of(summary, "hertz")["points"][0]["model_error"]["max_pressure"], 0.0);
}

/// Like rollers: Hertz's and Carter's closed forms leave nothing of the half-plane out. Unlike
/// ones: friction moves the pressure.
TEST(Bars, ModelErrorsVanishWhereTheoriesAreExact) {
  const std::string rollers =
      "[load]\nnormal_force = 16.2\n[friction]\ncoefficient = 0.3\n"
      "[wheel]\nyoung_modulus = 210000.0\npoisson_ratio = 0.3\n"
      "[rail]\nyoung_modulus = {}\npoisson_ratio = 0.3\n"
      "[geometry]\nshape = \"line\"\nrelative_radius = 25.0\n"
      "[contact_grid]\nelements_across = 20\n[rolling]\nlongitudinal_creepage = [0.0, 5e-4]\n";
  const json like = summary_of(fmt::format(fmt::runtime(rollers), 210000.0), {"hertz", "carter"});
  for (const char* name : {"hertz", "carter"})
    for (const json& point : model_of(like, name)["points"])
      for (const auto& [quantity, error] : point["model_error"].items())
        EXPECT_EQ(error, 0.0) << name << ": " << quantity;
  EXPECT_TRUE(model_of(like, "carter")["points"][1]["model_error"].contains("longitudinal_force"));
  EXPECT_TRUE(model_of(like, "hertz")["points"][0]["model_error"].contains("max_pressure"));
  const json unlike = summary_of(fmt::format(fmt::runtime(rollers), 70000.0), {"carter"});
  const json& rolled = model_of(unlike, "carter")["points"][1]["model_error"];
  EXPECT_GT(rolled["longitudinal_force"].get<double>(), 0.0);
  EXPECT_GT(rolled["max_pressure"].get<double>(), 0.0);
}

TEST(Bars, ArePrintedForCreepagesFoundForAForce) {
  const json summary = summary_of(small_case +
                                      "[contact_grid]\nelements_across = 20\n"
                                      "[rolling]\nlongitudinal_force = -10e3\n",
                                  {"hertz", "halfspace"});
  expect_all_said(summary);
  // Without friction there is no force to find.
  EXPECT_EQ(model_of(summary, "hertz")["points"][0]["model_error"]["max_pressure"], 0.0);
  const json& point = model_of(summary, "halfspace")["points"][0];
  EXPECT_GT(point["error_estimate"]["longitudinal_creepage"].get<double>(), 0.0);
  EXPECT_EQ(point["no_bar"]["lateral_creepage"], "given");
}

TEST(Bars, ArePrintedForOtherProblems) {
  expect_all_said(summary_of(with("normal_force = 50e3", "approach = 0.05") +
                                 "[contact_grid]\nelements_across = 12\n"
                                 "[output]\nstress_maxima = true\n",
                             {"hertz", "halfspace"}));
  expect_all_said(summary_of(
      small_case + "[contact_grid]\nelements_across = 12\n"
                   "[rolling]\nproblem = \"shift\"\n[history]\nlongitudinal_shift = 0.001\n",
      {"hertz", "halfspace"}));
}

/// The right wheel of S1002 on UIC60 on few elements, with a line in place of its creepages.
std::string wheel_with(const std::string& line) {
  std::string text = contents(std::string(ROLLFEM_SOURCE_DIR) + "/cases/s1002_uic60_right.toml");
  const auto replace = [&](const std::string& piece, const std::string& by) {
    const std::size_t at = text.find(piece);
    if (at == std::string::npos) throw std::logic_error("no '" + piece + "' in the case");
    text.replace(at, piece.size(), by);
  };
  replace("longitudinal_creepage = [0.0, 0.0005, 0.001, 0.002, 0.003, 0.004, 0.006]", "");
  replace("elements_across = 40", "elements_across = 12");
  replace("lateral_shift = 2.0", line + "\nlateral_shift = 2.0");
  return text;
}

TEST(Bars, ArePrintedForPatchesOfProfiles) {
  const json summary = summary_of(wheel_with(""), {"hertz", "fastsim", "strip", "halfspace"});
  expect_all_said(summary);
  for (const json& model : summary["models"])
    EXPECT_TRUE(model["points"][0].contains("vertical_force"));
  // An ellipse no longer represents the contact of true profiles.
  for (const char* name : {"hertz", "fastsim"})
    EXPECT_EQ(model_of(summary, name)["points"][0]["no_bar"]["max_pressure"], "theory") << name;
}

TEST(Bars, ArePrintedForTheBalanceOfAWheelset) {
  const json summary = summary_of(wheel_with("free_rolling = \"force\""), {"halfspace"});
  expect_all_said(summary);
  const json& point = summary["models"][0]["points"][0];
  const double error = point["error_estimate"]["longitudinal_creepage"].get<double>();
  EXPECT_GT(error, 0.0);
  EXPECT_LT(error, 1e-4);
}

#if ROLLFEM_WITH_FEM
TEST(Bars, ArePrintedForFiniteElements) {
  const json summary =
      summary_of(small_case +
                     "[fem]\ncell_size = 2.0\nextent = 40.0\n"
                     "[rolling]\nlongitudinal_creepage = 0.001\n[output]\nfields = false\n",
                 {"fem"});
  expect_all_said(summary);
  EXPECT_GT(summary["models"][0]["points"][0]["error_estimate"]["max_pressure"].get<double>(), 0.0);
}
#endif

}  // namespace
