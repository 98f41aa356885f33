// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tables/filling/table_parts.hpp"

#include "contact/base/threads.hpp"
#include "contact/result/record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <future>
#include <mutex>

namespace rollfem::tables {

namespace {

void exchange(contact::Record& record, std::vector<TablePoint>& points) {
  for (TablePoint& point : points) {
    record.values(point.forces[0], point.forces[1], point.forces[2], point.along_normal);
    record.values(point.bars[0], point.bars[1], point.elements_across);
  }
}

/// Number of points that a thread solves and stores as one record.
constexpr std::size_t longest_part = 64;

std::vector<TablePart> parts_of(std::size_t points, std::size_t of_a_group) {
  std::vector<TablePart> parts;
  for (std::size_t begin = 0; begin < points;) {
    const std::size_t end_of_group = (begin / of_a_group + 1) * of_a_group;
    const std::size_t end = std::min({begin + longest_part, end_of_group, points});
    parts.push_back({begin, end});
    begin = end;
  }
  return parts;
}

}  // namespace

void solve_parts(const TableParts& table, const contact::Progress& progress,
                 contact::Checkpoint* checkpoint) {
  contact::CheckpointPart kept(checkpoint, table.name + "-");
  const std::vector<TablePart> parts = parts_of(table.points, table.of_a_group);
  const auto name_of = [](std::size_t part) { return fmt::format("{:05}", part); };
  contact::ProgressEvent event;
  event.model = "table";
  event.stage = table.stage;
  event.points = static_cast<int>(table.points);
  const auto add = [&](std::size_t p, const std::vector<TablePoint>& points) {
    table.done(parts[p], points);
    event.point += static_cast<int>(points.size());
  };
  std::vector<std::size_t> missing;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    if (const auto bytes = kept.find(name_of(p))) {
      contact::Record record(*bytes);
      std::vector<TablePoint> points(parts[p].end - parts[p].begin);
      exchange(record, points);
      add(p, points);
    } else if (table.share.holds(p)) {
      missing.push_back(p);
    }
  }
  contact::report(progress, event);
  std::atomic<std::size_t> next{0};
  std::mutex telling;
  // Each thread takes one part after another until none is left.
  const auto work = [&] {
    try {
      const contact::SingleThread single;
      for (std::size_t n = next++; n < missing.size(); n = next++) {
        std::vector<TablePoint> points = table.solve(parts[missing[n]]);
        const std::lock_guard<std::mutex> one_at_a_time(telling);
        add(missing[n], points);
        contact::Record record;
        exchange(record, points);
        kept.keep(name_of(missing[n]), record.bytes());
        contact::report(progress, event);
      }
    } catch (...) {
      next = missing.size();  // no thread starts another part
      throw;
    }
  };
  const std::size_t threads = std::min(static_cast<std::size_t>(contact::threads()),
                                       std::max<std::size_t>(missing.size(), 1));
  std::vector<std::future<void>> running;
  for (std::size_t t = 1; t < threads; ++t) running.push_back(std::async(std::launch::async, work));
  work();
  for (std::future<void>& other : running) other.get();
  event.finished = true;
  contact::report(progress, event);
}

}  // namespace rollfem::tables
