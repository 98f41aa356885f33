// SPDX-License-Identifier: LGPL-2.1-or-later
#include "profiles/section_surface.hpp"

#include "profiles/section_list.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace rollfem::profiles {

namespace {

/// Sections repeated beyond each end of a full turn: the spline forgets what is farther away.
constexpr std::ptrdiff_t sections_beyond = 6;

/// Rejects features that do not lie in a section one after the other.
void check_ends(const std::vector<double>& ends) {
  for (std::size_t k = 1; k < ends.size(); ++k)
    if (!(ends[k] > ends[k - 1]))
      throw std::invalid_argument("the features of a section must lie within it and increase");
}

/// A part of all sections: the section from which it takes its nodes, that with most knots in it,
/// and where it begins on the surface.
struct Part {
  std::size_t master = 0;
  double from = 0.0, length = 0.0;  ///< parameters of the master
  double start = 0.0;               ///< parameter of the surface
};

std::vector<Part> parts_of(const std::vector<PlacedSection>& sections,
                           const std::vector<std::vector<double>>& bounds) {
  std::vector<Part> parts;
  double start = bounds.front().front();
  for (std::size_t k = 0; k + 1 < bounds.front().size(); ++k) {
    Part part;
    std::ptrdiff_t most = -1;
    for (std::size_t i = 0; i < sections.size(); ++i) {
      const auto& knots = sections[i].curve.knots().parameter;
      const auto from = std::upper_bound(knots.begin(), knots.end(), bounds[i][k]);
      const std::ptrdiff_t inside = std::lower_bound(from, knots.end(), bounds[i][k + 1]) - from;
      if (inside > most) most = inside, part.master = i;
    }
    part.from = bounds[part.master][k];
    part.length = bounds[part.master][k + 1] - part.from;
    part.start = start;
    start += part.length;
    parts.push_back(part);
  }
  return parts;
}

/// A node: its part and the fraction of that.
struct Node {
  std::size_t part;
  double fraction;
};

std::vector<Node> nodes_of(const std::vector<PlacedSection>& sections,
                           const std::vector<Part>& parts) {
  std::vector<Node> nodes{{0, 0.0}};
  for (std::size_t k = 0; k < parts.size(); ++k) {
    for (const double knot : sections[parts[k].master].curve.knots().parameter) {
      const double fraction = (knot - parts[k].from) / parts[k].length;
      constexpr double same = 1e-9;
      if (fraction > same && fraction < 1.0 - same) nodes.push_back({k, fraction});
    }
    nodes.push_back({k, 1.0});
  }
  return nodes;
}

/// A point of a section with the derivatives by its own parameter.
struct Passed {
  contact::CurveValue y, z;
};

Passed passed(const ProfileCurve& curve, double parameter) {
  const ProfileKnots& knots = curve.knots();
  const auto above =
      std::upper_bound(knots.parameter.begin() + 1, knots.parameter.end() - 1, parameter);
  const auto k = static_cast<std::size_t>(above - knots.parameter.begin()) - 1;
  const double h = knots.parameter[k + 1] - knots.parameter[k];
  const double t = (parameter - knots.parameter[k]) / h;
  return {contact::hermite(h, t, knots.y[k], knots.y[k + 1], knots.dy[k], knots.dy[k + 1]),
          contact::hermite(h, t, knots.z[k], knots.z[k + 1], knots.dz[k], knots.dz[k + 1])};
}

/// A full turn of sections, continued beyond both ends.
std::vector<PlacedSection> continued(const std::vector<PlacedSection>& once, double turn) {
  std::vector<PlacedSection> around;
  const auto n = static_cast<std::ptrdiff_t>(once.size()) - 1;  // the last one is the first again
  for (std::ptrdiff_t k = -sections_beyond; k <= n + sections_beyond; ++k) {
    const std::ptrdiff_t turns = (k + n * sections_beyond) / n - sections_beyond;
    around.push_back(once[static_cast<std::size_t>(k - n * turns)]);
    around.back().position += turn * static_cast<double>(turns);
  }
  return around;
}

/// Slopes at the knots of the natural cubic spline through `count` values `step` apart in a list.
class NaturalSpline {
 public:
  explicit NaturalSpline(const std::vector<double>& at) : at_(at), pivot_(at.size()) {
    // Equations of the slopes m: h_k m_{k-1} + 2 (h_{k-1} + h_k) m_k + h_{k-1} m_{k+1} = ...
    pivot_[0] = 2.0;
    for (std::size_t k = 1; k < at.size(); ++k)
      pivot_[k] = diagonal(k) - lower(k) * upper(k - 1) / pivot_[k - 1];
  }
  void slopes(const double* values, std::size_t step, double* slopes) const {
    const std::size_t n = at_.size();
    const auto chord = [&](std::size_t k) {
      return (values[(k + 1) * step] - values[k * step]) / (at_[k + 1] - at_[k]);
    };
    std::vector<double> right(n);
    right[0] = 3.0 * chord(0);
    right[n - 1] = 3.0 * chord(n - 2);
    for (std::size_t k = 1; k + 1 < n; ++k)
      right[k] = 3.0 * (length(k) * chord(k - 1) + length(k - 1) * chord(k));
    for (std::size_t k = 1; k < n; ++k) right[k] -= lower(k) / pivot_[k - 1] * right[k - 1];
    slopes[(n - 1) * step] = right[n - 1] / pivot_[n - 1];
    for (std::size_t k = n - 1; k-- > 0;)
      slopes[k * step] = (right[k] - upper(k) * slopes[(k + 1) * step]) / pivot_[k];
  }

 private:
  double length(std::size_t k) const { return at_[k + 1] - at_[k]; }
  bool end(std::size_t k) const { return k == 0 || k + 1 == at_.size(); }
  double diagonal(std::size_t k) const { return end(k) ? 2.0 : 2.0 * (length(k - 1) + length(k)); }
  double lower(std::size_t k) const { return end(k) ? 1.0 : length(k); }
  double upper(std::size_t k) const { return end(k) ? 1.0 : length(k - 1); }

  const std::vector<double>& at_;
  std::vector<double> pivot_;
};

}  // namespace

std::vector<double> ends_of_parts(const PlacedSection& section) {
  std::vector<double> ends{section.curve.first()};
  ends.insert(ends.end(), section.features.begin(), section.features.end());
  ends.push_back(section.curve.last());
  return ends;
}

SectionSurface::SectionSurface(std::vector<PlacedSection> sections, SectionSpline spline,
                               double turn)
    : count_(sections.size()), turn_(turn) {
  if (sections.size() < 2) throw std::invalid_argument("a surface needs at least two sections");
  given_ = {sections.front().position, sections.back().position};
  if (turn > 0.0) sections = continued(sections, turn);
  std::vector<std::vector<double>> bounds;
  for (const PlacedSection& section : sections) {
    if (!way_.empty() && !(section.position > way_.back()))
      throw std::invalid_argument("the positions of sections must increase");
    way_.push_back(section.position);
    bounds.push_back(ends_of_parts(section));
    check_ends(bounds.back());
    if (bounds.back().size() != bounds.front().size())
      throw std::invalid_argument("all sections need equally many features");
  }
  const std::vector<Part> parts = parts_of(sections, bounds);
  const std::vector<Node> nodes = nodes_of(sections, parts);
  for (const Node& node : nodes) {
    const Part& part = parts[node.part];
    parameter_.push_back(part.start + node.fraction * part.length);
  }
  for (std::size_t i = 0; i < sections.size(); ++i)
    for (const Node& node : nodes) {
      const double from = bounds[i][node.part], length = bounds[i][node.part + 1] - from;
      const Passed at = passed(sections[i].curve, from + node.fraction * length);
      // The parameter of the surface runs through the part at the pace of its master.
      const double pace = length / parts[node.part].length;
      y_.value.push_back(at.y.value);
      z_.value.push_back(at.z.value);
      y_.across.push_back(pace * at.y.slope);
      z_.across.push_back(pace * at.z.slope);
    }
  for (Nodes* coordinate : {&y_, &z_}) run_along_way(spline, *coordinate);
}

void SectionSurface::run_along_way(SectionSpline spline, Nodes& nodes) const {
  const std::size_t step = parameter_.size(), n = way_.size();
  const NaturalSpline natural(way_);
  const auto run = [&](std::vector<double>& values, std::vector<double>& slopes) {
    slopes.resize(values.size());
    const std::vector<double> given = values;
    for (std::size_t j = 0; j < step; ++j) {
      if (spline == SectionSpline::through) {
        natural.slopes(&values[j], step, &slopes[j]);
        continue;
      }
      for (std::size_t k = 0; k < n; ++k) {
        const auto chord = [&](std::size_t i) {
          return (given[(i + 1) * step + j] - given[i * step + j]) / (way_[i + 1] - way_[i]);
        };
        if (k == 0 || k + 1 == n) {
          slopes[k * step + j] = chord(k == 0 ? 0 : n - 2);
          continue;
        }
        // The cubic B-spline with equal steps, by the parabola through three sections.
        const double before = way_[k] - way_[k - 1], after = way_[k + 1] - way_[k];
        const double bend = (chord(k) - chord(k - 1)) / (before + after);
        values[k * step + j] += before * after * bend / 3.0;
        slopes[k * step + j] = chord(k - 1) + bend * before;
      }
    }
  };
  run(nodes.value, nodes.value_way);
  run(nodes.across, nodes.across_way);
}

SectionSurface::Cell SectionSurface::cell_of(const std::vector<double>& at, double place) {
  const auto above = std::upper_bound(at.begin() + 1, at.end() - 1, place);
  const auto node = static_cast<std::size_t>(above - at.begin()) - 1;
  const double length = at[node + 1] - at[node];
  return {node, length, (place - at[node]) / length};
}

double SectionSurface::known_way(double way) const {
  if (turn_ > 0.0) return way - turn_ * std::floor((way - given_[0]) / turn_);
  return std::clamp(way, given_[0], given_[1]);
}

SurfacePoint SectionSurface::at(double way, double parameter) const {
  const double known = known_way(way);
  const Cell along = cell_of(way_, known), across = cell_of(parameter_, parameter);
  const std::size_t step = parameter_.size();
  const auto coordinate = [&](const Nodes& nodes, double& value, double& by_way,
                              double& by_parameter) {
    std::array<contact::CurveValue, 2> heights, slopes;
    for (std::size_t side = 0; side < 2; ++side) {
      const std::size_t a = along.node * step + across.node + side, b = a + step;
      heights[side] = contact::hermite(along.length, along.fraction, nodes.value[a], nodes.value[b],
                                       nodes.value_way[a], nodes.value_way[b]);
      slopes[side] = contact::hermite(along.length, along.fraction, nodes.across[a],
                                      nodes.across[b], nodes.across_way[a], nodes.across_way[b]);
    }
    const contact::CurveValue here =
        contact::hermite(across.length, across.fraction, heights[0].value, heights[1].value,
                         slopes[0].value, slopes[1].value);
    value = here.value;
    by_parameter = here.slope;
    by_way = known != way && turn_ == 0.0
                 ? 0.0
                 : contact::hermite(across.length, across.fraction, heights[0].slope,
                                    heights[1].slope, slopes[0].slope, slopes[1].slope)
                       .value;
  };
  SurfacePoint point;
  coordinate(y_, point.y, point.y_way, point.y_across);
  coordinate(z_, point.z, point.z_way, point.z_across);
  return point;
}

ProfileCurve SectionSurface::section(double way) const {
  const Cell along = cell_of(way_, known_way(way));
  const std::size_t step = parameter_.size();
  const auto between = [&](const std::vector<double>& values, const std::vector<double>& slopes) {
    std::vector<double> result(step);
    for (std::size_t j = 0; j < step; ++j) {
      const std::size_t a = along.node * step + j, b = a + step;
      result[j] =
          contact::hermite(along.length, along.fraction, values[a], values[b], slopes[a], slopes[b])
              .value;
    }
    return result;
  };
  return ProfileCurve({parameter_, between(y_.value, y_.value_way), between(z_.value, z_.value_way),
                       between(y_.across, y_.across_way), between(z_.across, z_.across_way)});
}

bool SectionSurface::height(double way, double y, double start, SurfaceHeight& found) const {
  double parameter = start;
  for (int round = 0; round < 30; ++round) {
    const SurfacePoint point = at(way, parameter);
    if (!(point.y_across * steepest > std::abs(point.z_across))) return false;
    const double change = (y - point.y) / point.y_across;
    parameter += change;
    if (!has_parameter(parameter)) return false;
    if (std::abs(change) > 1e-13 * (1.0 + std::abs(parameter))) continue;
    const double by_y = point.z_across / point.y_across;
    found = {point.z + by_y * (y - point.y), point.z_way - by_y * point.y_way, by_y, parameter};
    return true;
  }
  return false;
}

SectionSurface SectionSurface::moved(double angle, double y, double z) const {
  SectionSurface result = *this;
  const double c = std::cos(angle), s = std::sin(angle);
  const auto turn = [&](std::vector<double> Nodes::*list, double shift_y, double shift_z) {
    for (std::size_t k = 0; k < (y_.*list).size(); ++k) {
      (result.y_.*list)[k] = c * (y_.*list)[k] - s * (z_.*list)[k] + shift_y;
      (result.z_.*list)[k] = s * (y_.*list)[k] + c * (z_.*list)[k] + shift_z;
    }
  };
  turn(&Nodes::value, y, z);
  for (const auto list : {&Nodes::across, &Nodes::value_way, &Nodes::across_way})
    turn(list, 0.0, 0.0);
  return result;
}

}  // namespace rollfem::profiles
