// SPDX-License-Identifier: LGPL-2.1-or-later
#include "case/checks/irregularity_checks.hpp"

#include "base/pi.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rollfem::contact {

namespace {

/// Of height over way.
constexpr double steepest = 0.5;
/// Of the wheel's radius.
constexpr double largest_edge = 0.8;

void check_flat(const GivenCase& given, const WheelFlat& flat, double radius) {
  const std::string depth = "wheel_flat.depth", length = "wheel_flat.length";
  const double shortest_chord = flat.depth ? 2.0 * std::sqrt(2.0 * radius * *flat.depth) : 0.0;
  if (flat.shape == WheelFlat::Shape::chord) {
    if (flat.depth.has_value() == flat.length.has_value())
      fail_at(given, length,
              flat.depth ? "stands beside depth, which follows from it" : "is missing",
              "a chord has a length or a depth", "give one of the two, say `length = 50.0`");
    if (flat.edge_radius > largest_edge * radius)
      fail_at(given, "wheel_flat.edge_radius", "is about the wheel's radius or larger",
              fmt::format("arcs of up to {:g} mm", largest_edge * radius), "write a smaller one");
  } else {
    if (pi * *flat.depth > steepest * *flat.length)
      fail_at(given, depth, "makes a notch of the flat",
              fmt::format("at most {:.3g} mm with this length", steepest / pi * *flat.length),
              "give a smaller depth, or a larger length");
  }
  if (std::max(flat.length.value_or(0.0), shortest_chord) > radius)
    fail_at(given, flat.length ? length : depth, "makes the flat longer than the wheel's radius",
            "a flat up to as long as wheel.rolling_radius", "give a smaller one");
}

/// `slope`: the steepest of each wave.
void check_waves(const GivenCase& given, const std::string& section, const Waves& waves,
                 const std::vector<double>& slope) {
  double sum = 0.0;
  for (std::size_t k = 0; k < slope.size(); ++k) sum += waves.amplitude[k] * slope[k];
  if (sum > steepest)
    fail_at(given, section + ".amplitude", fmt::format("makes waves as steep as {:.3g}", sum),
            fmt::format("slopes up to {:g}", steepest), "give smaller ones, or longer waves");
}

void check_polygon(const GivenCase& given, const WheelPolygon& polygon, double radius) {
  std::vector<double> slope;
  for (const double order : polygon.order) {
    if (order != std::floor(order))
      fail_at(given, "wheel_polygon.order", fmt::format("{:g} is not a whole number", order),
              "whole waves around the wheel", "write the next one");
    slope.push_back(order / radius);
  }
  check_waves(given, "wheel_polygon", polygon, slope);
}

void check_corrugation(const GivenCase& given, const RailCorrugation& waves) {
  std::vector<double> slope;
  for (const double length : waves.wavelength) slope.push_back(2.0 * pi / length);
  check_waves(given, "rail_corrugation", waves, slope);
  const double longest = *std::max_element(waves.wavelength.begin(), waves.wavelength.end());
  if (waves.extent && (*waves.extent)[1] - (*waves.extent)[0] < 2.0 * longest)
    fail_at(given, "rail_corrugation.extent", "is too short for waves to grow and to fade",
            fmt::format("first and last position at least two wavelengths apart, {:g} mm",
                        2.0 * longest),
            "give a longer one");
}

void check_dip(const GivenCase& given, const RailDip& dip) {
  if (3.0 * *dip.depth > steepest * *dip.length)
    fail_at(given, "rail_dip.depth", "makes a gap of the dip",
            fmt::format("at most {:.3g} mm with this length", steepest / 3.0 * *dip.length),
            "give a smaller depth, or a larger length");
  const double largest_angle = 12.0 * *dip.depth / *dip.length;
  if (dip.angle > largest_angle)
    fail_at(given, "rail_dip.angle", "lets the rail rise before it falls to the joint",
            fmt::format("up to 12 depth/length, here {:.4g} rad; 8 depth/length makes parabolas",
                        largest_angle),
            "give a smaller angle, or a deeper or shorter dip");
}

}  // namespace

void check_irregularities(const GivenCase& given, const Case& input) {
  if (input.wheel.flat) check_flat(given, *input.wheel.flat, input.wheel.rolling_radius);
  if (input.wheel.polygon) check_polygon(given, *input.wheel.polygon, input.wheel.rolling_radius);
  if (input.rail.corrugation) check_corrugation(given, *input.rail.corrugation);
  if (input.rail.dip) check_dip(given, *input.rail.dip);
}

}  // namespace rollfem::contact
