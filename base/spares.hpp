// SPDX-License-Identifier: LGPL-2.1-or-later
// Memory to work in that is kept from one use to the next, by an object that several threads use at
// once.
#pragma once

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace rollfem::contact {

/// Must outlive what was borrowed from it.
template <class Work>
class Spares {
 public:
  /// The caller's own until it goes out of scope, with what an earlier use left in it; made by
  /// make() while all others are in use.
  template <class Make>
  auto borrow(const Make& make) const {
    std::unique_ptr<Work> work = left_over();
    if (!work) work = make();
    const auto give_back = [this](Work* used) {
      const std::lock_guard<std::mutex> lock(mutex_);
      free_.emplace_back(used);
    };
    return std::unique_ptr<Work, decltype(give_back)>(work.release(), give_back);
  }
  auto borrow() const {
    return borrow([] { return std::make_unique<Work>(); });
  }

 private:
  std::unique_ptr<Work> left_over() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (free_.empty()) {
      free_.reserve(++made_);
      return nullptr;
    }
    std::unique_ptr<Work> work = std::move(free_.back());
    free_.pop_back();
    return work;
  }

  mutable std::mutex mutex_;
  mutable std::size_t made_ = 0;
  mutable std::vector<std::unique_ptr<Work>> free_;
};

}  // namespace rollfem::contact
