#include "contact/case/case_key_parts.hpp"

#include <algorithm>
#include <cmath>

namespace rollfem::contact {

namespace {

const Words upwind_words{"first", "second"};
const Words leading_edge_words{"fitted", "plain"};
const Words extra_slip_words{"none", "rolling-radius", "file"};
const Words solver_words{"automatic", "factorisation", "multigrid", "algebraic"};
const Words model_words{"hertz",   "linear", "vermeulen-johnson", "carter",
                        "fastsim", "strip",  "halfspace",         "fem"};
const Words default_models{"hertz", "halfspace", "fem"};

/// The list of one creepage component; a single number when all load points share it.
KeyValue component(const Case& input, double Creepage::*member) {
  return shortened(input.rolling.creepages,
                   [member](const Creepage& creepage) { return creepage.*member; });
}

void set_component(Case& input, double Creepage::*member, const KeyValue& value) {
  set_per_load_point(input, value, [member](Case& c, std::size_t k, double number) {
    c.rolling.creepages[k].*member = number;
  });
}

std::vector<Key> general_keys() {
  return {
      {"",
       "title",
       KeyKind::text,
       "",
       "",
       {},
       {},
       false,
       "the name of the file",
       R"("a wheel on a crowned rail")",
       "What the report is headed with.",
       [](const Case& c) -> KeyValue { return c.title; },
       [](Case& c, const KeyValue& v) { c.title = std::get<std::string>(v); }},
      {"",
       "models",
       KeyKind::words,
       "",
       "",
       {},
       model_words,
       false,
       "",
       "",
       "The models that `run` computes, in this order; `--model` on the command line overrides it.",
       [](const Case& c) -> KeyValue { return c.models; },
       [](Case& c, const KeyValue& v) { c.models = std::get<Words>(v); }},
  };
}

std::vector<Key> load_keys() {
  const std::string one_of = "exactly one of normal_force and approach is given";
  return {
      {"load",
       "normal_force",
       KeyKind::number,
       "F_z",
       "N",
       {1e-6, 1e12},
       {},
       false,
       one_of,
       "50e3",
       "Force that presses the wheel on the rail.",
       [](const Case& c) { return optional_number(c.load.normal_force); },
       [](Case& c, const KeyValue& v) { c.load.normal_force = std::get<double>(v); }},
      {"load",
       "approach",
       KeyKind::number,
       "delta",
       "mm",
       {1e-9, 1e6},
       {},
       false,
       one_of,
       "",
       "Approach of distant points of the two bodies, in place of the force; less than a tenth of "
       "the smallest radius.",
       [](const Case& c) { return optional_number(c.load.approach); },
       [](Case& c, const KeyValue& v) { c.load.approach = std::get<double>(v); }},
      {"friction",
       "coefficient",
       KeyKind::number,
       "mu",
       "",
       {0.0, 1000.0},
       {},
       true,
       "",
       "0.55",
       "Coulomb's coefficient of friction, the same for adhesion and slip; 0 is frictionless.",
       [](const Case& c) -> KeyValue { return c.friction_coefficient; },
       [](Case& c, const KeyValue& v) { c.friction_coefficient = std::get<double>(v); }},
  };
}

/// Young's modulus and Poisson's ratio are declared once for both bodies.
template <class Body>
void add_material(std::vector<Key>& keys, const std::string& section, Body Case::*body) {
  keys.push_back({section,
                  "young_modulus",
                  KeyKind::number,
                  "E",
                  "MPa",
                  {smallest, largest, false, false, true},
                  {},
                  false,
                  "",
                  "",
                  "Young's modulus; the default is steel; inf is a rigid body (not both).",
                  [body](const Case& c) -> KeyValue { return (c.*body).material.young_modulus; },
                  [body](Case& c, const KeyValue& v) {
                    (c.*body).material.young_modulus = std::get<double>(v);
                  }});
  keys.push_back({section,
                  "poisson_ratio",
                  KeyKind::number,
                  "nu",
                  "",
                  {0.0, 0.5, true},
                  {},
                  false,
                  "",
                  "",
                  "Poisson's ratio; an incompressible body (0.5) is not covered.",
                  [body](const Case& c) -> KeyValue { return (c.*body).material.poisson_ratio; },
                  [body](Case& c, const KeyValue& v) {
                    (c.*body).material.poisson_ratio = std::get<double>(v);
                  }});
  keys.push_back(
      {section,
       "density",
       KeyKind::number,
       "rho",
       "t/mm^3",
       {0.0, 1e-7},
       {},
       false,
       "",
       "",
       "Mass density, which matters at rolling.speed > 0 only; the default is steel "
       "(1 t/mm^3 = 1e12 kg/m^3).",
       [body](const Case& c) -> KeyValue { return (c.*body).material.density; },
       [body](Case& c, const KeyValue& v) { (c.*body).material.density = std::get<double>(v); }});
}

std::vector<Key> body_keys() {
  std::vector<Key> keys{
      {"wheel",
       "rolling_radius",
       KeyKind::number,
       "R",
       "mm",
       positive,
       {},
       true,
       "",
       "405.0",
       "Radius of the wheel at the running circle.",
       [](const Case& c) -> KeyValue { return c.wheel.rolling_radius; },
       [](Case& c, const KeyValue& v) { c.wheel.rolling_radius = std::get<double>(v); }},
      {"wheel",
       "transverse_radius",
       KeyKind::number,
       "R_wy",
       "mm",
       curved_or_flat,
       {},
       true,
       "",
       "inf",
       "Radius of the wheel's profile: positive convex, negative concave (a hollow tread), inf "
       "flat. A concave radius must be larger than the rail's. Left out where `profile` is given.",
       [](const Case& c) -> KeyValue { return c.wheel.transverse_radius; },
       [](Case& c, const KeyValue& v) { c.wheel.transverse_radius = std::get<double>(v); }}};
  add_material(keys, "wheel", &Case::wheel);
  keys.push_back(
      {"rail",
       "transverse_radius",
       KeyKind::number,
       "R_ry",
       "mm",
       curved_or_flat,
       {},
       true,
       "",
       "2000.0",
       "Radius of the rail's head: positive convex, negative concave, inf flat. Along the track "
       "the rail is straight. Left out where `profile` is given.",
       [](const Case& c) -> KeyValue { return c.rail.transverse_radius; },
       [](Case& c, const KeyValue& v) { c.rail.transverse_radius = std::get<double>(v); }});
  add_material(keys, "rail", &Case::rail);
  return keys;
}

Key creepage_key(const std::string& name, const std::string& symbol, const std::string& unit,
                 const std::string& sentence, double Creepage::*member) {
  return {"rolling",
          name,
          KeyKind::numbers,
          symbol,
          unit,
          at_most_one,
          {},
          false,
          "",
          name == "longitudinal_creepage" ? "[0.0, 0.0005, 0.001, 0.002, 0.003, 0.004, 0.006]" : "",
          sentence,
          [member](const Case& c) { return component(c, member); },
          [member](Case& c, const KeyValue& v) { set_component(c, member, v); }};
}

std::vector<Key> rolling_keys() {
  return {
      creepage_key(
          "longitudinal_creepage", "xi", "",
          "Rigid slip of the wheel over the rolling speed, along x. Positive when braking: "
          "the rail pulls the wheel towards -x. A list makes a creep curve.",
          &Creepage::longitudinal),
      creepage_key("lateral_creepage", "eta", "", "The same along y.", &Creepage::lateral),
      creepage_key("spin", "phi", "rad/mm",
                   "Rigid rotation about the normal over the rolling speed.", &Creepage::spin),
      {"rolling",
       "speed",
       KeyKind::number,
       "V",
       "mm/s",
       {0.0, 1e8},
       {},
       false,
       "",
       "",
       "Rolling speed, for the inertia of wheel and rail and the wheel's centrifugal load; 0 is "
       "quasi-static. Below 0.9 of the slower body's Rayleigh wave speed.",
       [](const Case& c) -> KeyValue { return c.rolling.speed; },
       [](Case& c, const KeyValue& v) { c.rolling.speed = std::get<double>(v); }},
      {"rolling",
       "upwind_order",
       KeyKind::word,
       "",
       "",
       {},
       upwind_words,
       false,
       "",
       "",
       "Order of the difference along the streamline; `first` is what CONTACT does and needs some "
       "ten times finer elements.",
       [](const Case& c) -> KeyValue {
         return upwind_words.at(static_cast<std::size_t>(c.rolling.upwind_order));
       },
       [](Case& c, const KeyValue& v) {
         c.rolling.upwind_order = enumerator<UpwindOrder>(v, upwind_words);
       }},
      {"rolling",
       "leading_edge",
       KeyKind::word,
       "",
       "",
       {},
       leading_edge_words,
       false,
       "",
       "",
       "Whether the second-order difference of steady rolling is fitted to the place of the "
       "leading "
       "edge inside its elements; `plain` is the textbook difference, whose tractions zigzag.",
       [](const Case& c) -> KeyValue {
         return leading_edge_words.at(static_cast<std::size_t>(c.rolling.leading_edge));
       },
       [](Case& c, const KeyValue& v) {
         c.rolling.leading_edge = enumerator<LeadingEdge>(v, leading_edge_words);
       }},
      {"rolling",
       "extra_slip",
       KeyKind::word,
       "",
       "",
       {},
       extra_slip_words,
       false,
       "",
       "",
       "Rigid slip from the shape of the surface (the model fem has it from its bodies): "
       "`rolling-radius` adds s_x = -z(y)/R, because "
       "across a curved patch the wheel rolls on different radii (z: drop of the rail surface); "
       "`file` takes it from extra_slip_file.",
       [](const Case& c) -> KeyValue {
         return extra_slip_words.at(static_cast<std::size_t>(c.rolling.extra_slip));
       },
       [](Case& c, const KeyValue& v) {
         c.rolling.extra_slip = enumerator<ExtraSlip>(v, extra_slip_words);
       }},
      file_key(
          "rolling", "extra_slip_file", "none, unless extra_slip is `file`",
          "Lines `x, y, s_x, s_y` (mm and slip over the rolling speed) on a regular lattice; the "
          "path is relative to the case file.",
          [](Case& c) -> std::optional<Lattice>& { return c.rolling.extra_slip_values; }),
  };
}

std::vector<Key> grid_keys() {
  return {
      {"contact_grid",
       "elements_across",
       KeyKind::integer,
       "",
       "",
       {4, 2000},
       {},
       false,
       "",
       "",
       "Contact elements along the smaller extent of the patch; not together with cell_size.",
       [](const Case& c) -> KeyValue {
         if (c.contact_grid.cell_size) return {};
         return static_cast<double>(c.contact_grid.elements_across);
       },
       [](Case& c, const KeyValue& v) {
         c.contact_grid.elements_across = static_cast<int>(std::get<double>(v));
       }},
      {"contact_grid",
       "cell_size",
       KeyKind::pair,
       "dx, dy",
       "mm",
       positive,
       {},
       false,
       "from elements_across",
       "",
       "Size of a contact element, [along x, along y].",
       [](const Case& c) -> KeyValue {
         if (!c.contact_grid.cell_size) return {};
         return Numbers(c.contact_grid.cell_size->begin(), c.contact_grid.cell_size->end());
       },
       [](Case& c, const KeyValue& v) {
         const auto& size = std::get<Numbers>(v);
         c.contact_grid.cell_size = {size.at(0), size.at(1)};
       }},
      {"contact_grid",
       "extent",
       KeyKind::pair,
       "",
       "mm",
       positive,
       {},
       false,
       "from the size of the patch",
       "",
       "Extent of the whole potential contact area, [along x, along y], where Hertz's ellipse does "
       "not tell (several patches).",
       [](const Case& c) -> KeyValue {
         if (!c.contact_grid.extent) return {};
         return Numbers(c.contact_grid.extent->begin(), c.contact_grid.extent->end());
       },
       [](Case& c, const KeyValue& v) {
         const auto& size = std::get<Numbers>(v);
         c.contact_grid.extent = {size.at(0), size.at(1)};
       }},
      {"contact_grid",
       "middle",
       KeyKind::pair,
       "",
       "mm",
       {0.0, 1e6, false, true},
       {},
       false,
       "",
       "",
       "Middle of the potential contact area, [x, y]; with profiles from the contact point, and "
       "without an extent from the middle of the patch.",
       [](const Case& c) -> KeyValue {
         return Numbers(c.contact_grid.middle.begin(), c.contact_grid.middle.end());
       },
       [](Case& c, const KeyValue& v) {
         const auto& at = std::get<Numbers>(v);
         c.contact_grid.middle = {at.at(0), at.at(1)};
       }},
  };
}

std::vector<Key> fem_keys() {
  return {
      {"fem",
       "cell_size",
       KeyKind::number,
       "h",
       "mm",
       positive,
       {},
       false,
       "chosen from the size of the patch",
       "",
       "Size of a finite element, and of a contact element of this model, in the patch.",
       [](const Case& c) { return optional_number(c.fem.cell_size); },
       [](Case& c, const KeyValue& v) { c.fem.cell_size = std::get<double>(v); }},
      {"fem",
       "degree",
       KeyKind::integer,
       "",
       "",
       {1, 2},
       {},
       false,
       "",
       "",
       "Polynomial degree of the displacement; 1 is 15 to 20 times less accurate on the same "
       "cells, and a contact element is then two cells by two.",
       [](const Case& c) -> KeyValue { return static_cast<double>(c.fem.degree); },
       [](Case& c, const KeyValue& v) { c.fem.degree = static_cast<int>(std::get<double>(v)); }},
      {"fem",
       "extent",
       KeyKind::number,
       "L",
       "mm",
       positive,
       {},
       false,
       "chosen from the size of the patch",
       "",
       "How far the segments of wheel and rail reach from the middle of the patch.",
       [](const Case& c) { return optional_number(c.fem.extent); },
       [](Case& c, const KeyValue& v) { c.fem.extent = std::get<double>(v); }},
      {"fem",
       "fine_extent",
       KeyKind::number,
       "c",
       "",
       {1.0, 10.0},
       {},
       false,
       "chosen by the model",
       "",
       "How far the finest cells reach from the middle, in semi-axes of the patch; beyond 1.1 "
       "nothing is gained.",
       [](const Case& c) { return optional_number(c.fem.fine_extent); },
       [](Case& c, const KeyValue& v) { c.fem.fine_extent = std::get<double>(v); }},
      {"fem",
       "linear_solver",
       KeyKind::word,
       "",
       "",
       {},
       solver_words,
       false,
       "",
       "",
       "`automatic` takes what should be quicker for the size and the number of load points; "
       "`algebraic` (Trilinos ML) is for imported meshes too fine to be a coarse level.",
       [](const Case& c) -> KeyValue {
         return solver_words.at(static_cast<std::size_t>(c.fem.linear_solver));
       },
       [](Case& c, const KeyValue& v) {
         c.fem.linear_solver = enumerator<LinearSolver>(v, solver_words);
       }},
  };
}

}  // namespace

bool Bounds::contains(double value) const {
  if (infinite && value == infinity) return true;
  if (!std::isfinite(value)) return false;
  const double bounded = magnitude ? std::abs(value) : value;
  return bounded >= lower && (upper_open ? bounded < upper : bounded <= upper);
}

const std::vector<Section>& case_sections() {
  static const std::vector<Section> sections{
      {"", "Before the first section"},
      {"load", "How hard the bodies are pressed together: a force or an approach"},
      {"friction", "Friction between wheel and rail"},
      {"wheel", "Upper body (1): a surface of revolution about the axle"},
      {"rail", "Lower body (2): a straight extruded rail"},
      {"wheel_profile", "Details of the profile that [wheel] names; files are mended only as told"},
      {"rail_profile", "Details of the profile that [rail] names; files are mended only as told"},
      {"track", "The track under wheels with profiles"},
      {"wheelset", "Where the wheelset with profiles stands on the track and how it moves"},
      {"rolling",
       "Rolling along x; lists have one length, that of the load points; numbers serve all"},
      {"history",
       "Steps of the problems `shift` and `transient`, one entry of each list a step; a shift is "
       "what "
       "happens in its step, not since the beginning"},
      {"undeformed_distance", "Distance of the undeformed bodies, in place of that of the radii"},
      {"given_pressure", "Hertz's pressure on a given ellipse in place of the normal problem"},
      {"contact_grid", "Elements of the contact area of the half-space model"},
      {"halfspace", "Model `halfspace`"},
      {"fastsim", "Model `fastsim`: Kalker's simplified theory on Hertz's ellipse"},
      {"strip", "Model `strip`: strips along rolling, each after Hertz, with brushes"},
      {"carter", "Model `carter`: strips along rolling, each a line contact"},
      {"fem", "Finite-element model"},
      {"output", "What is written beside summary.json and results.h5"},
      {"subsurface.point", "A point below the surface (models halfspace and fem); may be repeated",
       true},
      {"subsurface.line", "A line of points below the surface; may be repeated", true},
      {"subsurface.plane", "A plane of points below the surface; may be repeated", true},
      {"subsurface.surface",
       "A line that follows the contact surface of a body, on it or below it; may be repeated",
       true},
  };
  return sections;
}

const std::vector<Key>& case_keys() {
  static const std::vector<Key> keys = [] {
    std::vector<Key> all;
    for (auto* part :
         {&general_keys, &accuracy_keys, &load_keys, &body_keys, &profile_keys, &track_keys,
          &wheelset_keys, &rolling_keys, &problem_keys, &history_keys, &surface_keys, &grid_keys,
          &halfspace_keys, &theory_keys, &fem_keys, &mesh_keys, &output_keys, &subsurface_keys})
      for (Key& key : (*part)()) all.push_back(std::move(key));
    return all;
  }();
  return keys;
}

const Key* find_key(const std::string& section, const std::string& name) {
  for (const Key& key : case_keys())
    if (key.section == section && key.name == name) return &key;
  return nullptr;
}

Case default_case() {
  Case input;
  input.models = default_models;
  return input;
}

}  // namespace rollfem::contact
