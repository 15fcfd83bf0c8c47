// SPDX-License-Identifier: BSD-3-Clause
#include "system/call_order.h"

#include <string>

#include "boxplus/base/error.h"

namespace boxplus {

void CallOrder::refuse(const char* function, const char* expected) {
  throw InvalidArgument(std::string(function) + ": expected " + expected);
}

void CallOrder::refuse_size(const char* function, std::size_t size, std::size_t entries) {
  throw InvalidArgument(std::string(function) + ": expected a vector of " + std::to_string(entries) +
                        " entries, got " + std::to_string(size));
}

}  // namespace boxplus
