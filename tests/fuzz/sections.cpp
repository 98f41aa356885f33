// SPDX-License-Identifier: LGPL-2.1-or-later
// Bytes that draw a list of two to five sections, their points and features, of a rail or a wheel:
// placed and solved.
#include "fuzz/scene.hpp"
#include "fuzz/target.hpp"
#include <algorithm>
#include <vector>

using namespace rollfem::testing;

namespace {

/// Points of a parabola, as a measuring device writes them.
void write_points(Draws& draw, const std::string& name, double up) {
  const double half = draw.between(5.0, 40.0);
  const double radius = half * draw.size(draw.chance(0.1) ? 0.5 : 1.5, 20.0);
  const double off = draw.chance(0.5) ? 0.0 : draw.between(-3.0, 3.0);
  const int count = draw.count(draw.chance(0.1) ? 6 : 20, 80), digits = draw.chance(0.7) ? 6 : 3;
  const double notch = draw.chance(0.05) ? draw.between(-half, half) : 1e9;
  std::string text;
  for (int k = 0; k < count; ++k) {
    const double y = -half + 2.0 * half * k / (count - 1);
    const double z = up * y * y / (2.0 * radius) + off + (std::abs(y - notch) < 3.0 ? 1.0 : 0.0);
    text += fmt::format("{:.{}f},{:.{}f}\n", y, digits, z, digits);
  }
  write_scene_file(name, text);
}

std::string list_of(Draws& draw, bool wheel) {
  const std::string body = wheel ? "wheel" : "rail";
  const bool slices = draw.chance(0.15);
  const int count = draw.count(2, 5), features = draw.count(0, 3);
  double at = 0.0;
  std::string rows, lengths;
  for (int k = 0; k < count; ++k) {
    const std::string name = fmt::format("{}{}.csv", body, k);
    write_points(draw, name, wheel && draw.chance(0.3) ? -1.0 : 1.0);
    std::vector<double> places;
    for (int f = 0; f < features; ++f)
      places.push_back(
          draw.between(draw.chance(0.05) ? -1.0 : 0.0, draw.chance(0.1) ? 60.0 : 10.0));
    if (draw.chance(0.97)) std::sort(places.begin(), places.end());
    std::string row;
    for (const double place : places)
      row += draw.chance(0.05) ? " -" : fmt::format(" {:.4f}", place);
    rows += fmt::format("{} {}{}\n", at, name, slices ? "" : row);
    lengths += fmt::format("{} 0{} 999\n", at, row);
    at += draw.chance(0.97) ? (wheel ? draw.size(1e-3, 3.0) : draw.size(1e-3, 300.0)) : 0.0;
  }
  if (slices)
    rows = fmt::format("0 1\n{}\n{} 0 0\n{}\n", count, features > 0 ? features + 2 : 0,
                       draw.count(0, 2)) +
           rows + (features > 0 ? lengths : "");
  const std::string name = body + (slices ? (wheel ? ".slcw" : ".slcs") : ".sections");
  write_scene_file(name, rows);
  return name;
}

}  // namespace

std::string outcome_of(const std::string& input) {
  Draws draw(input);
  const bool wheel = draw.chance(0.35), rail = !wheel || draw.chance(0.3);
  std::string text = placed(draw, rail, wheel);
  text += "[wheel]\n" + key("rolling_radius", draw.chance(0.7) ? 460.0 : draw.size(50.0, 1e4)) +
          key("profile", wheel ? list_of(draw, true) : std::string("S1002"));
  text += "[rail]\n" + key("profile", rail ? list_of(draw, false) : std::string("60E1"));
  return said_of(text);
}
