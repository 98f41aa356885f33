#include "convert/read_case.hpp"
#include <algorithm>

namespace rollfem::convert {

namespace {

ProfileFile read_profile(InputLines& lines, const char* what) {
  const auto given = lines.named(what, {"MIRRORY", "SCALE", "SMOOTH"}, 2);
  ProfileFile profile;
  profile.name = given.text;
  profile.mirror_y = lines.whole(given.numbers[0], "MIRRORY", -1, 1);
  profile.scale = given.numbers[1];
  profile.smooth = given.numbers[2];
  if (given.numbers.size() > 3) profile.mirror_z = lines.whole(given.numbers[3], "MIRRORZ", -1, 1);
  const double option = given.numbers.size() > 4 ? given.numbers[4] : 0.0;
  profile.has_options = option >= 1.0;
  if (option >= 1.0) lines.numbers({"ISMOOTH", "ZIGTHRS", "KINKHIGH", "KINKLOW", "KINKWID"});
  if (option >= 2.0) lines.numbers({"ERRHND", "MAXOMIT"});
  return profile;
}

void read_track(InputLines& lines, ContactCase& next) {
  WheelRail& pair = next.wheel_rail;
  const int Z = next.digits.Z;
  if (Z == 1 || Z == 3) {
    const auto track = lines.numbers({"GAUGHT", "GAUGSQ", "GAUGWD", "CANT"});
    pair.gauge_height = track[0];
    pair.gauge_sequence = track[1];
    pair.gauge = track[2];
    pair.cant = track[3];
  }
  if (Z == 3) pair.rail = read_profile(lines, "the file of the rail's profile");
  if (Z == 2 || Z == 3)
    pair.rail_deviations = lines.numbers({"DY", "DZ", "ROLL", "VY", "VZ", "VROLL"});
  if ((Z == 2 || Z == 3) && next.digits.F == 3)
    lines.numbers({"KYRAIL", "FYRAIL", "KZRAIL", "FZRAIL"});
}

void read_wheelset(InputLines& lines, ContactCase& next) {
  WheelRail& pair = next.wheel_rail;
  const Digits& digits = next.digits;
  if (digits.E == 3 || digits.E == 5) {
    const auto size = lines.numbers({"FBDIST", "FBPOS", "NOMRAD"});
    pair.flange_back_distance = size[0];
    pair.flange_back_position = size[1];
    pair.nominal_radius = size[2];
    pair.wheel = read_profile(lines, "the file of the wheel's profile");
  }
  const auto six = [&](std::array<double, 6>& into, const std::vector<std::string>& names) {
    const auto values = lines.numbers(names);
    std::copy(values.begin(), values.end(), into.begin());
  };
  if (digits.E >= 1)
    six(pair.position, {"S", "Y", digits.N == 0 ? "Z" : "FZ", "ROLL", "YAW", "PITCH"});
  if (digits.E >= 2)
    six(pair.velocity, {"VS", "VY", "VZ", "VROLL", "VYAW",
                        digits.F == 1   ? "FX"
                        : digits.F == 2 ? "MY"
                                        : "VPITCH"});
  if (digits.E == 4 || digits.E == 5) {
    pair.wheel_deviations = lines.numbers({"DX", "DY", "DZ", "DROLL", "DYAW", "DPITCH"});
    const auto rates = lines.numbers({"VX", "VY", "VZ", "VROLL", "VYAW", "VPITCH"});
    pair.wheel_deviations.insert(pair.wheel_deviations.end(), rates.begin(), rates.end());
  }
}

}  // namespace

void read_wheel_rail(InputLines& lines, ContactCase& next) {
  if (next.digits.D >= 2) {
    const auto grid = lines.numbers({"DX", "DS", "DQREL", "A_SEP", "D_SEP", "D_COMB"}, 2);
    next.wheel_rail.dx = grid[0];
    next.wheel_rail.ds = grid[1];
  }
  read_track(lines, next);
  read_wheelset(lines, next);
}

}  // namespace rollfem::convert
