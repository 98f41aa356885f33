// SPDX-License-Identifier: LGPL-2.1-or-later
#include "result/write/vtu.hpp"

#include "base/threads.hpp"
#include "result/stress_measures.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <numeric>
#include <stdexcept>
#include <string_view>
#include <vector>
#include <zlib.h>

namespace rollfem::result {
namespace {

using contact::Field;

std::string base64(std::string_view bytes) {
  static const char* const letters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    const auto byte = [&](std::size_t offset) -> std::uint32_t {
      return k + offset < bytes.size() ? static_cast<unsigned char>(bytes[k + offset]) : 0U;
    };
    const std::uint32_t bits = byte(0) << 16U | byte(1) << 8U | byte(2);
    text += letters[bits >> 18U & 63U];
    text += letters[bits >> 12U & 63U];
    text += k + 1 < bytes.size() ? letters[bits >> 6U & 63U] : '=';
    text += k + 2 < bytes.size() ? letters[bits & 63U] : '=';
  }
  return text;
}

std::string deflate(std::string_view bytes) {
  uLongf size = compressBound(bytes.size());
  std::string out(size, '\0');
  const int status = compress2(reinterpret_cast<Bytef*>(out.data()), &size,
                               reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), 1);
  if (status != Z_OK) throw std::runtime_error(fmt::format("zlib: compress2 gave {}", status));
  out.resize(size);
  return out;
}

template <class T>
std::string_view as_bytes(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

/// VTK's layout: number of blocks, block size, size of a last partial block, compressed sizes; then
/// the compressed blocks.
std::string encode(std::string_view bytes) {
  constexpr std::size_t block = 1U << 18U;
  const std::size_t blocks = (bytes.size() + block - 1) / block;
  std::vector<std::uint64_t> sizes{blocks, block, bytes.size() % block};
  std::vector<std::string> parts(blocks);
  contact::for_each_index(
      blocks, [&](std::size_t k) { parts[k] = deflate(bytes.substr(k * block, block)); });
  std::string packed;
  for (const std::string& one : parts) {
    sizes.push_back(one.size());
    packed += one;
  }
  return base64(as_bytes(sizes)) + base64(packed);
}

template <class Number>
constexpr const char* type_name = "Float64";
template <>
constexpr const char* type_name<float> = "Float32";
template <>
constexpr const char* type_name<std::int32_t> = "Int32";
template <>
constexpr const char* type_name<std::int64_t> = "Int64";
template <>
constexpr const char* type_name<std::uint8_t> = "UInt8";

template <class Number>
std::string numbers(const std::string& name, const std::vector<Number>& values,
                    const std::vector<std::string>& components = {}) {
  std::string attributes;
  if (!components.empty())
    attributes += fmt::format(" NumberOfComponents=\"{}\"", components.size());
  for (std::size_t k = 0; k < components.size(); ++k)
    attributes += fmt::format(" ComponentName{}=\"{}\"", k, components[k]);
  return fmt::format("<DataArray type=\"{}\" Name=\"{}\"{} format=\"binary\">{}</DataArray>\n",
                     type_name<Number>, name, attributes, encode(as_bytes(values)));
}

template <class Number, std::size_t N>
std::vector<Number> flatten(const std::vector<std::array<Number, N>>& values) {
  std::vector<Number> flat;
  flat.reserve(N * values.size());
  for (const auto& value : values) flat.insert(flat.end(), value.begin(), value.end());
  return flat;
}

const std::vector<std::string> xyz{"x", "y", "z"};

/// Cells with N corners each.
template <std::size_t N>
std::string cells_xml(const std::vector<std::array<int, N>>& cells, std::uint8_t vtk_type) {
  std::vector<std::int32_t> corners;
  std::vector<std::int64_t> offsets;
  for (const auto& cell : cells) {
    corners.insert(corners.end(), cell.begin(), cell.end());
    offsets.push_back(static_cast<std::int64_t>(corners.size()));
  }
  const std::vector<std::uint8_t> types(cells.size(), vtk_type);
  return "<Cells>\n" + numbers("connectivity", corners) + numbers("offsets", offsets) +
         numbers("types", types) + "</Cells>\n";
}

std::string points_xml(const std::vector<std::array<double, 3>>& points) {
  return "<Points>\n" + numbers("Points", flatten(points), xyz) + "</Points>\n";
}

/// `parts`: points, data and cells.
std::string file_xml(std::size_t points, std::size_t cells,
                     std::initializer_list<std::string_view> parts) {
  std::string text = fmt::format(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n"
      "<UnstructuredGrid>\n<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n",
      points, cells);
  for (const std::string_view part : parts) text += part;
  return text + "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

const double* data_or_null(const Field& field) {
  return field.size() > 0 ? field.data() : nullptr;
}

/// Three fields as one vector; a missing component is 0; empty if all are missing.
std::string vector_xml(const std::string& name, const Field& x, const Field& y, const Field* z) {
  const double* const parts[] = {data_or_null(x), data_or_null(y), z ? data_or_null(*z) : nullptr};
  const Eigen::Index size = std::max({x.size(), y.size(), z ? z->size() : 0});
  if (size == 0) return {};
  std::vector<double> values;
  values.reserve(3 * static_cast<std::size_t>(size));
  for (Eigen::Index k = 0; k < size; ++k)
    for (const double* part : parts) values.push_back(part ? part[k] : 0.0);
  return numbers(name, values, xyz);
}

std::string scalar_xml(const std::string& name, const Field& field) {
  if (field.size() == 0) return {};
  return numbers(name, std::vector<double>(field.data(), field.data() + field.size()));
}

constexpr std::uint8_t vtk_hexahedron = 12;
constexpr std::uint8_t vtk_quadrilateral = 9;

}  // namespace

BodyVtu::BodyVtu(const contact::BodyField& body)
    : point_count_(body.points.size()),
      cell_count_(body.cells.size()),
      points_(points_xml(body.points)),
      cells_(cells_xml(body.cells, vtk_hexahedron)) {}

std::string BodyVtu::text(const contact::BodyValues* values) const {
  std::string data = "<PointData>\n";
  if (values != nullptr) {
    data += numbers("displacement [mm]", flatten(values->displacement), xyz);
    const std::vector<std::string> tensor{"XX", "YY", "ZZ", "XY", "YZ", "XZ"};
    data += numbers("stress [MPa]", flatten(values->stress), tensor);
    std::vector<float> equivalent;
    for (const auto& s : values->stress)
      equivalent.push_back(
          static_cast<float>(contact::von_mises({s[0], s[1], s[2], s[3], s[4], s[5]})));
    data += numbers("von Mises stress [MPa]", equivalent);
    if (!values->accumulated.empty())
      data += numbers("plastic strain [-]", flatten(values->plastic_strain), tensor) +
              numbers("accumulated plastic strain [-]", values->accumulated) +
              numbers("residual stress [MPa]", flatten(values->residual_stress), tensor);
  }
  data += "</PointData>\n";
  return file_xml(point_count_, cell_count_, {points_, data, cells_});
}

std::string contact_vtu(const contact::ContactGrid& grid, const contact::PointResult& point) {
  std::vector<std::array<double, 3>> points;
  for (int j = 0; j <= grid.ny; ++j)
    for (int i = 0; i <= grid.nx; ++i)
      points.push_back({grid.x(i) - 0.5 * grid.dx, grid.y(j) - 0.5 * grid.dy, 0.0});
  std::vector<std::array<int, 4>> cells;
  const int row = grid.nx + 1;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const int corner = j * row + i;
      cells.push_back({corner, corner + 1, corner + row + 1, corner + row});
    }
  const contact::ContactFields& f = point.fields;
  std::string data =
      "<CellData>\n" + scalar_xml("pressure [MPa]", f.traction.n) +
      vector_xml("tangential traction on the wheel [MPa]", f.traction.x, f.traction.y, nullptr) +
      scalar_xml("traction bound [MPa]", f.traction_bound) +
      vector_xml("slip [-]", f.slip.x, f.slip.y, nullptr) +
      scalar_xml("frictional work [N/mm^2]", f.work) + scalar_xml("gap [mm]", f.gap) +
      vector_xml("displacement difference [mm]", f.displacement.x, f.displacement.y,
                 &f.displacement.n);
  if (!f.state.empty()) {
    std::vector<std::uint8_t> state;
    for (const contact::ElementState s : f.state) state.push_back(static_cast<std::uint8_t>(s));
    data += numbers("state (0 exterior, 1 adhesion, 2 slip, 3 plastic)", state);
  }
  data += "</CellData>\n";
  return file_xml(points.size(), cells.size(),
                  {points_xml(points), data, cells_xml(cells, vtk_quadrilateral)});
}

std::vector<double> series_times(const std::vector<contact::PointResult>& points) {
  std::vector<double> times;
  for (const contact::PointResult& point : points) times.push_back(point.creepage.longitudinal);
  std::vector<double> sorted = times;
  std::sort(sorted.begin(), sorted.end());
  const bool differ = std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
  if (!differ) std::iota(times.begin(), times.end(), 0.0);
  return times;
}

std::string series_pvd(const std::vector<double>& times,
                       const std::vector<std::vector<std::string>>& files) {
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" "
      "byte_order=\"LittleEndian\">\n<Collection>\n";
  for (std::size_t k = 0; k < files.size(); ++k)
    for (std::size_t part = 0; part < files[k].size(); ++part)
      text += fmt::format("<DataSet timestep=\"{}\" group=\"\" part=\"{}\" file=\"{}\"/>\n",
                          times[k], part, files[k][part]);
  return text + "</Collection>\n</VTKFile>\n";
}

}  // namespace rollfem::result
