// Which model can take which case: asked before anything is computed.
#pragma once

#include "contact/case/case.hpp"

#include <string>

namespace rollfem::contact {

/// Throws InputError when the model leaves out what the case asks for: it names what that is, and
/// the models that can take it. What depends on creepages (spin, lateral creepage, extra slip) is
/// refused by the theories themselves.
void check_able(const Case& input, const std::string& model);

}  // namespace rollfem::contact
