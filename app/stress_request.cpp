#include "app/stress_request.hpp"

#include "contact/base/errors.hpp"
#include "contact/base/text_fields.hpp"
#include "postprocess/stress/shakedown.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

namespace rollfem::app {
namespace {

using contact::InputError;
using contact::SubsurfaceRequest;

constexpr int points_of_line = 101;
constexpr int points_of_plane = 51;
constexpr int most_points = 1000000;

/// One option of the call, for messages.
struct Option {
  std::string call;   ///< "--line 0,0,0:0,0,-5"
  std::string usage;  ///< "x,y,z:x,y,z[:n]"
  [[noreturn]] void refuse(const std::string& what) const {
    throw InputError(
        fmt::format("{}: {}; allowed: {} in mm, z > 0 in the wheel, z < 0 in the rail; "
                    "do: rollfem stress --help",
                    call, what, usage));
  }
};

std::array<double, 3> place(const Option& option, std::string_view text) {
  const auto parts = contact::parts_of(text, ",");
  std::array<double, 3> values{};
  if (parts.size() != 3) option.refuse(fmt::format("'{}' is not a point x,y,z", text));
  for (std::size_t c = 0; c < 3; ++c) {
    const std::optional<double> value = contact::number_of(parts[c]);
    if (!value) option.refuse(fmt::format("'{}' is not a number", parts[c]));
    values[c] = *value;
  }
  return values;
}

int count(const Option& option, std::string_view text) {
  const std::optional<int> value = contact::whole_number_of(text);
  if (!value || *value < 2 || *value > most_points)
    option.refuse(fmt::format("'{}' is not a number of points from 2 to {}", text, most_points));
  return *value;
}

SubsurfaceRequest shape(const Option& option, SubsurfaceRequest::Kind kind,
                        const std::string& text) {
  using Kind = SubsurfaceRequest::Kind;
  const std::size_t corners = kind == Kind::point ? 1 : kind == Kind::line ? 2 : 3;
  const auto parts = contact::parts_of(text, ":");
  const bool counted = kind != Kind::point && parts.size() == corners + 1;
  if (parts.size() != corners && !counted)
    option.refuse(fmt::format("{} points are needed", corners));
  SubsurfaceRequest request;
  request.kind = kind;
  request.from = request.to = request.across = place(option, parts[0]);
  if (kind == Kind::point) return request;
  request.to = place(option, parts[1]);
  request.points = {points_of_line, 1};
  if (kind == Kind::line) {
    if (counted) request.points[0] = count(option, parts[2]);
  } else {
    request.across = place(option, parts[2]);
    request.points = {points_of_plane, points_of_plane};
    if (counted) {
      const auto numbers = contact::parts_of(parts[3], ",");
      if (numbers.size() != 2) option.refuse(fmt::format("'{}' is not n,m", parts[3]));
      request.points = {count(option, numbers[0]), count(option, numbers[1])};
      if (static_cast<long>(request.points[0]) * request.points[1] > most_points)
        option.refuse(fmt::format("more than {} points", most_points));
    }
  }
  if (request.to == request.from || (kind == Kind::plane && request.across == request.from))
    option.refuse("two of the points coincide");
  return request;
}

/// Smallest and largest z of a request; the fourth corner of a plane counts.
std::array<double, 2> extent_of_z(const SubsurfaceRequest& request) {
  std::vector<double> z{request.from[2]};
  if (request.kind != SubsurfaceRequest::Kind::point) z.push_back(request.to[2]);
  if (request.kind == SubsurfaceRequest::Kind::plane) {
    z.push_back(request.across[2]);
    z.push_back(request.to[2] + request.across[2] - request.from[2]);
  }
  const auto [low, high] = std::minmax_element(z.begin(), z.end());
  return {*low, *high};
}

void add(const Option& option, const std::string& body, const std::string& name,
         SubsurfaceRequest request, std::vector<NamedRequest>& all) {
  const auto [low, high] = extent_of_z(request);
  if (body.empty() && low < 0.0 && high > 0.0)
    option.refuse("it passes from the rail into the wheel; request each body separately");
  for (const bool wheel : {true, false}) {
    const bool wanted =
        body.empty() ? (wheel ? low >= 0.0 : high <= 0.0) : body == (wheel ? "wheel" : "rail");
    if (!wanted) continue;
    request.wheel = wheel;
    all.push_back({name, option.call, request});
  }
}

}  // namespace

std::vector<NamedRequest> named_requests(const StressRequest& request) {
  using Kind = SubsurfaceRequest::Kind;
  struct Source {
    const char* option;
    const char* usage;
    const char* name;
    Kind kind;
    const std::vector<std::string>& texts;
  };
  const Source sources[] = {
      {"--at", "x,y,z", "at", Kind::point, request.places},
      {"--line", "x,y,z:x,y,z or x,y,z:x,y,z:n", "line", Kind::line, request.lines},
      {"--plane", "x,y,z:x,y,z:x,y,z or x,y,z:x,y,z:x,y,z:n,m", "plane", Kind::plane,
       request.planes}};
  std::vector<NamedRequest> all;
  for (const Source& source : sources)
    for (std::size_t k = 0; k < source.texts.size(); ++k) {
      const Option option{fmt::format("{} {}", source.option, source.texts[k]), source.usage};
      add(option, request.body, fmt::format("{}_{}", source.name, k + 1),
          shape(option, source.kind, source.texts[k]), all);
    }
  return all;
}

std::optional<double> yield_shear_stress(const StressRequest& request) {
  if (request.yield_shear_stress && request.yield_strength)
    throw InputError(
        "--yield-shear-stress and --yield-strength are both given; allowed: one of them; do: leave "
        "one out (k = Y / sqrt(3))");
  const auto positive = [](const char* name, double value) {
    if (!(value > 0.0) || !std::isfinite(value))
      throw InputError(
          fmt::format("{} {}: allowed: a stress > 0 in MPa; do: give one", name, value));
    return value;
  };
  if (request.yield_shear_stress)
    return positive("--yield-shear-stress", *request.yield_shear_stress);
  if (request.yield_strength)
    return postprocess::yield_shear_stress(positive("--yield-strength", *request.yield_strength));
  return std::nullopt;
}

}  // namespace rollfem::app
