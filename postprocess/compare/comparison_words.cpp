// The comparison of one case in words.
#include "postprocess/compare/comparison.hpp"
#include "postprocess/compare/comparison_spoken.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rollfem::postprocess {

const std::vector<Spoken>& spoken() {
  static const std::vector<Spoken> all{{"max_pressure", "largest pressure", " %"},
                                       {"semi_axis_x", "semi-axis along x", " %"},
                                       {"semi_axis_y", "semi-axis along y", " %"},
                                       {"traction_coefficient", "traction coefficient", " % of mu"},
                                       {"lateral_coefficient", "lateral coefficient", " % of mu"},
                                       {"max_traction_x", "largest |p_x|", " % of mu p0"}};
  return all;
}

std::string percent(double value) {
  const double size = std::abs(100.0 * value);
  return fmt::format("{:.{}f}", size,
                     size >= 9.95     ? 0
                     : size >= 0.995  ? 1
                     : size >= 0.0995 ? 2
                                      : 3);
}

std::string list(const std::vector<std::string>& parts, const char* separator) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : separator) + part;
  return text;
}

const Standing* find_standing(const std::vector<Standing>& standings, const std::string& model,
                              const std::string& quantity) {
  for (const Standing& standing : standings)
    if (standing.model == model && standing.quantity == quantity) return &standing;
  return nullptr;
}

namespace {

/// So many places get sentences of their own; of more, one sentence says where it is worst.
constexpr std::size_t most_places = 4;

/// The different values of a member, in their order.
std::vector<std::string> values_of(const std::vector<Standing>& standings,
                                   std::string Standing::*member) {
  std::vector<std::string> values;
  for (const Standing& standing : standings)
    if (std::find(values.begin(), values.end(), standing.*member) == values.end())
      values.push_back(standing.*member);
  return values;
}

/// Where on the creep curve, and at which place when the standing is of several.
std::string where(const Standing& standing) {
  const ComparedNumber& worst = standing.beyond;
  if (standing.compared < 2) return {};
  std::string text = fmt::format(" at load point {}, xi = {:.4g} %", worst.point,
                                 100.0 * worst.longitudinal_creepage);
  if (standing.patch.empty() && !worst.patch.empty()) text += ", " + worst.patch;
  return text;
}

std::string difference_words(const Standing& standing, const Spoken& about) {
  const ComparedNumber& worst = standing.beyond;
  std::string text =
      fmt::format("{} {} by {}{}{}, where they allow {} %", about.name,
                  worst.difference() > 0.0 ? "higher" : "lower", percent(worst.difference()),
                  about.unit, where(standing), percent(worst.allowed()));
  if (standing.compared > 1)
    text += fmt::format(" (at {} of {} load points", standing.differ, standing.compared);
  if (std::abs(standing.worst.difference()) > std::abs(worst.difference()))
    text +=
        fmt::format("; the largest difference is {} %, {}", percent(standing.worst.difference()),
                    standing.worst.differs() ? "with larger bars" : "within them");
  return text + (standing.compared > 1 ? ")" : "");
}

/// How one model stands at one place, or at all of them together.
std::string model_words(const std::vector<Standing>& standings, const std::string& model) {
  std::vector<std::string> agree;
  std::vector<std::string> differ;
  std::string reference;
  for (const Spoken& about : spoken()) {
    const Standing* standing = find_standing(standings, model, about.quantity);
    if (standing == nullptr) continue;
    reference = standing->reference;
    if (standing->differ > 0)
      differ.push_back(difference_words(*standing, about));
    else
      agree.push_back(
          fmt::format("{} ({}{})", about.name, percent(standing->worst.difference()), about.unit));
  }
  std::string text = fmt::format("{} against {}: ", model, reference);
  if (!agree.empty()) text += "within the error bars: " + list(agree, ", ");
  if (!agree.empty() && !differ.empty()) text += "; ";
  if (!differ.empty())
    text += (agree.empty() ? "beyond the error bars: " : "beyond them: ") + list(differ, "; ");
  return text + ".";
}

}  // namespace

std::vector<std::string> comparison_words(const std::vector<Standing>& standings) {
  const std::vector<std::string> places = values_of(standings, &Standing::patch);
  const bool one_by_one = places.size() <= most_places;
  const std::vector<Standing> all = one_by_one ? standings : over_places(standings);
  std::vector<std::string> sentences;
  for (const std::string& place : values_of(all, &Standing::patch)) {
    std::vector<Standing> here;
    for (const Standing& standing : all)
      if (standing.patch == place) here.push_back(standing);
    for (const std::string& model : values_of(here, &Standing::model))
      sentences.push_back((places.size() > 1 && !place.empty() ? place + ": " : "") +
                          model_words(here, model));
  }
  return sentences;
}

}  // namespace rollfem::postprocess
