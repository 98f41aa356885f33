// SPDX-License-Identifier: LGPL-2.1-or-later
// Working memory of an object whose const members run on several threads at once.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace rollfem::contact {

/// Makes as many as are in use at the same time, and keeps them for later calls.
template <class Work>
class Spares {
 public:
  using Loan = std::unique_ptr<Work, std::function<void(Work*)>>;

  /// For the exclusive use of the caller until the loan ends; contents are those that an earlier
  /// user left, or as made by `make`.
  template <class Make>
  Loan borrow(const Make& make) const {
    std::unique_ptr<Work> work;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (!spare_.empty()) {
        work = std::move(spare_.back());
        spare_.pop_back();
      }
    }
    if (!work) work = make();
    return Loan(work.release(), [this](Work* done) {
      const std::lock_guard<std::mutex> lock(mutex_);
      spare_.emplace_back(done);
    });
  }

 private:
  mutable std::mutex mutex_;
  mutable std::vector<std::unique_ptr<Work>> spare_;
};

}  // namespace rollfem::contact
