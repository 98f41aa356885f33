// SPDX-License-Identifier: LGPL-2.1-or-later
// Implements rollfem.h: tables of creep forces.
#include "capi/guarded.hpp"
#include "capi/units.hpp"
#include "tables/files/table_files.hpp"

#include "rollfem/rollfem.h"
#include <cstddef>

struct rollfem_table {
  rollfem::tables::CreepTableReader reader;
};

using rollfem::capi::Given;
using rollfem::capi::taken;
using rollfem::capi::units_of;
using rollfem::capi::wanted;

namespace {

const rollfem::tables::CreepTableReader& reader_of(const rollfem_table* table) {
  return wanted(table, "table", "what rollfem_table_open returned").reader;
}

}  // namespace

extern "C" {

rollfem_table* rollfem_table_open(const char* path, char* message, size_t size) {
  rollfem_table* made = nullptr;
  rollfem::capi::guarded(
      [&] {
        if (path == nullptr || *path == '\0')
          throw rollfem::contact::InputError("no table given; do: name its file");
        made =
            new rollfem_table{rollfem::tables::CreepTableReader(rollfem::tables::read_table(path))};
      },
      message, size);
  return made;
}

rollfem_status rollfem_table_forces(const rollfem_table* table, const rollfem_ellipse* ellipse,
                                    rollfem_creep_forces* forces, char* message, size_t size) {
  Given<rollfem_creep_forces> result(forces);
  return rollfem::capi::guarded(
      [&] {
        const rollfem_ellipse of =
            taken(ellipse, "ellipse", "an ellipse", offsetof(rollfem_ellipse, speed));
        const auto found = reader_of(table).physical(
            of.semi_axis_x, of.semi_axis_y, of.shear_modulus, of.friction_bound,
            {of.longitudinal_creepage, of.lateral_creepage, of.spin}, of.speed);
        result.check("forces", "a place for the forces");
        result.give({0, found.forces[0], found.forces[1], found.forces[2], found.force_bar,
                     found.moment_bar});
      },
      message, size);
}

rollfem_status rollfem_table_wheel_forces(const rollfem_table* table,
                                          const rollfem_shifted_wheel* wheel,
                                          rollfem_wheel_forces* forces, char* message,
                                          size_t size) {
  Given<rollfem_wheel_forces> result(forces);
  return rollfem::capi::guarded(
      [&] {
        const rollfem_shifted_wheel of = taken(wheel, "wheel", "a wheel at a lateral shift",
                                               offsetof(rollfem_shifted_wheel, load));
        const auto& reader = reader_of(table);
        const auto [length, newtons] = units_of(of.units);
        const rollfem::tables::TablePlace asked{length * of.lateral_shift, newtons * of.load,
                                                length * of.speed};
        const auto place = reader.wheel_at({asked.first, asked.load});
        const double own = reader.table().friction_coefficient * place.normal_force;
        const double bound = of.friction_bound == 0.0 ? own : newtons * of.friction_bound;
        const auto found = reader.of_wheel(
            asked, bound, {of.longitudinal_creepage, of.lateral_creepage, of.spin / length});
        const double moment = newtons * length;
        result.check("forces", "a place for the forces");
        result.give({0, found.forces[0] / newtons, found.forces[1] / newtons,
                     found.along_normal / newtons, found.forces[2] / moment,
                     found.force_bar / newtons, found.moment_bar / moment, bound / newtons,
                     place.normal_force / newtons, place.contact_angle,
                     place.rolling_radius / length, place.jump_after != 0.0});
      },
      message, size);
}

void rollfem_table_close(rollfem_table* table) {
  delete table;
}

}  // extern "C"
