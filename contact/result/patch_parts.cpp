#include "contact/result/patch_parts.hpp"

#include "contact/result/patch_size.hpp"
#include "contact/result/result.hpp"

#include <algorithm>
#include <utility>

namespace rollfem::contact {

namespace {

/// Number of the region of each element from 1, 0 outside; and how many there are.
std::pair<std::vector<int>, int> labelled(const ContactGrid& grid, const Field& pressure) {
  std::vector<int> label(static_cast<std::size_t>(grid.size()), 0);
  std::vector<std::array<int, 2>> open;
  int count = 0;
  const auto take = [&](int i, int j) {
    if (i < 0 || j < 0 || i >= grid.nx || j >= grid.ny) return;
    const int k = grid.index(i, j);
    int& here = label[static_cast<std::size_t>(k)];
    if (here != 0 || !(pressure[k] > 0.0)) return;
    here = count;
    open.push_back({i, j});
  };
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const int k = grid.index(i, j);
      if (label[static_cast<std::size_t>(k)] != 0 || !(pressure[k] > 0.0)) continue;
      ++count;
      take(i, j);
      while (!open.empty()) {
        const auto [x, y] = open.back();
        open.pop_back();
        for (int v = -1; v <= 1; ++v)
          for (int u = -1; u <= 1; ++u) take(x + u, y + v);
      }
    }
  return {std::move(label), count};
}

double sum_over(const Field& values, const Field& mask) {
  return values.size() == mask.size() ? values.dot(mask) : 0.0;
}

}  // namespace

int count_parts(const ContactGrid& grid, const Field& pressure) {
  return labelled(grid, pressure).second;
}

std::vector<PatchPart> patch_parts(const ContactGrid& grid, const ContactFields& fields) {
  const SurfaceField& traction = fields.traction;
  if (traction.n.size() != grid.size()) return {};
  const auto [label, count] = labelled(grid, traction.n);
  const Field x = grid.sample([](double at, double) { return at; });
  const Field y = grid.sample([](double, double at) { return at; });
  std::vector<PatchPart> parts;
  for (int number = 1; number <= count; ++number) {
    Field mask = Field::Zero(grid.size());
    for (int k = 0; k < grid.size(); ++k)
      if (label[static_cast<std::size_t>(k)] == number) mask[k] = 1.0;
    const Field pressure = traction.n.cwiseProduct(mask);
    const PatchSize size = patch_size(grid, pressure);
    const double sum = pressure.sum();
    PatchPart part;
    part.x = x.dot(pressure) / sum;
    part.y = y.dot(pressure) / sum;
    part.length = size.length;
    part.width = size.width;
    part.normal_force = grid.element_area() * sum;
    part.longitudinal_force = grid.element_area() * sum_over(traction.x, mask);
    part.lateral_force = grid.element_area() * sum_over(traction.y, mask);
    part.max_pressure = pressure.maxCoeff();
    parts.push_back(part);
  }
  std::stable_sort(parts.begin(), parts.end(), [](const PatchPart& a, const PatchPart& b) {
    return a.normal_force > b.normal_force;
  });
  return parts;
}

}  // namespace rollfem::contact
