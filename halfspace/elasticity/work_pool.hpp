// SPDX-License-Identifier: LGPL-2.1-or-later
// Memory to work in that is kept from one use to the next, by an object that several threads use at
// once.
#pragma once

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace rollfem::halfspace {

/// Must outlive what was taken from it.
template <class Work>
class WorkPool {
 public:
  /// The caller's own until it goes out of scope; holds what an earlier use left in it.
  auto take() {
    std::unique_ptr<Work> work = left_over();
    if (!work) work = std::make_unique<Work>();
    const auto give_back = [this](Work* used) {
      const std::lock_guard<std::mutex> lock(mutex_);
      free_.emplace_back(used);
    };
    return std::unique_ptr<Work, decltype(give_back)>(work.release(), give_back);
  }

 private:
  std::unique_ptr<Work> left_over() {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (free_.empty()) {
      free_.reserve(++made_);
      return nullptr;
    }
    std::unique_ptr<Work> work = std::move(free_.back());
    free_.pop_back();
    return work;
  }

  std::mutex mutex_;
  std::size_t made_ = 0;
  std::vector<std::unique_ptr<Work>> free_;
};

}  // namespace rollfem::halfspace
