// SPDX-License-Identifier: BSD-3-Clause
// When a pivot counts as not positive.
#pragma once

namespace boxplus {

/// A pivot d of scalar column j counts as lost when d ≤ kLostPivot · vᵀ diag(A + λD) v. Here v, with v_j = 1
/// and zeros after j, is the direction along which eliminating the columns before j leaves just d: vᵀ (A +
/// λD) v = d.
///
/// Rounding perturbs entry (i, k) of A + λD by about ε √(a_ii a_kk), hence d by about ε vᵀ diag(A + λD) v, so
/// that below 45 ε = 1e-14 of this there are no digits left. Because d / (vᵀ diag v) ≥ 1 / (condition number
/// of A + λD scaled to unit diagonal), no matrix whose scaled condition number is below 1e14 is ever refused,
/// whereas the freedom of a pose graph without anchor, which leaves noise of a few ε vᵀ diag v on the last
/// pivots, is found.
///
/// v_j = 1 makes d ≤ kLostPivot · a_jj sufficient, which costs one comparison per pivot. The sum needs a
/// back-substitution; it is formed only for the smallest few pivots below kSuspiciousPivot · a_jj.
inline constexpr double kLostPivot = 1e-14;
inline constexpr double kSuspiciousPivot = 1e-6;

template <class Scalar>
inline constexpr Scalar kLostPivotOf = kLostPivot;
template <class Scalar>
inline constexpr Scalar kSuspiciousPivotOf = kSuspiciousPivot;
/// In float, where 5 ε is the least that finds what has no digits left: such a pivot is for a factor in
/// double to judge.
template <>
inline constexpr float kLostPivotOf<float> = 3e-7F;
template <>
inline constexpr float kSuspiciousPivotOf<float> = 1e-2F;

}  // namespace boxplus
