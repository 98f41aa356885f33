# SPDX-License-Identifier: LGPL-2.1-or-later
"""Origin of the tolerances: the expected errors of both sides, and the reasons of the rows closest to theirs."""

# Chapter: uncertainty of the reference, and error of the program's grid, cells or steps there.
BASIS = {
    "hertz": "the closed form is exact; the pressure is of second order (5.6e-4 in p0 at 40 across), the approach 1.4e-4, "
             "semi-axes are found below the element, to some 0.1 %.",
    "grid-order": "CONTACT has nine digits on the same grid; against Hertz the order is 2: 3.4e-5 in p0 at 160 across.",
    "steuermann": "closed form; second order at 160 across; the radius is known to 1.25 elements only.",
    "cattaneo": "closed form without coupling of both directions (Mindlin), so nu = 0.42 is allowed 1 % where nu = 0 has "
                "0.3 %; areas of adhesion are counted in elements.",
    "spence": "CONTACT's guide has three to four digits; steps of the load are of first order, areas are counted in elements.",
    "carter": "strips of a closed form, b/a = 100: ends cost some 0.1 % of mu; order 1.5 to 2 in the elements along rolling.",
    "bentall-johnson": "CONTACT's creepages are printed to three digits (half a unit: 0.12 to 0.14 %); closed form at vanishing "
                       "friction.",
    "nowell-hills": "quadrature to 1e-4; elements of a/100 whose edges of slip are of first order in mu, so the tolerance "
                    "grows with mu; in full adhesion the patch narrows by an element, 1.5 % of the creepage.",
    "kalker": "the series is known to five digits and the table keeps six digits; between its entries 1e-4 "
              "(3e-4 where a/b is below 0.2 or above 20). Of the half-space at 40 across the edge of the ellipse is a "
              "staircase, which leaves the size of the patch open by a fifth of an element, 0.5 %: "
              "forces go with its square, those of spin with its cube, the moment of spin with its fourth power (as "
              "fractions of C33 at nu = 0, of which Poisson's effect leaves a part).",
    "benchmark-9": "CONTACT's extrapolation of a first-order scheme is good to 0.1 % in the forces and a few percent in the "
                   "moment.",
    "fastsim": "the same algorithm on the same elements with the same flexibilities; constants agree to 1e-5.",
    "transient": "a sixth of the contact length remains to be rolled, and steps are of first order: 0.8 % of mu.",
    "creep-frequency": "closed form of a line contact; second order in 80 elements and in the step.",
    "stress-circle": "closed form; half-space 80 across of second order, surface by cells; elements of a/8 1 % of p0 in "
                     "recovered stress.",
    "stress-case-a": "CONTACT has six digits at 160 across; half-space at 40 across 5.6e-4; recovered stress 1 % of p0.",
    "elements": "manufactured solutions: k + 1 and k, within what two meshes say of an order.",
    "persson": "Persson's integral equation is solved to four digits; angles are known to a quarter of a cell, 0.5 degrees.",
    "fem-hertz": "closed form; a/8 and degree 2: 0.3 % in p0 (design measurements: +0.27 % with cells fine over one patch).",
    "incompressible": "closed form; order of the element at the named number of cells.",
    "inertia": "closed forms; order of the element; the compliance rises with V squared to a few parts in a thousand.",
    "calculix": "CalculiX's p0 is 0.5 % low on cells of 0.63 mm, the hybrid's bar 0.1 %; on equal meshes both cancel in the "
                "difference but for its own change with the cell, 0.07 MPa from 0.95 to 0.63 mm and 0.1 to the limit: 0.3 MPa "
                "with the hybrid's correction. b is known to 0.03 mm from the fit.",
    "thesis-cases": "Hertz exact in a to d; half-space 5.6e-4; finite elements 0.3 % (a/8); CONTACT's extrapolations "
                    "+-0.0005 of F_z, 0.1 % of mu; finite elements differ from half-spaces by up to 0.6 % of mu.",
    "hybrid": "limits of finite elements are extrapolated with bars of some 0.02 % (`benchmarks/hybrid_limits.py`).",
    "curvature-slip": "the series is exact; segments of 8 and 16 a cost 1 to 2 % of the slip, cells of a/5 1 to 2 %; first "
                      "order in a/R leaves out some 3 a/R.",
    "conformal-contact": "CONTACT prints four digits and stops its iteration at some 0.1 %; distances along two normals "
                         "differ by 0.2 to 1 %. CalculiX's p0 is 0.7 % low on cells of 0.6 mm on a flat rail, which cancels "
                         "to some 0.3 %, and b is known to 0.03 mm of a fit, 0.5 % in either shape; the hybrid's bar is 0.15 %; "
                         "half-spaces miss what the chapter measures, 2 and 5 %.",
    "wheel-on-rail": "CONTACT on 0.05 mm; the patch is compared to one of its 0.2 mm elements in size; finite elements of "
                     "0.5 mm 0.5 %.",
    "manchester": "CONTACT prints four digits, on elements of 0.2 mm. The reference point follows an estimate of the approach "
                  "(0.03 mm); creepages are over two different speeds (1.3 %) and friction by differences of first and "
                  "second order (0.4 %). On the flange the patch is 3.7 elements wide, which is 2 to 3 % of p0 in either "
                  "program: 5 % for both, more than a test of the method can use.",
    "falling-friction": "CONTACT has four digits on the same elements; what differs is where its memory begins. The law is exact "
                        "in full sliding but for elastic strains; FASTSIM's flexibilities are those of another table.",
    "yielding-layer": "closed forms; elements are in contact or not (2 % of the patch at 40 across, 0.5 % at 160) and coarser than the "
                      "kinks of a brush; order 2 in the force; steps are of first order.",
    "measured": "Carter's closed form is exact, collocation with a layer good to 1e-5 of mu; second order in 80 elements. "
                "What was measured is known to half a unit of the last printed digit of the heat (4 % at the smallest slip) and "
                "to scatter of some 10 %: shown, not judged.",
}

# (chapter, words of the quantity, model): why a row uses more than 80 % of its tolerance.
SPENT = (
    ("curvature-slip", "sphere: mean slip", "cells of a/5, which add some 3 %, less what lies beyond the segment; at 8 a both cancel"),
    ("curvature-slip", "sphere: slip over the patch", "cells of a/5, which add some 3 %"),
    ("curvature-slip", "case a: mean slip, first order", "the other hand's figure has three digits, 0.3 %; the rest is not explained"),
    ("curvature-slip", "sphere, a/R = 0.0126", "the next term in a/R, which the first order leaves out"),
    ("thesis-cases", "p0", "cells of a/8: discretisation, all three on the same side"),
    ("thesis-cases", "case a: largest |p_x|", "40 elements across beside CONTACT's 160"),
    ("nowell-hills", "mu = 0.3", "edges of slip between elements of a/100, of first order, in proportion to mu"),
    ("nowell-hills", "mu = 10", "the patch narrows by half an element at either end"),
    ("cattaneo", "nu = 0.42", "Mindlin's closed form leaves out slip across the shift"),
    ("bentall-johnson", "mu = 0.05", "half a unit of CONTACT's last printed digit is 0.12 %"),
    ("conformal-contact", "creepage of free rolling", "normals that turn, measured in two ways; 0.4 % was allowed for it"),
    ("conformal-contact", "corner, given approach: F_z", "cells of the correction: 0.02 % with finer ones"),
    ("conformal-contact", "b over that on a flat rail", "b of the fit is known to 0.5 % in either shape"),
    ("wheel-on-rail", "moved by 1 µm", "the grid, laid over the patch, moves by a sixth of a row within this micrometre, "
     "and F_y by half of its error bar"),
    ("manchester", "F_y/(mu F_n)", "CONTACT's difference is of first order, here of second"),
    ("manchester", "on the track", "the reference point lies where the estimated approach puts it; with CONTACT's approach y of "
     "the left wheel is within 7 µm"),
    ("manchester", "y on the wheel", "the reference point lies where the estimated approach puts it"),
    ("manchester", "contact angle", "CONTACT prints the mean angle of the patch, here it is the tangent at its mean place"),
    ("manchester", "elements in contact", "the rim of the patch: 9 elements of 332 on grids that lie otherwise"),
    ("manchester", "eta", "creepage is over the mean of two speeds in CONTACT: up to 1.3 %"),
    ("manchester", "p0, at 10 mm", "elements of 0.2 mm across a patch of 0.73 mm, in both programs: see that chapter"),
    ("kalker", "", "the staircase of elements at the edge of the ellipse"),
)


def spent_on(chapter, row):
    """Why a row is close to its limit; empty if unknown."""
    for name, words, reason in SPENT:
        if name == chapter and (words in row.quantity or words == row.by):
            return reason
    return ""
