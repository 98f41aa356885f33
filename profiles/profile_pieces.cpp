#include "profiles/profile_pieces.hpp"

#include "contact/base/count.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rollfem::profiles {

namespace {

/// Length of the piece between two parameters by Gauss's rule of five points.
double arc_length(const std::function<PiecePoint(double)>& piece, double from, double to) {
  constexpr std::array<double, 3> place{0.0, 0.5384693101056831, 0.9061798459386640};
  constexpr std::array<double, 3> weight{0.5688888888888889, 0.4786286704993665,
                                         0.2369268850561891};
  const double middle = 0.5 * (from + to);
  const double half = 0.5 * (to - from);
  const auto speed = [&](double t) {
    const PiecePoint point = piece(middle + half * t);
    return std::hypot(point.dy, point.dz);
  };
  double sum = weight[0] * speed(0.0);
  for (std::size_t k = 1; k < place.size(); ++k)
    sum += weight[k] * (speed(place[k]) + speed(-place[k]));
  return std::abs(half) * sum;
}

void append(ProfileKnots& knots, double parameter, const PiecePoint& point, double direction) {
  const double speed = direction * std::hypot(point.dy, point.dz);
  knots.parameter.push_back(parameter);
  knots.y.push_back(point.y);
  knots.z.push_back(point.z);
  knots.dy.push_back(point.dy / speed);
  knots.dz.push_back(point.dz / speed);
}

}  // namespace

void append_piece(ProfileKnots& knots, const std::function<PiecePoint(double)>& piece, double from,
                  double to, double distance) {
  const double direction = to > from ? 1.0 : -1.0;
  if (knots.parameter.empty()) append(knots, 0.0, piece(from), direction);
  double length = 0.0;
  constexpr int parts = 16;
  for (int k = 0; k < parts; ++k)
    length +=
        arc_length(piece, from + (to - from) * k / parts, from + (to - from) * (k + 1) / parts);
  const int steps =
      std::max(2, contact::count_of(std::ceil(length / distance),
                                    "points along a profile (ends, limits, coefficients)"));
  double before = from;
  for (int k = 1; k <= steps; ++k) {
    const double here = k == steps ? to : from + (to - from) * k / steps;
    append(knots, knots.parameter.back() + arc_length(piece, before, here), piece(here), direction);
    before = here;
  }
}

void append_arc(ProfileKnots& knots, double y, double z, double radius, double from, double to,
                bool hollow) {
  const double up = hollow ? -1.0 : 1.0;
  append_piece(
      knots,
      [=](double angle) {
        return PiecePoint{y + radius * std::sin(angle), z - up * radius * std::cos(angle),
                          radius * std::cos(angle), up * radius * std::sin(angle)};
      },
      from, to);
}

void append_line(ProfileKnots& knots, double y0, double z0, double y1, double z1) {
  append_piece(
      knots,
      [=](double t) {
        return PiecePoint{y0 + t * (y1 - y0), z0 + t * (z1 - z0), y1 - y0, z1 - z0};
      },
      0.0, 1.0);
}

}  // namespace rollfem::profiles
