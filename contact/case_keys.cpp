#include "contact/case_keys.hpp"

#include <algorithm>
#include <cmath>

namespace rollfem::contact {

namespace {

using Words = std::vector<std::string>;
using Numbers = std::vector<double>;

// Radii, forces and moduli have bounds far outside of anything built, which only keep the
// arithmetic away from overflow and underflow.
constexpr double smallest = 1e-6;
constexpr double largest = 1e9;
const Bounds positive{smallest, largest};
const Bounds curved_or_flat{smallest, largest, false, true, true};
const Bounds at_most_one{0.0, 1.0, false, true};

KeyValue optional_number(const std::optional<double>& value) {
  return value ? KeyValue(*value) : KeyValue();
}

/// The list of one creepage component; a single number when all load points share it.
KeyValue component(const Case& input, double Creepage::*member) {
  Numbers values;
  for (const Creepage& creepage : input.rolling.creepages) values.push_back(creepage.*member);
  const bool same = std::all_of(values.begin(), values.end(),
                                [&](double value) { return value == values.front(); });
  if (same && !values.empty()) values.resize(1);
  return values;
}

/// Broadcasts: one number serves all load points. Lengths were checked before (case_checks.cpp).
void set_component(Case& input, double Creepage::*member, const KeyValue& value) {
  const auto& numbers = std::get<Numbers>(value);
  auto& creepages = input.rolling.creepages;
  if (creepages.size() == 1) creepages.resize(numbers.size(), creepages.front());
  for (std::size_t i = 0; i < creepages.size(); ++i)
    creepages[i].*member = numbers.size() == 1 ? numbers.front() : numbers.at(i);
}

/// Position of an enumerator in the list of words that names it.
template <class Enumeration>
Enumeration enumerator(const KeyValue& value, const Words& words) {
  const auto found = std::find(words.begin(), words.end(), std::get<std::string>(value));
  return static_cast<Enumeration>(found - words.begin());
}

const Words upwind_words{"first", "second"};
const Words extra_slip_words{"none", "rolling-radius"};
const Words solver_words{"automatic", "factorisation", "multigrid"};
const Words model_words{"hertz", "halfspace", "fem"};

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
                  positive,
                  {},
                  false,
                  "",
                  "",
                  "Young's modulus; the default is steel.",
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
       "flat. A concave radius must be larger than the rail's.",
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
       "the rail is straight.",
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
       "extra_slip",
       KeyKind::word,
       "",
       "",
       {},
       extra_slip_words,
       false,
       "",
       "",
       "Rigid slip from the shape of the surface: `rolling-radius` adds s_x = -z(y)/R, because "
       "across a curved patch the wheel rolls on different radii (z: drop of the rail surface).",
       [](const Case& c) -> KeyValue {
         return extra_slip_words.at(static_cast<std::size_t>(c.rolling.extra_slip));
       },
       [](Case& c, const KeyValue& v) {
         c.rolling.extra_slip = enumerator<ExtraSlip>(v, extra_slip_words);
       }},
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
       "cells.",
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
       "How far the finest cells reach from the middle, in semi-axes of the patch; 1.5 is good.",
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
       "`automatic` takes the factorisation up to some 400 000 unknowns a body, then multigrid.",
       [](const Case& c) -> KeyValue {
         return solver_words.at(static_cast<std::size_t>(c.fem.linear_solver));
       },
       [](Case& c, const KeyValue& v) {
         c.fem.linear_solver = enumerator<LinearSolver>(v, solver_words);
       }},
  };
}

std::vector<Key> output_keys() {
  return {
      {"output",
       "paths",
       KeyKind::words,
       "",
       "",
       {},
       {"x", "y"},
       false,
       "",
       "",
       "Middle lines of the patch along which stresses are written and drawn.",
       [](const Case& c) -> KeyValue { return c.output.paths; },
       [](Case& c, const KeyValue& v) { c.output.paths = std::get<Words>(v); }},
      {"output",
       "fields",
       KeyKind::boolean,
       "",
       "",
       {},
       {},
       false,
       "",
       "",
       "Write ParaView files of wheel and rail with displacement and stress (model fem).",
       [](const Case& c) -> KeyValue { return c.output.fields; },
       [](Case& c, const KeyValue& v) { c.output.fields = std::get<bool>(v); }},
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
      {"rolling", "Steady rolling along x; lists of creepages have one length, numbers serve all"},
      {"contact_grid", "Elements of the contact area of the half-space model"},
      {"fem", "Finite-element model"},
      {"output", "What is written beside summary.json and results.h5"},
  };
  return sections;
}

const std::vector<Key>& case_keys() {
  static const std::vector<Key> keys = [] {
    std::vector<Key> all;
    for (auto* part : {&general_keys, &load_keys, &body_keys, &rolling_keys, &grid_keys, &fem_keys,
                       &output_keys})
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
  input.models = model_words;
  return input;
}

}  // namespace rollfem::contact
