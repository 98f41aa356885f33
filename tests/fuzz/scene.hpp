// SPDX-License-Identifier: LGPL-2.1-or-later
// Scenes that are drawn from the bytes of an input, as case files with the files that they name.
#pragma once

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <unistd.h>

namespace rollfem::testing {

/// Numbers from bytes, two for each; 0 after the last.
class Draws {
 public:
  explicit Draws(std::string_view bytes) : bytes_(bytes) {}

  /// In [0, 1].
  double part() {
    const double value = static_cast<double>(byte()) * 256.0 + static_cast<double>(byte());
    return value / 65535.0;
  }
  double between(double a, double b) { return a + (b - a) * part(); }
  /// Evenly over the logarithm.
  double size(double a, double b) { return a * std::pow(b / a, part()); }
  double sign() { return chance(0.5) ? 1.0 : -1.0; }
  bool chance(double share) { return part() < share; }
  int count(int least, int most) {
    return least + static_cast<int>((most - least + 0.999) * part());
  }
  template <std::size_t n>
  std::string word(const std::array<const char*, n>& words) {
    return words[static_cast<std::size_t>(count(0, static_cast<int>(n) - 1))];
  }

 private:
  unsigned byte() {
    return next_ < bytes_.size() ? static_cast<unsigned char>(bytes_[next_++]) : 0;
  }

  std::string_view bytes_;
  std::size_t next_ = 0;
};

/// A folder of this process for the files of a scene.
inline const std::filesystem::path& scene_folder() {
  static const struct Folder {
    std::filesystem::path path =
        std::filesystem::temp_directory_path() / fmt::format("rollfem_fuzz_{}", ::getpid());
    Folder() { std::filesystem::create_directories(path); }
    ~Folder() {
      std::error_code ignored;
      std::filesystem::remove_all(path, ignored);
    }
  } folder;
  return folder.path;
}

inline void write_scene_file(const std::string& name, const std::string& text) {
  std::ofstream(scene_folder() / name) << text;
}

/// A line of a case file.
inline std::string key(const char* name, double value) {
  return fmt::format("{} = {}\n", name, value);
}
inline std::string key(const char* name, const std::string& word) {
  return fmt::format("{} = \"{}\"\n", name, word);
}

/// Where the wheel is, against one rail or on the track, with its load and friction; the grid has 4
/// to 8 elements across.
inline std::string placed(Draws& draw, bool rail_changes, bool wheel_changes) {
  std::string text = fmt::format(
      "models = [\"{}\"]\n",
      draw.chance(0.7) ? "halfspace" : draw.word<4>({"hertz", "linear", "fastsim", "strip"}));
  const double mild = draw.chance(0.5) ? 0.1 : 1.0;
  if (draw.chance(0.3)) {
    text += "[wheelset]\n" + key("side", draw.word<3>({"left", "right", "both"})) +
            key("lateral_shift", draw.between(-12.0, 12.0));
    if (draw.chance(0.5)) text += key("yaw", mild * draw.between(-0.2, 0.2));
    if (draw.chance(0.3)) text += key("roll", mild * draw.between(-0.1, 0.1));
  } else {
    const double way = draw.chance(0.7) ? 10.0 : 100.0;
    text += "[placement]\n" + key("side", draw.word<2>({"left", "right"})) +
            key("lateral_position", draw.between(-way, way));
    if (draw.chance(0.7)) text += key("yaw", mild * draw.between(-0.5, 0.5));
    if (draw.chance(0.7)) text += key("roll", mild * draw.between(-0.5, 0.5));
  }
  if (rail_changes) text += key("track_position", draw.between(0.0, 300.0));
  if (wheel_changes) text += key("wheel_angle", draw.between(-3.2, 3.2));
  if (draw.chance(0.15)) text += key("free_rolling", std::string("force"));
  const bool by_height = draw.chance(0.15);
  if (by_height) text += key("height", draw.between(-1.0, 2.0));
  if (text.find("[wheelset]") != std::string::npos)
    text += "[track]\n" + key("inclination", draw.between(-0.1, 0.1));
  if (!by_height)
    text += "[load]\n" + key("vertical_force", draw.chance(0.5) ? 80e3 : draw.size(1e-6, 1e9));
  text += "[friction]\n" + key("coefficient", draw.chance(0.6) ? 0.3 : draw.size(1e-12, 3.0));
  text += fmt::format("[contact_grid]\nelements_across = {}\n", draw.count(4, 8));
  if (draw.chance(0.2))
    text += "[halfspace]\n" + key("surface", draw.word<3>({"auto", "planar", "curved"}));
  if (draw.chance(0.1))
    text += "[layer]\n" + key("thickness", draw.size(1e-4, 1.0)) +
            key("shear_modulus", draw.size(1.0, 1e4));
  return text;
}

/// What the solver says of a case; "" with a solution.
std::string said_of(const std::string& text);

}  // namespace rollfem::testing
