# SPDX-License-Identifier: LGPL-2.1-or-later
"""Published numbers, each with its source. Units mm, N, MPa, rad; signs are rollfem's."""
import json
import os

# Steel of CONTACT's examples, G = 82 000 MPa: keys of a body, sections of both, E* in MPa.
CONTACT_STEEL = "young_modulus = 209920.0\npoisson_ratio = 0.28"
CONTACT_BODIES = f"[wheel]\n{CONTACT_STEEL}\n[rail]\n{CONTACT_STEEL}\n"
CONTACT_MODULUS = 82e3 / 0.72
# CONTACT rev 2707 run for this project on case a: p0 by elements across.
CONTACT_PRESSURE_A = {20: 577.730282, 40: 578.643455, 80: 578.888652, 160: 578.947893}
# Its errors in p0 against Hertz, and its elements in contact, by case and elements across; in its approach of case a.
CONTACT_PRESSURE_ERRORS = {"a": {20: (-2.137e-3, 324), 40: (-5.595e-4, 1276), 80: (-1.360e-4, 5052)},
                           "b": {20: (-2.063e-3, 316), 40: (-5.528e-4, 1272), 80: (-1.347e-4, 5048)},
                           "c": {20: (-2.119e-3, 320), 40: (-5.579e-4, 1276), 80: (-1.357e-4, 5052)}}
CONTACT_APPROACH_ERRORS = {40: (-1.424e-4, 2e-6), 80: (-3.184e-5, 1e-6)}  # and what rounding leaves open
# -F_x/F_z of case a by creepage: CONTACT on 80 and 160 elements across, extrapolated with order 1, which its
# differences show there (+-0.0005; four grids fitted together give up to 0.0005 more).
CONTACT_CURVE_A = {0.0005: 0.11542, 0.001: 0.21565, 0.002: 0.37221, 0.003: 0.47467, 0.004: 0.53016,
                   0.006: 0.54952}
# Largest |p_x| of case a at 0.2 %, CONTACT, 160 across.
CONTACT_TRACTION_A = 307.64071
# -F_x/F_z of case c, CONTACT at 80 and 160 across: (values, values).
CONTACT_CURVE_C = {0.001: (0.13354435, 0.13300248), 0.002: (0.24488792, 0.24396890),
                   0.004: (0.40748153, 0.40612354)}
CONTACT_CURVE_C_40 = {0.001: 0.13514831, 0.002: 0.24755009, 0.004: 0.41046727}
# Largest |p_x| of case c, CONTACT at 80 across.
CONTACT_TRACTION_C = {0.001: 500.03487, 0.002: 673.20600, 0.004: 832.21751}
# -F_x/F_z of case e with the rail's drop as extra slip: CONTACT at 40 across, first-order difference.
CONTACT_CURVE_E = {-0.002: -0.40511670, -0.001: -0.26957764, 0.0: -0.07844771, 0.001: 0.14400622, 0.002: 0.33114441, 0.003: 0.45746822,
                   0.004: 0.52678160}
# The same at 80 across.
CONTACT_CURVE_E_80 = {0.0: -0.07749473, 0.002: 0.32823775}
# CONTACT's FASTSIM on case a, 160 elements across, parabolic bound: (-F_x/F_z, largest traction).
CONTACT_FASTSIM_A = {0.0005: (0.11435703, 104.12065), 0.001: (0.21098024, 194.06035),
                     0.002: (0.35763296, 329.48376), 0.003: (0.45278539, 406.27024),
                     0.004: (0.50871749, 424.54292), 0.006: (0.54765097, 424.54292)}
# The largest temperatures that CONTACT prints for the ellipse of Ertz and Knothe, degC, and with friction that is this at 400 degC
# -F_x/(mu F_z) and the largest temperature in full sliding.
CONTACT_TEMPERATURES = {"sliding": 166.8, "hot wheel, sliding": 241.8, "hot wheel, partial slip": 90.85}
CONTACT_HEATED = {0.12: (0.8660, 137.5), 0.48: (1.178, 208.9)}
# Benchmark 9, CONTACT with first-order difference: elements across: (F_x, F_y N, M_z N mm).
CONTACT_BENCHMARK_9 = {20: (10510, -7275, -1896), 40: (10400, -7201, -1592), 80: (10320, -7126, -1364),
                       120: (10290, -7103, -1289)}
EXTRAPOLATED_BENCHMARK_9 = (10240, -7057, -1150)
# An ellipse of 8 by 4 mm under 82 kN, mu = 0.3, eta = -6.25e-4, spin 6.25e-4 rad/mm, first-order difference on 44 by 44 elements
# (user guide): F_y, M_z, p0, approach; elements in contact and adhesion.
CONTACT_ELLIPSE = (-1.494e4, -4.821e4, 1223.0, 9.266e-2), (1276, 356)
# Elements in contact and adhesion of benchmark 9.
CONTACT_ELEMENTS_9 = {20: (316, 220), 40: (1272, 878), 80: (5048, 3521)}
# Kalker's printed table of the linear theory (Kalker 1967; 1990 table E.3) by nu: a/b: C11, C22, C23, C33. Two public codes
# agree on C11, C22 and C23; for C33 no second source was found.
KALKER = {
    0: {0.1: (2.51, 2.51, 0.334, 6.42), 0.2: (2.59, 2.59, 0.483, 3.46), 0.3: (2.68, 2.68, 0.607, 2.49),
        0.4: (2.78, 2.78, 0.72, 2.02), 0.5: (2.88, 2.88, 0.827, 1.74), 0.6: (2.98, 2.98, 0.93, 1.56),
        0.7: (3.09, 3.09, 1.03, 1.43), 0.8: (3.19, 3.19, 1.13, 1.34), 0.9: (3.29, 3.29, 1.23, 1.27),
        1: (3.4, 3.4, 1.33, 1.21), 1 / 0.9: (3.51, 3.51, 1.44, 1.16), 1 / 0.8: (3.65, 3.65, 1.58, 1.1),
        1 / 0.7: (3.82, 3.82, 1.76, 1.05), 1 / 0.6: (4.06, 4.06, 2.01, 1.01), 1 / 0.5: (4.37, 4.37, 2.35, 0.958),
        1 / 0.4: (4.84, 4.84, 2.88, 0.912), 1 / 0.3: (5.57, 5.57, 3.79, 0.868), 1 / 0.2: (6.96, 6.96, 5.72, 0.828),
        1 / 0.1: (10.7, 10.7, 12.2, 0.795)},
    0.25: {0.1: (3.31, 2.52, 0.473, 8.28), 0.2: (3.37, 2.63, 0.603, 4.27), 0.3: (3.44, 2.75, 0.715, 2.96),
        0.4: (3.53, 2.88, 0.823, 2.32), 0.5: (3.62, 3.01, 0.929, 1.93), 0.6: (3.72, 3.14, 1.03, 1.68),
        0.7: (3.81, 3.28, 1.14, 1.5), 0.8: (3.91, 3.41, 1.25, 1.37), 0.9: (4.01, 3.54, 1.36, 1.27),
        1: (4.12, 3.67, 1.47, 1.19), 1 / 0.9: (4.22, 3.81, 1.59, 1.11), 1 / 0.8: (4.36, 3.99, 1.75, 1.04),
        1 / 0.7: (4.54, 4.21, 1.95, 0.965), 1 / 0.6: (4.78, 4.5, 2.23, 0.892), 1 / 0.5: (5.1, 4.9, 2.62, 0.819),
        1 / 0.4: (5.57, 5.48, 3.24, 0.747), 1 / 0.3: (6.34, 6.4, 4.32, 0.674), 1 / 0.2: (7.78, 8.14, 6.63, 0.601),
        1 / 0.1: (11.7, 12.8, 14.6, 0.526)},
    0.5: {0.1: (4.85, 2.53, 0.731, 11.7), 0.2: (4.81, 2.66, 0.809, 5.66), 0.3: (4.8, 2.81, 0.889, 3.72),
        0.4: (4.82, 2.98, 0.977, 2.77), 0.5: (4.83, 3.14, 1.07, 2.22), 0.6: (4.91, 3.31, 1.18, 1.86),
        0.7: (4.97, 3.48, 1.29, 1.6), 0.8: (5.05, 3.65, 1.4, 1.42), 0.9: (5.12, 3.82, 1.51, 1.27),
        1: (5.2, 3.98, 1.63, 1.16), 1 / 0.9: (5.3, 4.16, 1.77, 1.06), 1 / 0.8: (5.42, 4.39, 1.94, 0.954),
        1 / 0.7: (5.58, 4.67, 2.18, 0.852), 1 / 0.6: (5.8, 5.04, 2.5, 0.751), 1 / 0.5: (6.11, 5.56, 2.96, 0.65),
        1 / 0.4: (6.57, 6.31, 3.7, 0.549), 1 / 0.3: (7.34, 7.51, 5.01, 0.446), 1 / 0.2: (8.82, 9.79, 7.89, 0.341),
        1 / 0.1: (12.9, 16.0, 18.0, 0.228)}
}
# Bentall and Johnson's rollers, CONTACT on 200 elements (user guide): creepage of free rolling by friction
# coefficient, and largest pressure (MPa) at mu = 10; creepage at -+0.75 mu P for mu = 0.05.
CONTACT_ROLLERS = {1e-4: 5.260e-4, 0.05: 4.29e-4, 10.0: 3.59e-4}
CONTACT_ROLLERS_PRESSURE = 103.81
CONTACT_ROLLERS_PULLED = (5.392e-4, 2.108e-4)
# CONTACT on case a below the middle of the patch, normal load: depth mm: (sxx, syy, szz, von Mises) MPa.
CONTACT_STRESS_A = {0.5: (-383.311, -340.510, -573.375, 214.689), 1.0: (-276.966, -283.211, -557.459, 277.423),
                    2.0: (-137.465, -194.151, -503.644, 341.384), 3.0: (-64.6025, -132.593, -437.695, 344.171),
                    4.0: (-28.1380, -90.6904, -373.829, 319.047), 6.0: (-1.13786, -42.7999, -270.821, 251.454),
                    8.0: (5.22582, -20.2541, -199.750, 193.498), 12.0: (5.77334, -3.95558, -117.141, 118.350)}
# Its displacement of the wheel there, mm.
CONTACT_DISPLACEMENT_A = {0.5: 2.2868e-2, 1.0: 2.1976e-2, 2.0: 2.0064e-2, 3.0: 1.8190e-2, 4.0: 1.6481e-2, 6.0: 1.3655e-2,
                          8.0: 1.1514e-2, 12.0: 8.6137e-3}
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
# Manchester benchmark A-2.2 (Shackleton and Iwnicki 2008), CONTACT's shipped results (user guide 5.7): the left wheel
# of r2707, the right of r2447 (github.com/eve70a/CONTACT, examples/mbench_a22_right.ref_out; forces there in N, here
# over mu F_n; its creepages are minus ours). By shift in mm: y, z on the track, contact angle, y on the wheel (to the
# field), normal force, force along and across over mu F_n, approach, largest pressure, elements of 0.2 mm in contact,
# xi, eta, spin. At 5 mm CONTACT joins the right wheel's two patches. The file's y on the rail is y on the track +
# 760.5326 mm, without further information.
MANCHESTER_COLUMNS = ("y", "z", "angle", "y_wheel", "force", "along", "across", "approach", "pressure", "elements",
                      "xi", "eta", "spin")
MANCHESTER = {"left": {
    0: (-751.8726, 0.1252, 0.029, 1.8726, 9997, 9.281e-05, 0.08458, 0.01596, 338.3, 1291, 5.665e-05, 0, -6.302e-05),
    1: (-755.244, 0.0467, 0.0176, 6.2694, 10050, 0.2749, -0.9592, 0.01946, 423.9, 916, 0.0006297, 0.0024, -3.848e-05),
    2: (-756.5056, 0.0271, 0.0134, 8.566, 10040, 0.1814, -0.983, 0.02054, 465.9, 830, 0.0008651, 0.004798,
        -2.947e-05),
    3: (-757.2358, 0.0182, 0.011, 10.3382, 10030, 0.153, -0.9881, 0.02128, 498.8, 766, 0.001103, 0.007197,
        -2.432e-05),
    4: (-757.6645, 0.0138, 0.0096, 11.8167, 10030, 0.1451, -0.9893, 0.02185, 527.2, 727, 0.001399, 0.009594,
        -2.138e-05),
    5: (-757.8958, 0.0116, 0.0088, 13.1136, 10030, 0.2785, -0.9604, 0.02232, 552.8, 692, 0.003462, 0.01198,
        -1.99e-05),
    6: (-758.021, 0.0106, 0.0084, 14.3878, 10020, 0.3236, -0.9462, 0.02278, 578.5, 658, 0.004901, 0.01437,
        -1.957e-05),
    7: (-758.6092, 0.0062, 0.0064, 18.6704, 10010, 0.7746, -0.6325, 0.02412, 666.7, 575, 0.02035, 0.01663,
        -2.761e-05),
    8: (-758.2223, 0.0089, 0.0077, 20.3458, 10020, 0.7689, -0.6394, 0.02458, 701.1, 549, 0.02281, 0.01899,
        -3.511e-05),
    9: (-757.6922, 0.0135, 0.0095, 21.5501, 10020, 0.7509, -0.6604, 0.02489, 725.3, 532, 0.02425, 0.02135, -4.21e-05),
    10: (-757.0975, 0.0197, 0.0115, 22.5401, 10020, 0.7302, -0.6832, 0.02511, 744, 515, 0.02532, 0.02371,
        -4.883e-05)},
    "right": {
    0: (751.8726, 0.1252, 0.029, 1.8726, 9997, 9.249e-05, -0.08459, 0.01596, 338.3, 1291, 5.665e-05, 0, 6.302e-05),
    1: (741.9908, 0.5753, 0.0696, -9.0305, 9827, -0.2762, -0.9606, 0.02448, 741.3, 606, -0.0006943, 0.002407,
        0.000151),
    2: (740.9147, 0.6548, 0.0806, -11.1296, 9799, -0.176, -0.9841, 0.0248, 744.8, 505, -0.0008752, 0.004818,
        0.0001746),
    3: (739.9698, 0.7367, 0.0923, -13.0963, 9774, -0.1424, -0.9897, 0.02439, 713.2, 530, -0.001052, 0.007235,
        0.0001998),
    4: (738.7381, 0.8604, 0.1078, -15.3505, 9745, -0.1298, -0.9913, 0.0237, 664.4, 561, -0.001276, 0.009662,
        0.000233),
    5: (727.0855, 3.0041, 0.2905, -28.0471, 9619, -0.2645, -0.9488, 0.02719, 1556, 389, -0.004174, 0.01255,
        0.0006188),
    6: (725.1371, 3.6882, 0.4176, -31.1222, 9709, -0.3021, -0.9527, 0.02728, 1149, 332, -0.005077, 0.0158, 0.0008744),
    7: (719.0445, 9.2525, 1.0634, -41.1389, 14030, -0.4939, -0.8658, 0.03563, 2622, 224, -0.01949, 0.03457, 0.001838),
    8: (719.8316, 8.0092, 0.9501, -42.3894, 12720, -0.5425, -0.8373, 0.03494, 2634, 199, -0.02127, 0.033, 0.001701),
    9: (720.4903, 7.1643, 0.8676, -43.4346, 11970, -0.5608, -0.8251, 0.03447, 2640, 186, -0.02266, 0.03341, 0.001588),
    10: (721.088, 6.5066, 0.7992, -44.3815, 11440, -0.5673, -0.8217, 0.03411, 2643, 177, -0.02378, 0.03445,
        0.001486)}}
# Left wheel, first-order differences, elements of 0.2 mm, by shift: y on the track of the reference point, creepages and spin as
# CONTACT has them, force along and across over mu F_n, elements in contact and adhesion.
MANCHESTER_TRACTIONS = {0.0: (-751.8726, -5.665e-5, 0.0, -6.302e-5, 9.281e-5, 0.08458, 1291, 943),
                        0.5: (-754.2092, -3.708e-4, 1.2e-3, -4.592e-5, 0.2942, -0.7860, 989, 342),
                        1.0: (-755.2440, -6.297e-4, 2.4e-3, -3.848e-5, 0.2749, -0.9592, 916, 0),
                        5.0: (-757.8958, -3.462e-3, 1.198e-2, -1.990e-5, 0.2785, -0.9604, 692, 0)}
# The positions between, without z on the track, y on the wheel and elements.
MANCHESTER_BETWEEN_COLUMNS = ("y", "angle", "force", "along", "across", "approach", "pressure", "xi", "eta", "spin")
MANCHESTER_BETWEEN = {"left": {
    0.5: (-754.2092, 0.0211, 10050, 0.2942, -0.7860, 1.859e-2, 395.3, 0.0003708, 0.0012, -4.592e-05),
    1.5: (-755.9669, 0.0152, 10050, 0.2127, -0.9763, 2.007e-2, 446.5, 0.000753, 0.003599, -3.33e-05),
    2.5: (-756.9177, 0.0121, 10040, 0.1634, -0.9863, 2.094e-2, 483.1, 0.0009792, 0.005998, -2.655e-05),
    3.5: (-757.4801, 0.0102, 10030, 0.1472, -0.9890, 2.158e-2, 513.4, 0.001241, 0.008395, -2.263e-05),
    4.5: (-757.7990, 0.0091, 10030, 0.1465, -0.9892, 2.209e-2, 540.2, 0.001591, 0.01079, -2.049e-05),
    5.5: (-757.9746, 0.0085, 10020, 0.3106, -0.9505, 2.255e-2, 565.8, 0.004292, 0.01317, -1.959e-05),
    6.5: (-758.6243, 0.0064, 10010, 0.7524, -0.6587, 2.369e-2, 637.0, 0.01764, 0.01546, -2.319e-05),
    7.5: (-758.4440, 0.0070, 10010, 0.7748, -0.6322, 2.438e-2, 685.9, 0.0218, 0.01781, -3.146e-05),
    8.5: (-757.9681, 0.0086, 10020, 0.7605, -0.6493, 2.474e-2, 714.0, 0.0236, 0.02017, -3.864e-05),
    9.5: (-757.4008, 0.0105, 10020, 0.7407, -0.6718, 2.501e-2, 735.2, 0.02482, 0.02253, -4.549e-05)},
    "right": {
    0.5: (744.5026, 0.0568, 9870, -0.2972, -0.8711, 1.948e-2, 632.5, -0.0004948, 0.001202, 0.0001233),
    1.5: (741.3771, 0.0753, 9811, -0.2106, -0.9774, 2.489e-2, 754.1, -0.0007903, 0.003612, 0.0001633),
    2.5: (740.4620, 0.0862, 9787, -0.1554, -0.9878, 2.461e-2, 730.4, -0.0009607, 0.006025, 0.0001866),
    3.5: (739.4071, 0.0994, 9760, -0.1342, -0.9909, 2.410e-2, 691.6, -0.001154, 0.008447, 0.000215),
    4.5: (737.8905, 0.1185, 9726, -0.1291, -0.9915, 2.310e-2, 625.5, -0.00143, 0.01088, 0.0002559),
    5.5: (726.1169, 0.3363, 9629, -0.2943, -0.9552, 2.926e-2, 1486, -0.004379, 0.01401, 0.0007122),
    6.5: (718.4931, 1.1591, 15440, -0.4289, -0.9003, 3.623e-2, 2603, -0.01828, 0.03905, 0.001937),
    7.5: (719.4632, 1.0006, 13260, -0.5242, -0.8481, 3.524e-2, 2630, -0.02044, 0.03333, 0.001765),
    8.5: (720.1709, 0.9065, 12310, -0.5537, -0.8299, 3.469e-2, 2638, -0.022, 0.03309, 0.001642),
    9.5: (720.7950, 0.8321, 11680, -0.5652, -0.8228, 3.428e-2, 2641, -0.02325, 0.03388, 0.001536)}}
# Deep-groove rolling in CONTACT (github.com/eve70a/CONTACT, testbank/examples_conformal/groove_li: a wheel of 420 mm,
# 10 mm across, 10 kN, G 80 000, nu 0.28, mu 0.3, no force along rolling), by the groove's radius in mm: on half-spaces rolled
# out flat p0 (MPa), approach (mm), creepage of free rolling; with Blanco's coefficients (variant 3) p0 where pressure is
# found once (r2447), where friction is fed back (with five outer iterations, which the input file asks for today; as quoted
# to this project), and their creepage.
CONTACT_GROOVES = {
    10.25: {"p0": 530.2, "approach": 0.022367, "creepage": -2.3007e-4, "p0_turned": 527.4, "p0_turned_back": 520.6,
            "creepage_turned": -2.3418e-4},
    10.10: {"p0": 409.3, "approach": 0.019392, "creepage": -4.4108e-4, "p0_turned": 405.9, "p0_turned_back": 397.6,
            "creepage_turned": -4.5857e-4},
    10.05: {"p0": 348.7, "approach": 0.017427, "creepage": -6.4950e-4, "p0_turned_back": 336.1},
    10.02: {"p0": 296.8, "p0_turned_back": 283.6}}

# Traction curve of a locomotive (Eurosprinter, Polach 2005) as CONTACT prints it (user guide, section 5.9; open version r2707):
# -F_x/(mu F_z) by creepage with layer and memory (cases 31 to 60), and by its modified FASTSIM, mu = 0.36 (91 to 120).
CONTACT_LOCOMOTIVE = {1e-5: 0.001869, 0.001: 0.1825, 0.002: 0.3495, 0.003: 0.4928, 0.004: 0.6101, 0.005: 0.7029, 0.006:
    0.7739, 0.007: 0.8268, 0.008: 0.8652, 0.009: 0.8928, 0.010: 0.9119, 0.011: 0.9251, 0.012: 0.9340, 0.013: 0.9395, 0.014:
    0.9426, 0.015: 0.9442, 0.016: 0.9445, 0.018: 0.9429, 0.020: 0.9393, 0.030: 0.9138, 0.040: 0.8873, 0.050: 0.8622, 0.075:
    0.8053, 0.100: 0.7559, 0.125: 0.7129, 0.150: 0.6755, 0.175: 0.6430, 0.200: 0.6146, 0.225: 0.5900, 0.250: 0.5685}
CONTACT_LOCOMOTIVE_FASTSIM = {1e-5: 0.003526, 0.001: 0.2721, 0.002: 0.4388, 0.003: 0.5477, 0.005: 0.6757, 0.007: 0.7441,
    0.010: 0.7979, 0.014: 0.8298, 0.018: 0.8420, 0.022: 0.8451, 0.030: 0.8390, 0.040: 0.8215, 0.065: 0.7654, 0.100: 0.6874,
    0.150: 0.5970, 0.200: 0.5329, 0.250: 0.4877}
# Its ellipse by CONTACT with the first-order difference, without fall or layer: F_x/(mu F_z), elements in adhesion, by creepage.
CONTACT_LOCOMOTIVE_COULOMB = {1e-5: (-7.015e-3, 1382), 4e-4: (-0.2588, 1182), 8e-4: (-0.4742, 976), 1.2e-3: (-0.6482, 782), 1.6e-3:
    (-0.7831, 596), 2e-3: (-0.8816, 422), 2.4e-3: (-0.9467, 262), 2.8e-3: (-0.9832, 132), 3.2e-3: (-0.9976, 32), 3.6e-3:
    (-0.9991, 0), 8e-3: (-0.9998, 0)}
# The force at 1e-5 in N without and with the layer.
CONTACT_LOCOMOTIVE_SLOPE = (247.0, 65.81)

# Rollers at 45 m/s on friction that falls steeply (Vollebregt and Schuttelaars 2012; example veldep_fric of r2707, cases 3 to 14):
# F_x/(mu F_z) of steps of an element from fast sliding on.
CONTACT_ROLLERS_SLIDING = (0.5941, 0.5702, 0.5739, 0.5774, 0.5806, 0.5835, 0.5860, 0.5882, 0.5714, 0.5751, 0.5786, 0.5817)

# Dry twin disc, wheel steel R8T on rail steel 900A (Lewis and Dwyer-Joyce 2004): discs of 47 mm, track of 10 mm, 400 rpm,
# 1500 MPa by Hertz, which is 7198 N. Slip: heat of friction in W; the traction coefficient is heat/(slip V F_n).
TWIN_DISC = {0.002: 1.3, 0.005: 9.2, 0.01: 25.7, 0.03: 102.6, 0.075: 246.0, 0.1: 327.8, 0.15: 492.1, 0.2: 728.4}
TWIN_DISC_SPEED, TWIN_DISC_FORCE, TWIN_DISC_PRESSURE = 0.984, 7198.0, 1500.0  # m/s, N, MPa

def calculix(case):
    """({by: line without friction}, CalculiX's on the finest cells) of the comparison that holds `case`, as
    benchmarks/calculix/curved_patch.py --store wrote it."""
    with open(os.path.join(os.path.dirname(__file__), "calculix.json"), encoding="utf-8") as file:
        lines = {line["by"]: line for line in json.load(file) if case in line and line["friction"] == 0.0}
    finest = min((by for by in lines if by.startswith("CalculiX")), key=lambda by: float(by.split()[1]))
    return lines, lines[finest]
