// Keys of the meshes of wheel and rail.
#include "contact/case/case_key_parts.hpp"

namespace rollfem::contact {

namespace {

const Words family_words{"structured", "gmsh"};
const Words far_boundary_words{"clamped", "point_load"};

template <class Body>
Key mesh_file_key(const std::string& section, Body Case::*body) {
  Key key;
  key.section = section;
  key.name = "mesh";
  key.kind = KeyKind::text;
  key.when_absent = "meshed by the program";
  key.sentence =
      "Hexahedral gmsh mesh (.msh 4.1 or 2.2, mm, contact point at the origin) with the physical "
      "surfaces `contact` and `fixed`, and `symmetry` for a half y >= 0; the path is relative to "
      "the case file (model fem).";
  key.get = [body](const Case& c) -> KeyValue {
    const std::string& file = (c.*body).mesh;
    return file.empty() ? KeyValue() : KeyValue(file);
  };
  key.set = [body](Case& c, const KeyValue& v) { (c.*body).mesh = std::get<std::string>(v); };
  return key;
}

Key size_key(const std::string& name, const std::string& sentence,
             std::optional<double> FemOptions::*member) {
  Key key;
  key.section = "fem";
  key.name = name;
  key.kind = KeyKind::number;
  key.unit = "mm";
  key.bounds = positive;
  key.when_absent = name == "depth"           ? "as far as extent; 172, the foot, of true sections"
                    : name == "rim_thickness" ? "65"
                                              : "twice the extent";
  key.sentence = sentence;
  key.get = [member](const Case& c) { return optional_number(c.fem.*member); };
  key.set = [member](Case& c, const KeyValue& v) { c.fem.*member = std::get<double>(v); };
  return key;
}

Key far_boundary_key() {
  Key key;
  key.section = "fem";
  key.name = "far_boundary";
  key.kind = KeyKind::word;
  key.words = far_boundary_words;
  key.when_absent = "`point_load`; `clamped` with a mesh of your own or true sections";
  key.sentence =
      "How the far boundary of the segments is held: `clamped`, or displaced as a half-space under "
      "the force on the patch (`point_load`), which leaves less of their size in the approach.";
  key.get = [](const Case& c) -> KeyValue {
    const auto& far = c.fem.far_boundary;
    return far ? KeyValue(far_boundary_words.at(static_cast<std::size_t>(*far))) : KeyValue();
  };
  key.set = [](Case& c, const KeyValue& v) {
    c.fem.far_boundary = enumerator<FarBoundary>(v, far_boundary_words);
  };
  return key;
}

Key family_key() {
  Key key;
  key.section = "fem";
  key.name = "mesh";
  key.kind = KeyKind::word;
  key.words = family_words;
  key.when_absent = "`structured`; `gmsh` where profiles are too steep for a box";
  key.sentence =
      "How wheel and rail are meshed: `structured` lays a graded box on the surface; `gmsh` meshes "
      "the cross-section in quadrilaterals and revolves or extrudes it, with profiles the true "
      "section of rail and wheel rim.";
  key.get = [](const Case& c) -> KeyValue {
    const auto& family = c.fem.mesh;
    return family ? KeyValue(family_words.at(static_cast<std::size_t>(*family))) : KeyValue();
  };
  key.set = [](Case& c, const KeyValue& v) {
    c.fem.mesh = enumerator<MeshFamily>(v, family_words);
  };
  return key;
}

}  // namespace

std::vector<Key> mesh_keys() {
  return {
      mesh_file_key("wheel", &Case::wheel),
      mesh_file_key("rail", &Case::rail),
      family_key(),
      size_key("width", "Width of the segments of wheel and rail across rolling.",
               &FemOptions::width),
      size_key("depth",
               "Depth of the segments below the surface; of a rail with a true section the depth "
               "below its top at which it is cut and held.",
               &FemOptions::depth),
      size_key("rim_thickness",
               "Thickness of the wheel's rim below the contact, held at its inner side, in a true "
               "section (profiles).",
               &FemOptions::rim_thickness),
      size_key("length",
               "Length of the segments along rolling, on the wheel the arc of its sector.",
               &FemOptions::length),
      far_boundary_key(),
  };
}

}  // namespace rollfem::contact
