// SPDX-License-Identifier: LGPL-2.1-or-later
// Output, tables, and points below the surface: [[subsurface.*]].
#include "case/keys/key_builder.hpp"

#include <algorithm>

namespace rollfem::contact {

namespace {

SectionWithKeys output_section() {
  Keys<OutputOptions> keys("output", "Output beside summary.json and results.h5", &Case::output);
  keys.add("paths", &OutputOptions::paths, among({"x", "y"}), or_empty,
           "Centre lines along which tractions are written and drawn.");
  keys.add("fields", &OutputOptions::fields,
           "Write ParaView files of `grid_fields` and `body_fields`.");
  keys.add("grid_fields", &OutputOptions::grid_fields,
           {{"auto", GridFields::automatic},
            {"all", GridFields::all},
            {"some", GridFields::some},
            {"none", GridFields::none}},
           "Load points that keep fields on the contact grid, which figures and rollfem stress "
           "need: `some` is 25, `auto` all of up to 100 per model and patch, otherwise `some`.");
  keys.add("body_fields", &OutputOptions::body_fields,
           {{"all", BodyFields::all}, {"last", BodyFields::last}, {"none", BodyFields::none}},
           "Load points that keep displacement and stress of wheel and rail (model fem), for "
           "rollfem stress; each takes some 12 MB and doubles the time.");
  keys.add("stress_maxima", &OutputOptions::stress_maxima,
           "Largest von Mises, Tresca, orthogonal shear and principal stress of both bodies, with "
           "positions.");
  return keys;
}

SectionWithKeys table_section() {
  Keys<TableOptions> keys("table", "Grid of `rollfem table`; other commands ignore it",
                          &Case::table);
  keys.add("axis_ratio", &TableOptions::axis_ratio, ascending, symbol("a/b"), between(0.02, 50.0),
           otherwise("that of the case"), "Increasing axis ratios, a along rolling.");
  keys.add("lateral_shift", &TableOptions::lateral_shift, ascending, unit("mm"), within(1e3),
           otherwise("axis_ratio applies"),
           "Increasing lateral shifts, for a wheel with profiles.");
  keys.add("lateral_shift_step", &TableOptions::lateral_shift_step, unit("mm"), between(1e-3, 1e3),
           otherwise("all are listed"), "Step between the two shifts of lateral_shift.");
  keys.add("load", &TableOptions::load, ascending, unit("N"), between(1e-6, largest_force),
           otherwise("that of the case"),
           "Increasing loads as an axis; for ellipses with a memory or a layer.");
  keys.add("speed", &TableOptions::speed, ascending, unit("mm/s"), between(1e-3, 1e8),
           otherwise("rolling.speed"), "Increasing speeds as an axis, under a falling law.");
  keys.add("points", &TableOptions::points, between(2, 200),
           otherwise("16, 16, 31; over lateral shifts 8, 8, 15"),
           "Grid points along xi', eta' (from 0; over lateral shifts mirrored) and phi' (both "
           "signs; an odd number includes 0).");
  keys.add("largest", &TableOptions::largest, between(0.01, 1000.0),
           "Largest xi', eta' and phi'; beyond, full sliding is assumed (refused with a falling "
           "law or a layer).");
  const auto of_lists = zero_or(smallest, 1000.0);
  const auto from_points = otherwise("from points and largest");
  keys.add("longitudinal_values", &TableOptions::longitudinal, ascending, symbol("xi'"), of_lists,
           from_points,
           "Scaled longitudinal creepages (docs/tables.md) from 0, instead of points and largest; "
           "over lateral shifts mirrored.");
  keys.add("lateral_values", &TableOptions::lateral, ascending, symbol("eta'"), of_lists,
           from_points, "The same for lateral creepage.");
  keys.add("spin_values", &TableOptions::spin, ascending, symbol("phi'"), of_lists, from_points,
           "The same for spin; mirrored.");
  keys.add("check_points", &TableOptions::check_points, between(0, 1e6),
           "Random points at which the interpolation error is evaluated.");
  return keys;
}

using Request = SubsurfaceRequest;
using RequestKeys = Keys<Request>;
using Corner = std::array<double, 3> Request::*;

/// The last request of that kind, nullptr if none.
const Request* last_of(const Case& input, Request::Kind kind) {
  const auto& all = input.subsurface;
  const auto found = std::find_if(all.rbegin(), all.rend(),
                                  [kind](const Request& request) { return request.kind == kind; });
  return found == all.rend() ? nullptr : &*found;
}

RequestKeys section_of(const std::string& name, const std::string& sentence, Request::Kind kind) {
  RequestKeys keys("subsurface." + name, sentence,
                   {[kind](const Case& c) { return last_of(c, kind); },
                    [kind](Case& c) -> Request& {
                      if (last_of(c, kind) == nullptr) c.subsurface.emplace_back().kind = kind;
                      return const_cast<Request&>(*last_of(c, kind));
                    }});
  keys.section().repeated = true;
  keys.section().alternatives = true;
  return keys;
}

void add_body(RequestKeys& keys, const std::string& sentence) {
  keys.add("body", &Request::wheel, {{"rail", false}, {"wheel", true}}, example("\"wheel\""),
           otherwise("wheel"), sentence);
}

constexpr const char* around_points =
    "z >= 0 in the wheel, z <= 0 in the rail; with hybrid and fem a concave body extends beyond z "
    "= 0.";

void add_corner(RequestKeys& keys, const std::string& name, const std::string& sentence,
                Corner corner) {
  keys.add(name, corner, unit("mm"), within(1e6), Required{"[0.0, 0.0, 3.0]"}, sentence);
}

/// An end of a line on the surface, with x and y only.
void add_end(RequestKeys& keys, const std::string& name, const std::string& sentence,
             Corner corner) {
  keys.add(
      KeyKind::pair, name,
      Access<Request>{[corner](const Request& r) {
                        return Numbers{(r.*corner)[0], (r.*corner)[1]};
                      },
                      [corner](Request& r, const KeyValue& value) { assign(r.*corner, value); }},
      unit("mm"), within(1e6), Required{"[0.0, 5.0]"}, sentence);
}

void add_number_of_points(RequestKeys& keys, const std::string& sentence) {
  keys.add(
      "points", [](auto& request) -> auto& { return request.points[0]; }, between(2, 10000),
      Required{"61"}, sentence);
}

SectionWithKeys subsurface_point_section() {
  RequestKeys keys =
      section_of("point", "A point below the surface (models halfspace, hybrid and fem)",
                 Request::Kind::point);
  add_body(keys, around_points);
  add_corner(keys, "at", "The point, [x, y, z].", &Request::from);
  return keys;
}

SectionWithKeys subsurface_line_section() {
  RequestKeys keys = section_of("line", "A line of points below the surface", Request::Kind::line);
  add_body(keys, around_points);
  add_corner(keys, "from", "One end of the line, [x, y, z].", &Request::from);
  add_corner(keys, "to", "The other end.", &Request::to);
  add_number_of_points(keys, "Equally spaced points, ends included.");
  return keys;
}

SectionWithKeys subsurface_plane_section() {
  RequestKeys keys =
      section_of("plane", "A plane of points below the surface", Request::Kind::plane);
  add_body(keys, around_points);
  add_corner(keys, "from", "One corner of the parallelogram, [x, y, z].", &Request::from);
  add_corner(keys, "to", "Corner at the end of the first side.", &Request::to);
  add_corner(keys, "across", "Corner at the end of the second side.", &Request::across);
  keys.add("points", &Request::points, between(2, 10000), Required{"[41, 21]"},
           "Points along each side.");
  return keys;
}

SectionWithKeys subsurface_surface_section() {
  RequestKeys keys = section_of("surface", "A line on or below the contact surface of a body",
                                Request::Kind::surface);
  add_body(keys, "The body.");
  add_end(keys, "from", "One end of the line, [x, y].", &Request::from);
  add_end(keys, "to", "The other end.", &Request::to);
  keys.add("depth", &Request::depth, unit("mm"), zero_or(smallest, 1e6), example("0.0"),
           otherwise("0, on the surface"),
           "Depth below the surface: along z in the rail, towards the axle in the wheel.");
  add_number_of_points(keys, "Points equally spaced in x and y, ends included.");
  return keys;
}

}  // namespace

Sections output_sections() {
  return {output_section(),           table_section(),
          subsurface_point_section(), subsurface_line_section(),
          subsurface_plane_section(), subsurface_surface_section()};
}

void begin_entry(Case& input, const std::string& section) {
  Request& request = input.subsurface.emplace_back();
  for (const auto kind :
       {Request::Kind::point, Request::Kind::line, Request::Kind::plane, Request::Kind::surface})
    if (section == std::string("subsurface.") + word_of(kind)) request.kind = kind;
}

}  // namespace rollfem::contact
