// SPDX-License-Identifier: BSD-3-Clause
// The tags of TORO (Grisetti, Stachniss, Burgard, "Nonlinear constraint network optimization for efficient
// map learning", 2009), and the older names of two of them, which Gm2dl has. The reader accepts these tags.
// The writer uses the corresponding tags of .g2o instead.
#include <algorithm>
#include <array>

#include "boxplus/io/registry.h"
#include "boxplus/types/slam2d.h"
#include "boxplus/types/slam3d.h"
#include "io/toro/euler_pose.h"

namespace boxplus {
namespace {

/// The file lists the entries of Ω in the order xx xy yy θθ xθ yθ.
struct ToroEdge2 : EdgeFields<Between<SE2>> {
  static void to_upper_triangle(std::span<double> v) {
    const std::array upper{v[0], v[1], v[4], v[2], v[5], v[3]};
    std::copy(upper.begin(), upper.end(), v.begin());
  }
};

struct ToroPose3 {
  static SE3 read(FieldReader& in) { return read_euler_pose(in); }
};

/// In TORO, Ω weights small errors in x y z roll pitch yaw.
struct ToroEdge3 {
  static Between<SE3> read(FieldReader& in) { return Between<SE3>(read_euler_pose(in)); }
  static void to_upper_triangle(std::span<double> listed) {
    constexpr int kRows = 6;
    auto value = listed.begin();
    for (int i = 0; i < kRows; ++i) {
      for (int j = i; j < kRows; ++j) *value++ *= euler_row_scale(i) * euler_row_scale(j);
    }
  }
};

}  // namespace

void register_toro(Registry& registry) {
  registry.old_vertex<SE2>("VERTEX2", "1 1 0.1 0.5");
  registry.old_edge<ToroEdge2, Between<SE2>, SE2, SE2>("EDGE2", "0 1 1 0 0.5 4 1 3 2 0 0.5");
  registry.old_vertex<SE2>("VERTEX", "1 1 0.1 0.5");
  registry.old_edge<ToroEdge2, Between<SE2>, SE2, SE2>("EDGE", "0 1 1 0 0.5 4 1 3 2 0 0.5");
  registry.old_vertex<SE3, ToroPose3>("VERTEX3", "1 1 0 0.5 0.1 -0.2 3");
  registry.old_edge<ToroEdge3, Between<SE3>, SE3, SE3>(
      "EDGE3", "0 1 1 0 0.5 0.1 -0.2 3 9 0 0 0 0 0 9 0 0 0 0 9 0 0 0 4 0 0 4 0 4");
}

}  // namespace boxplus
