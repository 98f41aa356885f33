// The line of progress: how long it has taken, and what is left where load points tell it.
#include "app/progress_display.hpp"

#include <gtest/gtest.h>

using rollfem::app::progress_line;
using rollfem::contact::ProgressEvent;

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

TEST(ProgressDisplay, TellsWhatIsLeftFromTheLoadPointsThatAreDone) {
  EXPECT_NE(line(2, true, 20.0).find(" 20.0 s, about 30 s left"), std::string::npos);
  EXPECT_NE(line(3, false, 20.0).find(", about 30 s left"), std::string::npos);
}

TEST(ProgressDisplay, GuessesNothing) {
  for (const std::string& text : {line(1, false, 20.0), line(5, true, 20.0), line(2, true, 0.5)})
    EXPECT_EQ(text.find("left"), std::string::npos) << text;
}

TEST(ProgressDisplay, NamesACreepageOnlyWhereThereIsOne) {
  EXPECT_NE(line(2, true, 1.0).find(" 2/5"), std::string::npos);
  EXPECT_EQ(line(2, true, 1.0).find("xi"), std::string::npos);
  ProgressEvent rolling;
  rolling.point = rolling.points = 1;
  rolling.creepage = 0.001;
  EXPECT_NE(progress_line(rolling, 1.0).find(" xi 0.001"), std::string::npos);
}
