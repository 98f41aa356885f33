#include "meshes/contact_search.hpp"

#include "contact/errors.hpp"
#include "contact/geometry.hpp"
#include "meshes/load_estimate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace rollfem::meshes {

using contact::Axle;
using contact::Case;
using contact::Vector3;

namespace {

/// Humps with a valley shallower than this between them are one (mm): roughness of a profile.
constexpr double least_valley = 2e-3;
/// Patches whose distance is less than this part of their widths are one potential contact.
constexpr double near_touch = 0.1;
/// How far the section of the wheel is taken from the contact (mm), more than any patch.
constexpr double section_reach = 30.0;

std::string where(const Case& input, int position, bool left) {
  return fmt::format("{}: wheelset.lateral_shift = {:.6g} (position {}), {} wheel",
                     input.file.empty() ? "case" : input.file,
                     input.wheelset.lateral_shift.at(static_cast<std::size_t>(position - 1)),
                     position, left ? "left" : "right");
}

VerticalGap make_gap(const Case& input, const SearchScene& scene, const WheelsetPose& pose,
                     int position, bool left) {
  const Axle axle = place_axle(pose, input.wheelset, input.wheel.rolling_radius, left);
  try {
    return {scene.wheel, input.wheel.rolling_radius, axle, scene.rail_head};
  } catch (const contact::SolveError& error) {
    throw contact::SolveError(
        fmt::format("{}: {}; do: check gauge, flange_back_distance and lateral_shift",
                    where(input, position, left), error.what()));
  }
}

[[noreturn]] void fail_at_end(const Case& input, const VerticalGap& gap, bool inner, int position,
                              bool left, const std::string& what) {
  const contact::HeightCurve& wheel = gap.wheel().curve();
  const bool wheel_ends =
      inner ? wheel.first() > gap.rail().first() : wheel.last() < gap.rail().last();
  throw contact::InputError(fmt::format(
      "{}: {} the {} end of the {} profile, {:.2f} mm from the middle of the track; allowed: "
      "profiles that reach beyond the contact on both sides, as a height over y; do: take a longer "
      "{} profile, or check gauge, flange_back_distance and lateral_shift",
      where(input, position, left), what, inner ? "flange-side" : "field-side",
      wheel_ends ? "wheel" : "rail", inner ? gap.first() : gap.last(),
      wheel_ends ? "wheel" : "rail"));
}

/// Refuses a wheel that stands on the end of a profile or on its flange.
void check_support(const Case& input, const SearchScene& scene, const VerticalGap& gap,
                   int position, bool left) {
  const GapEnd end = gap.end();
  if (end != GapEnd::none)
    fail_at_end(input, gap, end == GapEnd::inner, position, left,
                "wheel and rail would touch first at");
  const std::vector<GapMinimum> minima = gap.minima();
  const auto first =
      std::min_element(minima.begin(), minima.end(),
                       [](const GapMinimum& a, const GapMinimum& b) { return a.gap < b.gap; });
  const auto& knots = scene.profiles.wheel.knots();
  const auto tip =
      static_cast<std::size_t>(std::max_element(knots.z.begin(), knots.z.end()) - knots.z.begin());
  const double profile_y = gap.wheel().at(first->y).profile_y;
  // A profile without a flange is highest at its own end.
  const bool has_flange = tip > 0 && knots.y[tip] < 0.0 && knots.z[tip] > 10.0;
  if (has_flange && profile_y < knots.y[tip] + 1.0)
    throw contact::SolveError(fmt::format(
        "{}: the wheel stands on the tip of its flange (wheel y = {:.2f} mm), it has left the "
        "rail; do: check gauge, flange_back_distance and lateral_shift",
        where(input, position, left), profile_y));
}

WheelsetPose asked_pose(const Case& input, int position) {
  const auto k = static_cast<std::size_t>(position - 1);
  WheelsetPose pose;
  pose.lateral_shift = input.wheelset.lateral_shift.at(k);
  pose.yaw = input.wheelset.yaw.at(k);
  if (!input.wheelset.roll.empty()) pose.roll = input.wheelset.roll.at(k);
  return pose;
}

/// Lowered until the wheel touches.
WheelsetPose touching_pose(const Case& input, const SearchScene& scene, WheelsetPose pose,
                           int position, bool left) {
  pose.height = 0.0;
  const VerticalGap gap = make_gap(input, scene, pose, position, left);
  check_support(input, scene, gap, position, left);
  pose.height = gap.smallest();
  return pose;
}

/// Roll at which both wheels touch at one height: what the left one can sink less what the right
/// one can rises with roll, by twice the distance of the rails per radian. Illinois method.
double touching_roll(const Case& input, const SearchScene& scene, WheelsetPose pose, int position) {
  const auto difference = [&](double roll) {
    pose.roll = roll;
    return make_gap(input, scene, pose, position, true).smallest() -
           make_gap(input, scene, pose, position, false).smallest();
  };
  // Steps of the slope expected until the sign changes.
  const double slope = input.track.gauge + 65.0;
  double a = 0.0, at_a = difference(a);
  if (at_a == 0.0) return 0.0;
  double b = -1.2 * at_a / slope, at_b = difference(b);
  constexpr double largest_roll = 0.1;
  while ((at_a < 0.0) == (at_b < 0.0)) {
    const double step = b - a;
    a = b, at_a = at_b;
    b += 2.0 * step;
    if (std::abs(b) > largest_roll)
      throw contact::SolveError(fmt::format(
          "{}: no roll of the wheelset below {} rad lets both wheels touch their rails; do: check "
          "gauge, flange_back_distance and lateral_shift, or give wheelset.roll",
          where(input, position, true), largest_roll));
    at_b = difference(b);
  }
  int kept = 0;
  for (int step = 0; step < 60 && std::abs(b - a) > 1e-13; ++step) {
    const double c = (a * at_b - b * at_a) / (at_b - at_a);
    const double at_c = difference(c);
    if (at_c == 0.0) return c;
    if ((at_c < 0.0) == (at_b < 0.0)) {
      b = c, at_b = at_c;
      if (kept == 1) at_a *= 0.5;
      kept = 1;
    } else {
      a = c, at_a = at_c;
      if (kept == -1) at_b *= 0.5;
      kept = -1;
    }
    if (std::abs(at_c) < 1e-10) return c;
  }
  return 0.5 * (a + b);
}

/// Sinking under the load of the case, as estimated.
double sinking_under_load(const Case& input, const VerticalGap& gap,
                          const std::vector<Stretch>& stretches) {
  const double modulus =
      contact::combine(input.wheel.material, input.rail.material).contact_modulus;
  const auto deepest = std::min_element(
      stretches.begin(), stretches.end(),
      [](const Stretch& a, const Stretch& b) { return a.deepest.gap < b.deepest.gap; });
  const double cosine = std::cos(deepest->deepest.angle());
  if (input.load.approach) return deepest->deepest.gap + *input.load.approach / cosine;
  const double vertical = input.load.vertical_force
                              ? *input.load.vertical_force
                              : input.load.normal_force.value_or(0.0) * cosine;
  return estimate_sinking(gap, stretches, vertical, modulus);
}

/// A stretch and the minima that went into it.
struct Group {
  Stretch stretch;
  std::vector<GapMinimum> minima;
};

void join(Group& group, const Group& next) {
  if (next.stretch.deepest.gap < group.stretch.deepest.gap) {
    group.stretch.deepest = next.stretch.deepest;
    group.stretch.rolling_radius = next.stretch.rolling_radius;
  }
  group.stretch.limits[1] = next.stretch.limits[1];
  group.minima.insert(group.minima.end(), next.minima.begin(), next.minima.end());
}

/// Every minimum with the stretch between the ridges beside it; roughness is smoothed over.
std::vector<Group> separate_groups(const VerticalGap& gap) {
  std::vector<Group> groups;
  for (const GapMinimum& minimum : gap.minima()) {
    Group group;
    group.stretch.deepest = minimum;
    group.stretch.rolling_radius = gap.wheel().at(minimum.y).radius;
    group.stretch.limits = {gap.first(), gap.last()};
    group.minima = {minimum};
    if (!groups.empty()) {
      Group& last = groups.back();
      const auto ridge = gap.largest_between(last.stretch.deepest.y, minimum.y);
      if (ridge[0] - std::max(last.stretch.deepest.gap, minimum.gap) < least_valley) {
        join(last, group);
        continue;
      }
      last.stretch.limits[1] = group.stretch.limits[0] = ridge[1];
    }
    groups.push_back(std::move(group));
  }
  return groups;
}

std::vector<Stretch> stretches_of(const std::vector<Group>& groups) {
  std::vector<Stretch> stretches;
  for (const Group& group : groups) stretches.push_back(group.stretch);
  return stretches;
}

std::array<double, 2> reach_of(const VerticalGap& gap, const Stretch& stretch, double sinking) {
  return gap.below(sinking, stretch.deepest.y, stretch.limits[0], stretch.limits[1]);
}

bool are_one(const VerticalGap& gap, const Stretch& a, const Stretch& b, double sinking,
             double merge_angle) {
  if (!(approach_of(a, sinking) > 0.0) || !(approach_of(b, sinking) > 0.0)) return false;
  if (std::abs(a.deepest.angle() - b.deepest.angle()) > merge_angle) return false;
  const auto left = reach_of(gap, a, sinking), right = reach_of(gap, b, sinking);
  const double widths = left[1] - left[0] + right[1] - right[0];
  return right[0] - left[1] < near_touch * widths;
}

/// Mean place of the overlap at a sinking, weighted by the square of its depth over the area: the
/// overlap of depth d is as long as sqrt(d), which makes d^2.5 along y.
double reference_place(const VerticalGap& gap, const Stretch& stretch, double sinking) {
  if (!(approach_of(stretch, sinking) > 0.0)) return stretch.deepest.y;
  const auto reach = reach_of(gap, stretch, sinking);
  constexpr int cells = 400;
  const double dy = (reach[1] - reach[0]) / cells;
  double weights = 0.0, moments = 0.0;
  for (int k = 0; k < cells; ++k) {
    const double y = reach[0] + (k + 0.5) * dy;
    const double depth = sinking - gap.at(y).value;
    if (!(depth > 0.0)) continue;
    const double weight = depth * depth * std::sqrt(depth);
    weights += weight;
    moments += weight * y;
  }
  return weights > 0.0 ? moments / weights : stretch.deepest.y;
}

/// Joins neighbours until none meet any more; the sinking falls with every joint.
double merge(const Case& input, const VerticalGap& gap, std::vector<Group>& groups,
             double merge_angle) {
  double sinking = sinking_under_load(input, gap, stretches_of(groups));
  for (std::size_t k = 0; k + 1 < groups.size();) {
    if (!are_one(gap, groups[k].stretch, groups[k + 1].stretch, sinking, merge_angle)) {
      ++k;
      continue;
    }
    join(groups[k], groups[k + 1]);
    groups.erase(groups.begin() + static_cast<std::ptrdiff_t>(k) + 1);
    sinking = sinking_under_load(input, gap, stretches_of(groups));
    k = 0;
  }
  return sinking;
}

/// Side frame to track frame.
Vector3 to_track(bool left, const Vector3& v) {
  return {v[0], side_sign(left) * v[1], v[2]};
}

/// The frame of a patch on the rail; coordinates as of a right-hand patch frame on the left side,
/// whose y points to the field; on the right the lateral one is turned in the end.
struct PatchAxes {
  double y0, z0;        ///< side frame, mm
  double cosine, sine;  ///< of the contact angle
  double across(double y, double z) const { return cosine * (y - y0) - sine * (z - z0); }
  double along_normal(double y, double z) const { return -sine * (y - y0) - cosine * (z - z0); }
};

contact::HeightCurve changed(const contact::HeightCurve& curve, double sign_y, double factor,
                             double added) {
  std::vector<double> y, z, slope;
  for (const double knot : curve.knots()) {
    const contact::CurveValue at = curve.at(knot);
    y.push_back(sign_y * knot);
    z.push_back(factor * at.value + added);
    slope.push_back(sign_y * factor * at.slope);
  }
  if (sign_y < 0.0)
    for (auto* list : {&y, &z, &slope}) std::reverse(list->begin(), list->end());
  return {std::move(y), std::move(z), std::move(slope)};
}

/// Parameter of the knot nearest to a place.
double parameter_near(const ProfileCurve& curve, double y, double z) {
  const ProfileKnots& knots = curve.knots();
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < knots.y.size(); ++k) {
    const double distance = std::hypot(knots.y[k] - y, knots.z[k] - z);
    if (distance < least) least = distance, nearest = k;
  }
  return knots.parameter[nearest];
}

contact::PatchGeometry make_geometry(const Case& input, const SearchScene& scene,
                                     const PatchAxes& axes, const Axle& axle_of_side, bool left,
                                     const OutlinePoint& touch, double sink) {
  const ProfileCurve rail =
      scene.rail.moved(0.0, -axes.y0, -axes.z0).moved(std::atan2(axes.sine, axes.cosine), 0.0, 0.0);
  // z of the patch points up, that of the profile down.
  const double sign_y = left ? 1.0 : -1.0;
  contact::HeightCurve heights =
      changed(height_over_y(rail, parameter_near(rail, 0.0, 0.0)), sign_y, -1.0, 0.0);
  const ProfileCurve& wheel = scene.profiles.wheel;
  contact::HeightCurve radius = changed(
      height_over_y(
          wheel, parameter_near(wheel, touch.profile_y, touch.radius - input.wheel.rolling_radius)),
      sign_y, 1.0, input.wheel.rolling_radius);
  // Mirrored for the right side: y changes its sign, and the direction is turned about so that it
  // points to larger y again (and its axial coordinate with it, as in `changed`).
  const Vector3& p = axle_of_side.point;
  const Vector3& d = axle_of_side.direction;
  Axle axle;
  axle.point = {p[0] - touch.x, sign_y * axes.across(p[1], p[2] + sink),
                axes.along_normal(p[1], p[2] + sink)};
  const double d_across = axes.cosine * d[1] - axes.sine * d[2];
  const double d_normal = -axes.sine * d[1] - axes.cosine * d[2];
  axle.direction = {sign_y * d[0], d_across, sign_y * d_normal};
  return {std::move(heights), std::move(radius), axle, -section_reach, section_reach};
}

class WheelSearch {
 public:
  WheelSearch(const Case& input, const SearchScene& scene, const WheelsetPose& pose, int position,
              bool left)
      : input_(input),
        scene_(scene),
        position_(position),
        left_(left),
        pose_(touching_pose(input, scene, pose, position, left)),
        axle_(place_axle(pose_, input.wheelset, input.wheel.rolling_radius, left)),
        gap_(make_gap(input, scene, pose_, position, left)),
        modulus_(contact::combine(input.wheel.material, input.rail.material).contact_modulus) {}

  std::vector<WheelRailContact> contacts(const SearchOptions& options) const {
    std::vector<Group> groups = separate_groups(gap_);
    const double sinking = merge(input_, gap_, groups, options.merge_angle);
    std::vector<WheelRailContact> found;
    int loaded = 0;
    for (std::size_t k = 0; k < groups.size(); ++k) {
      WheelRailContact contact = describe(groups[k], sinking, k > 0, k + 1 < groups.size());
      if (contact.normal_force > 0.0)
        ++loaded;
      else if (contact.place.separation > options.near_miss)
        continue;
      found.push_back(std::move(contact));
    }
    std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
      return a.normal_force != b.normal_force ? a.normal_force > b.normal_force
                                              : a.place.separation < b.place.separation;
    });
    for (std::size_t k = 0; k < found.size(); ++k) {
      found[k].place.patches = loaded;
      found[k].place.patch = found[k].normal_force > 0.0 ? static_cast<int>(k) + 1 : 0;
    }
    return found;
  }

 private:
  WheelRailContact describe(const Group& group, double sinking, bool neighbour_inside,
                            bool neighbour_outside) const {
    const GapMinimum& first = group.stretch.deepest;
    const double y = reference_place(gap_, group.stretch, sinking);
    const contact::CurveValue rail = gap_.rail().at(y);
    const double angle = -std::atan(rail.slope);
    const PatchAxes axes{y, rail.value, std::cos(angle), std::sin(angle)};
    const OutlinePoint touch = gap_.wheel().at(y);
    WheelRailContact contact;
    contact.pose = pose_;
    contact.approach = std::max(0.0, approach_of(group.stretch, sinking));
    contact.normal_force = estimate_force(gap_, group.stretch, contact.approach, modulus_);
    fill_place(contact.place, group.stretch, axes, touch);
    fill_frames(contact, axes, touch);
    if (contact.normal_force > 0.0) check_reach(group.stretch, sinking);
    const auto across = [&](double at) { return axes.across(at, gap_.rail().at(at).value); };
    const auto pair = [&](double lower, double upper) {
      return left_ ? std::array<double, 2>{lower, upper} : std::array<double, 2>{-upper, -lower};
    };
    const auto reach = reach_of(gap_, group.stretch, std::max(sinking, first.gap));
    contact.reach = pair(across(reach[0]), across(reach[1]));
    contact.limits = pair(neighbour_inside ? across(group.stretch.limits[0]) : -contact::infinity,
                          neighbour_outside ? across(group.stretch.limits[1]) : contact::infinity);
    for (const GapMinimum& minimum : group.minima)
      contact.touching.push_back(
          {(left_ ? 1.0 : -1.0) * across(minimum.y), minimum.gap * axes.cosine});
    contact.geometry = make_geometry(input_, scene_, axes, axle_, left_, touch, first.gap);
    return contact;
  }

  void fill_place(contact::ContactPlace& place, const Stretch& stretch, const PatchAxes& axes,
                  const OutlinePoint& touch) const {
    place.left = left_;
    place.position = position_;
    place.lateral_shift = pose_.lateral_shift;
    place.yaw = pose_.yaw;
    place.roll = pose_.roll;
    place.height = pose_.height;
    place.y_track = side_sign(left_) * axes.y0;
    place.z_track = axes.z0;
    place.y_rail = profile_coordinates(scene_.rail_place, axes.y0, axes.z0)[0];
    place.y_wheel = touch.profile_y;
    place.contact_angle = std::atan2(axes.sine, axes.cosine);
    place.rolling_radius = touch.radius;
    place.separation = stretch.deepest.gap * axes.cosine;
  }

  void fill_frames(WheelRailContact& contact, const PatchAxes& axes,
                   const OutlinePoint& touch) const {
    contact.axle.point = {0.0, pose_.lateral_shift, pose_.height - input_.wheel.rolling_radius};
    const Vector3 outward = to_track(left_, axle_.direction);
    for (int d = 0; d < 3; ++d) contact.axle.direction[d] = side_sign(left_) * outward[d];
    contact.origin = to_track(left_, {touch.x, axes.y0, axes.z0});
    contact.along = {1.0, 0.0, 0.0};
    contact.normal = to_track(left_, {0.0, -axes.sine, -axes.cosine});
    contact.across = {0.0, contact.normal[2], -contact.normal[1]};  // normal x along
  }

  void check_reach(const Stretch& stretch, double sinking) const {
    const auto reach = reach_of(gap_, stretch, sinking);
    if (reach[0] <= gap_.first())
      fail_at_end(input_, gap_, true, position_, left_, "under its load the patch reaches");
    if (reach[1] >= gap_.last())
      fail_at_end(input_, gap_, false, position_, left_, "under its load the patch reaches");
  }

  const Case& input_;
  const SearchScene& scene_;
  int position_;
  bool left_;
  WheelsetPose pose_;
  Axle axle_;
  VerticalGap gap_;
  double modulus_;
};

}  // namespace

double WheelRailContact::approach_at(double sinking) const {
  return sinking * std::cos(place.contact_angle) - place.separation;
}

SearchScene make_search_scene(const Case& input, ProfilePair profiles) {
  SearchScene scene;
  scene.rail_place = rail_place(profiles.rail, input.track);
  scene.rail = place_rail(profiles.rail, scene.rail_place);
  scene.rail_head = rail_heights(scene.rail);
  scene.wheel = wheel_points(profiles.wheel);
  scene.profiles = std::move(profiles);
  return scene;
}

WheelsetPose find_pose(const Case& input, const SearchScene& scene, int position) {
  WheelsetPose pose = asked_pose(input, position);
  if (input.wheelset.roll.empty()) pose.roll = touching_roll(input, scene, pose, position);
  return pose;
}

std::vector<WheelRailContact> find_contacts(const Case& input, const SearchScene& scene,
                                            const WheelsetPose& pose, int position, bool left,
                                            const SearchOptions& options) {
  return WheelSearch(input, scene, pose, position, left).contacts(options);
}

std::vector<WheelRailContact> find_contacts(const Case& input, const SearchScene& scene,
                                            int position, const SearchOptions& options) {
  const WheelsetPose pose = find_pose(input, scene, position);
  std::vector<WheelRailContact> all;
  for (const bool left : {true, false}) {
    const contact::WheelSide other = left ? contact::WheelSide::right : contact::WheelSide::left;
    if (input.wheelset.side == other) continue;
    for (WheelRailContact& contact : find_contacts(input, scene, pose, position, left, options))
      all.push_back(std::move(contact));
  }
  return all;
}

}  // namespace rollfem::meshes
