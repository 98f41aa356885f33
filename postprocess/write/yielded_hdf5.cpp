// SPDX-License-Identifier: LGPL-2.1-or-later
#include "postprocess/write/yielded_hdf5.hpp"

namespace rollfem::postprocess {

using namespace hdf5;

void write_yielded(hid_t point, const std::vector<contact::YieldedSection>& bodies) {
  if (bodies.empty()) return;
  const Handle all = create_group(point, "yielded",
                                  "Bodies that yield after this pass: the section behind the load, "
                                  "streamlines [down, across] with y fastest");
  for (const contact::YieldedSection& body : bodies) {
    const Handle group = create_group(all, body.body, "Attributes: the pass as a whole");
    write_attribute(group, "verdict", body.verdict);
    write_attribute(group, "from_pass", static_cast<long>(body.from_pass));
    write_attribute(group, "iterations", static_cast<long>(body.iterations));
    for (const auto& [name, value] : contact::scalars_of(body)) write_attribute(group, name, value);
    write_attribute(group, "across", static_cast<long>(body.across));
    write_attribute(group, "down", static_cast<long>(body.down));
    write_values(group, "y", body.y, "mm", "of the streamlines");
    write_values(group, "depth", body.depth, "mm", "of the streamlines, below the surface");
    write_rows(group, "strain", body.strain, "-",
               "plastic strain xx, yy, zz, xy, yz, xz (tensor components), x along rolling");
    write_rows(group, "stress", body.stress, "MPa",
               "residual stress xx, yy, zz, xy, yz, xz; tension positive");
    write_values(group, "accumulated",
                 std::vector<double>(body.accumulated.begin(), body.accumulated.end()), "-",
                 "accumulated plastic strain");
    write_values(group, "surface_y", body.surface_y, "mm", "of groove and forward_flow");
    write_values(group, "groove", body.groove, "mm",
                 "plastic displacement of the surface, negative into the body");
    write_values(group, "forward_flow", body.forward_flow, "mm",
                 "plastic displacement of the surface along rolling");
  }
}

void write_stress_before(hid_t group, const contact::Case& input) {
  for (const auto& [name, steel] : {std::pair("wheel_stress_before", &input.wheel.plasticity),
                                    std::pair("rail_stress_before", &input.rail.plasticity)}) {
    if (!*steel || (*steel)->residual.depth.empty()) continue;
    const auto& [depth, along, across, file] = (*steel)->residual;
    std::vector<double> rows;
    for (std::size_t k = 0; k < depth.size(); ++k)
      rows.insert(rows.end(),
                  {depth[k], along.empty() ? 0.0 : along[k], across.empty() ? 0.0 : across[k]});
    const Handle table =
        write_dataset(group, name, {depth.size(), 3}, H5T_NATIVE_DOUBLE, rows.data());
    write_comment(table, "Depth, mm; residual stress along and across before the first pass, MPa");
  }
}

}  // namespace rollfem::postprocess
