#include "convert/contact_reader.hpp"

#include <fmt/format.h>

#include "convert/input_lines.hpp"
#include "convert/read_case.hpp"
#include <cmath>

namespace rollfem::convert {

namespace {

bool rolls(const ContactCase& given) {
  return given.digits.T == 2 || given.digits.T == 3;
}
bool new_influence(int C) {
  return (C >= 2 && C <= 4) || C == 9;
}

/// V = 2 of older files and 3 of newer ones: a set of friction parameters for each row of elements.
bool friction_by_row(const Digits& digits) {
  return digits.V >= 2;
}

void read_single_contact(InputLines& lines, ContactCase& next) {
  const Digits& digits = next.digits;
  if (digits.G != 1) read_solver(lines, next);
  read_kinematics(lines, next);
  if (digits.L != 1 && !friction_by_row(digits)) read_friction(lines, next, 1);
  if (new_influence(digits.C)) {
    if (rolls(next)) read_rolling_step(lines, next);
    read_material(lines, next);
  }
  if (digits.D == 2) read_potential_contact(lines, next);
  if (digits.Z == 2 && next.potential.ipotcn > 0) read_undeformed_distance(lines, next);
  if (digits.L != 1 && friction_by_row(digits)) read_friction(lines, next, next.potential.my);
  if (digits.E == 9)
    lines.array("EXRHS", 2 * static_cast<std::size_t>(next.potential.mx) *
                             static_cast<std::size_t>(next.potential.my));
  read_subsurface(lines, next);
}

void read_wheel_on_rail(InputLines& lines, ContactCase& next) {
  const Digits& digits = next.digits;
  if (digits.G != 1) read_solver(lines, next);
  if (digits.L != 1)
    read_friction(lines, next,
                  digits.V == 0 ? 1 : lines.whole(lines.numbers({"NVF"}).front(), "NVF", 1, 10000));
  if (digits.C >= 2 && digits.C <= 4) read_material(lines, next);
  read_wheel_rail(lines, next);
  read_subsurface(lines, next);
}

/// What a first case cannot take from one before.
void check_first(const InputLines& lines, const ContactCase& first) {
  const Digits& digits = first.digits;
  const auto refuse = [&](const char* digit, const char* what) {
    lines.fail(
        fmt::format("digit {} of the first case keeps {} of a previous case, and there is none",
                    digit, what),
        "begin with a case that gives all its data");
  };
  if (digits.L == 1) refuse("L", "the friction");
  if (digits.D == 0) refuse("D", "the grid");
  if (digits.C == 0) refuse("C", "the materials");
  if (digits.Z == 0) refuse("Z", first.module == 1 ? "the track" : "the undeformed distance");
}

}  // namespace

std::vector<ContactCase> read_contact_file(std::string_view text, const std::string& name) {
  InputLines lines(text, name);
  std::vector<ContactCase> cases;
  ContactCase next;
  while (!lines.at_end()) {
    const double module = lines.numbers({"the module number"}).front();
    if (module == 0.0) break;
    if (module != 1.0 && module != 3.0)
      lines.fail(fmt::format("module {:g}; allowed: 1 (wheel and rail), 3 (single contacts), "
                             "0 (the end)",
                             module),
                 "check for a missing line above it");
    next.module = static_cast<int>(module);
    next.number = static_cast<int>(cases.size()) + 1;
    next.line = lines.line();
    read_digits(lines, next);
    if (cases.empty() || cases.back().module != next.module) check_first(lines, next);
    if (next.module == 3)
      read_single_contact(lines, next);
    else
      read_wheel_on_rail(lines, next);
    cases.push_back(next);
  }
  if (cases.empty()) lines.fail("the file contains no case", "give an input file of CONTACT");
  return cases;
}

}  // namespace rollfem::convert
