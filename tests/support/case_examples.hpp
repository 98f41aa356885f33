// A small valid case file for the tests, and variations of it.
#pragma once

#include <stdexcept>
#include <string>

namespace rollfem::testing {

inline const std::string small_case = R"([load]
normal_force = 50e3
[friction]
coefficient = 0.55
[wheel]
rolling_radius = 405.0
transverse_radius = inf
[rail]
transverse_radius = 2000.0
)";

/// The small case with one piece of text replaced by another.
inline std::string with(const std::string& piece, const std::string& replacement) {
  std::string text = small_case;
  const std::size_t at = text.find(piece);
  if (at == std::string::npos) throw std::logic_error("no '" + piece + "' in the small case");
  return text.replace(at, piece.size(), replacement);
}

/// The small case with lines added at the end.
inline std::string plus(const std::string& lines) {
  return small_case + lines;
}

}  // namespace rollfem::testing
