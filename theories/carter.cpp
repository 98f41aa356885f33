// SPDX-License-Identifier: LGPL-2.1-or-later
#include "theories/carter.hpp"

#include "base/pi.hpp"
#include "case/keys/key_builder.hpp"
#include "result/bars.hpp"
#include "result/quantities.hpp"
#include "theories/brush.hpp"
#include "theories/theory.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace rollfem::theories {

namespace {

using contact::pi;

double root_of_rest(double t) {
  return std::sqrt(std::max(0.0, (1.0 - t) * (1.0 + t)));
}

/// The strip of the ellipse at y as a line contact.
CarterContact strip_contact(const EllipticPatch& patch, double y) {
  const double root = root_of_rest(y / patch.hertz.semi_axis_y);
  return {patch.hertz.semi_axis_x * root, patch.hertz.max_pressure * root, patch.friction,
          patch.material.contact_modulus};
}

/// The strip at y, rolling at its local creepage.
CarterSolution strip_solution(const EllipticPatch& patch, const contact::Creepage& creepage,
                              double y) {
  return {strip_contact(patch, y), strip_creepage(patch.geometry, creepage, y).longitudinal};
}

/// Number of strips of an ellipse; a line contact is one strip.
std::vector<StripPlace> carter_strips_of(const EllipticPatch& patch, int strips) {
  if (patch.geometry.geometry().line) return {{0.0, 2.0 * patch.hertz.semi_axis_y}};
  return strip_places(patch.hertz.semi_axis_y, strips);
}

BrushTotals sum_carter_strips(const EllipticPatch& patch, const contact::Creepage& creepage,
                              int strips) {
  BrushTotals totals;
  for (const auto& [y, width] : carter_strips_of(patch, strips)) {
    const CarterSolution strip = strip_solution(patch, creepage, y);
    totals.forces.longitudinal += width * strip.force();
    totals.forces.spin_moment -= width * y * strip.force();
    totals.work += width * strip.work();
    totals.max_traction = std::max(totals.max_traction, strip.largest_traction());
    totals.adhesion_area += 2.0 * width * strip.stick_half_width();
    totals.contact_area += 2.0 * width * strip_contact(patch, y).half_width;
  }
  totals.max_traction_x = totals.max_traction;
  totals.power = totals.work;
  return totals;
}

/// Returns the work of the rows, N/mm.
contact::Field fill_fields(const EllipticPatch& patch, contact::PointResult& point) {
  const contact::ContactGrid& grid = patch.grid;
  contact::ContactFields& fields = point.fields;
  contact::Field work(grid.ny);
  for (int j = 0; j < grid.ny; ++j) {
    const CarterSolution strip = strip_solution(patch, point.creepage, grid.y(j));
    work[j] = strip.work();
    for (int i = 0; i < grid.nx; ++i) {
      const int k = grid.index(i, j);
      if (fields.state[k] == contact::ElementState::exterior) continue;
      const double x = grid.x(i);
      fields.traction.x[k] = strip.traction(x);
      fields.slip.x[k] = strip.slip(x);
      if (std::abs(x - strip.stick_middle()) > strip.stick_half_width())
        fields.state[k] = contact::ElementState::slip;
    }
  }
  return work;
}

/// Values that depend on no grid or number of strips.
void note_closed_form(const contact::Scene& scene, contact::PointResult& point) {
  for (const contact::Quantity& quantity : contact::quantities())
    if (quantity.of_friction() || quantity.name == std::string("adhesion_area"))
      point.no_bar.emplace(
          quantity.name, scene.material.couples() ? contact::NoBar::theory : contact::NoBar::exact);
}

}  // namespace

double CarterContact::force_per_length() const {
  return 0.5 * pi * half_width * max_pressure;
}

double CarterContact::saturation_creepage() const {
  return 2.0 * friction * max_pressure / contact_modulus;
}

CarterSolution::CarterSolution(const CarterContact& contact, double creepage)
    : contact_(contact), creepage_(creepage), stick_(contact.half_width) {
  if (creepage == 0.0) return;
  const double saturation = contact.saturation_creepage();
  const double slipped = saturation > 0.0 ? std::abs(creepage) / saturation : 1.0;
  stick_ = contact.half_width * std::max(0.0, 1.0 - slipped);
}

double CarterSolution::force() const {
  if (contact_.half_width == 0.0) return 0.0;
  const double ratio = stick_ / contact_.half_width;
  return -std::copysign((1.0 - ratio) * (1.0 + ratio), creepage_) * contact_.friction *
         contact_.force_per_length();
}

double CarterSolution::traction(double x) const {
  const double a = contact_.half_width;
  if (creepage_ == 0.0 || std::abs(x) >= a) return 0.0;
  double value = root_of_rest(x / a);
  if (stick_ > 0.0) value -= stick_ / a * root_of_rest((x - stick_middle()) / stick_);
  return -std::copysign(contact_.friction * contact_.max_pressure * value, creepage_);
}

/// In adhesion the traction falls monotonically towards the leading edge, with infinite slope at
/// first.
double CarterSolution::largest_traction() const {
  return std::abs(traction(std::min(0.0, stick_middle() - stick_)));
}

/// |w| over the saturation creepage. Under the traction sqrt(1 - t^2) the slope of the displacement
/// is proportional to t inside and to t + sqrt(t^2 - 1) behind (Johnson 1985, eq. 8.11).
double CarterSolution::unit_slip(double x) const {
  const double a = contact_.half_width;
  const double t = (x - stick_middle()) / stick_;
  return t > -1.0 ? 0.0 : stick_ / a * std::sqrt((t - 1.0) * (t + 1.0));
}

double CarterSolution::slip(double x) const {
  const double saturation = contact_.saturation_creepage();
  if (stick_ > 0.0) return std::copysign(saturation * unit_slip(x), creepage_);
  if (creepage_ == 0.0 || contact_.half_width == 0.0) return 0.0;
  // Full slip: the rigid slip less the slope of the displacement under mu p.
  return creepage_ - std::copysign(saturation, creepage_) * x / contact_.half_width;
}

contact::ModelResult run_carter(const contact::Scene& scene, const contact::Progress& progress) {
  const int strips = scene.options.of<CarterOptions>().strips;
  const EllipticPatch patch = elliptic_patch(scene);
  const auto fill = [&](contact::PointResult& point) {
    const contact::Field rows = fill_fields(patch, point);
    const BrushTotals totals = sum_carter_strips(patch, point.creepage, strips);
    set_totals(totals, patch.grid, rows, point);
    if (scene.geometry.line)
      note_closed_form(scene, point);
    else
      estimate_error(totals, sum_carter_strips(patch, point.creepage, (strips + 1) / 2), 2, point);
  };
  contact::ModelResult result =
      run_theory(scene, patch.grid, patch.normal, "carter", progress, fill);
  result.notes.push_back(
      {"bars", scene.geometry.line
                   ? "Carter's closed form of line contact: exact for like materials"
                   : "Carter by strips: error estimates cover the resolution only; the "
                     "theory is for patches much wider than long"});
  return result;
}

namespace {

void add_carter_keys() {
  using contact::between;
  contact::Keys<CarterOptions> keys("carter", "Model `carter`");
  keys.add("strips", &CarterOptions::strips, between(8, 2000), "Strips across the patch.");
  keys.section().position = 3;
  contact::add_section(keys);
}

}  // namespace

contact::ModelInfo carter_model() {
  using contact::Demand;
  contact::ModelInfo model = theory(
      "carter", "Carter", "strips of an ellipse along rolling, each a line contact",
      {Demand::line_contact, Demand::extra_slip}, with_pass_work(run_carter), strips_on_ellipse);
  model.add_keys = add_carter_keys;
  model.refinements = {refined_strips<CarterOptions, &CarterOptions::strips>()};
  return model;
}

}  // namespace rollfem::theories
