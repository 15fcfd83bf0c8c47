// SPDX-License-Identifier: BSD-3-Clause
#include "linearize/jacobian_products.h"

#include <algorithm>

#include "plan/plan.h"

namespace boxplus {
namespace {

/// Up to Lanes edges of a tile, beginning with edge `first`. Vectors of n values per edge have value m of the
/// edge in lane l at index m · Lanes + l. The lanes behind the last edge have unspecified values.
template <int Lanes>
class Group {
 public:
  Group(const PlacedTile& edges, int first)
      : edges_(edges),
        first_(first),
        count_(std::min(Lanes, edges.tile.count - first)),
        jacobian_(edges.tile.jacobian + first * edges.tile.rows * edges.tile.cols) {}

  /// Copies the entries of `vector` for the vertices of each edge to x. The entries are zero for vertices
  /// that do not move, and, unless `with_eliminated` is true, for eliminated vertices.
  void gather(const double* vector, VectorLayout layout, bool with_eliminated, double* x) const {
    for_each_vertex([&](std::size_t i, int column) {
      for (int lane = 0; lane < count_; ++lane) {
        const std::uint32_t target = target_of(lane, i);
        const bool is_kept = target >= layout.first_kept;
        const bool counts = target != Scatter::kNowhere && (is_kept || with_eliminated);
        const double* from = counts ? vector + (is_kept ? target - layout.copy : target) : nullptr;
        for (int c = 0; c < edges_.dims[i]; ++c)
          x[(column + c) * Lanes + lane] = from != nullptr ? from[c] : 0;
      }
    });
  }

  /// s = J x.
  void multiply(const double* x, double* s) const {
    const int rows = edges_.tile.rows;
    std::fill_n(s, rows * Lanes, 0.0);
    for (int c = 0; c < edges_.tile.cols; ++c) {
      for (int r = 0; r < rows; ++r) {
        const double* j = jacobian_ + (c * rows + r) * Lanes;
        for (int lane = 0; lane < Lanes; ++lane) s[r * Lanes + lane] += j[lane] * x[c * Lanes + lane];
      }
    }
  }

  /// t = ρ′Ω s.
  void weigh(const double* s, double* t) const {
    const TileWeights& weights = edges_.weights;
    const auto kind = static_cast<detail::InformationKind>(weights.kind());
    const int rows = edges_.tile.rows;
    for (int lane = 0; lane < count_; ++lane) {
      const double* omega = weights.omegas()[first_ + lane];
      const double weight = weights.weight(static_cast<std::size_t>(first_ + lane));
      const auto entry = [&](int i, int j) { return detail::InformationView{kind, rows, omega}(i, j); };
      for (int r = 0; r < rows; ++r) {
        double sum = 0;
        switch (kind) {
          case detail::InformationKind::kScalar:
            sum = omega[0] * s[r * Lanes + lane];
            break;
          case detail::InformationKind::kDiagonal:
            sum = omega[r] * s[r * Lanes + lane];
            break;
          case detail::InformationKind::kFull:
            for (int c = 0; c < rows; ++c) sum += entry(r, c) * s[c * Lanes + lane];
        }
        t[r * Lanes + lane] = weight * sum;
      }
    }
  }

  /// Subtracts Jᵀ t from the entries of `vector` that belong to eliminated vertices. y is scratch memory.
  void subtract_from_eliminated(const double* t, VectorLayout layout, double* y, double* vector) const {
    for_each_vertex([&](std::size_t i, int column) {
      const int dim = edges_.dims[i];
      const auto is_eliminated = [&](int lane) { return target_of(lane, i) < layout.first_kept; };
      bool any = false;
      for (int lane = 0; lane < count_; ++lane) any = any || is_eliminated(lane);
      if (!any) return;
      multiply_transposed(column, dim, t, y);
      for (int lane = 0; lane < count_; ++lane) {
        if (!is_eliminated(lane)) continue;
        double* const to = vector + target_of(lane, i);
        for (int c = 0; c < dim; ++c) to[c] -= y[c * Lanes + lane];
      }
    });
  }

  /// Σ sᵀ t.
  double dot(const double* s, const double* t) const {
    double sum = 0;
    for (int lane = 0; lane < count_; ++lane) {
      for (int r = 0; r < edges_.tile.rows; ++r) sum += s[r * Lanes + lane] * t[r * Lanes + lane];
    }
    return sum;
  }

 private:
  std::uint32_t target_of(int lane, std::size_t vertex) const {
    return edges_.targets[first_ + lane][vertex];
  }

  /// Calls f(i, column) for the i-th vertex of the edges, whose first column in the Jacobian is `column`.
  template <class F>
  void for_each_vertex(F&& f) const {
    int column = 0;
    for (std::size_t i = 0; i < edges_.dims.size(); column += edges_.dims[i], ++i) f(i, column);
  }

  /// y = Jᵀ t for the columns [column, column + dim) of J.
  void multiply_transposed(int column, int dim, const double* t, double* y) const {
    const int rows = edges_.tile.rows;
    std::fill_n(y, dim * Lanes, 0.0);
    for (int c = 0; c < dim; ++c) {
      for (int r = 0; r < rows; ++r) {
        const double* j = jacobian_ + ((column + c) * rows + r) * Lanes;
        for (int lane = 0; lane < Lanes; ++lane) y[c * Lanes + lane] += j[lane] * t[r * Lanes + lane];
      }
    }
  }

  const PlacedTile& edges_;
  int first_, count_;
  const double* jacobian_;
};

/// Calls f for each Group of the edges.
template <class F>
void for_each_group(const PlacedTile& edges, F&& f) {
  constexpr int kLanes = detail::EdgeTile::kLanes;
  if (edges.tile.in_lanes) {
    for (int first = 0; first < edges.tile.count; first += kLanes) f(Group<kLanes>(edges, first));
  } else {
    for (int first = 0; first < edges.tile.count; ++first) f(Group<1>(edges, first));
  }
}

}  // namespace

JacobianProducts::JacobianProducts(std::size_t values, std::size_t rows)
    : x_(values), y_(values), product_(rows), weighted_(rows) {}

void JacobianProducts::subtract_coupling(const PlacedTile& edges, VectorLayout layout, double* x) {
  const detail::EdgeTile& tile = edges.tile;
  edges.weights.read_informations(edges.pool, edges.edges, tile.rows);
  const dense::SubtractCoupling kernel = dense::kernels().subtract_coupling_for(
      tile.rows, edges.dims.data(), static_cast<int>(edges.dims.size()));
  const double* const jacobian = kernel != nullptr ? jacobian_in_lanes(tile) : nullptr;
  if (jacobian != nullptr) {
    return kernel({tile.count, jacobian, edges.weights.kind(), edges.weights.omegas(),
                   edges.weights.weights(), edges.targets.data(), layout.first_kept, layout.copy, x});
  }
  for_each_group(edges, [&](const auto& group) {
    group.gather(x, layout, false, x_.data());
    group.multiply(x_.data(), product_.data());
    group.weigh(product_.data(), weighted_.data());
    group.subtract_from_eliminated(weighted_.data(), layout, y_.data(), x);
  });
}

/// The Jacobians of the tile in lanes. Returns null if there is no memory for the lanes of so few edges.
const double* JacobianProducts::jacobian_in_lanes(const detail::EdgeTile& tile) {
  if (tile.in_lanes) return tile.jacobian;
  const int groups = (tile.count + detail::EdgeTile::kLanes - 1) / detail::EdgeTile::kLanes;
  const int values = tile.rows * tile.cols;
  if (x_.size() < static_cast<std::size_t>(groups * detail::EdgeTile::kLanes * values)) return nullptr;
  dense::kernels().to_lanes(tile.jacobian, values, tile.count, x_.data());
  return x_.data();
}

double JacobianProducts::curvature(const PlacedTile& edges, VectorLayout layout, const double* d) {
  edges.weights.read_informations(edges.pool, edges.edges, edges.tile.rows);
  double sum = 0;
  for_each_group(edges, [&](const auto& group) {
    group.gather(d, layout, true, x_.data());
    group.multiply(x_.data(), product_.data());
    group.weigh(product_.data(), weighted_.data());
    sum += group.dot(product_.data(), weighted_.data());
  });
  return sum;
}

}  // namespace boxplus
