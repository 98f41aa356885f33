// Suggestions for misspelt names.
#pragma once

#include <string>
#include <vector>

namespace rollfem::contact {

/// The candidate that is nearest to a misspelt name; empty when none is near.
std::string nearest_name(const std::string& name, const std::vector<std::string>& candidates);

/// "did you mean NAME? ", for a message; empty when none is near.
std::string did_you_mean(const std::string& name, const std::vector<std::string>& candidates);

}  // namespace rollfem::contact
