// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/core/drawing.h"

namespace g2o {

Drawing::~Drawing() = default;

void Drawing::cube(const Isometry3& pose, const Color& color, double side, double width) {
  const double half = side / 2;
  std::vector<Vector3> bottom, top;
  for (const auto& [x, y] : {std::pair(-half, -half), {half, -half}, {half, half}, {-half, half}}) {
    bottom.emplace_back(pose * Vector3(x, y, -half));
    top.emplace_back(pose * Vector3(x, y, half));
  }
  polyline(bottom, true, color, width);
  polyline(top, true, color, width);
  for (size_t i = 0; i < bottom.size(); ++i) line(bottom[i], top[i], color, width);
}

}  // namespace g2o
