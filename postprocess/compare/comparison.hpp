// SPDX-License-Identifier: LGPL-2.1-or-later
// Results of several models side by side: every number with its error bar and its difference
// from a reference model, over one or several cases. Built from the summaries of result
// folders, so that stored results take part like new ones.
#pragma once

#include "contact/result/quantities.hpp"
#include "postprocess/write/output.hpp"

#include <optional>
#include <string>
#include <vector>

namespace rollfem::postprocess {

/// A model that has no result for a case, and why.
struct MissingModel {
  std::string model;
  std::string reason;
  bool failed = false;  ///< else the case is none that it can take
};

struct ComparedCase {
  std::string name;       ///< of its result folder beside the comparison
  std::string case_file;  ///< as given by the user
  std::string title;
  double friction = 0.0;  ///< coefficient
  std::string summary;    ///< text of its summary.json; empty when no model gave a result
  std::vector<MissingModel> missing;
};

struct ComparisonRecord {
  Provenance provenance;
  std::vector<std::string> models;  ///< as asked for
  std::string reference;            ///< as asked for; may be empty
  /// In what order models are taken as the reference: the one asked for, then the program's own.
  std::vector<std::string> references;
  std::vector<ComparedCase> cases;
};

/// One quantity of one model at one load point, against the reference.
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
  std::optional<double> error;  ///< the model's own estimate, absolute; none: it gives no estimate
  std::optional<double> model_error;  ///< what the model says that it leaves out, absolute
  std::optional<double> reference_value;
  double reference_error = 0.0;  ///< absolute; 0 without an estimate
  /// What differences are relative to: the reference's value, or what full sliding gives.
  double scale = 0.0;
  double difference() const { return (value - *reference_value) / scale; }
  /// What both error bars allow together, relative to the scale.
  double allowed() const { return (error.value_or(0.0) + reference_error) / scale; }
  bool differs() const;  ///< by more than that; a theory without an estimate has no bar of its own
};

/// By what models are held against each other, those of the patch before those of friction.
std::vector<contact::Quantity> compared_quantities();

/// The model that others are compared with: the first of `order` that is among `models`, which have
/// such results (of friction or of the patch), else the first of these.
std::string reference_of(const std::vector<std::string>& models,
                         const std::vector<std::string>& order);

/// All numbers of a case, patch by patch, model by model, load point by load point.
std::vector<ComparedNumber> compared_numbers(const ComparedCase& compared,
                                             const std::vector<std::string>& references);

/// How a model stands to the reference in one quantity at one place of one case.
struct Standing {
  std::string patch;  ///< as in ComparedNumber; empty also when it is of all places together
  std::string model;
  std::string reference;
  std::string quantity;
  int compared = 0;       ///< numbers
  int differ = 0;         ///< of these, by more than their error bars
  ComparedNumber worst;   ///< the largest difference
  ComparedNumber beyond;  ///< where the difference exceeds what the error bars allow the most
};
std::vector<Standing> standings(const std::vector<ComparedNumber>& numbers);

/// The places of a case taken together: one standing for each model and quantity.
std::vector<Standing> over_places(const std::vector<Standing>& standings);

/// A case and how its models stand.
struct CaseStandings {
  std::string name;
  std::vector<Standing> standings;
  std::vector<std::pair<std::string, double>> seconds;  ///< of the models, in their order
};
CaseStandings case_standings(const ComparedCase& compared,
                             const std::vector<std::string>& references);

/// For the terminal: the largest differences of every model, marked where any is beyond the error
/// bars, and its seconds. Of several places the worst.
std::string comparison_table(const CaseStandings& one);

/// One line: which models are within the error bars of the reference in every case, and by how much
/// the others are beyond them. Empty when nothing was compared.
std::string comparison_verdict(const std::vector<CaseStandings>& cases);

/// compare.json: cases, models and how they stand; docs/commands.md has the layout.
std::string comparison_json(const ComparisonRecord& record);

/// compare.csv: the numbers, one row for each.
std::string comparison_csv(const ComparisonRecord& record);

}  // namespace rollfem::postprocess
