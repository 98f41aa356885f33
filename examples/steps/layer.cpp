// SPDX-License-Identifier: LGPL-2.1-or-later
// Step 3: an elasticity of one's own. A rigid ball presses on an elastic layer bonded to a rigid
// base. The layer is a Compliance, by its Fourier transform; the half-space only preconditions it.
#include "case/reading/case_reader.hpp"
#include "contact/solve/contact_run.hpp"
#include "halfspace/elasticity/fft.hpp"
#include "halfspace/elasticity/preconditioned_elasticity.hpp"
#include "halfspace/patch/patch_search.hpp"

#include <cmath>
#include <cstdio>

using namespace rollfem;

constexpr double young = 210e3, nu = 0.3, radius = 500.0;  // as in the case below

/// Under pressure cos(k x) the surface moves by 2 (1 - nu^2)/(E k) f(k h) cos(k x), where
/// f(q) = ((3 - 4 nu) sinh 2q - 2q) / ((3 - 4 nu) cosh 2q + 2 q^2 + 5 - 12 nu + 8 nu^2)
/// (bonded layer; Johnson 1985, section 5.8). Long waves see springs side by side, h/M.
class Layer : public contact::Compliance {
 public:
  Layer(const contact::ContactGrid& grid, double thickness)
      : grid_(grid),
        fft_(grid.nx, grid.ny, 2 * grid.nx, 2 * grid.ny),
        symbol_(fft_.spectrum_size()) {
    for (int kx = 0; kx < fft_.frequencies_x(); ++kx)
      for (int ky = 0; ky < fft_.py(); ++ky) {
        const double wave_x = 2.0 * M_PI * kx / (fft_.px() * grid.dx);
        const double wave_y = 2.0 * M_PI * std::min(ky, fft_.py() - ky) / (fft_.py() * grid.dy);
        const double q = std::clamp(std::hypot(wave_x, wave_y) * thickness, 1e-6, 100.0);
        const double rises = (3.0 - 4.0 * nu) * std::sinh(2.0 * q) - 2.0 * q;
        const double base = 2.0 * q * q + 5.0 - 12.0 * nu + 8.0 * nu * nu;
        symbol_[kx * fft_.py() + ky] = 2.0 * (1.0 - nu * nu) * thickness / (young * q) * rises /
                                       ((3.0 - 4.0 * nu) * std::cosh(2.0 * q) + base);
      }
  }
  const contact::ContactGrid& grid() const override { return grid_; }
  contact::SurfaceField apply(const contact::SurfaceField& traction) const override {
    halfspace::PaddedFft::Spectrum spectrum(symbol_.size());
    fft_.forward(traction.n, spectrum);
    for (std::size_t i = 0; i < symbol_.size(); ++i) spectrum[i] *= symbol_[i];
    contact::SurfaceField moved = traction;  // the layer has no tangential part here
    fft_.backward(spectrum, moved.n);
    return moved;
  }

 private:
  contact::ContactGrid grid_;
  halfspace::PaddedFft fft_;
  std::vector<double> symbol_;
};

int main() {
  const contact::Scene scene(contact::parse_case(R"(
    load.normal_force = 50e3
    friction.coefficient = 0.0
    wheel = {rolling_radius = 500.0, transverse_radius = 500.0, young_modulus = inf}
    rail.transverse_radius = inf
  )",
                                                 "step 3"));
  const contact::ChartedGeometry geometry = halfspace::halfspace_geometry(scene);
  const double modulus = young * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu));
  std::printf("thickness mm   p_0 MPa   of springs side by side\n");
  double p0 = 0.0, springs = 1.0;
  for (const double thickness : {4.0, 2.0, 1.0, 0.5}) {
    springs = std::sqrt(50e3 * modulus / (M_PI * radius * thickness));
    const double a = std::sqrt(2.0 * radius * springs * thickness / modulus);
    const contact::ContactGrid grid = contact::ContactGrid::centred(96, 96, a / 40.0, a / 40.0);
    const contact::Progress silent;
    contact::ContactRun run(scene, geometry, {}, silent, nullptr);
    const auto make = [&] {
      return std::make_unique<halfspace::PreconditionedElasticity>(
          scene, grid, std::make_unique<Layer>(grid, thickness));
    };
    if (!run.solve(grid, make)) return 1;  // the patch reaches the border of the grid
    p0 = run.take_result().points.front().max_pressure;
    std::printf("%12.2f   %7.1f   %7.1f\n", thickness, p0, springs);
  }
  return std::abs(p0 / springs - 1.0) < 0.04 ? 0 : 1;
}
