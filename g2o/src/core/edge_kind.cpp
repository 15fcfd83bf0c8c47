// SPDX-License-Identifier: BSD-3-Clause
#include "core/edge_kind.h"

#include <algorithm>
#include <mutex>
#include <typeindex>
#include <unordered_map>
#include <utility>

namespace g2o {
namespace internal {
namespace {

struct Declaration {
  const std::type_info* type;
  const EdgeKind* kind;
};

/// Several libraries in a process may declare the same type. A key refers to the type in the library of the
/// last declaration, because a library that has withdrawn its declaration may be unloaded.
struct EdgeKinds {
  std::mutex mutex;
  std::unordered_map<std::type_index, std::vector<Declaration>> declarations;
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
  std::vector<Declaration> all;
  if (const auto found = known.declarations.find(type); found != known.declarations.end()) {
    all = std::move(found->second);
    known.declarations.erase(found);
  }
  if (declared) {
    all.push_back({&type, &kind});
  } else {
    const auto is_withdrawn = [&](const Declaration& each) { return each.kind == &kind; };
    all.erase(std::remove_if(all.begin(), all.end(), is_withdrawn), all.end());
  }
  if (all.empty()) return;
  const std::type_index key = *all.back().type;
  known.declarations.emplace(key, std::move(all));
}

const EdgeKind* edge_kind(const std::type_info& type) {
  EdgeKinds& known = edge_kinds();
  const std::lock_guard<std::mutex> lock(known.mutex);
  const auto found = known.declarations.find(type);
  return found == known.declarations.end() ? nullptr : found->second.back().kind;
}

}  // namespace internal
}  // namespace g2o
