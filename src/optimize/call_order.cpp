// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/call_order.h"

#include <string>

#include "boxplus/base/error.h"

namespace boxplus {

void CallOrder::refuse(const char* function, const char* expected) {
  throw InvalidArgument(std::string(function) + ": expected " + expected);
}

}  // namespace boxplus
