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

void exchange(contact::Record& record, TablePoint& point) {
  for (double& force : point.forces) record.value(force);
  record.values(point.along_normal, point.bars[0], point.bars[1], point.elements_across);
}

std::string bytes_of(std::vector<TablePoint> points) {
  contact::Record record;
  for (TablePoint& point : points) exchange(record, point);
  return record.bytes();
}

std::vector<TablePoint> points_of(const std::string& bytes, std::size_t count) {
  contact::Record record(bytes);
  std::vector<TablePoint> points(count);
  for (TablePoint& point : points) exchange(record, point);
  return points;
}

/// State shared by the threads; each takes one part after another until none is left.
class SharedParts {
 public:
  SharedParts(const TableParts& table, const contact::Progress& progress,
              contact::Checkpoint* checkpoint)
      : table_(table), progress_(progress), checkpoint_(checkpoint) {
    for (const TablePart& part : table.parts) points_ += part.end - part.begin;
  }

  void take_up() {
    for (std::size_t p = 0; p < table_.parts.size(); ++p) {
      const TablePart& part = table_.parts[p];
      const auto kept = checkpoint_ == nullptr ? std::nullopt : checkpoint_->find(name_of(p));
      if (!kept) {
        if (table_.share.holds(p)) missing_.push_back(p);
        continue;
      }
      table_.done(part, points_of(*kept, part.end - part.begin));
      done_ += part.end - part.begin;
    }
  }

  std::size_t missing() const { return missing_.size(); }

  void operator()() {
    try {
      const contact::SingleThread single;
      for (std::size_t n = next_++; n < missing_.size(); n = next_++) solve(missing_[n]);
    } catch (...) {
      next_ = missing_.size();  // no thread starts another part
      throw;
    }
  }

  void tell(bool finished) const {
    contact::ProgressEvent event;
    event.model = "table";
    event.stage = table_.stage;
    event.point = static_cast<int>(done_);
    event.points = static_cast<int>(points_);
    event.finished = finished;
    contact::report(progress_, event);
  }

 private:
  std::string name_of(std::size_t part) const { return fmt::format("{}-{:05}", table_.name, part); }

  void solve(std::size_t p) {
    const TablePart& part = table_.parts[p];
    const std::vector<TablePoint> points = table_.solve(part);
    const std::lock_guard<std::mutex> one_at_a_time(telling_);
    table_.done(part, points);
    if (checkpoint_ != nullptr) checkpoint_->keep(name_of(p), bytes_of(points));
    done_ += points.size();
    tell(false);
  }

  const TableParts& table_;
  const contact::Progress& progress_;
  contact::Checkpoint* checkpoint_;
  std::size_t points_ = 0, done_ = 0;
  std::vector<std::size_t> missing_;
  std::atomic<std::size_t> next_{0};
  std::mutex telling_;
};

/// Number of points that a thread solves and stores as one record.
constexpr std::size_t longest_part = 64;

}  // namespace

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

void solve_parts(const TableParts& table, const contact::Progress& progress,
                 contact::Checkpoint* checkpoint) {
  SharedParts work(table, progress, checkpoint);
  work.take_up();
  work.tell(false);
  const std::size_t threads = std::min(static_cast<std::size_t>(contact::threads()),
                                       std::max<std::size_t>(work.missing(), 1));
  std::vector<std::future<void>> running;
  for (std::size_t t = 1; t < threads; ++t)
    running.push_back(std::async(std::launch::async, [&work] { work(); }));
  work();
  for (std::future<void>& other : running) other.get();
  work.tell(true);
}

}  // namespace rollfem::tables
