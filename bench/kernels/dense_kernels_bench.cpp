// SPDX-License-Identifier: BSD-3-Clause
// Measures the dense kernels of every instruction set that this processor can run.
#include <benchmark/benchmark.h>

#include <random>
#include <vector>

#include "kernels/dense_kernels.h"
#include "kernels/kernel_table.h"

namespace boxplus {
namespace {

template <class Scalar>
std::vector<Scalar> random_numbers(int count) {
  std::mt19937 random(1);
  std::uniform_real_distribution<Scalar> uniform(-1, 1);
  std::vector<Scalar> numbers(static_cast<std::size_t>(count));
  for (Scalar& number : numbers) number = uniform(random);
  return numbers;
}

void report(benchmark::State& state, double flops) {
  state.counters["GFLOP/s"] = benchmark::Counter(flops * 1e-9, benchmark::Counter::kIsIterationInvariantRate);
}

/// Computes the Cholesky factorization of a panel: the first `columns` rows are a square, and `below` more
/// rows follow.
template <class Scalar>
void factor_panel(benchmark::State& state, const dense::FactorKernels<Scalar>& kernels) {
  const int columns = static_cast<int>(state.range(0)), below = static_cast<int>(state.range(1));
  const int rows = columns + below;
  std::vector<Scalar> original = random_numbers<Scalar>(rows * columns), panel;
  for (int j = 0; j < columns; ++j)
    original[static_cast<std::size_t>(j * rows + j)] = static_cast<Scalar>(rows + 1);
  const std::vector<Scalar> limits(static_cast<std::size_t>(columns), Scalar{0});
  for (auto _ : state) {
    panel = original;
    benchmark::DoNotOptimize(kernels.factor_panel(panel.data(), rows, columns, rows, limits.data()));
  }
  const double n = columns, m = below;
  report(state, n * n * n / 3 + n * n * m);
}

/// Computes the lower triangle of C = −A Aᵀ.
template <class Scalar>
void square(benchmark::State& state, const dense::FactorKernels<Scalar>& kernels) {
  const int size = static_cast<int>(state.range(0)), k = static_cast<int>(state.range(1));
  const std::vector<Scalar> a = random_numbers<Scalar>(size * k);
  std::vector<Scalar> c(static_cast<std::size_t>(size * size));
  for (auto _ : state) {
    kernels.set_to_minus_square(c.data(), size, a.data(), size, size, k, 0, size);
    benchmark::ClobberMemory();
  }
  report(state, 1.0 * size * (size + 1) * k);
}

template <class Scalar>
void register_all(const std::string& set, const dense::FactorKernels<Scalar>& kernels) {
  for (auto* bench :
       {benchmark::RegisterBenchmark(("factor_panel/" + set).c_str(), factor_panel<Scalar>, kernels),
        benchmark::RegisterBenchmark(("square/" + set).c_str(), square<Scalar>, kernels)}) {
    bench->ArgPair(6, 18)->ArgPair(12, 48)->ArgPair(36, 120)->ArgPair(120, 240)->ArgPair(400, 400);
  }
}

const bool registered = [] {
  for (const dense::KernelTable* table : dense::usable_kernels()) {
    register_all<double>(table->name, table->in_double);
    register_all<float>(std::string(table->name) + "/float", table->in_float);
  }
  return true;
}();

}  // namespace
}  // namespace boxplus
