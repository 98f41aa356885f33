// SPDX-License-Identifier: LGPL-2.1-or-later
// Options of models, each a struct that stands with its model.
#pragma once

#include <any>
#include <map>
#include <typeindex>

namespace rollfem::contact {

/// One struct of options of each type, with its default values until it is set.
class ModelOptions {
 public:
  template <class Options>
  const Options& of() const {
    static const Options by_default{};
    const auto found = structs_.find(typeid(Options));
    return found == structs_.end() ? by_default : std::any_cast<const Options&>(found->second);
  }
  /// To change them; not while another thread reads any.
  template <class Options>
  Options& set() {
    std::any& one = structs_[typeid(Options)];
    if (!one.has_value()) one = Options{};
    return std::any_cast<Options&>(one);
  }

 private:
  std::map<std::type_index, std::any> structs_;
};

}  // namespace rollfem::contact
