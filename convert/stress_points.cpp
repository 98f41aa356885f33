#include <fmt/format.h>

#include "convert/equivalent.hpp"
#include <algorithm>
#include <array>
#include <cmath>

namespace rollfem::convert {

namespace {

constexpr std::size_t most_entries = 100;  // of a case file

bool equally_spaced(const std::vector<double>& values) {
  const double step = (values.back() - values.front()) / static_cast<double>(values.size() - 1);
  for (std::size_t k = 1; k < values.size(); ++k)
    if (std::abs(values[k] - values[k - 1] - step) > 1e-6 * std::abs(step)) return false;
  return true;
}

std::string place(const std::array<double, 3>& p) {
  return fmt::format("[{:.12g}, {:.12g}, {:.12g}]", p[0], p[1], p[2]);
}

const char* body_of(double z) {
  return z >= 0.0 ? "wheel" : "rail";
}

/// A block in mm, in our axes.
class Block {
 public:
  Block(const StressBlock& given, const ElementPlaces& elements, double sign)
      : along_{given.x, given.y, given.z} {
    if (given.by_element) {
      for (double& x : along_[0]) x = elements.x + (x - 0.5) * elements.dx;
      for (double& y : along_[1]) y = elements.y + (y - 0.5) * elements.dy;
    }
    for (std::size_t c = 0; c < 2; ++c)
      for (double& value : along_[c]) value = in_mm(sign * value);
    for (auto& values : along_) std::sort(values.begin(), values.end());
  }

  /// One line for all points of one direction, if there are some equally far from each other.
  std::vector<std::string> entries() const {
    std::size_t line = 3;
    for (std::size_t c = 0; c < 3; ++c) {
      const bool one_body = c < 2 || along_[2].front() * along_[2].back() >= 0.0;
      if (along_[c].size() > 1 && one_body && equally_spaced(along_[c]) &&
          (line == 3 || along_[c].size() > along_[line].size()))
        line = c;
    }
    std::size_t number = 1;
    for (std::size_t c = 0; c < 3; ++c)
      if (c != line) number *= along_[c].size();
    std::vector<std::string> all;
    if (number > most_entries) return all;
    walk(line, {}, 0, all);
    return all;
  }

 private:
  void walk(std::size_t line, std::array<double, 3> at, std::size_t c,
            std::vector<std::string>& all) const {
    if (c == 3) return all.push_back(entry(line, at));
    if (c == line) return walk(line, at, c + 1, all);
    for (const double value : along_[c]) {
      at[c] = value;
      walk(line, at, c + 1, all);
    }
  }

  std::string entry(std::size_t line, std::array<double, 3> at) const {
    if (line == 3)
      return fmt::format("[[subsurface.point]]\nbody = \"{}\"\nat = {}\n", body_of(at[2]),
                         place(at));
    std::array<double, 3> from = at, to = at;
    from[line] = along_[line].front();
    to[line] = along_[line].back();
    return fmt::format("[[subsurface.line]]\nbody = \"{}\"\nfrom = {}\nto = {}\npoints = {}\n",
                       body_of(std::min(from[2], to[2]) < 0.0 ? -1.0 : 1.0), place(from), place(to),
                       along_[line].size());
  }

  std::array<std::vector<double>, 3> along_;
};

}  // namespace

void fill_stresses(const ContactCase& given, const ElementPlaces& elements, double sign,
                   Equivalent& made) {
  if (given.digits.S == 0 || given.digits.M != 0) return;
  std::size_t entries = 0;
  for (const StressBlock& block : given.stress_blocks) {
    if (block.x.empty() || block.y.empty() || block.z.empty()) continue;
    const auto texts = Block(block, elements, sign).entries();
    entries += texts.size();
    if (texts.empty() || entries > most_entries)
      made.notes.push_back(
          fmt::format("a block of {} by {} by {} points below the surface is not converted: "
                      "rollfem stress evaluates planes and lines after the run",
                      block.x.size(), block.y.size(), block.z.size()));
    else
      for (const std::string& text : texts) made.stresses += "\n" + text;
  }
}

}  // namespace rollfem::convert
