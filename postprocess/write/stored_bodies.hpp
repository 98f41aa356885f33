// SPDX-License-Identifier: LGPL-2.1-or-later
// Wheel and rail in results.h5: nodes and cells once per model, nodal displacement and stress at
// every load point that stores them. Layout: docs/results.md.
#pragma once

#include "contact/result/result.hpp"
#include "postprocess/hdf5/hdf5_objects.hpp"

#include <cstddef>
#include <vector>

namespace rollfem::postprocess {

/// Writes points/NUMBER/bodies of a load point, if it stores bodies. `bodies`: ModelResult::bodies.
void write_body_values(hid_t point, const std::vector<contact::BodyField>& bodies,
                       const contact::PointResult& result);

/// Writes MODEL/bodies, after all load points.
void write_bodies(hid_t model, const contact::ModelResult& result);

/// Load points of a stored model that have bodies, from 0.
std::vector<std::size_t> points_with_bodies(hid_t model);

/// Reads nodes and cells. std::runtime_error if they are inconsistent.
std::vector<contact::BodyField> read_bodies(hid_t model);

/// Reads displacement and stress of `bodies` at a load point of points_with_bodies().
/// std::runtime_error if their number differs from that of the nodes.
std::vector<contact::BodyValues> read_body_values(hid_t model, std::size_t point,
                                                  const std::vector<contact::BodyField>& bodies);

}  // namespace rollfem::postprocess
