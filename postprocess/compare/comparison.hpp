// SPDX-License-Identifier: LGPL-2.1-or-later
// Results of several models side by side: every number with its error bar and its difference from a
// reference model, for one or several cases.
#pragma once

#include "contact/result/quantities.hpp"
#include "postprocess/write/output.hpp"

#include <optional>
#include <string>
#include <vector>

namespace rollfem::postprocess {

struct ComparedCase {
  std::string name;       ///< of its result folder beside the comparison
  std::string case_file;  ///< as given by the user
  std::string title;
  double friction = 0.0;                     ///< coefficient
  std::vector<contact::ModelResult> models;  ///< scalars_of the results
  std::vector<MissingModel> missing;
};

/// A case without results yet.
ComparedCase compared_case(const std::string& name, const contact::Case& input);

/// Results without the values of elements and nodes, which no comparison needs.
std::vector<contact::ModelResult> scalars_of(std::vector<contact::ModelResult> models);

struct ComparisonRecord {
  Provenance provenance;
  std::vector<std::string> models;  ///< as requested
  std::string reference;            ///< as requested; may be empty
  /// Candidates for the reference in order of preference: the requested model, then the program's
  /// defaults.
  std::vector<std::string> references;
  std::vector<ComparedCase> cases;
};

/// One quantity of one model at one load point, compared with the reference.
struct ComparedNumber {
  std::string patch;  ///< "left wheel, position 1"; empty without profiles
  std::string model;
  std::string reference;
  int point = 1;  ///< load point, counted from 1
  double longitudinal_creepage = 0.0;
  double lateral_creepage = 0.0;
  double spin = 0.0;
  std::string quantity;  ///< as in summary.json, or lateral_coefficient = -F_y/F_z
  double value = 0.0;
  std::optional<double> error;        ///< the model's own estimate, absolute; empty: no estimate
  std::optional<double> model_error;  ///< model error as estimated by the model, absolute
  std::optional<double> reference_value;
  double reference_error = 0.0;  ///< absolute; 0 without an estimate
  /// Scale of relative differences: the reference's value, or the value at full sliding.
  double scale = 0.0;
  double difference() const { return (value - *reference_value) / scale; }
  /// Sum of both error bars, relative to the scale.
  double allowed() const { return (error.value_or(0.0) + reference_error) / scale; }
  bool differs() const;  ///< by more than allowed(); a theory without an estimate has no bar
};

/// Quantities for comparing models: patch quantities first, then friction quantities.
std::vector<contact::Quantity> compared_quantities();

/// The reference model: the first entry of `order` that is among `models` (the models with results
/// of friction, or of the patch), otherwise the first of `models`.
std::string reference_of(const std::vector<std::string>& models,
                         const std::vector<std::string>& order);

/// All numbers of a case, patch by patch, model by model, load point by load point.
std::vector<ComparedNumber> compared_numbers(const ComparedCase& compared,
                                             const std::vector<std::string>& references);

/// Comparison of a model with the reference in one quantity at one place of one case.
struct Standing {
  std::string patch;  ///< as in ComparedNumber; also empty for all places together
  std::string model;
  std::string reference;
  std::string quantity;
  int compared = 0;       ///< number of compared values
  int differ = 0;         ///< number of values that differ by more than the error bars
  ComparedNumber worst;   ///< the largest difference
  ComparedNumber beyond;  ///< the number that exceeds the error bars most
};
std::vector<Standing> standings(const std::vector<ComparedNumber>& numbers);

/// Merges the places of a case: one standing for each model and quantity.
std::vector<Standing> over_places(const std::vector<Standing>& standings);

/// A case with the standings of its models.
struct CaseStandings {
  std::string name;
  std::vector<Standing> standings;
  std::vector<std::pair<std::string, double>> seconds;  ///< of the models, in their order
};
CaseStandings case_standings(const ComparedCase& compared,
                             const std::vector<std::string>& references);

/// Table for the terminal: the largest differences of every model over all places, marked if they
/// exceed the error bars, and the seconds.
std::string comparison_table(const CaseStandings& one);

/// One line: which models agree with the reference within the error bars in every case, and by how
/// much the others exceed them. Empty if nothing was compared.
std::string comparison_verdict(const std::vector<CaseStandings>& cases);

/// What the program prints: the table of every case with the models that are missing, and the
/// verdict.
std::string comparison_text(const ComparisonRecord& record);

/// Text of compare.json: cases, models and their standings; layout in docs/commands.md.
std::string comparison_json(const ComparisonRecord& record);

/// Text of compare.csv: one row per number.
std::string comparison_csv(const ComparisonRecord& record);

}  // namespace rollfem::postprocess
