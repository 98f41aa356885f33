// SPDX-License-Identifier: LGPL-2.1-or-later
// A profile: the first line is the name of the file, with `wheel` or `rail` before it and keys that
// mend behind it; the rest is the file. Read, mended, checked, made a curve.
#include "base/errors.hpp"
#include "profiles/profile_curve.hpp"
#include "profiles/profiles.hpp"

#include "fuzz/target.hpp"
#include <algorithm>
#include <sstream>

using namespace rollfem;

namespace {

contact::ProfileSource source_of(std::istream& words) {
  contact::ProfileSource source;
  words >> source.name;
  for (std::string word; words >> word;) {
    source.mirror |= word == "mirror";
    source.flip |= word == "flip";
    source.reverse |= word == "reverse";
    source.sort |= word == "sort";
    source.drop_duplicates |= word == "drop_duplicates";
    source.drop_zigzag |= word == "drop_zigzag";
    if (word == "rounding") source.rounding = 1.0;
    if (word == "smoothing") source.smoothing = 0.01;
    if (word == "thinning") source.thinning = 0.5;
    if (word == "inch") source.unit = contact::LengthUnit::inch;
    if (word == "m") source.unit = contact::LengthUnit::m;
    if (word == "kinks") source.largest_kink = 180.0;
  }
  return source;
}

}  // namespace

std::string outcome_of(const std::string& input) {
  const std::size_t end = std::min(input.find('\n'), input.size());
  std::istringstream words(input.substr(0, end));
  std::string body;
  words >> body;
  contact::ProfileSource source = source_of(words);
  // As in a case file, where a text has no control characters.
  const auto control = [](unsigned char c) { return c < 0x20 || c == 0x7f; };
  if (source.name.empty() || std::any_of(source.name.begin(), source.name.end(), control))
    source.name = "profile.txt";
  try {
    const bool wheel = body != "rail";
    const profiles::ProfileCurve curve =
        profiles::profile_of_text(input.substr(std::min(end + 1, input.size())), source, wheel);
    static_cast<void>(profiles::profile_features(curve, wheel));
    static_cast<void>(profiles::flange_tip(curve));
  } catch (const contact::InputError& error) {
    return error.what();
  }
  return "";
}
