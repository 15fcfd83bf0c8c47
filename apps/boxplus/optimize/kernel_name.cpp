// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/kernel_name.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <vector>

#include "boxplus/base/error.h"
#include "boxplus/robust/default_width.h"
#include "boxplus/robust/kernel_table.h"
#include "boxplus/robust/make_robust_kernel.h"

namespace boxplus::app {
namespace {

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

/// Returns the usual spelling of a name: "Huber" for "huber" and "Barron:1" for "barron:1". Returns unknown
/// names unchanged.
std::string spelt_out(const std::string& text) {
  const std::size_t end = std::min(text.find(':'), text.size());
  for (const detail::KernelEntry& kernel : detail::kernel_table()) {
    const std::string known(kernel.name.substr(0, kernel.name.find(':')));
    if (lower(text.substr(0, end)) == lower(known)) return known + text.substr(end);
  }
  return text;
}

}  // namespace

CLI::Validator kernel_name() {
  const auto check = [](std::string& name) {
    name = spelt_out(name);
    try {
      make_default_kernel(name, 1);
      return std::string();
    } catch (const InvalidArgument& error) {
      return std::string(error.what());
    }
  };
  std::vector<std::string_view> names;
  for (const detail::KernelEntry& kernel : detail::kernel_table()) names.push_back(kernel.name);
  return {check, fmt::format("{{{}}}", fmt::join(names, ","))};
}

std::string kernels_with_squared_width() {
  std::vector<std::string_view> names;
  for (const detail::KernelEntry& kernel : detail::kernel_table()) {
    if (kernel.width_is_squared) names.push_back(kernel.name);
  }
  return fmt::format("{}", fmt::join(names, " and "));
}

}  // namespace boxplus::app
