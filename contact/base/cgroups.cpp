// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/base/cgroups.hpp"

#include <fstream>
#include <limits>

namespace rollfem::contact {

void for_each_cgroup(const std::string& proc, const std::string& root,
                     const std::string& controller,
                     const std::function<void(const std::string& group, bool unified)>& visit) {
  std::ifstream stream(proc + "/self/cgroup");
  for (std::string line; std::getline(stream, line);) {
    const std::size_t first = line.find(':');
    const std::size_t second = line.find(':', first + 1);
    if (first == std::string::npos || second == std::string::npos) continue;
    const std::string controllers = "," + line.substr(first + 1, second - first - 1) + ",";
    const bool unified = controllers == ",,";
    if (!unified && controllers.find("," + controller + ",") == std::string::npos) continue;
    const std::string base = unified ? root : root + "/" + controller;
    for (std::string path = line.substr(second + 1);; path.resize(path.rfind('/'))) {
      while (!path.empty() && path.back() == '/') path.pop_back();
      visit(base + path, unified);
      if (path.empty() || path.find('/') == std::string::npos) break;
    }
  }
}

double first_number(const std::string& file) {
  std::ifstream stream(file);
  double value = 0.0;
  return stream >> value ? value : std::numeric_limits<double>::infinity();
}

}  // namespace rollfem::contact
