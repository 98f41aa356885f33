// SPDX-License-Identifier: LGPL-2.1-or-later
#include "postprocess/read/results_reader.hpp"

#include "contact/base/errors.hpp"
#include "contact/case/case_reader.hpp"
#include "contact/case/keys/case_keys.hpp"
#include "contact/result/quantities.hpp"
#include "contact/scene/geometry.hpp"
#include "postprocess/files/seal.hpp"
#include "postprocess/hdf5/hdf5_objects.hpp"
#include "postprocess/write/output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace fs = std::filesystem;

namespace rollfem::postprocess {
namespace {

using contact::BodyField;
using contact::BodyValues;
using contact::Field;
using contact::FileError;
using contact::InputError;
using contact::ModelResult;
using contact::PointResult;
using namespace hdf5;

const char* const again = "do: run the case again";

const char* const result_wanted = "name a result folder of rollfem run, or its results.h5";

/// The file meant by `path`, with the right checksum.
std::string sound_file(const std::string& path) {
  std::error_code error;
  const bool folder = fs::is_directory(path, error);
  std::string file = folder ? (fs::path(path) / "results.h5").string() : path;
  if (!hdf5_seal_is_intact(file, result_wanted))
    throw FileError(
        fmt::format("{} is truncated or damaged: its checksum is missing or does not match; {}, or "
                    "use a copy",
                    file, again));
  return file;
}

File open_checked(const std::string& path) {
  try {
    return open_file(path);
  } catch (const std::runtime_error&) {
    throw FileError(
        fmt::format("{} is truncated or damaged: HDF5 cannot open it; {}", path, again));
  }
}

void check_format(hid_t file, const std::string& path) {
  if (!has_attribute(file, "format") || read_text(file, "format") != "rollfem results")
    throw FileError(fmt::format(
        "{} is an HDF5 file, but not a result of rollfem; do: name the results.h5 of a run", path));
  const double version = read_number(file, "format_version");
  if (version != hdf5_format_version)
    throw FileError(fmt::format(
        "{} has format version {}, this program reads {}; do: run the case again with this "
        "version of rollfem, or read it with the version that wrote it ({})",
        path, version, hdf5_format_version, read_text(open_group(file, "provenance"), "version")));
  if (!has_attribute(file, "complete") || read_number(file, "complete") != 1.0)
    throw FileError(
        fmt::format("{} is incomplete, because writing it was interrupted; {}", path, again));
}

/// Runs `read` and turns errors of HDF5 and of the layout into one message with the file's name.
template <class Read>
auto guarded(const std::string& path, const Read& read) {
  try {
    return read();
  } catch (const InputError&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw FileError(
        fmt::format("{} cannot be read as a result of rollfem: {}; {}", path, error.what(), again));
  }
}

/// The case as its keys give it, without lists of words.
contact::Case read_case(hid_t file) {
  const Handle group = open_group(file, "case"), keys = open_group(group, "keys");
  const auto numbers = read_numbers(keys);
  const auto texts = read_texts(keys);
  contact::Case input;
  for (const contact::Key& key : contact::case_keys()) {
    if (const auto text = texts.find(key.path()); text != texts.end()) key.set(input, text->second);
    const bool listed = key.kind == contact::KeyKind::numbers;
    if (listed && has_member(keys, key.path()))
      key.set(input, read_dataset(keys, key.path()).values);
    const auto number = numbers.find(key.path());
    if (number == numbers.end()) continue;
    if (key.kind == contact::KeyKind::boolean)
      key.set(input, number->second != 0.0);
    else if (listed)
      key.set(input, std::vector<double>{number->second});
    else
      key.set(input, number->second);
  }
  input.title = read_text(group, "title");
  input.file = read_text(group, "file");
  for (const std::string& text : read_lines(group, "text")) input.text += text;
  return input;
}

std::optional<contact::ContactPlace> read_place(hid_t model) {
  if (!has_member(model, "place")) return {};
  const Handle group = open_group(model, "place");
  contact::ContactPlace place;
  place.left = read_text(group, "wheel") == "left";
  contact::for_members<contact::ContactPlace>([&](const auto& each) {
    using Part = decltype(each.part);
    if constexpr (std::is_member_object_pointer_v<Part> &&
                  std::decay_t<decltype(each)>::kept != contact::Kept::within)
      if (has_attribute(group, each.name))
        place.*each.part =
            static_cast<std::decay_t<decltype(place.*each.part)>>(read_number(group, each.name));
  });
  return place;
}

/// Load points of a model that store wheel and rail, from 0.
std::vector<std::size_t> points_with_bodies(hid_t model) {
  std::vector<std::size_t> found;
  if (!has_member(model, "bodies")) return found;
  const std::size_t count = members(open_group(model, "points")).size();
  for (std::size_t k = 0; k < count; ++k)
    if (has_member(open_group(model, fmt::format("points/{:04}", k)), "bodies")) found.push_back(k);
  return found;
}

std::vector<StoredModel> list_models(hid_t file) {
  const Handle all = open_group(file, "models");
  std::vector<std::pair<double, StoredModel>> found;
  for (const std::string& key : members(all)) {
    const Handle group = open_group(all, key);
    StoredModel model;
    model.key = key;
    model.name = has_attribute(group, "model") ? read_text(group, "model") : key;
    model.points_with_bodies = points_with_bodies(group);
    model.points = static_cast<int>(members(open_group(group, "points")).size());
    model.place = read_place(group);
    found.emplace_back(read_number(group, "order"), model);
  }
  std::sort(found.begin(), found.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<StoredModel> models;
  for (const auto& [order, model] : found) models.push_back(model);
  return models;
}

contact::ContactGrid read_grid(hid_t model) {
  const Handle group = open_group(model, "grid");
  const std::vector<double> x = read_dataset(group, "x").values;
  const std::vector<double> y = read_dataset(group, "y").values;
  contact::ContactGrid grid;
  grid.nx = static_cast<int>(x.size());
  grid.ny = static_cast<int>(y.size());
  grid.dx = read_number(group, "dx");
  grid.dy = read_number(group, "dy");
  if (!x.empty()) grid.x_first = x.front();
  if (!y.empty()) grid.y_first = y.front();
  return grid;
}

void read_quantities(hid_t group, PointResult& point) {
  for (const contact::Quantity& quantity : contact::quantities())
    if (has_attribute(group, quantity.name))
      quantity.member.set(point, read_number(group, quantity.name));
    else if (!quantity.member.may_be_absent)
      throw std::runtime_error(fmt::format("there is no attribute {}", quantity.name));
}

std::map<std::string, double> read_by_name(hid_t parent, const char* name) {
  return has_member(parent, name) ? read_numbers(open_group(parent, name))
                                  : std::map<std::string, double>{};
}

void read_fields(hid_t point, const contact::ContactGrid& grid, contact::ContactFields& fields) {
  const auto check = [&](const Numbers& numbers, const char* name) {
    if (numbers.values.size() != static_cast<std::size_t>(grid.size()))
      throw std::runtime_error(fmt::format("dataset {} has {} values for a grid of {}", name,
                                           numbers.values.size(), grid.size()));
  };
  for (const contact::PointField& field : contact::point_fields()) {
    if (!has_member(point, field.name)) continue;
    const Numbers numbers = read_dataset(point, field.name);
    check(numbers, field.name);
    field.member(fields) = Eigen::Map<const Field>(numbers.values.data(), grid.size());
  }
  if (!has_member(point, "state")) return;
  const Numbers state = read_dataset(point, "state");
  check(state, "state");
  for (const double s : state.values)
    fields.state.push_back(static_cast<contact::ElementState>(static_cast<unsigned char>(s)));
}

std::vector<contact::StressMaximum> read_maxima(hid_t point) {
  if (!has_member(point, "stress_maxima")) return {};
  const Handle group = open_group(point, "stress_maxima");
  const std::vector<std::string> body = read_lines(group, "body");
  const std::vector<std::string> measure = read_lines(group, "measure");
  const std::vector<double> value = read_dataset(group, "value").values;
  const auto place = read_rows<3>(group, "place");
  if (measure.size() != body.size() || value.size() != body.size() || place.size() != body.size())
    throw std::runtime_error("columns of different length in stress_maxima");
  std::vector<contact::StressMaximum> maxima;
  for (std::size_t k = 0; k < body.size(); ++k)
    maxima.push_back({body[k], measure[k], value[k], place[k]});
  return maxima;
}

PointResult read_point(hid_t group, const contact::ContactGrid& grid) {
  PointResult point;
  read_quantities(group, point);
  point.error_estimate = read_by_name(group, "error_estimate");
  point.model_error = read_by_name(group, "model_error");
  point.richardson = read_by_name(group, "richardson");
  if (has_member(group, "no_bar")) point.no_bar = read_texts(open_group(group, "no_bar"));
  read_fields(group, grid, point.fields);
  point.stress_maxima = read_maxima(group);
  return point;
}

BodyField read_mesh(hid_t bodies, const std::string& name) {
  const Handle group = open_group(bodies, name);
  BodyField body;
  body.name = name;
  body.points = read_rows<3>(group, "points");
  const double nodes = static_cast<double>(body.points.size());
  for (const auto& row : read_rows<8>(group, "cells")) {
    std::array<int, 8> cell{};
    for (std::size_t k = 0; k < 8; ++k) {
      if (!(row[k] >= 0.0 && row[k] < nodes))
        throw std::runtime_error(
            fmt::format("a cell of the {} names node {} of {}", name, row[k], body.points.size()));
      cell[k] = static_cast<int>(row[k]);
    }
    body.cells.push_back(cell);
  }
  return body;
}

/// Nodes and cells.
std::vector<BodyField> read_mesh_of_bodies(hid_t model) {
  if (!has_member(model, "bodies")) return {};
  const Handle all = open_group(model, "bodies");
  std::vector<BodyField> bodies;
  for (const char* name : {"wheel", "rail"})
    if (has_member(all, name)) bodies.push_back(read_mesh(all, name));
  return bodies;
}

/// Displacement and stress of `bodies` at a load point of points_with_bodies().
std::vector<BodyValues> read_body_values(hid_t model, std::size_t point,
                                         const std::vector<BodyField>& bodies) {
  const Handle all = open_group(model, fmt::format("points/{:04}/bodies", point));
  std::vector<BodyValues> values;
  for (const BodyField& body : bodies) {
    const Handle group = open_group(all, body.name);
    values.push_back(
        {read_rows<3, float>(group, "displacement"), read_rows<6, float>(group, "stress")});
    if (values.back().displacement.size() != body.points.size() ||
        values.back().stress.size() != body.points.size())
      throw std::runtime_error(
          fmt::format("nodes and values of the {} differ in number", body.name));
  }
  return values;
}

}  // namespace

ResultsFile::ResultsFile(const std::string& path) : path_(sound_file(path)) {
  const File file = open_checked(path_);
  guarded(path_, [&] {
    check_format(file, path_);
    input_ = read_case(file);
    models_ = list_models(file);
  });
}

ModelResult ResultsFile::read(const StoredModel& model) const {
  const File file = open_checked(path_);
  return guarded(path_, [&] {
    const Handle group = open_group(open_group(file, "models"), model.key);
    ModelResult result;
    result.name = model.name;
    if (has_attribute(group, "label")) result.label = read_text(group, "label");
    if (has_attribute(group, "model_error_source"))
      result.model_error_source = read_text(group, "model_error_source");
    result.unknowns = static_cast<long>(read_number(group, "unknowns"));
    result.contact_elements = static_cast<int>(read_number(group, "contact_elements"));
    result.notes = read_lines(group, "notes");
    result.place = model.place;
    result.seconds = read_by_name(group, "seconds");
    result.grid = read_grid(group);
    if (result.grid.ny == 1 && !input_.text.empty()) {  // perhaps without ends
      const contact::Geometry geometry(contact::parse_case(input_.text, input_.file));
      if (geometry.line) result.grid.line_reference = geometry.line->reference;
    }
    const Handle points = open_group(group, "points");
    for (const std::string& number : members(points))
      result.points.push_back(read_point(open_group(points, number), result.grid));
    result.bodies = read_mesh_of_bodies(group);
    return result;
  });
}

void ResultsFile::read_bodies(const StoredModel& model, std::size_t point,
                              ModelResult& result) const {
  const File file = open_checked(path_);
  guarded(path_, [&] {
    const Handle group = open_group(open_group(file, "models"), model.key);
    result.points.at(point).bodies = read_body_values(group, point, result.bodies);
  });
}

}  // namespace rollfem::postprocess
