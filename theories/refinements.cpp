#include "theories/refinements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace rollfem::theories {

using contact::ModelInput;
using contact::RefinedInput;
using contact::Refinement;

namespace {

/// A count of the case at level k.
int scaled(int count, int k) {
  return std::max(1, count / 4) * (1 << k);
}

RefinedInput strips_level(int strips, ModelInput input) {
  return {fmt::format("{} strips", strips), static_cast<double>(strips), std::move(input)};
}

RefinedInput carter_level(ModelInput input, int k, int /*n*/) {
  input.carter.strips = scaled(input.carter.strips, k);
  return strips_level(input.carter.strips, std::move(input));
}

RefinedInput fastsim_level(ModelInput input, int k, int /*n*/) {
  input.fastsim.strips = scaled(input.fastsim.strips, k);
  input.fastsim.strip_elements = scaled(input.fastsim.strip_elements, k);
  return strips_level(input.fastsim.strips, std::move(input));
}

RefinedInput strip_level(ModelInput input, int k, int /*n*/) {
  input.strip.strips = scaled(input.strip.strips, k);
  input.strip.strip_elements = scaled(input.strip.strip_elements, k);
  return strips_level(input.strip.strips, std::move(input));
}

Refinement strips_of(RefinedInput (*level)(ModelInput, int, int)) {
  return {"grid", "", "strips", 2.0, 5, false, level};
}

}  // namespace

Refinement carter_strips() {
  return strips_of(carter_level);
}

Refinement fastsim_strips() {
  return strips_of(fastsim_level);
}

Refinement strip_strips() {
  return strips_of(strip_level);
}

}  // namespace rollfem::theories
