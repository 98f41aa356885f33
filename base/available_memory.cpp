// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/available_memory.hpp"

#include "base/errors.hpp"
#include "base/text_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>

namespace rollfem::contact {

namespace {

constexpr double gigabyte = 1e9;
constexpr double unlimited = std::numeric_limits<double>::infinity();

/// The value of a line "name 123 ...", in the unit of the line.
double line_in(const std::string& file, const std::string& name) {
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(line);
    std::string first;
    double value = 0.0;
    if (words >> first >> value && (first == name || first == name + ":")) return value;
  }
  return unlimited;
}

/// Memory left below a limit; file pages that the kernel can drop do not count as used.
double left_below(double limit, double used, double droppable) {
  if (!std::isfinite(limit) || !std::isfinite(used)) return unlimited;
  if (!std::isfinite(droppable)) droppable = 0.0;
  return std::max(0.0, limit - used + droppable);
}

double left_in_cgroups(const std::string& proc, const std::string& root) {
  double left = unlimited;
  for_each_cgroup(proc, root, "memory", [&](const std::string& group, bool unified) {
    left = std::min(left, unified
                              ? left_below(first_number(group + "/memory.max"),
                                           first_number(group + "/memory.current"),
                                           line_in(group + "/memory.stat", "inactive_file"))
                              : left_below(first_number(group + "/memory.limit_in_bytes"),
                                           first_number(group + "/memory.usage_in_bytes"),
                                           line_in(group + "/memory.stat", "total_inactive_file")));
  });
  return left;
}

}  // namespace

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

double available_bytes(const std::string& proc, const std::string& cgroup) {
  const double kilobytes = line_in(proc + "/meminfo", "MemAvailable");
  return std::min(1024.0 * kilobytes, left_in_cgroups(proc, cgroup));
}

double available_bytes() {
  if (const char* text = std::getenv("ROLLFEM_MEMORY_GB")) {
    const std::optional<double> value = number_of(text);
    if (!value || !(*value > 0.0))
      throw InputError(fmt::format(
          "ROLLFEM_MEMORY_GB = {}: allowed: a number of GB above 0; do: change or unset it", text));
    return *value * gigabyte;
  }
  return available_bytes("/proc", "/sys/fs/cgroup");
}

std::string in_gigabytes(double bytes) {
  return std::isfinite(bytes) ? fmt::format("{:.3g} GB", bytes / gigabyte) : "unknown memory";
}

}  // namespace rollfem::contact
