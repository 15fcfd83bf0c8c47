// SPDX-License-Identifier: BSD-3-Clause
// Errors and Jacobians of reprojection edges, one edge per lane. The formulas, and the plain functions that
// tests use as a reference, are in boxplus/types/ba/reprojection.h. Each isa_*.cpp includes this file once,
// for its instruction set.
#pragma once

#include "boxplus/types/ba/camera_models.h"
#include "kernels/kernel_table.h"
#include "kernels/transpose.h"
#include "types/ba/lane_number.h"
#include "types/ba/reprojection_kernels.h"

namespace boxplus::dense::BOXPLUS_ISA {

/// The rotation matrix of a unit quaternion (x, y, z, w), by rows.
inline void rotation_of(const LaneNumber* q, LaneNumber (&R)[3][3]) {
  const LaneNumber x2 = q[0] + q[0], y2 = q[1] + q[1], z2 = q[2] + q[2];
  const LaneNumber xx = x2 * q[0], yy = y2 * q[1], zz = z2 * q[2];
  const LaneNumber xy = x2 * q[1], xz = x2 * q[2], yz = y2 * q[2];
  const LaneNumber wx = x2 * q[3], wy = y2 * q[3], wz = z2 * q[3];
  R[0][0] = 1.0 - (yy + zz), R[0][1] = xy - wz, R[0][2] = xz + wy;
  R[1][0] = xy + wz, R[1][1] = 1.0 - (xx + zz), R[1][2] = yz - wx;
  R[2][0] = xz - wy, R[2][1] = yz + wx, R[2][2] = 1.0 - (xx + yy);
}

/// The values of the edges from `first` on: Size values per edge, from `sources`.
template <int Size>
inline void load_numbers(const double* const* sources, int first, int count, LaneNumber (&to)[Size]) {
  const double* lanes[kLanes];
  for (int l = 0; l < kLanes; ++l) lanes[l] = sources[first + l < count ? first + l : count - 1];
  Pack packs[Size];
  load_lanes<Size>(lanes, packs);
  for_each_index<Size>([&](auto i) { to[i].lanes = packs[i]; });
}

template <class Camera>
void reproject(const Reprojections& edges, double* error, double* jacobian) {
  constexpr int kParameters = Camera::kSize;
  const int columns = edges.camera_column < 0 ? 9 : 9 + kParameters;
  for (int first = 0; first < edges.count; first += kLanes) {
    LaneNumber z[2], pose[7], l[3], camera[kParameters], R[3][3], b[3], pixel[2];
    load_numbers(edges.pixel, first, edges.count, z);
    load_numbers(edges.pose, first, edges.count, pose);
    load_numbers(edges.point, first, edges.count, l);
    load_numbers(edges.camera, first, edges.count, camera);
    rotation_of(pose + 3, R);
    const LaneNumber d[3] = {l[0] - pose[0], l[1] - pose[1], l[2] - pose[2]};
    for (int i = 0; i < 3; ++i) b[i] = R[0][i] * d[0] + R[1][i] * d[1] + R[2][i] * d[2];
    LaneNumber J[6], J_camera[2 * kParameters];  // column-major
    if (jacobian == nullptr) {
      Camera::project(b, camera, pixel, nullptr, nullptr);
    } else {
      Camera::project(b, camera, pixel, J, J_camera);
    }
    for (int r = 0; r < 2; ++r)
      store(error + lane_offset(2, first) + r * kTileLanes, (pixel[r] - z[r]).lanes);
    if (jacobian == nullptr) continue;
    double* const to = jacobian + lane_offset(2 * columns, first);
    const auto put = [&](int row, int column, LaneNumber value) {
      store(to + (2 * column + row) * kTileLanes, value.lanes);
    };
    for (int r = 0; r < 2; ++r) {
      const LaneNumber a[3] = {J[r], J[2 + r], J[4 + r]};
      for (int c = 0; c < 3; ++c) {
        const int c1 = (c + 1) % 3, c2 = (c + 2) % 3;
        put(r, c, -a[c]);
        put(r, 3 + c, 2.0 * (a[c1] * b[c2] - a[c2] * b[c1]));  // aᵀ [b]× = (a × b)ᵀ
        put(r, edges.point_column + c, a[0] * R[c][0] + a[1] * R[c][1] + a[2] * R[c][2]);
      }
    }
    if (edges.camera_column < 0) continue;
    for (int m = 0; m < 2 * kParameters; ++m) put(m % 2, edges.camera_column + m / 2, J_camera[m]);
  }
}

template <class>
struct KernelsOf;
template <class... Camera>
struct KernelsOf<detail::CameraTypes<Camera...>> {
  static constexpr Reproject kAll[]{reproject<Camera>...};
};

constinit const Reproject* const kReprojectionKernels = KernelsOf<detail::CameraList>::kAll;

}  // namespace boxplus::dense::BOXPLUS_ISA
