// SPDX-License-Identifier: LGPL-2.1-or-later
// Damage to files, the same in every run of a seed: bits turned, cut short, blocks zeroed, moved or
// doubled, numbers of a text replaced by impossible ones.
#pragma once

#include "support/test.hpp"

namespace rollfem::testing {

/// How many damaged files a test tries: `usual`, or as many as ROLLFEM_DAMAGED says.
inline int damaged_files(int usual) {
  const char* asked = std::getenv("ROLLFEM_DAMAGED");
  return asked != nullptr ? std::atoi(asked) : usual;
}

class Damage {
 public:
  explicit Damage(unsigned long long seed) : random_(seed) {}

  std::size_t below(std::size_t bound) { return bound == 0 ? 0 : random_() % bound; }

  /// Never the bytes that it is given.
  std::string of(const std::string& bytes) {
    std::string damaged = bytes;
    while (damaged == bytes) damaged = once(damaged);
    if (below(4) == 0) damaged = once(damaged);
    return damaged == bytes ? bytes.substr(0, bytes.size() / 2) : damaged;
  }

 private:
  std::string once(std::string bytes) {
    const std::size_t at = below(bytes.size());
    const std::size_t length = std::min(bytes.size() - at, 1 + below(1 + below(600)));
    switch (below(8)) {
      case 0:
      case 1:
        for (std::size_t k = 0, count = 1 + below(8); k < count && !bytes.empty(); ++k)
          bytes[below(bytes.size())] ^= static_cast<char>(1U << below(8));
        return bytes;
      case 2:
        return bytes.substr(0, at);
      case 3:
        return bytes.replace(at, length, length, '\0');
      case 4:  // one block over another
        return bytes.replace(at, length, bytes, below(bytes.size()), length);
      case 5:
        return bytes.erase(at, length);
      case 6:
        return bytes.insert(at, bytes.substr(below(bytes.size()), length));
      default:
        return with_number(std::move(bytes), at);
    }
  }

  /// A number of a text, or eight bytes of what is none.
  std::string with_number(std::string bytes, std::size_t at) {
    constexpr std::array<const char*, 14> impossible{"-1",
                                                     "0",
                                                     "2147483648",
                                                     "-2147483649",
                                                     "4294967297",
                                                     "9223372036854775807",
                                                     "-9223372036854775808",
                                                     "18446744073709551616",
                                                     "1e308",
                                                     "-1e309",
                                                     "nan",
                                                     "inf",
                                                     "1e-320",
                                                     "0x10"};
    const std::string digits = "0123456789.-e";
    const std::size_t begin = bytes.find_first_of(digits, at);
    if (begin == bytes.npos) return bytes;
    const std::size_t end = std::min(bytes.find_first_not_of(digits, begin), bytes.size());
    return bytes.replace(begin, end - begin, impossible[below(impossible.size())]);
  }

  std::mt19937_64 random_;
};

}  // namespace rollfem::testing
