// SPDX-License-Identifier: LGPL-2.1-or-later
#include "convert/stress_block.hpp"

#include <algorithm>

namespace rollfem::convert {

namespace {

/// Numbers of elements `first`, `first + step`, ... up to `last`, as CONTACT counts, from 1.
std::vector<double> every(const std::vector<double>& range, int most) {
  std::vector<double> numbers;
  if (range.size() < 3) return numbers;
  for (double k = std::max(range[0], 1.0); k <= std::min(range[2], double(most));
       k += std::max(range[1], 1.0))
    numbers.push_back(k);
  return numbers;
}

/// All, a range, or those given.
std::vector<double> elements_of(int kind, const std::vector<double>& given, int most) {
  if (kind == 3 || kind == 7) return given;
  return every(kind == 2 || kind == 6 ? given : std::vector<double>{1.0, 1.0, double(most)}, most);
}

}  // namespace

StressBlock stress_block(int kind, const std::array<std::vector<double>, 3>& given,
                         const std::array<int, 2>& elements) {
  const auto& [x, y, z] = given;
  if (kind == 9) return {false, x, y, z};
  StressBlock block{true, elements_of(kind, x, elements[0]), elements_of(kind, y, elements[1]), z};
  if (kind >= 5) return block;
  block.z.clear();  // NZ, ZL, DZ
  for (double k = 0.0; z.size() >= 3 && k < z[0]; ++k) block.z.push_back(z[1] + k * z[2]);
  return block;
}

}  // namespace rollfem::convert
