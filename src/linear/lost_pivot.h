// SPDX-License-Identifier: BSD-3-Clause
// The test that decides whether a pivot counts as not positive.
#pragma once

namespace boxplus {

/// A pivot d of scalar column j counts as lost if d ≤ kLostPivot · vᵀ diag(A + λD) v. The vector v has v_j =
/// 1, zeros after j, and before j the values that minimize vᵀ (A + λD) v. The minimum is d.
///
/// Rounding perturbs entry (i, k) of A + λD by about ε √(a_ii a_kk), and so it perturbs d by about
/// ε vᵀ diag(A + λD) v. If d is below 45 ε = 1e-14 times vᵀ diag(A + λD) v, it has no correct digits. The
/// ratio d / (vᵀ diag(A + λD) v) is at least 1 / (condition number of A + λD, scaled to unit diagonal). So a
/// matrix with a scaled condition number below 1e14 is never rejected. A pose graph without an anchor is
/// always rejected, because its last pivots are rounding noise of a few ε vᵀ diag(A + λD) v.
///
/// Because v_j = 1, a pivot with d ≤ kLostPivot · a_jj is certainly lost. This check costs one comparison per
/// pivot. Computing v takes a back-substitution, so this is done only for the few smallest pivots below
/// kSuspiciousPivot · a_jj.
inline constexpr double kLostPivot = 1e-14;
inline constexpr double kSuspiciousPivot = 1e-6;

template <class Scalar>
inline constexpr Scalar kLostPivotOf = kLostPivot;
template <class Scalar>
inline constexpr Scalar kSuspiciousPivotOf = kSuspiciousPivot;
/// In float, the bound is only 2.5 ε, which just finds pivots without correct digits. A factor in double must
/// then decide whether the pivot is positive.
template <>
inline constexpr float kLostPivotOf<float> = 3e-7F;
template <>
inline constexpr float kSuspiciousPivotOf<float> = 1e-2F;

}  // namespace boxplus
