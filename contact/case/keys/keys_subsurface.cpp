// SPDX-License-Identifier: LGPL-2.1-or-later
// [[subsurface.*]]: any number of subsurface points.
#include "contact/case/keys/key_builder.hpp"

#include <algorithm>

namespace rollfem::contact {

namespace {

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
  keys.choice("body")
      .example("\"wheel\"")
      .otherwise("wheel")
      .says(sentence)
      .into(&Request::wheel, {{"rail", false}, {"wheel", true}});
}

void add_body_around_points(RequestKeys& keys) {
  add_body(keys,
           "Body of the points: z >= 0 in the wheel, z <= 0 in the rail; with hybrid and fem a "
           "concave body extends beyond z = 0 to its surface.");
}

void add_corner(RequestKeys& keys, const std::string& name, const std::string& sentence,
                Corner corner) {
  keys.triple(name).unit("mm").within(1e6).required("[0.0, 0.0, 3.0]").says(sentence).into(corner);
}

/// An end of a line on the surface, with x and y only.
void add_end(RequestKeys& keys, const std::string& name, const std::string& sentence,
             Corner corner) {
  keys.pair(name)
      .unit("mm")
      .within(1e6)
      .required("[0.0, 5.0]")
      .says(sentence)
      .by(
          [corner](const Request& r) {
            return Numbers{(r.*corner)[0], (r.*corner)[1]};
          },
          [corner](Request& r, const KeyValue& value) { assign(r.*corner, value); });
}

void add_number_of_points(RequestKeys& keys, const std::string& sentence) {
  keys.integer("points").between(2, 10000).required("61").says(sentence).into(
      [](auto& request) -> auto& { return request.points[0]; });
}

}  // namespace

SectionWithKeys subsurface_point_section() {
  RequestKeys keys =
      section_of("point", "A point below the surface (models halfspace, hybrid and fem)",
                 Request::Kind::point);
  add_body_around_points(keys);
  add_corner(keys, "at", "The point, [x, y, z].", &Request::from);
  return keys;
}

SectionWithKeys subsurface_line_section() {
  RequestKeys keys = section_of("line", "A line of points below the surface", Request::Kind::line);
  add_body_around_points(keys);
  add_corner(keys, "from", "One end of the line, [x, y, z].", &Request::from);
  add_corner(keys, "to", "The other end.", &Request::to);
  add_number_of_points(keys, "Equally spaced points, both ends included.");
  return keys;
}

SectionWithKeys subsurface_plane_section() {
  RequestKeys keys =
      section_of("plane", "A plane of points below the surface", Request::Kind::plane);
  add_body_around_points(keys);
  add_corner(keys, "from", "One corner of the plane, a parallelogram, [x, y, z].", &Request::from);
  add_corner(keys, "to", "Corner at the end of the first side.", &Request::to);
  add_corner(keys, "across", "Corner at the end of the second side from `from`.", &Request::across);
  keys.pair("points")
      .between(2, 10000)
      .required("[41, 21]")
      .says("Points along the first and along the second side.")
      .into(&Request::points);
  return keys;
}

SectionWithKeys subsurface_surface_section() {
  RequestKeys keys =
      section_of("surface", "A line that follows the contact surface of a body, on it or below it",
                 Request::Kind::surface);
  add_body(keys, "The body whose surface is followed.");
  add_end(keys, "from", "One end of the line, [x, y].", &Request::from);
  add_end(keys, "to", "The other end.", &Request::to);
  keys.real("depth")
      .unit("mm")
      .zero_or(smallest, 1e6)
      .example("0.0")
      .otherwise("0, on the surface")
      .says(
          "Depth of the line below the surface: along z in the rail, towards the axle in the "
          "wheel.")
      .into(&Request::depth);
  add_number_of_points(keys, "Points equally spaced in x and y, both ends included.");
  return keys;
}

void begin_entry(Case& input, const std::string& section) {
  Request& request = input.subsurface.emplace_back();
  for (const auto kind :
       {Request::Kind::point, Request::Kind::line, Request::Kind::plane, Request::Kind::surface})
    if (section == std::string("subsurface.") + word_of(kind)) request.kind = kind;
}

}  // namespace rollfem::contact
