// Readers of the parts of a CONTACT case, in the order of the file; for contact_reader.cpp.
#pragma once

#include "convert/contact_case.hpp"
#include "convert/input_lines.hpp"

namespace rollfem::convert {

void read_digits(InputLines& lines, ContactCase& next);
void read_solver(InputLines& lines, ContactCase& next);
void read_kinematics(InputLines& lines, ContactCase& next);
/// Friction of digits V and L; `sets` is how many sets of parameters there are.
void read_friction(InputLines& lines, ContactCase& next, int sets);
void read_rolling_step(InputLines& lines, ContactCase& next);  ///< module 3
void read_material(InputLines& lines, ContactCase& next);
void read_potential_contact(InputLines& lines, ContactCase& next);
void read_undeformed_distance(InputLines& lines, ContactCase& next);
void read_wheel_rail(InputLines& lines, ContactCase& next);  ///< grid, track, wheelset
void read_subsurface(InputLines& lines, ContactCase& next);

}  // namespace rollfem::convert
