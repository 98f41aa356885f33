#include "halfspace/stress/subsurface_fields.hpp"

#include "halfspace/stress/subsurface.hpp"

namespace rollfem::halfspace {

std::vector<std::array<double, 3>> subsurface_points(const contact::SubsurfaceRequest& request) {
  std::vector<std::array<double, 3>> points;
  const auto share = [](int k, int count) {
    return count > 1 ? static_cast<double>(k) / (count - 1) : 0.0;
  };
  for (int j = 0; j < request.points[1]; ++j)
    for (int i = 0; i < request.points[0]; ++i) {
      std::array<double, 3> point = request.from;
      for (int c = 0; c < 3; ++c) {
        point[c] += share(i, request.points[0]) * (request.to[c] - request.from[c]);
        if (request.points[1] > 1)
          point[c] += share(j, request.points[1]) * (request.across[c] - request.from[c]);
      }
      if (request.kind == contact::SubsurfaceRequest::Kind::surface)
        point[2] = request.wheel ? request.depth : 0.0 - request.depth;
      points.push_back(point);
    }
  return points;
}

std::vector<contact::SubsurfaceField> subsurface_fields(const contact::Scene& scene,
                                                        const contact::ContactGrid& grid,
                                                        const contact::SurfaceField& traction) {
  std::vector<contact::SubsurfaceField> fields;
  for (const contact::SubsurfaceRequest& request : scene.subsurface) {
    contact::SubsurfaceField field;
    field.request = request;
    field.points = subsurface_points(request);
    std::vector<SubsurfacePoint> points;
    for (const auto& point : field.points)
      points.push_back({point[0], point[1], request.wheel ? point[2] : 0.0 - point[2]});
    const LoadedBody body{request.wheel ? Body::wheel : Body::rail,
                          request.wheel ? scene.wheel.material : scene.rail.material, grid,
                          traction};
    for (const SubsurfaceState& state : subsurface_at(body, points)) {
      field.displacement.push_back(state.displacement);
      field.stress.push_back(state.stress.as_array());
    }
    fields.push_back(std::move(field));
  }
  return fields;
}

}  // namespace rollfem::halfspace
