// SPDX-License-Identifier: BSD-3-Clause
// A prior on any number of vertices of several types, with all correlations between them. Marginalizing all
// other vertices of a problem produces such a prior.
#pragma once

#include <span>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "boxplus/graph/differentiate.h"
#include "boxplus/graph/type_name.h"
#include "boxplus/types/pose_math.h"

namespace boxplus {

namespace dense_prior {

/// R and r in e = R δ + r, column-major.
struct Rows {
  int rows = 0, cols = 0;
  std::vector<double> root, offset;
};

/// Throws InvalidArgument unless `root` has `cols` columns, and `offset` is empty or has as many rows as
/// `root`.
Rows from_root(const Eigen::MatrixXd& root, const Eigen::VectorXd& offset, int cols);
/// R and r with RᵀR = H and Rᵀr = b. Directions in which H is zero to within rounding get no row. Throws
/// InvalidArgument unless H is symmetric and positive semi-definite with `cols` columns, and b is empty or
/// has `cols` entries. O(cols³).
Rows from_information(const Eigen::MatrixXd& H, const Eigen::VectorXd& b, int cols);

/// e ← R δ + r.
void evaluate(const Rows& rows, const double* delta, double* error);
/// J ← R[:, first … first + dim) D. D is dim × dim.
void multiply(const Rows& rows, int first, int dim, const double* D, double* jacobian);

/// Throws InvalidArgument with a message that the number of vertices of the edge is not the number of means.
[[noreturn]] void throw_count(std::string_view type, std::size_t expected, std::size_t actual);

}  // namespace dense_prior

/// Error: R δ + r. δ stacks x_k ⊟ mean_k of all vertices: first the vertices of the first type, in the order
/// of the edge, then the vertices of the second type, …
///
///     graph.add_edge(DensePrior<SE3, Vector3>({pose_means, point_means}, R), poses, points);
///
/// With Ω = 1 (the default), the cost of the prior is ‖Rδ + r‖². The means stay at the estimates at which the
/// problem was linearized, as fixed-lag smoothers and consistent filters require. The Jacobian is R times the
/// derivative of δ at the current estimates; computing it takes O(rows · cols · dim), with the tangent
/// dimension dim of one vertex. So the dense product JᵀJ, which takes O(rows · cols²), dominates the time of
/// an iteration.
template <class... T>
class DensePrior {
 public:
  static constexpr std::string_view kName = "DensePrior";
  using Means = std::tuple<std::vector<T>...>;

  /// `root`: R, with any number of rows. `offset`: r; if it is empty, r = 0. Throws InvalidArgument if the
  /// sizes do not match.
  DensePrior(Means means, const Eigen::MatrixXd& root, const Eigen::VectorXd& offset = Eigen::VectorXd())
      : means_(std::move(means)), rows_(dense_prior::from_root(root, offset, dim())) {}

  /// The prior whose cost is δᵀHδ + 2 bᵀδ, up to a constant. H and b are the results of marginalization.
  /// Throws InvalidArgument if the sizes do not match, or if H is not symmetric positive semi-definite.
  static DensePrior from_information(Means means, const Eigen::MatrixXd& H,
                                     const Eigen::VectorXd& b = Eigen::VectorXd()) {
    DensePrior prior(std::move(means));
    prior.rows_ = dense_prior::from_information(H, b, prior.dim());
    return prior;
  }

  const Means& means() const { return means_; }

  Vector<double, kDynamic> error(std::span<const T>... x) const {
    std::vector<double> delta(static_cast<std::size_t>(rows_.cols));
    double* out = delta.data();
    for_each_vertex(
        [&](const auto& estimate, const auto& mean) {
          Manifold<std::remove_cvref_t<decltype(mean)>>::ominus(estimate, mean, out);
          out += boxplus::detail::tangent_dim(mean);
        },
        x...);
    Vector<double, kDynamic> e(rows_.rows);
    dense_prior::evaluate(rows_, delta.data(), e.data());
    return e;
  }

  template <class... J>
  void jacobians(std::span<const T>... x, J&... blocks) const {
    int first = 0;
    const auto fill = [&]<class V>(std::span<const V> estimates, const std::vector<V>& means, double* out) {
      for (std::size_t k = 0; k < means.size(); ++k) {
        const int size = boxplus::detail::tangent_dim(means[k]);
        const std::vector<double> D = difference_jacobian(estimates[k], means[k]);
        dense_prior::multiply(rows_, first, size, D.data(), out);
        first += size;
        out += static_cast<std::ptrdiff_t>(rows_.rows) * size;
      }
    };
    std::apply([&](const auto&... means) { (fill(x, means, blocks.data()), ...); }, means_);
  }

 private:
  explicit DensePrior(Means means) : means_(std::move(means)) {}

  int dim() const {
    int sum = 0;
    const auto add = [&](const auto& means) {
      for (const auto& mean : means) sum += boxplus::detail::tangent_dim(mean);
    };
    std::apply([&](const auto&... means) { (add(means), ...); }, means_);
    return sum;
  }

  /// Calls f(estimate, mean) for each vertex.
  template <class F>
  void for_each_vertex(F&& f, std::span<const T>... x) const {
    const auto visit = [&]<class V>(std::span<const V> estimates, const std::vector<V>& means) {
      if (estimates.size() != means.size())
        dense_prior::throw_count(detail::type_name<V>(), means.size(), estimates.size());
      for (std::size_t k = 0; k < means.size(); ++k) {
        detail::require_same_size(means[k], "the mean", estimates[k]);
        f(estimates[k], means[k]);
      }
    };
    std::apply([&](const auto&... means) { (visit(x, means), ...); }, means_);
  }

  /// Whether ⊟ accepts estimates over dual numbers.
  template <class V>
  static constexpr bool kHasGenericMinus = [] {
    if constexpr (requires { requires detail::LiftableManifold<V, detail::DualFor<V>>; }) {
      using Lifted = detail::Rebind<V, detail::DualFor<V>>;
      return requires(const Lifted& y, detail::DualFor<V>* delta) {
        Manifold<Lifted>::ominus(y, y, delta);
      };
    } else {
      return false;
    }
  }();

  /// ∂ ((x ⊞ δ) ⊟ mean) / ∂δ, column-major.
  template <class V>
  static std::vector<double> difference_jacobian(const V& x, const V& mean) {
    const int size = boxplus::detail::tangent_dim(mean);
    std::vector<double> error(static_cast<std::size_t>(size)), D(static_cast<std::size_t>(size * size));
    if constexpr (kHasGenericMinus<V>) {
      const auto minus = [&](const auto& y) { return detail::difference(y, mean); };
      detail::automatic_jacobian<V>(minus, error.data(), D.data(), size, size, x);
    } else {
      const auto minus = [&](const V& y) {
        std::vector<double> delta(static_cast<std::size_t>(size));
        Manifold<V>::ominus(y, mean, delta.data());
        return delta;
      };
      detail::numeric_jacobian<V>(minus, error.data(), D.data(), size, size, x);
    }
    return D;
  }

  Means means_;
  dense_prior::Rows rows_;
};

}  // namespace boxplus
