// SPDX-License-Identifier: LGPL-2.1-or-later
// drop_zigzag drops exactly the points that were added beside a good profile and turn its curve
// back, wherever they are.
#include "profiles/profile_points.hpp"

#include "support/profile_texts.hpp"

namespace rollfem::profiles {
namespace {

using PointList = Points;

ProfilePoints listed(const PointList& points) {
  ProfilePoints list{"profile.txt", {}};
  for (const auto& [y, z] : points)
    list.list.push_back({y, z, static_cast<unsigned>(list.list.size() + 1)});
  return list;
}

bool turns_back(const ProfilePoints& points) {
  try {
    check_order(points, true);
    return false;
  } catch (const PointFault&) {
    return true;
  }
}

/// Expects that only the points which are not among the good ones are dropped; false where nothing
/// turns back.
bool expect_dropped(const PointList& good, const PointList& with_outliers,
                    const std::string& what) {
  ProfilePoints kept = listed(with_outliers);
  if (!turns_back(kept)) return false;
  drop_zigzag(kept);
  EXPECT_EQ(kept.list.size(), good.size()) << what;
  for (std::size_t k = 0; k < std::min(good.size(), kept.list.size()); ++k)
    if (kept.list[k].y != good[k][0] || kept.list[k].z != good[k][1]) {
      ADD_FAILURE() << what << ": line " << kept.list[k].line << " stands for point " << k;
      break;
    }
  return true;
}

/// Beside point k: so many mm along the profile and off it.
std::array<double, 2> beside(const PointList& points, std::size_t k, double along, double off) {
  const auto &a = points[k > 0 ? k - 1 : 0], &b = points[std::min(k + 1, points.size() - 1)];
  const double y = b[0] - a[0], z = b[1] - a[1], length = std::hypot(y, z);
  return {points[k][0] + (along * y - off * z) / length,
          points[k][1] + (along * z + off * y) / length};
}

/// Steep faces (gauge face, flange, back of the flange) and flat ones; the ends too.
TEST(Zigzag, OnePointThatTurnsBackIsDropped) {
  for (const char* const name : {"S1002", "60E1"}) {
    const PointList good = points_of(name, 0.25);
    int turned = 0;
    for (std::size_t k = 0; k < good.size(); ++k)
      for (const double along : {-1.4, -0.6, 0.4, 0.9, 1.6})
        for (const double off : {-0.2, 0.15}) {
          PointList with = good;
          with.insert(with.begin() + static_cast<std::ptrdiff_t>(k) + 1,
                      beside(good, k, along, off));
          turned += expect_dropped(good, with, fmt::format("{} {} {} {}", name, k, along, off));
        }
    EXPECT_GT(turned, 1000) << name;
  }
}

TEST(Zigzag, PointsAddedToTheEndsAreDropped) {
  for (const char* const name : {"S1002", "60E1"}) {
    const PointList good = points_of(name, 0.25);
    int turned = 0;
    for (const auto& [y, z] : PointList{{3.6, 0.1}, {2.0, -0.3}, {1.0, 0.0}}) {
      PointList with = good;
      with.insert(with.begin(), {good.front()[0] + y, good.front()[1] + z});
      turned += expect_dropped(good, with, std::string(name) + " first");
      with = good;
      with.push_back({good.back()[0] - y, good.back()[1] + z});
      turned += expect_dropped(good, with, std::string(name) + " last");
    }
    EXPECT_GE(turned, 4) << name;
  }
}

TEST(Zigzag, SeveralPointsAreDroppedTogether) {
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> far(0.4, 2.0), aside(0.1, 0.3);
  for (int round = 0; round < 60; ++round) {
    const PointList good = points_of(round % 2 == 0 ? "S1002" : "60E1", 0.25);
    PointList apart = good, close = good;
    std::size_t added = 0;
    // From the end, so that the numbers of the good points stay.
    for (int k = static_cast<int>(good.size()) - 2; k > 0;
         k -= 10 + static_cast<int>(generator() % 150)) {
      const auto outlier = [&] {
        const double along = (generator() % 2 == 0 ? 1.0 : -1.0) * far(generator);
        return beside(good, static_cast<std::size_t>(k), along, aside(generator));
      };
      PointList with = good;
      with.insert(with.begin() + k + 1, outlier());
      if (turns_back(listed(with)))
        apart.insert(apart.begin() + k + 1, with[static_cast<std::size_t>(k) + 1]);
      for (std::size_t count = 1 + generator() % 3; count > 0; --count, ++added)
        close.insert(close.begin() + k + 1, outlier());
    }
    EXPECT_TRUE(expect_dropped(good, apart, fmt::format("round {}", round)));
    // Without them the curve does not turn back, so no more points need to go.
    ProfilePoints kept = listed(close);
    drop_zigzag(kept);
    EXPECT_FALSE(turns_back(kept));
    EXPECT_GE(kept.list.size(), good.size()) << round << ", added " << added;
  }
}

/// An instrument that stops, goes back and goes on: every point is kept once.
TEST(Zigzag, AWayBackAndForthIsTravelledOnce) {
  const PointList good = points_of("60E1", 0.25);
  for (const std::size_t length : {4u, 12u, 40u})
    for (std::size_t k = 60; k + 10 < good.size(); k += 25) {
      PointList with(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(k));
      for (std::size_t back = 2; back <= length; ++back)
        with.push_back(beside(good, k - back, 0.1, 0.002));
      with.insert(with.end(), good.begin() + static_cast<std::ptrdiff_t>(k - length), good.end());
      ProfilePoints kept = listed(with);
      drop_zigzag(kept);
      EXPECT_FALSE(turns_back(kept)) << length << ' ' << k;
      EXPECT_NEAR(static_cast<double>(kept.list.size()), static_cast<double>(good.size()), 2.0)
          << length << ' ' << k;
    }
}

}  // namespace
}  // namespace rollfem::profiles
