// SPDX-License-Identifier: BSD-3-Clause
// Random points for the tests of the manifold laws.
#pragma once

#include <random>
#include <vector>

#include "boxplus/autodiff/dual.h"
#include "boxplus/manifold/manifold.h"

namespace boxplus {

/// Uniformly distributed random numbers, which are the same in every run.
class Samples {
 public:
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }

  template <int N>
  Vector<double, N> vector(double radius) {
    Vector<double, N> v;
    for (int i = 0; i < N; ++i) v[i] = uniform(-radius, radius);
    return v;
  }

  /// The results of `count` calls of make().
  template <class Make>
  static auto many(int count, const Make& make) {
    std::vector<decltype(make())> points;
    for (int i = 0; i < count; ++i) points.push_back(make());
    return points;
  }

 private:
  std::mt19937_64 engine_{42};
};

/// The Jacobian of f(x ⊞ δ) at δ = 0, computed with dual numbers. f takes a point that consists of dual
/// numbers, and returns a vector of `Rows` entries.
template <int Rows, class T, class F>
Matrix<double, Rows, Manifold<T>::kDim> dual_jacobian(const F& f, const T& x) {
  constexpr int n = Manifold<T>::kDim;
  using D = detail::Dual<double, n>;
  D delta[n];
  for (int i = 0; i < n; ++i) delta[i] = D::variable(0, i);
  const Vector<D, Rows> e = f(Manifold<detail::Rebind<T, D>>::oplus(Manifold<T>::template cast<D>(x), delta));
  Matrix<double, Rows, n> jacobian;
  for (int i = 0; i < Rows; ++i) {
    for (int k = 0; k < n; ++k) jacobian(i, k) = e[i].derivative[k];
  }
  return jacobian;
}

}  // namespace boxplus
