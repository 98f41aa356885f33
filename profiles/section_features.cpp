// SPDX-License-Identifier: LGPL-2.1-or-later
// Features of sections whose list gives none.
#include "contact/base/pi.hpp"
#include "profiles/profile_points.hpp"
#include "profiles/section_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace rollfem::profiles {

namespace {

constexpr double degree = contact::pi / 180.0;
constexpr double level = 30.0 * degree, steep = 60.0 * degree;
/// Between the places looked at, mm, and how far from the end of its section a feature must lie:
/// one that another section just does not reach is none.
constexpr double look_step = 0.25, least_from_end = 5.0;
/// A kink this close to a bend is part of it, mm.
constexpr double same_bend = 2.0;

/// What ends at a feature: a kink, or the stretches on its sides (-1 rises, 0 is level, 1 falls).
struct Kind {
  int before = 0, after = 0;  ///< both 0: a kink
  bool operator==(const Kind& other) const {
    return before == other.before && after == other.after;
  }
};

struct Feature {
  double parameter = 0.0;
  Kind kind;
  ProfilePoint place;
};

/// The stretch to which an angle belongs, none between level and steep.
std::optional<int> stretch_of(double angle) {
  if (std::abs(angle) <= level) return 0;
  if (std::abs(angle) >= steep) return angle > 0.0 ? 1 : -1;
  return {};
}

std::vector<Feature> bends_of(const ProfileCurve& curve) {
  const std::vector<double> at = dense_parameters(curve, look_step, 1e-3);
  std::vector<double> angle;
  for (const double parameter : at) {
    const ProfilePoint place = curve.at(parameter);
    angle.push_back(std::atan2(place.tangent_z, place.tangent_y));
  }
  // Between k and its successor, on the side of a stretch that faces another one.
  const auto end_of = [&](std::size_t k, int stretch, int other) {
    const double bound = stretch == 0 ? (other > 0 ? level : -level) : stretch * steep;
    const double part = (bound - angle[k]) / (angle[k + 1] - angle[k]);
    return at[k] + std::clamp(part, 0.0, 1.0) * (at[k + 1] - at[k]);
  };
  std::vector<Feature> found;
  std::optional<int> stretch;
  std::size_t last = 0;
  for (std::size_t k = 0; k < at.size(); ++k) {
    const std::optional<int> here = stretch_of(angle[k]);
    if (!here) continue;
    if (stretch && *here != *stretch)
      found.push_back({0.5 * (end_of(last, *stretch, *here) + end_of(k - 1, *here, *stretch)),
                       {*stretch, *here},
                       {}});
    stretch = here;
    last = k;
  }
  return found;
}

std::vector<Feature> features_of(const ProfileCurve& curve) {
  std::vector<Feature> found = bends_of(curve);
  const std::size_t bends = found.size();
  const ProfileKnots& knots = curve.knots();
  for (const std::size_t k : kinks_of({knots.y, knots.z})) {
    const double kink = knots.parameter[k];
    if (std::none_of(
            found.begin(), found.begin() + static_cast<std::ptrdiff_t>(bends),
            [&](const Feature& bend) { return std::abs(bend.parameter - kink) < same_bend; }))
      found.push_back({kink, {}, {}});
  }
  std::sort(found.begin(), found.end(),
            [](const Feature& a, const Feature& b) { return a.parameter < b.parameter; });
  std::vector<Feature> inside;
  for (Feature& feature : found) {
    feature.place = curve.at(feature.parameter);
    if (std::min(feature.parameter - curve.first(), curve.last() - feature.parameter) >
        least_from_end)
      inside.push_back(feature);
  }
  return inside;
}

/// The first of `all` to which the features of a section correspond, one after the other; none
/// where they do so in no way, or equally well in two. `all` has the places in the section beside.
std::optional<std::size_t> first_of(const std::vector<Feature>& here,
                                    const std::vector<Feature>& all) {
  std::optional<std::size_t> best;
  double least = std::numeric_limits<double>::infinity(), second = least;
  for (std::size_t shift = 0; !here.empty() && shift + here.size() <= all.size(); ++shift) {
    double farthest = 0.0;
    for (std::size_t k = 0; k < here.size(); ++k) {
      const Feature& other = all[shift + k];
      farthest = std::max(farthest, here[k].kind == other.kind
                                        ? std::hypot(here[k].place.y - other.place.y,
                                                     here[k].place.z - other.place.z)
                                        : std::numeric_limits<double>::infinity());
    }
    second = std::min(second, std::max(farthest, least));
    if (farthest < least) least = farthest, best = shift;
  }
  return least < 0.5 * second ? best : std::nullopt;
}

std::string named(const std::vector<Feature>& features, double position) {
  std::string text = fmt::format("{} at {:g} (y =", features.size(), position);
  for (const Feature& feature : features) text += fmt::format(" {:.4g}", feature.place.y);
  return text + ")";
}

}  // namespace

void find_features(std::vector<PlacedSection>& sections) {
  std::vector<std::vector<Feature>> found;
  for (const PlacedSection& section : sections) found.push_back(features_of(section.curve));
  const auto fullest = std::max_element(
      found.begin(), found.end(), [](const auto& a, const auto& b) { return a.size() < b.size(); });
  const std::ptrdiff_t start = fullest - found.begin();
  const auto last = static_cast<std::ptrdiff_t>(found.size()) - 1;
  if (fullest->empty()) return;
  for (const std::ptrdiff_t step : {1, -1}) {
    std::vector<Feature> all = *fullest;
    for (std::ptrdiff_t k = start; k >= 0 && k <= last; k += step) {
      const auto i = static_cast<std::size_t>(k);
      const std::optional<std::size_t> first = first_of(found[i], all);
      if (!first)
        throw std::invalid_argument(fmt::format(
            "the sections' bends and kinks do not correspond: {}, {}; allowed: the same in each, "
            "or those of heads that begin or end; do: give the arc lengths of the features in "
            "every line, - for one that a section lacks (docs/profiles.md)",
            named(found[i], sections[i].position),
            named(found[static_cast<std::size_t>(k - step)],
                  sections[static_cast<std::size_t>(k - step)].position)));
      sections[i].features.assign(all.size(), std::numeric_limits<double>::quiet_NaN());
      for (std::size_t f = 0; f < found[i].size(); ++f) {
        all[*first + f] = found[i][f];
        sections[i].features[*first + f] = found[i][f].parameter;
      }
    }
  }
}

}  // namespace rollfem::profiles
