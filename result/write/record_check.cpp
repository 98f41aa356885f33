// SPDX-License-Identifier: LGPL-2.1-or-later
#include "result/quantities.hpp"
#include "result/write/contents.hpp"

#include <fmt/core.h>

#include <cmath>
#include <functional>
#include <numeric>
#include <set>
#include <stdexcept>

namespace rollfem::result {
namespace {

void require(bool condition, const std::string& where, const std::string& what) {
  if (!condition) throw std::logic_error(fmt::format("result record: {} {}", where, what));
}

void require_finite(double value, const std::string& where) {
  if (!std::isfinite(value))
    require(false, where, fmt::format("is {}, which is not a finite number", value));
}

void check_model_name(const std::string& name, std::set<std::string>& seen) {
  const bool is_file_name =
      !name.empty() &&
      name.find_first_not_of(
          "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_+.") ==
          std::string::npos &&
      name.front() != '.';
  require(is_file_name, fmt::format("model name '{}'", name),
          "must be a file name of letters, digits and - _ + .");
  require(seen.insert(name).second, fmt::format("model '{}'", name), "occurs twice");
}

void check_array(const std::string& where, const Array& array) {
  const std::size_t expected =
      std::accumulate(array.shape.begin(), array.shape.end(), std::size_t{1}, std::multiplies<>());
  require(array.count == expected, where,
          fmt::format("has {} values, its places {}", array.count, expected));
  if (array.type == Array::Type::whole || array.type == Array::Type::byte) return;
  // Millions of numbers are checked, so only bad ones get a name.
  for (std::size_t k = 0; k < array.count; ++k)
    if (const double value = array.at(k); !std::isfinite(value))
      require_finite(value, fmt::format("{}[{}]", where, k * array.shape[0] / array.count));
}

/// `solved`: without a solution a load point has no numbers of its own.
void check_tree(const std::string& where, const Tree& tree, bool solved = true) {
  for (const auto& [name, value] : tree.attributes)
    if (const auto* number = std::get_if<double>(&value); number != nullptr && solved)
      require_finite(*number, where + "/" + name);
  for (const Entry& entry : tree.entries)
    if (const auto* array = std::get_if<Array>(&entry.values))
      check_array(where + "/" + entry.name, *array);
  for (const Tree& part : tree.parts) check_tree(where + "/" + part.name, part);
}

void check_cells(const std::string& where, const contact::BodyField& body) {
  for (const auto& cell : body.cells)
    for (const int corner : cell)
      if (corner < 0 || corner >= static_cast<int>(body.points.size()))
        require(false, where + "/cells",
                fmt::format("name point {} of {}", corner, body.points.size()));
}

}  // namespace

void check_record(const RunRecord& run) {
  std::set<std::string> names;
  for (const contact::ModelResult& model : run.models) {
    const std::string key = model.key();
    check_model_name(key, names);
    std::set<std::string> bodies;
    for (const contact::BodyField& body : model.bodies) {
      check_model_name(body.name, bodies);
      check_cells(key + "/bodies/" + body.name, body);
    }
    check_tree(key, model_tree(model, run.input));
    for (std::size_t k = 0; k < model.points.size(); ++k) {
      const std::string where = fmt::format("{}/points/{:04}", key, k);
      const std::size_t stored = model.points[k].bodies.size();
      require(stored == 0 || stored == model.bodies.size(), where + "/bodies",
              fmt::format("has {} entries for {} bodies", stored, model.bodies.size()));
      check_tree(where, point_tree(model, k, true), contact::is_solved(model.points[k]));
    }
  }
}

}  // namespace rollfem::result
