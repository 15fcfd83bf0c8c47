// SPDX-License-Identifier: BSD-3-Clause
#include "core/thread_safe_types.h"

#include <atomic>
#include <mutex>
#include <typeindex>
#include <unordered_map>

#include "g2o/core/thread_safe.h"

namespace g2o {
namespace internal {
namespace {

struct ThreadSafeTypes {
  std::mutex mutex;
  std::unordered_map<std::type_index, int> declarations;
  std::atomic<std::uint64_t> revision = 0;
};

/// The object is not destroyed at exit, because static objects of clients and plug-ins may still withdraw
/// their declarations at that time.
ThreadSafeTypes& thread_safe_types() {
  static ThreadSafeTypes& instance = *new ThreadSafeTypes;
  return instance;
}

}  // namespace

void declare_thread_safe(const std::type_info& type, bool declared) {
  ThreadSafeTypes& known = thread_safe_types();
  const std::lock_guard<std::mutex> lock(known.mutex);
  int& declarations = known.declarations[type];
  declarations += declared ? 1 : -1;
  if (declarations == 0) known.declarations.erase(type);
  ++known.revision;
}

bool is_thread_safe(const std::type_info& type) {
  const std::lock_guard<std::mutex> lock(thread_safe_types().mutex);
  return thread_safe_types().declarations.count(type) > 0;
}

std::uint64_t thread_safe_types_revision() {
  return thread_safe_types().revision;
}

}  // namespace internal
}  // namespace g2o
