// The axes of a table, from the section [table] of a case.
#pragma once

#include "contact/case/case.hpp"
#include "postprocess/table/creep_table.hpp"

namespace rollfem::app {

/// A table without forces. Throws contact::InputError where the lists do not increase, the bodies
/// are of unlike materials, or there is no ellipse whose ratio could be taken.
postprocess::CreepTable empty_table(const contact::Case& input);

}  // namespace rollfem::app
