// SPDX-License-Identifier: BSD-3-Clause
// Checks whether a type, such as your own, obeys the laws of manifold.h. Needs no test framework:
//
//     const ManifoldCheck check = check_manifold<Pose>({Pose(…), Pose(…)});
//     if (!check.ok) std::puts(check.message.c_str());
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "boxplus/autodiff/dual.h"
#include "boxplus/manifold/manifold.h"
#include "boxplus/manifold/numeric_jacobian.h"

namespace boxplus {

/// If `ok` is false, `message` says which law is violated, for which sample, and by how much.
struct [[nodiscard]] ManifoldCheck {
  bool ok = true;
  std::string message;
  explicit operator bool() const { return ok; }
};

struct ManifoldCheckOptions {
  double step = 0.1;                   ///< largest absolute entry of the random δ
  int random_steps = 8;                ///< number of random δ per sample
  double tolerance = 1e-9;             ///< tolerance of laws 1 to 3, relative to 1 + |δ|
  double derivative_tolerance = 1e-7;  ///< tolerance of derivatives
  std::uint64_t seed = 1;
};

/// The checks, one function per law. Each returns false and fills result() on the first violation.
template <detail::ManifoldType T>
class ManifoldChecker {
 public:
  using Trait = Manifold<T>;
  using Tangent = std::vector<double>;

  explicit ManifoldChecker(const ManifoldCheckOptions& options) : options_(options), random_(options.seed) {}

  const ManifoldCheck& result() const { return result_; }

  /// (1) x ⊞ 0 = x.
  bool zero_is_neutral(const T& x) {
    const Tangent zero(detail::tangent_dim(x), 0.0);
    return expect_equal("law 1, x ⊞ 0 = x", minus(plus(x, zero), x), zero, options_.tolerance);
  }

  /// (2) x ⊞ (y ⊟ x) = y.
  bool plus_inverts_minus(const T& x, const T& y) {
    if (detail::tangent_dim(x) != detail::tangent_dim(y)) return true;
    const Tangent delta = minus(y, x);
    const Tangent zero(delta.size(), 0.0);
    return expect_equal("law 2, x ⊞ (y ⊟ x) = y", minus(plus(x, delta), y), zero,
                        options_.tolerance * (1 + largest(delta)));
  }

  /// (3) (x ⊞ δ) ⊟ x = δ.
  bool minus_inverts_plus(const T& x, const Tangent& delta) {
    return expect_equal("law 3, (x ⊞ δ) ⊟ x = δ", minus(plus(x, delta), x), delta,
                        options_.tolerance * (1 + largest(delta)));
  }

  /// (4) ⊞ is smooth at 0 with full rank. Differentiates (x ⊞ δ) ⊟ y for a point y = x ⊞ η near x.
  bool plus_is_smooth(const T& x, const Tangent& eta) {
    const T y = plus(x, eta);
    const int n = detail::tangent_dim(x);
    Matrix<double, kDynamic, kDynamic> jacobian(n, n);
    detail::NumericOptions numeric;
    numeric.initial_step = 0.25 * options_.step;
    const double error =
        detail::numeric_jacobian([&](const T& z) { return minus(z, y); }, x, jacobian, numeric);
    if (!(error <= options_.derivative_tolerance * (1 + jacobian.cwiseAbs().maxCoeff()))) {
      return fail("law 4, ⊞ is smooth at 0: its numeric derivative is uncertain", error);
    }
    const double pivot = smallest_pivot(jacobian);
    return pivot > 1e-6 ? true : fail("law 4, ∂(x ⊞ δ)/∂δ has full rank: a pivot exceeds 0 only", pivot);
  }

  /// For dual numbers, ⊞ has the same value and derivative as for double. Skips this check if the type cannot
  /// be lifted to dual numbers, or if the lifted type has no ⊟.
  bool lifted_agrees(const T& x, const Tangent& delta) {
    if constexpr (detail::LiftableManifold<T, D>) {
      if constexpr (requires(const detail::Rebind<T, D>& z, D* out) {
                      Manifold<detail::Rebind<T, D>>::ominus(z, z, out);
                    }) {
        for (std::size_t k = 0; k < delta.size(); ++k) {
          if (!lifted_agrees_along(x, delta, k)) return false;
        }
      }
    }
    return true;
  }

  Tangent random_tangent(const T& x) {
    Tangent delta(detail::tangent_dim(x));
    for (double& d : delta) d = options_.step * random();
    return delta;
  }

 private:
  using D = detail::Dual<double, 1>;

  bool lifted_agrees_along(const T& x, const Tangent& delta, std::size_t k) {
    const T y = plus(x, delta);
    const int n = detail::tangent_dim(x);
    std::vector<D> lifted(delta.begin(), delta.end()), difference(n);
    lifted[k].derivative[0] = 1;
    using Lifted = Manifold<detail::Rebind<T, D>>;
    Lifted::ominus(Lifted::oplus(Trait::template cast<D>(x), lifted.data()), Trait::template cast<D>(y),
                   difference.data());

    Tangent value(n), derivative(n), expected(n), moved = delta;
    for (int i = 0; i < n; ++i) value[i] = difference[i].value;
    for (int i = 0; i < n; ++i) derivative[i] = difference[i].derivative[0];
    detail::NumericOptions numeric;
    numeric.initial_step = 0.25 * options_.step;
    detail::NumericDerivative differentiate(numeric);
    differentiate(
        [&](double h, double* out) {
          moved[k] = delta[k] + h;
          Trait::ominus(plus(x, moved), y, out);
        },
        n, expected.data());
    return expect_equal("⊞ on dual numbers has the value of ⊞ on double", value, Tangent(n, 0.0),
                        options_.tolerance) &&
           expect_equal("⊞ on dual numbers has the derivative of ⊞ on double", derivative, expected,
                        options_.derivative_tolerance);
  }

  T plus(const T& x, const Tangent& delta) const { return Trait::oplus(x, delta.data()); }
  Tangent minus(const T& y, const T& x) const {
    Tangent delta(detail::tangent_dim(x));
    Trait::ominus(y, x, delta.data());
    return delta;
  }
  static double largest(const Tangent& v) {
    double largest = 0;
    for (const double c : v) largest = std::max(largest, std::abs(c));
    return largest;
  }

  /// The smallest pivot of Gaussian elimination with full pivoting, divided by the first pivot.
  static double smallest_pivot(Matrix<double, kDynamic, kDynamic> a) {
    if (a.size() == 0) return 1;
    double first = 0, pivot = 0;
    for (Eigen::Index k = 0; k < a.rows(); ++k) {
      const Eigen::Index rest = a.rows() - k;
      Eigen::Index i = 0, j = 0;
      pivot = a.bottomRightCorner(rest, rest).cwiseAbs().maxCoeff(&i, &j);
      if (k == 0) first = pivot;
      if (!(pivot > 0)) return 0;
      a.row(k).swap(a.row(k + i));
      a.col(k).swap(a.col(k + j));
      for (Eigen::Index r = k + 1; r < a.rows(); ++r) a.row(r) -= (a(r, k) / a(k, k)) * a.row(k).eval();
    }
    return first > 0 ? pivot / first : 1;
  }

  bool expect_equal(const char* law, const Tangent& actual, const Tangent& expected, double tolerance) {
    for (std::size_t i = 0; i < actual.size(); ++i) {
      const double off = std::abs(actual[i] - expected[i]);
      if (!(off <= tolerance))
        return fail(std::string(law) + ": component " + std::to_string(i) + " is off", off);
    }
    return true;
  }
  bool fail(const std::string& law, double amount) {
    char number[32];
    std::snprintf(number, sizeof number, "%.3g", amount);
    result_ = {false, law + " by " + number};
    return false;
  }

  /// Uniform in [−1, 1] (splitmix64).
  double random() {
    random_ += 0x9e3779b97f4a7c15;
    std::uint64_t z = random_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1.0p-52 - 1;
  }

  ManifoldCheckOptions options_;
  std::uint64_t random_;
  ManifoldCheck result_;
};

/// Checks all laws on all samples, and law 2 on all pairs of them.
template <detail::ManifoldType T>
ManifoldCheck check_manifold(const std::vector<T>& samples, const ManifoldCheckOptions& options = {}) {
  ManifoldChecker<T> checker(options);
  for (std::size_t s = 0; s < samples.size(); ++s) {
    const T& x = samples[s];
    bool ok = checker.zero_is_neutral(x);
    for (const T& y : samples) ok = ok && checker.plus_inverts_minus(x, y);
    std::vector<std::vector<double>> steps(options.random_steps);
    for (auto& delta : steps) delta = checker.random_tangent(x);
    for (const auto& delta : steps) {
      ok = ok && checker.minus_inverts_plus(x, delta) && checker.plus_is_smooth(x, delta);
    }
    steps.insert(steps.begin(), std::vector<double>(detail::tangent_dim(x), 0.0));
    for (const auto& delta : steps) ok = ok && checker.lifted_agrees(x, delta);
    if (!ok) return {false, "sample " + std::to_string(s) + ": " + checker.result().message};
  }
  return {};
}

/// Checks all laws at x.
template <detail::ManifoldType T>
ManifoldCheck check_manifold(const T& x, const ManifoldCheckOptions& options = {}) {
  return check_manifold(std::vector<T>{x}, options);
}

}  // namespace boxplus
