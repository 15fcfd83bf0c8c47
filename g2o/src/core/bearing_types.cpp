// SPDX-License-Identifier: BSD-3-Clause
#include "core/bearing_types.h"

#include <atomic>
#include <mutex>
#include <typeindex>
#include <unordered_map>

#include "g2o/core/side_by_side.h"

namespace g2o {
namespace internal {
namespace {

struct BearingTypes {
  std::mutex mutex;
  std::unordered_map<std::type_index, int> declarations;
  std::atomic<std::uint64_t> revision = 0;
};

/// Never destroyed: static objects of clients and plug-ins take their declarations back late.
BearingTypes& bearing_types() {
  static BearingTypes& instance = *new BearingTypes;
  return instance;
}

}  // namespace

void allow_side_by_side(const std::type_info& type, bool allowed) {
  BearingTypes& known = bearing_types();
  const std::lock_guard<std::mutex> lock(known.mutex);
  int& declarations = known.declarations[type];
  declarations += allowed ? 1 : -1;
  if (declarations == 0) known.declarations.erase(type);
  ++known.revision;
}

bool bears_threads(const std::type_info& type) {
  const std::lock_guard<std::mutex> lock(bearing_types().mutex);
  return bearing_types().declarations.count(type) > 0;
}

std::uint64_t bearing_types_revision() {
  return bearing_types().revision;
}

}  // namespace internal
}  // namespace g2o
