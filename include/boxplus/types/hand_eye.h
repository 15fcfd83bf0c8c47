// SPDX-License-Identifier: BSD-3-Clause
// Hand-eye calibration: the pose of a sensor (the eye) on a body (the hand), from poses of both that somebody
// else measured.
#pragma once

#include "boxplus/types/pose_math.h"
#include "boxplus/types/type_label.h"

namespace boxplus {

namespace detail {
struct HandEyeText {
  static constexpr std::string_view kText = "HandEye";
};
}  // namespace detail

/// A X = X B: `hand` measures A, the motion of the hand between two times (its second pose in the frame of
/// the first), and `eye` measures B, the motion of the eye between the same times. X is the pose of the eye
/// on the hand. Error: (X B) ⊟ (A X), in the frame of the eye at the second time.
///
/// A X = Z B: A is the pose of the hand in the frame of its base, B the pose of the eye relative to a target,
/// and Z the pose of the target in the frame of the base. Error: (Z B) ⊟ (A X).
///
/// Vertices: X, or X and Z. The motions must turn around at least two axes; otherwise, X is not determined.
/// For a start, see calibrate_hand_eye(). If the poses of the hand are vertices, too, use OffsetBetween.
template <class T>
struct HandEye {
  static constexpr std::string_view kName = detail::TypeLabel<detail::HandEyeText, T>::kValue;
  T hand, eye;

  HandEye(const T& A, const T& B) : hand(A), eye(B) {}

  template <class X>
  auto error(const X& x) const {
    return error(x, x);
  }
  template <class X>
  auto error(const X& x, const X& target) const {
    using S = detail::ScalarOf<X>;
    const X by_hand = X(Manifold<T>::template cast<S>(hand) * x),
            by_eye = X(target * Manifold<T>::template cast<S>(eye));
    Vector<S, Manifold<T>::kDim> e;
    Manifold<X>::ominus(by_eye, by_hand, e.data());
    return e;
  }
};

}  // namespace boxplus
