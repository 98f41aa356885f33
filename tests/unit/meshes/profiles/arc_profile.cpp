// Circular transverse profiles: the drop is the circle's, without cancellation, either sign.
#include "meshes/profiles/arc_profile.hpp"

#include "contact/base/errors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using rollfem::contact::InputError;
using rollfem::meshes::ArcProfile;

TEST(ArcProfile, PointsLieOnTheCircle) {
  for (const double radius : {100.0, 2000.0, -51.282}) {
    const ArcProfile profile(radius);
    for (const double y : {-40.0, -3.0, 0.0, 10.87, 50.0}) {
      const double centre_distance = std::hypot(y, radius - profile.drop(y));
      EXPECT_NEAR(centre_distance, std::abs(radius), 1e-10) << "R " << radius << " y " << y;
    }
  }
}

TEST(ArcProfile, SmallDropsKeepTheirDigits) {
  // y^2 / (2 R) (1 + y^2 / (4 R^2)): the plain formula R - sqrt(R^2 - y^2) has no digit left here.
  const ArcProfile profile(1e6);
  EXPECT_NEAR(profile.drop(1e-3) / 5e-13, 1.0, 1e-12);
}

TEST(ArcProfile, SlopeIsTheDerivative) {
  const ArcProfile profile(-105.263);
  const double step = 1e-5;
  for (const double y : {-30.0, 1.0, 60.0})
    EXPECT_NEAR(profile.slope(y), (profile.drop(y + step) - profile.drop(y - step)) / (2 * step),
                1e-8);
}

TEST(ArcProfile, AnInfiniteRadiusIsAStraightLine) {
  const ArcProfile profile(std::numeric_limits<double>::infinity());
  EXPECT_EQ(profile.drop(17.0), 0.0);
  EXPECT_EQ(profile.slope(17.0), 0.0);
  EXPECT_EQ(profile.curvature(), 0.0);
}

TEST(ArcProfile, BeyondTheArcIsRefused) {
  EXPECT_THROW(ArcProfile(50.0).drop(50.0), InputError);
  EXPECT_THROW(ArcProfile(0.0), InputError);
  EXPECT_THROW(ArcProfile(std::numeric_limits<double>::quiet_NaN()), InputError);
}
