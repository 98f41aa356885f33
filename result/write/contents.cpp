// SPDX-License-Identifier: LGPL-2.1-or-later
#include "result/write/contents.hpp"

#include "case/keys/case_keys.hpp"
#include "result/derived.hpp"
#include "result/quantities.hpp"
#include "result/write/wheelset_rows.hpp"
#include "scene/friction_law.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <numeric>
#include <set>
#include <stdexcept>
#include <type_traits>

namespace rollfem::result {
namespace {

using contact::for_members;
using contact::Kept;
using contact::Listed;
using contact::ModelResult;
using contact::PointResult;

struct About {
  const char *name, *unit = "", *meaning = "", *sign = "";
};

template <class Member>
About about(const Member& member) {
  return {member.name, member.unit, member.meaning, member.sign};
}

Array::Type type_of(const double* /*number*/) {
  return Array::Type::real;
}
Array::Type type_of(const float* /*number*/) {
  return Array::Type::single;
}
Array::Type type_of(const int* /*number*/) {
  return Array::Type::whole;
}

template <class Number>
Array array_of(const std::vector<Number>& values) {
  return {type_of(values.data()), {values.size()}, values.size(), values.data()};
}
template <class Number, std::size_t N>
Array array_of(const std::vector<std::array<Number, N>>& rows) {
  const Number* const first = rows.empty() ? nullptr : rows.front().data();
  return {type_of(first), {rows.size(), N}, rows.size() * N, first};
}
Array array_of(const contact::Field& field) {
  const auto size = static_cast<std::size_t>(field.size());
  return {Array::Type::real, {size}, size, field.data()};
}

template <class Kind>
inline constexpr bool is_map = false;
template <class Entry>
inline constexpr bool is_map<std::map<std::string, Entry>> = true;
template <class Kind>
inline constexpr bool is_optional = false;
template <class Entry>
inline constexpr bool is_optional<std::optional<Entry>> = true;
template <class Kind>
inline constexpr bool lists_structs = false;
template <class Entry>
inline constexpr bool lists_structs<std::vector<Entry>> = contact::has_members<Entry>;

template <class Kind>
bool is_empty(const Kind& value) {
  if constexpr (std::is_same_v<Kind, contact::Field>)
    return value.size() == 0;
  else if constexpr (std::is_arithmetic_v<Kind> || is_optional<Kind>)
    return false;
  else
    return value.empty();
}

Value attribute(bool truth) {
  return truth;
}
Value attribute(long number) {
  return number;
}
Value attribute(int number) {
  return static_cast<long>(number);
}
Value attribute(double number) {
  return number;
}
Value attribute(const std::string& text) {
  return text;
}
template <class Word, std::enable_if_t<std::is_enum_v<Word>, int> = 0>
Value attribute(Word member) {
  return std::string(word_of(member));
}

/// A member in a column of a table.
template <class Part>
auto cell_of(const Part& value) {
  if constexpr (std::is_enum_v<Part>)
    return std::string(word_of(value));
  else
    return value;
}

template <class Whole>
void fill(Tree& tree, const Whole& whole);

/// By number or by the first member of each, or as a table.
template <class Each>
Tree list_of(const About& what, const std::vector<Each>& all);

template <class Given>
void put(Tree& tree, const About& what, Given&& value) {
  using Kind = std::decay_t<Given>;
  if constexpr (std::is_arithmetic_v<Kind> || std::is_enum_v<Kind> ||
                std::is_same_v<Kind, std::string>) {
    tree.attributes.emplace_back(what.name, attribute(value));
  } else if constexpr (std::is_same_v<Kind, const char*>) {
    tree.attributes.emplace_back(what.name, attribute(std::string(value)));
  } else if constexpr (is_optional<Kind>) {
    if (value) put(tree, what, *value);
  } else if constexpr (is_map<Kind>) {
    Tree& part = tree.parts.emplace_back(Tree{what.name, what.meaning});
    for (const auto& [name, entry] : value) part.attributes.emplace_back(name, attribute(entry));
  } else if constexpr (contact::has_members<Kind>) {
    fill(tree.parts.emplace_back(Tree{what.name, what.meaning}), value);
  } else if constexpr (lists_structs<Kind>) {
    tree.parts.push_back(list_of(what, value));
  } else {
    Entry& entry = tree.entries.emplace_back();
    entry.name = what.name;
    entry.unit = what.unit;
    entry.description = what.meaning;
    entry.sign = what.sign;
    if constexpr (std::is_same_v<Kind, std::vector<std::string>>) {
      entry.values = value;
    } else if constexpr (std::is_lvalue_reference_v<Given>) {
      entry.values = array_of(value);
    } else {
      const auto kept = std::make_shared<const Kind>(std::forward<Given>(value));
      Array array = array_of(*kept);
      array.own = kept;
      entry.values = std::move(array);
    }
  }
}

template <class Whole>
void fill(Tree& tree, const Whole& whole) {
  for_members<Whole>([&](const auto& each) {
    constexpr Kept kept = std::decay_t<decltype(each)>::kept;
    if constexpr (kept != Kept::within) {
      decltype(auto) value = std::invoke(each.part, whole);
      if constexpr (kept == Kept::if_given)
        if (is_empty(value)) return;
      put(tree, about(each), std::forward<decltype(value)>(value));
    }
  });
}

template <class Each>
Tree list_of(const About& what, const std::vector<Each>& all) {
  Tree list{what.name, what.meaning};
  list.listed = Each::listed;
  if constexpr (Each::listed == Listed::as_table) {
    for_members<Each>([&](const auto& member) {
      if constexpr (std::decay_t<decltype(member)>::kept != Kept::within) {
        std::vector<decltype(cell_of(std::invoke(member.part, all.front())))> column;
        for (const Each& each : all) column.push_back(cell_of(std::invoke(member.part, each)));
        put(list, about(member), std::move(column));
      }
    });
  } else {
    for (const Each& each : all) {
      Tree part{fmt::format("{:04}", list.parts.size()), what.meaning};
      fill(part, each);
      if (Each::listed == Listed::by_first) {
        list.key = part.attributes.front().first;
        part.name = std::get<std::string>(part.attributes.front().second);
        part.attributes.erase(part.attributes.begin());
      }
      list.parts.push_back(std::move(part));
    }
  }
  return list;
}

/// Explains attributes for programs that do not show comments.
std::vector<std::string> documentation() {
  std::vector<std::string> lines;
  for (const contact::Quantity& quantity : contact::quantities())
    lines.push_back(fmt::format("{} [{}]: {}", quantity.name, quantity.unit, quantity.meaning));
  for_members<contact::ContactPlace>([&](const auto& each) {
    if (each.kept != Kept::within && *each.unit != '\0')
      lines.push_back(fmt::format("place/{} [{}]: {}", each.name, each.unit, each.meaning));
  });
  return lines;
}

/// The same for the scalars of a load point only, in columns for programs.
Tree quantities_tree() {
  Tree tree{"quantities", "Scalars of a load point: entry k of each dataset describes one"};
  const auto column = [&](const char* name, const char* meaning, const auto& text) {
    std::vector<std::string> lines;
    for (const contact::Quantity& quantity : contact::quantities())
      lines.emplace_back(std::invoke(text, quantity));
    put(tree, {name, "", meaning, ""}, lines);
  };
  using Q = contact::Quantity;
  column("name", "Attribute of /models/NAME/points/NUMBER", &Q::name);
  column("title", "For headings", &Q::title);
  column("symbol", "F_x, xi, ...; empty if there is none", &Q::symbol);
  column("unit", "- if there is none", &Q::unit);
  column("meaning", "Meaning, with sign", &Q::meaning);
  column("percent_of", "Reference of percentages of errors and differences; empty: none",
         [](const Q& quantity) { return contact::text_of(quantity.scale); });
  return tree;
}

/// A law that falls with the slip velocity, tabulated for figures and reports.
void add_friction_law(Tree& tree, const contact::Case& input) {
  const contact::Friction law = contact::friction_of(input);
  if (!law || !law->feels_slip() || law->by_temperature()) return;
  const double speed = input.rolling.slip_speed();
  constexpr int per_decade = 30;
  std::vector<std::array<double, 2>> rows{{0.0, law->coefficient()}};
  for (int k = -3 * per_decade; k <= 9 * per_decade; ++k) {
    const double velocity = std::pow(10.0, static_cast<double>(k) / per_decade);
    rows.push_back({velocity, law->at(velocity / speed).value});
  }
  put(tree,
      {"friction_law", "mm/s, -",
       "Slip velocity (in a shift: slip in mm), and coefficient of friction", ""},
      std::move(rows));
}

Tree case_tree(const contact::Case& input) {
  Tree tree{"case", "The case file as text, and the values of its keys in mm, N, MPa"};
  tree.attributes = {{"title", input.title}, {"file", input.file}};
  tree.entries.push_back({"text", input.text, "", "The case file as read (TOML)", ""});
  add_friction_law(tree, input);
  tree.parts.push_back(keys_tree(input));
  return tree;
}

void put_key(Tree& tree, const contact::Key& key, const contact::KeyValue& value) {
  const std::string path = key.path();
  const About what{path.c_str(), key.unit.empty() ? "-" : key.unit.c_str(), key.sentence.c_str(),
                   ""};
  std::visit(
      [&](auto given) {
        using Kind = std::decay_t<decltype(given)>;
        if constexpr (std::is_same_v<Kind, double>) {
          if (key.kind == contact::KeyKind::integer) return put(tree, what, std::lround(given));
        }
        if constexpr (!std::is_same_v<Kind, std::monostate>) put(tree, what, std::move(given));
      },
      value);
}

/// Wheel and rail of finite elements: nodes and cells, once for all load points.
Tree bodies_tree(const ModelResult& model, std::size_t last) {
  Tree all{"bodies",
           "Wheel and rail: nodes and hexahedra; displacement and stress are links to the load "
           "point in the attribute load_point (from 0)"};
  all.attributes = {{"load_point", static_cast<long>(last)}};
  all.summed_up = false;
  for (const contact::BodyField& body : model.bodies)
    fill(all.parts.emplace_back(Tree{body.name, "The whole segment, both halves"}), body);
  return all;
}

/// Their values at a load point.
Tree values_tree(const ModelResult& model, const PointResult& point) {
  Tree all{"bodies",
           "Wheel and rail under this load: values at the nodes of ../../bodies; between them "
           "trilinear"};
  all.summed_up = false;
  for (std::size_t k = 0; k < point.bodies.size(); ++k) {
    const contact::BodyField& body = model.bodies.at(k);
    Tree& part = all.parts.emplace_back(Tree{body.name, "The whole segment, both halves"});
    fill(part, point.bodies[k]);
    for (Entry& entry : part.entries) std::get<Array>(entry.values).shape[0] = body.points.size();
  }
  return all;
}

void add_quantities(Tree& tree, const PointResult& point) {
  for (const contact::Quantity& quantity : contact::quantities()) {
    const std::optional<double> value = quantity.value(point);
    if (!value && quantity.member.may_be_absent) continue;
    const double number = value.value_or(std::nan(""));
    switch (quantity.member.kind) {
      case contact::QuantityKind::number:
        put(tree, {quantity.name}, number);
        break;
      case contact::QuantityKind::count:
        put(tree, {quantity.name}, std::lround(number));
        break;
      case contact::QuantityKind::truth:
        put(tree, {quantity.name}, number != 0.0);
        break;
    }
  }
}

void add_fields(Tree& tree, const contact::ContactGrid& grid,
                const contact::ContactFields& fields) {
  const std::vector<std::size_t> shape{static_cast<std::size_t>(grid.ny),
                                       static_cast<std::size_t>(grid.nx)};
  const auto add = [&](Array array, const About& what) {
    if (array.count == 0) return;
    array.shape = shape;
    tree.entries.push_back({what.name, std::move(array), what.unit, what.meaning, what.sign});
  };
  for (const contact::PointField& field : contact::point_fields())
    add(array_of(field.value(fields)), {field.name, field.unit, field.description, field.sign});
  add({Array::Type::byte, {}, fields.state.size(), fields.state.data()},
      {"state", "-", contact::state_meaning, ""});
}

std::vector<double> places(int count, double first, double step) {
  std::vector<double> all;
  for (int k = 0; k < count; ++k) all.push_back(first + k * step);
  return all;
}

}  // namespace

double Array::at(std::size_t k) const {
  switch (type) {
    case Type::real:
      return static_cast<const double*>(first)[k];
    case Type::single:
      return static_cast<const float*>(first)[k];
    case Type::whole:
      return static_cast<const int*>(first)[k];
    case Type::byte:
      return static_cast<const unsigned char*>(first)[k];
  }
  return 0.0;
}

Tree keys_tree(const contact::Case& input) {
  Tree tree{"keys", "The keys that the case gives or that have a default, by their paths"};
  for (const contact::Section& section : contact::case_sections())
    if (!section.repeated && section.applies_to(input))
      for (const contact::Key& key : section) put_key(tree, key, key.get(input));
  return tree;
}

Tree dips_tree(const RunRecord& run) {
  Tree tree;
  if (const auto dips = wheel_dips(run); !dips.empty())
    put(tree, {"dips", "", "Where each wheel is lowest on its way, and its dip angle", ""}, dips);
  return tree;
}

Tree head_tree(const RunRecord& run) {
  Tree tree = dips_tree(run);
  tree.attributes = {{"verdict", run.verdict}};
  put(tree,
      {"documentation", "", "Unit and meaning of the attributes of /models/NAME/points/NUMBER"},
      documentation());
  tree.parts.push_back(quantities_tree());
  tree.parts.push_back(case_tree(run.input));
  put(tree, {"provenance", "", "Program, version, machine and time of this result", ""},
      run.provenance);
  if (!run.pairs.empty())
    put(tree, {"profiles", "", "Wheel and rail in position on the track, at its x = 0", ""},
        run.pairs);
  return tree;
}

std::size_t headline(const ModelResult& model) {
  std::size_t best = 0;
  const auto& points = model.points;
  for (std::size_t k = 1; k < points.size(); ++k) {
    if (!contact::is_solved(points[k])) continue;
    const bool of_passes = points[k].forward_flow.has_value();  // steps of a pressed body have none
    if (of_passes || !(points[best].normal_force >= points[k].normal_force * (1.0 - 1e-9)))
      best = k;
  }
  return best;
}

Tree place_tree(const contact::ContactPlace& place) {
  Tree tree;
  fill(tree, place);
  return tree;
}

Tree model_tree(const ModelResult& model, const contact::Case& input) {
  Tree tree{model.key(), "Result of the model " + model.name};
  fill(tree, model);
  if (model.place)
    for (const WayScalar& way : ways_of(input))
      tree.parts.front().attributes.emplace_back(way.name, way.at(input, model.place->position));
  Tree& grid = tree.parts.emplace_back(Tree{
      "grid",
      "Contact grid: centres of the elements (x, y) and their size (attributes dx, dy, in mm); "
      "fields are [ny, nx], x runs fastest"});
  grid.summed_up = false;
  grid.attributes = {{"dx", model.grid.dx}, {"dy", model.grid.dy}, {"unit", std::string("mm")}};
  put(grid, {"x", "mm", "element centres along rolling", "material enters at large x"},
      places(model.grid.nx, model.grid.x_first, model.grid.dx));
  put(grid, {"y", "mm", "element centres across rolling"},
      places(model.grid.ny, model.grid.y_first, model.grid.dy));
  fill(grid, model.rows);
  if (const auto kept = model.points_with_bodies(); !kept.empty())
    tree.parts.push_back(bodies_tree(model, kept.back()));
  Tree& traits = tree.parts.emplace_back(Tree{"traits", "What holds of the model"});
  traits.summed_up = false;
  for (const std::string& name : model.traits) traits.attributes.emplace_back(name, true);
  return tree;
}

Tree point_tree(const ModelResult& model, std::size_t number, bool with_fields) {
  const PointResult& point = model.points[number];
  Tree tree{fmt::format("{:04}", number),
            fmt::format("Creepage xi = {}, eta = {}, spin = {} rad/mm; attributes: see "
                        "/documentation",
                        point.creepage.longitudinal, point.creepage.lateral, point.creepage.spin)};
  add_quantities(tree, point);
  fill(tree, point);
  if (with_fields) add_fields(tree, model.grid, point.fields);
  if (contact::Field work = contact::pass_work(model.grid, point); work.size() > 0)
    put(tree, {"pass_work", "N/mm", "frictional work per pass and area", ""}, std::move(work));
  if (!point.bodies.empty()) tree.parts.push_back(values_tree(model, point));
  return tree;
}

namespace {

void require(bool condition, const std::string& where, const std::string& what) {
  if (!condition) throw std::logic_error(fmt::format("result record: {} {}", where, what));
}

void require_finite(double value, const std::string& where) {
  if (!std::isfinite(value))
    require(false, where, fmt::format("is {}, which is not a finite number", value));
}

void check_model_name(const std::string& name, std::set<std::string>& seen) {
  const bool is_file_name =
      !name.empty() &&
      name.find_first_not_of(
          "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_+.") ==
          std::string::npos &&
      name.front() != '.';
  require(is_file_name, fmt::format("model name '{}'", name),
          "must be a file name of letters, digits and - _ + .");
  require(seen.insert(name).second, fmt::format("model '{}'", name), "occurs twice");
}

void check_array(const std::string& where, const Array& array) {
  const std::size_t expected =
      std::accumulate(array.shape.begin(), array.shape.end(), std::size_t{1}, std::multiplies<>());
  require(array.count == expected, where,
          fmt::format("has {} values, its places {}", array.count, expected));
  if (array.type == Array::Type::whole || array.type == Array::Type::byte) return;
  // Millions of numbers are checked, so only bad ones get a name.
  for (std::size_t k = 0; k < array.count; ++k)
    if (const double value = array.at(k); !std::isfinite(value))
      require_finite(value, fmt::format("{}[{}]", where, k * array.shape[0] / array.count));
}

/// `solved`: without a solution a load point has no numbers of its own.
void check_tree(const std::string& where, const Tree& tree, bool solved = true) {
  for (const auto& [name, value] : tree.attributes)
    if (const auto* number = std::get_if<double>(&value); number != nullptr && solved)
      require_finite(*number, where + "/" + name);
  for (const Entry& entry : tree.entries)
    if (const auto* array = std::get_if<Array>(&entry.values))
      check_array(where + "/" + entry.name, *array);
  for (const Tree& part : tree.parts) check_tree(where + "/" + part.name, part);
}

void check_cells(const std::string& where, const contact::BodyField& body) {
  for (const auto& cell : body.cells)
    for (const int corner : cell)
      if (corner < 0 || corner >= static_cast<int>(body.points.size()))
        require(false, where + "/cells",
                fmt::format("name point {} of {}", corner, body.points.size()));
}

}  // namespace

bool keeps_grid(const contact::Case& input, const contact::ModelResult& model, std::size_t k) {
  if (!input.is_wheel_history() || !model.place)
    return input.output.keeps_grid(k, model.points.size());
  return input.output.keeps_grid(static_cast<std::size_t>(model.place->position) - 1,
                                 input.wheelset.positions());
}

void check_record(const RunRecord& run) {
  std::set<std::string> names;
  for (const contact::ModelResult& model : run.models) {
    const std::string key = model.key();
    check_model_name(key, names);
    std::set<std::string> bodies;
    for (const contact::BodyField& body : model.bodies) {
      check_model_name(body.name, bodies);
      check_cells(key + "/bodies/" + body.name, body);
    }
    check_tree(key, model_tree(model, run.input));
    for (std::size_t k = 0; k < model.points.size(); ++k) {
      const std::string where = fmt::format("{}/points/{:04}", key, k);
      const std::size_t stored = model.points[k].bodies.size();
      require(stored == 0 || stored == model.bodies.size(), where + "/bodies",
              fmt::format("has {} entries for {} bodies", stored, model.bodies.size()));
      check_tree(where, point_tree(model, k, true), contact::is_solved(model.points[k]));
    }
  }
}

}  // namespace rollfem::result
