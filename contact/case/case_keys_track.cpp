// Declarations of how wheels with profiles stand and move on the track: [track], [wheelset] and the
// vertical force.
#include "contact/case/case_key_parts.hpp"

namespace rollfem::contact {

namespace {

const Words inclination_words{"none", "1:20", "1:40"};
const std::vector<double> inclinations{0.0, 1.0 / 20.0, 1.0 / 40.0};
const Words side_words{"left", "right", "both"};
const Words free_rolling_words{"none", "force", "torque"};

struct Description {
  std::string name, symbol, unit;
  Bounds bounds;
  std::string when_absent, example, sentence;
};

Key described(const std::string& section, KeyKind kind, const Description& text) {
  Key key;
  key.section = section;
  key.name = text.name;
  key.kind = kind;
  key.symbol = text.symbol;
  key.unit = text.unit;
  key.bounds = text.bounds;
  key.when_absent = text.when_absent;
  key.example = text.example;
  key.sentence = text.sentence;
  return key;
}

template <class Part>
Key number_key(const std::string& section, Part Case::*part, double Part::*member,
               const Description& text) {
  Key key = described(section, KeyKind::number, text);
  key.get = [part, member](const Case& c) -> KeyValue { return c.*part.*member; };
  key.set = [part, member](Case& c, const KeyValue& v) { c.*part.*member = std::get<double>(v); };
  return key;
}

/// A list over the positions of the wheelset, made one length by complete_track.
Key position_key(std::vector<double> Wheelset::*member, const Description& text) {
  Key key = described("wheelset", KeyKind::numbers, text);
  key.get = [member](const Case& c) -> KeyValue {
    const std::vector<double>& values = c.wheelset.*member;
    if (values.empty()) return {};
    return shortened(values, [](double value) { return std::optional<double>(value); });
  };
  key.set = [member](Case& c, const KeyValue& v) { c.wheelset.*member = std::get<Numbers>(v); };
  return key;
}

Key inclination_key() {
  Key key = described("track", KeyKind::word,
                      {"inclination",
                       "",
                       "",
                       {},
                       "required with profiles",
                       R"("1:40")",
                       "How far the rails lean towards the middle of the track; `none` also where "
                       "the rail's profile was measured in place."});
  key.words = inclination_words;
  key.get = [](const Case& c) -> KeyValue {
    const auto found = std::find(inclinations.begin(), inclinations.end(), c.track.inclination);
    return inclination_words.at(static_cast<std::size_t>(found - inclinations.begin()));
  };
  key.set = [](Case& c, const KeyValue& v) {
    const auto found =
        std::find(inclination_words.begin(), inclination_words.end(), std::get<std::string>(v));
    c.track.inclination =
        inclinations.at(static_cast<std::size_t>(found - inclination_words.begin()));
  };
  return key;
}

Key rotation_change_key() {
  Key key = described(
      "wheelset", KeyKind::numbers,
      {"rotation_change",
       "",
       "",
       {0.0, 1.0, false, true},
       "0: the wheelset turns with V / rolling_radius",
       "",
       "Relative change of the wheelset's rotation against V / rolling_radius: positive drives, "
       "negative brakes. A list makes a creep curve; not with longitudinal_creepage."});
  key.get = [](const Case& c) -> KeyValue {
    if (c.wheelset.rotation_change.empty()) return {};
    return shortened(c.wheelset.rotation_change,
                     [](double value) { return std::optional<double>(value); });
  };
  key.set = [](Case& c, const KeyValue& v) {
    c.wheelset.rotation_change.resize(c.rolling.creepages.size());
    set_per_load_point(c, v, [](Case& all, std::size_t k, double number) {
      all.wheelset.rotation_change[k] = number;
    });
  };
  return key;
}

Key vertical_force_key() {
  Key key =
      described("load", KeyKind::number,
                {"vertical_force",
                 "Q",
                 "N",
                 {1e-6, 1e12},
                 "exactly one of normal_force, approach and vertical_force is given",
                 "",
                 "With profiles: vertical force on each wheel, which normal force and friction of "
                 "all its patches carry together."});
  key.get = [](const Case& c) { return optional_number(c.load.vertical_force); };
  key.set = [](Case& c, const KeyValue& v) { c.load.vertical_force = std::get<double>(v); };
  return key;
}

}  // namespace

std::vector<Key> track_keys() {
  const Bounds lengths{1.0, 1e4};
  return {
      vertical_force_key(),
      number_key("track", &Case::track, &Track::gauge,
                 {"gauge", "", "mm", lengths, "", "", "Distance between the rails."}),
      number_key("track", &Case::track, &Track::gauge_height,
                 {"gauge_height",
                  "",
                  "mm",
                  {0.1, 100.0},
                  "",
                  "",
                  "How far below the top of the rails the gauge is measured."}),
      inclination_key(),
  };
}

std::vector<Key> wheelset_keys() {
  const Bounds angle{0.0, 0.2, false, true};
  const Bounds place{0.0, 1e3, false, true};
  return {
      word_key<WheelSide>("wheelset", "side", side_words,
                          "The wheels that are computed; both are placed in any case.",
                          [](Case& c) -> WheelSide& { return c.wheelset.side; }),
      number_key("wheelset", &Case::wheelset, &Wheelset::flange_back_distance,
                 {"flange_back_distance",
                  "",
                  "mm",
                  {1.0, 1e4},
                  "",
                  "",
                  "Distance between the backs of the two flanges (back to back)."}),
      number_key("wheelset", &Case::wheelset, &Wheelset::flange_back_position,
                 {"flange_back_position", "", "mm", place, "", "",
                  "Where the back of the flange is in the wheel's profile: its y."}),
      position_key(&Wheelset::lateral_shift,
                   {"lateral_shift", "", "mm", place, "", "",
                    "Of the wheelset, positive to the right seen along x. A list makes positions: "
                    "lateral_shift, yaw and roll then have one length, or one number for all."}),
      position_key(&Wheelset::yaw, {"yaw", "", "rad", angle, "", "",
                                    "Of the wheelset about the vertical, positive to the right."}),
      position_key(&Wheelset::roll, {"roll", "", "rad", angle, "both wheels touch their rails", "",
                                     "Of the wheelset about x, positive when the right wheel is "
                                     "lower. With it each wheel touches its rail by itself."}),
      number_key("wheelset", &Case::wheelset, &Wheelset::lateral_velocity,
                 {"lateral_velocity",
                  "",
                  "",
                  {0.0, 1.0, false, true},
                  "",
                  "",
                  "Of the wheelset over its forward speed, positive to the right."}),
      number_key("wheelset", &Case::wheelset, &Wheelset::yaw_velocity,
                 {"yaw_velocity",
                  "",
                  "rad/mm",
                  {0.0, 1.0, false, true},
                  "",
                  "",
                  "Change of yaw over the distance rolled."}),
      rotation_change_key(),
      word_key<FreeRolling>(
          "wheelset", "free_rolling", free_rolling_words,
          "What decides the rotation in place of rotation_change: `force`, no F_x on each wheel by "
          "itself; `torque`, no torque of both wheels about the axle; `none`, nothing.",
          [](Case& c) -> FreeRolling& { return c.wheelset.free_rolling; }),
  };
}

}  // namespace rollfem::contact
