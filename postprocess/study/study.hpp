// SPDX-License-Identifier: LGPL-2.1-or-later
// A refinement study as a record and as files: values level by level, their errors against a
// reference, observed orders and limits. Layout of the files: docs/commands.md.
#pragma once

#include "postprocess/study/convergence.hpp"
#include "postprocess/write/output.hpp"

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rollfem::postprocess {

/// Values by key: "max_pressure", "semi_axis_x", "semi_axis_y" (of true profiles "contact_length",
/// "contact_width"), "approach" of the first load point, "traction_coefficient:4" of the fourth.
using StudyValues = std::map<std::string, double>;

struct StudyLevel {
  std::string label;       ///< "40 across", "0.47 mm"
  double parameter = 0.0;  ///< what is varied, as a number
  long unknowns = 0;
  int contact_elements = 0;
  double seconds = 0.0;  ///< as a user waits for it, error estimates included
  StudyValues values;
  StudyValues bars;    ///< absolute, the model's own; of keys that it has an estimate of
  double noise = 0.0;  ///< what its solver ended at, relative
};

/// One model, refined in one way.
struct StudySeries {
  std::string model;
  std::string vary;       ///< "grid", "cell", "degree", "domain", "grid and domain"; "" one level
  std::string parameter;  ///< "elements across", "FE cell in mm"
  /// By which cells shrink (domains grow) from level to level; 0 where that has no meaning.
  double ratio = 0.0;
  std::vector<StudyLevel> levels;  ///< coarsest first
  std::string failure;             ///< of levels that should have a result; empty: none
  bool measures_others = false;    ///< the others are held against it where it has three levels
  bool limit_of_its_own = false;   ///< finite bodies do not tend to the closed form
  std::string left_out = {};       ///< coarse levels that the case cannot be laid out on, and why
};

enum class ReferenceRule {
  automatic,     ///< exact where there is such a value, else extrapolated
  exact,         ///< Hertz
  finest,        ///< the finest level
  extrapolated,  ///< Richardson value of the series; its finest where it shows no order
};

struct StudyReference {
  double value = 0.0;
  double uncertainty = 0.0;  ///< absolute; 0: exact, or given
  std::string kind;          ///< "exact", "given", "extrapolated", "finest"
};

/// What is studied at one contact: that of a case with radii, or one patch of true profiles. Each
/// has limits of its own.
struct StudyPlace {
  std::optional<contact::ContactPlace> place;  ///< of a patch; none with radii
  std::vector<contact::Creepage> creepages;    ///< of the load points
  StudyValues exact;                           ///< Hertz, where it holds
  StudyValues given;                           ///< of the user; take precedence
  std::vector<StudySeries> series;
  /// Accuracy in percent -> which model and grid meet it, in a sentence.
  std::vector<std::pair<double, std::string>> choice;
};

struct StudyRecord {
  Provenance provenance;
  std::string title;
  std::string case_file;
  std::string case_text;
  double friction = 0.0;
  ReferenceRule rule = ReferenceRule::automatic;
  std::vector<std::string> notes;  ///< what a reader must know of all places
  std::vector<StudyPlace> places;
};

/// "left wheel, position 3, patch 1 of 2"; empty with radii.
std::string place_name(const StudyPlace& place);
/// "left_3_1"; empty with radii.
std::string place_key(const StudyPlace& place);

/// Index of the series whose levels are the reference for all: the half-space refined in its grid,
/// else the first with three levels, else the first. Throws std::logic_error without series.
std::size_t reference_series(const StudyPlace& place);

/// Reference of every key that any level has.
std::map<std::string, StudyReference> references(const StudyPlace& place, ReferenceRule rule);

/// The key is a traction coefficient, whose errors are relative to the coefficient of friction.
bool is_coefficient(const std::string& key);

/// What errors of the key are percent of: "value", "mu".
const char* percent_of(const std::string& key);

/// Whether the finest value of a series is itself the reference: it then shows no error.
bool is_reference(const StudyPlace& place, const StudySeries& series,
                  const StudyReference& reference);

/// |value - reference|, relative to the reference, of coefficients to the coefficient of friction.
double study_error(const StudyRecord& record, const std::string& key, double value,
                   const StudyReference& reference);

/// Limit of one key of a series; none with fewer than two levels or without a ratio.
std::optional<Limit> series_limit(const StudySeries& series, const std::string& key);

/// Orders at the levels of a series that have the key: from the errors of a level and the one
/// before where the reference is exact or given, else from the last three values, since an
/// extrapolated reference would give back the order that it was made with.
std::vector<std::optional<double>> level_orders(const StudyRecord& record,
                                                const StudySeries& series, const std::string& key,
                                                const StudyReference& reference);

/// One line: how far the finest levels are off, and how many sequences of levels show an order.
std::string study_verdict(const StudyRecord& record);

std::string study_json(const StudyRecord& record);
/// One row per place, series, level and key.
std::string study_csv(const StudyRecord& record);
/// For the terminal: a table for each series of each place, and the verdict.
std::string study_table(const StudyRecord& record);

}  // namespace rollfem::postprocess
