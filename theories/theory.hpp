// SPDX-License-Identifier: LGPL-2.1-or-later
// Common parts of the theories as models: the equivalent ellipse of true profiles, load points
// of different loads, the work of friction over the patch, and the error against the half-space.
#pragma once

#include "contact/solve/model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace rollfem::theories {

/// Scope of a theory.
struct TheoryKind {
  bool with_friction = true;  ///< it has forces, too
  bool hertzian = true;       ///< its patch and pressure without true profiles are Hertz's
  contact::BarRules bars{};
};
/// A theory on Hertz's ellipse: closed forms throughout, or strips with error estimates.
inline constexpr TheoryKind closed_form{true, true, {true, contact::NoBar::theory}};
inline constexpr TheoryKind strips_on_ellipse{true, true, {true, contact::NoBar::not_estimated}};

/// A theory of an elliptic patch: `more` than the keys that all of them support. No checkpoint, for
/// a theory takes no time; its model error (difference from the half-space) is added.
contact::ModelInfo theory(const char* name, const char* label, const char* sentence,
                          const contact::Demands& more, const contact::Model& model,
                          TheoryKind kind = {});

/// A theory of an elliptic patch, on the equivalent ellipse where the case has true profiles.
contact::Model elliptic(const contact::Model& theory, bool leaves_extra_slip = false);

/// A theory that finds fields of traction and slip, and from them the work of friction and where it
/// is done.
contact::Model with_pass_work(const contact::Model& theory);

/// Refinement levels of a theory in a study: the case's strips and elements, members of its
/// options, are the third of five levels.
template <class Options, int Options::*strips, int Options::*... elements>
contact::Refinement refined_strips() {
  const auto level = [](contact::ModelInput input, int k, int /*n*/) -> contact::RefinedInput {
    const auto scaled = [k](int count) { return std::max(1, count / 4) * (1 << k); };
    auto& options = input.options.set<Options>();
    for (int* count : {&(options.*strips), &(options.*elements)...}) *count = scaled(*count);
    const int count = options.*strips;
    return {fmt::format("{} strips", count), static_cast<double>(count), std::move(input)};
  };
  return {"grid", "", "strips", 2.0, 5, false, level};
}

}  // namespace rollfem::theories
