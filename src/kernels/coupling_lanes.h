// SPDX-License-Identifier: BSD-3-Clause
// Multiplies the coupling of eliminated and kept vertices with a vector, for several edges at a time, one
// edge per lane.
#pragma once

#include "kernels/edge_lanes.h"
#include "kernels/kernel_table.h"
#include "kernels/transpose.h"

namespace boxplus::dense::BOXPLUS_ISA {

/// The vectors of kLanes edges, whose errors have R rows and whose vertices have the tangent sizes D.
template <int R, int... D>
class CouplingLanes {
 public:
  using Places = EdgePlaces<R, D...>;

  /// Takes `count` edges, beginning with edge `first`. The other lanes are copies of the first edge.
  CouplingLanes(const CoupledEdges& tile, int first, int count) : tile_(tile), first_(first), count_(count) {
    jacobian_ = tile.jacobian + lane_offset(R * Places::kColumns, first);
  }

  /// Sets the product to J_k x_k, for the columns J_k of the kept vertices.
  void multiply() {
    for (int r = 0; r < R; ++r) product_[r] = Pack{};
    for_each_index<Places::kArity>([&](auto i) {
      constexpr int kDim = Places::dim(i);
      bool any = false;
      for (int lane = 0; lane < kLanes; ++lane) any = any || !is_eliminated(target(lane, i));
      if (!any) return;
      const double* from[kLanes];
      for (int lane = 0; lane < kLanes; ++lane) from[lane] = kept_entries<kDim>(target(lane, i));
      Pack x[kDim];
      load_lanes<kDim>(from, x);
      for_each_index<kDim>(
          [&](auto c) { for_each_index<R>([&](auto r) { product_[r] += column<i, c, r>() * x[c]; }); });
    });
  }

  /// Multiplies the product by ρ′Ω.
  template <EdgeNumbers::Kind kKind>
  void weigh_product() {
    constexpr int kNumbers = kOmegaNumbers<R, kKind>;
    const double* omegas[kLanes];
    double weights[kLanes];
    for (int lane = 0; lane < kLanes; ++lane) {
      omegas[lane] = tile_.omega[edge(lane)];
      weights[lane] = tile_.weight != nullptr ? tile_.weight[edge(lane)] : 1;
    }
    Pack omega[kNumbers], weighted[R];
    load_lanes<kNumbers>(omegas, omega);
    weigh<R, kKind>(omega, product_, weighted);
    for_each_index<R>([&](auto r) { product_[r] = weighted[r] * load(weights); });
  }

  /// Subtracts J_eᵀ times the product from x_e, for the columns J_e of the eliminated vertices.
  void subtract() const {
    for_each_index<Places::kArity>([&](auto i) {
      constexpr int kDim = Places::dim(i);
      bool any = false;
      for (int lane = 0; lane < count_; ++lane) any = any || is_eliminated(target(lane, i));
      if (!any) return;
      double sums[kDim][kLanes];
      for_each_index<kDim>([&](auto c) {
        Pack sum{};
        for_each_index<R>([&](auto r) { sum += column<i, c, r>() * product_[r]; });
        store(sums[c], sum);
      });
      for (int lane = 0; lane < count_; ++lane) {
        if (!is_eliminated(target(lane, i))) continue;
        double* const x = tile_.x + target(lane, i);
        for_each_index<kDim>([&](auto c) { x[c] -= sums[c][lane]; });
      }
    });
  }

 private:
  int edge(int lane) const { return lane < count_ ? first_ + lane : first_; }
  std::uint32_t target(int lane, int vertex) const { return tile_.targets[edge(lane)][vertex]; }
  bool is_eliminated(std::uint32_t target) const { return target < tile_.first_kept; }

  /// The entries of x for a vertex, or zeros if the vertex is eliminated or does not move.
  template <int kDim>
  const double* kept_entries(std::uint32_t target) const {
    static constexpr double kZeros[kDim] = {};
    return is_eliminated(target) || target == kNoTarget ? kZeros : tile_.x + (target - tile_.copy);
  }

  /// The entries (r, c) of the Jacobians with respect to vertex i.
  template <int i, int c, int r>
  Pack column() const {
    return load(jacobian_ + ((Places::first_column(i) + c) * R + r) * kTileLanes);
  }

  const CoupledEdges& tile_;
  int first_, count_;
  const double* jacobian_;
  Pack product_[R];
};

template <int R, int... D>
void subtract_coupling(const CoupledEdges& tile) {
  for (int k = 0; k < tile.count; k += kLanes) {
    CouplingLanes<R, D...> lanes(tile, k, tile.count - k < kLanes ? tile.count - k : kLanes);
    lanes.multiply();
    for_kind(tile.kind, [&]<EdgeNumbers::Kind kKind>() { lanes.template weigh_product<kKind>(); });
    lanes.subtract();
  }
}

/// The kernel for edges of these sizes, or null if there is none.
inline SubtractCoupling subtract_coupling_for(int rows, const int* dims, int arity) {
  SubtractCoupling found = nullptr;
  for_lane_sizes(
      rows, dims, arity, [&]<int R, int... D>(Sizes<R, D...>) { found = subtract_coupling<R, D...>; });
  return found;
}

}  // namespace boxplus::dense::BOXPLUS_ISA
