// SPDX-License-Identifier: LGPL-2.1-or-later
// A checkpoint that keeps its records in memory.
#pragma once

#include "base/checkpoint.hpp"

#include "support/test.hpp"

namespace rollfem::testing {

class RecordsInMemory : public contact::Checkpoint {
 public:
  std::optional<std::string> find(const std::string& name) override {
    const auto found = records.find(name);
    return found == records.end() ? std::nullopt : std::optional<std::string>(found->second);
  }
  void keep(const std::string& name, const std::string& record) override { records[name] = record; }

  void refuse(const std::string& /*name*/) override { ++refused; }

  std::map<std::string, std::string> records;
  int refused = 0;
};

}  // namespace rollfem::testing
