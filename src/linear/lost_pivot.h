// SPDX-License-Identifier: BSD-3-Clause
// The test whether a pivot counts as not positive.
#pragma once

namespace boxplus {

/// A pivot d of scalar column j counts as lost when d ≤ kLostPivot · vᵀ diag(A + λD) v. Here v, with v_j = 1
/// and zeros after j, is the direction along which eliminating the columns before j leaves just d: vᵀ (A +
/// λD) v = d.
///
/// Rounding perturbs entry (i, k) of A + λD by about ε √(a_ii a_kk), and so d by about ε vᵀ diag(A + λD) v. A
/// pivot below 45 ε = 1e-14 of this has no correct digits. d / (vᵀ diag v) ≥ 1 / (condition number of A + λD
/// scaled to unit diagonal), so a matrix with a scaled condition number below 1e14 is never refused. A pose
/// graph without an anchor, whose last pivots are rounding noise of a few ε vᵀ diag v, is always found.
///
/// Because v_j = 1, d ≤ kLostPivot · a_jj is sufficient; this costs one comparison per pivot. The sum over v
/// needs a back-substitution, so it is computed only for the few smallest pivots below kSuspiciousPivot ·
/// a_jj.
inline constexpr double kLostPivot = 1e-14;
inline constexpr double kSuspiciousPivot = 1e-6;

template <class Scalar>
inline constexpr Scalar kLostPivotOf = kLostPivot;
template <class Scalar>
inline constexpr Scalar kSuspiciousPivotOf = kSuspiciousPivot;
/// In float, 5 ε is the smallest bound that finds pivots without correct digits. A factor in double must then
/// decide whether the pivot is positive.
template <>
inline constexpr float kLostPivotOf<float> = 3e-7F;
template <>
inline constexpr float kSuspiciousPivotOf<float> = 1e-2F;

}  // namespace boxplus
