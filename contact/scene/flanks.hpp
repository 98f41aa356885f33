// The error for a patch that reaches the end of the circles of wheel and rail.
#pragma once

#include "contact/scene/geometry.hpp"

#include <string>

namespace rollfem::contact {

/// A sentence with what to do for a potential contact area that ends at y, mm; empty unless both
/// bodies are circles that have ended there: straight flanks as steep as each other touch as far as
/// they go.
std::string why_flanks_touch(const Geometry& geometry, double y);

}  // namespace rollfem::contact
