// SPDX-License-Identifier: LGPL-2.1-or-later
// Files of values on a lattice: reading and interpolation.
#include "case/lattice.hpp"

#include "base/errors.hpp"

#include "support/temporary_folder.hpp"
#include <cstdio>

namespace {

class LatticeFile : public ::testing::Test {
 protected:
  Lattice read(const std::string& text, int columns = 1) const {
    return read_lattice(folder_.file("points.csv", text), "points.csv", columns);
  }

  /// A lattice of nx by ny points, 0.5 by 0.25 mm apart, in the usual form.
  static std::string points(int nx, int ny, const std::function<double(double, double)>& value) {
    std::ostringstream text;
    text.precision(17);
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) {
        const double x = -2.0 + 0.5 * i;
        const double y = -1.0 + 0.25 * j;
        text << x << ", " << y << ", " << value(x, y) << "\n";
      }
    return text.str();
  }

  const TemporaryFolder folder_;
};

double cubic(double x, double y) {
  return 1.0 + x - 2.0 * y + x * y + 0.3 * x * x * x - 0.7 * y * y * y * x * x;
}

TEST_F(LatticeFile, CubicsAreInterpolatedExactlyAlsoAtTheBorder) {
  const Lattice lattice = read("# a comment\nx,y,h\n" + points(9, 9, cubic));
  EXPECT_EQ(lattice.nx, 9);
  EXPECT_EQ(lattice.ny, 9);
  EXPECT_DOUBLE_EQ(lattice.dx, 0.5);
  EXPECT_DOUBLE_EQ(lattice.dy, 0.25);
  for (const double x : {-2.0, -1.97, -0.3, 0.0, 0.61, 1.99})
    for (const double y : {-1.0, -0.8, 0.01, 0.99})
      EXPECT_NEAR(lattice_value(lattice, 0, x, y), cubic(x, y), 1e-12) << x << " " << y;
}

TEST_F(LatticeFile, InterpolationIsOfFourthOrder) {
  const auto error_at = [&](int count) {
    Lattice lattice{"", count, count, 0.0, 0.0, 1.0 / (count - 1), 1.0 / (count - 1), {{}}};
    for (int j = 0; j < count; ++j)
      for (int i = 0; i < count; ++i)
        lattice.values[0].push_back(std::sin(3.0 * i * lattice.dx) *
                                    std::cos(2.0 * j * lattice.dy));
    double worst = 0.0;
    for (int k = 0; k < 400; ++k) {
      const double x = std::fmod(0.618034 * k, 1.0);
      const double y = std::fmod(0.414214 * k, 1.0);
      worst = std::max(
          worst, std::abs(lattice_value(lattice, 0, x, y) - std::sin(3.0 * x) * std::cos(2.0 * y)));
    }
    return worst;
  };
  EXPECT_GT(error_at(11) / error_at(21), 12.0);
}

TEST_F(LatticeFile, OrderOfLinesSeparatorsAndRoundingDoNotMatter) {
  std::string text = "x y s_x s_y\r\n";
  for (int i = 3; i >= 0; --i)
    for (int j = 0; j < 4; ++j) {
      char line[80];
      std::snprintf(line, sizeof line, "%.4f;%.4f\t%d %d # here\r\n", i / 3.0, j / 3.0, i, 10 * j);
      text += line;
    }
  const Lattice lattice = read(text, 2);
  EXPECT_EQ(lattice.nx, 4);
  EXPECT_NEAR(lattice.dx, 1.0 / 3.0, 1e-12);
  EXPECT_NEAR(lattice_value(lattice, 0, 2.0 / 3.0, 0.5), 2.0, 1e-9);
  EXPECT_NEAR(lattice_value(lattice, 1, 0.1, 1.0 / 3.0), 10.0, 1e-9);
}

TEST_F(LatticeFile, AGridBeyondThePointsIsRefused) {
  const Lattice lattice = read(points(9, 9, cubic));
  const ContactGrid within = ContactGrid::centred(4, 4, 0.5, 0.4);
  EXPECT_TRUE(covers(lattice, within));
  EXPECT_EQ(sample_lattice(lattice, 0, within, "key").size(), 16);
  const ContactGrid beyond = ContactGrid::centred(4, 9, 0.5, 0.4);
  EXPECT_FALSE(covers(lattice, beyond));
  EXPECT_THROW(sample_lattice(lattice, 0, beyond, "key"), InputError);
}

}  // namespace
