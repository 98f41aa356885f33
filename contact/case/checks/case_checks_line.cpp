// Checks of [geometry]: a line contact has no extent across, and nothing that would need one.
#include "contact/case/checks/case_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace rollfem::contact {

namespace {

bool is_nothing(const GivenValue& value) {
  if (const auto* number = std::get_if<double>(&value.value)) return std::isinf(*number);
  if (const auto* truth = std::get_if<bool>(&value.value)) return !*truth;
  if (const auto* word = std::get_if<std::string>(&value.value))
    return *word == "auto" || *word == "planar";
  const auto* numbers = std::get_if<std::vector<double>>(&value.value);
  return numbers != nullptr &&
         std::all_of(numbers->begin(), numbers->end(), [](double number) { return number == 0.0; });
}

/// The width where nobody gives one, as the template of a case has it.
bool is_default_width(const std::string& name, const GivenValue& value) {
  const auto* number = std::get_if<double>(&value.value);
  return name == "width" && number != nullptr && *number == ContactShapeCase{}.width;
}

struct Refused {
  const char* section;
  const char* name;
  const char* why;
  const char* action;
};

constexpr const char* no_extent = "applies to contacts of finite width, but geometry.shape is line";
constexpr const char* give_radius =
    "remove it; the radius of a line contact is geometry.relative_radius";
constexpr const char* by_force = "give normal_force, the force in N on geometry.width";
constexpr const char* as_point = "remove it, or geometry.shape";

constexpr std::array<Refused, 14> refused{
    {{"wheel", "transverse_radius", no_extent, give_radius},
     {"rail", "transverse_radius", no_extent, give_radius},
     {"wheel", "profile", no_extent, give_radius},
     {"rail", "profile", no_extent, give_radius},
     {"undeformed_distance", "quadratic", no_extent, give_radius},
     {"undeformed_distance", "file", no_extent, give_radius},
     {"given_pressure", "semi_axis_x", no_extent, as_point},
     {"load", "approach",
      "does not determine the force, because half-planes have no finite approach", by_force},
     {"history", "approach",
      "does not determine the force, because half-planes have no finite approach", by_force},
     {"rolling", "spin", "is a rotation about the normal, which endless rollers do not allow",
      as_point},
     {"history", "spin_shift", "is a rotation about the normal, which endless rollers do not allow",
      as_point},
     {"rolling", "extra_slip_file", no_extent, as_point},
     {"halfspace", "surface", no_extent, as_point},
     {"halfspace", "model_error", "needs bodies of finite width, but geometry.shape is line",
      as_point}}};

void check_radius_of_line(const GivenCase& given) {
  if (given.find("geometry", "relative_radius") != nullptr ||
      given.find("wheel", "rolling_radius") != nullptr)
    return;
  CaseProblem missing;
  missing.line = section_line(given, "geometry");
  missing.column = 1;
  missing.key = "geometry.relative_radius";
  missing.wrong = "is missing, and wheel.rolling_radius too";
  missing.allowed = "one of them: a line contact needs a radius along rolling";
  missing.action = "add `relative_radius = 405.0` under [geometry]";
  fail(given.file, missing);
}

}  // namespace

bool is_line(const GivenCase& given) {
  const GivenValue* shape = given.find("geometry", "shape");
  return shape != nullptr && std::get<std::string>(shape->value) == "line";
}

void check_line(const GivenCase& given) {
  if (!is_line(given)) {
    for (const char* name : {"width", "relative_radius", "reference_distance"})
      if (const GivenValue* value = given.find("geometry", name);
          value && !is_default_width(name, *value))
        fail_at(given, std::string("geometry.") + name, *value,
                "applies to line contact, but geometry.shape is point", "with shape = \"line\"",
                "write `shape = \"line\"` under [geometry], or remove it");
    return;
  }
  for (const Refused& key : refused) {
    const GivenValue* value = given.find(key.section, key.name);
    if (value == nullptr || is_nothing(*value)) continue;
    fail_at(given, std::string(key.section) + "." + key.name, *value, key.why,
            "line contact of rollers under a prescribed force, rolling straight ahead", key.action);
  }
  check_radius_of_line(given);
}

void check_grid_of_line(const GivenCase& given, const Case& input) {
  if (input.geometry.shape != ContactShape::line) return;
  const double width = input.geometry.width;
  const auto check = [&](const char* name, double across, double expected) {
    const GivenValue* value = given.find("contact_grid", name);
    if (value == nullptr || std::abs(across - expected) <= 1e-9 * width) return;
    fail_at(
        given, std::string("contact_grid.") + name, *value,
        fmt::format("is not a single row of elements as wide as geometry.width, {:g} mm", width),
        fmt::format("{:g} mm across", expected),
        fmt::format("write {:g} as its second number", expected));
  };
  const GridOptions& grid = input.contact_grid;
  if (grid.cell_size) check("cell_size", (*grid.cell_size)[1], width);
  if (grid.extent) check("extent", (*grid.extent)[1], width);
  check("middle", grid.middle[1], 0.0);
}

}  // namespace rollfem::contact
