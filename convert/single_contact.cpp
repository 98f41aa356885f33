// SPDX-License-Identifier: LGPL-2.1-or-later
#include "convert/single_contact.hpp"

#include "base/grid.hpp"
#include "base/material.hpp"
#include "base/pi.hpp"
#include "halfspace/closed_forms/hertz.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace rollfem::convert {

namespace {

/// Sign from CONTACT's axes to ours: -1 if CONTACT rolls along -x, so that both axes turn by half a
/// turn.
std::optional<double> turn(const ContactCase& given, Equivalent& made) {
  if (given.digits.T < 2) return 1.0;
  const double chi = std::remainder(given.rolling[0], 2.0 * contact::pi);
  if (std::abs(chi) < 1e-9) return 1.0;
  if (std::abs(std::abs(chi) - contact::pi) < 1e-9) {
    made.notes.push_back(
        "CHI = 180 degrees: the axes are turned by half a turn so that the case rolls along +x; x, "
        "y, F_x and F_y have the opposite sign of CONTACT's, spin and M_z the same");
    return -1.0;
  }
  made.impossible.push_back(
      fmt::format("CHI = {:g} degrees: rolling is along x only; allowed: 0 and 180",
                  chi * 180.0 / contact::pi));
  return std::nullopt;
}

contact::Material material(const BodyConstants& bodies, std::size_t body) {
  contact::Material made;
  made.poisson_ratio = bodies.poisson[body];
  made.young_modulus = 2.0 * bodies.shear_modulus[body] * (1.0 + made.poisson_ratio);
  return made;
}

/// Beyond this ratio of curvatures a contact is numerically a line.
constexpr double largest_ratio = 1e8;

bool is_line(double A, double B) {
  return A > largest_ratio * B || B > largest_ratio * A;
}

/// Reports values that must be positive for the conversion.
void judge_values(const ContactCase& given, Equivalent& made) {
  const auto demand = [&](bool right, const char* what) { made.refuse(!right, what); };
  for (std::size_t body = 0; body < 2; ++body) {
    const double nu = given.bodies.poisson[body];
    demand(given.bodies.shear_modulus[body] > 0.0, "GG must be positive");
    demand(nu >= 0.0 && nu < 0.5, "POISS must be at least 0 and below 0.5");
  }
  demand(given.kinematics[0] > 0.0,
         given.digits.N == 0 ? "PEN must be positive" : "FN must be positive");
  const int kind = given.potential.ipotcn;
  const auto& size = given.potential.size;
  if (kind >= 0 || kind < -3) return;
  demand(size[0] > 0.0 && size[1] > 0.0 && size[2] > 0.0,
         "the curvatures or semi-axes and SCALE behind MX, MY must be positive");
  const double power = kind == -1 ? 1.0 : 2.0;  // exponent of the ratio of semi-axes
  const double first = kind == -2 ? 1.0 : size[0];
  demand(!is_line(std::pow(first, power), std::pow(size[1], power)),
         "the curvatures differ so much that this is a line contact");
}

bool has_given_pressure(const ContactCase& given) {
  return given.potential.ipotcn < 0 && !is_simplified(given.digits) && given.digits.B == 2;
}

using Area = ElementPlaces;

void set_grid(const ContactCase& given, const Area& area, double sign, Equivalent& made) {
  const double length = area.dx * given.potential.mx, width = area.dy * given.potential.my;
  made.set("contact_grid", "cell_size", {area.dx, area.dy}, "mm");
  made.set("contact_grid", "extent", {length, width},
           fmt::format("mm, {} by {} elements", given.potential.mx, given.potential.my));
  const double x = in_mm(sign * (area.x + 0.5 * length));
  const double y = in_mm(sign * (area.y + 0.5 * width));
  const double rounding = 1e-9 * (length + width);
  if (std::abs(x) > rounding || std::abs(y) > rounding)
    made.set("contact_grid", "middle", {x, y}, "mm");
  if (given.friction.size() > 1) {
    std::vector<double> rows;
    for (int j = 0; j < given.potential.my; ++j)
      rows.push_back(in_mm(sign * (area.y + (j + 0.5) * area.dy)));
    std::sort(rows.begin(), rows.end());
    made.set("friction", "lateral_position", rows, "mm, of the rows");
  }
  fill_stresses(given, area, sign, made);
}

Area stated_area(const PotentialContact& given) {
  const auto& [x, y, u, v] =
      given.size;  // dx, dy for kinds 1 and 3, the opposite corner for 2 and 4
  if (given.ipotcn == 1) return {x, y, u, v};
  if (given.ipotcn == 3) return {x - 0.5 * u, y - 0.5 * v, u, v};
  if (given.ipotcn == 2) return {x, y, (u - x) / given.mx, (v - y) / given.my};
  // kind 4: between the centres of the first and the last element
  const double dx = given.mx > 1 ? (u - x) / (given.mx - 1) : 2.0 * (u - x);
  const double dy = given.my > 1 ? (v - y) / (given.my - 1) : 2.0 * (v - y);
  return {x - 0.5 * dx, y - 0.5 * dy, dx, dy};
}

using halfspace::HertzContact;

/// Hertz's contact with these semi-axes and a largest pressure of 1 MPa.
HertzContact unit_ellipse(double a, double b) {
  return {a, b, 1.0, 0.0, 2.0 / 3.0 * contact::pi * a * b};
}

/// Ellipse and curvatures for IPOTCN = -1 to -3.
struct Ellipse {
  HertzContact hertz;
  contact::Curvatures curvatures;
};

HertzContact hertz_of(const ContactCase& given, double A, double B, double modulus) {
  return (given.digits.N == 1 ? halfspace::hertz_from_force : halfspace::hertz_from_approach)(
      A, B, modulus, given.kinematics[0]);
}

Ellipse ellipse_of(const ContactCase& given, double modulus) {
  const auto& s = given.potential.size;
  if (given.potential.ipotcn == -3) {
    const HertzContact hertz = unit_ellipse(s[0], s[1]);
    const contact::Curvatures unit = halfspace::hertz_curvatures(hertz, modulus);
    const HertzContact found =
        halfspace::hertz_from_force(unit.A, unit.B, modulus, hertz.normal_force);
    const double factor =
        given.kinematics[0] / (given.digits.N == 1 ? hertz.normal_force : found.approach);
    return {{s[0], s[1], factor, factor * found.approach, factor * hertz.normal_force},
            {factor * unit.A, factor * unit.B}};
  }
  double B = s[1];
  if (given.potential.ipotcn == -2) {
    const contact::Curvatures unit = halfspace::hertz_curvatures(unit_ellipse(s[1], 1.0), modulus);
    B = s[0] * unit.B / unit.A;
  }
  return {hertz_of(given, s[0], B, modulus), {s[0], B}};
}

void note_resolution(const HertzContact& hertz, double dx, double dy, Equivalent& made) {
  const double along = std::max(1.0, std::round(2.0 * hertz.semi_axis_x / dx));
  const double across = std::max(1.0, std::round(2.0 * hertz.semi_axis_y / dy));
  made.note(along < 4.0 || across < 4.0,
            fmt::format("the patch is only {:g} by {:g} elements: its numbers are those of CONTACT "
                        "on the same elements, not those of the bodies",
                        along, across));
}

void fill_ellipse(const ContactCase& given, double modulus, double sign, Equivalent& made) {
  const PotentialContact& potential = given.potential;
  if (potential.ipotcn <= -4)
    return made.refuse(true, potential.ipotcn == -6
                                 ? "IPOTCN = -6: the contact area of SDEC"
                                 : fmt::format("IPOTCN = {}: line contact", potential.ipotcn));
  const Ellipse ellipse = ellipse_of(given, modulus);
  const double scale = potential.size[2];
  const double a = ellipse.hertz.semi_axis_x, b = ellipse.hertz.semi_axis_y;
  const bool simplified = is_simplified(given.digits);
  if (has_given_pressure(given)) {
    made.set("given_pressure", "semi_axis_x", a, "mm");
    made.set("given_pressure", "semi_axis_y", b, "mm");
  } else {
    made.set("undeformed_distance", "quadratic", {ellipse.curvatures.A, ellipse.curvatures.B},
             "1/mm, h = A x^2 + B y^2");
  }
  const Area area{-scale * a, -scale * b, 2.0 * scale * a / potential.mx,
                  2.0 * scale * b / potential.my};
  set_grid(given, area, sign, made);
  note_resolution(ellipse.hertz, area.dx, area.dy, made);
  if (!simplified) return;
  made.model = given.digits.M == 5 ? "fastrip" : "fastsim";
  made.set("fastsim", "bound", given.digits.B == 3 ? "parabolic" : "elliptic");
  made.set("fastsim", "elements", "grid");
  made.set("fastsim", "strips", std::round(potential.my / scale), "MY / SCALE");
  made.set("fastsim", "strip_elements", std::round(potential.mx / scale), "MX / SCALE");
  const auto& slope = given.bodies.slope_reduction;
  made.set("fastsim", "slope_reduction", {slope.begin(), slope.end()}, "K0_MF, ALFAMF, BETAMF");
}

/// Undeformed distance of circles along x and a polyline across, whose outer segments are
/// unbounded.
double circular_distance(const std::vector<double>& values, double x, double y) {
  const double xm = values[1], radius = values[2], y1 = values[3], dy = values[4];
  const auto last = static_cast<double>(values.size() - 7);  // index of the last segment, from 0
  const double piece = std::clamp(std::floor((y - y1) / dy), 0.0, last);
  const double* height = values.data() + 5 + static_cast<std::size_t>(piece);
  const double rise = (height[1] - height[0]) * ((y - y1) / dy - piece);
  return height[0] + rise + (x - xm) * (x - xm) / (2.0 * radius);
}

/// Undeformed distance of the element with that number at (x, y), in CONTACT's axes.
double distance_at(const UndeformedDistance& distance, std::size_t element, double x, double y) {
  const std::vector<double>& B = distance.values;
  if (distance.ibase == 9) return B[element];
  if (distance.ibase == 2) return circular_distance(B, x, y);
  if (distance.ibase == 3)
    return B[0] * std::sin(B[1] * (x - B[2])) - B[3] * std::sin(B[4] * (x - B[5])) + x * x / B[6] +
           y * y / B[7];
  return B[0] * x * x + B[1] * x * y + B[2] * y * y + B[3] * x + B[4] * y + B[5];
}

/// Undeformed distance of all elements in our axes.
std::vector<std::array<double, 3>> distances(const ContactCase& given, const Area& area,
                                             double sign) {
  std::vector<std::array<double, 3>> made;
  for (int j = 0; j < given.potential.my; ++j)
    for (int i = 0; i < given.potential.mx; ++i) {
      const double x = area.x + (i + 0.5) * area.dx, y = area.y + (j + 0.5) * area.dy;
      made.push_back({sign * x, sign * y, distance_at(given.distance, made.size(), x, y)});
    }
  return made;
}

/// Least length of the elements of a single row over the length of the row. Their ends then change
/// displacement differences within the row by at most 6e-4.
constexpr double longest_row = 20.0;

/// Of a line contact of rollers; 0: none.
double roller_radius(const UndeformedDistance& distance) {
  const auto& B = distance.values;
  const auto zeros_from = [&](std::ptrdiff_t first) {
    return std::all_of(B.begin() + first, B.end(), [](double value) { return value == 0.0; });
  };
  if (distance.ibase == 1 && B[0] > 0.0 && zeros_from(1)) return 0.5 / B[0];
  // NN, XM, RX1, Y1, DY1 and the heights across
  return distance.ibase == 2 && B[1] == 0.0 && zeros_from(5) ? B[2] : 0.0;
}

void fill_line(const ContactCase& given, Area area, double modulus, double sign, Equivalent& made) {
  const auto refuse = [&](const std::string& what) { made.refuse(true, what); };
  const double radius = roller_radius(given.distance);
  if (!(radius > 0.0))
    return refuse(
        "MY = 1: a line contact of rollers needs IBASE = 1 with B1 > 0 and all other B = 0, or "
        "IBASE = 2 with RX1 > 0, XM = 0 and no height across");
  if (given.digits.N == 0) return refuse("MY = 1, N = 0: a line contact with prescribed approach");
  if (given.kinematics[3] != 0.0) return refuse("MY = 1, CPHI: a line contact with spin");
  const double row = given.potential.mx * area.dx;
  if (area.dy < longest_row * row)
    return refuse(
        fmt::format("MY = 1: DY = {:g} mm is too short for a line contact; allowed: at least {:g} "
                    "times the row of {:g} mm",
                    area.dy, longest_row, row));
  made.set("geometry", "shape", "line");
  made.set("geometry", "width", area.dy, "mm, the width that forces refer to: DY");
  made.set("geometry", "relative_radius", radius,
           given.distance.ibase == 2 ? std::string("mm, RX1")
                                     : fmt::format("mm, B1 = {:g} /mm", given.distance.values[0]));
  made.set("geometry", "reference_distance", contact::infinity,
           "displacements as in elements of that length");
  area.y = -0.5 * area.dy;
  set_grid(given, area, sign, made);
  made.varied.erase("rolling.spin");
  made.varied.erase("history.spin_shift");
  const double a =
      halfspace::line_hertz(radius, modulus, given.kinematics[0] / area.dy, area.dy).half_width;
  note_resolution({a, 0.5 * area.dy, 0.0, 0.0, 0.0}, area.dx, 0.25 * area.dy, made);
}

/// x of the lowest point of IBASE = 1 in a step of a shift, to CONTACT's digits: the body may roll
/// over axes that stand still. Otherwise 0.
double place_of_parabola(const ContactCase& given) {
  const auto& B = given.distance.values;
  const Digits& digits = given.digits;
  if (digits.P != 0 || digits.T != 1 || digits.S > 0 || given.distance.ibase != 1 || !(B[0] > 0.0))
    return 0.0;
  return std::round(-0.5e4 * B[3] / B[0]) * 1e-4;
}

/// h = A (x - place)^2 + B y^2 with positive A and B.
bool is_parabola(const UndeformedDistance& distance, double place) {
  const auto& B = distance.values;
  if (distance.ibase != 1 || B[1] != 0.0 || B[4] != 0.0 || !(B[0] > 0.0) || !(B[2] > 0.0))
    return false;
  if (place == 0.0) return B[3] == 0.0 && B[5] == 0.0;
  constexpr double rounding = 1e-6;  // mm
  return std::abs(B[5] - B[0] * place * place) <= rounding + 1e-5 * B[5];
}

void fill_distance(const ContactCase& given, double modulus, double sign, Equivalent& made) {
  const UndeformedDistance& distance = given.distance;
  const auto refuse = [&](const std::string& what) { made.refuse(true, what); };
  made.refuse(distance.iplan != 1,
              fmt::format("IPLAN = {}: a prescribed planform", distance.iplan));
  const auto& B = distance.values;
  made.refuse(distance.ibase == 2 && (B[2] == 0.0 || B[4] <= 0.0),
              "IBASE = 2: RX1 must not be 0 and DY1 must be positive");
  made.refuse(distance.ibase == 3 && (B[6] == 0.0 || B[7] == 0.0),
              "IBASE = 3: B7 and B8 must not be 0");
  if (!made.impossible.empty()) return;
  Area area = stated_area(given.potential);
  if (area.dx <= 0.0 || area.dy <= 0.0) return refuse("the element size is not positive");
  if (given.potential.my == 1) return fill_line(given, area, modulus, sign, made);
  const double place = place_of_parabola(given);
  const bool plain = is_parabola(distance, place);
  if (plain && is_line(B[0], B[2]))
    return refuse("the curvatures differ so much that this is a line contact");
  if (plain) area.x -= made.place = place;
  set_grid(given, area, sign, made);
  if (plain) {
    const HertzContact hertz = hertz_of(given, B[0], B[2], modulus);
    made.approach = hertz.approach;
    made.set("undeformed_distance", "quadratic", {B[0], B[2]}, "1/mm, h = A x^2 + B y^2");
    return note_resolution(hertz, area.dx, area.dy, made);
  }
  made.distance = distances(given, area, sign);
}

/// Normal force of PEN; 0 where no closed form knows it.
double force_by_hertz(const ContactCase& given, double modulus) {
  if (given.potential.ipotcn < 0)
    return given.potential.ipotcn >= -3 ? ellipse_of(given, modulus).hertz.normal_force : 0.0;
  if (!is_parabola(given.distance, place_of_parabola(given))) return 0.0;
  const auto& B = given.distance.values;
  return hertz_of(given, B[0], B[2], modulus).normal_force;
}

void fill_motion(const ContactCase& given, double modulus, double sign, Equivalent& made) {
  const Digits& digits = given.digits;
  const auto& k = given.kinematics;
  const bool shift = made.problem == "shift";
  const bool by_step = made.history() && !has_given_pressure(given);
  made.varied[std::string(by_step ? "history." : "load.") +
              (digits.N == 0 ? "approach" : "normal_force")] = k[0];
  if (digits.T == 0) return;
  const double normal_force = digits.N == 1 ? k[0] : force_by_hertz(given, modulus);
  made.refuse(digits.F > 0 && normal_force == 0.0,
              "digits N = 0, F > 0: tangential forces are relative to a normal force that is known "
              "only for an ellipse or a parabola");
  made.note(digits.F > 0 && digits.N == 0,
            "digits N = 0, F > 0: FX and FY are taken of FSTAT times the force of PEN by Hertz");
  const std::array<std::string, 2> names{"longitudinal", "lateral"};
  for (std::size_t direction = 0; direction < 2; ++direction) {
    const double value = sign * k[1 + direction] + 0.0;  // no -0
    const std::string& name = names[direction];
    const bool by_force = digits.F > static_cast<int>(direction);
    // Cases with forces and cases with creepages may share a file.
    made.varied["rolling." + name + "_force"] =
        by_force ? value * given.friction.front().fstat * normal_force : std::nan("");
    made.varied[shift ? "history." + name + "_shift" : "rolling." + name + "_creepage"] =
        by_force ? 0.0 : value;
  }
  made.varied[shift ? "history.spin_shift" : "rolling.spin"] = k[3];
  if (made.problem == "transient") made.varied["history.step_length"] = given.rolling[1];
}

}  // namespace

std::optional<std::array<double, 4>> ellipse_of_case(const ContactCase& given) {
  if (given.potential.ipotcn >= 0 || given.potential.ipotcn < -3) return {};
  const double modulus =
      contact::combine(material(given.bodies, 0), material(given.bodies, 1)).contact_modulus;
  const Ellipse found = ellipse_of(given, modulus);
  return std::array{found.curvatures.A, found.curvatures.B, found.hertz.semi_axis_x,
                    found.hertz.semi_axis_y};
}

void fill_single_contact(const ContactCase& given, Equivalent& made) {
  judge_values(given, made);
  if (!made.impossible.empty()) return;
  const auto sign = turn(given, made);
  fill_bodies(given, {"wheel", "rail"}, made);
  if (!sign) return;
  const double modulus =
      contact::combine(material(given.bodies, 0), material(given.bodies, 1)).contact_modulus;
  fill_motion(given, modulus, *sign, made);
  if (!made.impossible.empty()) return;
  if (given.potential.ipotcn < 0)
    fill_ellipse(given, modulus, *sign, made);
  else
    fill_distance(given, modulus, *sign, made);
  if (made.model == "halfspace" && (given.digits.T == 2 || given.digits.T == 3))
    made.set("rolling", "upwind_order", "first");
}

}  // namespace rollfem::convert
