// SPDX-License-Identifier: LGPL-2.1-or-later
#include "meshes/msh_parts.hpp"

#include "base/errors.hpp"
#include "base/text_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace rollfem::meshes {

namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

constexpr int quadrilateral_corners = 4;
constexpr int hexahedron_corners = 8;
/// mm: exceeded by meshes in micrometres or with garbage.
constexpr double farthest = 1e9;

/// gmsh's names and numbers.
const std::map<std::int64_t, MshKind> kinds{
    {1, {1, 2, "Line 2"}},           {2, {2, 3, "Triangle 3"}},
    {3, {2, 4, "Quadrilateral 4"}},  {4, {3, 4, "Tetrahedron 4"}},
    {5, {3, 8, "Hexahedron 8"}},     {6, {3, 6, "Prism 6"}},
    {7, {3, 5, "Pyramid 5"}},        {8, {1, 3, "Line 3"}},
    {9, {2, 6, "Triangle 6"}},       {10, {2, 9, "Quadrilateral 9"}},
    {11, {3, 10, "Tetrahedron 10"}}, {12, {3, 27, "Hexahedron 27"}},
    {13, {3, 18, "Prism 18"}},       {14, {3, 14, "Pyramid 14"}},
    {15, {0, 1, "Point"}},           {16, {2, 8, "Quadrilateral 8"}},
    {17, {3, 20, "Hexahedron 20"}},  {18, {3, 15, "Prism 15"}},
    {19, {3, 13, "Pyramid 13"}},     {20, {2, 9, "Triangle 9"}},
    {21, {2, 10, "Triangle 10"}},    {26, {1, 4, "Line 4"}},
    {29, {3, 20, "Tetrahedron 20"}}, {36, {2, 16, "Quadrilateral 16"}},
    {92, {3, 64, "Hexahedron 64"}}};

}  // namespace

MshBytes::MshBytes(const std::string& path, std::string name) : name_(std::move(name)) {
  constexpr std::size_t largest_file = 20'000'000'000;
  bytes_ =
      contact::text_of_file(path, name_, largest_file,
                            "name a gmsh mesh file (.msh), its path relative to the case file");
}

void MshBytes::fail_file(const std::string& wrong, const std::string& action) const {
  throw contact::InputError(fmt::format("{}: {}; do: {}", name_, wrong, action));
}

void MshBytes::fail_at(std::size_t place, const std::string& wrong,
                       const std::string& action) const {
  if (format_.binary) fail_file(fmt::format("byte {}: {}", place, wrong), action);
  const auto end = bytes_.begin() + static_cast<std::ptrdiff_t>(std::min(place, bytes_.size()));
  fail_file(fmt::format("line {}: {}", 1 + std::count(bytes_.begin(), end, '\n'), wrong), action);
}

bool MshBytes::at_end() {
  while (next_ < bytes_.size() && is_blank(bytes_[next_])) ++next_;
  place_ = next_;
  return next_ == bytes_.size();
}

std::string_view MshBytes::line() {
  place_ = next_;
  const std::size_t end = std::min(bytes_.find('\n', next_), bytes_.size());
  const std::string_view text = std::string_view(bytes_).substr(next_, end - next_);
  next_ = std::min(end + 1, bytes_.size());
  return contact::trimmed(text);
}

bool MshBytes::pass(std::string_view text) {
  for (std::size_t found = bytes_.find(text, next_); found != std::string::npos;
       found = bytes_.find(text, found + 1)) {
    const std::size_t end = found + text.size();
    if (found == 0 || bytes_[found - 1] != '\n' || (end < bytes_.size() && !is_blank(bytes_[end])))
      continue;
    next_ = end;
    return true;
  }
  return false;
}

std::string_view MshBytes::token(const char* what) {
  if (at_end()) fail(fmt::format("the file ends before {}", what), save_msh_again);
  while (next_ < bytes_.size() && !is_blank(bytes_[next_])) ++next_;
  return std::string_view(bytes_).substr(place_, next_ - place_);
}

template <class Number>
Number MshBytes::raw(const char* what) {
  place_ = next_;
  Number number{};
  if (bytes_.size() - next_ < sizeof number)
    fail(fmt::format("the file ends before {}", what), save_msh_again);
  std::memcpy(&number, bytes_.data() + next_, sizeof number);
  next_ += sizeof number;
  return number;
}

std::int64_t MshBytes::from_text(const char* what) {
  const std::string_view text = token(what);
  std::int64_t number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || stop != end)
    fail(fmt::format("`{}` is not {}, a whole number", contact::printable(text), what),
         save_msh_again);
  return number;
}

std::int64_t MshBytes::checked(std::int64_t number, const char* what, std::int64_t least,
                               std::int64_t most) const {
  if (number >= least && number <= most) return number;
  fail(fmt::format("{} is {}; allowed: {} to {}", what, number, least, most), save_msh_again);
}

std::int64_t MshBytes::integer(const char* what, std::int64_t least, std::int64_t most) {
  return checked(format_.binary ? raw<std::int32_t>(what) : from_text(what), what, least, most);
}

std::int64_t MshBytes::large(const char* what, std::int64_t least, std::int64_t most) {
  if (!format_.binary || format_.old || format_.count_bytes == sizeof(std::int32_t))
    return integer(what, least, most);
  return checked(raw<std::int64_t>(what), what, least, most);
}

std::size_t MshBytes::count(const char* what, std::size_t text_bytes, std::size_t binary_bytes) {
  std::int64_t number = 0;
  if (format_.old) {  // also a line of text before binary numbers
    number = checked(from_text(what), what, 0, INT64_MAX);
    const std::size_t begin = place_;
    line();
    place_ = begin;
  } else {
    number = large(what, 0, INT64_MAX);
  }
  const std::size_t each = format_.binary ? binary_bytes : text_bytes;
  // The last number of a text may be followed by the end of the file instead of a blank.
  const std::size_t most = (bytes_.size() - next_ + 1) / each;
  if (static_cast<std::uint64_t>(number) > most)
    fail(fmt::format("{} is {}, but the rest of the file has room for at most {}", what, number,
                     most),
         save_msh_again);
  return static_cast<std::size_t>(number);
}

double MshBytes::real(const char* what) {
  if (format_.binary) return raw<double>(what);
  std::string_view text = token(what);
  if (text.size() > 1 && text.front() == '+') text.remove_prefix(1);
  double number = 0.0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (stop != end || error == std::errc::invalid_argument)
    fail(fmt::format("`{}` is not {}, a number", contact::printable(text), what), save_msh_again);
  // Out of range of a double: underflow gives 0, overflow fails like infinity.
  if (error == std::errc::result_out_of_range)
    return text.find("e-") == text.npos && text.find("E-") == text.npos ? HUGE_VAL : 0.0;
  return number;
}

const MshKind& MshElements::kind(std::int64_t type) const {
  const auto found = kinds.find(type);
  if (found == kinds.end())
    bytes_.fail(fmt::format("gmsh's element type {} is not supported; allowed: 1 (lines), 3 "
                            "(quadrilaterals), 5 (hexahedra), 15 (points)",
                            type),
                "mesh with hexahedra of order 1");
  if (found->second.dimension == 3 && found->second.nodes != hexahedron_corners)
    bytes_.fail(fmt::format("there are cells of type {}; allowed: hexahedra with 8 corners",
                            found->second.name),
                "mesh with hexahedra of order 1 (transfinite, or an extruded recombined section)");
  return found->second;
}

void MshElements::add_node(std::int64_t number, const std::array<double, 3>& coordinates) {
  for (const double c : coordinates)
    if (!(std::abs(c) <= farthest))
      bytes_.fail(fmt::format("node {} is at ({}, {}, {}) mm; allowed: magnitudes up to {:g}",
                              number, coordinates[0], coordinates[1], coordinates[2], farthest),
                  "save the mesh again, in mm");
  if (!index_.try_emplace(number, static_cast<int>(points_.size())).second)
    bytes_.fail(fmt::format("there are two nodes with the number {}", number),
                "renumber the nodes (in gmsh Renumber Mesh Nodes)");
  points_.push_back(coordinates);
}

void MshElements::add(std::int64_t number, const MshKind& kind, int group,
                      const std::vector<std::int64_t>& nodes) {
  std::array<int, 8> corners{};
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const auto found = index_.find(nodes[k]);
    if (found == index_.end())
      bytes_.fail(
          fmt::format(
              "element {} refers to node {}, which does not exist; allowed: nodes listed in $Nodes",
              number, nodes[k]),
          save_msh_again);
    if (k < corners.size()) corners[k] = found->second;
  }
  if (kind.dimension == 2)
    faces_[group].push_back(
        {bytes_.place(), kind.nodes, {corners[0], corners[1], corners[2], corners[3]}});
  // In 2.2 a cell is repeated with another number for each physical group that it belongs to.
  if (kind.dimension == 3 && (!bytes_.format().old || once_.insert(corners).second))
    cells_.push_back(corners);
}

HexMesh MshElements::mesh(const std::function<std::vector<Side>(int group)>& side_of) const {
  HexMesh mesh;
  std::vector<int> number(points_.size(), -1);
  for (std::array<int, 8> cell : cells_) {
    for (int& corner : cell) {
      int& own = number[static_cast<std::size_t>(corner)];
      if (own < 0) {
        own = static_cast<int>(mesh.points.size());
        mesh.points.push_back(points_[static_cast<std::size_t>(corner)]);
      }
      corner = own;
    }
    mesh.cells.push_back(cell);
  }
  for (const auto& [group, faces] : faces_)
    for (const Side side : side_of(group))
      for (const Face& face : faces) {
        const char* const name = side_names[static_cast<std::size_t>(side)];
        if (face.count != quadrilateral_corners)
          bytes_.fail_at(
              face.place,
              fmt::format("the group `{}` has faces that are not quadrilaterals with 4 corners",
                          name),
              "recombine the surface mesh");
        SideQuad quad{face.corners, side};
        for (int& corner : quad.corners) {
          corner = number[static_cast<std::size_t>(corner)];
          if (corner < 0)
            bytes_.fail_at(
                face.place,
                fmt::format("the group `{}` has a face that is not a face of a hexahedron", name),
                "save the volume cells too: put the volume into a physical group (gmsh "
                "then saves it), or set Mesh.SaveAll = 1");
        }
        mesh.sides.push_back(quad);
      }
  return mesh;
}

}  // namespace rollfem::meshes
