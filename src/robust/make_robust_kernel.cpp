// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/robust/make_robust_kernel.h"

#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <system_error>

#include "boxplus/base/error.h"
#include "boxplus/robust/barron.h"
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

struct Entry {
  std::string_view name;
  std::unique_ptr<RobustKernel> (*make)(double delta);
};

constexpr std::array kKernels = {
    Entry{Cauchy::kName, make<Cauchy>},       Entry{DCS::kName, make<DCS>},
    Entry{Fair::kName, make<Fair>},           Entry{GemanMcClure::kName, make<GemanMcClure>},
    Entry{Huber::kName, make<Huber>},         Entry{PseudoHuber::kName, make<PseudoHuber>},
    Entry{Saturated::kName, make<Saturated>}, Entry{Tukey::kName, make<Tukey>},
    Entry{Welsch::kName, make<Welsch>},
};

constexpr std::string_view kBarronPrefix = "Barron:";
constexpr std::string_view kBarronUsage = "Barron:ALPHA";

constexpr auto kNames = [] {
  std::array<std::string_view, kKernels.size() + 1> names{kBarronUsage};
  for (std::size_t i = 0; i < kKernels.size(); ++i) names[i + 1] = kKernels[i].name;
  return names;
}();

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

std::span<const std::string_view> robust_kernel_names() {
  return kNames;
}

std::unique_ptr<RobustKernel> make_robust_kernel(std::string_view name, double delta) {
  for (const Entry& entry : kKernels) {
    if (entry.name == name) return entry.make(delta);
  }
  if (name.starts_with(kBarronPrefix)) {
    return make_barron(name.substr(kBarronPrefix.size()), delta);
  }
  std::string message = "unknown robust kernel '" + std::string(name) + "'; known are";
  for (const std::string_view known : kNames) message += " " + std::string(known);
  throw InvalidArgument(message);
}

}  // namespace boxplus
