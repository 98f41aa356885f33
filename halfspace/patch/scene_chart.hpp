// What a contact grid of half-spaces lies on: the plane of the patch or the common surface.
#pragma once

#include "contact/scene/scene.hpp"

namespace rollfem::halfspace {

/// The scene as the contact grid of the model lies on it. Throws contact::InputError where the
/// common surface is asked for and not known.
contact::ChartedGeometry halfspace_geometry(const contact::Scene& scene);

}  // namespace rollfem::halfspace
