// Declarations of the options of the theories, and of the points below the surface.
#include "contact/case/case_key_parts.hpp"

namespace rollfem::contact {

namespace {

using Triple = std::array<double, 3>;
using Kind = SubsurfaceRequest::Kind;

const std::string point_section = "subsurface.point";
const std::string line_section = "subsurface.line";
const std::string plane_section = "subsurface.plane";
const std::string surface_section = "subsurface.surface";

Kind kind_of(const std::string& section) {
  if (section == point_section) return Kind::point;
  if (section == line_section) return Kind::line;
  return section == plane_section ? Kind::plane : Kind::surface;
}

/// The last request of that kind, nullptr when there is none.
const SubsurfaceRequest* last_of(const Case& input, Kind kind) {
  const auto& all = input.subsurface;
  const auto found =
      std::find_if(all.rbegin(), all.rend(),
                   [kind](const SubsurfaceRequest& request) { return request.kind == kind; });
  return found == all.rend() ? nullptr : &*found;
}

/// The request that is being filled; a first one is made where there is none.
SubsurfaceRequest& current(Case& input, const std::string& section) {
  if (last_of(input, kind_of(section)) == nullptr) begin_entry(input, section);
  return const_cast<SubsurfaceRequest&>(*last_of(input, kind_of(section)));
}

Key place_key(const std::string& section, const std::string& name, const std::string& sentence,
              Triple SubsurfaceRequest::*member) {
  Key key;
  key.section = section;
  key.name = name;
  key.kind = KeyKind::triple;
  key.unit = "mm";
  key.bounds = {0.0, 1e6, false, true};
  key.required = true;
  key.example = "[0.0, 0.0, 3.0]";
  key.sentence = sentence;
  key.get = [section, member](const Case& c) -> KeyValue {
    const SubsurfaceRequest* request = last_of(c, kind_of(section));
    if (request == nullptr) return {};
    return Numbers((request->*member).begin(), (request->*member).end());
  };
  key.set = [section, member](Case& c, const KeyValue& v) {
    const auto& at = std::get<Numbers>(v);
    current(c, section).*member = {at.at(0), at.at(1), at.at(2)};
  };
  return key;
}

/// An end of a line on the surface, [x, y].
Key surface_place_key(const std::string& name, const std::string& sentence,
                      Triple SubsurfaceRequest::*member) {
  Key key = place_key(surface_section, name, sentence, member);
  key.kind = KeyKind::pair;
  key.example = "[0.0, 5.0]";
  key.get = [member](const Case& c) -> KeyValue {
    const SubsurfaceRequest* request = last_of(c, Kind::surface);
    if (request == nullptr) return {};
    const Triple& at = request->*member;
    return Numbers{at[0], at[1]};
  };
  key.set = [member](Case& c, const KeyValue& v) {
    const auto& at = std::get<Numbers>(v);
    current(c, surface_section).*member = {at.at(0), at.at(1), 0.0};
  };
  return key;
}

Key depth_key() {
  Key key;
  key.section = surface_section;
  key.name = "depth";
  key.unit = "mm";
  key.bounds = {0.0, 1e6};
  key.when_absent = "0, on the surface";
  key.example = "0.0";
  key.sentence =
      "How far below the surface of the body the line runs: along z on the rail, towards the axle "
      "on the wheel.";
  key.get = [](const Case& c) -> KeyValue {
    const SubsurfaceRequest* request = last_of(c, Kind::surface);
    if (request == nullptr) return {};
    return request->depth;
  };
  key.set = [](Case& c, const KeyValue& v) {
    current(c, surface_section).depth = std::get<double>(v);
  };
  return key;
}

Key body_key(const std::string& section) {
  Key key;
  key.section = section;
  key.name = "body";
  key.kind = KeyKind::word;
  key.words = {"rail", "wheel"};
  key.when_absent = "wheel";
  key.example = "\"wheel\"";
  key.sentence =
      section == surface_section
          ? "The body whose surface is followed."
          : "The body in which the points lie: z >= 0 in the wheel, z <= 0 in the rail; beyond "
            "that in a concave body down to its surface (model fem).";
  key.get = [section](const Case& c) -> KeyValue {
    const SubsurfaceRequest* request = last_of(c, kind_of(section));
    if (request == nullptr) return {};
    return std::string(request->wheel ? "wheel" : "rail");
  };
  key.set = [section](Case& c, const KeyValue& v) {
    current(c, section).wheel = std::get<std::string>(v) == "wheel";
  };
  return key;
}

Key number_of_points_key(const std::string& section, KeyKind kind, const std::string& sentence) {
  Key key;
  key.section = section;
  key.name = "points";
  key.kind = kind;
  key.bounds = {2, 10000};
  key.required = true;
  key.example = kind == KeyKind::pair ? "[41, 21]" : "61";
  key.sentence = sentence;
  key.get = [section, kind](const Case& c) -> KeyValue {
    const SubsurfaceRequest* request = last_of(c, kind_of(section));
    if (request == nullptr) return {};
    if (kind == KeyKind::pair)
      return Numbers{static_cast<double>(request->points[0]),
                     static_cast<double>(request->points[1])};
    return static_cast<double>(request->points[0]);
  };
  key.set = [section, kind](Case& c, const KeyValue& v) {
    SubsurfaceRequest& request = current(c, section);
    if (kind == KeyKind::pair)
      request.points = {static_cast<int>(std::get<Numbers>(v).at(0)),
                        static_cast<int>(std::get<Numbers>(v).at(1))};
    else
      request.points = {static_cast<int>(std::get<double>(v)), 1};
  };
  return key;
}

}  // namespace

void begin_entry(Case& input, const std::string& section) {
  SubsurfaceRequest request;
  request.kind = kind_of(section);
  input.subsurface.push_back(request);
}

std::vector<Key> subsurface_keys() {
  using Request = SubsurfaceRequest;
  return {
      body_key(point_section),
      place_key(point_section, "at", "The point, [x, y, z].", &Request::from),
      body_key(line_section),
      place_key(line_section, "from", "One end of the line, [x, y, z].", &Request::from),
      place_key(line_section, "to", "The other end.", &Request::to),
      number_of_points_key(line_section, KeyKind::integer,
                           "Equally spaced points, both ends included."),
      body_key(plane_section),
      place_key(plane_section, "from", "One corner of the plane, a parallelogram, [x, y, z].",
                &Request::from),
      place_key(plane_section, "to", "Corner at the end of the first side.", &Request::to),
      place_key(plane_section, "across", "Corner at the end of the second side, beside `from`.",
                &Request::across),
      number_of_points_key(plane_section, KeyKind::pair,
                           "Points along the first and along the second side."),
      body_key(surface_section),
      surface_place_key("from", "One end of the line, [x, y].", &Request::from),
      surface_place_key("to", "The other end.", &Request::to),
      depth_key(),
      number_of_points_key(surface_section, KeyKind::integer,
                           "Points equally spaced in x and y, both ends included."),
  };
}

std::vector<Key> theory_keys() {
  const Bounds strips{8, 2000};
  const Bounds elements{4, 2000};
  return {
      word_key<BoundShape>("fastsim", "bound", {"parabolic", "elliptic"},
                          "Traction bound over the ellipse: `parabolic` 4/3 mu p0 (1 - r^2), as is "
                          "usual; `elliptic` "
                          "mu p0 sqrt(1 - r^2), that of Hertz's pressure.",
                          [](Case& c) -> BoundShape& { return c.fastsim.bound; }),
      word_key<Flexibilities>(
          "fastsim", "flexibilities", {"three", "one"},
          "Flexibility of the brushes: one for each creepage, or their mean weighted by the "
          "creepages.",
          [](Case& c) -> Flexibilities& { return c.fastsim.flexibilities; }),
      word_key<FastsimElements>(
          "fastsim", "elements", {"chord", "grid"},
          "`chord` divides every strip equally; `grid` takes elements of a common grid, as CONTACT "
          "does, which is of first order.",
          [](Case& c) -> FastsimElements& { return c.fastsim.elements; }),
      count_key("fastsim", "strips", strips, "Strips across the patch.",
                [](Case& c) -> int& { return c.fastsim.strips; }),
      count_key("fastsim", "strip_elements", elements, "Elements along each strip.",
                [](Case& c) -> int& { return c.fastsim.strip_elements; }),
      count_key("strip", "strips", {16, 2000}, "Strips across the patch.",
                [](Case& c) -> int& { return c.strip.strips; }),
      count_key("strip", "strip_elements", elements, "Elements along each strip.",
                [](Case& c) -> int& { return c.strip.strip_elements; }),
      count_key("carter", "strips", strips, "Strips across the patch.",
                [](Case& c) -> int& { return c.carter.strips; }),
  };
}

}  // namespace rollfem::contact
