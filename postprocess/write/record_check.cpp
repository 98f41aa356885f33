// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/result/quantities.hpp"
#include "postprocess/write/output.hpp"
#include "postprocess/write/point_table.hpp"

#include <fmt/core.h>

#include <cmath>
#include <set>
#include <stdexcept>

namespace rollfem::postprocess {
namespace {

void require(bool condition, const std::string& where, const std::string& what) {
  if (!condition) throw std::logic_error(fmt::format("result record: {} {}", where, what));
}

void require_finite(double value, const std::string& where) {
  if (std::isfinite(value)) return;
  require(false, where, fmt::format("is {}, which is not a finite number", value));
}

/// The same for entry k. Millions of entries are checked, so only bad ones get a name.
void require_finite(double value, const std::string& where, std::size_t k) {
  if (!std::isfinite(value)) require_finite(value, fmt::format("{}[{}]", where, k));
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

void check_fields(const std::string& where, const contact::ContactGrid& grid,
                  const contact::ContactFields& fields) {
  for (const PointField& field : point_fields()) {
    const contact::Field& values = field.value(fields);
    const std::string name = fmt::format("{}/{}", where, field.name);
    require(values.size() == 0 || values.size() == grid.size(), name,
            fmt::format("has {} values, its grid {}", values.size(), grid.size()));
    for (Eigen::Index k = 0; k < values.size(); ++k)
      require_finite(values[k], name, static_cast<std::size_t>(k));
  }
  require(fields.state.empty() || static_cast<int>(fields.state.size()) == grid.size(),
          where + "/state", fmt::format("has {} values", fields.state.size()));
}

template <class Vectors>
void check_vectors(const std::string& where, const Vectors& vectors, std::size_t count) {
  require(vectors.empty() || vectors.size() == count, where,
          fmt::format("has {} entries for {} points", vectors.size(), count));
  for (std::size_t k = 0; k < vectors.size(); ++k)
    for (const double value : vectors[k]) require_finite(value, where, k);
}

void check_point(const std::string& where, const contact::ContactGrid& grid,
                 const contact::PointResult& point) {
  for (const contact::Quantity& quantity : contact::quantities()) {
    const bool may_be_absent = quantity.member.may_be_absent || !contact::is_solved(point);
    require_finite(quantity.value(point).value_or(may_be_absent ? 0.0 : std::nan("")),
                   fmt::format("{}/{}", where, quantity.name));
  }
  for (const auto& [quantity, error] : point.error_estimate)
    require_finite(error, fmt::format("{}/error_estimate/{}", where, quantity));
  for (const auto& [quantity, error] : point.model_error)
    require_finite(error, fmt::format("{}/model_error/{}", where, quantity));
  for (const auto& [quantity, value] : point.richardson)
    require_finite(value, fmt::format("{}/richardson/{}", where, quantity));
  check_fields(where, grid, point.fields);
  for (const contact::StressMaximum& maximum : point.stress_maxima) {
    const std::string name =
        fmt::format("{}/stress_maxima/{}/{}", where, maximum.body, maximum.measure);
    require_finite(maximum.value, name);
    for (const double coordinate : maximum.place) require_finite(coordinate, name + "/place");
  }
  for (const contact::YieldedSection& body : point.yielded) {
    const std::string name = fmt::format("{}/yielded/{}", where, body.body);
    for (const auto& [scalar, value] : contact::scalars_of(body))
      require_finite(value, name + "/" + scalar);
    check_vectors(name + "/strain", body.strain, body.depth.size());
    check_vectors(name + "/stress", body.stress, body.depth.size());
  }
  for (std::size_t k = 0; k < point.subsurface.size(); ++k) {
    const contact::SubsurfaceField& field = point.subsurface[k];
    const std::string name = fmt::format("{}/subsurface[{}]", where, k);
    check_vectors(name + "/displacement", field.displacement, field.points.size());
    check_vectors(name + "/stress", field.stress, field.points.size());
  }
}

void check_body(const std::string& where, const contact::BodyField& body) {
  check_vectors(where + "/points", body.points, body.points.size());
  for (const auto& cell : body.cells)
    for (const int corner : cell)
      if (corner < 0 || corner >= static_cast<int>(body.points.size()))
        require(false, where + "/cells",
                fmt::format("name point {} of {}", corner, body.points.size()));
}

/// A load point must store the values of all bodies or of none.
void check_body_values(const std::string& where, const std::vector<contact::BodyField>& bodies,
                       const std::vector<contact::BodyValues>& values) {
  if (values.empty()) return;
  require(values.size() == bodies.size(), where + "/bodies",
          fmt::format("has {} entries for {} bodies", values.size(), bodies.size()));
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const std::string name = fmt::format("{}/{}", where, bodies[b].name);
    const std::size_t count = bodies[b].points.size();
    require(values[b].displacement.size() == count && values[b].stress.size() == count, name,
            fmt::format("does not have {} values, one for each point", count));
    check_vectors(name + "/displacement", values[b].displacement, count);
    check_vectors(name + "/stress", values[b].stress, count);
  }
}

}  // namespace

void check_record(const RunRecord& run) {
  std::set<std::string> names;
  for (const contact::ModelResult& model : run.models) {
    const std::string key = model.key();
    check_model_name(key, names);
    for (const auto& [stage, seconds] : model.seconds)
      require_finite(seconds, fmt::format("{}/seconds/{}", key, stage));
    for (const double value :
         {model.grid.dx, model.grid.dy, model.grid.x_first, model.grid.y_first})
      require_finite(value, key + "/grid");
    for (const contact::Field* places :
         {&model.rows.y_wheel, &model.rows.y_rail, &model.rows.width})
      for (const double value : *places) require_finite(value, key + "/grid");
    for (std::size_t k = 0; k < model.points.size(); ++k) {
      const std::string where = fmt::format("{}/points[{}]", key, k);
      check_point(where, model.grid, model.points[k]);
      check_body_values(where, model.bodies, model.points[k].bodies);
    }
    if (model.place)
      for (const PlaceScalar& scalar : place_scalars())
        require_finite(scalar.value(*model.place), fmt::format("{}/place/{}", key, scalar.name));
    std::set<std::string> bodies;
    for (const contact::BodyField& body : model.bodies) {
      check_model_name(body.name, bodies);
      check_body(fmt::format("{}/{}", key, body.name), body);
    }
  }
}

}  // namespace rollfem::postprocess
