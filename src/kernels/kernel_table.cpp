// SPDX-License-Identifier: BSD-3-Clause
#include "kernels/kernel_table.h"

#include <cstdlib>
#include <string_view>

#include "kernels/dense_kernels.h"

namespace boxplus::dense {
namespace {

struct Usable {
  const KernelTable* tables[3] = {&baseline::kTable};
  std::size_t count = 1;

  Usable() {
#ifdef BOXPLUS_X86_KERNELS
    __builtin_cpu_init();
    const bool has_avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    if (has_avx2) tables[count++] = &avx2::kTable;
    if (has_avx2 && __builtin_cpu_supports("avx512f")) tables[count++] = &avx512::kTable;
#endif
  }
};

const KernelTable* chosen() {
  const auto usable = usable_kernels();
  if (const char* wanted = std::getenv("BOXPLUS_ISA")) {
    for (const KernelTable* table : usable) {
      if (std::string_view(wanted) == table->name) return table;
    }
  }
  return usable.back();
}

const KernelTable*& in_use() {
  static const KernelTable* table = chosen();
  return table;
}

}  // namespace

std::span<const KernelTable* const> usable_kernels() {
  static const Usable usable;
  return {usable.tables, usable.count};
}

const KernelTable& kernels() {
  return *in_use();
}

void use_kernels(const KernelTable& table) {
  in_use() = &table;
}

int factor_panel(double* panel, int rows, int columns, int ld, const double* minimum_pivot) {
  return kernels().factor_panel(panel, rows, columns, ld, minimum_pivot);
}

void set_to_minus_square(double* c, int ldc, const double* a, int lda, int size, int k, int begin, int end) {
  kernels().set_to_minus_square(c, ldc, a, lda, size, k, begin, end);
}

void subtract_square(double* c, int ldc, const double* a, int lda, int size, int k, int begin, int end) {
  kernels().subtract_square(c, ldc, a, lda, size, k, begin, end);
}

void subtract_product_transposed(double* c, int ldc, const double* a, int lda, const double* b, int ldb,
                                 int rows, int columns, int k) {
  kernels().subtract_product_transposed(c, ldc, a, lda, b, ldb, rows, columns, k);
}

void subtract_product(double* c, int ldc, const double* a, int lda, const double* b, int ldb, int rows,
                      int columns, int k) {
  kernels().subtract_product(c, ldc, a, lda, b, ldb, rows, columns, k);
}

void divide_by_transposed(double* x, int ldx, const double* l, int ldl, int rows, int size) {
  kernels().divide_by_transposed(x, ldx, l, ldl, rows, size);
}

void divide_by(double* x, int ldx, const double* l, int ldl, int rows, int size) {
  kernels().divide_by(x, ldx, l, ldl, rows, size);
}

void solve_forward(const double* panel, int rows, int columns, int ld, double* work) {
  kernels().solve_forward(panel, rows, columns, ld, work);
}

void solve_backward(const double* panel, int rows, int columns, int ld, double* work) {
  kernels().solve_backward(panel, rows, columns, ld, work);
}

}  // namespace boxplus::dense
