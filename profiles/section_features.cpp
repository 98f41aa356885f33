// SPDX-License-Identifier: LGPL-2.1-or-later
// Features of sections whose list gives none.
#include "contact/base/pi.hpp"
#include "profiles/profile_points.hpp"
#include "profiles/section_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace rollfem::profiles {

namespace {

constexpr double level = contact::pi / 6.0, steep = contact::pi / 3.0;
/// A feature closer to the end of its section (mm) is none, because another section may just not
/// reach it; a kink this close to a bend is part of it.
constexpr double least_from_end = 5.0, same_bend = 2.0;

/// `kind`: of a bend 3 times the stretch before it plus that behind it (-1 rises, 0 is level, 1
/// falls), of a kink 0.
struct Feature {
  double parameter = 0.0;
  int kind = 0;
  double y = 0.0, z = 0.0;
};

std::vector<Feature> bends_of(const ProfileCurve& curve) {
  const std::vector<double> at = dense_parameters(curve, 0.25, 1e-3);
  std::vector<double> angle;
  for (const double parameter : at) {
    const ProfilePoint place = curve.at(parameter);
    angle.push_back(std::atan2(place.tangent_z, place.tangent_y));
  }
  // Between k and its successor, on the side of a stretch that faces another one.
  const auto end_of = [&](std::size_t k, int stretch, int other) {
    const double bound = stretch == 0 ? other * level : stretch * steep;
    const double part = (bound - angle[k]) / (angle[k + 1] - angle[k]);
    return at[k] + std::clamp(part, 0.0, 1.0) * (at[k + 1] - at[k]);
  };
  std::vector<Feature> found;
  int before = 0;
  std::size_t last = at.size();
  for (std::size_t k = 0; k < at.size(); ++k) {
    const double size = std::abs(angle[k]);
    if (size > level && size < steep) continue;
    const int here = size <= level ? 0 : (angle[k] > 0.0 ? 1 : -1);
    if (last < at.size() && here != before)
      found.push_back(
          {0.5 * (end_of(last, before, here) + end_of(k - 1, here, before)), 3 * before + here});
    before = here;
    last = k;
  }
  return found;
}

std::vector<Feature> features_of(const ProfileCurve& curve) {
  const std::vector<Feature> bends = bends_of(curve);
  std::vector<Feature> all = bends, inside;
  const ProfileKnots& knots = curve.knots();
  for (const std::size_t k : kinks_of({knots.y, knots.z})) {
    const double kink = knots.parameter[k];
    if (std::none_of(bends.begin(), bends.end(), [&](const Feature& bend) {
          return std::abs(bend.parameter - kink) < same_bend;
        }))
      all.push_back({kink});
  }
  std::sort(all.begin(), all.end(),
            [](const Feature& a, const Feature& b) { return a.parameter < b.parameter; });
  for (const auto& [parameter, kind, y, z] : all) {
    const ProfilePoint place = curve.at(parameter);
    if (std::min(parameter - curve.first(), curve.last() - parameter) > least_from_end)
      inside.push_back({parameter, kind, place.y, place.z});
  }
  return inside;
}

/// The first of `all`, with their places in the section beside, to which the features of a section
/// correspond, one after the other; none where they do so in no way or in two alike.
std::optional<std::size_t> first_of(const std::vector<Feature>& here,
                                    const std::vector<Feature>& all) {
  std::optional<std::size_t> best;
  double least = std::numeric_limits<double>::infinity(), second = least;
  for (std::size_t shift = 0; !here.empty() && shift + here.size() <= all.size(); ++shift) {
    double farthest = 0.0;
    for (std::size_t k = 0; k < here.size(); ++k) {
      const Feature &a = here[k], &b = all[shift + k];
      farthest = std::max(farthest, a.kind == b.kind ? std::hypot(a.y - b.y, a.z - b.z)
                                                     : std::numeric_limits<double>::infinity());
    }
    second = std::min(second, std::max(farthest, least));
    if (farthest < least) least = farthest, best = shift;
  }
  return least < 0.5 * second ? best : std::nullopt;
}

}  // namespace

std::string find_features(std::vector<PlacedSection>& sections) {
  std::vector<std::vector<Feature>> found;
  for (const PlacedSection& section : sections) found.push_back(features_of(section.curve));
  const auto fullest = std::max_element(
      found.begin(), found.end(), [](const auto& a, const auto& b) { return a.size() < b.size(); });
  if (fullest->empty()) return "";
  const auto count = static_cast<std::ptrdiff_t>(found.size());
  for (const std::ptrdiff_t step : {1, -1}) {
    std::vector<Feature> all = *fullest;
    for (std::ptrdiff_t k = fullest - found.begin(); k >= 0 && k < count; k += step) {
      const auto i = static_cast<std::size_t>(k);
      const auto first = first_of(found[i], all);
      if (!first) {
        for (PlacedSection& section : sections) section.features.clear();
        return fmt::format(
            "the {} bends and kinks of the section at {:g} do not correspond to the {} of the "
            "section at {:g}; give the arc lengths of features in every line to keep edges sharp",
            found[i].size(), sections[i].position, fullest->size(),
            sections[static_cast<std::size_t>(fullest - found.begin())].position);
      }
      sections[i].features.assign(all.size(), std::numeric_limits<double>::quiet_NaN());
      for (std::size_t f = 0; f < found[i].size(); ++f) {
        all[*first + f] = found[i][f];
        sections[i].features[*first + f] = found[i][f].parameter;
      }
    }
  }
  return "";
}

}  // namespace rollfem::profiles
