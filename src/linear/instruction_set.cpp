// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/linear/instruction_set.h"

#include "kernels/kernel_table.h"

namespace boxplus {

std::string_view instruction_set() {
  return dense::kernels().name;
}

std::vector<std::string_view> instruction_sets() {
  std::vector<std::string_view> names;
  for (const dense::KernelTable* table : dense::usable_kernels()) names.emplace_back(table->name);
  return names;
}

}  // namespace boxplus
