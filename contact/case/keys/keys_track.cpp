// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/case/case_text.hpp"
#include "contact/case/keys/key_builder.hpp"

#include <fmt/format.h>

#include <cmath>

namespace rollfem::contact {

namespace {

/// A tangent as written in a file: "none", "1:40" where it is such a ratio, otherwise the angle.
KeyValue lean_of(double tangent) {
  if (tangent == 0.0) return std::string("none");
  const std::string ratio = fmt::format("1:{:g}", 1.0 / tangent);
  const std::optional<double> number = ratio_of(ratio);
  if (number && std::abs(*number * tangent - 1.0) < 1e-12) return ratio;
  return std::atan(tangent);
}

double tangent_of(const KeyValue& value) {
  if (const auto* angle = std::get_if<double>(&value)) return std::tan(*angle);
  const std::optional<double> ratio = ratio_of(std::get<std::string>(value));
  return ratio ? 1.0 / *ratio : 0.0;
}

}  // namespace

SectionWithKeys track_section() {
  Keys<Track> keys("track", "The track under wheels with profiles", &Case::track);
  keys.section().of_profiles = true;
  keys.real("gauge")
      .unit("mm")
      .between(1.0, 1e4)
      .says("Distance between the rails.")
      .into(&Track::gauge);
  keys.real("gauge_height")
      .unit("mm")
      .between(0.1, 100.0)
      .says("Depth below the top of the rails at which the gauge is measured.")
      .into(&Track::gauge_height);
  keys.lean("inclination")
      .among({"none"})
      .within(0.5)
      .example(R"("1:40")")
      .otherwise("required with profiles")
      .says(
          "Inclination of the rails towards the middle of the track; `none` also if the rail's "
          "profile was measured in the track.")
      .by([](const Track& track) { return lean_of(track.inclination); },
          [](Track& track, const KeyValue& value) { track.inclination = tangent_of(value); });
  return keys;
}

}  // namespace rollfem::contact
