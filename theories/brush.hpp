// SPDX-License-Identifier: LGPL-2.1-or-later
// Kalker's simplified theory on strips along the rolling direction: the surface is a layer of
// brushes, u = L p, with friction bounded along each strip. FASTSIM and the strip model use it with
// different bounds (Kalker 1982, Vehicle System Dynamics 11, 1-13).
#pragma once

#include "halfspace/closed_forms/hertz.hpp"
#include "halfspace/closed_forms/kalker.hpp"
#include "result/result.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace rollfem::theories {

/// Flexibilities L of the brushes for each creepage, mm/MPa.
struct BrushFlexibilities {
  double longitudinal = 0.0;  ///< L1 = 8 a / (3 G C11)
  double lateral = 0.0;       ///< L2 = 8 a / (3 G C22)
  double spin = 0.0;          ///< L3 = pi a^2 / (4 G c C23), c = sqrt(a b)
};

/// Flexibilities for which an ellipse without slip has the forces F_x, F_y of the linear theory.
BrushFlexibilities kalker_flexibilities(double semi_axis_x, double semi_axis_y,
                                        double shear_modulus, double poisson_ratio);

/// One flexibility for all, weighted by the creepages:
/// L = (L1 |xi| + L2 |eta| + L3 |phi| c) / sqrt(xi^2 + eta^2 + phi^2 c^2).
BrushFlexibilities single_flexibility(const BrushFlexibilities& three,
                                      const contact::Creepage& creepage, double c);

/// Shape of the traction bound of brushes along a strip, t from -1 to 1 over its length.
enum class BoundShape {
  parabolic,  ///< 1 - t^2
  elliptic,   ///< sqrt(1 - t^2)
};

/// Strip theory of an elliptic patch (Haines and Ollerton 1963, Kalker 1967): every strip along
/// rolling is a line contact with both components of traction. In a strip of half length a the
/// traction on the wheel is, in adhesion,
///   m (k r, l r - P r) - m (k, l) r',  r = sqrt(a^2 - x^2),  r' = sqrt((a - d)^2 - (x - d)^2),
/// so that the slip vanishes there, and reaches the bound m r where adhesion ends, x = 2 d - a.
class StripTheory {
 public:
  struct Traction {
    double x = 0.0, y = 0.0;  ///< MPa
  };

  /// `bound` = mu p_0/a of the ellipse, MPa/mm, above 0. `creepage` is that of the strip at y. The
  /// slopes are scaled to the linear theory's C11, C22 and C23, so that F_x and F_y of small
  /// creepages are Kalker's (Sichani, Enblom and Berg 2016, Vehicle System Dynamics 54, 748-764).
  StripTheory(const halfspace::HertzContact& ellipse, const contact::CombinedMaterial& material,
              double bound, const contact::Creepage& creepage, double y);

  /// Whether the strip adheres at x; from the leading edge as far as 2 d - a.
  bool adheres(double x) const { return x > 2.0 * slip_ - half_length_; }
  /// Mean traction over an element of length `step` about x, where the strip adheres: with small
  /// creepages the traction grows without bound towards the trailing edge.
  Traction traction(double x, double step) const;

 private:
  double bound_;
  double half_length_;        ///< a, mm
  double slip_ = 0.0;         ///< d, half the length of the slip area, mm; infinite: no adhesion
  double across_ = 0.0;       ///< P
  double k_ = 0.0, l_ = 0.0;  ///< of the subtracted part
};

/// A line along x through the patch.
struct BrushStrip {
  double y = 0.0;            ///< mm
  double half_length = 0.0;  ///< mm, 0 outside of the patch
  double bound = 0.0;        ///< MPa, largest traction bound of the strip; may be infinite
  BoundShape shape = BoundShape::parabolic;
  double middle = 0.0;  ///< mm, x halfway between its ends; nonzero when the wheel is yawed
  /// Law by which the bound falls from that at rest with the rigid slip; null: it does not fall.
  const contact::FrictionLaw* law = nullptr;
  /// FaStrip: adhesion by this theory; brushes give the direction of the traction where it slips.
  std::optional<StripTheory> theory{};
  double bound_at(double x) const;
};

/// Strip of an ellipse whose bound is `bound` times the shape of the whole ellipse.
BrushStrip ellipse_strip(const halfspace::HertzContact& ellipse, double y, double bound,
                         BoundShape shape);

/// Elements of a strip in the order in which material passes them: the first at x_first, reached
/// from the leading edge after `first_step`, the others `step` apart.
struct StripElements {
  double x_first = 0.0;
  double first_step = 0.0;
  double step = 0.0;
  int count = 0;
  /// Steps upstream of an element at which the spin is taken: halfway adhesion is exact.
  double spin_at = 0.5;
};

/// `count` equal elements over the length of the strip. Adhesion is exact; where the direction of
/// slip turns, the tractions are first order, as in Kalker's algorithm.
StripElements chord_elements(const BrushStrip& strip, int count);

/// Tractions on the wheel (MPa) and slip at the elements of a strip.
struct StripTractions {
  StripElements elements;
  std::vector<double> traction_x, traction_y;
  std::vector<double> slip_x, slip_y;
  std::vector<contact::ElementState> state;
  double work = 0.0, power = 0.0;  ///< N per mm of width and mm rolled, as in BrushTotals
};

/// Follows the material through a strip whose rigid slip is (xi - phi y, eta + phi x).
/// With three flexibilities the slip is given in terms of L1 and L2.
StripTractions solve_strip(const BrushStrip& strip, const BrushFlexibilities& flexibilities,
                           const contact::Creepage& creepage, const StripElements& elements);

/// Creepages of the strip at y: those of the load point, with the extra rigid slip of the geometry.
contact::Creepage strip_creepage(const contact::ChartedGeometry& geometry,
                                 const contact::Creepage& creepage, double y);

/// Strips of a patch: the strip at y.
using StripAt = std::function<BrushStrip(double y)>;

/// A load point to be solved by brushes.
struct BrushProblem {
  const contact::ChartedGeometry& geometry;  ///< for the extra rigid slip
  contact::Creepage creepage;
  BrushFlexibilities flexibilities;
  int elements;  ///< per strip
};

/// Forces and areas of a patch, summed over strips.
struct BrushTotals {
  halfspace::CreepForces forces;
  double contact_area = 0.0;    ///< mm^2
  double adhesion_area = 0.0;   ///< mm^2
  double max_traction = 0.0;    ///< MPa
  double max_traction_x = 0.0;  ///< MPa
  /// N, of friction: tractions times the rigid slip that the brushes see, because the work of their
  /// own displacement vanishes from edge to edge. With three flexibilities the spin that they see
  /// differs from that of the bodies, which gives the power of the creep forces.
  double work = 0.0, power = 0.0;
  long elements = 0;
};

/// Adds a strip of the given width (mm).
void add_strip(const BrushStrip& strip, const StripTractions& tractions, double width,
               BrushTotals& totals);

/// A strip of the sum over a patch.
struct StripPlace {
  double y = 0.0;
  double width = 0.0;
};

/// `count` strips between y = -half_width and half_width, equally spaced in the angle t of y =
/// half_width sin t: sums of forces proportional to powers of the ellipse's length are fourth
/// order.
std::vector<StripPlace> strip_places(double half_width, int count);

/// Elements of a strip.
using ElementsOf = std::function<StripElements(const BrushStrip&)>;

/// Adds the strips at these places; without `elements_of` by chord_elements.
void add_strips(const BrushProblem& problem, const StripAt& strip_at,
                const std::vector<StripPlace>& places, BrushTotals& totals,
                const ElementsOf& elements_of = {});

/// Tractions, slip, state and (when finite) the bound of the strips of a load point on its contact
/// grid: every row of elements is a strip. Returns the work of the rows, N/mm.
contact::Field fill_brush_fields(const contact::ContactGrid& grid, const BrushProblem& problem,
                                 const StripAt& strip_at, contact::PointResult& point);

/// Forces, works, adhesion area (as a fraction of the contact area) and largest tractions of a load
/// point from the sum over strips. `rows`: work of the rows of the grid, which are scaled to it.
void set_totals(const BrushTotals& totals, const contact::ContactGrid& grid,
                const contact::Field& rows, contact::PointResult& point);

/// Error estimates of forces, moment and work of a load point, by a
/// method of the given order, with elements twice as large for `coarse`.
void estimate_error(const BrushTotals& totals, const BrushTotals& coarse, int order,
                    contact::PointResult& point);

}  // namespace rollfem::theories
