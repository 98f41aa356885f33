// SPDX-License-Identifier: LGPL-2.1-or-later
// results.h5: the trees of a result as groups.
#include "result/hdf5/hdf5_objects.hpp"
#include "result/write/contents.hpp"

#include <fmt/core.h>

#include <array>

namespace rollfem::result {
namespace {

using namespace hdf5;

const char* const conventions =
    "mm, N, MPa, s, rad. x: rolling direction, material enters at large x; y: lateral; z: normal, "
    "into the wheel. Tractions and forces act on the wheel. Displacement difference and slip: "
    "wheel "
    "minus rail. traction_coefficient = -F_x / F_z.";

void write_entry(hid_t group, const Entry& entry) {
  if (const auto* array = std::get_if<Array>(&entry.values)) {
    const std::array<hid_t, 4> types{H5T_NATIVE_DOUBLE, H5T_NATIVE_FLOAT, H5T_NATIVE_INT,
                                     H5T_NATIVE_UCHAR};
    const Handle dataset =
        write_dataset(group, entry.name, Shape(array->shape.begin(), array->shape.end()),
                      types[static_cast<std::size_t>(array->type)], array->first);
    describe(dataset, entry.unit, entry.description, entry.sign);
    return;
  }
  const auto* text = std::get_if<std::string>(&entry.values);
  write_comment(text != nullptr ? write_dataset(group, entry.name, *text)
                                : write_dataset(group, entry.name,
                                                std::get<std::vector<std::string>>(entry.values)),
                entry.description);
}

Handle write(hid_t parent, const Tree& tree);

void write_into(hid_t group, const Tree& tree) {
  for (const auto& [name, value] : tree.attributes)
    std::visit(
        [&, &called = name](const auto& each) {
          if constexpr (std::is_same_v<decltype(each), const bool&>)
            write_attribute(group, called, each ? 1L : 0L);
          else
            write_attribute(group, called, each);
        },
        value);
  for (const Entry& entry : tree.entries) write_entry(group, entry);
  for (const Tree& part : tree.parts) write(group, part);
}

Handle write(hid_t parent, const Tree& tree) {
  Handle group = create_group(parent, tree.name, tree.comment);
  write_into(group, tree);
  return group;
}

void write_model(hid_t models, const contact::ModelResult& model, long order,
                 const contact::Case& input) {
  const Handle group = write(models, model_tree(model, input));
  write_attribute(group, "model", model.name);
  write_attribute(group, "order", order);
  const Handle points = create_group(group, "points", "Load points in the order of the case");
  for (std::size_t k = 0; k < model.points.size(); ++k)
    write(points, point_tree(model, k, input.output.keeps_grid(k, model.points.size())));
  // The values of bodies at the last load point that stores them stand beside their nodes, too.
  const std::vector<std::size_t> kept = model.points_with_bodies();
  for (const contact::BodyField& body : model.bodies)
    for (const char* name : {"displacement", "stress"})
      if (!kept.empty())
        link(group, fmt::format("points/{:04}/bodies/{}/{}", kept.back(), body.name, name),
             open_group(group, "bodies/" + body.name), name);
}

}  // namespace

std::string results_hdf5(const RunRecord& run) {
  const File file = create_file_in_memory();
  write_comment(file, std::string("rollfem result, layout: docs/results.md. ") + conventions);
  write_attribute(file, "format", std::string("rollfem results"));
  write_attribute(file, "format_version", static_cast<long>(hdf5_format_version));
  write_attribute(file, "format_minor", static_cast<long>(hdf5_format_minor));
  write_attribute(file, "conventions", std::string(conventions));
  write_into(file, head_tree(run));
  {
    const Handle models = create_group(
        file, "models",
        "One group per model; with profiles per model and patch, MODEL_SIDE_POSITION_PATCH");
    for (std::size_t k = 0; k < run.models.size(); ++k)
      write_model(models, run.models[k], static_cast<long>(k), run.input);
  }
  // Written last, so that a reader recognises incomplete files.
  write_attribute(file, "complete", 1L);
  return sealed_image(file);
}

}  // namespace rollfem::result
