// SPDX-License-Identifier: BSD-3-Clause
// Computes errors and Jacobians of relative-pose edges, one edge per lane. The formulas are in
// between_jacobians.h of boxplus/types/slam2d and boxplus/types/slam3d, together with plain functions that
// tests use as a reference.
#pragma once

#include "kernels/kernel_table.h"
#include "kernels/transpose.h"

namespace boxplus::dense::BOXPLUS_ISA {

inline Pack all(double value) {
  return Pack{} + value;
}

/// Wraps an angle that lies in (−2π, 2π) to (−π, π].
inline Pack wrapped(Pack angle) {
  constexpr double kPi = 3.14159265358979323846;
  const Pack above = angle > all(kPi) ? angle - 2 * kPi : angle;
  return angle > all(-kPi) ? above : angle + 2 * kPi;
}

/// The error and, unless `jacobian` is null, the Jacobian for poses in the plane, given as x y θ cos θ sin θ.
inline void between_se2_of(const Pack* z, const Pack* i, const Pack* j, double* error, double* jacobian) {
  const auto put = [](double* to, int m, Pack value) { store(to + m * kTileLanes, value); };
  const Pack dx = j[0] - i[0], dy = j[1] - i[1];
  const Pack ax = i[3] * dx + i[4] * dy, ay = i[3] * dy - i[4] * dx;  // Xi⁻¹ Xj
  const Pack ac = i[3] * j[3] + i[4] * j[4], as = i[3] * j[4] - i[4] * j[3];
  const Pack ex = ax - z[0], ey = ay - z[1];
  put(error, 0, z[3] * ex + z[4] * ey);
  put(error, 1, z[3] * ey - z[4] * ex);
  put(error, 2, wrapped(wrapped(j[2] - i[2]) - z[2]));
  if (jacobian == nullptr) return;
  const Pack c = z[3] * ac + z[4] * as, s = z[3] * as - z[4] * ac, zero{};
  const Pack columns[18] = {-z[3],
                            z[4],
                            zero,
                            -z[4],
                            -z[3],
                            zero,  //
                            z[3] * ay - z[4] * ax,
                            -(z[4] * ay) - z[3] * ax,
                            all(-1),
                            c,
                            s,
                            zero,
                            -s,
                            c,
                            zero,
                            zero,
                            zero,
                            all(1)};
  for (int m = 0; m < 18; ++m) put(jacobian, m, columns[m]);
}

struct LaneQuaternion {
  Pack x, y, z, w;
};

/// conj(a) b.
inline LaneQuaternion conjugate_times(const LaneQuaternion& a, const LaneQuaternion& b) {
  return {a.w * b.x - a.x * b.w - a.y * b.z + a.z * b.y, a.w * b.y + a.x * b.z - a.y * b.w - a.z * b.x,
          a.w * b.z - a.x * b.y + a.y * b.x - a.z * b.w, a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z};
}

/// R(q)ᵀ p.
inline void rotate_back(const LaneQuaternion& q, const Pack (&p)[3], Pack (&out)[3]) {
  const Pack tx = 2 * (q.z * p[1] - q.y * p[2]);
  const Pack ty = 2 * (q.x * p[2] - q.z * p[0]);
  const Pack tz = 2 * (q.y * p[0] - q.x * p[1]);
  out[0] = p[0] + q.w * tx - (q.y * tz - q.z * ty);
  out[1] = p[1] + q.w * ty - (q.z * tx - q.x * tz);
  out[2] = p[2] + q.w * tz - (q.x * ty - q.y * tx);
}

/// R(q), column by column.
inline void rotation_columns(const LaneQuaternion& q, Pack (&r)[3][3]) {
  const Pack x2 = 2 * q.x, y2 = 2 * q.y, z2 = 2 * q.z;
  const Pack xx = x2 * q.x, yy = y2 * q.y, zz = z2 * q.z;
  const Pack xy = x2 * q.y, xz = x2 * q.z, yz = y2 * q.z, wx = x2 * q.w, wy = y2 * q.w, wz = z2 * q.w;
  const Pack one = all(1);
  r[0][0] = one - (yy + zz), r[0][1] = xy + wz, r[0][2] = xz - wy;
  r[1][0] = xy - wz, r[1][1] = one - (xx + zz), r[1][2] = yz + wx;
  r[2][0] = xz + wy, r[2][1] = yz - wx, r[2][2] = one - (xx + yy);
}

/// The error and, unless `jacobian` is null, the Jacobian for poses in space, given as x y z qx qy qz qw.
inline void between_se3_of(const Pack* z, const Pack* i, const Pack* j, double* error, double* jacobian) {
  const LaneQuaternion qz{z[3], z[4], z[5], z[6]}, qi{i[3], i[4], i[5], i[6]}, qj{j[3], j[4], j[5], j[6]};
  const LaneQuaternion qa = conjugate_times(qi, qj), qd = conjugate_times(qz, qa);
  Pack ta[3], td[3];
  rotate_back(qi, {j[0] - i[0], j[1] - i[1], j[2] - i[2]}, ta);
  rotate_back(qz, {ta[0] - z[0], ta[1] - z[1], ta[2] - z[2]}, td);
  const Pack sign = qd.w < all(0) ? all(-1) : all(1);
  const Pack e[6] = {td[0], td[1], td[2], sign * qd.x, sign * qd.y, sign * qd.z};
  for (int r = 0; r < 6; ++r) store(error + r * kTileLanes, e[r]);
  if (jacobian == nullptr) return;

  const auto put = [&](int row, int column, Pack value) {
    store(jacobian + (column * 6 + row) * kTileLanes, value);
  };
  Pack rz[3][3], rd[3][3];
  rotation_columns(qz, rz);
  rotation_columns(qd, rd);
  // (w_Z I − [v_Z]×)(w_A I − [v_A]×) + v_Z v_Aᵀ = (w_Z w_A − v_Z·v_A) I − [w_Z v_A + w_A v_Z]×
  //                                               + v_A v_Zᵀ + v_Z v_Aᵀ,
  // because [a]× [b]× = b aᵀ − (a·b) I.
  const Pack vz[3] = {qz.x, qz.y, qz.z}, va[3] = {qa.x, qa.y, qa.z};
  const Pack diagonal = qz.w * qa.w - (vz[0] * va[0] + vz[1] * va[1] + vz[2] * va[2]);
  const Pack cross_i[3] = {qz.w * va[0] + qa.w * vz[0], qz.w * va[1] + qa.w * vz[1],
                           qz.w * va[2] + qa.w * vz[2]};
  const Pack cross_j[3] = {qd.x, qd.y, qd.z};
  const Pack zero{};
#pragma GCC unroll 3
  for (int c = 0; c < 3; ++c) {
    const int c1 = (c + 1) % 3, c2 = (c + 2) % 3;  // column c of [v]× has v[c2] in row c1, −v[c1] in row c2
#pragma GCC unroll 3
    for (int r = 0; r < 3; ++r) {
      // The rows of R_Zᵀ are the columns of R_Z.
      put(r, c, -rz[r][c]);
      put(r, 3 + c, 2 * (rz[r][c1] * ta[c2] - rz[r][c2] * ta[c1]));
      put(3 + r, c, zero);
      const Pack symmetric = va[r] * vz[c] + vz[r] * va[c];
      const Pack skew_i = r == c ? diagonal : r == c1 ? -cross_i[c2] : cross_i[c1];
      put(3 + r, 3 + c, -sign * (symmetric + skew_i));
      put(r, 6 + c, rd[c][r]);
      put(r, 9 + c, zero);
      put(3 + r, 6 + c, zero);
      put(3 + r, 9 + c, sign * (r == c ? qd.w : r == c1 ? cross_j[c2] : -cross_j[c1]));
    }
  }
}

/// Applies `between` to all edges. Each pose consists of N values.
template <int N, int kRows, class Between>
inline void between_all(const PosePairs& edges, double* error, double* jacobian, Between&& between) {
  for (int k = 0; k < edges.count; k += kLanes) {
    const double* sources[3][kLanes];
    for (int l = 0; l < kLanes; ++l) {
      const int edge = k + l < edges.count ? k + l : edges.count - 1;
      sources[0][l] = edges.measurement[edge];
      sources[1][l] = edges.from[edge];
      sources[2][l] = edges.to[edge];
    }
    Pack poses[3][N];
    for (int p = 0; p < 3; ++p) load_lanes<N>(sources[p], poses[p]);
    between(poses[0], poses[1], poses[2], error + lane_offset(kRows, k),
            jacobian ? jacobian + lane_offset(2 * kRows * kRows, k) : nullptr);
  }
}

inline void between_se2(const PosePairs& edges, double* error, double* jacobian) {
  between_all<5, 3>(edges, error, jacobian, [](auto... a) { between_se2_of(a...); });
}

inline void between_se3(const PosePairs& edges, double* error, double* jacobian) {
  between_all<7, 6>(edges, error, jacobian, [](auto... a) { between_se3_of(a...); });
}

}  // namespace boxplus::dense::BOXPLUS_ISA
