// SPDX-License-Identifier: BSD-3-Clause
#include "system/gauge_treatment.h"

#include <algorithm>

namespace boxplus {

void GaugeTreatment::clear() {
  lost_scalars.clear();  // keeps its memory
  holds = true;
  damping = 0;
}

bool GaugeTreatment::hold_lost_pivot(const Plan& plan, std::uint32_t block, std::uint32_t scalar) {
  const auto hold = [&](std::uint32_t i) {
    const bool is_new = std::find(lost_scalars.begin(), lost_scalars.end(), i) == lost_scalars.end();
    if (is_new) lost_scalars.push_back(i);
    return is_new;
  };
  const auto& loose = plan.undetermined_blocks;
  const bool is_loose = std::find(loose.begin(), loose.end(), block) != loose.end();
  if (is_loose && scalar != BlockStructure::kAbsent) return hold(scalar);
  for (const std::uint32_t candidate : loose) {
    for (std::uint32_t i = plan.structure.offset[candidate]; i < plan.structure.offset[candidate + 1]; ++i) {
      if (hold(i)) return true;
    }
  }
  return false;
}

}  // namespace boxplus
