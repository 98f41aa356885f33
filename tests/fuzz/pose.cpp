// SPDX-License-Identifier: LGPL-2.1-or-later
// Bytes that draw where a wheel is on a rail, both with profiles of a few arcs or built in: solved.
#include "fuzz/scene.hpp"
#include "fuzz/target.hpp"
#include <algorithm>
#include <vector>

using namespace rollfem::testing;

namespace {

/// A profile of one to three arcs.
std::string arcs(Draws& draw, const char* section) {
  const int count = draw.count(1, 3);
  const double half = draw.chance(0.3) ? 5.0 : draw.between(2.0, 40.0);
  std::string radii, ends = fmt::format("{}", -half * draw.between(0.5, 1.0));
  for (int k = 1; k <= count; ++k) {
    const double radius =
        draw.chance(0.3) ? 0.0 : (draw.chance(0.8) ? 1.0 : -1.0) * draw.size(5.0, 500.0);
    radii += (k > 1 ? ", " : "") + (radius == 0.0 ? std::string("inf") : fmt::format("{}", radius));
    ends += fmt::format(", {}", half * k / count);
  }
  std::string text = fmt::format("[{}]\nradii = [{}]\nends = [{}]\n", section, radii, ends);
  if (draw.chance(0.3)) text += key("slope", draw.between(-0.5, 0.5));
  if (draw.chance(0.5)) text += "free_ends = true\n";
  if (draw.chance(0.1)) text += key("rotation", draw.between(-1.0, 1.0));
  return text;
}

}  // namespace

std::string outcome_of(const std::string& input) {
  Draws draw(input);
  const bool wheel_arcs = draw.chance(0.5), rail_arcs = draw.chance(0.4);
  std::string text = placed(draw, false, false);
  text += "[wheel]\n" + key("rolling_radius", draw.chance(0.6) ? 460.0 : draw.size(20.0, 1e5)) +
          key("profile", std::string(wheel_arcs ? "arcs" : "S1002"));
  text += "[rail]\n" + key("profile", rail_arcs ? std::string("arcs")
                                                : draw.word<2>({"60E1", "UIC60-manchester"}));
  if (draw.chance(0.15)) text += key("rolling_radius", draw.sign() * draw.size(30.0, 3000.0));
  if (wheel_arcs) text += arcs(draw, "wheel_profile");
  if (rail_arcs) text += arcs(draw, "rail_profile");
  return said_of(text);
}
