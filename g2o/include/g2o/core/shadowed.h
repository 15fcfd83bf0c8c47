// SPDX-License-Identifier: BSD-3-Clause
// A list of registrations that are hidden by other registrations with the same names.
#pragma once
#ifndef G2O_SHADOWED_H
#define G2O_SHADOWED_H

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace g2o {
namespace internal {

/// Keeps the hidden registrations of a registry. Several copies of a library in one process may register the
/// same names in one registry. When a copy is unloaded, it withdraws only its own registrations, so that the
/// registrations of the other copies remain.
template <class T>
class Shadowed {
 public:
  using Ptr = std::shared_ptr<T>;

  /// Makes `one` the current registration of the name and hides the previous registration.
  void replace(const std::string& name, Ptr& current, const Ptr& one) {
    if (current == one) return;
    remove(name, one);
    if (current != nullptr) hide(name, current);
    current = one;
  }
  void hide(const std::string& name, const Ptr& one) {
    remove(name, one);
    hidden_.emplace_back(name, one);
  }
  /// Withdraws `one`. If `one` was current, sets `current` to the registration that was hidden last, or to
  /// nullptr. Returns false if `one` was neither hidden nor current.
  bool take_back(const std::string& name, Ptr& current, const Ptr& one) {
    if (current == one) {
      current = last(name);
      return true;
    }
    return remove(name, one);
  }
  void forget(const std::string& name) {
    while (last(name) != nullptr) continue;
  }

 private:
  bool remove(const std::string& name, const Ptr& one) {
    const auto at = std::find(hidden_.begin(), hidden_.end(), std::make_pair(name, one));
    if (at == hidden_.end()) return false;
    hidden_.erase(at);
    return true;
  }
  Ptr last(const std::string& name) {
    for (auto at = hidden_.end(); at != hidden_.begin();) {
      if ((--at)->first != name) continue;
      Ptr found = std::move(at->second);
      hidden_.erase(at);
      return found;
    }
    return nullptr;
  }

  std::vector<std::pair<std::string, Ptr>> hidden_;
};

}  // namespace internal
}  // namespace g2o

#endif  // G2O_SHADOWED_H
