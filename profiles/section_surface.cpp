// SPDX-License-Identifier: LGPL-2.1-or-later
#include "profiles/section_surface.hpp"

#include "base/knots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace rollfem::profiles {

namespace {

/// Sections repeated beyond each end of a full turn; farther ones have no effect on the spline.
constexpr std::ptrdiff_t sections_beyond = 6;

/// A part of all sections: the section with most knots in it, from which it takes its nodes; the
/// parameter at which it begins; the first and the last section that have it.
struct Part {
  std::size_t master = 0;
  double from = 0.0, length = 0.0;  ///< parameters of the master
  double start = 0.0;               ///< parameter of the surface
  std::array<std::size_t, 2> having{};
};

bool has_part(const std::vector<double>& ends, std::size_t k) {
  return !std::isnan(ends[k] + ends[k + 1]);
}

std::vector<Part> parts_of(const std::vector<PlacedSection>& sections,
                           const std::vector<std::vector<double>>& bounds) {
  std::vector<Part> parts;
  double start = 0.0;
  for (std::size_t k = 0; k + 1 < bounds.front().size(); ++k) {
    Part part;
    std::ptrdiff_t most = -1;
    for (std::size_t i = 0; i < sections.size(); ++i) {
      if (!has_part(bounds[i], k)) continue;
      if (most >= 0 && part.having[1] + 1 < i)
        throw std::invalid_argument("a part between two features begins again where it had ended");
      if (most < 0) part.having[0] = i;
      part.having[1] = i;
      const auto& knots = sections[i].curve.knots();
      const auto inside = std::count_if(knots.begin(), knots.end(), [&](const ProfileKnot& knot) {
        return knot.parameter > bounds[i][k] && knot.parameter < bounds[i][k + 1];
      });
      if (inside > most) most = inside, part.master = i;
    }
    if (most < 0)
      throw std::invalid_argument("no section has two neighbouring features between which it lies");
    part.from = bounds[part.master][k];
    part.length = bounds[part.master][k + 1] - part.from;
    if (k == 0) start = part.from;
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
  std::vector<Node> nodes;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    // Each part has its own ends: its parameter runs at another pace than that of its neighbour.
    constexpr double apart = 1e-4, most_apart = 0.01;  // mm, of the length
    nodes.push_back({k, k == 0 ? 0.0 : std::min(apart / parts[k].length, most_apart)});
    for (const ProfileKnot& knot : sections[parts[k].master].curve.knots()) {
      const double fraction = (knot.parameter - parts[k].from) / parts[k].length;
      constexpr double same = 1e-9;
      if (fraction > nodes.back().fraction + same && fraction < 1.0 - same)
        nodes.push_back({k, fraction});
    }
    nodes.push_back({k, 1.0});
  }
  return nodes;
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
  explicit NaturalSpline(std::vector<double> at) : at_(std::move(at)), pivot_(at_.size()) {
    // Equations of the slopes m: h_k m_{k-1} + 2 (h_{k-1} + h_k) m_k + h_{k-1} m_{k+1} = ...
    pivot_[0] = 2.0;
    for (std::size_t k = 1; k < at_.size(); ++k)
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

  std::vector<double> at_, pivot_;
};

}  // namespace

std::vector<double> ends_of_parts(const PlacedSection& section) {
  std::vector<double> ends{section.curve.first()};
  ends.insert(ends.end(), section.features.begin(), section.features.end());
  ends.push_back(section.curve.last());
  for (std::size_t k = 1; k + 1 < ends.size() && std::isnan(ends[k]); ++k)
    std::swap(ends[k - 1], ends[k]);
  for (std::size_t k = ends.size() - 2; k > 0 && std::isnan(ends[k]); --k)
    std::swap(ends[k], ends[k + 1]);
  double last = -std::numeric_limits<double>::infinity();
  for (const double end : ends) {
    if (end <= last)
      throw std::invalid_argument("the features of a section must lie within it and increase");
    if (!std::isnan(end)) last = end;
  }
  return ends;
}

SectionSurface::SectionSurface(std::vector<PlacedSection> sections, SectionSpline spline,
                               double turn)
    : count_(sections.size()), turn_(turn) {
  if (sections.size() < 2) throw std::invalid_argument("a surface needs at least two sections");
  given_ = {sections.front().position, sections.back().position};
  constexpr double digits = 1e-9;
  const bool around = turn > 0.0 && given_[1] - given_[0] > (1.0 - digits) * turn;
  for (const PlacedSection& section : sections)
    for (const double feature : section.features)
      if (around && std::isnan(feature))
        throw std::invalid_argument("around a wheel every section needs all features");
  if (around) sections = continued(sections, turn);
  std::vector<std::vector<double>> bounds;
  for (const PlacedSection& section : sections) {
    if (!way_.empty() && !(section.position > way_.back()))
      throw std::invalid_argument("the positions of sections must increase");
    way_.push_back(section.position);
    bounds.push_back(ends_of_parts(section));
    if (bounds.back().size() != bounds.front().size())
      throw std::invalid_argument("all sections need equally many features");
  }
  const std::vector<Part> parts = parts_of(sections, bounds);
  const std::vector<Node> nodes = nodes_of(sections, parts);
  for (const Node& node : nodes) {
    const Part& part = parts[node.part];
    parameter_.push_back(part.start + node.fraction * part.length);
  }
  std::vector<std::array<std::size_t, 2>> having;
  for (const Node& node : nodes) having.push_back(parts[node.part].having);
  for (std::size_t i = 0; i < sections.size(); ++i)
    for (std::size_t j = 0; j < nodes.size(); ++j) {
      const Node& node = nodes[j];
      // Where its part does not exist a node is where it is in the nearest section.
      const std::size_t near = std::clamp(i, having[j][0], having[j][1]);
      const double from = bounds[near][node.part], length = bounds[near][node.part + 1] - from;
      const auto [y, z] = sections[near].curve.by_parameter(from + node.fraction * length);
      // The parameter of the surface runs through the part at the pace of its master.
      const double pace = length / parts[node.part].length;
      y_.value.push_back(y.value);
      z_.value.push_back(z.value);
      y_.across.push_back(pace * y.slope);
      z_.across.push_back(pace * z.slope);
    }
  for (Nodes* coordinate : {&y_, &z_}) {
    run_along_way(spline, having, *coordinate);
    check_way(having, *coordinate);
  }
  for (std::size_t i = 1; i < sections.size(); ++i)
    if (std::none_of(having.begin(), having.end(),
                     [i](const auto& node) { return node[0] < i && node[1] >= i; }))
      throw std::invalid_argument("two neighbouring sections have no part in common");
  constexpr double far = std::numeric_limits<double>::infinity();
  const std::size_t last = sections.size() - 1;
  for (const auto& [begins, ends] : having)
    presence_.push_back({begins == 0 ? -far : way_[begins], ends == last ? far : way_[ends]});
  if (std::all_of(having.begin(), having.end(),
                  [last](const auto& node) { return node[0] == 0 && node[1] == last; }))
    presence_.clear();
}

void SectionSurface::run_along_way(SectionSpline spline,
                                   const std::vector<std::array<std::size_t, 2>>& having,
                                   Nodes& nodes) const {
  const std::size_t step = parameter_.size();
  std::optional<NaturalSpline> natural;
  const auto run = [&](std::vector<double>& values, std::vector<double>& slopes) {
    slopes.assign(values.size(), 0.0);
    const std::vector<double> given = values;
    for (std::size_t j = 0; j < step; ++j) {
      const auto [first, last] = having[j];
      if (first == last) continue;
      if (spline == SectionSpline::through) {
        if (j == 0 || having[j] != having[j - 1])
          natural.emplace(
              std::vector<double>(way_.begin() + static_cast<std::ptrdiff_t>(first),
                                  way_.begin() + static_cast<std::ptrdiff_t>(last) + 1));
        natural->slopes(&values[first * step + j], step, &slopes[first * step + j]);
        continue;
      }
      const auto chord = [&, j = j](std::size_t i) {
        return (given[(i + 1) * step + j] - given[i * step + j]) / (way_[i + 1] - way_[i]);
      };
      slopes[first * step + j] = chord(first);
      slopes[last * step + j] = chord(last - 1);
      for (std::size_t k = first + 1; k < last; ++k) {
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

void SectionSurface::check_way(const std::vector<std::array<std::size_t, 2>>& having,
                               const Nodes& nodes) const {
  const double steepest_way = turn_ > 0.0 ? 5000.0 : 10.0;  // mm/rad, mm/mm
  constexpr double least_swing = 1.0;                       // mm
  const auto step = static_cast<std::ptrdiff_t>(parameter_.size());
  for (std::size_t k = 0; k < nodes.value.size(); ++k) {
    const auto [first, last] = having[k % parameter_.size()];
    const std::size_t i = k / parameter_.size();
    if (i < first || i >= last) continue;
    const double *value = &nodes.value[k], *slope = &nodes.value_way[k];
    const double length = way_[i + 1] - way_[i], chord = (value[step] - value[0]) / length;
    double change = std::abs(value[step] - value[0]);
    if (i > first) change = std::max(change, std::abs(value[0] - value[-step]));
    if (i + 1 < last) change = std::max(change, std::abs(value[2 * step] - value[step]));
    // The largest distance of a cubic from its chord where one end has another slope.
    const double turned = std::max(std::abs(slope[0] - chord), std::abs(slope[step] - chord));
    const double swing = 4.0 / 27.0 * length * turned;
    // Steep beside two sections much nearer to each other; over gaps of many metres gentle slopes
    // swing as far, where no wheel is.
    double near = length;
    if (i > first) near = std::min(near, way_[i] - way_[i - 1]);
    if (i + 1 < last) near = std::min(near, way_[i + 2] - way_[i + 1]);
    const bool swings = length > 20.0 * near && turned > 0.05 * steepest_way &&
                        swing > std::max(least_swing, 2.0 * change);
    // A wall whose foot has sections is given so; one between sections at about the same place is a
    // mistake.
    const bool is_wall = std::abs(chord) > steepest_way && length < 10.0 / steepest_way;
    if (!is_wall && !swings) continue;
    throw SectionsTooClose(fmt::format(
        "from {:g} to {:g} points move by up to {:.3g} mm from section to section, and a smooth "
        "curve swings {:.3g} mm beyond; allowed: differences that the distance of the sections "
        "resolves; do: leave out one of the sections near there, or put them farther apart",
        way_[i], way_[i + 1], change, swing));
  }
}

bool SectionSurface::exists(double way, double parameter) const {
  if (presence_.empty()) return true;
  const auto [from, to] = presence_[contact::piece_of(parameter_, parameter).first];
  const double within = within_turn(way);
  return within >= from && within <= to;
}

/// The same place of a wheel, at most half a turn from the middle of the given sections.
double SectionSurface::within_turn(double way) const {
  if (turn_ == 0.0) return way;
  return way - turn_ * std::round((way - 0.5 * (given_[0] + given_[1])) / turn_);
}

double SectionSurface::known_way(double way) const {
  const double within = within_turn(way);
  return closed() ? within : std::clamp(within, given_[0], given_[1]);
}

SurfacePoint SectionSurface::at(double way, double parameter) const {
  const double known = known_way(way);
  const bool beyond = known != within_turn(way);
  const auto along = contact::piece_of(way_, known),
             across = contact::piece_of(parameter_, parameter);
  const std::size_t step = parameter_.size();
  const auto coordinate = [&](const Nodes& nodes, double& value, double& by_way,
                              double& by_parameter) {
    std::array<contact::CurveValue, 2> heights, slopes;
    for (std::size_t side = 0; side < 2; ++side) {
      const std::size_t a = along.first * step + across.first + side, b = a + step;
      heights[side] = contact::hermite(along.length, along.part, nodes.value[a], nodes.value[b],
                                       nodes.value_way[a], nodes.value_way[b]);
      slopes[side] = contact::hermite(along.length, along.part, nodes.across[a], nodes.across[b],
                                      nodes.across_way[a], nodes.across_way[b]);
    }
    const contact::CurveValue here =
        contact::hermite(across.length, across.part, heights[0].value, heights[1].value,
                         slopes[0].value, slopes[1].value);
    value = here.value;
    by_parameter = here.slope;
    by_way = beyond ? 0.0
                    : contact::hermite(across.length, across.part, heights[0].slope,
                                       heights[1].slope, slopes[0].slope, slopes[1].slope)
                          .value;
  };
  SurfacePoint point;
  coordinate(y_, point.y, point.y_way, point.y_across);
  coordinate(z_, point.z, point.z_way, point.z_across);
  if (irregularity_.height) {
    const contact::CurveValue added = irregularity_.height(way);
    point.y += outwards_[0] * added.value;
    point.z += outwards_[1] * added.value;
    point.y_way += outwards_[0] * added.slope;
    point.z_way += outwards_[1] * added.slope;
  }
  return point;
}

ProfileCurve SectionSurface::section(double way) const {
  const auto along = contact::piece_of(way_, known_way(way));
  const std::size_t step = parameter_.size();
  const double added = irregularity_.height ? irregularity_.height(way).value : 0.0;
  std::vector<ProfileKnot> knots;
  for (std::size_t j = 0; j < step; ++j) {
    if (!exists(way, parameter_[j])) continue;
    const auto between = [&](const std::vector<double>& values, const std::vector<double>& slopes) {
      const std::size_t a = along.first * step + j, b = a + step;
      return contact::hermite(along.length, along.part, values[a], values[b], slopes[a], slopes[b])
          .value;
    };
    knots.push_back({parameter_[j], between(y_.value, y_.value_way) + outwards_[0] * added,
                     between(z_.value, z_.value_way) + outwards_[1] * added,
                     between(y_.across, y_.across_way), between(z_.across, z_.across_way)});
  }
  return ProfileCurve(std::move(knots));
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
    if (!exists(way, parameter)) return false;
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
  result.outwards_ = {c * outwards_[0] - s * outwards_[1], s * outwards_[0] + c * outwards_[1]};
  return result;
}

SectionSurface SectionSurface::with(Irregularity irregularity) const {
  SectionSurface result = *this;
  result.irregularity_ = std::move(irregularity);
  return result;
}

}  // namespace rollfem::profiles
