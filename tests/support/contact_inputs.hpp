// SPDX-License-Identifier: LGPL-2.1-or-later
// Small input files in CONTACT's format, made for the tests.
#pragma once

#include "support/test.hpp"

namespace rollfem::testing {

/// A ball of radius 25 mm on a plane, G = 300 MPa, nu = 0.25, pressed with 20 N and pushed by half
/// of what friction (0.3) bears.
inline const std::string pushed_ball = R"(% a ball is pushed
 3 module                         % numbers first, words behind them
 201120   P-B-T-N-F-S
 022020   L-D-C-M-Z-E
 0001341  H-G-I-A-O-W-R
 200 100 30 1 1d-6                MAXGS MAXIN MAXNR MAXOUT EPS
 20.0  -0.5  0.0  0.0             FN FX FY CPHI
 0.30  0.30                       FSTAT FKIN
 0.25  0.25  300. 300.            POISS GG
   1                              IPOTCN
 36 36  -1.35 -1.35 0.075 0.075   MX MY XL YL DX DY
   1 1                            IBASE IPLAN
 0.02 0.0 0.02
 0.0 0.0 0.0                      B1 to B6, on two lines
 0 module
)";

/// Rolling of an ellipse of 5 by 3 mm, three creepages.
inline const std::string rolling_ellipse = R"( 3 module
 203100   P-B-T-N-F-S
 022020   L-D-C-M-Z-E
 0001341  H-G-I-A-O-W-R
 200 100 30 1 1e-6
 40000. 0.0004 -0.0002 0.0003     FN CKSI CETA CPHI
 0.35 0.35
 0.0 0.5 20000.                   CHI DQ VELOC
 0.28 0.28 82000. 82000.
  -3
 22 22 5.0 3.0 1.1                MX MY AA BB SCALE
 3 module
 203100
 100000
 0101341
 40000. 0.0008 -0.0002 0.0003
 3 module
 203100
 100000
 0101341
 40000. 0.0012 -0.0002 0.0003
 0
)";

/// A roller of 300 mm on a plane, 250 mm wide, driven by 0.4 of what friction bears; rolls along
/// -x.
inline const std::string driven_roller = R"( 3 module
 203110   P-B-T-N-F-S
 022020   L-D-C-M-Z-E
 0001341  H-G-I-A-O-W-R
 200 100 30 1 1e-6
 30000. 0.4 0.0 0.0               FN FX CETA CPHI
 0.25 0.25
 180d 0.02 20000.                 CHI DQ VELOC
 0.30 0.25 30000. 80000.
   1
 60 1 -1.2 -125. 0.04 250.        MX MY XL YL DX DY
   1 1
 0.0016666666666667 0.0 0.0 0.0 0.0 0.0
 0
)";

/// An ellipse of 5 by 3 mm under Hertz's pressure, pushed by half of what friction bears.
inline const std::string pushed_ellipse = R"( 3 module
 221110   P-B-T-N-F-S
 022020   L-D-C-M-Z-E
 0001341  H-G-I-A-O-W-R
 200 100 30 1 1e-6
 40000. 0.5 0.0 0.0               FN FX CETA CPHI
 0.35 0.35
 0.28 0.28 82000. 82000.
  -3
 22 22 5.0 3.0 1.1                MX MY AA BB SCALE
 0
)";

/// The left wheel of a wheelset that is 1.5 mm to the right, yawed and turns a little too fast.
inline const std::string left_wheel = R"( 1 module
 0203100  C-P-B-T-N-F-S
 0022033  V-L-D-C-M-Z-E
 0000321  H-G-I-A-O-W-R
 200 100 30 1 1e-5
 0.25 0.25
 0.30 0.28  70000. 80000.         POISS, GG: rail, wheel
 0.25 0.2 1.0 90d 8.0 4.0         DX DS DQREL A_SEP D_SEP D_COMB
 14.5 0 1435.0 0.025              GAUGHT GAUGSQ GAUGWD CANT
 'rail.csv' 0 1.0 0.0             file MIRRORY SCALE SMOOTH
 0.0 0.0 0.0 0.0 0.0 0.0
 1358.0 -70.0 450.0               FBDIST FBPOS NOMRAD
 'wheel.csv' 1 1.0 0.0 1          file MIRRORY SCALE SMOOTH MIRRORZ
 0.0 1.5 45000. -0.0001 0.003 0.0 S Y FZ ROLL YAW PITCH
 9000. 18. 0. 0. 0.09 -20.02      VS VY VZ VROLL VYAW VPITCH
 0 module
)";

/// A text with one piece of it replaced by another.
inline std::string replaced(std::string text, const std::string& piece, const std::string& by) {
  return text.replace(text.find(piece), piece.size(), by);  // at throws where there is none
}

/// The ball, pushed by a force and then rolled at a creepage.
inline const std::string pushed_then_rolled = replaced(pushed_ball, " 0 module", R"( 3 module
 002100
 102000
 0111341
 20.0 0.0001 0.0 0.0
 0.0 0.1 1000.
 0.25 0.25 300. 300.
 0 module)");

/// The first two cases of the ellipse are the same.
inline const std::string rolled_twice = replaced(rolling_ellipse, "40000. 0.0008", "40000. 0.0004");

}  // namespace rollfem::testing
