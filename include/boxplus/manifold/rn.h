// SPDX-License-Identifier: BSD-3-Clause
// Vector spaces as manifolds: all Eigen column vectors, and single numbers (one-dimensional). ⊞ is addition.
#pragma once

#include "boxplus/autodiff/dual.h"
#include "boxplus/base/matrix.h"
#include "boxplus/manifold/lift.h"
#include "boxplus/manifold/manifold.h"
#include "boxplus/manifold/same_size.h"
#include "boxplus/manifold/scalar.h"

namespace boxplus {

/// Column vectors of fixed or run-time size, with any Eigen options. ominus() throws InvalidArgument if the
/// sizes differ.
template <class S, int N, int Options, int MaxRows, int MaxCols>
struct Manifold<Eigen::Matrix<S, N, 1, Options, MaxRows, MaxCols>> {
  using Point = Eigen::Matrix<S, N, 1, Options, MaxRows, MaxCols>;
  template <class T>
  using Rebind = Eigen::Matrix<T, N, 1, Options, MaxRows, MaxCols>;
  static constexpr int kDim = N == Eigen::Dynamic ? kDynamic : N;

  static int dim(const Point& x) { return static_cast<int>(x.size()); }

  template <class D>
  static Rebind<detail::Promoted<S, D>> oplus(const Point& x, const D* delta) {
    Rebind<detail::Promoted<S, D>> y(x.size());
    for (Eigen::Index i = 0; i < x.size(); ++i) y[i] = x[i] + delta[i];
    return y;
  }
  template <class D>
  static void ominus(const Point& y, const Point& x, D* delta) {
    detail::require_same_size(x, "the other vector", y);
    for (Eigen::Index i = 0; i < x.size(); ++i) delta[i] = y[i] - x[i];
  }
  template <class T>
  static Rebind<T> cast(const Point& x) {
    Rebind<T> y(x.size());
    for (Eigen::Index i = 0; i < x.size(); ++i) y[i] = T(x[i]);
    return y;
  }
  template <class T>
  static void lift(const Point& x, const detail::Seed<T>& seed, Rebind<T>& y) {
    for (int i = 0; i < N; ++i) seed.set(y[i], x[i], i, {1.0});
  }
  static S* entry(Point& x, int i) { return &x[i]; }
};

/// The real line.
template <class S>
requires(std::is_same_v<S, double> || detail::kIsDual<S>) struct Manifold<S> {
  template <class T>
  using Rebind = T;
  static constexpr int kDim = 1;

  template <class D>
  static detail::Promoted<S, D> oplus(const S& x, const D* delta) {
    return x + delta[0];
  }
  template <class D>
  static void ominus(const S& y, const S& x, D* delta) {
    delta[0] = y - x;
  }
  template <class T>
  static T cast(const S& x) {
    return T(x);
  }
  template <class T>
  static void lift(const S& x, const detail::Seed<T>& seed, T& y) {
    seed.set(y, x, 0, {1.0});
  }
  static S* entry(S& x, int /*i*/) { return &x; }
};

}  // namespace boxplus
