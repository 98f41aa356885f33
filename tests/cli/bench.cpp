// SPDX-License-Identifier: LGPL-2.1-or-later
// rollfem bench: errors and seconds of the models.
#include "support/case_examples.hpp"
#include "support/program.hpp"

namespace {

/// The last number but one (the error of the force) of the line that begins so.
double force_error(const std::string& text, const std::string& beginning) {
  const std::size_t at = text.find('\n' + beginning);
  EXPECT_NE(at, std::string::npos) << beginning << '\n' << text;
  if (at == std::string::npos) return 1e9;
  const std::string line = text.substr(at + 1, text.find('\n', at + 1) - at - 1);
  const std::size_t percent = line.rfind('%');
  return std::atof(line.substr(line.find_last_of("+-", percent)).c_str());
}

}  // namespace

using Bench = ProgramTest;

TEST_F(Bench, QuicklySaysErrorsAndSecondsOfTheModels) {
  const Outcome outcome = done({"bench", "--quick"}, {"ROLLFEM_CACHE=cache"});
  EXPECT_TRUE(says(outcome.out, "seconds", "\nhertz ", "\nlinear ", "\nstrip "));
  // Errors fall with the grid; theories keep their model error.
  const double coarse = std::abs(force_error(outcome.out, "halfspace                 24"));
  const double fine = std::abs(force_error(outcome.out, "halfspace                 40"));
  EXPECT_LT(coarse, 0.6);
  EXPECT_LT(fine, 0.25);
  EXPECT_GT(std::abs(force_error(outcome.out, "linear ")), 5.0);
  EXPECT_FALSE(folder.holds("cache")) << "nothing is kept";
}
