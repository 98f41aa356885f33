// SPDX-License-Identifier: LGPL-2.1-or-later
// Displacement and stress below the contact grid, in the wheel or in the rail, from the tractions
// of a solved (or given) contact: at points, on lines, on planes of constant depth and in boxes.
//
// Output is in the global frame (x rolling, y lateral, z into the wheel) for both bodies: the wheel
// is z = +depth, the rail z = -depth. Tractions are those on the wheel, as everywhere else; the
// opposite ones act on the rail. Only the constants of the body itself matter: nu in the stress, nu
// and G in the displacement, which is that of the half-space, zero at infinity. In a line contact
// nothing depends on y, and displacements are relative as on the surface
// (ContactGrid::line_reference).
#pragma once

#include "base/grid.hpp"
#include "case/case.hpp"
#include "result/result.hpp"
#include "result/stress_measures.hpp"

#include <array>
#include <vector>

namespace rollfem::halfspace {

enum class Body {
  wheel,  ///< body 1, material at z > 0
  rail,   ///< body 2, material at z < 0
};

/// One body and the tractions of the contact.
struct LoadedBody {
  Body body = Body::wheel;
  contact::Material material;  ///< of this body
  contact::ContactGrid grid;
  contact::SurfaceField traction;  ///< MPa, on the wheel; n is the pressure. x, y may be empty: 0
};

struct SubsurfacePoint {
  double x = 0.0;      ///< mm
  double y = 0.0;      ///< mm
  double depth = 0.0;  ///< mm, >= 0 below the surface of the body
};

/// Global frame.
struct SubsurfaceState {
  std::array<double, 3> displacement{};  ///< mm
  contact::SymmetricTensor stress{};     ///< MPa, tension positive
};

/// The states of one depth, one per point of a lattice, index j * nx + i.
struct SubsurfaceLayer {
  double depth = 0.0;
  std::vector<SubsurfaceState> states;
};

/// Method of summation over contact elements.
enum class Summation {
  automatic,  ///< the cheaper possible method
  direct,     ///< every point with every loaded element
  fft,        ///< convolution by layers: only for points at the spacing of the contact grid
};

/// State at any points. For points on the surface under the edge of an element see
/// corner_potentials. Throws contact::InputError for negative depths, fields of the wrong size,
/// impossible constants.
std::vector<SubsurfaceState> subsurface_at(const LoadedBody& body,
                                           const std::vector<SubsurfacePoint>& points);

/// The same, but on the surface the mean of the stress at the middles of the four elements around a
/// point: there the steps of the tractions make the stress along the surface infinite at the edges
/// of elements.
std::vector<SubsurfaceState> smooth_subsurface_at(const LoadedBody& body,
                                                  const std::vector<SubsurfacePoint>& points);

/// State on the points of a lattice (the element centres of a ContactGrid) at several depths: a
/// box; a lattice with nx or ny = 1 is a vertical section. For FFT summation the lattice needs dx
/// and dy of the contact grid, but may be shifted, larger or smaller.
std::vector<SubsurfaceLayer> subsurface_box(const LoadedBody& body,
                                            const contact::ContactGrid& points,
                                            const std::vector<double>& depths,
                                            Summation summation = Summation::automatic);

// Stresses of half-spaces at the [[subsurface.*]] points of a case.

/// Points of a request, mm in the global frame, the first side fastest; lines that follow the
/// surface are on the plane z = 0 or at the requested depth below it.
std::vector<std::array<double, 3>> subsurface_points(const contact::SubsurfaceRequest& request);

/// Displacement and stress at the points of every request of the case, from tractions on the wheel.
/// Each body has its own material; the opposite tractions act on the rail. No displacement in a
/// rigid body.
std::vector<contact::SubsurfaceField> subsurface_fields(const contact::Scene& scene,
                                                        const contact::ContactGrid& grid,
                                                        const contact::SurfaceField& traction);

}  // namespace rollfem::halfspace
