#include "meshes/profiles.hpp"

#include "contact/errors.hpp"
#include "meshes/built_in_profiles.hpp"

namespace rollfem::meshes {

ProfileCurve make_profile(const contact::ProfileSource& source, bool wheel,
                          const std::string& case_file) {
  if (const BuiltInProfile* profile = find_built_in_profile(source.name)) return profile->make();
  throw contact::InputError(case_file + ": no profile is called " + source.name);
  (void)wheel;
}

}  // namespace rollfem::meshes
