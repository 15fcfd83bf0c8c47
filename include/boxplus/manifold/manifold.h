// SPDX-License-Identifier: BSD-3-Clause
// Manifold<T>: the trait that makes a type T a manifold, so that T can be the type of a vertex.
//
// Specialize the trait for your own type, or for a type of another library:
//
//     template <> struct boxplus::Manifold<Pose> {
//       static constexpr int kDim = 3;                                      // tangent size, or kDynamic
//       static Pose oplus(const Pose& x, const double* delta);              // x ⊞ δ
//       static void ominus(const Pose& y, const Pose& x, double* delta);    // δ with x ⊞ δ = y
//     };
//
// If the size is chosen at run time (kDim == kDynamic), add `static int dim(const Pose& x)`. For exact
// Jacobians of edges, add three members that lift an estimate to another scalar S (a dual number):
//
//     template <class S> using Rebind = BasicPose<S>;
//     template <class S> static BasicPose<S> cast(const Pose& x);
//   and Manifold<BasicPose<S>>::oplus(const BasicPose<S>&, const S* delta).
//
// Without these three members, the edges of the vertex are differentiated numerically, and the Report says
// so.
//
// To allow bounds of a vertex (Graph::set_bounds()), add `static double* entry(Pose& x, int i)`: the number
// in x to which ⊞ adds δ[i], or nullptr if there is none.
//
// Laws, for all x, y and all small δ (testing/check_manifold.h checks them):
//   (1) x ⊞ 0 = x                  (2) x ⊞ (y ⊟ x) = y
//   (3) (x ⊞ δ) ⊟ x = δ            (4) ⊞ is smooth in δ at 0, with a Jacobian of full rank kDim there
// Here y ⊟ x is the result of ominus(y, x, ·). Law 2 may fail on the cut locus of the chart (a rotation by
// π).
#pragma once

#include <concepts>

#include "boxplus/base/matrix.h"

namespace boxplus {

template <class T>
struct Manifold;

}  // namespace boxplus

namespace boxplus::detail {

/// A copyable type T for which the trait Manifold<T> is complete.
template <class T>
concept ManifoldType = std::copyable<T> && requires(const T& x, const T& y, const double* in, double* out) {
  { Manifold<T>::kDim } -> std::convertible_to<int>;
  { Manifold<T>::oplus(x, in) } -> std::convertible_to<T>;
  Manifold<T>::ominus(y, x, out);
  requires Manifold<T>::kDim != kDynamic || requires {
    { Manifold<T>::dim(x) } -> std::convertible_to<int>;
  };
};

/// The dimension of the tangent space at x.
template <ManifoldType T>
constexpr int tangent_dim(const T& x) {
  if constexpr (Manifold<T>::kDim == kDynamic) {
    return Manifold<T>::dim(x);
  } else {
    return Manifold<T>::kDim;
  }
}

/// The number in x to which x ⊞ δ adds δ[i], or nullptr if there is none.
template <ManifoldType T>
double* entry(T& x, int i) {
  if constexpr (requires { Manifold<T>::entry(x, i); }) {
    return Manifold<T>::entry(x, i);
  } else {
    return nullptr;
  }
}

/// The type T with the scalar S in place of double.
template <class T, class S>
using Rebind = typename Manifold<T>::template Rebind<S>;

/// A manifold whose estimates can be lifted to another scalar, so that exact derivatives pass through ⊞.
template <class T, class S>
concept LiftableManifold = ManifoldType<T> &&
    requires(const T& x, const Rebind<T, S>& lifted, const S* delta) {
  { Manifold<T>::template cast<S>(x) } -> std::convertible_to<Rebind<T, S>>;
  { Manifold<Rebind<T, S>>::oplus(lifted, delta) } -> std::convertible_to<Rebind<T, S>>;
};

}  // namespace boxplus::detail
