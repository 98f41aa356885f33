// What the sentences of a comparison share: the quantities that they are about, and numbers for
// reading. Internal to postprocess.
#pragma once

#include "postprocess/compare/comparison.hpp"

#include <string>
#include <vector>

namespace rollfem::postprocess {

/// A quantity as sentences name it.
struct Spoken {
  const char* quantity;
  const char* name;
  const char* unit;  ///< of a difference
};

/// What the sentences are about, in their order; the files have more.
const std::vector<Spoken>& spoken();

/// Percent with two digits that mean something, without sign and unit.
std::string percent(double value);

/// The parts with a separator between them.
std::string list(const std::vector<std::string>& parts, const char* separator);

/// The standing of a model in a quantity, or none.
const Standing* find_standing(const std::vector<Standing>& standings, const std::string& model,
                              const std::string& quantity);

}  // namespace rollfem::postprocess
