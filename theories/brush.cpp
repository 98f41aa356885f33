// SPDX-License-Identifier: LGPL-2.1-or-later
#include "theories/brush.hpp"

#include "base/pi.hpp"
#include "result/derived.hpp"
#include "scene/geometry.hpp"
#include "theories/elliptic_patch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rollfem::theories {

namespace {

using contact::pi;

/// Tractions between the elements of a strip. They vanish at the leading edge, and with a finite
/// bound at the trailing edge.
struct StripSample {
  double traction_x, traction_y;
  int nearest;
};

StripSample sample(const StripTractions& strip, const BrushStrip& place, double x) {
  const StripElements& elements = strip.elements;
  const double position = (elements.x_first - x) / elements.step;
  const int last = elements.count - 1;
  const int nearest = std::clamp(static_cast<int>(std::lround(position)), 0, last);
  if (position <= 0.0 || position >= last) {
    const int edge = position <= 0.0 ? 0 : last;
    const bool vanishing = edge == 0 || std::isfinite(place.bound);
    const double weight =
        vanishing ? (place.half_length - std::abs(x - place.middle)) / (0.5 * elements.step) : 1.0;
    return {weight * strip.traction_x[edge], weight * strip.traction_y[edge], nearest};
  }
  const int k = static_cast<int>(position);
  const double weight = position - k;
  const auto between = [&](const std::vector<double>& v) {
    return (1.0 - weight) * v[k] + weight * v[k + 1];
  };
  return {between(strip.traction_x), between(strip.traction_y), nearest};
}

/// Fields of a row of the contact grid.
void fill_row(const contact::ContactGrid& grid, int j, const BrushStrip& strip,
              const StripTractions& tractions, contact::ContactFields& fields) {
  for (int i = 0; i < grid.nx; ++i) {
    const double x = grid.x(i);
    const int k = grid.index(i, j);
    if (std::abs(x - strip.middle) >= strip.half_length) continue;
    const StripSample at = sample(tractions, strip, x);
    fields.traction.x[k] = at.traction_x;
    fields.traction.y[k] = at.traction_y;
    fields.slip.x[k] = tractions.slip_x[at.nearest];
    fields.slip.y[k] = tractions.slip_y[at.nearest];
    fields.state[k] = tractions.state[at.nearest];
    if (std::isfinite(strip.bound)) fields.traction_bound[k] = strip.bound_at(x);
    if (strip.law != nullptr && fields.state[k] == contact::ElementState::slip)
      fields.traction_bound[k] = std::hypot(at.traction_x, at.traction_y);
  }
}

}  // namespace

BrushFlexibilities kalker_flexibilities(double semi_axis_x, double semi_axis_y,
                                        double shear_modulus, double poisson_ratio) {
  const halfspace::KalkerCoefficients k =
      halfspace::kalker_coefficients(semi_axis_x, semi_axis_y, poisson_ratio);
  const double a = semi_axis_x;
  const double c = std::sqrt(semi_axis_x * semi_axis_y);
  return {8.0 * a / (3.0 * shear_modulus * k.c11), 8.0 * a / (3.0 * shear_modulus * k.c22),
          pi * a * a / (4.0 * shear_modulus * c * k.c23)};
}

BrushFlexibilities single_flexibility(const BrushFlexibilities& three,
                                      const contact::Creepage& creepage, double c) {
  const double xi = std::abs(creepage.longitudinal);
  const double eta = std::abs(creepage.lateral);
  const double phi = std::abs(creepage.spin) * c;
  const double size = std::hypot(xi, eta, phi);
  const double single =
      size > 0.0 ? (three.longitudinal * xi + three.lateral * eta + three.spin * phi) / size
                 : three.longitudinal;
  return {single, single, single};
}

double BrushStrip::bound_at(double x) const {
  const double t = (x - middle) / half_length;
  const double remainder = std::max(0.0, (1.0 - t) * (1.0 + t));
  return bound * (shape == BoundShape::parabolic ? remainder : std::sqrt(remainder));
}

BrushStrip ellipse_strip(const halfspace::HertzContact& ellipse, double y, double bound,
                         BoundShape shape) {
  const double t = y / ellipse.semi_axis_y;
  const double remainder = std::max(0.0, (1.0 - t) * (1.0 + t));
  const double root = std::sqrt(remainder);
  const double factor = shape == BoundShape::parabolic ? remainder : root;
  return {y, ellipse.semi_axis_x * root, factor > 0.0 ? bound * factor : 0.0, shape, 0.0};
}

StripTheory::StripTheory(const halfspace::HertzContact& ellipse,
                         const contact::CombinedMaterial& material, double bound,
                         const contact::Creepage& creepage, double y)
    : bound_(bound) {
  const double a = ellipse.semi_axis_x;
  const double b = ellipse.semi_axis_y;
  const double nu = material.poisson_ratio;
  const halfspace::KalkerCoefficients kalker = halfspace::kalker_coefficients(a, b, nu);
  half_length_ = a * std::sqrt(std::max(0.0, (1.0 - y / b) * (1.0 + y / b)));
  const double scale = material.shear_modulus / bound;
  // Strip theory by itself has C11 = pi^2/(4 (1 - nu)), C22 = pi^2/4, C23 = pi/3 sqrt(a/b).
  const double spin = 1.5 / pi * kalker.c23 * std::sqrt(b / a) * creepage.spin * scale;
  const double x =
      2.0 / (pi * pi) * kalker.c11 * creepage.longitudinal * scale - spin * y / (1.0 - nu);
  const double e = 2.0 / (pi * pi) * kalker.c22 * creepage.lateral * scale;
  across_ = spin;
  if (x == 0.0 && e == 0.0) {  // nothing moves but the spin, which the strip bears up to its bound
    if (std::abs(spin) >= 1.0) slip_ = std::numeric_limits<double>::infinity();
    return;
  }
  // k d = -x, l d = -e, and k^2 + (l - P)^2 = 1 at the end of adhesion.
  const double root = e * e + x * x * (1.0 - spin * spin);
  const double divisor = std::sqrt(std::max(0.0, root)) - e * spin;
  slip_ = root >= 0.0 && divisor > 0.0 ? (x * x + e * e) / divisor
                                       : std::numeric_limits<double>::infinity();
  if (slip_ >= half_length_) slip_ = std::numeric_limits<double>::infinity();
  k_ = -x / slip_;
  l_ = -e / slip_;
}

namespace {

/// Mean of sqrt(radius^2 - t^2) over t from `first` to `last`, 0 beyond the radius.
double mean_root(double radius, double first, double last) {
  const auto integral = [radius](double t) {
    const double u = std::clamp(t, -radius, radius);
    return 0.5 * (u * std::sqrt(radius * radius - u * u) + radius * radius * std::asin(u / radius));
  };
  return (integral(last) - integral(first)) / (last - first);
}

}  // namespace

StripTheory::Traction StripTheory::traction(double x, double step) const {
  const double first = x - 0.5 * step;
  const double last = x + 0.5 * step;
  const double whole = mean_root(half_length_, first, last);
  const double rest = whole - mean_root(half_length_ - slip_, first - slip_, last - slip_);
  return {bound_ * k_ * rest, bound_ * (l_ * rest - across_ * whole)};
}

StripElements chord_elements(const BrushStrip& strip, int count) {
  const double step = 2.0 * strip.half_length / count;
  return {strip.middle + strip.half_length - 0.5 * step, 0.5 * step, step, count};
}

namespace {

/// Fraction of the bound at rest that falling friction leaves, as the material goes through a
/// strip. Its slip velocity is that of the rigid slip: with the slip of the brushes themselves the
/// problem would have no solution that stays as elements are refined, for brushes do not feel each
/// other.
class FallingBound {
 public:
  explicit FallingBound(const contact::FrictionLaw* law)
      : law_(law), rest_(law ? law->coefficient() : 1.0), coefficient_(rest_) {}

  /// mu over that at rest at the end of a step.
  double part_left(double slip, double step) {
    if (law_ == nullptr) return 1.0;
    const double there = law_->at(slip).value;
    const auto memory = law_->memory();
    const double left =
        memory ? std::exp(-step * std::max(slip, memory->least_slip) / memory->distance) : 0.0;
    coefficient_ = there + left * (coefficient_ - there);
    return coefficient_ / rest_;
  }

 private:
  const contact::FrictionLaw* law_;
  double rest_, coefficient_;
};

/// FaStrip: tractions of strip theory where it adheres, those of brushes brought to the bound where
/// it does not. Strip theory lets every strip adhere at its leading edge, where spin alone reaches
/// the bound if |P| >= 1. Against lateral creepage its traction then is above the bound from there
/// until both balance: this part slips, too.
void take_adhesion(const BrushStrip& strip, StripTractions& brushes) {
  const StripElements& elements = brushes.elements;
  for (int k = 0; k < elements.count; ++k) {
    const double x = elements.x_first - k * elements.step;
    double& px = brushes.traction_x[k];
    double& py = brushes.traction_y[k];
    bool adheres = strip.theory->adheres(x);
    StripTheory::Traction traction;
    if (adheres) traction = strip.theory->traction(x, elements.step);
    adheres = adheres && std::hypot(traction.x, traction.y) <= strip.bound_at(x);
    brushes.state[k] = adheres ? contact::ElementState::adhesion : contact::ElementState::slip;
    if (adheres) {
      px = traction.x;
      py = traction.y;
      brushes.slip_x[k] = brushes.slip_y[k] = 0.0;
    } else if (const double size = std::hypot(px, py); size > 0.0) {
      px *= strip.bound_at(x) / size;
      py *= strip.bound_at(x) / size;
    }
  }
}

void set_works(double y, const BrushFlexibilities& flexible, const contact::Creepage& creepage,
               StripTractions& strip) {
  const double along = flexible.longitudinal / flexible.spin;
  const double across = flexible.lateral / flexible.spin;
  const StripElements& elements = strip.elements;
  for (int k = 0; k < elements.count; ++k) {
    const double x = elements.x_first - k * elements.step;
    const double fx = elements.step * strip.traction_x[k], fy = elements.step * strip.traction_y[k];
    const double rolling = fx * creepage.longitudinal + fy * creepage.lateral;
    strip.work -= rolling + creepage.spin * (across * x * fy - along * y * fx);
    strip.power -= rolling + creepage.spin * (x * fy - y * fx);
  }
}

}  // namespace

StripTractions solve_strip(const BrushStrip& strip, const BrushFlexibilities& flexibilities,
                           const contact::Creepage& creepage, const StripElements& elements) {
  const BrushFlexibilities& flexible = flexibilities;
  const double rate_x =
      creepage.longitudinal / flexible.longitudinal - creepage.spin * strip.y / flexible.spin;
  StripTractions result;
  result.elements = elements;
  for (auto* values : {&result.traction_x, &result.traction_y, &result.slip_x, &result.slip_y})
    values->assign(elements.count, 0.0);
  result.state.assign(elements.count, contact::ElementState::adhesion);
  double px = 0.0;
  double py = 0.0;
  FallingBound falling(strip.law);
  for (int k = 0; k < elements.count; ++k) {
    const double step = k == 0 ? elements.first_step : elements.step;
    const double x = elements.x_first - k * elements.step;
    const double rate_y = creepage.lateral / flexible.lateral +
                          creepage.spin * (x + elements.spin_at * step) / flexible.spin;
    px -= rate_x * step;
    py -= rate_y * step;
    const double size = std::hypot(px, py);
    const double rigid = std::hypot(creepage.longitudinal - creepage.spin * strip.y,
                                    creepage.lateral + creepage.spin * x);
    const double bound = strip.bound_at(x) * falling.part_left(rigid, step);
    if (size > bound) {
      const double factor = bound / size;
      result.slip_x[k] = -flexible.longitudinal * (1.0 - factor) * px / step;
      result.slip_y[k] = -flexible.lateral * (1.0 - factor) * py / step;
      result.state[k] = contact::ElementState::slip;
      px *= factor;
      py *= factor;
    }
    result.traction_x[k] = px;
    result.traction_y[k] = py;
  }
  if (strip.theory) take_adhesion(strip, result);
  set_works(strip.y, flexible, creepage, result);
  return result;
}

contact::Creepage strip_creepage(const contact::ChartedGeometry& geometry,
                                 const contact::Creepage& creepage, double y) {
  const contact::Creepage without_spin{creepage.longitudinal, creepage.lateral, 0.0};
  const contact::TangentialField slip =
      geometry.rigid_slip(without_spin, contact::ContactGrid{1, 1, 1.0, 1.0, 0.0, y});
  return {slip.x[0], slip.y[0], creepage.spin};
}

std::vector<StripPlace> strip_places(double half_width, int count) {
  const double angle = pi / count;
  std::vector<StripPlace> places;
  for (int j = 0; j < count; ++j) {
    const double t = -0.5 * pi + (j + 0.5) * angle;
    places.push_back({half_width * std::sin(t), half_width * std::cos(t) * angle});
  }
  return places;
}

void add_strip(const BrushStrip& strip, const StripTractions& tractions, double width,
               BrushTotals& totals) {
  const StripElements& elements = tractions.elements;
  const double area = elements.step * width;
  for (int k = 0; k < elements.count; ++k) {
    const double x = elements.x_first - k * elements.step;
    const double px = tractions.traction_x[k];
    const double py = tractions.traction_y[k];
    totals.forces.longitudinal += area * px;
    totals.forces.lateral += area * py;
    totals.forces.spin_moment += area * (x * py - strip.y * px);
    if (tractions.state[k] == contact::ElementState::adhesion) totals.adhesion_area += area;
    totals.max_traction = std::max(totals.max_traction, std::hypot(px, py));
    totals.max_traction_x = std::max(totals.max_traction_x, std::abs(px));
  }
  totals.work += width * tractions.work;
  totals.power += width * tractions.power;
  totals.contact_area += area * elements.count;
  totals.elements += elements.count;
}

namespace {

StripTractions solve_strip(const BrushProblem& problem, const BrushStrip& strip,
                           const StripElements& elements) {
  return solve_strip(strip, problem.flexibilities,
                     strip_creepage(problem.geometry, problem.creepage, strip.y), elements);
}

}  // namespace

void add_strips(const BrushProblem& problem, const StripAt& strip_at,
                const std::vector<StripPlace>& places, BrushTotals& totals,
                const ElementsOf& elements_of) {
  for (const auto& [y, width] : places) {
    const BrushStrip strip = strip_at(y);
    if (strip.half_length <= 0.0) continue;
    const StripElements elements =
        elements_of ? elements_of(strip) : chord_elements(strip, problem.elements);
    add_strip(strip, solve_strip(problem, strip, elements), width, totals);
  }
}

contact::Field fill_brush_fields(const contact::ContactGrid& grid, const BrushProblem& problem,
                                 const StripAt& strip_at, contact::PointResult& point) {
  contact::Field work = contact::Field::Zero(grid.ny);
  for (int j = 0; j < grid.ny; ++j) {
    const BrushStrip strip = strip_at(grid.y(j));
    if (strip.half_length <= 0.0) continue;
    const StripTractions tractions =
        solve_strip(problem, strip, chord_elements(strip, problem.elements));
    fill_row(grid, j, strip, tractions, point.fields);
    work[j] = tractions.work;
  }
  return work;
}

void set_totals(const BrushTotals& totals, const contact::ContactGrid& grid,
                const contact::Field& rows, contact::PointResult& point) {
  set_forces(totals.forces, point);
  point.frictional_work = std::max(totals.work, 0.0);
  point.creepage_work = totals.power + 0.0;
  contact::Field work = rows.cwiseMax(0.0);
  if (work.sum() > 0.0) work *= *point.frictional_work / (grid.dy * work.sum());
  contact::set_pass_work(grid, work, point);
  if (totals.contact_area > 0.0)
    point.adhesion_area = point.contact_area * totals.adhesion_area / totals.contact_area;
  point.max_traction = totals.max_traction;
  point.max_traction_x = totals.max_traction_x;
}

void estimate_error(const BrushTotals& totals, const BrushTotals& coarse, int order,
                    contact::PointResult& point) {
  const double divisor = (1 << order) - 1;
  const auto estimate = [&](const char* name, double halfspace::CreepForces::*member) {
    point.error_estimate[name] = std::abs(totals.forces.*member - coarse.forces.*member) / divisor;
  };
  estimate("longitudinal_force", &halfspace::CreepForces::longitudinal);
  estimate("lateral_force", &halfspace::CreepForces::lateral);
  estimate("spin_moment", &halfspace::CreepForces::spin_moment);
  point.error_estimate["frictional_work"] = std::abs(totals.work - coarse.work) / divisor;
  // Quantities that end at a boundary within an element keep the full change.
  const auto uneven = [&](const char* name, double BrushTotals::*member, double scale) {
    point.error_estimate[name] = scale * std::abs(totals.*member - coarse.*member);
  };
  uneven("max_traction", &BrushTotals::max_traction, 1.0);
  uneven("max_traction_x", &BrushTotals::max_traction_x, 1.0);
  if (totals.contact_area > 0.0)
    uneven("adhesion_area", &BrushTotals::adhesion_area, point.contact_area / totals.contact_area);
  if (point.normal_force > 0.0)
    point.error_estimate["traction_coefficient"] =
        point.error_estimate["longitudinal_force"] / point.normal_force;
}

}  // namespace rollfem::theories
