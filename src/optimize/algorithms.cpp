// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/optimize/algorithms.h"

#include <algorithm>
#include <string>

#include "boxplus/base/error.h"
#include "optimize/dogleg.h"
#include "optimize/gauss_newton.h"
#include "optimize/levenberg_marquardt.h"

namespace boxplus {

namespace {

template <class A>
std::unique_ptr<Algorithm> make() {
  return std::make_unique<A>();
}

constexpr detail::AlgorithmEntry kAlgorithms[] = {
    {AlgorithmKind::kAutomatic, "automatic", nullptr},
    {AlgorithmKind::kGaussNewton, "gauss-newton", make<GaussNewton>},
    {AlgorithmKind::kLevenbergMarquardt, "levenberg-marquardt", make<LevenbergMarquardt>},
    {AlgorithmKind::kDogleg, "dogleg", make<Dogleg>},
};

const detail::AlgorithmEntry* find(AlgorithmKind kind) {
  const auto* found = std::find_if(std::begin(kAlgorithms), std::end(kAlgorithms),
                                   [&](const auto& entry) { return entry.kind == kind; });
  return found == std::end(kAlgorithms) ? nullptr : found;
}

}  // namespace

std::span<const detail::AlgorithmEntry> detail::algorithm_table() {
  return kAlgorithms;
}

std::unique_ptr<Algorithm> make_algorithm(AlgorithmKind kind) {
  const detail::AlgorithmEntry* entry = find(kind);
  if (entry == nullptr || entry->make == nullptr)
    throw InvalidArgument("make_algorithm: expected one of the library's algorithms, got AlgorithmKind " +
                          std::to_string(static_cast<int>(kind)));
  return entry->make();
}

std::string_view to_string(AlgorithmKind kind) {
  const detail::AlgorithmEntry* entry = find(kind);
  return entry == nullptr ? "unknown" : entry->name;
}

}  // namespace boxplus
