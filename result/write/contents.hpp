// SPDX-License-Identifier: LGPL-2.1-or-later
// A result as trees of named values, from the lists of members of its structs: what results.h5
// stores, summary.json sums up, the check of a record sees and Python gets. A run has one for its
// head, one for each model, and one for each load point.
#pragma once

#include "result/write/output.hpp"

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace rollfem::result {

/// Numbers in row-major order, in the memory of the result or in their own.
struct Array {
  enum class Type { real, single, whole, byte };
  Type type = Type::real;
  std::vector<std::size_t> shape;
  std::size_t count = 0;  ///< what the shape says, in a sound record
  const void* first = nullptr;
  std::shared_ptr<const void> own{};
  double at(std::size_t k) const;
};

using Value = std::variant<bool, long, double, std::string>;

/// An array, lines of text, or a text.
struct Entry {
  std::string name;
  std::variant<Array, std::vector<std::string>, std::string> values;
  std::string unit, description, sign;
};

struct Tree {
  std::string name, comment;
  std::vector<std::pair<std::string, Value>> attributes = {};
  std::vector<Entry> entries = {};
  std::vector<Tree> parts = {};
  std::optional<contact::Listed> listed = {};  ///< the parts, or rows of the entries, are a list
  std::string key = {};                        ///< Listed::by_first: what the names of parts are
  bool summed_up = true;                       ///< in summary.json, too
};

/// The WheelDips of a run as its part "dips"; empty without any.
Tree dips_tree(const RunRecord& run);

/// Verdict, quantities, documentation, case, provenance, profiles and dips of a run.
Tree head_tree(const RunRecord& run);

/// The keys that the case gives or that have a default, by path; without [[subsurface.*]].
Tree keys_tree(const contact::Case& input);

/// A model without its load points.
Tree model_tree(const contact::ModelResult& model, const contact::Case& input);

/// The load point, from 0, whose numbers stand for the model: the last pass over bodies that yield,
/// otherwise the first one at the largest normal force; 0 without a solution.
std::size_t headline(const contact::ModelResult& model);

/// A load point, counted from 0, with its fields if they are kept. A quantity that a point without
/// solution lacks is nan.
Tree point_tree(const contact::ModelResult& model, std::size_t number, bool with_fields);

/// Whether the fields on the grid of load point k are stored; each step of a wheel's history is a
/// result of its own.
bool keeps_grid(const contact::Case& input, const contact::ModelResult& model, std::size_t k);

Tree place_tree(const contact::ContactPlace& place);

/// Throws std::logic_error naming the field if the record holds a number that is not finite, a
/// field that does not fit its grid, or a model name that is empty, repeated or not a file name.
/// Such a result is a defect of its model and must not reach a file.
void check_record(const RunRecord& run);

}  // namespace rollfem::result
