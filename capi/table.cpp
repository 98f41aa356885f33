// rollfem.h: tables of creep forces.
#include "capi/guarded.hpp"
#include "postprocess/table/table_files.hpp"

#include "rollfem/rollfem.h"

struct rollfem_table {
  rollfem::postprocess::CreepTableReader reader;
};

extern "C" {

rollfem_table* rollfem_table_open(const char* path, char* message, size_t size) {
  rollfem_table* made = nullptr;
  rollfem::capi::guarded(
      [&] {
        if (path == nullptr || *path == '\0')
          throw rollfem::contact::InputError("the table is not given; do: name its file");
        made = new rollfem_table{
            rollfem::postprocess::CreepTableReader(rollfem::postprocess::read_table(path))};
      },
      message, size);
  return made;
}

rollfem_status rollfem_table_forces(const rollfem_table* table, const rollfem_ellipse* ellipse,
                                    rollfem_creep_forces* forces, char* message, size_t size) {
  *forces = rollfem_creep_forces{};
  return rollfem::capi::guarded(
      [&] {
        const auto found = table->reader.physical(
            ellipse->semi_axis_x, ellipse->semi_axis_y, ellipse->shear_modulus,
            ellipse->friction_bound,
            {ellipse->longitudinal_creepage, ellipse->lateral_creepage, ellipse->spin});
        *forces = {found.forces[0], found.forces[1], found.forces[2], found.force_bar,
                   found.moment_bar};
      },
      message, size);
}

void rollfem_table_close(rollfem_table* table) {
  delete table;
}

}  // extern "C"
