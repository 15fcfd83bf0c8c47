// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/graph/type_name.h"

#include <cxxabi.h>

#include <cstdlib>
#include <memory>

namespace boxplus::detail {

std::string demangle(const char* mangled) {
  int status = 0;
  const std::unique_ptr<char, decltype(&std::free)> plain(
      abi::__cxa_demangle(mangled, nullptr, nullptr, &status), &std::free);
  return status == 0 ? plain.get() : mangled;
}

}  // namespace boxplus::detail
