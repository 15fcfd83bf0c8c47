// SPDX-License-Identifier: BSD-3-Clause
// The dense kernels of every instruction set that this processor can run.
#include <benchmark/benchmark.h>

#include <random>
#include <vector>

#include "kernels/dense_kernels.h"
#include "kernels/kernel_table.h"

namespace boxplus {
namespace {

std::vector<double> random_numbers(int count) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<double> numbers(static_cast<std::size_t>(count));
  for (double& number : numbers) number = uniform(random);
  return numbers;
}

void report(benchmark::State& state, double flops) {
  state.counters["GFLOP/s"] = benchmark::Counter(flops * 1e-9, benchmark::Counter::kIsIterationInvariantRate);
}

/// A panel of `columns` columns and `below` rows more.
void factor_panel(benchmark::State& state, const dense::KernelTable& table) {
  const int columns = static_cast<int>(state.range(0)), below = static_cast<int>(state.range(1));
  const int rows = columns + below;
  std::vector<double> original = random_numbers(rows * columns), panel;
  for (int j = 0; j < columns; ++j) original[static_cast<std::size_t>(j * rows + j)] = rows + 1;
  const std::vector<double> limits(static_cast<std::size_t>(columns), 0.0);
  for (auto _ : state) {
    panel = original;
    benchmark::DoNotOptimize(table.factor_panel(panel.data(), rows, columns, rows, limits.data()));
  }
  const double n = columns, m = below;
  report(state, n * n * n / 3 + n * n * m);
}

/// C = −A Aᵀ, the lower triangle.
void square(benchmark::State& state, const dense::KernelTable& table) {
  const int size = static_cast<int>(state.range(0)), k = static_cast<int>(state.range(1));
  const std::vector<double> a = random_numbers(size * k);
  std::vector<double> c(static_cast<std::size_t>(size * size));
  for (auto _ : state) {
    table.set_to_minus_square(c.data(), size, a.data(), size, size, k, 0, size);
    benchmark::ClobberMemory();
  }
  report(state, 1.0 * size * (size + 1) * k);
}

const bool registered = [] {
  for (const dense::KernelTable* table : dense::usable_kernels()) {
    const std::string name = table->name;
    for (auto* bench : {benchmark::RegisterBenchmark(("factor_panel/" + name).c_str(), factor_panel, *table),
                        benchmark::RegisterBenchmark(("square/" + name).c_str(), square, *table)}) {
      bench->ArgPair(6, 18)->ArgPair(12, 48)->ArgPair(36, 120)->ArgPair(120, 240)->ArgPair(400, 400);
    }
  }
  return true;
}();

}  // namespace
}  // namespace boxplus
