#include "postprocess/csv.hpp"

#include "postprocess/point_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace rollfem::postprocess {
namespace {

using contact::ContactGrid;
using contact::Field;
using contact::ModelResult;
using contact::PointResult;

std::string header(const std::string& name, const std::string& unit) {
  return fmt::format(",{} [{}]", name, unit);
}

/// Mean over the middle rows or columns at position k along the path.
double along_path(const ContactGrid& grid, const Field& field, Path path,
                  const std::vector<int>& lines, int k) {
  double sum = 0.0;
  for (const int line : lines)
    sum += field[path == Path::x ? grid.index(k, line) : grid.index(line, k)];
  return sum / static_cast<double>(lines.size());
}

void append_path(std::string& text, const ModelResult& model, std::size_t number, Path path) {
  const ContactGrid& grid = model.grid;
  const PointResult& point = model.points[number];
  const std::vector<int> lines = path == Path::x ? middle_lines(grid.y_first, grid.dy, grid.ny)
                                                 : middle_lines(grid.x_first, grid.dx, grid.nx);
  if (lines.empty()) return;
  const int count = path == Path::x ? grid.nx : grid.ny;
  for (int k = 0; k < count; ++k) {
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{}", model.name, number,
                   point.creepage.longitudinal, point.creepage.lateral, point.creepage.spin,
                   path == Path::x ? grid.x(k) : grid.y(k));
    for (const PointField& field : point_fields()) {
      const Field& values = field.value(point.fields);
      text += ',';
      if (values.size() > 0)
        fmt::format_to(std::back_inserter(text), "{}", along_path(grid, values, path, lines, k));
    }
    text += '\n';
  }
}

}  // namespace

std::vector<int> middle_lines(double first, double step, int count) {
  if (count < 1 || !(step > 0.0)) return {};
  const double position = -first / step;  // of the origin, in elements
  const double below = std::floor(position);
  const bool between = std::abs(position - below - 0.5) < 1e-6;
  const auto clamp = [count](double k) {
    return static_cast<int>(std::clamp(k, 0.0, static_cast<double>(count - 1)));
  };
  const int low = between ? clamp(below) : clamp(std::round(position));
  const int high = between ? clamp(below + 1.0) : low;
  return low == high ? std::vector<int>{low} : std::vector<int>{low, high};
}

std::string creep_curve_csv(const RunRecord& run) {
  std::string text = "model,point";
  for (const PointScalar& scalar : point_scalars()) text += header(scalar.name, scalar.unit);
  text += ",iterations [-],residual [-],seconds [s],converged\n";
  for (const ModelResult& model : run.models)
    for (std::size_t k = 0; k < model.points.size(); ++k) {
      const PointResult& point = model.points[k];
      text += fmt::format("{},{}", model.name, k);
      for (const PointScalar& scalar : point_scalars())
        text += fmt::format(",{}", scalar.value(point));
      text += fmt::format(",{},{},{},{}\n", point.iterations, point.residual, point.seconds,
                          point.converged ? 1 : 0);
    }
  return text;
}

std::string path_csv(const RunRecord& run, Path path) {
  std::string text = "model,point,longitudinal_creepage [-],lateral_creepage [-],spin [rad/mm]";
  text += header(path == Path::x ? "x" : "y", "mm");
  for (const PointField& field : point_fields()) text += header(field.name, field.unit);
  text += '\n';
  for (const ModelResult& model : run.models)
    for (std::size_t k = 0; k < model.points.size(); ++k) append_path(text, model, k, path);
  return text;
}

}  // namespace rollfem::postprocess
