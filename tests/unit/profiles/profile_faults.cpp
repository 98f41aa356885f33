// SPDX-License-Identifier: LGPL-2.1-or-later
// Every fault of a profile file is refused with one message that names the line and the repairing
// key, and the key repairs it.
#include "base/errors.hpp"
#include "profiles/profiles.hpp"

#include "support/profile_texts.hpp"
#include <ostream>

namespace rollfem::profiles {
namespace {

struct Fault {
  const char* name;
  bool wheel;
  std::string text;
  std::vector<std::string> parts;            ///< of the message
  std::function<void(ProfileSource&)> mend;  ///< empty: cannot be mended
};

void PrintTo(const Fault& fault, std::ostream* stream) {
  *stream << fault.name;
}

const auto same = [](Points&) {};

/// The same change of every point.
template <class Change>
std::function<void(Points&)> each(const Change& change) {
  return [change](Points& points) {
    for (auto& point : points) change(point);
  };
}

const std::vector<Fault> faults{
    {"Empty", true, "", {"is empty"}, {}},
    {"OnlyComments", true, "# nothing\n\n", {"is empty"}, {}},
    {"NoProfile",
     true,
     "Dear Sir,\nplease find\n",
     {"profile.txt:2: is not a profile", "do not begin with a number"},
     {}},
    {"BadNumber", true, "1 2\n3 x4\n", {"profile.txt:2:", "`x4`"}, {}},
    {"OneColumn", false, "1\n2\n", {"profile.txt:1:", "two columns"}, {}},
    {"NotFinite", false, "1 2\n3 nan\n", {"profile.txt:2:", "`nan`"}, {}},
    {"TooFewPoints", false, "-20 2\n0 0\n20 2\n", {"has 3 points"}, {}},
    {"Binary", false, std::string("1 2\0 3", 6), {"binary"}, {}},
    {"Metres",
     true,
     changed("S1002", same, 1000.0),
     {"in m?", "unit = \"m\""},
     [](ProfileSource& s) { s.unit = contact::LengthUnit::m; }},
    {"Inches",
     false,
     changed("60E1", same, 25.4),
     {"inches", "unit = \"inch\""},
     [](ProfileSource& s) { s.unit = contact::LengthUnit::inch; }},
    {"MirroredWheel",
     true,
     changed("S1002", each([](auto& q) { q[0] = -q[0]; })),
     {"flange is on the wrong side", "mirror = true"},
     [](ProfileSource& s) { s.mirror = true; }},
    {"UpwardWheel",
     true,
     changed("S1002", each([](auto& q) { q[1] = -q[1]; })),
     {"upward", "flip = true"},
     [](ProfileSource& s) { s.flip = true; }},
    {"UpwardRail",
     false,
     changed("60E1", each([](auto& q) { q[1] = -q[1]; })),
     {"upward", "flip = true"},
     [](ProfileSource& s) { s.flip = true; }},
    {"ReversedWheel",
     true,
     changed("S1002", [](Points& p) { std::reverse(p.begin(), p.end()); }),
     {"profile.txt:1:", "large to small y", "reverse = true"},
     [](ProfileSource& s) { s.reverse = true; }},
    {"Unordered",
     false,
     changed("60E1",
             [](Points& p) {
               for (std::size_t k = 3; k + 8 < p.size(); k += 9) std::swap(p[k], p[k + 6]);
             }),
     {"unordered", "sort = true"},
     [](ProfileSource& s) { s.sort = true; }},
    {"Duplicate",
     false,
     changed("60E1", [](Points& p) { p.insert(p.begin() + 100, p[100]); }),
     {"profile.txt:102:", "line 101", "drop_duplicates = true"},
     [](ProfileSource& s) { s.drop_duplicates = true; }},
    {"Zigzag",
     false,
     changed("60E1",
             [](Points& p) {
               p.insert(p.begin() + 131, {p[128][0], p[128][1]});
             }),
     {"profile.txt:132:", "zig-zag", "drop_zigzag = true"},
     [](ProfileSource& s) { s.drop_zigzag = true; }},
    {"Gap",
     false,
     changed("60E1", [](Points& p) { p.erase(p.begin() + 125, p.begin() + 139); }),
     {"profile.txt:126:", "gap of 7.5", "longest_gap = 8"},
     [](ProfileSource& s) { s.longest_gap = 8.0; }},
    {"Kink",
     false,
     changed("60E1", each([](auto& q) { q[1] += 0.5 * std::max(0.0, q[0] - 5.0); })),
     {"kink of 26", "rounding = 0.05", "largest_kink = 27"},
     {}},
    {"WheelAsRail",
     false,
     changed("S1002", same),
     {"seems to be a wheel", "tip at y = -55.", "tread up to y = 59.",
      "do: give it as the profile of the wheel"},
     {}},
    {"MirroredWheelAsRail",
     false,
     changed("S1002",
             [](Points& p) {
               for (auto& q : p) q[0] = -q[0];
               std::reverse(p.begin(), p.end());
             }),
     {"seems to be a wheel", "tip at y = 55.", "tread up to y = -59."},
     {}},
    {"RailAsWheel",
     true,
     changed("60E1", same),
     {"seems to be the head of a rail", "to both its ends",
      "do: give it as the profile of the rail"},
     {}},
    {"Step",
     false,
     changed("60E1", each([](auto& q) { q[1] += q[0] > 5.0 ? 0.1 : 0.0; })),
     {"step of 0.1 mm", "y = 4.8", "`rounding = 0.05`"},
     {}},
};

class FaultyFile : public ::testing::TestWithParam<Fault> {};

TEST_P(FaultyFile, IsRefusedWithOneMessageAndReadWhenMended) {
  const Fault& fault = GetParam();
  const std::string message = refusal(fault.text, fault.wheel);
  EXPECT_TRUE(says(message, fault.parts));
  EXPECT_TRUE(says(message, "do: "));
  EXPECT_FALSE(says(message, "\n"));
  if (!fault.mend) return;
  ProfileSource source;
  fault.mend(source);
  EXPECT_LT(off(read(fault.text, fault.wheel, source), fault.wheel ? "S1002" : "60E1"), 2e-3);
}

INSTANTIATE_TEST_SUITE_P(Profile, FaultyFile, ::testing::ValuesIn(faults),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace rollfem::profiles
