// SPDX-License-Identifier: LGPL-2.1-or-later
#include "result/quantities.hpp"

#include "result/bars.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace rollfem::contact {

namespace {

template <auto First, auto... Rest, class Object>
auto& follow(Object& object) {
  if constexpr (sizeof...(Rest) == 0)
    return object.*First;
  else
    return follow<Rest...>(object.*First);
}

/// The member at the end of a path of member pointers: double, int, bool, or a double that may be
/// absent.
template <auto... Path>
QuantityMember at() {
  using Value = std::remove_reference_t<decltype(follow<Path...>(std::declval<PointResult&>()))>;
  constexpr bool optional = std::is_same_v<Value, std::optional<double>>;
  constexpr QuantityKind kind = std::is_same_v<Value, bool>  ? QuantityKind::truth
                                : std::is_same_v<Value, int> ? QuantityKind::count
                                                             : QuantityKind::number;
  return {kind, optional,
          [](const PointResult& point) -> std::optional<double> {
            const auto& member = follow<Path...>(point);
            if constexpr (optional)
              return member;
            else if constexpr (kind == QuantityKind::number)
              return std::isnan(member) ? std::nullopt : std::optional<double>(member);
            else
              return static_cast<double>(member);
          },
          [](PointResult& point, double value) {
            if constexpr (kind == QuantityKind::truth)
              follow<Path...>(point) = value != 0.0;
            else if constexpr (kind == QuantityKind::count)
              follow<Path...>(point) = static_cast<int>(value);
            else
              follow<Path...>(point) = value;
          }};
}

/// The same of the problem without friction.
template <auto... Path>
QuantityMember normal() {
  QuantityMember member = at<Path...>();
  member.normal_problem = true;
  return member;
}

using P = PointResult;
using Scale = ErrorScale;
using Use = QuantityUse;

/// Prescribed quantities: creepages (found for prescribed forces) and, in a history, the
/// accumulated motion.
std::vector<Quantity> of_the_motion() {
  return {
      {"longitudinal_creepage", "longitudinal creepage", "xi", "-",
       "longitudinal creepage, prescribed or found; positive brakes the wheel", Scale::none,
       Use::stored, at<&P::creepage, &Creepage::longitudinal>(), NoBar::given},
      {"lateral_creepage", "lateral creepage", "eta", "-", "lateral creepage; positive towards +y",
       Scale::none, Use::stored, at<&P::creepage, &Creepage::lateral>(), NoBar::given},
      {"spin", "spin", "phi", "rad/mm",
       "rotation of the wheel on the rail about the normal, per mm rolled", Scale::none,
       Use::stored, at<&P::creepage, &Creepage::spin>(), NoBar::given},
      {"step", "step", "", "-",
       "step of a history or pass over bodies that yield, from 1; otherwise 0", Scale::none,
       Use::stored, at<&P::step>(), NoBar::counted},
      {"longitudinal_shift", "longitudinal shift", "", "mm",
       "rigid shift of the wheel along x since the beginning", Scale::none, Use::stored,
       at<&P::longitudinal_shift>(), NoBar::given},
      {"lateral_shift", "lateral shift", "", "mm",
       "rigid shift of the wheel along y since the beginning", Scale::none, Use::stored,
       at<&P::lateral_shift>(), NoBar::given},
      {"spin_shift", "rotation", "", "rad", "rotation about the normal since the beginning",
       Scale::none, Use::stored, at<&P::spin_shift>(), NoBar::given},
      {"distance", "distance", "", "mm", "distance rolled since the beginning", Scale::none,
       Use::stored, at<&P::distance>(), NoBar::given},
  };
}

std::vector<Quantity> of_the_forces() {
  return {
      {"normal_force", "normal force", "F_z", "N", "normal force, positive in compression",
       Scale::value, Use::accuracy, normal<&P::normal_force>()},
      {"longitudinal_force", "longitudinal force", "F_x", "N",
       "force along x on the wheel; negative for positive xi", Scale::force, Use::stored,
       at<&P::longitudinal_force>()},
      {"lateral_force", "lateral force", "F_y", "N",
       "force along y of the patch on the wheel; negative for positive eta", Scale::force,
       Use::stored, at<&P::lateral_force>()},
      {"lateral_pressure", "lateral force of the pressure", "", "N",
       "part of the lateral force carried by the pressure of a curved patch; friction bounds the "
       "rest",
       Scale::none, Use::stored, at<&P::lateral_pressure>(), NoBar::one_grid},
      {"spin_moment", "spin moment", "M_z", "N mm", "moment on the wheel about the origin",
       Scale::moment, Use::stored, at<&P::spin_moment>()},
      {"traction_coefficient", "traction coefficient", "-F_x/F_z", "-",
       "ordinate of the creep curve", Scale::friction, Use::accuracy,
       at<&P::traction_coefficient>()},
      {"max_pressure", "largest pressure", "p_0", "MPa",
       "largest pressure, positive in compression", Scale::value, Use::accuracy,
       normal<&P::max_pressure>()},
      {"max_traction", "largest tangential traction", "|p_t|", "MPa",
       "largest magnitude of the tangential traction", Scale::traction, Use::stored,
       at<&P::max_traction>()},
      {"max_traction_x", "largest longitudinal traction", "|p_x|", "MPa",
       "largest magnitude of the traction along x", Scale::traction, Use::accuracy,
       at<&P::max_traction_x>()},
  };
}

std::vector<Quantity> of_the_patch() {
  return {
      {"approach", "approach", "", "mm", "approach (penetration)", Scale::value, Use::accuracy,
       normal<&P::approach>()},
      {"semi_axis_x", "semi-axis along x", "a", "mm",
       "half the extent in x, found below the element size", Scale::value, Use::accuracy,
       normal<&P::semi_axis_x>()},
      {"semi_axis_y", "semi-axis along y", "b", "mm",
       "half the width, found below the element size", Scale::value, Use::accuracy,
       normal<&P::semi_axis_y>()},
      {"contact_length", "length of the patch along x", "", "mm", "extent of the patch in x",
       Scale::value, Use::stored, normal<&P::contact_length>()},
      {"contact_width", "width of the patch along y", "", "mm",
       "extent of the patch across; of a curved one the arc length", Scale::value, Use::stored,
       normal<&P::contact_width>()},
      {"contact_area", "contact area", "", "mm^2", "area of the patch", Scale::value, Use::compared,
       normal<&P::contact_area>()},
      {"adhesion_area", "adhesion area", "", "mm^2", "area that does not slip", Scale::value,
       Use::stored, at<&P::adhesion_area>()},
      {"patch_count", "patches", "", "-",
       "separate regions of the contact; forces are those of all, `patches` and `patches.csv` list "
       "each",
       Scale::none, Use::stored, at<&P::patch_count>(), NoBar::counted},
  };
}

/// Figures of the solution, and quantities derived from the fields where a model gives them.
std::vector<Quantity> of_the_solution() {
  return {
      {"iterations", "iterations", "", "-", "outer iterations (FE solves) or Newton steps",
       Scale::none, Use::stored, at<&P::iterations>(), NoBar::counted},
      {"residual", "residual", "", "-", "relative residual of the last iteration", Scale::none,
       Use::stored, at<&P::residual>(), NoBar::measured},
      {"seconds", "seconds", "", "s", "time of this load point", Scale::none, Use::stored,
       at<&P::seconds>(), NoBar::measured},
      {"converged", "converged", "", "-", "do not use a point that has not converged", Scale::none,
       Use::stored, at<&P::converged>(), NoBar::counted},
      {"elastic_energy", "elastic energy", "", "N mm",
       "elastic energy of both bodies; half-space only", Scale::value, Use::stored,
       at<&P::elastic_energy>()},
      {"frictional_work", "frictional work", "", "N",
       "N mm per mm rolled, tractions times slip; steady rolling only", Scale::value, Use::stored,
       at<&P::frictional_work>()},
      {"creepage_work", "work of the creepages", "", "N",
       "N mm per mm rolled, forces times creepages; equals the frictional work of half-spaces",
       Scale::value, Use::stored, at<&P::creepage_work>()},
      {"max_pass_work", "largest work per pass", "w", "N/mm",
       "largest frictional work per pass and area (N mm/mm^2) on the profiles; the bar holds at "
       "every place",
       Scale::value, Use::stored, at<&P::max_pass_work>()},
      {"pass_work_y_wheel", "place of the largest work on the wheel", "", "mm",
       "y of it on the wheel's profile; without profiles y of the patch", Scale::none, Use::stored,
       at<&P::pass_work_y_wheel>(), NoBar::one_grid},
      {"pass_work_y_rail", "place of the largest work on the rail", "", "mm",
       "the same on the rail's profile", Scale::none, Use::stored, at<&P::pass_work_y_rail>(),
       NoBar::one_grid},
      {"revolution_work", "frictional work per revolution", "", "J",
       "frictional work per revolution of the wheel", Scale::value, Use::stored,
       at<&P::revolution_work>()},
      {"patch_x_middle", "middle of the patch along x", "", "mm",
       "middle of the patch in x; with profiles", Scale::none, Use::stored,
       normal<&P::patch_x_middle>()},
      {"patch_y_middle", "middle of the patch along y", "", "mm",
       "middle of the patch in y; with profiles", Scale::none, Use::stored,
       normal<&P::patch_y_middle>()},
      {"vertical_force", "vertical force", "", "N",
       "vertical force in the track, friction included; with profiles", Scale::value, Use::stored,
       at<&P::vertical_force>()},
      {"lateral_force_track", "lateral force on the track", "Y", "N",
       "force on the wheel along y of the track, of pressure and friction; with profiles",
       Scale::force, Use::stored, at<&P::lateral_force_track>()},
      {"loaded_height", "height under load", "", "mm",
       "`height` of the place plus sinking under the load, z down; with profiles", Scale::none,
       Use::stored, at<&P::loaded_height>()},
  };
}

std::vector<Quantity> of_the_heat() {
  return {
      {"max_temperature", "largest temperature", "T", "degC",
       "largest temperature in contact, with `[wheel_heat]` or `[rail_heat]`", Scale::value,
       Use::stored, at<&P::max_temperature>()},
      {"max_temperature_x", "x of the largest temperature", "", "mm",
       "x of the element that has it", Scale::none, Use::stored, at<&P::max_temperature_x>(),
       NoBar::one_grid},
      {"max_temperature_y", "y of the largest temperature", "", "mm", "its y", Scale::none,
       Use::stored, at<&P::max_temperature_y>(), NoBar::one_grid},
      {"heat_wheel", "heat into the wheel", "", "N",
       "N mm per mm rolled into the wheel; negative where a cooler rail takes more than friction "
       "gives",
       Scale::value, Use::stored, at<&P::heat_wheel>()},
      {"heat_rail", "heat into the rail", "", "N", "the same of the rail", Scale::value,
       Use::stored, at<&P::heat_rail>()},
  };
}

std::vector<Quantity> of_the_passes() {
  return {
      {"plastic_strain", "accumulated plastic strain", "p", "-",
       "largest accumulated plastic strain after this pass", Scale::value, Use::stored,
       at<&P::plastic_strain>()},
      {"plastic_increment", "plastic strain of the pass", "", "-",
       "largest increase of the plastic strain p in this pass", Scale::value, Use::stored,
       at<&P::plastic_increment>()},
      {"net_plastic_increment", "lasting plastic strain of the pass", "", "-",
       "largest change of the plastic strain that lasts after the pass (equivalent strain): the "
       "rate of ratchetting",
       Scale::value, Use::stored, at<&P::net_plastic_increment>()},
      {"residual_stress", "largest residual compression", "", "MPa",
       "largest compressive residual stress along rolling below the running band; of pressed "
       "bodies below the middle of the contact",
       Scale::value, Use::stored, at<&P::residual_stress>()},
      {"groove_depth", "depth of the groove", "", "mm",
       "depth of the groove (imprint) left by plastic strain", Scale::value, Use::stored,
       at<&P::groove_depth>()},
      {"forward_flow", "forward flow", "", "mm",
       "largest displacement of the surface along rolling by plastic strain, positive along +x",
       Scale::value, Use::stored, at<&P::forward_flow>()},
      {"plastic_work", "plastic work", "", "N",
       "plastic work of the pass, both bodies, N mm per mm of track", Scale::value, Use::stored,
       at<&P::plastic_work>()},
  };
}

/// A cell of a Markdown table, in which a vertical bar must be escaped.
std::string cell(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '|' ? "\\|" : std::string(1, c);
  return out;
}

}  // namespace

const std::vector<Quantity>& quantities() {
  static const std::vector<Quantity> all = [] {
    std::vector<Quantity> list;
    for (const auto& part : {of_the_motion(), of_the_forces(), of_the_patch(), of_the_solution(),
                             of_the_heat(), of_the_passes()})
      list.insert(list.end(), part.begin(), part.end());
    return list;
  }();
  return all;
}

const std::vector<PointField>& point_fields() {
  using F = ContactFields&;
  static const std::vector<PointField> fields{
      {"pressure", "MPa", "contact pressure p_n", "positive in compression, 0 outside the patch",
       [](F f) -> Field& { return f.traction.n; }},
      {"traction_x", "MPa", "tangential traction p_x along rolling",
       "acts on the wheel in +x; negative for positive longitudinal creepage",
       [](F f) -> Field& { return f.traction.x; }},
      {"traction_y", "MPa", "tangential traction p_y across rolling", "acts on the wheel in +y",
       [](F f) -> Field& { return f.traction.y; }},
      {"traction_bound", "MPa", "traction bound g of |p_t|: mu p_n, or the theory's own",
       "never negative", [](F f) -> Field& { return f.traction_bound; }},
      {"slip_x", "-", "slip w_x per unit of rolling distance",
       "wheel surface relative to rail, positive in +x", [](F f) -> Field& { return f.slip.x; }},
      {"slip_y", "-", "slip w_y per unit of rolling distance",
       "wheel surface relative to rail, positive in +y", [](F f) -> Field& { return f.slip.y; }},
      {"gap", "mm", "h + u_n - approach: distance of the deformed surfaces, as solved",
       "positive where open, in the patch 0 within the tolerance, with either sign",
       [](F f) -> Field& { return f.gap; }},
      {"displacement_x", "mm", "tangential displacement difference u_x", "wheel minus rail",
       [](F f) -> Field& { return f.displacement.x; }},
      {"displacement_y", "mm", "tangential displacement difference u_y", "wheel minus rail",
       [](F f) -> Field& { return f.displacement.y; }},
      {"displacement_n", "mm", "normal displacement difference u_n",
       "wheel minus rail, positive when it opens the gap",
       [](F f) -> Field& { return f.displacement.n; }},
      {"work", "N/mm^2", "frictional work per area and distance rolled, local T-gamma/A",
       "its rows times dx are pass_work", [](F f) -> Field& { return f.work; }},
      {"temperature_wheel", "degC", "temperature of the wheel's surface",
       "in contact that of both surfaces", [](F f) -> Field& { return f.temperature_wheel; }},
      {"temperature_rail", "degC", "temperature of the rail's surface",
       "in contact that of both surfaces", [](F f) -> Field& { return f.temperature_rail; }},
  };
  return fields;
}

const Quantity* find_quantity(const std::string& name) {
  const auto& all = quantities();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Quantity& q) { return q.name == name; });
  return found == all.end() ? nullptr : &*found;
}

const Quantity& quantity_named(const std::string& name) {
  const Quantity* found = find_quantity(name);
  if (found == nullptr) throw std::logic_error("no quantity of that name: " + name);
  return *found;
}

const char* text_of(ErrorScale scale) {
  static const char* const texts[] = {"", "value", "mu", "mu F_z", "mu F_z sqrt(ab)", "mu p_0"};
  return texts[static_cast<int>(scale)];
}

void leave_empty(PointResult& point) {
  PointResult empty;
  for (const Quantity& quantity : quantities())
    if (!quantity.member.may_be_absent && quantity.member.kind == QuantityKind::number)
      quantity.member.set(empty, std::nan(""));
  for (const Quantity& motion : of_the_motion())
    motion.member.set(empty, motion.value(point).value());
  point = std::move(empty);
}

bool is_solved(const PointResult& point) {
  return point.converged || !std::isnan(point.normal_force);
}

double quantity(const PointResult& point, const std::string& name) {
  const std::optional<double> value = quantity_named(name).value(point);
  if (!value) throw std::logic_error("the load point has no " + name);
  return *value;
}

double full_sliding(const Quantity& quantity, const PointResult& point,
                    double friction_coefficient) {
  switch (quantity.scale) {
    case ErrorScale::none:
    case ErrorScale::value:
      return 0.0;
    case ErrorScale::friction:
      return friction_coefficient;
    case ErrorScale::force:
      return friction_coefficient * point.normal_force;
    case ErrorScale::moment:
      return friction_coefficient * point.normal_force *
             std::sqrt(point.semi_axis_x * point.semi_axis_y);
    case ErrorScale::traction:
      return friction_coefficient * point.max_pressure;
  }
  return 0.0;
}

double whole_of(const Quantity& quantity, const PointResult& point, double friction_coefficient) {
  if (quantity.scale == ErrorScale::none) return 0.0;
  if (quantity.of_friction()) return full_sliding(quantity, point, friction_coefficient);
  return std::abs(quantity.value(point).value_or(0.0));
}

std::string percent_text(ErrorScale scale, double part) {
  const std::string number = fmt::format("{:.2g} %", 100.0 * part);
  return scale > ErrorScale::value ? fmt::format("{} of {}", number, text_of(scale)) : number;
}

std::vector<std::string> accuracy_words() {
  std::vector<std::string> words;
  for (const Quantity& quantity : quantities())
    if (quantity.use == QuantityUse::accuracy) words.emplace_back(quantity.name);
  return words;
}

std::string quantities_markdown() {
  std::string text = "| key of a point | unit | meaning | percent of |\n|---|---|---|---|\n";
  for (const Quantity& q : quantities())
    text += fmt::format("| `{}` {} | {} | {} | {} |\n", q.name, cell(q.symbol), q.unit, q.meaning,
                        text_of(q.scale));
  return text;
}

}  // namespace rollfem::contact
