#include "contact/scene/derived_values.hpp"

#include "contact/scene/geometry.hpp"

#include <fmt/format.h>

namespace rollfem::contact {

std::string derived_values(const Case& input) {
  const Curvatures curvatures = relative_curvatures(input);
  const CombinedMaterial material = combine(input.wheel.material, input.rail.material);
  std::string text = "what follows\n";
  const auto line = [&](const char* name, double value, const char* unit, const char* meaning) {
    text += fmt::format("  {:<22} {:.6g}{}  ({})\n", name, value, unit, meaning);
  };
  if (!input.given_pressure && !input.undeformed_distance.values && !input.has_profiles()) {
    line("A", curvatures.A, " 1/mm", "undeformed distance h = A x^2 + B y^2");
    line("B", curvatures.B, " 1/mm",
         input.undeformed_distance.quadratic ? "as given"
                                             : "from the transverse radii of wheel and rail");
  }
  line("E*", material.contact_modulus, " MPa", "contact modulus of both bodies");
  line("G", material.shear_modulus, " MPa", "combined shear modulus");
  line("nu", material.poisson_ratio, "", "combined Poisson's ratio");
  line("K", material.difference, "",
       "unlike materials couple pressure and friction; 0: they do not");
  text += fmt::format("  {:<22} {}\n", "load points", input.rolling.creepages.size());
  return text;
}

}  // namespace rollfem::contact
