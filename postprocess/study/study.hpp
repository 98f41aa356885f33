// SPDX-License-Identifier: LGPL-2.1-or-later
// A refinement study as a record and as files: values per level, their errors against a reference,
// observed orders and limits. Layout of the files: docs/commands.md.
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
  double parameter = 0.0;  ///< the varied quantity as a number
  long unknowns = 0;
  int contact_elements = 0;
  double seconds = 0.0;  ///< wall time, error estimates included
  StudyValues values;
  StudyValues bars;    ///< the model's own error bars, absolute, for keys with an estimate
  double noise = 0.0;  ///< relative tolerance reached by its solver
};

/// One model, refined in one way.
struct StudySeries {
  std::string model;
  std::string vary;       ///< "grid", "cell", "degree", "domain", "grid and domain"; "" one level
  std::string parameter;  ///< "elements across", "FE cell in mm"
  /// Factor by which cells shrink (domains grow) from level to level; 0 if not meaningful.
  double ratio = 0.0;
  std::vector<StudyLevel> levels;  ///< coarsest first
  std::string failure;             ///< why levels failed; empty: none failed
  bool measures_others = false;    ///< models differ from it, if it has three levels
  bool limit_of_its_own = false;   ///< finite bodies do not tend to the closed form
  std::string left_out = {};       ///< coarse levels that do not fit the case, and why
};

enum class ReferenceRule {
  automatic,     ///< exact if there is such a value, otherwise extrapolated
  exact,         ///< Hertz
  finest,        ///< the finest level
  extrapolated,  ///< Richardson value of the series; its finest value without an order
};

/// What the errors of the levels of a series refer to: a property of its own model.
struct StudyReference {
  double value = 0.0;
  double uncertainty = 0.0;  ///< absolute; 0: exact or given
  std::string kind;          ///< "exact", "given", "extrapolated", "finest"
};

/// The study of one contact: of a case with radii, or of one patch of true profiles. Each has its
/// own limits.
struct StudyPlace {
  std::optional<contact::ContactPlace> place;  ///< of a patch; empty with radii
  std::vector<contact::Creepage> creepages;    ///< of the load points
  StudyValues exact;                           ///< Hertz's values, if they are valid
  StudyValues given;                           ///< given by the user; take precedence
  std::vector<StudySeries> series;
};

struct StudyRecord {
  Provenance provenance;
  std::string title;
  std::string case_file;
  std::string case_text;
  double friction = 0.0;
  ReferenceRule rule = ReferenceRule::automatic;
  std::vector<std::string> notes;  ///< remarks on all places
  std::vector<StudyPlace> places;
};

/// "left wheel, position 3, patch 1 of 2"; empty with radii.
std::string place_name(const StudyPlace& place);
/// "left_3_1"; empty with radii.
std::string place_key(const StudyPlace& place);

/// Index of the series from which other models differ: the half-space refined in its grid,
/// otherwise the first with three levels, otherwise the first. Throws std::logic_error without
/// series.
std::size_t reference_series(const StudyPlace& place);

/// References of all keys of a series. Unless a value is given or exact for it, its own limit.
std::map<std::string, StudyReference> references(const StudyPlace& place, const StudySeries& series,
                                                 ReferenceRule rule);

/// The limit of a model less that of reference_series: an effect of the theory, not of the grid.
struct ModelDifference {
  double value = 0.0;        ///< relative to the latter, for coefficients to that of friction
  double uncertainty = 0.0;  ///< of both limits, likewise
};
/// By key; empty for series of the same model.
std::map<std::string, ModelDifference> model_differences(const StudyRecord& record,
                                                         const StudyPlace& place,
                                                         const StudySeries& series);

/// Whether the key is a traction coefficient, whose errors are relative to the coefficient of
/// friction.
bool is_coefficient(const std::string& key);

/// Reference of percentage errors of the key: "value" or "mu".
const char* percent_of(const std::string& key);

/// |value - reference| relative to the reference, for coefficients relative to the coefficient of
/// friction.
double study_error(const StudyRecord& record, const std::string& key, double value,
                   const StudyReference& reference);

/// The model's own error bar.
std::optional<double> bar_of(const StudyLevel& level, const std::string& key);

/// Limit of one key of a series; empty with fewer than two levels or without a ratio.
std::optional<Limit> series_limit(const StudySeries& series, const std::string& key);

/// Orders at the levels of a series with the key: from the errors of a level and the previous one
/// if the reference is exact or given, otherwise from the last three values, because an
/// extrapolated reference would reproduce its own order.
std::vector<std::optional<double>> level_orders(const StudyRecord& record,
                                                const StudySeries& series, const std::string& key,
                                                const StudyReference& reference);

/// One line: errors of the finest levels, and the number of sequences of levels that show an order.
std::string study_verdict(const StudyRecord& record);

std::string study_json(const StudyRecord& record);
/// One row per place, series, level and key.
std::string study_csv(const StudyRecord& record);
/// Text for the terminal: a table for each series of each place, and the verdict.
std::string study_table(const StudyRecord& record);

}  // namespace rollfem::postprocess
