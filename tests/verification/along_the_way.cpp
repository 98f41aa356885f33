// SPDX-License-Identifier: LGPL-2.1-or-later
// Rails that change along the track and wheels that are not round, against closed forms: where they
// touch, and what they carry as bodies of the curvatures there.
#include "base/pi.hpp"
#include "halfspace/model/halfspace_model.hpp"
#include "track/motion/placed_scenes.hpp"

#include "support/temporary_folder.hpp"
#include "support/wheel_rail_cases.hpp"

namespace {

using profiles::PlacedSection;
using profiles::SectionSpline;
using profiles::SectionSurface;
using Height = std::function<double(double, double)>;

constexpr double wheel_radius = 300.0, head_radius = 200.0, approach = 0.03;

std::shared_ptr<const SectionSurface> sections_of(const Height& height, const Height& slope,
                                                  double first, double step, int count,
                                                  double turn = 0.0) {
  std::vector<PlacedSection> sections;
  for (int k = 0; k < count; ++k) {
    const double u = first + k * step;
    sections.push_back({u,
                        profile_of([&, u](double y) { return height(u, y); },
                                   [&, u](double y) { return slope(u, y); }, -40.0, 40.0),
                        {}});
  }
  return std::make_shared<const SectionSurface>(std::move(sections), SectionSpline::through, turn);
}

double arc(double radius, double y) {
  return radius - std::sqrt(radius * radius - y * y);
}
double arc_slope(double radius, double y) {
  return y / std::sqrt(radius * radius - y * y);
}

profiles::ProfileCurve profile(const Height& height, const Height& slope) {
  return profile_of([&](double y) { return height(0.0, y); },
                    [&](double y) { return slope(0.0, y); }, -40.0, 40.0);
}

/// A right wheel by itself, frictionless.
contact::Case wheel_case() {
  contact::Case input = manchester_case(0.0, 0.0);
  input.load = {};
  input.load.approach = approach;
  input.wheel.rolling_radius = wheel_radius;
  input.wheelset.on_rail = true;
  input.wheelset.side = contact::WheelSide::right;
  input.wheelset.track_position = {0.0};
  input.wheelset.wheel_angle = {0.0};
  input.rolling.problem = contact::Problem::frictionless;
  input.contact_grid.elements_across = 40;
  return input;
}

const Height sphere = [](double, double y) { return -arc(wheel_radius, y); };
const Height sphere_slope = [](double, double y) { return -arc_slope(wheel_radius, y); };
const Height head = [](double, double y) { return arc(head_radius, y); };
const Height head_slope = [](double, double y) { return arc_slope(head_radius, y); };

struct Found {
  track::PlacedScene placed;
  contact::PointResult point;
};

Found solved(const contact::Case& input, const track::ProfilePair& pair) {
  std::vector<track::PlacedScene> placed =
      track::make_scenes(input, track::make_search_scene(input, pair));
  EXPECT_EQ(placed.size(), 1u);
  contact::PointResult point = halfspace::run_halfspace(placed.at(0).scene, {}).points.at(0);
  return {std::move(placed.at(0)), std::move(point)};
}

/// The bodies of these relative curvatures (1/mm), at the same approach.
contact::PointResult of_curvatures(double along, double across) {
  contact::Case input = wheel_case();
  input.wheelset = {};
  input.wheel.rolling_radius = 1.0 / along;
  input.wheel.transverse_radius = 1.0 / across;
  input.rail.transverse_radius = contact::infinity;
  return halfspace::run_halfspace(contact::Scene(input), {}).points.at(0);
}

void expect_alike(const contact::PointResult& a, const contact::PointResult& b, double within) {
  EXPECT_NEAR(a.normal_force, b.normal_force, within * b.normal_force);
  EXPECT_NEAR(a.max_pressure, b.max_pressure, within * b.max_pressure);
  EXPECT_NEAR(a.contact_length, b.contact_length, within * b.contact_length);
  EXPECT_NEAR(a.contact_width, b.contact_width, within * b.contact_width);
}

TEST(AlongTheWay, RisingRailIsTouchedAheadOfTheAxle) {
  constexpr double rise = 0.1;
  const double angle = std::atan(rise);
  const auto rail = sections_of([](double x, double y) { return arc(head_radius, y) - rise * x; },
                                head_slope, -100.0, 10.0, 21);
  const Found found = solved(
      wheel_case(), {profile(sphere, sphere_slope), profile(head, head_slope), nullptr, rail});
  const contact::ContactPlace& place = found.placed.contact.place;
  EXPECT_NEAR(place.x_track, wheel_radius * std::sin(angle), 1e-5);
  EXPECT_NEAR(place.height, wheel_radius - wheel_radius / std::cos(angle), 1e-8);
  EXPECT_NEAR(place.climb, angle, 1e-8);
  EXPECT_NEAR(place.y_rail, 0.0, 1e-6);
  // The curvature of a sheared cylinder is that of its section times the cosine.
  expect_alike(
      found.point,
      of_curvatures(1.0 / wheel_radius, 1.0 / wheel_radius + std::cos(angle) / head_radius), 1e-3);
}

TEST(AlongTheWay, DipIsTouchedOnTheLineBetweenTheCentres) {
  constexpr double dip = 1000.0, middle = 20.0;
  const Height height = [](double x, double) { return -arc(dip, x - middle); };
  const Height level = [](double, double) { return 0.0; };
  const auto rail = sections_of(height, level, -100.0, 2.0, 121);
  const Found found =
      solved(wheel_case(), {profile(sphere, sphere_slope), profile(level, level), nullptr, rail});
  EXPECT_NEAR(found.placed.contact.place.x_track, -middle * wheel_radius / (dip - wheel_radius),
              1e-5);
  EXPECT_NEAR(found.placed.contact.place.height,
              wheel_radius - dip + std::sqrt(std::pow(dip - wheel_radius, 2) - middle * middle),
              1e-8);
  expect_alike(found.point, of_curvatures(1.0 / wheel_radius - 1.0 / dip, 1.0 / wheel_radius),
               1e-3);
}

TEST(AlongTheWay, PolygonHasTheCurvatureOfItsCrestAndTrough) {
  constexpr double amplitude = 1.0, order = 6.0;
  const double turn = 2.0 * contact::pi;
  const auto wheel = sections_of(
      [](double angle, double y) {
        return amplitude * std::cos(order * angle) - arc(wheel_radius, y);
      },
      sphere_slope, 0.0, turn / 360.0, 361, turn);
  for (const auto& [sign, by_key] :
       {std::pair{1.0, false}, {-1.0, false}, {1.0, true}, {-1.0, true}}) {
    contact::Case input = wheel_case();
    input.wheelset.wheel_angle = {sign > 0.0 ? 0.0 : contact::pi / order};
    if (by_key) input.wheel.polygon = {{{amplitude}, {}}, {order}};
    const Found found = solved(input, {profile(sphere, sphere_slope), profile(head, head_slope),
                                       by_key ? nullptr : wheel, nullptr});
    const double radius = wheel_radius + sign * amplitude;
    EXPECT_NEAR(found.placed.contact.place.height, -sign * amplitude, 1e-6);
    EXPECT_NEAR(found.placed.contact.place.x_track, 0.0, 1e-4);
    const double along = (radius + sign * order * order * amplitude) / (radius * radius);
    expect_alike(found.point, of_curvatures(along, 1.0 / wheel_radius + 1.0 / head_radius), 1e-3);
  }
}

TEST(AlongTheWay, RotatedRailEqualsAYawedWheel) {
  constexpr double yaw = 0.03;
  const track::ProfilePair pair = manchester_pair();
  const auto over_y = [](const profiles::ProfileCurve& curve) {
    return profiles::height_over_y(curve, curve.parameter_at(0.0));
  };
  const contact::HeightCurve rail = over_y(pair.rail);
  const auto rotated = sections_of(
      [&](double x, double y) { return rail.at(y * std::cos(yaw) - x * std::sin(yaw)).value; },
      [&](double x, double y) {
        return std::cos(yaw) * rail.at(y * std::cos(yaw) - x * std::sin(yaw)).slope;
      },
      -60.0, 2.0, 61);
  contact::Case input = wheel_case();
  input.wheel.rolling_radius = 460.0;
  input.wheelset.lateral_shift = {-8.0};
  const Found turned = solved(input, {pair.wheel, rotated->section(0.0), nullptr, rotated});
  // The same about z by the other sign, in which the wheel's middle moves too.
  input.wheelset.yaw = {-yaw};
  input.wheelset.lateral_shift = {-8.0 * std::cos(yaw)};
  const Found yawed = solved(input, {pair.wheel, pair.rail});
  EXPECT_GT(turned.placed.contact.geometry.variation(), 0.01);
  EXPECT_NEAR(turned.placed.contact.place.y_wheel, yawed.placed.contact.place.y_wheel, 2e-3);
  EXPECT_NEAR(turned.placed.contact.place.height, yawed.placed.contact.place.height, 1e-6);
  EXPECT_NEAR(turned.point.normal_force, yawed.point.normal_force, 1e-3 * yawed.point.normal_force);
  EXPECT_NEAR(turned.point.max_pressure, yawed.point.max_pressure, 3e-3 * yawed.point.max_pressure);
}

TEST(AlongTheWay, EqualSectionsAreThePlainProfile) {
  const track::ProfilePair pair = manchester_pair();
  std::vector<PlacedSection> sections;
  for (const double u : {-50.0, 0.0, 70.0}) sections.push_back({u, pair.rail, {}});
  const track::ProfilePair family{
      pair.wheel, pair.rail, nullptr,
      std::make_shared<const SectionSurface>(std::move(sections), SectionSpline::through)};
  contact::Case input = wheel_case();
  input.wheel.rolling_radius = 460.0;
  // On the tread, and on the corner, where the plain profile is a cubic over y between its points.
  for (const auto& [shift, within] : {std::pair{0.0, 1e-9}, {-3.0, 1e-9}, {4.0, 1e-7}}) {
    input.wheelset.lateral_shift = {shift};
    const Found equal = solved(input, family), plain = solved(input, pair);
    const contact::ContactPlace &a = equal.placed.contact.place, &b = plain.placed.contact.place;
    EXPECT_NEAR(a.height, b.height, within) << shift;
    EXPECT_NEAR(a.y_rail, b.y_rail, within) << shift;
    EXPECT_NEAR(a.y_wheel, b.y_wheel, within) << shift;
    EXPECT_NEAR(a.contact_angle, b.contact_angle, within) << shift;
    EXPECT_LT(equal.placed.contact.geometry.variation(), within) << shift;
    for (const double x : {-4.0, 0.0, 5.0})
      for (const double y : {-2.0, 0.3, 3.0})
        EXPECT_NEAR(equal.placed.contact.geometry.distance(x, y),
                    plain.placed.contact.geometry.distance(x, y), within);
    // As near as the solver's own tolerance.
    EXPECT_NEAR(equal.point.normal_force, plain.point.normal_force,
                1e-6 * plain.point.normal_force);
    EXPECT_NEAR(equal.point.max_pressure, plain.point.max_pressure,
                1e-6 * plain.point.max_pressure);
    expect_alike(equal.point, plain.point, 1e-5);
  }
}

track::ProfilePair round_pair() {
  return {profile(sphere, sphere_slope), profile(head, head_slope)};
}

/// Where the right wheel first touches.
contact::ContactPlace touched(const contact::Case& input, const track::ProfilePair& pair) {
  return contacts_of(input, track::make_search_scene(input, pair), false).at(0).place;
}

TEST(Irregularities, AFlatRollsOnItsEdges) {
  // Cut by a chord with arcs at its ends, the circle is the sum of a smaller one, cut by a chord,
  // and a circle of the arc's radius: it stands on the edge of the smaller one.
  constexpr double depth = 0.6;
  for (const double arc : {0.0, 40.0, 200.0}) {
    const double inner = wheel_radius - arc, half = std::acos((inner - depth) / inner);
    for (const double turned : {-1.2, -0.9, -0.3, 0.1, 0.6, 1.1}) {
      contact::Case input = wheel_case();
      input.wheel.flat.emplace();
      if (arc > 0.0)
        input.wheel.flat->depth = depth;
      else
        input.wheel.flat->length = 2.0 * std::sqrt(depth * (2.0 * wheel_radius - depth));
      input.wheel.flat->edge_radius = arc;
      input.wheel.flat->angle = 5.0;
      const double angle = turned * half, to_edge = std::max(half - std::abs(angle), 0.0);
      input.wheelset.wheel_angle = {5.0 + angle - 4.0 * contact::pi};
      const contact::ContactPlace place = touched(input, round_pair());
      EXPECT_NEAR(place.height, inner * (1.0 - std::cos(to_edge)), 1e-8) << arc << " " << turned;
      EXPECT_NEAR(place.x_track, std::copysign(inner * std::sin(to_edge), angle), 1e-5)
          << arc << " " << turned;
    }
  }
}

TEST(Irregularities, AFlatThatIsDownTouchesAlongItsLength) {
  constexpr double length = 50.0;
  const Height level = [](double, double) { return 0.0; };
  contact::Case input = wheel_case();
  input.contact_grid.elements_across = 20;
  input.wheel.flat.emplace();
  input.wheel.flat->length = length;
  const double edge = std::asin(0.5 * length / wheel_radius);
  const Found found = solved(input, {profile(level, level), profile(head, head_slope)});
  EXPECT_NEAR(found.placed.contact.place.height, wheel_radius * (1.0 - std::cos(edge)), 1e-8);
  EXPECT_NEAR(found.placed.contact.place.x_track, 0.0, 2.5);  // a row of the search
  // Beyond its ends the wheel rises with their slope.
  EXPECT_GT(found.point.contact_length, length);
  EXPECT_LT(found.point.contact_length, length + 2.0 * approach / std::sin(edge) + 1.0);
}

TEST(Irregularities, ARoundedFlatIsThatOfItsSections) {
  constexpr double depth = 0.6, length = 60.0, ends = 0.5 * length / wheel_radius;
  const auto wheel = sections_of(
      [&](double angle, double y) {
        const double here = std::min(std::abs(angle), ends);
        return -0.5 * depth * (1.0 + std::cos(contact::pi * here / ends)) - arc(wheel_radius, y);
      },
      sphere_slope, -1.2 * ends, 0.005 * ends, 481);
  contact::Case input = wheel_case();
  for (const double turned : {-1.0, 0.0, 0.5}) {
    input.wheelset.wheel_angle = {turned * ends};
    input.wheel.flat.reset();
    const Found listed =
        solved(input, {profile(sphere, sphere_slope), profile(head, head_slope), wheel, nullptr});
    input.wheel.flat = {contact::WheelFlat::Shape::rounded, depth, length};
    const Found by_key = solved(input, round_pair());
    EXPECT_NEAR(by_key.placed.contact.place.height, listed.placed.contact.place.height, 1e-5);
    expect_alike(by_key.point, listed.point, 1e-3);
  }
}

TEST(Irregularities, CorrugationHasTheCurvatureOfItsCrestAndTrough) {
  // Of a roller, over its radius.
  constexpr double amplitude = 0.2, wavelength = 120.0;
  const double bend = amplitude * std::pow(2.0 * contact::pi / wavelength, 2);
  for (const double roller : {contact::infinity, 500.0})
    for (const double sign : {1.0, -1.0}) {
      contact::Case input = wheel_case();
      input.rail.rolling_radius = roller;
      input.rail.corrugation = {
          {{0.0, amplitude}, {0.0, 1.5 * contact::pi}}, {70.0, wavelength}, {}};
      input.wheelset.track_position = {wavelength * (sign > 0.0 ? 0.75 : 5.25)};
      const Found found = solved(input, round_pair());
      EXPECT_NEAR(found.placed.contact.place.height, -sign * amplitude, 1e-8);
      EXPECT_NEAR(found.placed.contact.place.x_track, 0.0, 1e-5);
      const double height = 1.0 + sign * amplitude / roller;
      const double rail = 1.0 / (roller + sign * amplitude) + sign * bend / (height * height);
      expect_alike(found.point,
                   of_curvatures(1.0 / wheel_radius + rail, 1.0 / wheel_radius + 1.0 / head_radius),
                   1e-3);
    }
}

TEST(Irregularities, FadedWavesEndLevelAndAreWholeInside) {
  contact::Case input = wheel_case();
  input.rail.corrugation = {{{0.1}, {}}, {100.0}, {{-1000.0, 1000.0}}};
  for (const auto& [position, height] :
       {std::pair{0.0, -0.1}, {-900.0, -0.1}, {-950.0, 0.05}, {1100.0, 0.0}, {-1500.0, 0.0}}) {
    input.wheelset.track_position = {position};
    // In a trough of a faded wave the lowest place is beside the axle.
    EXPECT_NEAR(touched(input, round_pair()).height, height, position == -950.0 ? 5e-3 : 1e-8)
        << position;
  }
}

/// How far a wheel sinks into a valley, by brute force.
double sunk(const std::function<double(double)>& depth, double middle) {
  double least = contact::infinity;
  for (double x = -30.0; x < 30.0; x += 1e-3)
    least = std::min(least, depth(x + middle) + arc(wheel_radius, x));
  return least;
}

TEST(Irregularities, AJointIsTouchedOnBothSidesAndAWeldAtItsBottom) {
  constexpr double depth = 2.0, length = 400.0, half = 0.5 * length;
  contact::Case input = wheel_case();
  input.rail.dip = contact::RailDip{10.0, depth, length, 8.0 * depth / length};
  for (const double position : {10.0, 7.0, 30.0, 150.0, 215.0}) {
    input.wheelset.track_position = {position};
    const auto parabolas = [](double x) {
      return depth * std::pow(std::max(0.0, 1.0 - std::abs(x) / half), 2);
    };
    EXPECT_NEAR(touched(input, round_pair()).height, sunk(parabolas, position - 10.0), 1e-7)
        << position;
  }
  // 3 a/length of the bend is missing at the end of the patch.
  input.rail.dip = contact::RailDip{10.0, 5.0, 1000.0, 0.0};
  input.wheelset.track_position = {10.0};
  const Found weld = solved(input, round_pair());
  EXPECT_NEAR(weld.placed.contact.place.height, 5.0, 1e-8);
  expect_alike(weld.point,
               of_curvatures(1.0 / wheel_radius - 6.0 * 5.0 / (500.0 * 500.0),
                             1.0 / wheel_radius + 1.0 / head_radius),
               2e-3);
}

TEST(Irregularities, ACrestOfLongWavesIsARailThatIsHigher) {
  // Along z of its inclined profile, on both sides.
  constexpr double amplitude = 0.5;
  contact::Case raised = manchester_case(2.0, 0.0), moved = raised;
  raised.wheelset.track_position = {0.0};
  raised.rail.corrugation = {{{amplitude}, {}}, {1e7}, {}};
  const double lean = std::atan(raised.track.inclination);
  const double aside = amplitude * std::sin(lean), up = -amplitude * std::cos(lean);
  moved.rail_displacement.lateral = {aside, -aside};
  moved.rail_displacement.vertical = {up, up};
  for (const bool left : {true, false}) {
    const auto a = contacts_of(raised, left).at(0).place, b = contacts_of(moved, left).at(0).place;
    EXPECT_NEAR(a.height, b.height, 1e-7);
    EXPECT_NEAR(a.roll, b.roll, 1e-10);
    EXPECT_NEAR(a.y_track, b.y_track, 1e-5);
    EXPECT_NEAR(a.y_wheel, b.y_wheel, 1e-5);
  }
}

TEST(Irregularities, OfNoAmplitudeLeaveTheProfileAsItIs) {
  contact::Case input = wheel_case();
  input.wheel.polygon = {{{0.0, 0.0}, {}}, {3.0, 20.0}};
  input.rail.corrugation = {{{0.0}, {}}, {40.0}, {{0.0, 500.0}}};
  input.rail.dip = contact::RailDip{0.0, 0.0, 1000.0, 0.0};
  EXPECT_FALSE(track::make_search_scene(input, round_pair()).varies());
}

/// A crown about y = -10, a groove, and another crown 5 mm lower about y = 40. The first one begins
/// at x = 0: before it the sections begin in the groove.
std::shared_ptr<const SectionSurface> head_that_begins() {
  constexpr double groove = 10.0, from = 4.0, floor = 8.0, to = 13.0, second = 17.0;
  const auto crown = [](double y) { return 5.0 + arc(head_radius, y - 40.0); };
  const auto height = [&](double y) {
    if (y < from) return arc(head_radius, y + 10.0);
    if (y < floor) return groove * (y - from) / (floor - from);
    if (y < to) return groove;
    return y < second ? groove + (crown(second) - groove) * (y - to) / (second - to) : crown(y);
  };
  const auto slope = [&](double y) {
    return y < from || y >= second ? arc_slope(head_radius, y + (y < from ? 10.0 : -40.0)) : 0.0;
  };
  std::vector<PlacedSection> sections;
  for (const double x : {-200.0, -100.0, -10.0, 0.0, 60.0}) {
    const bool lacks = x < 0.0;
    sections.push_back({x,
                        profile_of(height, slope, lacks ? floor : -40.0, 60.0),
                        {lacks ? std::nan("") : floor, to}});
  }
  return std::make_shared<const SectionSurface>(std::move(sections), SectionSpline::through);
}

TEST(AlongTheWay, AHeadThatBeginsCarriesFromThereOn) {
  const track::ProfilePair pair{profile(sphere, sphere_slope), profile(head, head_slope), nullptr,
                                head_that_begins()};
  contact::Case input = wheel_case();
  input.wheelset.lateral_shift = {-10.0};
  input.wheelset.track_position = {40.0};
  const Found on_head = solved(input, pair);
  EXPECT_NEAR(on_head.placed.contact.place.y_rail, -10.0, 1e-6);
  EXPECT_NEAR(on_head.placed.contact.place.height, 0.0, 1e-9);
  expect_alike(on_head.point,
               of_curvatures(1.0 / wheel_radius, 1.0 / wheel_radius + 1.0 / head_radius), 1e-3);
  // Farther before it than the wheel reaches, only the other one carries.
  input.wheelset.track_position = {-150.0};
  const Found before = solved(input, pair);
  const double apart = 50.0, both = wheel_radius + head_radius;
  // The middle of the patch, in which the slope changes.
  EXPECT_NEAR(before.placed.contact.place.y_rail, 40.0 - apart * head_radius / both, 1e-3);
  EXPECT_NEAR(before.placed.contact.place.height,
              5.0 + both - std::sqrt(both * both - apart * apart), 1e-8);
  // Where the wheel would stand on the edge at which it begins.
  input.wheelset.track_position = {-20.0};
  EXPECT_TRUE(says(refusal<contact::SolveError>([&] { solved(input, pair); }),
                   "a head of the rail begins or ends", "do: let the sections"));
}

}  // namespace
