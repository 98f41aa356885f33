"""Runs of the hybrid that are too dear for the book, with the commands that made them; what they come to in words.

Made with rollfem 0.1.0 at commit 2199ea1, some ten seconds of processor time each:

    rollfem run cases/conformal_groove.toml --model hybrid     with rail.transverse_radius = -10.25, -10.10, -10.05
    rollfem run cases/conformal_corner.toml --model hybrid     with contact_grid.elements_across = 30

The groove of 10.25 mm with friction has rolling.problem = "steady", longitudinal_creepage = -2.31e-4 (F_x = -147 N) and 30
elements across; segments of 35 mm are fem.extent = 35.0.
With friction the corner has rolling.problem = "steady" (22 s) and all of its rigid slip from rolling.extra_slip_file, which is
CONTACT's within 1e-6: with R = 10.1, t = s/R, s the arc, s_x = -0.004 + 0.0015372 R sin t - R (1 - cos t)/650.54 and
s_y = -0.014 cos(pi/4 - t) - x sin(pi/4 - t)/460.

Sums of pressure are those of results.h5 times the area of an element.
"""

# By the groove's radius: p0 in MPa (bars 0.7, 0.6, 0.6), semi-axes and approach in mm.
GROOVES = {10.25: {"p0": 530.026, "a": 3.0783, "b": 2.9423, "approach": 0.0222170},
           10.10: {"p0": 409.722, "a": 2.6639, "b": 4.4404, "approach": 0.0191437},
           10.05: {"p0": 348.280, "a": 2.3836, "b": 5.8729, "approach": 0.0170418}}

# The corner at its approach: who, force along the approach in kN, sum of pressure in kN, p0 in MPa.
CORNER = [("half-space, curved", "90.04", "92.74", "1005.4"),
          ("CONTACT on half-spaces", "89.25", "91.84", "1012"),
          ("hybrid, segments of 8 semi-axes", "97.68 ± 0.77", "101.19", "1009.0 ± 2.3"),
          ("hybrid, segments of 35 mm in place of 63 mm", "97.40", "", "1006.2"),
          ("CONTACT, coefficients by finite elements of others, friction of 0.3", "", "99.32", "1034")]
# With friction and the rigid slip of CONTACT's cases 4 and 5: who, F_x, F_s, sum of pressure in kN, p0 in MPa.
CORNER_FRICTION = [("half-space, curved", "10.56", "22.66", "92.74", "1005.4"),
                   ("CONTACT on half-spaces", "10.50", "22.51", "91.84", "1012"),
                   ("hybrid, segments of 8 semi-axes", "13.31", "23.71", "102.08 ± 0.95", "1020.0 ± 1.9"),
                   ("CONTACT, coefficients by finite elements of others", "12.70", "23.83", "99.83", "1040")]

VERDICT = """\
**Why CONTACT and the curved half-space seemed to differ.** They do not. In the grooves CONTACT rolls with friction of 0.3 and
no force along rolling; normals that lean make spin, spin makes friction across, and at 10.25 mm that carries {part} % of
the load. With the same friction p0, approach and creepage agree as above; without it the half-space has 0.6 to 1.2 % more
pressure. Distance along the local normal, elements along the arc of the mean circle, half-space coefficients rolled out
flat and the load as the sum of p cos are the same in both. In the corner CONTACT prints the sum of pressure, 91.84 kN, of
which 89.25 kN are along the approach; what is left, 0.9 % in force and 0.7 % in p0, is its distance along rolling, x²/2R along the
normal, where the wheel's circle closes along z.

**What "Blanco's" coefficients are.** No bodies by finite elements, but the half-space's coefficients with directions turned
by the angle between two places (between like bodies the normal one is multiplied by its cosine). Without friction they give the
pressure of the hybrid, whose bodies are meshed: in the grooves they are right about what a curved half-space lacks. CONTACT's
520.6 MPa has, beyond that, friction that displaces the surfaces along the normal; the hybrid with friction (xi = −2.31e-4)
has 524.1 MPa, half way between 527.4 without and 520.6 with it. Only the corner's second
set of coefficients is of meshed bodies: quarter and three-quarter spaces, whose flanks begin at 45 degrees where ours begin at
44.4 ([meshes](../meshes.md#how-far-circles-go-on)). At a given approach they and the hybrid have 8 to 9 % more force than
half-spaces. Both say that conformity adds a fifth to a quarter to F_x. What is left between them, 2 % in force
and pressure and 5 % in F_x, is not explained: the extents of those bodies and their cells are not published.

**How far a theory goes** (half the patch over the smaller radius across, here in the three grooves, between
them by the square of the ratio, which also goes on below 0.29).
Given the force, p0 is within 1 % by Hertz and plane half-spaces up to 0.19 and within 5 % up to 0.48, by the curved
half-space within 1 % up to 0.53 and within 1.3 % to the end, 0.59. The width is within 5 % by Hertz up to 0.43, by the curved half-space to
the end. The approach is within 1 % by Hertz up to 0.43 and within 5 % to the end; the curved half-space is 1.8 %
off at 0.29 and 4.5 % at 0.59: its normals turn and its coefficients do not. At a given approach a corner of 0.6 has 8 % less
force than the hybrid, so there it is the hybrid, or finite elements."""
