// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/robust/make_robust_kernel.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>
#include <system_error>

#include "base/number_from_chars.h"
#include "boxplus/base/error.h"
#include "boxplus/robust/barron.h"
#include "boxplus/robust/default_width.h"
#include "boxplus/robust/huber.h"
#include "boxplus/robust/kernel_table.h"
#include "boxplus/robust/redescending.h"

namespace boxplus {

double detail::checked_kernel_width(double delta, std::string_view kernel) {
  if (delta >= kSmallestKernelWidth && delta <= kLargestKernelWidth) return delta;
  const bool is_positive = std::isfinite(delta) && delta > 0;
  throw InvalidArgument(fmt::format("robust kernel {}: expected {}, got {}", kernel,
                                    is_positive ? "a width from 1e-100 to 1e100" : "a finite width > 0",
                                    delta));
}

namespace {

using detail::KernelEntry;

template <class K>
std::unique_ptr<RobustKernel> make(std::string_view /*parameter*/, double delta) {
  return std::make_unique<K>(delta);
}

std::unique_ptr<RobustKernel> make_barron(std::string_view shape, double delta) {
  double alpha = 0;
  const auto [end, error] = number_from_chars(shape.data(), shape.data() + shape.size(), alpha);
  if (error != std::errc() || end != shape.data() + shape.size()) {
    throw InvalidArgument("robust kernel Barron: expected a number as shape in 'Barron:ALPHA', got '" +
                          std::string(shape) + "'");
  }
  return std::make_unique<Barron>(alpha, delta);
}

constexpr bool kSquared = true;
constexpr std::array kKernels = {
    KernelEntry{"Barron:ALPHA", make_barron},
    KernelEntry{Cauchy::kName, make<Cauchy>},
    KernelEntry{DCS::kName, make<DCS>, kSquared},
    KernelEntry{Fair::kName, make<Fair>},
    KernelEntry{GemanMcClure::kName, make<GemanMcClure>, kSquared},
    KernelEntry{Huber::kName, make<Huber>},
    KernelEntry{PseudoHuber::kName, make<PseudoHuber>},
    KernelEntry{Saturated::kName, make<Saturated>},
    KernelEntry{Tukey::kName, make<Tukey>},
    KernelEntry{Welsch::kName, make<Welsch>},
};

/// A row of the table, and the text after the colon in the name of the kernel.
struct Choice {
  const KernelEntry& kernel;
  std::string_view parameter;
};

Choice find(std::string_view name) {
  const std::size_t colon = name.find(':');
  const std::string_view parameter = colon == std::string_view::npos ? "" : name.substr(colon + 1);
  for (const KernelEntry& kernel : kKernels) {
    const std::string_view known = kernel.name.substr(0, kernel.name.find(':'));
    if (known == name.substr(0, colon) && kernel.takes_parameter() == (colon != std::string_view::npos))
      return {kernel, parameter};
  }
  std::string known;
  for (const KernelEntry& kernel : kKernels) known.append(known.empty() ? "" : ", ").append(kernel.name);
  throw InvalidArgument("unknown robust kernel '" + std::string(name) + "'; known kernels: " + known);
}

}  // namespace

std::span<const detail::KernelEntry> detail::kernel_table() {
  return kKernels;
}

std::unique_ptr<RobustKernel> make_robust_kernel(std::string_view name, double delta) {
  const Choice choice = find(name);
  return choice.kernel.make(choice.parameter, delta);
}

std::unique_ptr<RobustKernel> make_default_kernel(std::string_view name, int rows) {
  const Choice choice = find(name);
  const double width = default_width(rows);
  return choice.kernel.make(choice.parameter, choice.kernel.width_is_squared ? width * width : width);
}

}  // namespace boxplus
