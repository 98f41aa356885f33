"""Numbers of others, each with its source. Units mm, N, MPa, rad; signs are rollfem's."""

# CONTACT rev 2707 run for this project on case a: p0 by elements across.
CONTACT_PRESSURE_A = {20: 577.730282, 40: 578.643455, 80: 578.888652, 160: 578.947893}
# -F_x/F_z of case a by creepage: CONTACT on 80 and 160 elements across, extrapolated with order 1, which its
# differences show there (+-0.0005; four grids fitted together give up to 0.0005 more).
CONTACT_CURVE_A = {0.0005: 0.11542, 0.001: 0.21565, 0.002: 0.37221, 0.003: 0.47467, 0.004: 0.53016,
                   0.006: 0.54952}
# Largest |p_x| of case a at 0.2 %, CONTACT, 160 across.
CONTACT_TRACTION_A = 307.64071
# -F_x/F_z of case c, CONTACT at 80 and 160 across: (values, values).
CONTACT_CURVE_C = {0.001: (0.13354435, 0.13300248), 0.002: (0.24488792, 0.24396890)}
# -F_x/F_z of case e with the rail's drop as extra slip: CONTACT at 40 across, first-order difference.
CONTACT_CURVE_E = {0.0: -0.07844771, 0.001: 0.14400622, 0.002: 0.33114441, 0.003: 0.45746822,
                   0.004: 0.52678160}
# The same at 80 across.
CONTACT_CURVE_E_80 = {0.0: -0.07749473, 0.002: 0.32823775}
# CONTACT's FASTSIM on case a, 160 elements across, parabolic bound: (-F_x/F_z, largest traction).
CONTACT_FASTSIM_A = {0.0005: (0.11435703, 104.12065), 0.001: (0.21098024, 194.06035),
                     0.002: (0.35763296, 329.48376), 0.003: (0.45278539, 406.27024),
                     0.004: (0.50871749, 424.54292), 0.006: (0.54765097, 424.54292)}
# Benchmark 9, CONTACT with first-order difference: elements across: (F_x, F_y N, M_z N mm).
CONTACT_BENCHMARK_9 = {20: (10510, -7275, -1896), 40: (10400, -7201, -1592), 80: (10320, -7126, -1364),
                       120: (10290, -7103, -1289)}
EXTRAPOLATED_BENCHMARK_9 = (10240, -7057, -1150)
# Kalker's table of the linear theory (Kalker 1967; 1990 table E.3) for nu = 0.25: a/b: C11, C22, C23.
KALKER_NU_025 = {0.1: (3.31, 2.52, 0.473), 0.2: (3.37, 2.63, 0.603), 0.5: (3.62, 3.01, 0.929),
                 1.0: (4.12, 3.67, 1.47), 2.0: (5.1, 4.9, 2.62), 5.0: (7.78, 8.14, 6.63),
                 10.0: (11.7, 12.8, 14.6)}
# Bentall and Johnson's rollers, CONTACT on 200 elements (user guide): creepage of free rolling by friction
# coefficient, and largest pressure (MPa) at mu = 10; creepage at -+0.75 mu P for mu = 0.05.
CONTACT_ROLLERS = {0.05: 4.29e-4, 10.0: 3.59e-4}
CONTACT_ROLLERS_PRESSURE = 103.81
CONTACT_ROLLERS_PULLED = (5.392e-4, 2.108e-4)
# CONTACT on case a below the middle of the patch, normal load: depth mm: (sxx, syy, szz, von Mises) MPa.
CONTACT_STRESS_A = {0.5: (-383.311, -340.510, -573.375, 214.689), 1.0: (-276.966, -283.211, -557.459, 277.423),
                    2.0: (-137.465, -194.151, -503.644, 341.384), 3.0: (-64.6025, -132.593, -437.695, 344.171),
                    4.0: (-28.1380, -90.6904, -373.829, 319.047), 6.0: (-1.13786, -42.7999, -270.821, 251.454),
                    8.0: (5.22582, -20.2541, -199.750, 193.498), 12.0: (5.77334, -3.95558, -117.141, 118.350)}
# S1002 on UIC60, 100 kN, wheelset 2 mm to the right: CONTACT rev 2707 on 0.05 mm (left), and the 2012
# thesis by program: (p0, length along x, width). None: not known.
WHEEL_ON_RAIL = {
    "left": {"CONTACT today": (1011.17, 12.75, 16.20), "thesis: CONTACT": (1013, 15.3, 16.6),
             "thesis: WSC": (987.2, 12.1, 16.2), "thesis: SRS (FE)": (1012.4, 13.2, 16.7)},
    "right": {"CONTACT today": (1510.7, None, None), "thesis: CONTACT": (1526, 16.7, 16.3),
              "thesis: WSC": (1082, 13.6, 16), "thesis: SRS (FE)": (1448, 15.9, 17)}}
# The 2012 thesis, case: program: (a, b, p0). Hertz read from a diagram; SRS: a commercial FE tool, 8 to 12 h.
THESIS = {
    "a": {"Hertz, diagram": (3.79, 10.93, 575.8), "CONTACT": (3.81, 10.8, 578.9), "WSC": (3.78, 10.85, 562.2),
          "SRS (FE)": (4.17, 11.77, 586.1)},
    "c": {"Hertz, diagram": (6.27, 2.48, None), "CONTACT": (6.26, 2.5, None), "WSC": (6.25, 2.45, None),
          "SRS (FE)": (7.74, 3.53, None)}}
# Largest |p_x| of case a at 0.2 % in the thesis, MPa.
THESIS_TRACTION_A = {"CONTACT": 317.6, "WSC": 364.0, "SRS (FE)": 322.0}
# Manchester benchmark, left wheel, CONTACT's shipped results (user guide 5.7): shift mm:
# (y on the track, normal force, largest pressure, xi).
MANCHESTER = {
    0: (-751.8726, 9997, 338.3, 5.665e-5), 1: (-755.2440, 10050, 423.9, 6.297e-4),
    2: (-756.5056, 10040, 465.9, 8.651e-4), 3: (-757.2358, 10030, 498.8, 1.103e-3),
    4: (-757.6645, 10030, 527.2, 1.399e-3), 5: (-757.8958, 10030, 552.8, 3.462e-3),
    6: (-758.0210, 10020, 578.5, 4.901e-3), 7: (-758.6092, 10010, 666.7, 2.035e-2),
    8: (-758.2223, 10020, 701.1, 2.281e-2), 9: (-757.6922, 10020, 725.3, 2.425e-2),
    10: (-757.0975, 10020, 744.0, 2.532e-2)}
