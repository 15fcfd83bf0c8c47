// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/linear/linear_solver.h"

namespace boxplus {

std::string_view to_string(Precision precision) {
  switch (precision) {
    case Precision::kAutomatic:
      return "automatic";
    case Precision::kDouble:
      return "double";
    case Precision::kMixed:
      return "mixed";
  }
  return "unknown";
}

}  // namespace boxplus
