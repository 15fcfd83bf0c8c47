// SPDX-License-Identifier: BSD-3-Clause
// The tags of TORO (Grisetti, Stachniss, Burgard, "Nonlinear constraint network optimization for efficient
// map learning", 2009), and the older names of two of them, which Gm2dl has. All files may contain these
// tags; only files of TORO and Gm2dl are written with them.
#include <algorithm>
#include <array>

#include "boxplus/io/registry.h"
#include "boxplus/types/slam2d.h"
#include "boxplus/types/slam3d.h"
#include "io/toro/euler_pose.h"
#include "io/toro/toro_format.h"

namespace boxplus {
namespace {

/// The file lists the entries of Ω in the order xx xy yy θθ xθ yθ.
struct ToroEdge2 : EdgeFields<Between<SE2>> {
  static void to_upper_triangle(std::span<double> v) {
    const std::array upper{v[0], v[1], v[4], v[2], v[5], v[3]};
    std::copy(upper.begin(), upper.end(), v.begin());
  }
  static void from_upper_triangle(std::span<double> v) {
    const std::array listed{v[0], v[1], v[3], v[5], v[2], v[4]};
    std::copy(listed.begin(), listed.end(), v.begin());
  }
};

struct ToroPose3 {
  static SE3 read(FieldReader& in) { return read_euler_pose(in); }
  static void write(const SE3& pose, FieldWriter& out) { write_euler_pose(pose, out); }
};

/// In TORO, Ω weights small errors in x y z roll pitch yaw.
struct ToroEdge3 {
  static Between<SE3> read(FieldReader& in) { return Between<SE3>(read_euler_pose(in)); }
  static void write(const Between<SE3>& edge, FieldWriter& out) { write_euler_pose(edge.measurement, out); }
  static void to_upper_triangle(std::span<double> listed) {
    for_each_scale(listed, [](double& value, double scale) { value *= scale; });
  }
  static void from_upper_triangle(std::span<double> upper) {
    for_each_scale(upper, [](double& value, double scale) { value /= scale; });
  }

 private:
  template <class F>
  static void for_each_scale(std::span<double> values, F f) {
    constexpr int kRows = 6;
    auto value = values.begin();
    for (int i = 0; i < kRows; ++i) {
      for (int j = i; j < kRows; ++j) f(*value++, euler_row_scale(i) * euler_row_scale(j));
    }
  }
};

constexpr const char* kPose2 = "1 1 0.1 0.5";
constexpr const char* kEdge2 = "0 1 1 0 0.5 4 1 3 2 0 0.5";
constexpr const char* kPose3 = "1 1 0 0.5 0.1 -0.2 3";
constexpr const char* kEdge3 = "0 1 1 0 0.5 0.1 -0.2 3 9 0 0 0 0 0 9 0 0 0 0 9 0 0 0 4 0 0 4 0 4";

}  // namespace

void register_toro(Registry& registry) {
  registry.old_vertex<SE2>("VERTEX2", kPose2);
  registry.old_edge<ToroEdge2, Between<SE2>, SE2, SE2>("EDGE2", kEdge2);
  registry.old_vertex<SE2>("VERTEX", kPose2);
  registry.old_edge<ToroEdge2, Between<SE2>, SE2, SE2>("EDGE", kEdge2);
  registry.old_vertex<SE3, ToroPose3>("VERTEX3", kPose3);
  registry.old_edge<ToroEdge3, Between<SE3>, SE3, SE3>("EDGE3", kEdge3);
}

const Registry& toro_registry() {
  static const Registry registry = [] {
    Registry tags;
    tags.vertex<SE2>("VERTEX2", kPose2);
    tags.edge_with_fields<ToroEdge2, Between<SE2>, SE2, SE2>("EDGE2", kEdge2);
    tags.vertex<SE3, ToroPose3>("VERTEX3", kPose3);
    tags.edge_with_fields<ToroEdge3, Between<SE3>, SE3, SE3>("EDGE3", kEdge3);
    return tags;
  }();
  return registry;
}

const Registry& gm2dl_registry() {
  static const Registry registry = [] {
    Registry tags;
    tags.vertex<SE2>("VERTEX", kPose2);
    tags.edge_with_fields<ToroEdge2, Between<SE2>, SE2, SE2>("EDGE", kEdge2);
    return tags;
  }();
  return registry;
}

}  // namespace boxplus
