// Declarations of the profiles: what they are, and what may be mended of those from files.
#include "contact/case/case_key_parts.hpp"

#include <fmt/format.h>

#include <array>

namespace rollfem::contact {

namespace {

const Words unit_words{"mm", "m", "inch"};
const Bounds any_place{0.0, 1e6, false, true};

template <bool wheel>
ProfileSource& profile(Case& c) {
  if constexpr (wheel) return c.wheel.profile;
  return c.rail.profile;
}

template <bool wheel>
const ProfileSource& profile(const Case& c) {
  return profile<wheel>(const_cast<Case&>(c));
}

/// Nothing for a default while the body has no profile: a template of a case leaves the section
/// out.
template <bool wheel, class Value>
KeyValue of_profile(const Case& c, const Value& value, const Value& initial) {
  if (profile<wheel>(c).name.empty() && value == initial) return {};
  return value;
}

template <bool wheel>
Key plain_key(const std::string& name, KeyKind kind, const std::string& unit,
              const std::string& sentence) {
  Key key;
  key.section = wheel ? "wheel_profile" : "rail_profile";
  key.name = name;
  key.kind = kind;
  key.unit = unit;
  key.sentence = sentence;
  return key;
}

template <bool wheel>
Key number_key(const std::string& name, const std::string& unit, Bounds bounds,
               const std::string& sentence, double ProfileSource::*member) {
  Key key = plain_key<wheel>(name, KeyKind::number, unit, sentence);
  key.bounds = bounds;
  key.when_absent = fmt::format("{}", ProfileSource().*member);
  key.get = [member](const Case& c) {
    return of_profile<wheel>(c, profile<wheel>(c).*member, ProfileSource().*member);
  };
  key.set = [member](Case& c, const KeyValue& v) {
    profile<wheel>(c).*member = std::get<double>(v);
  };
  return key;
}

template <bool wheel>
Key list_key(const std::string& name, const std::string& unit, Bounds bounds,
             const std::string& when_absent, const std::string& sentence,
             std::vector<double> ProfileSource::*member) {
  Key key = plain_key<wheel>(name, KeyKind::numbers, unit, sentence);
  key.bounds = bounds;
  key.when_absent = when_absent;
  key.get = [member](const Case& c) -> KeyValue {
    const auto& values = profile<wheel>(c).*member;
    return values.empty() ? KeyValue() : KeyValue(values);
  };
  key.set = [member](Case& c, const KeyValue& v) {
    profile<wheel>(c).*member = std::get<Numbers>(v);
  };
  return key;
}

template <bool wheel>
Key switch_key(const std::string& name, const std::string& sentence, bool ProfileSource::*member) {
  Key key = plain_key<wheel>(name, KeyKind::boolean, "", sentence);
  key.when_absent = "false";
  key.get = [member](const Case& c) {
    return of_profile<wheel>(c, profile<wheel>(c).*member, ProfileSource().*member);
  };
  key.set = [member](Case& c, const KeyValue& v) { profile<wheel>(c).*member = std::get<bool>(v); };
  return key;
}

template <bool wheel>
Key name_key() {
  Key key = plain_key<wheel>("profile", KeyKind::text, "", "");
  key.section = wheel ? "wheel" : "rail";
  key.when_absent = "the body has a transverse_radius";
  key.sentence =
      std::string("The profile, in place of transverse_radius: ") +
      (wheel ? "`S1002` or `S1002-smooth`" : "`60E1` (the same as `UIC60`) or `UIC60-manchester`") +
      ", `arcs`, `polynomial`, or a file relative to the case file: two columns y, z (text or "
      "CSV), SIMPACK " +
      (wheel ? ".prw, MiniProf .whl" : ".prr, MiniProf .ban") + ". Details in [" +
      (wheel ? "wheel" : "rail") + "_profile]; see docs/profiles.md.";
  key.get = [](const Case& c) -> KeyValue {
    const std::string& name = profile<wheel>(c).name;
    return name.empty() ? KeyValue() : KeyValue(name);
  };
  key.set = [](Case& c, const KeyValue& v) { profile<wheel>(c).name = std::get<std::string>(v); };
  return key;
}

template <bool wheel>
void add_formulas(std::vector<Key>& keys) {
  keys.push_back(list_key<wheel>(
      "radii", "mm", curved_or_flat, "none, needed for `arcs`",
      "Profile `arcs`: radii of arcs tangent to each other, positive convex, negative concave, inf "
      "straight.",
      &ProfileSource::radii));
  keys.push_back(list_key<wheel>(
      "ends", "mm", any_place, "none, needed for `arcs`",
      "y at which the arcs end: with symmetric = true one for each radius, from the middle "
      "outwards; else one more than radii, from small to large y. The arcs pass through (0, 0).",
      &ProfileSource::ends));
  keys.push_back(switch_key<wheel>("symmetric",
                                   "The arcs are given for y > 0 and are the same for y < 0.",
                                   &ProfileSource::symmetric));
  keys.push_back(number_key<wheel>("slope", "", any_place,
                                   "dz/dy of the arcs at (0, 0), when they are not symmetric.",
                                   &ProfileSource::slope));
  keys.push_back(list_key<wheel>(
      "coefficients", "", any_force, "none, needed for `polynomial`",
      "Profile `polynomial`: z in mm over y in mm, lowest order first; those of several pieces "
      "one after the other, equally many for each.",
      &ProfileSource::coefficients));
  keys.push_back(list_key<wheel>(
      "limits", "mm", any_place, "none, needed for `polynomial`",
      "y at which the pieces begin and end, one more than pieces, rising; pieces meet in value "
      "and slope.",
      &ProfileSource::limits));
}

template <bool wheel>
void add_places(std::vector<Key>& keys) {
  keys.push_back(
      switch_key<wheel>("mirror", "Turn the sides around: y becomes -y.", &ProfileSource::mirror));
  keys.push_back(number_key<wheel>("rotation", "rad", Bounds{0.0, 1.6, false, true},
                                   "Turn the profile about (0, 0), positive from y to z; the "
                                   "rail's inclination is not meant (track.inclination).",
                                   &ProfileSource::rotation));
  Key shift =
      plain_key<wheel>("shift", KeyKind::pair, "mm", "Shift along y and z, after the rotation.");
  shift.bounds = any_place;
  shift.when_absent = "[0, 0]";
  shift.get = [](const Case& c) {
    const auto& value = profile<wheel>(c).shift;
    return of_profile<wheel>(c, Numbers(value.begin(), value.end()), Numbers{0.0, 0.0});
  };
  shift.set = [](Case& c, const KeyValue& v) {
    const auto& value = std::get<Numbers>(v);
    profile<wheel>(c).shift = {value.at(0), value.at(1)};
  };
  keys.push_back(shift);
}

template <bool wheel>
void add_mending(std::vector<Key>& keys) {
  Key unit = word_key<LengthUnit>(wheel ? "wheel_profile" : "rail_profile", "unit", unit_words,
                                  "Unit of the lengths in the file; SIMPACK files name their own.",
                                  [](Case& c) -> LengthUnit& { return profile<wheel>(c).unit; });
  unit.when_absent = "mm";
  unit.get = [](const Case& c) {
    return of_profile<wheel>(c, unit_words.at(static_cast<std::size_t>(profile<wheel>(c).unit)),
                             unit_words.front());
  };
  keys.push_back(unit);
  keys.push_back(
      switch_key<wheel>("flip", "The file's z points upward: z becomes -z.", &ProfileSource::flip));
  keys.push_back(
      switch_key<wheel>("reverse", "The file's last point comes first.", &ProfileSource::reverse));
  keys.push_back(
      switch_key<wheel>("sort", "Put the points in order of rising y.", &ProfileSource::sort));
  keys.push_back(switch_key<wheel>("drop_duplicates",
                                   "Leave out points that are within 1e-6 mm of the one before.",
                                   &ProfileSource::drop_duplicates));
  keys.push_back(switch_key<wheel>("drop_zigzag", "Leave out points at which the curve goes back.",
                                   &ProfileSource::drop_zigzag));
  keys.push_back(number_key<wheel>("thinning", "mm", Bounds{0.0, 10.0},
                                   "Points within this distance become one, their mean; 0: all "
                                   "are kept.",
                                   &ProfileSource::thinning));
  keys.push_back(number_key<wheel>("longest_gap", "mm", positive,
                                   "Points further apart than this are an error; up to it the "
                                   "curve bridges them.",
                                   &ProfileSource::longest_gap));
  keys.push_back(number_key<wheel>("largest_kink", "degrees", Bounds{0.1, 180.0},
                                   "A larger angle between two chords is an error, and so is a "
                                   "step that stands out from the other points.",
                                   &ProfileSource::largest_kink));
  keys.push_back(number_key<wheel>("rounding", "mm", Bounds{0.0, 100.0},
                                   "Leave out the points up to this distance to both sides of a "
                                   "kink or step, and bridge it smoothly; 0: kinks are errors.",
                                   &ProfileSource::rounding));
  keys.push_back(number_key<wheel>("smoothing", "mm", Bounds{0.0, 1.0},
                                   "Scatter of the measured points across the profile (standard "
                                   "deviation), which is smoothed away; 0: through the points.",
                                   &ProfileSource::smoothing));
}

template <bool wheel>
void add_profile(std::vector<Key>& keys) {
  keys.push_back(name_key<wheel>());
  add_formulas<wheel>(keys);
  add_places<wheel>(keys);
  add_mending<wheel>(keys);
}

}  // namespace

std::vector<Key> profile_keys() {
  std::vector<Key> keys;
  add_profile<true>(keys);
  add_profile<false>(keys);
  return keys;
}

}  // namespace rollfem::contact
