// SPDX-License-Identifier: BSD-3-Clause
#include "io/written_errors.h"

#include <fmt/format.h>

#include <cmath>

#include "boxplus/base/error.h"

namespace boxplus {

void require_equal_error(std::string_view format, const ObservationName& name, const Vector2& of_graph,
                         const Vector2& of_file) {
  constexpr double kRounding = 1e-4;
  const double wanted = std::hypot(of_graph[0], of_graph[1]), got = std::hypot(of_file[0], of_file[1]);
  if (!std::isfinite(wanted) || std::abs(got - wanted) <= kRounding * (1 + wanted)) return;
  throw InvalidArgument(
      fmt::format("cannot write {}: {} {} and point {}: expected values so moderate that the file keeps the "
                  "reprojection error of {:.6g} pixels, got {:.6g} pixels after rounding",
                  format, name.image, name.image_id, name.point_id, wanted, got));
}

}  // namespace boxplus
