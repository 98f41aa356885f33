// SPDX-License-Identifier: LGPL-2.1-or-later
#include "postprocess/write/record_check.hpp"

#include <fmt/core.h>

#include <set>
#include <stdexcept>

namespace rollfem::postprocess {
namespace {

void require(bool condition, const std::string& where, const std::string& what) {
  if (!condition) throw std::logic_error(fmt::format("result record: {} {}", where, what));
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

/// A load point must store the values of all bodies or of none.
void check_bodies(const contact::ModelResult& model) {
  std::set<std::string> names;
  for (const contact::BodyField& body : model.bodies) {
    check_model_name(body.name, names);
    for (const auto& cell : body.cells)
      for (const int corner : cell)
        if (corner < 0 || corner >= static_cast<int>(body.points.size()))
          require(false, body.name,
                  fmt::format("names point {} of {}", corner, body.points.size()));
  }
  for (const contact::PointResult& point : model.points) {
    require(point.bodies.empty() || point.bodies.size() == model.bodies.size(), model.key(),
            fmt::format("has values of {} bodies, not {}", point.bodies.size(), names.size()));
    for (std::size_t b = 0; b < point.bodies.size(); ++b)
      require(point.bodies[b].stress.size() == model.bodies[b].points.size(), model.bodies[b].name,
              "does not have one value for each point");
  }
}

}  // namespace

void check_record(const RunRecord& run) {
  std::set<std::string> names;
  for (const contact::ModelResult& model : run.models) {
    check_model_name(model.key(), names);
    check_bodies(model);
  }
}

}  // namespace rollfem::postprocess
