// SPDX-License-Identifier: LGPL-2.1-or-later
// What every test begins with: GoogleTest, the usual headers of the standard library, and the names
// that tests use without a prefix. Compiled once (tests/CMakeLists.txt). Headers of this folder
// bring it, except those that the benchmarks use as well.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace rollfem::contact {}
namespace rollfem::testing {}

using namespace rollfem;
using namespace rollfem::contact;
using namespace rollfem::testing;
