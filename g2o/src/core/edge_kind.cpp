// SPDX-License-Identifier: BSD-3-Clause
#include "core/edge_kind.h"

#include <algorithm>
#include <mutex>
#include <typeindex>
#include <unordered_map>

namespace g2o {
namespace internal {
namespace {

/// Several libraries in a process may declare the same type.
struct EdgeKinds {
  std::mutex mutex;
  std::unordered_map<std::type_index, std::vector<const EdgeKind*>> kinds;
};

/// The object is not destroyed at exit, because plug-ins may still withdraw their declarations at that time.
EdgeKinds& edge_kinds() {
  static EdgeKinds& instance = *new EdgeKinds;
  return instance;
}

}  // namespace

void declare_edge_kind(const std::type_info& type, const EdgeKind& kind, bool declared) {
  EdgeKinds& known = edge_kinds();
  const std::lock_guard<std::mutex> lock(known.mutex);
  std::vector<const EdgeKind*>& kinds = known.kinds[type];
  if (declared) {
    kinds.push_back(&kind);
  } else {
    kinds.erase(std::remove(kinds.begin(), kinds.end(), &kind), kinds.end());
  }
}

const EdgeKind* edge_kind(const std::type_info& type) {
  EdgeKinds& known = edge_kinds();
  const std::lock_guard<std::mutex> lock(known.mutex);
  const auto found = known.kinds.find(type);
  return found == known.kinds.end() || found->second.empty() ? nullptr : found->second.back();
}

}  // namespace internal
}  // namespace g2o
