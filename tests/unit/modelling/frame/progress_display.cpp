// SPDX-License-Identifier: LGPL-2.1-or-later
// The progress line: elapsed time, and remaining time if load points allow an estimate.
#include "modelling/frame/progress_display.hpp"

#include "support/temporary_folder.hpp"

using rollfem::modelling::progress_line;

namespace {

std::string line(int point, bool finished, double seconds) {
  ProgressEvent event;
  event.model = "fem";
  event.stage = "rolling";
  event.point = point;
  event.points = 5;
  event.finished = finished;
  return progress_line(event, seconds);
}

}  // namespace

TEST(ProgressDisplay, EstimatesTheRemainingTimeFromFinishedLoadPoints) {
  EXPECT_TRUE(says(line(2, true, 20.0), " 20.0 s, about 30 s left"));
  EXPECT_TRUE(says(line(3, false, 20.0), ", about 30 s left"));
}

TEST(ProgressDisplay, GuessesNothing) {
  for (const std::string& text : {line(1, false, 20.0), line(5, true, 20.0), line(2, true, 0.5)})
    EXPECT_FALSE(says(text, "left"));
}

TEST(ProgressDisplay, NamesACreepageOnlyWhereThereIsOne) {
  EXPECT_TRUE(says(line(2, true, 1.0), " 2/5"));
  EXPECT_FALSE(says(line(2, true, 1.0), "xi"));
  ProgressEvent rolling;
  rolling.point = rolling.points = 1;
  rolling.creepage = 0.001;
  EXPECT_TRUE(says(progress_line(rolling, 1.0), " xi 0.001"));
}
