// SPDX-License-Identifier: LGPL-2.1-or-later
// Wheel and rail: their radii, materials, profiles and meshes; the shape of the contact.
#include "case/keys/key_builder.hpp"

#include <algorithm>

namespace rollfem::contact {

namespace {

template <class Body>
void add_radius(Keys<Body>& keys, const char* papers_symbol, const char* toml,
                const char* sentence) {
  keys.add("transverse_radius", &Body::transverse_radius, symbol(papers_symbol), unit("mm"),
           or_inf(sized(smallest_radius, largest)), Required{toml}, sentence);
  keys.add(
      "round_to", &Body::round_to, between(0.1, 0.9),
      "Fraction of the transverse radius beyond which the profile is straight (docs/meshes.md).");
}

template <class Body>
void add_material(Keys<Body>& keys) {
  keys.add("young_modulus", inside(&Body::material, &Material::young_modulus), symbol("E"),
           unit("MPa"), or_inf(positive()), "Young's modulus; inf: rigid (not both).");
  keys.add("poisson_ratio", inside(&Body::material, &Material::poisson_ratio), symbol("nu"),
           upper_open(between(0.0, 0.5)), "Poisson's ratio.");
  keys.add("density", inside(&Body::material, &Material::density), symbol("rho"), unit("t/mm^3"),
           zero_or(1e-15, 1e-7), "Density, for fem.inertia and heat.");
}

/// `names`: built-in profiles.
template <class Body>
void add_shape_from_files(Keys<Body>& keys, const std::string& names) {
  keys.add("profile", inside(&Body::profile, &ProfileSource::name), names_file,
           otherwise("transverse_radius applies"),
           "Built in: " + names +
               "; or `arcs`, `polynomial`, or a file (columns y, z, or other formats). Details: [" +
               keys.section().name + "_profile], docs/profiles.md.");
  keys.add("mesh", &Body::mesh, names_file, otherwise("meshed by the program"),
           "Model fem: hexahedral gmsh mesh (docs/meshes.md).");
}

SectionWithKeys wheel_section() {
  Keys<Wheel> keys("wheel", "Upper body (1): a surface of revolution about the axle", &Case::wheel);
  keys.add("rolling_radius", &Wheel::rolling_radius, symbol("R"), unit("mm"),
           between(smallest_radius, largest), Required{"405.0"}, "Radius at the running circle.");
  add_radius(keys, "R_wy", "inf",
             "Radius of the profile: positive convex, negative concave (larger than the rail's), "
             "inf flat.");
  add_material(keys);
  add_shape_from_files(keys, "`S1002`, `S1002-smooth`");
  return keys;
}

SectionWithKeys rail_section() {
  Keys<Rail> keys("rail", "Lower body (2): a straight extruded rail, or a roller", &Case::rail);
  keys.add("rolling_radius", &Rail::rolling_radius, symbol("R_r"), unit("mm"),
           or_inf(sized(smallest_radius, largest)),
           "Radius at z = 0 of the profile: inf a straight rail, positive a roller below the "
           "wheel, negative a ring around it.");
  add_radius(keys, "R_ry", "2000.0",
             "Radius of the head: positive convex, negative concave, inf flat.");
  add_material(keys);
  add_shape_from_files(
      keys, "`60E1` (`UIC60`), `60E2`, `54E1` (`UIC54`), `56E1` (`BS113A`), `UIC60-manchester`");
  return keys;
}

/// Of a section without which the body lacks this part.
template <class Part, class Body, class Member>
Place<Part> optional_part(Body Case::*body, Member member) {
  return {[=](const Case& c) {
            const std::optional<Part>& part = c.*body.*member;
            return part ? &*part : nullptr;
          },
          [=](Case& c) -> Part& {
            std::optional<Part>& part = c.*body.*member;
            return part ? *part : part.emplace();
          }};
}

/// A list with one number for each back stress.
Access<BodyPlasticity> of_back_stresses(double BodyPlasticity::BackStress::*member) {
  return {[member](const BodyPlasticity& steel) -> KeyValue {
            // As many as there are moduli.
            std::size_t moduli = 0, given = 0;
            Numbers numbers;
            for (const BodyPlasticity::BackStress& back : steel.back_stresses) {
              numbers.push_back(back.*member);
              if (back.modulus > 0.0) moduli = numbers.size();
              if (back.*member != 0.0) given = numbers.size();
            }
            if (given == 0) return {};
            numbers.resize(moduli > 0 ? moduli : given);
            return numbers;
          },
          [member](BodyPlasticity& steel, const KeyValue& value) {
            const auto& numbers = std::get<Numbers>(value);
            // One recovery is that of all; of the moduli there is one for each.
            const bool of_all =
                numbers.size() == 1 && member == &BodyPlasticity::BackStress::recovery;
            const std::size_t count = of_all ? steel.back_stresses.size()
                                             : std::min(numbers.size(), steel.back_stresses.size());
            for (std::size_t k = 0; k < count; ++k)
              steel.back_stresses[k].*member = numbers[of_all ? 0 : k];
          }};
}

void add_residual_stress(Keys<BodyPlasticity>& keys) {
  using Residual = BodyPlasticity::ResidualStress;
  const auto of = [](std::vector<double> Residual::*member) {
    return inside(&BodyPlasticity::residual, member);
  };
  const auto each = per("depths in [" + keys.section().name + "]");
  keys.add("residual_depth", of(&Residual::depth), each, counts, ascending, unit("mm"),
           zero_or(smallest, 1e3), otherwise("no residual stress"),
           "Depths below the surface, ascending, of the initial residual stress: linear between, "
           "constant outside.");
  keys.add("residual_along", of(&Residual::along), each, unit("MPa"), within(largest),
           otherwise("0"),
           "Residual stress along rolling at these depths, or one for all; tension is positive.");
  keys.add("residual_across", of(&Residual::across), each, unit("MPa"), within(largest),
           otherwise("0"), "The same across.");
  keys.add("residual_file", inside(&BodyPlasticity::residual, &Residual::file), names_file,
           otherwise("the three lists apply"),
           "Instead of the three lists: lines `depth, along, across` (mm, MPa).");
}

template <class Body>
SectionWithKeys plasticity_section(const std::string& name, Body Case::*body) {
  using Steel = BodyPlasticity;
  Keys<Steel> keys(name + "_plasticity",
                   "Steel of the " + name + " that yields (model fem, docs/plasticity.md)",
                   optional_part<Steel>(body, &Body::plasticity));
  keys.section().alternatives = true;
  const auto each = per("back stresses in [" + keys.section().name + "]");
  keys.add("yield_stress", &Steel::yield_stress, symbol("sigma_y"), unit("MPa"), positive(),
           otherwise("required with this section"),
           "Yield stress in tension; sqrt(3) times the k of shakedown maps.");
  keys.add(KeyKind::numbers, "hardening", of_back_stresses(&Steel::BackStress::modulus), each,
           counts, symbol("C"), unit("MPa"), positive(), otherwise("no kinematic hardening"),
           "Initial plastic moduli, in tension, of one to three back stresses.");
  keys.add(KeyKind::numbers, "recovery", of_back_stresses(&Steel::BackStress::recovery), each,
           symbol("gamma"), zero_or(smallest, largest), otherwise("0 (Prager)"),
           "Dynamic recovery of each back stress, or one for all (Armstrong and Frederick; "
           "Chaboche); it saturates at hardening/recovery; 0: linear (Prager).");
  keys.add("hot_temperature", &Steel::hot_temperature, unit("degC"), between(-273.0, 1500.0),
           otherwise("no softening"),
           "Temperature from which the steel has its `hot_yield_stress`; linear from that before "
           "contact.");
  keys.add("hot_yield_stress", &Steel::hot_yield_stress, unit("MPa"), positive(),
           otherwise("no softening"), "Yield stress in tension of hot steel.");
  for (const HardeningLaw& law : hardening_laws())
    for (const HardeningLaw::Constant& own : law.constants)
      keys.add(own.key, own.member, silent_default, otherwise("0"), symbol(own.symbol),
               unit(own.unit), own.may_be_negative ? within(largest) : zero_or(smallest, largest),
               std::string(own.sentence));
  add_residual_stress(keys);
  return keys;
}

template <class Body>
SectionWithKeys heat_section(const std::string& name, Body Case::*body) {
  Keys<BodyHeat> keys(name + "_heat",
                      "Heat of friction in the " + name +
                          "; with either section, results have temperatures (docs/heat.md)",
                      optional_part<BodyHeat>(body, &Body::heat));
  keys.section().alternatives = true;
  keys.add("temperature", &BodyHeat::temperature, unit("degC"), between(-273.0, 1500.0),
           "Temperature before contact.");
  keys.add("conductivity", &BodyHeat::conductivity, symbol("lambda"), unit("W/(m K)"),
           between(1e-3, 1e4), "Heat conductivity.");
  keys.add("heat_capacity", &BodyHeat::capacity, symbol("c"), unit("J/(kg K)"), between(1.0, 1e5),
           "Heat capacity; the density is that of the body.");
  keys.add(
      "expansion", &BodyHeat::expansion, symbol("alpha"), unit("1/K"), zero_or(1e-9, 1e-3),
      "Thermal expansion, for the thermal stress of `rollfem stress` and in steel that yields.");
  keys.add("limit", &BodyHeat::limit, unit("degC"), between(-273.0, 1e4),
           "Surface temperature above which results warn (steel transforms).");
  return keys;
}

SectionWithKeys geometry_section() {
  Keys<ContactShapeCase> keys("geometry", "Bodies of finite width or endless rollers",
                              &Case::geometry);
  keys.section().alternatives = true;
  keys.add("shape", &ContactShapeCase::shape,
           {{"point", ContactShape::point}, {"line", ContactShape::line}},
           "`point`: given by radii, profiles or points; `line`: endless rollers in plane strain, "
           "without transverse radii and spin.");
  keys.add("width", &ContactShapeCase::width, unit("mm"), positive(),
           "Line contact: width to which forces, areas and work refer.");
  keys.add("relative_radius", &ContactShapeCase::relative_radius, symbol("R"), unit("mm"),
           between(smallest_radius, largest), otherwise("from the rolling radii"),
           "Line contact: R of the undeformed distance x^2/(2 R).");
  keys.add(
      "reference_distance", &ContactShapeCase::reference_distance, unit("mm"), or_inf(positive()),
      otherwise("the relative radius"),
      "Line contact: approach, energy, shifts and transients are relative to the surface at this "
      "distance from the load, with inf to distant points, for a load as long as `width`.");
  return keys;
}

using Profile = ProfileSource;
using ProfileKeys = Keys<Profile>;

void add_formulas(ProfileKeys& keys) {
  keys.add("radii", &Profile::radii, unit("mm"), or_inf(sized(smallest_radius, largest)),
           otherwise("required by `arcs`"),
           "Radii of tangent arcs: positive convex, negative concave, inf straight.");
  keys.add("ends", &Profile::ends, unit("mm"), within(1e3), otherwise("required by `arcs`"),
           "y at which the arcs end, from the middle outwards if symmetric, otherwise one more "
           "than radii, increasing. They pass through (0, 0).");
  keys.add("symmetric", &Profile::symmetric, "The arcs are given for y > 0 and mirrored.");
  keys.add("slope", &Profile::slope, within(1e6), "dz/dy of unsymmetric arcs at (0, 0).");
  keys.add("coefficients", &Profile::coefficients, within(largest_force),
           otherwise("required by `polynomial`"),
           "z(y) in mm, lowest order first; piece after piece, with equally many coefficients.");
  keys.add("limits", &Profile::limits, unit("mm"), within(1e3),
           otherwise("required by `polynomial`"),
           "y at which pieces begin and end; they must meet in value and slope.");
}

void add_places(ProfileKeys& keys) {
  keys.add("mirror", &Profile::mirror, "Swap the sides: y becomes -y.");
  keys.add("rotation", &Profile::rotation, unit("rad"), within(1.6),
           "Rotate about (0, 0), from y to z; not the rail's inclination.");
  keys.add("shift", &Profile::shift, unit("mm"), within(1e6), "Then shift along y and z.");
  keys.add("free_ends", &Profile::free_ends,
           "The body ends where its profile does, at a side face that contacts may reach "
           "(docs/profiles.md).");
}

void add_mending(ProfileKeys& keys) {
  keys.add("unit", &Profile::unit,
           {{"mm", LengthUnit::mm}, {"m", LengthUnit::m}, {"inch", LengthUnit::inch}},
           "Unit of the file, unless its format states it.");
  keys.add("section", &Profile::section, otherwise("required if the file has several"),
           "Profile of the file: `Profile1Points` (MiniProf), `left` or `right` (VAMPIRE).");
  keys.add("flip", &Profile::flip, "z points upward: z becomes -z.");
  keys.add("reverse", &Profile::reverse, "Reverse the order of the points.");
  keys.add("sort", &Profile::sort, "Sort the points by y.");
  keys.add("drop_duplicates", &Profile::drop_duplicates,
           "Drop points within 1e-6 mm of the previous one.");
  keys.add("drop_zigzag", &Profile::drop_zigzag, "Drop points at which the curve turns back.");
  keys.add("thinning", &Profile::thinning, unit("mm"), zero_or(smallest, 10.0),
           "Merge points closer than this into their mean; 0: keep all.");
  keys.add("longest_gap", &Profile::longest_gap, unit("mm"), positive(),
           "A larger gap between points is an error.");
  keys.add("largest_kink", &Profile::largest_kink, unit("degrees"), between(0.1, 180.0),
           "A larger angle between two chords, or a step that stands out, is an error.");
  keys.add(
      "rounding", &Profile::rounding, unit("mm"), zero_or(smallest, 100.0),
      "Drop points this near to a kink or step and bridge the gap smoothly; 0: kinks are errors.");
  keys.add("smoothing", &Profile::smoothing, unit("mm"), zero_or(smallest, 1.0),
           "Scatter (standard deviation) of measured points across the profile; 0: the curve "
           "passes through them.");
}

template <class Body>
SectionWithKeys profile_section(const std::string& name, Body Case::*body) {
  ProfileKeys keys(name + "_profile",
                   "Details of the profile; rollfem repairs files only as these keys say",
                   {[body](const Case& c) { return &(c.*body).profile; },
                    [body](Case& c) -> Profile& { return (c.*body).profile; }});
  keys.section().of_profiles = true;
  add_formulas(keys);
  add_places(keys);
  add_mending(keys);
  return keys;
}

// Irregularities of profiles along the way (docs/profiles.md).

template <class Part, class Body>
Keys<Part> irregularity(const std::string& name, const std::string& sentence, Body Case::*body,
                        std::optional<Part> Body::*part) {
  Keys<Part> keys(name, sentence, optional_part<Part>(body, part));
  keys.section().alternatives = true;
  keys.section().of_profiles = true;
  return keys;
}

constexpr double most_deep = 50.0, most_amplitude = 10.0;  // mm
const char* const with_section = "required with this section";

SectionWithKeys flat_section() {
  using Flat = WheelFlat;
  Keys<Flat> keys =
      irregularity("wheel_flat", "A flat of the wheel, with profiles (docs/profiles.md)",
                   &Case::wheel, &Wheel::flat);
  keys.add("shape", &Flat::shape,
           {{"chord", Flat::Shape::chord}, {"rounded", Flat::Shape::rounded}}, otherwise("`chord`"),
           "`chord`: a new, plane flat of `depth` or `length`; `rounded`: a worn one, a cosine, of "
           "both.");
  keys.add("depth", &Flat::depth, symbol("d"), unit("mm"), between(smallest, most_deep),
           otherwise("of a chord, that of its length"), "Depth in the middle.");
  keys.add("length", &Flat::length, symbol("L"), unit("mm"), between(0.1, largest),
           otherwise("of a chord, that of its depth"),
           "Length around the running circle; of a chord, straight, before rounding.");
  keys.add("edge_radius", &Flat::edge_radius, unit("mm"), zero_or(smallest_radius, largest),
           otherwise("0"),
           "Radius that rounds the ends of a chord, smaller than the wheel's; 0: sharp edges.");
  keys.add("angle", &Flat::angle, unit("rad"), within(1e3), otherwise("0"),
           "Angle of its middle about the axle: below the axle at the same wheel_angle.");
  return keys;
}

/// The lists of waves that another one counts.
template <class Part, class Counted>
void add_waves(Keys<Part>& keys, const Counted& counted, const std::string& at_zero) {
  const auto each = per("waves in [" + keys.section().name + "]");
  counted(each);
  keys.add("amplitude", &Part::amplitude, each, symbol("A"), unit("mm"),
           zero_or(1e-9, most_amplitude), otherwise(with_section),
           "Amplitude, half the height from trough to crest.");
  keys.add("phase", &Part::phase, each, unit("rad"), within(1e3), otherwise("0"),
           "At 0 a crest is at " + at_zero + "; a larger phase shifts it forward.");
}

SectionWithKeys polygon_section() {
  Keys<WheelPolygon> keys = irregularity(
      "wheel_polygon", "A wheel that is out of round, with profiles (docs/profiles.md)",
      &Case::wheel, &Wheel::polygon);
  add_waves(
      keys,
      [&](const auto& each) {
        keys.add("order", &WheelPolygon::order, each, counts, symbol("n"), between(1.0, 1000.0),
                 otherwise(with_section),
                 "Waves around the wheel: the radius grows by A cos(n angle - phase). A list is a "
                 "sum of waves.");
      },
      "the angle 0");
  return keys;
}

SectionWithKeys corrugation_section() {
  using Waves = RailCorrugation;
  Keys<Waves> keys =
      irregularity("rail_corrugation", "Waves of the rails, with profiles (docs/profiles.md)",
                   &Case::rail, &Rail::corrugation);
  add_waves(
      keys,
      [&](const auto& each) {
        keys.add(
            "wavelength", &Waves::wavelength, each, counts, symbol("lambda"), unit("mm"),
            between(2.0, largest), otherwise(with_section),
            "The rail rises by A cos(2 pi position/lambda - phase). A list is a sum of waves.");
      },
      "the position 0");
  keys.add("extent", &Waves::extent, unit("mm"), within(largest), otherwise("everywhere"),
           "First and last position of the waves; they grow and fade over the longest wavelength.");
  return keys;
}

SectionWithKeys dip_section() {
  Keys<RailDip> keys = irregularity(
      "rail_dip", "A dipped weld or joint of the rails, with profiles (docs/profiles.md)",
      &Case::rail, &Rail::dip);
  keys.add("position", &RailDip::position, unit("mm"), within(largest), otherwise("0"),
           "Middle, along the track.");
  keys.add("depth", &RailDip::depth, symbol("d"), unit("mm"), zero_or(smallest, most_deep),
           otherwise(with_section), "Depth in the middle.");
  keys.add("length", &RailDip::length, symbol("L"), unit("mm"), between(1.0, largest),
           otherwise(with_section), "Length; it ends without a kink.");
  keys.add("angle", &RailDip::angle, symbol("2 alpha"), unit("rad"), zero_or(1e-9, 0.5),
           otherwise("0"),
           "Angle between the rails at a joint in the middle: 8 d/L with parabolas, at most 12 "
           "d/L; 0: a smooth weld.");
  return keys;
}

}  // namespace

Sections body_sections() {
  return {wheel_section(),
          rail_section(),
          geometry_section(),
          profile_section("wheel", &Case::wheel),
          profile_section("rail", &Case::rail),
          flat_section(),
          polygon_section(),
          corrugation_section(),
          dip_section(),
          plasticity_section("wheel", &Case::wheel),
          plasticity_section("rail", &Case::rail),
          heat_section("wheel", &Case::wheel),
          heat_section("rail", &Case::rail)};
}

}  // namespace rollfem::contact
