// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/robust/make_robust_kernel.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>
#include <system_error>

#include "boxplus/base/error.h"
#include "boxplus/robust/barron.h"
#include "boxplus/robust/default_width.h"
#include "boxplus/robust/huber.h"
#include "boxplus/robust/redescending.h"

namespace boxplus {

double checked_kernel_width(double delta, std::string_view kernel) {
  if (std::isfinite(delta) && delta > 0) return delta;
  throw InvalidArgument("robust kernel " + std::string(kernel) + ": expected a finite width > 0, got " +
                        std::to_string(delta));
}

namespace {

template <class K>
std::unique_ptr<RobustKernel> make(double delta) {
  return std::make_unique<K>(delta);
}

/// The units of a kernel's width: those of √e², or of e².
enum class WidthUnit : std::uint8_t { kError, kSquaredError };

struct Entry {
  std::string_view name;
  std::unique_ptr<RobustKernel> (*make)(double delta);
  WidthUnit unit = WidthUnit::kError;
};

constexpr std::array kKernels = {
    Entry{Cauchy::kName, make<Cauchy>},
    Entry{DCS::kName, make<DCS>, WidthUnit::kSquaredError},
    Entry{Fair::kName, make<Fair>},
    Entry{GemanMcClure::kName, make<GemanMcClure>, WidthUnit::kSquaredError},
    Entry{Huber::kName, make<Huber>},
    Entry{PseudoHuber::kName, make<PseudoHuber>},
    Entry{Saturated::kName, make<Saturated>},
    Entry{Tukey::kName, make<Tukey>},
    Entry{Welsch::kName, make<Welsch>},
};

constexpr std::string_view kBarronPrefix = "Barron:";
constexpr std::string_view kBarronUsage = "Barron:ALPHA";

constexpr auto kNames = [] {
  std::array<std::string_view, kKernels.size() + 1> names{kBarronUsage};
  for (std::size_t i = 0; i < kKernels.size(); ++i) names[i + 1] = kKernels[i].name;
  return names;
}();

const Entry* find(std::string_view name) {
  const auto found =
      std::find_if(kKernels.begin(), kKernels.end(), [&](const Entry& e) { return e.name == name; });
  return found == kKernels.end() ? nullptr : &*found;
}

std::unique_ptr<RobustKernel> make_barron(std::string_view shape, double delta) {
  double alpha = 0;
  const auto [end, error] = std::from_chars(shape.data(), shape.data() + shape.size(), alpha);
  if (error != std::errc() || end != shape.data() + shape.size()) {
    throw InvalidArgument("robust kernel Barron: expected a number as shape in 'Barron:ALPHA', got '" +
                          std::string(shape) + "'");
  }
  return std::make_unique<Barron>(alpha, delta);
}

}  // namespace

std::unique_ptr<RobustKernel> make_default_kernel(std::string_view name, int rows) {
  const Entry* entry = find(name);
  const bool is_squared = entry && entry->unit == WidthUnit::kSquaredError;
  const double width = default_width(rows);
  return make_robust_kernel(name, is_squared ? width * width : width);
}

std::span<const std::string_view> robust_kernel_names() {
  return kNames;
}

std::unique_ptr<RobustKernel> make_robust_kernel(std::string_view name, double delta) {
  if (const Entry* entry = find(name)) return entry->make(delta);
  if (name.starts_with(kBarronPrefix)) {
    return make_barron(name.substr(kBarronPrefix.size()), delta);
  }
  std::string message = "unknown robust kernel '" + std::string(name) + "'; known are";
  for (const std::string_view known : kNames) message += " " + std::string(known);
  throw InvalidArgument(message);
}

}  // namespace boxplus
