# SPDX-License-Identifier: LGPL-2.1-or-later
# The variables of the FMU, of which CMakeLists.txt makes modelDescription.xml and variables.h: name, causality, start
# value (of outputs: none), unit, description. Value references count from 0, strings by themselves.
set(fmu_reals
  "speed|input|20|m/s|forward speed of the wheelset"
  "curvature|input|0|1/m|of the track, to the right"
  "lateral_force|input|0|N|of the springs on the wheelset, to the right, at the height of the axle"
  "yaw_moment|input|0|N.m|of the springs on the wheelset, to the right"
  "axle_torque|input|0|N.m|drives the wheelset forward"
  "left_load|input|50000|N|of the left wheel on its rail, vertical"
  "right_load|input|50000|N|of the right wheel on its rail, vertical"
  "mass|parameter|1500|kg|of the wheelset"
  "yaw_inertia|parameter|900|kg.m2|of the wheelset"
  "spin_inertia|parameter|100|kg.m2|of the wheelset about its axle"
  "rolling_radius|parameter|0.46|m|of both wheels"
  "gauge|parameter|1.435|m|between the rails"
  "inclination|parameter|0.025|1|of the rails, as a tangent"
  "friction|parameter|0.3|1|coefficient of friction, at rest"
  "kinetic_coefficient|parameter|0|1|where the surfaces slide fast, for a friction_law that falls, as the next five"
  "half_velocity|parameter|0|m/s|at which the first part of the fall is halved"
  "second_part|parameter|0|1|of the fall"
  "second_half_velocity|parameter|0|m/s|at which it is halved"
  "memory_distance|parameter|0|m|slid until friction has followed"
  "memory_velocity|parameter|0|m/s|below which it follows as at this velocity (0: 0.001)"
  "layer_thickness|parameter|0|m|of an elastic layer between wheel and rail (0: none)"
  "layer_shear_modulus|parameter|0|Pa|of the layer"
  "largest_step|parameter|0.002|s|of the integration in a communication step"
  "start_shift|parameter|0|m|lateral shift at the start, to the right"
  "start_yaw|parameter|0|rad|yaw at the start, to the right"
  "shift|output||m|lateral shift, to the right"
  "lateral_velocity|output||m/s|its rate"
  "yaw|output||rad|against the track, to the right"
  "yaw_rate|output||rad/s|its rate, against the track"
  "extra_rotation|output||rad/s|rotation beyond speed over rolling_radius"
  "roll|output||rad|right wheel down"
  "left_fx|output||N|of the left rail on its wheel, along"
  "left_fy|output||N|of the left rail on its wheel, to the right"
  "right_fx|output||N|of the right rail on its wheel, along"
  "right_fy|output||N|of the right rail on its wheel, to the right"
  "left_t_gamma|output||N|wear number of the left wheel"
  "right_t_gamma|output||N|wear number of the right wheel")
set(fmu_laws constant linear rational exponential)  # in the order of rollfem_law
string(REPLACE ";" ", " fmu_law_words "${fmu_laws}")
set(fmu_strings
  "wheel_profile|parameter|S1002||built in or a file"
  "rail_profile|parameter|60E1||built in or a file"
  "friction_law|parameter|constant||${fmu_law_words}: how friction falls with the slip velocity")
