// SPDX-License-Identifier: LGPL-2.1-or-later
// A case in CONTACT's own words (E. A. H. Vollebregt, user guide for CONTACT; module 1, wheel and
// rail, and module 3, single contacts), whether it was read from an input file or set through the
// functions of its library. Names follow CONTACT's user guide; units mm, N, MPa, rad, s unless a
// member says otherwise.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace rollfem::convert {

/// The control integers, digit by digit.
struct Digits {
  int config = 0;  ///< C of module 1: 0, 4 left, 1, 5 right; 4 and 5 on a roller rig
  int P = 2, B = 0, T = 0, N = 0, F = 0, S = 0;
  int V = 0, L = 0, D = 0, C = 0, M = 0, Z = 0, E = 0;
  int M2 = 0;  ///< damping, a separate number after V-L-D-C-M-Z-E
  int X = 0, H = 0, G = 0, I = 0, A = 0, O = 0, W = 0, R = 0;
};

struct BodyConstants {
  std::array<double, 2> poisson{}, shear_modulus{};      ///< module 3: upper, lower; 1: rail, wheel
  int influence = 2;                                     ///< digit C as last given
  std::array<double, 3> slope_reduction{1.0, 1.0, 1.0};  ///< K0_MF, ALFAMF, BETAMF
  std::array<double, 4> layer{};                         ///< GG3, LAYTHK, TAU_C0, K_TAU
  std::array<std::array<double, 4>, 2> heat{};           ///< BKTEMP, HEATCP, LAMBDA, DENSITY
};

/// The potential contact area of module 3.
struct PotentialContact {
  int ipotcn = 0, mx = 0, my = 0;
  std::array<double, 4> size{};  ///< numbers after MX, MY; their meaning depends on ipotcn
};

struct UndeformedDistance {
  int ibase = 1, iplan = 1;
  /// B1 to B6; NN, XM, RX1, Y1, DY1 and heights; B1 to B8; or the distance of every element.
  std::vector<double> values;
};

struct ProfileFile {
  std::string name;  ///< as written in the file, with /
  int mirror_y = 0, mirror_z = 0;
  double scale = 1.0, smooth = 0.0;
  bool has_options = false;  ///< further options of smoothing
};

/// Module 1: track, wheelset and grid.
struct WheelRail {
  int search = 2;                ///< digit D as last given anew
  std::array<double, 2> cell{};  ///< DX, DS
  double step = 1.0;             ///< DQREL: rolled in a step of T = 2, in DX
  std::vector<double> springs;   ///< KYRAIL, FYRAIL, KZRAIL, FZRAIL
  /// GAUGHT, GAUGSQ, GAUGWD, or GAUGHT <= 0, RAILY0, RAILZ0; CANT or the roller's NOMRAD
  std::array<double, 4> track{};
  ProfileFile rail, wheel;
  std::vector<double> rail_deviations;   ///< DY, DZ, ROLL, VY, VZ, VROLL
  std::vector<double> wheel_deviations;  ///< twelve, E = 4 and 5
  std::array<double, 3> wheelset{};      ///< FBDIST, FBPOS, NOMRAD
  std::array<double, 6> position{};      ///< S, Y, FZ or Z, ROLL, YAW, PITCH
  std::array<double, 6> velocity{};      ///< VS, VY, VZ, VROLL, VYAW, VPITCH (or FX, MY)
};

/// Points below the surface: all of x by y by z.
struct StressBlock {
  bool by_element = false;      ///< x and y are element numbers from 1 instead of mm
  std::vector<double> x, y, z;  ///< z > 0 in the upper body
};

/// A set of friction parameters.
struct FrictionSet {
  double place = 0.0;              ///< ALPHVF, rad, negative on the gauge face; SVF, mm; else 0
  double fstat = 0.0, fkin = 0.0;  ///< at rest, sliding
  std::array<double, 4> fall{};    ///< F1, SABSH1, F2, SABSH2 of L = 2 to 4; TREF, DFHEAT, DTHEAT
};

struct ContactCase {
  int module = 0;        ///< 1 or 3
  int number = 0;        ///< counted from 1, as in CONTACT
  std::size_t line = 0;  ///< line of the module number, or of the last one before it
  Digits digits;
  int max_outer = 1;                   ///< MAXOUT
  int initial_slip = 0;                ///< INISLP
  std::array<double, 4> kinematics{};  ///< module 3: FN or PEN, CKSI or FX, CETA or FY, CPHI
  int friction_law = 0;                ///< digit L as it was last given anew
  int friction_over = 0;               ///< digit V as it was last given with friction
  /// One; or with friction_over > 0 one per place over the rail (module 1), or per row of elements.
  std::vector<FrictionSet> friction;
  std::array<double, 2> memory{};                     ///< MEMDST, MEM_S0
  std::array<double, 4> rolling{0, 0, 0, 1.0 / 6.0};  ///< CHI, DQ, VELOC, FACPHI
  BodyConstants bodies;
  PotentialContact potential;
  UndeformedDistance distance;
  WheelRail wheel_rail;
  std::vector<StressBlock> stress_blocks;  ///< as last given
};

}  // namespace rollfem::convert
