// SPDX-License-Identifier: LGPL-2.1-or-later
// Which elements are made to adhere behind a border of adhesion that moves downstream.
#include "contact/iteration/adhesion_fronts.hpp"

#include "support/test.hpp"

namespace rollfem::contact {
namespace {

/// Rows of '#' adhesion and '.' slip, upstream to the right, the first one at the top.
class Rows {
 public:
  explicit Rows(const std::vector<std::string>& rows)
      : nx_(static_cast<int>(rows[0].size())),
        ny_(static_cast<int>(rows.size())),
        fronts_(ContactGrid::centred(nx_, ny_, 1.0, 1.0), all()) {
    take(rows);
  }

  /// What becomes of the next adhesion area.
  std::vector<std::string> take(const std::vector<std::string>& rows) {
    std::vector<char> adheres;
    for (const std::string& row : rows)
      for (const char c : row) adheres.push_back(c == '#');
    const std::vector<char> before = adheres;
    extended_ = fronts_.extend(adheres);
    EXPECT_EQ(extended_, adheres != before);
    std::vector<std::string> result = rows;
    for (std::size_t k = 0; k < adheres.size(); ++k)
      result[k / rows[0].size()][k % rows[0].size()] = adheres[k] ? '#' : '.';
    return result;
  }

  void forget() { fronts_.forget(); }

 private:
  std::vector<Eigen::Index> all() const {
    std::vector<Eigen::Index> elements;
    for (int k = 0; k < nx_ * ny_; ++k) elements.push_back(k);
    return elements;
  }

  int nx_;
  int ny_;
  AdhesionFronts fronts_;
  bool extended_ = false;
};

using Lines = std::vector<std::string>;

TEST(AdhesionFronts, FillARowThatFallsBehindItsNeighbours) {
  Rows rows({"..########", "........##", "...#######"});
  EXPECT_EQ(rows.take({"..########", ".......###", "...#######"}),
            (Lines{"..########", "...#######", "...#######"}));
}

TEST(AdhesionFronts, LeaveAloneWhatDoesNotChange) {
  const Lines same{"..########", "........##", "...#######"};
  Rows rows(same);
  EXPECT_EQ(rows.take(same), same);
  const Lines more_slip{"..########", ".........#", "...#######"};
  EXPECT_EQ(rows.take(more_slip), more_slip);
  const Lines adhesion_begins{"..########", "....#....#", "...#######"};  // not behind adhesion
  EXPECT_EQ(rows.take(adhesion_begins), adhesion_begins);
}

TEST(AdhesionFronts, GoTwiceAsFarEveryTimeARowMovesAlone) {
  Rows rows({"...............#"});
  EXPECT_EQ(rows.take({"..............##"}), (Lines{"..............##"}));
  EXPECT_EQ(rows.take({".............###"}), (Lines{"............####"}));
  EXPECT_EQ(rows.take({"...........#####"}), (Lines{"........########"}));
  EXPECT_EQ(rows.take({"........########"}), (Lines{"........########"}));
  EXPECT_EQ(rows.take({".......#########"}), (Lines{".......#########"}));
  rows.forget();
  EXPECT_EQ(rows.take({"......##########"}), (Lines{"......##########"}));
}

}  // namespace
}  // namespace rollfem::contact
