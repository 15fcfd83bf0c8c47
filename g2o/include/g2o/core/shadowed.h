// SPDX-License-Identifier: BSD-3-Clause
// What another registration of the same name hides.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace g2o {
namespace internal {

/// Copies of a library in one process may share the registries of one of them, and register the same there.
/// Each takes back its own when it is unloaded, and what it hid, or was hidden by, stays.
template <class T>
class Shadowed {
 public:
  void put(const std::string& name, std::shared_ptr<T> hidden) {
    hidden_.emplace_back(name, std::move(hidden));
  }
  /// The last one put under the name; nullptr where there is none.
  std::shared_ptr<T> take(const std::string& name) {
    for (auto at = hidden_.end(); at != hidden_.begin();) {
      if ((--at)->first != name) continue;
      std::shared_ptr<T> last = std::move(at->second);
      hidden_.erase(at);
      return last;
    }
    return nullptr;
  }
  /// Takes one back that is hidden; false where it is not.
  bool remove(const std::shared_ptr<T>& one) {
    for (auto at = hidden_.begin(); at != hidden_.end(); ++at) {
      if (at->second != one) continue;
      hidden_.erase(at);
      return true;
    }
    return false;
  }

 private:
  std::vector<std::pair<std::string, std::shared_ptr<T>>> hidden_;
};

}  // namespace internal
}  // namespace g2o
