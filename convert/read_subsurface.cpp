#include <fmt/format.h>

#include "convert/read_case.hpp"
#include <algorithm>

namespace rollfem::convert {

namespace {

constexpr int largest_block = 100000;  // points along one direction

std::size_t points(const InputLines& lines, double value, const char* name) {
  return static_cast<std::size_t>(lines.whole(value, name, 1, largest_block));
}

/// Numbers of elements `first`, `first + step`, ... up to `last`, as CONTACT counts, from 1.
std::vector<double> every(const std::vector<double>& range, int most) {
  std::vector<double> numbers;
  for (double k = std::max(range[0], 1.0); k <= std::min(range[2], double(most));
       k += std::max(range[1], 1.0))
    numbers.push_back(k);
  return numbers;
}

/// Which places across the surface a block of kind 1 to 7 has.
void read_elements(InputLines& lines, int kind, const PotentialContact& area, StressBlock& block) {
  block.by_element = true;
  block.x = every({1.0, 1.0, double(area.mx)}, area.mx);
  block.y = every({1.0, 1.0, double(area.my)}, area.my);
  if (kind == 2 || kind == 6) {
    block.x = every(lines.numbers({"IXL", "IXINC", "IXH"}), area.mx);
    block.y = every(lines.numbers({"IYL", "IYINC", "IYH"}), area.my);
  } else if (kind == 3 || kind == 7) {
    const auto n = lines.numbers({"NX", "NY"});
    block.x = lines.array("IX", points(lines, n[0], "NX"));
    block.y = lines.array("IY", points(lines, n[1], "NY"));
  }
}

void read_depths(InputLines& lines, int kind, StressBlock& block) {
  if (kind >= 5) {
    block.z = lines.array("Z", points(lines, lines.numbers({"NZ"}).front(), "NZ"));
    return;
  }
  const auto depths = lines.numbers({"NZ", "ZL", "DZ"});
  const std::size_t n = points(lines, depths[0], "NZ");
  for (std::size_t k = 0; k < n; ++k)
    block.z.push_back(depths[1] + static_cast<double>(k) * depths[2]);
}

}  // namespace

void read_subsurface(InputLines& lines, ContactCase& next) {
  const int S = next.digits.S;
  if (S < 2) return;
  lines.numbers({"MATFIL", "OUTPUT"});
  if (S < 3) return;
  next.stress_blocks.clear();
  while (true) {
    const int kind = lines.whole(lines.numbers({"ISUBS"}).front(), "ISUBS", 0, 9);
    if (kind == 0) return;
    if (kind == 4 || kind == 8)
      lines.fail(fmt::format("ISUBS = {}; allowed: 0 to 3, 5 to 7, 9", kind),
                 "look at the line above");
    StressBlock block;
    if (kind == 9) {
      const auto n = lines.numbers({"NX", "NY", "NZ"});
      block.x = lines.array("X", points(lines, n[0], "NX"));
      block.y = lines.array("Y", points(lines, n[1], "NY"));
      block.z = lines.array("Z", points(lines, n[2], "NZ"));
    } else {
      read_elements(lines, kind, next.potential, block);
      read_depths(lines, kind, block);
    }
    next.stress_blocks.push_back(block);
  }
}

}  // namespace rollfem::convert
