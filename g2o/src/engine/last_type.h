// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <typeinfo>

#include "core/thread_safe_types.h"

namespace g2o {
namespace internal {

/// Remembers is_thread_safe() of the last type, because most objects have the same type.
class LastType {
 public:
  bool allowed(const std::type_info& type) {
    if (last_ != &type) {
      allowed_ = is_thread_safe(type);
      last_ = &type;
    }
    return allowed_;
  }

 private:
  const std::type_info* last_ = nullptr;
  bool allowed_ = false;
};

}  // namespace internal
}  // namespace g2o
