// The profile that a case asks for: built in, by arcs, by a polynomial, or from a file, checked and
// mended only as told.
#pragma once

#include "contact/track.hpp"
#include "meshes/profile_curve.hpp"

#include <string>

namespace rollfem::meshes {

/// `wheel`: else rail. Files are relative to the folder of `case_file`. Throws contact::InputError
/// with the file, line and value of what is wrong.
ProfileCurve make_profile(const contact::ProfileSource& source, bool wheel,
                          const std::string& case_file);

}  // namespace rollfem::meshes
