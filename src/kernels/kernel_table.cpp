// SPDX-License-Identifier: BSD-3-Clause
#include "kernels/kernel_table.h"

#include <cstdlib>
#include <string_view>

namespace boxplus::dense {
namespace {

struct Usable {
  const KernelTable* tables[3] = {&baseline::kTable};
  std::size_t count = 1;

  Usable() {  // NOLINT(modernize-use-equals-default): it is not empty on x86 and ARM
#ifdef BOXPLUS_X86_KERNELS
    __builtin_cpu_init();
    const bool has_avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    if (has_avx2) tables[count++] = &avx2::kTable;
    if (has_avx2 && __builtin_cpu_supports("avx512f")) tables[count++] = &avx512::kTable;
#elif defined(BOXPLUS_ARM_KERNELS)
    tables[count++] = &neon::kTable;  // all 64-bit ARM processors have NEON
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

}  // namespace boxplus::dense
