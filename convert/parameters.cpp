// SPDX-License-Identifier: LGPL-2.1-or-later
#include "convert/parameters.hpp"

#include <algorithm>
#include <map>

namespace rollfem::convert {

namespace {

const Names* found_in(const std::map<int, Names>& all, int digit) {
  const auto found = all.find(digit);
  return found == all.end() ? nullptr : &found->second;
}

}  // namespace

const Names* friction_names(int law) {
  static const Names by_speed{"FKIN", "F1", "SABSH1", "F2", "SABSH2"};
  static const std::map<int, Names> laws{{0, {"FSTAT", "FKIN"}},
                                         {2, by_speed},
                                         {3, by_speed},
                                         {4, by_speed},
                                         {6, {"FREF", "TREF", "DFHEAT", "DTHEAT"}}};
  return found_in(laws, law);
}

FrictionSet friction_set(int law, const double* values) {
  FrictionSet made;
  if (law == 0) made.fstat = values[0], made.fkin = values[1];
  if (law >= 2 && law <= 4) {
    std::copy_n(values + 1, 4, made.fall.begin());
    made.fkin = values[0];
    made.fstat = made.fkin + made.fall[0] + made.fall[2];
  }
  if (law == 6) {
    made.fstat = values[0];
    std::copy_n(values + 1, 3, made.fall.begin());
  }
  return made;
}

const Names* area_names(int ipotcn) {
  static const std::map<int, Names> areas{{-6, {"MX", "MY", "AA", "BNEG", "BPOS", "SCALE"}},
                                          {-5, {"MX", "MY", "AA", "BB", "SCALE"}},
                                          {-4, {"MX", "MY", "A1", "BB", "SCALE"}},
                                          {-3, {"MX", "MY", "AA", "BB", "SCALE"}},
                                          {-2, {"MX", "MY", "A1", "AOB", "SCALE"}},
                                          {-1, {"MX", "MY", "A1", "B1", "SCALE"}},
                                          {1, {"MX", "MY", "XL", "YL", "DX", "DY"}},
                                          {2, {"MX", "MY", "XL", "YL", "XH", "YH"}},
                                          {3, {"MX", "MY", "XC1", "YC1", "DX", "DY"}},
                                          {4, {"MX", "MY", "XC1", "YC1", "XCM", "YCM"}}};
  return found_in(areas, ipotcn);
}

}  // namespace rollfem::convert
