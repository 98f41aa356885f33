// SPDX-License-Identifier: LGPL-2.1-or-later
// Frequency response of transient creep (Knothe and Gross-Thebing 1986): line contact, full
// adhesion, creepage xi e^(i w t); its closed form and its verdict are the book's. Displacements
// are relative to those at the distance `reference`.
#include "contact/solve/contact_problem.hpp"
#include "contact/solve/point_motion.hpp"
#include "halfspace/elasticity/halfspace_compliance.hpp"
#include "scene/geometry.hpp"

#include "support/recorded.hpp"
#include "support/thesis_cases.hpp"
#include <complex>

namespace {

constexpr double semi_axis = 1.0;   // mm
constexpr double reference = 20.0;  // mm
constexpr double shear_modulus = 82000.0, poisson_ratio = 0.28;

/// F/F_0 of steps of one element over waves of the creepage, when the start is forgotten.
std::complex<double> rolled(double ka, int across) {
  const double cell = 2.0 * semi_axis / across;
  ContactGrid grid = ContactGrid::centred(across + 8, 1, cell, 1.0);
  grid.line_reference = reference;
  const halfspace::HalfspaceCompliance compliance(grid, alike(shear_modulus, poisson_ratio));
  contact::ContactConditions conditions;
  conditions.given_pressure = grid.sample([](double x, double) {
    return std::sqrt(std::max(0.0, 1.0 - x * x / (semi_axis * semi_axis)));
  });
  conditions.friction = contact::coulomb(1000.0);
  contact::ContactProblem problem(compliance, compliance, conditions);
  contact::History history(grid, contact::UpwindOrder::second);
  const double xi = 1e-5;
  const double wave = ka / semi_axis;
  // After 40 lengths of the patch what is left of the start is below 1e-4; then three waves.
  const int settled = static_cast<int>(std::ceil(40.0 * semi_axis / cell));
  const int period = static_cast<int>(std::round(2.0 * M_PI / wave / cell));
  const double step = 2.0 * M_PI / wave / period;
  std::complex<double> sum = 0.0;
  contact::ContactState state;
  const int last = settled + period;
  for (int k = 1; k <= last; ++k) {
    const double now = wave * step * k;
    const TangentialField slip{Field::Constant(grid.size(), xi * std::cos(now)),
                               Field::Zero(grid.size())};
    const contact::TangentialMotion each = history.rolling_step(slip, step);
    state = problem.solve({1.0, {}}, {each.rigid_slip, contact::Motion::shift, each.slip_factor},
                          k > 1 ? &state : nullptr, {1e-9, {1e-9, 50, 5}});
    history.advance({state.displacement.x, state.displacement.y}, step);
    if (k <= last - period) continue;
    const double force = -state.tangential.traction.x.sum() * cell;
    sum += 2.0 / period * force * std::exp(std::complex<double>(0.0, -now));
  }
  const double first = xi * semi_axis * M_PI * shear_modulus / (2.0 * (1.0 - poisson_ratio));
  return sum / first;
}

}  // namespace

TEST(CreepFrequency, OfLineContactIsTheClosedForm) {
  for (const double ka : {0.1, 0.3, 1.0, 2.0, 4.0}) {
    SCOPED_TRACE(ka);
    const std::complex<double> coarse = rolled(ka, 40), fine = rolled(ka, 80);
    const std::string at = "_" + fmt::format("{:g}", ka);
    record("amplitude" + at, std::abs(fine));
    record("phase" + at, std::arg(fine));
    record("coarse_amplitude" + at, std::abs(coarse));
    record("coarse_phase" + at, std::arg(coarse));
  }
}
