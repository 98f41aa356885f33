// Wall-clock seconds since a start: the cost stored with every result.
#pragma once

#include <chrono>

namespace rollfem::contact {

class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace rollfem::contact
