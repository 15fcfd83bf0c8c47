// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/algorithm/algorithm_table.h"

#include <string>

#include "algorithm/dogleg.h"
#include "algorithm/gauss_newton.h"
#include "algorithm/levenberg_marquardt.h"
#include "boxplus/base/error.h"

namespace boxplus {

namespace {

template <class A>
std::unique_ptr<Algorithm> make() {
  return std::make_unique<A>();
}

constexpr detail::AlgorithmEntry kAlgorithms[] = {
    {AlgorithmKind::kAutomatic, nullptr},
    {AlgorithmKind::kGaussNewton, make<GaussNewton>},
    {AlgorithmKind::kLevenbergMarquardt, make<LevenbergMarquardt>},
    {AlgorithmKind::kDogleg, make<Dogleg>},
};

}  // namespace

std::span<const detail::AlgorithmEntry> detail::algorithm_table() {
  return kAlgorithms;
}

std::unique_ptr<Algorithm> make_algorithm(AlgorithmKind kind) {
  for (const detail::AlgorithmEntry& entry : kAlgorithms) {
    if (entry.kind == kind && entry.make != nullptr) return entry.make();
  }
  throw InvalidArgument("make_algorithm: expected one of the algorithms of the library, got AlgorithmKind " +
                        std::to_string(static_cast<int>(kind)));
}

}  // namespace boxplus
