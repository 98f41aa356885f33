// SPDX-License-Identifier: LGPL-2.1-or-later
#include "postprocess/write/stored_bodies.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>

namespace rollfem::postprocess {
namespace {

using contact::BodyField;
using contact::BodyValues;
using namespace hdf5;

std::string group_of(std::size_t point) {
  return fmt::format("points/{:04}/bodies", point);
}

void write_mesh(hid_t group, const BodyField& body) {
  write_rows(group, "points", body.points, "mm",
             "x, y, z of the undeformed nodes in the global frame, z into the wheel");
  write_rows(group, "cells", body.cells, "-", "nodes of every hexahedron, from 0, in VTK's order");
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

}  // namespace

void write_body_values(hid_t point, const std::vector<BodyField>& bodies,
                       const contact::PointResult& result) {
  if (result.bodies.empty()) return;
  const Handle all = create_group(point, "bodies",
                                  "Wheel and rail under this load: values at the nodes of "
                                  "../../bodies; between them trilinear");
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const Handle group = create_group(all, bodies[k].name, "The whole segment, both halves");
    write_rows(group, "displacement", result.bodies.at(k).displacement, "mm",
               "displacement of the nodes, x, y, z");
    write_rows(group, "stress", result.bodies.at(k).stress, "MPa",
               "stress: xx, yy, zz, xy, yz, xz; tension positive");
  }
}

void write_bodies(hid_t model, const contact::ModelResult& result) {
  const std::vector<std::size_t> kept = result.points_with_bodies();
  if (kept.empty()) return;
  const Handle all =
      create_group(model, "bodies",
                   "Wheel and rail: nodes and hexahedra; displacement and stress are links to the "
                   "load point in the attribute load_point (from 0)");
  write_attribute(all, "load_point", static_cast<long>(kept.back()));
  for (const BodyField& body : result.bodies) {
    const Handle group = create_group(all, body.name, "The whole segment, both halves");
    write_mesh(group, body);
    for (const char* name : {"displacement", "stress"})
      link(model, fmt::format("{}/{}/{}", group_of(kept.back()), body.name, name), group, name);
  }
}

std::vector<std::size_t> points_with_bodies(hid_t model) {
  std::vector<std::size_t> found;
  if (!has_member(model, "bodies")) return found;
  const std::size_t count = members(open_group(model, "points")).size();
  for (std::size_t k = 0; k < count; ++k)
    if (has_member(open_group(model, fmt::format("points/{:04}", k)), "bodies")) found.push_back(k);
  return found;
}

std::vector<BodyField> read_bodies(hid_t model) {
  if (!has_member(model, "bodies")) return {};
  const Handle all = open_group(model, "bodies");
  std::vector<BodyField> bodies;
  for (const char* name : {"wheel", "rail"})
    if (has_member(all, name)) bodies.push_back(read_mesh(all, name));
  return bodies;
}

std::vector<BodyValues> read_body_values(hid_t model, std::size_t point,
                                         const std::vector<BodyField>& bodies) {
  const Handle all = open_group(model, group_of(point));
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

}  // namespace rollfem::postprocess
