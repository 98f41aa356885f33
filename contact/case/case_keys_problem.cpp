// Declarations of what is asked: problem, prescribed forces, steps of a history, and what takes the
// place of the radii.
#include "contact/case/case_key_parts.hpp"

namespace rollfem::contact {

namespace {

const Words problem_words{"steady", "shift", "transient", "frictionless"};

Key force_key(const std::string& name, const std::string& symbol, const std::string& sentence,
              std::optional<double> PrescribedForce::*member) {
  Key key;
  key.section = "rolling";
  key.name = name;
  key.kind = KeyKind::numbers;
  key.symbol = symbol;
  key.unit = "N";
  key.bounds = any_force;
  key.when_absent = "creepage or shift is given instead";
  key.sentence = sentence;
  key.get = [member](const Case& c) {
    return shortened(c.rolling.forces, [member](const PrescribedForce& f) { return f.*member; });
  };
  key.set = [member](Case& c, const KeyValue& v) {
    c.rolling.forces.resize(c.rolling.creepages.size());
    set_per_load_point(c, v, [member](Case& all, std::size_t k, double number) {
      all.rolling.forces[k].*member = number;
    });
  };
  return key;
}

Key step_key(const std::string& name, const std::string& symbol, const std::string& unit,
             Bounds bounds, const std::string& when_absent, const std::string& sentence) {
  Key key;
  key.section = "history";
  key.name = name;
  key.kind = KeyKind::numbers;
  key.symbol = symbol;
  key.unit = unit;
  key.bounds = bounds;
  key.when_absent = when_absent;
  key.sentence = sentence;
  return key;
}

/// `member` is a double or an optional of it.
template <class Member>
Key step_key(Key key, Member HistoryStep::*member) {
  key.get = [member](const Case& c) {
    return shortened(c.history,
                     [member](const HistoryStep& s) { return std::optional<double>(s.*member); });
  };
  key.set = [member](Case& c, const KeyValue& v) {
    c.history.resize(c.rolling.creepages.size());
    set_per_load_point(c, v, [member](Case& all, std::size_t k, double number) {
      all.history[k].*member = number;
    });
  };
  return key;
}

Key ellipse_key(const std::string& name, const std::string& symbol, const std::string& unit,
                const std::string& when_absent, const std::string& sentence,
                double GivenPressure::*member) {
  Key key;
  key.section = "given_pressure";
  key.name = name;
  key.symbol = symbol;
  key.unit = unit;
  key.bounds = positive;
  key.when_absent = when_absent;
  key.sentence = sentence;
  key.get = [member](const Case& c) -> KeyValue {
    if (!c.given_pressure || (*c.given_pressure).*member == 0.0) return {};
    return (*c.given_pressure).*member;
  };
  key.set = [member](Case& c, const KeyValue& v) {
    if (!c.given_pressure) c.given_pressure.emplace();
    (*c.given_pressure).*member = std::get<double>(v);
  };
  return key;
}

}  // namespace

void grow_load_points(Case& input, std::size_t count) {
  auto& creepages = input.rolling.creepages;
  if (creepages.size() == 1) creepages.resize(count, creepages.front());
  const auto follow = [&](auto& entries) {
    if (!entries.empty()) entries.resize(creepages.size(), entries.front());
  };
  follow(input.rolling.forces);
  follow(input.wheelset.rotation_change);
  follow(input.history);
}

Key count_key(const std::string& section, const std::string& name, Bounds bounds,
              const std::string& sentence, int& (*member)(Case&)) {
  Key key;
  key.section = section;
  key.name = name;
  key.kind = KeyKind::integer;
  key.bounds = bounds;
  key.sentence = sentence;
  key.get = [member](const Case& c) -> KeyValue {
    return static_cast<double>(member(const_cast<Case&>(c)));
  };
  key.set = [member](Case& c, const KeyValue& v) {
    member(c) = static_cast<int>(std::get<double>(v));
  };
  return key;
}

Key file_key(const std::string& section, const std::string& name, const std::string& when_absent,
             const std::string& sentence, std::optional<Lattice>& (*member)(Case&)) {
  Key key;
  key.section = section;
  key.name = name;
  key.kind = KeyKind::text;
  key.when_absent = when_absent;
  key.sentence = sentence;
  key.get = [member](const Case& c) -> KeyValue {
    const std::optional<Lattice>& values = member(const_cast<Case&>(c));
    return values ? KeyValue(values->file) : KeyValue();
  };
  key.set = [member](Case& c, const KeyValue& v) {
    member(c).emplace().file = std::get<std::string>(v);
  };
  return key;
}

std::vector<Key> problem_keys() {
  return {
      word_key<Problem>(
          "rolling", "problem", problem_words,
          "`steady`: steady rolling, every load point on its own; `shift`: pressed and pushed "
          "without "
          "rolling (Cattaneo), load points are steps; `transient`: rolling in steps from the state "
          "before; `frictionless`: the normal problem alone.",
          [](Case& c) -> Problem& { return c.rolling.problem; }),
      force_key("longitudinal_force", "F_x",
                "Force on the wheel along x, in place of longitudinal_creepage (or "
                "longitudinal_shift); negative when braking. Its size must be below mu F_z.",
                &PrescribedForce::longitudinal),
      force_key("lateral_force", "F_y",
                "The same along y, in place of lateral_creepage (or lateral_shift).",
                &PrescribedForce::lateral),
  };
}

std::vector<Key> history_keys() {
  const Bounds small_shift{0.0, 1e3, false, true};
  std::vector<Key> keys;
  Key steps;
  steps.section = "history";
  steps.name = "steps";
  steps.kind = KeyKind::integer;
  steps.bounds = {1, 1000};
  steps.when_absent = "the length of the lists";
  steps.sentence = "Number of steps, where no list tells it.";
  steps.get = [](const Case& c) -> KeyValue {
    if (c.history.empty()) return {};
    return static_cast<double>(c.history.size());
  };
  steps.set = [](Case& c, const KeyValue& v) {
    c.history.resize(c.rolling.creepages.size());
    grow_load_points(c, static_cast<std::size_t>(std::get<double>(v)));
  };
  keys.push_back(steps);
  keys.push_back(
      step_key(step_key("normal_force", "F_z", "N", {1e-6, 1e12}, "load.normal_force in all steps",
                        "Normal force of each step, in place of [load]."),
               &HistoryStep::normal_force));
  keys.push_back(
      step_key(step_key("approach", "delta", "mm", {1e-9, 1e6}, "load.approach in all steps",
                        "Approach in each step, in place of [load]."),
               &HistoryStep::approach));
  keys.push_back(step_key(
      step_key("longitudinal_shift", "", "mm", small_shift, "0",
               "Rigid displacement of the wheel over the rail along x in each step (shift)."),
      &HistoryStep::longitudinal_shift));
  keys.push_back(
      step_key(step_key("lateral_shift", "", "mm", small_shift, "0", "The same along y."),
               &HistoryStep::lateral_shift));
  keys.push_back(step_key(step_key("spin_shift", "", "rad", at_most_one, "0",
                                   "Rotation about the normal in each step (shift)."),
                          &HistoryStep::spin_shift));
  keys.push_back(step_key(step_key("step_length", "", "mm", positive, "required by `transient`",
                                   "How far the wheel rolls in each step (transient)."),
                          &HistoryStep::step_length));
  return keys;
}

std::vector<Key> surface_keys() {
  Key quadratic;
  quadratic.section = "undeformed_distance";
  quadratic.name = "quadratic";
  quadratic.kind = KeyKind::pair;
  quadratic.symbol = "A, B";
  quadratic.unit = "1/mm";
  quadratic.bounds = {1e-9, 1e6};
  quadratic.when_absent = "from the radii of wheel and rail";
  quadratic.sentence = "h = A x^2 + B y^2; the radii may then be left out.";
  quadratic.get = [](const Case& c) -> KeyValue {
    const auto& values = c.undeformed_distance.quadratic;
    return values ? KeyValue(Numbers(values->begin(), values->end())) : KeyValue();
  };
  quadratic.set = [](Case& c, const KeyValue& v) {
    const auto& values = std::get<Numbers>(v);
    c.undeformed_distance.quadratic = {values.at(0), values.at(1)};
  };
  return {
      quadratic,
      file_key(
          "undeformed_distance", "file", "from the radii of wheel and rail",
          "Lines `x, y, h` in mm on a regular lattice, which becomes the potential contact area; "
          "the path is relative to the case file. Cubics between the points.",
          [](Case& c) -> std::optional<Lattice>& { return c.undeformed_distance.values; }),
      ellipse_key("semi_axis_x", "a", "mm", "the normal problem is solved",
                  "Semi-axis of the ellipse along rolling; the radii may then be left out.",
                  &GivenPressure::semi_axis_x),
      ellipse_key("semi_axis_y", "b", "mm", "the normal problem is solved",
                  "Semi-axis of the ellipse across rolling.", &GivenPressure::semi_axis_y),
      ellipse_key("max_pressure", "p_0", "MPa", "from load.normal_force",
                  "Pressure in the middle of the ellipse, in place of load.normal_force.",
                  &GivenPressure::max_pressure),
  };
}

}  // namespace rollfem::contact
