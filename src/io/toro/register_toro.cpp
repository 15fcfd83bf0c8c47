// SPDX-License-Identifier: BSD-3-Clause
// The tags of TORO (Grisetti, Stachniss, Burgard, "Nonlinear constraint network optimization for efficient
// map learning", 2009). The reader accepts these tags. The writer uses the corresponding tags of .g2o
// instead.
#include <algorithm>
#include <array>
#include <cmath>

#include "boxplus/io/registry.h"
#include "boxplus/types/slam2d.h"
#include "boxplus/types/slam3d.h"

namespace boxplus {
namespace {

/// The file lists the entries of Ω in the order xx xy yy θθ xθ yθ.
struct ToroEdge2 : EdgeFields<Between<SE2>> {
  static void to_upper_triangle(std::span<double> v) {
    const std::array upper{v[0], v[1], v[4], v[2], v[5], v[3]};
    std::copy(upper.begin(), upper.end(), v.begin());
  }
};

/// The file lists a pose as x y z roll pitch yaw. The rotation is Rz(yaw) Ry(pitch) Rx(roll).
struct ToroPose3 {
  static SE3 read(FieldReader& in) {
    Vector3 t;
    in.numbers(t.data(), 3, "a coordinate");
    const double roll = in.number("the roll angle") / 2, pitch = in.number("the pitch angle") / 2,
                 yaw = in.number("the yaw angle") / 2;
    const double cr = std::cos(roll), sr = std::sin(roll), cp = std::cos(pitch), sp = std::sin(pitch),
                 cy = std::cos(yaw), sy = std::sin(yaw);
    return SE3(t, detail::Quaternion<double>{cy * cp * sr - sy * sp * cr, cy * sp * cr + sy * cp * sr,
                                             sy * cp * cr - cy * sp * sr, cy * cp * cr + sy * sp * sr});
  }
};

/// In TORO, Ω weights small errors in x y z roll pitch yaw. In boxplus, the rotation error is the vector part
/// of a quaternion, which is half as large, so the rows and columns of Ω for the rotation are doubled.
struct ToroEdge3 {
  static Between<SE3> read(FieldReader& in) { return Between<SE3>(ToroPose3::read(in)); }
  static void to_upper_triangle(std::span<double> listed) {
    constexpr int kRows = 6;
    const auto scale = [](int row) { return row < 3 ? 1 : 2; };
    auto value = listed.begin();
    for (int i = 0; i < kRows; ++i) {
      for (int j = i; j < kRows; ++j) *value++ *= scale(i) * scale(j);
    }
  }
};

}  // namespace

void register_toro(Registry& registry) {
  registry.old_vertex<SE2>("VERTEX2", "1 1 0.1 0.5");
  registry.old_edge<ToroEdge2, Between<SE2>, SE2, SE2>("EDGE2", "0 1 1 0 0.5 4 1 3 2 0 0.5");
  registry.old_vertex<SE3, ToroPose3>("VERTEX3", "1 1 0 0.5 0.1 -0.2 3");
  registry.old_edge<ToroEdge3, Between<SE3>, SE3, SE3>(
      "EDGE3", "0 1 1 0 0.5 0.1 -0.2 3 9 0 0 0 0 0 9 0 0 0 0 9 0 0 0 4 0 0 4 0 4");
}

}  // namespace boxplus
