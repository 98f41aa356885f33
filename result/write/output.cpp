// SPDX-License-Identifier: LGPL-2.1-or-later
#include "result/write/output.hpp"

#include "base/threads.hpp"
#include "case/reading/case_reader.hpp"
#include "result/files/checkpoint_folder.hpp"
#include "result/files/result_folder.hpp"
#include "result/hdf5/hdf5_objects.hpp"
#include "result/patch_size.hpp"
#include "result/write/csv.hpp"
#include "result/write/json_head.hpp"
#include "result/write/vtu.hpp"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <functional>
#include <utility>
#include <vector>

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
    write(points, point_tree(model, k, keeps_grid(input, model, k)));
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

namespace {

using nlohmann::ordered_json;

ordered_json point_json(const contact::ModelResult& model, std::size_t number) {
  ordered_json json = json_of(point_tree(model, number, false));
  const contact::PointResult& point = model.points[number];
  if (point.patch_count > 1)
    for (const contact::PatchPart& part : contact::patch_parts(model.grid, point.fields)) {
      ordered_json& entry = json["patches"].emplace_back(ordered_json::object());
      contact::for_members(part, [&](const auto& each, double value) { entry[each.name] = value; });
      // Regions are distinguished only on the finest grid.
      entry["no_bar"] = word_of(contact::NoBar::one_grid);
    }
  return json;
}

ordered_json model_json(const contact::ModelResult& model, const contact::Case& input) {
  ordered_json json{{"name", model.name}};
  json.update(json_of(model_tree(model, input)));
  if (!model.choice.empty()) json["chosen_by"] = "auto";
  json["headline"] = headline(model);
  json["points"] = ordered_json::array();
  for (std::size_t k = 0; k < model.points.size(); ++k)
    json["points"].push_back(point_json(model, k));
  return json;
}

}  // namespace

std::string summary_json(const RunRecord& run) {
  ordered_json json;
  json["format"] = 3;
  json["title"] = run.input.title;
  json["case_file"] = run.input.file;
  json["case_checksum"] = checksum_of_case(run.input);
  json["program"] = {{"version", run.provenance.version}, {"commit", run.provenance.commit}};
  json["verdict"] = run.verdict;
  json.update(json_of(dips_tree(run)));
  json["models"] = ordered_json::array();
  for (const contact::ModelResult& model : run.models)
    json["models"].push_back(model_json(model, run.input));
  return json_text(json, 2);
}

namespace {

/// Files that are independent of each other: compressing them takes long.
using Jobs = std::vector<std::function<void()>>;

/// Writes the contact surface of every load point that stores it, their series, and the last one
/// under a separate name.
void write_contact(ResultFolder& folder, const contact::ModelResult& model,
                   const contact::Case& input, Jobs& jobs) {
  const std::string stem = "fields/" + model.key() + "_contact";
  const std::vector<double> all = series_times(model.points);
  std::vector<double> times;
  std::vector<std::vector<std::string>> files;
  std::vector<std::size_t> kept;
  for (std::size_t k = 0; k < model.points.size(); ++k) {
    if (model.points[k].fields.traction.n.size() == 0) continue;
    if (!keeps_grid(input, model, k)) continue;
    files.push_back({fmt::format("{}_contact_{:04}.vtu", model.key(), k)});
    times.push_back(all[k]);
    kept.push_back(k);
  }
  if (kept.empty()) return;
  for (const std::size_t k : kept)
    jobs.emplace_back([&folder, &model, stem, k, last = kept.back()] {
      const std::string content = contact_vtu(model.grid, model.points[k]);
      folder.write(fmt::format("{}_{:04}.vtu", stem, k), content);
      if (k == last) folder.write(stem + ".vtu", content);
    });
  folder.write(stem + ".pvd", series_pvd(times, files));
}

/// The same for wheel and rail of every load point that stores them.
void write_body_files(ResultFolder& folder, const contact::ModelResult& model, Jobs& jobs) {
  const std::vector<std::size_t> kept = model.points_with_bodies();
  if (kept.empty()) return;
  std::vector<std::vector<std::string>> files(kept.size());
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const std::string stem = model.key() + "_" + model.bodies[b].name;
    for (std::size_t k = 0; k < kept.size(); ++k)
      files[k].push_back(fmt::format("{}_{:04}.vtu", stem, kept[k]));
    jobs.emplace_back([&folder, &model, kept, b, stem = "fields/" + stem] {
      const BodyVtu body(model.bodies[b]);
      for (const std::size_t k : kept) {
        const std::string content = body.text(&model.points[k].bodies[b]);
        folder.write(fmt::format("{}_{:04}.vtu", stem, k), content);
        if (k == kept.back()) folder.write(stem + ".vtu", content);
      }
    });
  }
  const std::vector<double> all = series_times(model.points);
  std::vector<double> times;
  for (const std::size_t k : kept) times.push_back(all[k]);
  folder.write("fields/" + model.key() + "_bodies.pvd", series_pvd(times, files));
}

}  // namespace

void write_results(const std::string& directory, const RunRecord& run) {
  check_record(run);
  ResultFolder folder(directory);
  const auto asks = [&](const char* path) {
    const auto& paths = run.input.output.paths;
    return std::count(paths.begin(), paths.end(), path) > 0;
  };
  folder.write("case.toml", contact::text_in_folder(run.input, directory));
  folder.write("summary.json", summary_json(run));
  const std::pair<const char*, std::string> tables[] = {
      {"creep_curve.csv", creep_curve_csv(run)},
      {"path_x.csv", asks("x") ? path_csv(run, Path::x) : ""},
      {"path_y.csv", asks("y") ? path_csv(run, Path::y) : ""},
      {"subsurface.csv", subsurface_csv(run)},
      {"contacts.csv", contacts_csv(run)},
      {"wheelset.csv", wheelset_csv(run)},
      {"wheelset_rigid.csv",
       run.rigid_row.empty() ? "" : rigid_wheelset_columns().table(run.rigid_row)},
      {"patches.csv", patches_csv(run)},
      {"pass_work.csv", pass_work_csv(run)}};
  for (const auto& [name, text] : tables)
    if (!text.empty()) folder.write(name, text);
  Jobs jobs{[&] { folder.write("results.h5", results_hdf5(run)); }};
  if (run.input.output.fields)
    for (const contact::ModelResult& model : run.models) {
      write_contact(folder, model, run.input, jobs);
      write_body_files(folder, model, jobs);
    }
  contact::for_each_index(jobs.size(), [&](std::size_t k) { jobs[k](); });
  folder.commit();
}

}  // namespace rollfem::result
