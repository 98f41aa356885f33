// SPDX-License-Identifier: LGPL-2.1-or-later
#include "track/placement/along_way.hpp"

#include "base/errors.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace rollfem::track {

using contact::Axle;
using contact::dot;
using contact::Vector3;
using profiles::ProfileCurve;
using profiles::SectionSurface;

namespace {

/// Between the points of a section from which searches start, mm.
constexpr double sample_step = 0.5;
/// Rows to each side, up to this fraction of the wheel's radius, and rows to the shortest wave of
/// an irregularity.
constexpr int fewest_rows_to_side = 30;
constexpr double farthest_row = 0.25;
constexpr double rows_to_wave = 8.0;

/// The part of a section that is a height over y.
struct OverY {
  struct Knot : contact::HeightKnot {
    double parameter;  ///< of the section
  };
  std::vector<Knot> knots;

  void add(const profiles::ProfilePoint& point, double parameter) {
    knots.push_back({{point.y, point.z, point.tangent_z / point.tangent_y}, parameter});
  }
  contact::HeightCurve heights() const {
    check();
    return contact::HeightCurve({knots.begin(), knots.end()});
  }
  contact::HeightCurve parameters() const {
    check();
    std::vector<contact::HeightKnot> made;
    for (std::size_t k = 0; k < knots.size(); ++k) {
      const Knot &a = knots[k > 0 ? k - 1 : 0], &b = knots[std::min(k + 1, knots.size() - 1)];
      made.push_back({knots[k].y, knots[k].parameter, (b.parameter - a.parameter) / (b.y - a.y)});
    }
    return contact::HeightCurve(std::move(made));
  }
  void check() const {
    if (knots.size() < 2)
      throw contact::InputError(
          "wheel.profile, rail.profile: a section near this position is nowhere a height over y; "
          "allowed: a tread or head less steep than 85 degrees; do: check rotation, flip and "
          "mirror "
          "of the sections, and sections that differ much close to each other");
  }
};

bool is_height(const profiles::ProfilePoint& point) {
  return point.tangent_y * profiles::steepest > std::abs(point.tangent_z);
}

/// The parts of a rail seen from above, where heads stand beside each other.
OverY parts_seen(const ProfileCurve& rail) {
  OverY seen;
  for (const double at : profiles::dense_parameters(rail, sample_step, 1e-3)) {
    const profiles::ProfilePoint point = rail.at(at);
    if (!is_height(point)) continue;
    std::vector<OverY::Knot>& knots = seen.knots;
    while (!knots.empty() && point.y <= knots.back().y && point.z < knots.back().z)
      knots.pop_back();
    constexpr double least = 1e-6;  // mm
    if (knots.empty() || point.y > knots.back().y + least) seen.add(point, at);
  }
  return seen;
}

/// The part of a wheel about y = `about` that is a height over y.
OverY part_about(const ProfileCurve& wheel, double about) {
  OverY part;
  for (const double at : profiles::dense_parameters(wheel, sample_step, 1e-3)) {
    const profiles::ProfilePoint point = wheel.at(at);
    if (is_height(point) && (part.knots.empty() || point.y > part.knots.back().y)) {
      part.add(point, at);
    } else if (point.y < about) {
      part = {};
    } else {
      break;
    }
  }
  return part;
}

/// Heights up over y, from a place.
contact::HeightCurve upside_down(const contact::HeightCurve& curve, const Vector3& place) {
  std::vector<contact::HeightKnot> knots;
  for (const contact::HeightKnot& knot : curve.knots()) {
    const contact::CurveValue at = curve.at(knot.y);
    knots.push_back({knot.y - place[1], place[2] - at.value, -at.slope});
  }
  return contact::HeightCurve(std::move(knots));
}

/// The side frame with z up and its origin at a place in the plane x = 0.
SurfaceFrame level_frame(const Vector3& place) {
  return {{0.0, place[1], place[2]}};
}

Axle in_frame(const Axle& axle, const SurfaceFrame& frame) {
  const Vector3 arm = contact::plus(axle.point, frame.origin, -1.0);
  const Vector3& e = axle.direction;
  return {{dot(arm, frame.x), dot(arm, frame.y), dot(arm, frame.z)},
          {dot(e, frame.x), dot(e, frame.y), dot(e, frame.z)}};
}

// The locus along which a wheel and a rail that change along their way are closest: at every y the
// least gap over x.

/// Most and least between the points of the locus, and between the places at which all of x is
/// looked at, mm.
constexpr double locus_step = 0.1, least_step = 0.02, look_step = 1.0;
/// Places closer than this are one, mm.
constexpr double rounding = 1e-6;

/// Over a stretch without points, the wall between two heads, the gap is wide: it opens on one side
/// and closes on the other.
void bridge(std::vector<LocusPoint>& points, const LocusPoint& next) {
  if (points.empty() || next.y - points.back().y < 1.5 * locus_step) return;
  constexpr double wide = 20.0;  // mm
  const LocusPoint last = points.back();
  const double width = next.y - last.y;
  for (const double part : {1.0 / 3.0, 2.0 / 3.0}) {
    LocusPoint point = part < 0.5 ? last : next;
    point.y = last.y + part * width;
    point.rail_z = point.wheel_z + wide;
    point.rail_slope = (part < 0.5 ? 1.0 : -1.0) * wide / width;
    point.wheel_slope = 0.0;
    points.push_back(point);
  }
}

/// The wheel's surface there.
SlopedHeight wheel_at(const contact::PatchGeometry& bodies, double x, double y) {
  const double z = bodies.wheel_height(x, y);
  if (!std::isfinite(z)) return {z};
  const contact::AxlePlace at = bodies.axle_place({x, y, z});
  const contact::RadiusAround radius = bodies.radius_around(at);
  const Vector3& axle = bodies.axle().direction;
  const Vector3 around = contact::cross(at.across, axle);  // the way in which the angle grows
  const auto normal = [&](std::size_t d) {
    return at.across[d] / at.radius - radius.by_axial * axle[d] -
           radius.by_angle * around[d] / (at.radius * at.radius);
  };
  return {z, -normal(0) / normal(2), -normal(1) / normal(2)};
}

/// Places between two y, with those at which a section begins another piece, so that the curves
/// through the points are as accurate as the sections.
std::vector<double> places_between(double from, double to, const std::vector<double>& pieces) {
  std::vector<double> places{from};
  const auto go_to = [&](double y) {
    const double start = places.back();
    const int steps = static_cast<int>(std::ceil((y - start) / locus_step));
    for (int k = 1; k <= steps; ++k) places.push_back(start + (y - start) * k / steps);
  };
  for (const double y : pieces)
    if (y > places.back() + least_step && y < to - rounding) go_to(y);
  go_to(to);
  return places;
}

}  // namespace

contact::HeightCurve seen_from_above(const ProfileCurve& section) {
  return parts_seen(section).heights();
}

/// The rail over all rows: what functions of it share.
struct BodiesAlongWay::Rail {
  std::shared_ptr<const SectionSurface> surface;
  double way = 0.0;
  double rolling_radius = contact::infinity;  ///< of a roller
  Axle axle;
  /// A point with its derivatives by the way and by the parameter.
  struct Point {
    Vector3 place, by_way, by_parameter;
  };
  Point at(double along, double parameter) const;
  /// Rail at one x: what of it is seen from above, as z (down) and as the parameter over y.
  struct Row {
    double x = 0.0;
    contact::HeightCurve height, parameter;
  };
  std::vector<Row> rows;

  /// The row nearest to x, or one beside it.
  const Row& nearest(double x, double beside = 0.0) const {
    const double part = (x - rows.front().x) / (rows.back().x - rows.front().x);
    const double last = static_cast<double>(rows.size() - 1);
    return rows[static_cast<std::size_t>(std::clamp(std::round(part * last) + beside, 0.0, last))];
  }
  SlopedHeight height_in(const SurfaceFrame& frame, double x, double y) const;
  SlopedHeight height_from(const Row& row, const SurfaceFrame& frame, double x, double y) const;
};

/// On a roller the section at `along` is turned about the axle from the plane x = 0.
BodiesAlongWay::Rail::Point BodiesAlongWay::Rail::at(double along, double parameter) const {
  const profiles::SurfacePoint at = surface->at(way + along, parameter);
  if (std::isinf(rolling_radius))
    return {{along, at.y, at.z}, {1.0, at.y_way, at.z_way}, {0.0, at.y_across, at.z_across}};
  const Vector3 &e = axle.direction, down{0.0, -e[2], e[1]};
  const double sine = std::sin(along / rolling_radius), cosine = std::cos(along / rolling_radius);
  const auto turned = [&](double y, double z) {
    const double axial = y * e[1] + z * e[2], radial = y * down[1] + z * down[2];
    return Vector3{-sine * radial, axial * e[1] + cosine * radial * down[1],
                   axial * e[2] + cosine * radial * down[2]};
  };
  const Vector3 arm = turned(at.y - axle.point[1], at.z - axle.point[2]);
  const Vector3 around = contact::cross(arm, e);
  Point point{contact::plus(arm, axle.point), turned(at.y_way, at.z_way),
              turned(at.y_across, at.z_across)};
  for (int d = 0; d < 3; ++d) point.by_way[d] += around[d] / rolling_radius;
  return point;
}

SlopedHeight BodiesAlongWay::Rail::height_in(const SurfaceFrame& frame, double x, double y) const {
  const double along = frame.origin[0] + x * frame.x[0] + y * frame.y[0];
  SlopedHeight found = height_from(nearest(along), frame, x, y);
  // Where a head begins the nearest row may lack it.
  for (const double beside : {1.0, -1.0})
    if (surface->has_ends() && !std::isfinite(found.z))
      found = height_from(nearest(along, beside), frame, x, y);
  return found;
}

/// Newton's method for position along the track and parameter of the point over (x, y).
SlopedHeight BodiesAlongWay::Rail::height_from(const Row& row, const SurfaceFrame& frame, double x,
                                               double y) const {
  const auto at_plane = [&](std::size_t d) {
    return frame.origin[d] + x * frame.x[d] + y * frame.y[d];
  };
  double along = at_plane(0);
  const double aside = std::clamp(at_plane(1), row.parameter.first(), row.parameter.last());
  double parameter = row.parameter.at(aside).value;
  for (int step = 0; step < 30; ++step) {
    const auto [place, by_way, by_parameter] = this->at(along, parameter);
    const Vector3 arm = contact::plus(place, frame.origin, -1.0);
    const double defect_x = x - dot(arm, frame.x), defect_y = y - dot(arm, frame.y);
    const double a = dot(by_way, frame.x), b = dot(by_parameter, frame.x);
    const double c = dot(by_way, frame.y), d = dot(by_parameter, frame.y);
    const double determinant = a * d - b * c;
    const double up = dot(by_way, frame.z), up_across = dot(by_parameter, frame.z);
    // Seen from above; a roller has a lower side too.
    const double facing = dot(contact::cross(by_parameter, by_way), frame.z);
    if (!(facing * profiles::steepest > std::abs(up_across))) break;
    const double change = (d * defect_x - b * defect_y) / determinant;
    const double across = (a * defect_y - c * defect_x) / determinant;
    if (std::abs(change) + std::abs(across) < 1e-11) {
      if (!surface->exists(way + along, parameter)) break;
      return {dot(arm, frame.z) + change * up + across * up_across,
              (d * up - c * up_across) / determinant, (a * up_across - b * up) / determinant};
    }
    along += change;
    parameter += across;
    if (!surface->has_parameter(parameter)) break;
  }
  return {};
}

BodiesAlongWay::BodiesAlongWay(Sections sections, const ProfileCurve& rail,
                               const ProfileCurve& wheel, double rolling_radius, const Axle& axle,
                               double tread_y)
    : sections_(std::move(sections)),
      wheel_(sections_.wheel ? sections_.wheel->section(sections_.wheel_angle) : wheel),
      rolling_radius_(rolling_radius),
      axle_(axle),
      tread_y_(tread_y) {
  auto all = std::make_shared<Rail>();
  all->surface = sections_.rail;
  all->way = sections_.rail_way;
  all->rolling_radius = sections_.rail_rolling_radius;
  all->axle = sections_.rail_axle;
  double wave = contact::infinity;
  if (sections_.rail) wave = sections_.rail->irregularity().shortest;
  if (sections_.wheel)
    wave = std::min(wave, rolling_radius * sections_.wheel->irregularity().shortest);
  const double reach = farthest_row * rolling_radius;
  const int rows_to_side =
      std::max(fewest_rows_to_side, static_cast<int>(std::ceil(reach * rows_to_wave / wave)));
  const double step = reach / rows_to_side;
  for (int k = -rows_to_side; k <= rows_to_side; ++k) {
    const double x = axle.point[0] + k * step;
    if (all->surface || all->rows.empty()) {
      const OverY seen = parts_seen(all->surface ? all->surface->section(all->way + x) : rail);
      all->rows.push_back({x, seen.heights(), seen.parameters()});
    } else {
      all->rows.push_back(all->rows.front());
      all->rows.back().x = x;
    }
  }
  rail_ = std::move(all);
}

contact::RailSurface BodiesAlongWay::rail_in(const SurfaceFrame& frame) const {
  if (!rail_changes()) return {};
  return [rail = rail_, frame](double x, double y) { return rail->height_in(frame, x, y).z; };
}

ProfileCurve BodiesAlongWay::rail_section(const AlongRail& along) const {
  const ProfileCurve at = sections_.rail->section(sections_.rail_way + along.x);
  std::vector<profiles::ProfileKnot> section = at.knots();
  for (profiles::ProfileKnot& knot : section) {
    double way = along.x;
    Vector3 place{}, by_way{}, by_parameter{};
    for (int step = 0; step < 20; ++step) {
      const Rail::Point point = rail_->at(way, knot.parameter);
      place = along.place_to_top(point.place);
      by_way = along.direction_to_top(point.by_way);
      by_parameter = along.direction_to_top(point.by_parameter);
      const double change = place[0] / by_way[0];
      way -= change;
      if (std::abs(change) < 1e-12 * (1.0 + std::abs(way))) break;
    }
    const double turn = -by_parameter[0] / by_way[0];  // of the way by the parameter
    knot = {knot.parameter, place[1], place[2], by_parameter[1] + turn * by_way[1],
            by_parameter[2] + turn * by_way[2]};
  }
  return ProfileCurve(std::move(section));
}

double BodiesAlongWay::angle_of(const Vector3& place) const {
  const SurfaceFrame level = level_frame(place);
  const Axle axle = in_frame(axle_, level);
  return contact::angle_about(axle, contact::axle_place(axle, {place[0], 0.0, 0.0}).across);
}

ProfileCurve BodiesAlongWay::wheel_section(double angle) const {
  return sections_.wheel->section(sections_.wheel_angle + angle);
}

contact::WheelSurface BodiesAlongWay::wheel_around(double angle_here, double angle_there,
                                                   double sign_y) const {
  if (!wheel_changes()) return {};
  const double offset = sections_.wheel_angle + angle_here - angle_there;
  const OverY part = part_about(wheel_section(angle_here), tread_y_);
  return [surface = sections_.wheel, offset, sign_y, radius = rolling_radius_,
          parameters = part.parameters()](double axial, double angle) {
    const double y = sign_y * axial;
    const double start = parameters.at(std::clamp(y, parameters.first(), parameters.last())).value;
    profiles::SurfaceHeight found;
    if (!surface->height(offset + angle, y, start, found))
      return contact::RadiusAround{contact::infinity, 0.0, 0.0};
    return contact::RadiusAround{radius + found.z, sign_y * found.by_y, found.by_way};
  };
}

/// The section that points down from its tread to both sides.
BodiesAlongWay::Level BodiesAlongWay::level() const {
  Vector3 tread = contact::plus(axle_.point, axle_.direction, tread_y_);
  Vector3 down = contact::cross(axle_.direction, contact::cross({0.0, 0.0, 1.0}, axle_.direction));
  const double length = std::sqrt(dot(down, down));
  for (double& part : down) part /= length;
  OverY part = part_about(wheel_, tread_y_);
  const double radius = rolling_radius_ + part.heights().at(tread_y_).value;
  tread = contact::plus(tread, down, radius);
  for (OverY::Knot& knot : part.knots) knot.z += rolling_radius_;
  const contact::HeightCurve& head = rail_->nearest(axle_.point[0]).height;
  Level level{level_frame(tread), {}, contact::infinity, -contact::infinity, {}, {}};
  for (const Rail::Row& row : rail_->rows) {
    level.rows.push_back(row.x);
    level.first = std::min(level.first, row.height.first() - tread[1]);
    level.last = std::max(level.last, row.height.last() - tread[1]);
  }
  level.bodies = {upside_down(head, tread), part.heights(), in_frame(axle_, level.frame),
                  std::min(level.first, -1.0), std::max(level.last, 1.0)};
  level.bodies.set_surfaces(rail_in(level.frame), wheel_around(0.0, 0.0, 1.0));
  for (const contact::HeightKnot& knot : head.knots()) level.pieces.push_back(knot.y - tread[1]);
  for (const OverY::Knot& knot : part.knots)
    level.pieces.push_back(axle_.point[1] + knot.y * axle_.direction[1] + knot.z * down[1] -
                           tread[1]);
  std::sort(level.pieces.begin(), level.pieces.end());
  return level;
}

SlopedHeight BodiesAlongWay::rail_at(const Level& level, double x, double y) const {
  if (rail_changes()) return rail_->height_in(level.frame, x, y);
  const contact::CurveValue rail = level.bodies.rail().at(y);
  return {rail.value, 0.0, rail.slope};
}

/// The gap over x at one y, level frame.
struct BodiesAlongWay::GapAlong {
  const BodiesAlongWay& along_way;
  const Level& level;
  double y;

  double at(double x) const { return level.bodies.distance(x, y); }
  double slope(double x) const {
    const SlopedHeight wheel = wheel_at(level.bodies, x, y), rail = along_way.rail_at(level, x, y);
    return std::isfinite(wheel.z - rail.z) ? wheel.along - rail.along : contact::infinity;
  }

  /// The lowest place between two x, by the secant method on the slope; it may be where a head
  /// begins or ends. `bend`: about the change of the slope.
  std::optional<double> lowest(double lower, double start, double upper, double bend) const {
    constexpr double close = 1e-8;  // mm
    constexpr int rounds_if_smooth = 15;
    double x = start, before = start, slope_before = contact::infinity;
    for (int round = 0; round < 60; ++round) {
      const double here = slope(x);
      if (std::isinf(here)) {
        if (std::abs(x - before) < close) break;
        (x < before ? lower : upper) = x;
        x = 0.5 * (x + before);
        continue;
      }
      if (x != before && (here - slope_before) * (x - before) > 0.0)
        bend = (here - slope_before) / (x - before);
      (here > 0.0 ? upper : lower) = before = x;
      slope_before = here;
      const double next = x - here / bend;
      if (std::abs(next - x) < close) return next;
      if (upper - lower < close) return x;
      // At an edge the slope jumps.
      x = round < rounds_if_smooth && next > lower && next < upper ? next : 0.5 * (lower + upper);
    }
    return std::isinf(slope_before) ? std::nullopt : std::optional(before);
  }

  /// Rows at which the gap is a local minimum among them; of equal ones, under a flat, the middle.
  std::vector<std::size_t> low_rows() const {
    std::vector<double> value;
    for (const double x : level.rows) value.push_back(at(x));
    std::vector<std::size_t> low;
    constexpr double equal = 1e-10;  // mm
    for (std::size_t k = 1, last = 1; k + 1 < value.size(); k = ++last) {
      while (last + 2 < value.size() && std::abs(value[last + 1] - value[k]) < equal) ++last;
      if (std::isfinite(value[k]) && value[k] < value[k - 1] && value[k] <= value[last + 1])
        low.push_back((k + last) / 2);
    }
    return low;
  }

  /// Radius of the circle that opens as much at `wide` to both sides of x.
  double relative_radius(double x, double wide, double most) const {
    const double opening = 0.5 * (at(x - wide) + at(x + wide)) - at(x);
    if (!std::isfinite(opening)) return along_way.rolling_radius_;
    return 2.0 * opening * most > wide * wide + opening * opening
               ? 0.5 * (wide * wide / opening + opening)
               : most;
  }
};

/// The point at y where the gap is least among the lowest places near these rows. `before`: the
/// point beside it, if any.
std::optional<LocusPoint> BodiesAlongWay::point_at(const Level& level, double y,
                                                   const std::vector<std::size_t>& near,
                                                   const LocusPoint* before) const {
  const GapAlong gap{*this, level, y};
  std::optional<double> best;
  for (const std::size_t k : near) {
    const double lower = level.rows[k - 1], upper = level.rows[k + 1];
    const bool known = before != nullptr && before->x > lower && before->x < upper;
    const auto x = gap.lowest(lower, known ? before->x : level.rows[k], upper,
                              1.0 / (known ? before->relative_radius : rolling_radius_));
    if (x && (!best || gap.at(*x) < gap.at(*best))) best = x;
  }
  if (!best) return {};
  const SlopedHeight rail = rail_at(level, *best, y);
  SlopedHeight wheel = wheel_at(level.bodies, *best, y);
  // On an edge of a flat, the mean of both sides with which the gap is level along x: its slope
  // along the edge.
  constexpr double level_slope = 1e-6, beside = 1e-6;  // -, mm
  if (std::abs(wheel.along - rail.along) > level_slope) {
    const SlopedHeight behind = wheel_at(level.bodies, *best - beside, y);
    const SlopedHeight ahead = wheel_at(level.bodies, *best + beside, y);
    const double part = (rail.along - behind.along) / (ahead.along - behind.along);
    if (part > 0.0 && part < 1.0)
      wheel.across = behind.across + part * (ahead.across - behind.across);
  }
  LocusPoint point;
  point.x = *best;
  point.y = level.frame.origin[1] + y;
  point.rail_z = level.frame.origin[2] - rail.z;
  point.wheel_z = level.frame.origin[2] - wheel.z;
  point.along = -rail.along;
  point.rail_slope = -rail.across;
  point.wheel_slope = -wheel.across;
  constexpr double depth = 0.1, most_times = 50.0;
  point.relative_radius = gap.relative_radius(point.x, std::sqrt(2.0 * rolling_radius_ * depth),
                                              most_times * rolling_radius_);
  if (!std::isfinite(point.rail_slope + point.wheel_slope + point.along)) return {};
  return point;
}

std::vector<LocusPoint> BodiesAlongWay::locus() const {
  const Level level = this->level();
  const double from = std::max(level.first, level.bodies.wheel().first());
  const double to = std::min(level.last, level.bodies.wheel().last());
  std::vector<LocusPoint> points;
  std::vector<std::size_t> near, ahead;
  double looked = -contact::infinity;
  for (const double y :
       from < to - rounding ? places_between(from, to, level.pieces) : std::vector<double>{}) {
    if (y > looked) {
      near = std::isinf(looked) ? GapAlong{*this, level, y}.low_rows() : ahead;
      looked = std::min(std::max(looked, y) + look_step, to);
      ahead = GapAlong{*this, level, looked}.low_rows();
      for (const std::size_t row : ahead)
        if (std::find(near.begin(), near.end(), row) == near.end()) near.push_back(row);
    }
    if (const auto point = point_at(level, y, near, points.empty() ? nullptr : &points.back())) {
      bridge(points, *point);
      points.push_back(*point);
    }
  }
  if (points.size() < 2)
    throw contact::SolveError("the wheel is not above the rail anywhere near this position");
  return points;
}

}  // namespace rollfem::track
